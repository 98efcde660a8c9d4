# SPDX-License-Identifier: LGPL-2.1-or-later
"""Drawing of a shared volume: red, and visible through the parts that share it."""
from ..texts import translate
from . import surface
from .base import View, set_if_there, state_icon
from .ghost import Overlay

COLOUR = (0.90, 0.10, 0.10)


class SharedBody(Overlay):
    """The shared volume of two parts, visible through them. Not part of any document."""

    def __init__(self, document):
        from pivy import coin

        super().__init__(document)
        seen, shade = coin.SoAnnotation(), coin.SoMaterial()
        shade.diffuseColor = COLOUR
        self.surface = coin.SoGroup()
        for node in (shade, self.surface):
            seen.addChild(node)
        self.root.addChild(seen)

    def show(self, drawn):
        """Draws a result of surface.drawn(); None: draws nothing."""
        self.surface.removeAllChildren()
        if drawn is not None:
            self.surface.addChild(surface.group_of(drawn, solid=True))


class SharedView(View):
    """View provider of the shared volume."""

    EDITOR = "SweptVolume_Overlap"

    def __init__(self, view):
        super().__init__(view)
        set_if_there(view, ShapeColor=COLOUR, Transparency=0, DisplayMode="Shaded")

    def getIcon(self):
        return state_icon("SweptVolume_Overlap", self.Object)

    def setupContextMenu(self, view, menu):
        commands = ((translate("SweptVolume", "Compute again"), self.EDITOR),)
        self.add_commands(menu, view.Object, commands)
