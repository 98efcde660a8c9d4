# SPDX-License-Identifier: LGPL-2.1-or-later
"""The solid of an envelope in the tree."""
from ..texts import translate
from .base import View, set_if_there, state_icon

COLOUR = (0.93, 0.78, 0.20)


class SolidView(View):
    """View provider of the solid."""

    PARENTS = ("Source",)
    EDITOR = "SweptVolume_Solid"

    def __init__(self, view):
        super().__init__(view)
        set_if_there(view, ShapeColor=COLOUR, Transparency=0, DisplayMode="Shaded")

    def getIcon(self):
        return state_icon("SweptVolume_Solid", self.Object)

    def setupContextMenu(self, view, menu):
        commands = (
            (translate("SweptVolume", "Make solid again"), "SweptVolume_Solid"),
            (translate("SweptVolume", "Export"), "SweptVolume_Export"),
        )
        self.add_commands(menu, view.Object, commands)
