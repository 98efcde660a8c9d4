# SPDX-License-Identifier: LGPL-2.1-or-later
"""Export report: writes the results of a check or a study as an HTML page or a PDF."""
from ..texts import QT_TRANSLATE_NOOP, translate
from .base import BaseCommand


class Command(BaseCommand):
    NAME = "SweptVolume_ExportReport"
    TEXT = QT_TRANSLATE_NOOP("SweptVolume", "Export report...")
    TIP = QT_TRANSLATE_NOOP(
        "SweptVolume",
        "Writes the results of the selected check or study as one HTML file or as "
        "PDF. The HTML file of a check has a 3D view",
    )

    def _found(self, document):
        """Returns (object, count). object is the selected object that has a report, or the only one
        of the document, or None. count is the number of such objects."""
        from ..panels import selection

        known = [obj for obj in document.Objects if selection.has_report(obj)]
        chosen = selection.reported()
        if chosen is None and len(known) == 1:
            chosen = known[0]
        return chosen, len(known)

    def missing(self, document):
        found, count = self._found(document)
        if found is not None:
            return ""
        if count:
            return translate(
                "SweptVolume", "The document has {0} checks and studies: select one of them."
            ).format(count)
        return translate(
            "SweptVolume",
            "There is no check in the document: make one with Check clearance or Check mechanism.",
        )

    def run(self, document):
        from ..features.study import is_study
        from ..panels import file_dialogs, page_task, run_panel, study_tasks

        found, _ = self._found(document)
        path = file_dialogs.ask_report(found.Label)
        if path:
            task = study_tasks.StudyPageTask if is_study(found) else page_task.PageTask
            run_panel.show(task(found, path), self.NAME)
