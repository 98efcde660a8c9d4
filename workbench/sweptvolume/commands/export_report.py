# SPDX-License-Identifier: LGPL-2.1-or-later
"""Export report: what a clearance check found as an HTML page or a PDF."""
from ..texts import mark, translate
from .base import BaseCommand


class Command(BaseCommand):
    NAME = "SweptVolume_ExportReport"
    TEXT = mark("Commands", "Export report...")
    TIP = mark(
        "Commands",
        "Writes what the selected clearance check found as one HTML file with a 3D view, or as PDF",
    )

    def missing(self, document):
        from ..features.clearance import Clearance
        from ..panels import selection

        found, count = selection.of_kind(document, Clearance.KIND)
        if found is not None:
            return ""
        if count:
            return translate("Messages", "Select one of the {0} clearance checks.").format(count)
        return translate(
            "Messages",
            "There is no clearance check in the document: make one with Check clearance.",
        )

    def run(self, document):
        from ..features.clearance import Clearance
        from ..panels import file_dialogs, page_task, run_panel, selection

        found = selection.of_kind(document, Clearance.KIND)[0]
        path = file_dialogs.ask_report(found.Label)
        if path:
            run_panel.show(page_task.PageTask(found, path), self.NAME)
