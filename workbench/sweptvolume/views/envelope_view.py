# SPDX-License-Identifier: LGPL-2.1-or-later
"""Drawing of an envelope: translucent, so that the parts inside are visible. A large envelope is
drawn by a simplified copy."""
from PySide import QtCore

from .. import runner
from ..features import envelope
from ..texts import QT_TRANSLATE_NOOP, translate
from . import made_colours, surface
from .base import View, run_command, set_if_there, state_icon

COLOUR = (0.35, 0.60, 0.90)


class _Recut(runner.Task):
    """Simplifies the kept surface to a new tolerance; other properties do not change."""

    def __init__(self, obj):
        self.title = translate("SweptVolume", "Compute envelope")
        self.document, self.obj, self.watched = obj.Document, obj, [obj]
        plan = envelope.Plan.of(obj)
        self.hash, self.most = plan.hash(), surface.most_of(obj)
        self.run = envelope.prepare(plan, obj.Document)

    def work(self, control):
        return surface.ready(self.run(control), self.most)

    def room(self, found):
        return surface.room(self.obj, found)

    def finish(self, found):
        if surface.undoable(found):
            self.apply(found)

    def after(self, found):
        if not surface.undoable(found):
            surface.watch_undo()
            self.apply(found)

    def apply(self, found):
        envelope.apply(self.obj, found, self.hash)
        surface.show(self.obj, found)
        self.obj.purgeTouched()

    def fail(self, text, cancelled=False):
        envelope.fail(self.obj, text, self.hash, cancelled)


def recut(obj):
    """Simplifies an envelope to its new tolerance at once, if no sampling is needed."""
    try:
        if not runner.is_running(obj) and envelope.can_recut(obj):
            run = runner.start(_Recut(obj))
            run.ended.connect(lambda ended: recut(obj) if ended.state == "ok" else None)
    except ReferenceError:
        pass  # the object was deleted meanwhile


class EnvelopeView(View):
    """View provider of the envelope."""

    PARENTS = ("Motion", "Motions")
    COUNTER = "Triangles"
    EDITOR = "SweptVolume_EditEnvelope"

    def __init__(self, view):
        super().__init__(view)
        set_if_there(
            view,
            ShapeColor=COLOUR,
            Transparency=45,
            DisplayMode="Shaded",
            CreaseAngle=35.0,
            Lighting="Two side",
        )

    def attach(self, view):
        super().attach(view)
        if "DrawnTriangles" not in view.PropertiesList:
            text = QT_TRANSLATE_NOOP(
                "App::Property",
                "Largest number of triangles to draw. A larger mesh is reduced to "
                "this number on screen. 0: draws all triangles",
            )
            view.addProperty("App::PropertyInteger", "DrawnTriangles", "Display", text)
            view.DrawnTriangles = surface.MOST
        if "ColourBy" not in view.PropertiesList:
            text = QT_TRANSLATE_NOOP(
                "App::Property",
                "What the colours show. They need a record of the faces that made the envelope: "
                "set MadeBy to Session or Document, and compute the envelope again",
            )
            view.addProperty("App::PropertyEnumeration", "ColourBy", "Display", text)
            view.ColourBy = made_colours.CHOICES
        view.RootNode.insertChild(surface.unsorted_blending(), 0)
        self.display = surface.LightDisplay(view.Object, lambda: view.DrawnTriangles)

    def updateData(self, obj, name):
        super().updateData(obj, name)
        if name == "Mesh" and hasattr(self, "display"):
            self.display.later()
        if name in ("Mesh", "InputHash", "MadeByData"):
            self.colour_later(obj)
        if name == "Tolerance" and not getattr(obj.Document, "Transacting", False):
            # Called later from the event loop, when all related properties have been written.
            QtCore.QTimer.singleShot(0, lambda: recut(obj))

    def onChanged(self, view, name):
        if name == "DrawnTriangles" and hasattr(self, "display"):
            self.display.later()
        if name in ("DrawnTriangles", "ColourBy", "Transparency"):
            self.colour_later(view.Object)

    def colour_later(self, obj):
        """Colours the envelope from the event loop, when the whole result has been written."""
        if not getattr(self, "_asked", False):
            self._asked = True
            QtCore.QTimer.singleShot(0, lambda: self._colour(obj))

    def _colour(self, obj):
        """Colours the envelope as ColourBy says. Without a record, the envelope has its own colour."""
        self._asked = False
        try:
            record, by = made_colours.record_to_show(obj.ViewObject)
            if record is None:
                if self.__dict__.pop("_coloured", False):
                    self.display.later()
                return
            self._coloured = now = object()

            def show(coloured):
                if self.__dict__.get("_coloured") is now:
                    # Less transparent, because colours behind each other could not be
                    # distinguished.
                    transparency = made_colours.CLEARER * obj.ViewObject.Transparency / 100.0
                    self.display.show_nodes(made_colours.nodes_of(coloured, transparency))

            most = obj.ViewObject.DrawnTriangles
            runner.start(made_colours.Colouring(obj, record, by, most, show))
        except (ReferenceError, RuntimeError):
            pass  # the object was deleted meanwhile, or there is no core

    def getIcon(self):
        return state_icon("SweptVolume_Envelope", self.Object)

    def setupContextMenu(self, view, menu):
        obj = view.Object
        for text, name in (
            (translate("SweptVolume", "Edit envelope"), "SweptVolume_EditEnvelope"),
            (translate("SweptVolume", "Recompute envelope"), "SweptVolume_Recompute"),
            (translate("SweptVolume", "Check clearance"), "SweptVolume_Clearance"),
            (translate("SweptVolume", "Make solid"), "SweptVolume_Solid"),
            (translate("SweptVolume", "What made this?"), "SweptVolume_MadeBy"),
            (translate("SweptVolume", "Export envelope"), "SweptVolume_Export"),
        ):
            icon_name = name.replace("EditEnvelope", "Envelope")
            self.add_menu(menu, text, icon_name, lambda name=name: run_command(obj, name))
