# SPDX-License-Identifier: LGPL-2.1-or-later
"""A mechanism check in the tree. Its panel draws in the 3D view."""
from ..texts import translate
from .base import View, verdict_icon


class MechanismView(View):
    """View provider of the mechanism check."""

    EDITOR = "SweptVolume_Mechanism"

    def getIcon(self):
        return verdict_icon("SweptVolume_Mechanism", self.Object)

    def claimChildren(self):
        """Returns the motions of its parts, which the tree shows below it."""
        try:
            found = [motion for motion in self.Object.Motions if motion is not None]
        except (AttributeError, ReferenceError):
            return []
        return list(dict.fromkeys(found))

    def setupContextMenu(self, view, menu):
        commands = (
            (translate("SweptVolume", "Check mechanism"), self.EDITOR),
            (translate("SweptVolume", "Export report..."), "SweptVolume_ExportReport"),
        )
        self.add_commands(menu, view.Object, commands)
