# SPDX-License-Identifier: LGPL-2.1-or-later
"""Export report: what a check of distances, or a study, found as an HTML page or a PDF."""
from ..texts import mark, translate
from .base import BaseCommand


def _kinds():
    """KIND of what has a report -> the task that writes it, given the object and the path."""
    from ..features import clearance, mechanism, study
    from ..panels import page_task, study_tasks

    return {
        clearance.Clearance.KIND: page_task.PageTask,
        mechanism.Mechanism.KIND: page_task.PageTask,
        study.Study.KIND: study_tasks.StudyPageTask,
    }


class Command(BaseCommand):
    NAME = "SweptVolume_ExportReport"
    TEXT = mark("Commands", "Export report...")
    TIP = mark(
        "Commands",
        "Writes what the selected check or study found as one HTML file, with a 3D view of a check, or as "
        "PDF",
    )

    def _found(self, document):
        """(object or None, how many there are, its task)."""
        from ..panels import selection

        found = {kind: selection.of_kind(document, kind) for kind in _kinds()}
        count = sum(number for _, number in found.values())
        chosen = selection.reported()
        if chosen is None and count == 1:
            chosen = next(obj for obj, _ in found.values() if obj is not None)
        return chosen, count

    def missing(self, document):
        found, count = self._found(document)
        if found is not None:
            return ""
        if count:
            return translate("Messages", "Select one of the {0} checks and studies.").format(count)
        return translate(
            "Messages",
            "There is no check in the document: make one with Check clearance or Check mechanism.",
        )

    def run(self, document):
        from ..features.base import kind_of
        from ..panels import file_dialogs, run_panel

        found, _ = self._found(document)
        path = file_dialogs.ask_report(found.Label)
        if path:
            run_panel.show(_kinds()[kind_of(found)](found, path), self.NAME)
