# SPDX-License-Identifier: LGPL-2.1-or-later
"""How a shared volume looks: red, and seen through what shares it."""
from ..texts import translate
from .base import View, run_command, set_if_there, state_icon

COLOUR = (0.90, 0.10, 0.10)


class SharedView(View):
    """View provider of the shared volume."""

    EDITOR = "SweptVolume_Overlap"

    def __init__(self, view):
        super().__init__(view)
        set_if_there(view, ShapeColor=COLOUR, Transparency=0, DisplayMode="Shaded")

    def getIcon(self):
        return state_icon("SweptVolume_Overlap", self.Object)

    def setupContextMenu(self, view, menu):
        text = translate("Commands", "Compute again")
        self.add_menu(menu, text, self.EDITOR, lambda: run_command(view.Object, self.EDITOR))
