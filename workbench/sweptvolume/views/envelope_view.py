# SPDX-License-Identifier: LGPL-2.1-or-later
"""How an envelope looks: translucent, so that the parts inside stay visible; a heavy one is drawn by a
thinned copy."""
from ..texts import mark, translate
from . import surface
from .base import View, run_command, set_if_there, state_icon

COLOUR = (0.35, 0.60, 0.90)


class EnvelopeView(View):
    """View provider of the envelope."""

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
            text = mark("Properties", "About so many triangles are drawn of a heavy mesh; 0: all")
            view.addProperty(
                "App::PropertyInteger", "DrawnTriangles", "Display", translate("Properties", text)
            )
            view.DrawnTriangles = surface.MOST
        view.RootNode.insertChild(surface.unsorted_blending(), 0)
        self.display = surface.LightDisplay(view.Object, lambda: view.DrawnTriangles)

    def updateData(self, obj, name):
        super().updateData(obj, name)
        if name == "Mesh" and hasattr(self, "display"):
            self.display.later()

    def onChanged(self, view, name):
        if name == "DrawnTriangles" and hasattr(self, "display"):
            self.display.later()

    def getIcon(self):
        return state_icon("SweptVolume_Envelope", self.Object)

    def doubleClicked(self, view):
        run_command(view.Object, "SweptVolume_EditEnvelope")
        return True

    def setupContextMenu(self, view, menu):
        obj = view.Object
        for text, name in (
            (translate("Commands", "Edit envelope"), "SweptVolume_EditEnvelope"),
            (translate("Commands", "Recompute envelope"), "SweptVolume_Recompute"),
            (translate("Commands", "Make solid"), "SweptVolume_Solid"),
            (translate("Commands", "Export envelope"), "SweptVolume_Export"),
        ):
            icon_name = name.replace("EditEnvelope", "Envelope")
            self.add_menu(menu, text, icon_name, lambda name=name: run_command(obj, name))
