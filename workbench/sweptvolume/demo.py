# SPDX-License-Identifier: LGPL-2.1-or-later
"""The demo: a starter motor is installed past exhaust, engine and bell housing.

build() creates the document. main() does the whole job with the ordinary functions of the workbench
and writes a FreeCAD document, a STEP file and a picture.
"""
import os

import FreeCAD as App

from . import demo_parts
from .features import envelope, motion, solid
from .texts import translate

DOCUMENT = "SweptVolumeDemo"
RESOLUTION = 96
#: Largest deviation by simplification (mm).
TOLERANCE = 0.1


class Demo:
    """The objects of the demo."""

    def __init__(self, document, starter, motion_obj):
        self.document = document
        self.starter = starter
        self.motion = motion_obj
        self.envelope = None
        self.solid = None


def build():
    """Creates a new document with the parts and the installation path."""
    document = App.newDocument(DOCUMENT)
    document.UndoMode = 1
    document.openTransaction(translate("SweptVolume", "Demo"))
    neighbours = document.addObject("App::Part", "Neighbours")
    neighbours.Label = translate("SweptVolume", "Neighbours")
    starter = None
    for name, label, model, colour in demo_parts.PARTS:
        obj = document.addObject("Part::Feature", name)
        obj.Label = translate("SweptVolume", label)
        obj.Shape = model()
        if obj.ViewObject is not None:
            obj.ViewObject.ShapeColor = colour
        if starter is None:
            starter = obj
        else:
            neighbours.addObject(obj)
    times, placements = demo_parts.path()
    path = motion.motion_from_poses(document, times, placements)
    path.Label = translate("SweptVolume", "Installation path")
    motion.set_parts(path, [(starter, "")])
    starter.Placement = placements[-1]
    document.recompute()
    document.commitTransaction()
    set_view(document)
    return Demo(document, starter, path)


def add_envelope(demo, **settings):
    """Adds the envelope object of the demo, not yet computed."""
    values = dict(Resolution=RESOLUTION, Tolerance=TOLERANCE)
    values.update(settings)
    demo.envelope = envelope.make_envelope(demo.document, [demo.starter], demo.motion, **values)
    demo.document.recompute()
    return demo.envelope


def add_solid(demo):
    """Adds the solid object of the demo's envelope, not yet computed."""
    demo.solid = solid.make_solid(demo.document, demo.envelope)
    demo.document.recompute()
    return demo.solid


def set_view(document):
    """Sets a view that shows the path and the neighbours."""
    if not App.GuiUp:
        return
    import FreeCADGui as Gui

    view = Gui.getDocument(document.Name).activeView()
    view.setCameraOrientation(view_rotation().Q)
    Gui.SendMsgToActiveView("ViewFit")


def view_rotation():
    """Returns the camera orientation: from outside, in front of the starter and slightly above
    it."""
    out = App.Vector(-0.42, 0.86, 0.30).normalize()  # from the scene to the camera
    right = App.Vector(0, 0, 1).cross(out).normalize()
    up = out.cross(right)
    m = App.Matrix(
        right.x, up.x, out.x, 0, right.y, up.y, out.y, 0, right.z, up.z, out.z, 0, 0, 0, 0, 1
    )
    return App.Rotation(m)


def output_folder(wanted=""):
    """Returns the folder for the files: the given one, or out/ in the current folder."""
    folder = os.path.abspath(wanted or os.environ.get("SWEPT_OUT") or "out")
    os.makedirs(folder, exist_ok=True)
    return folder
