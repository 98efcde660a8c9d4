# SPDX-License-Identifier: LGPL-2.1-or-later
"""How a study looks in the tree."""
from ..features.base import UP_TO_DATE
from ..texts import translate
from .base import View, run_command, shown_icon, verdict_icon


class StudyView(View):
    """View provider of the study."""

    EDITOR = "SweptVolume_Study"

    def getIcon(self):
        if self.Object.Verdict == "failed" and self.Object.Status == UP_TO_DATE:
            return shown_icon("SweptVolume_Study_failed")
        return verdict_icon("SweptVolume_Study", self.Object)

    def claimChildren(self):
        return []  # its sources stand with their parts

    def setupContextMenu(self, view, menu):
        text = translate("Commands", "Study...")
        self.add_menu(menu, text, self.EDITOR, lambda: run_command(view.Object, self.EDITOR))
        self.add_menu(
            menu,
            translate("Commands", "Export report..."),
            "SweptVolume_ExportReport",
            lambda: run_command(view.Object, "SweptVolume_ExportReport"),
        )
