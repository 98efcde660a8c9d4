# SPDX-License-Identifier: LGPL-2.1-or-later
"""A study in the tree."""
from ..features.base import UP_TO_DATE
from ..texts import translate
from .base import View, shown_icon, verdict_icon


class StudyView(View):
    """View provider of the study."""

    EDITOR = "SweptVolume_Study"

    def getIcon(self):
        if self.Object.Verdict == "failed" and self.Object.Status == UP_TO_DATE:
            return shown_icon("SweptVolume_Study_failed")
        return verdict_icon("SweptVolume_Study", self.Object)

    def claimChildren(self):
        return []  # the tree shows its sources below their parts

    def setupContextMenu(self, view, menu):
        commands = (
            (translate("SweptVolume", "Study..."), self.EDITOR),
            (translate("SweptVolume", "Export report..."), "SweptVolume_ExportReport"),
        )
        self.add_commands(menu, view.Object, commands)
