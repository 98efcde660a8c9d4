# SPDX-License-Identifier: LGPL-2.1-or-later
"""Study: computes many runs, from a study file or from the envelopes and checks of the document."""
from ..texts import QT_TRANSLATE_NOOP
from .base import BaseCommand


class Command(BaseCommand):
    NAME = "SweptVolume_Study"
    TEXT = QT_TRANSLATE_NOOP("SweptVolume", "Study...")
    TIP = QT_TRANSLATE_NOOP(
        "SweptVolume",
        "Runs many computations, several at once. The runs come from a study file, "
        "or are envelopes and clearance checks of the document. Select envelopes and "
        "checks, or an existing study",
    )

    def run(self, document):
        from ..panels import selection, study_panel

        study_panel.show(document, obj=selection.study(), sources=selection.runs())
