# SPDX-License-Identifier: LGPL-2.1-or-later
"""Check reserved spaces: compares parts and envelopes that stand still."""
from ..texts import QT_TRANSLATE_NOOP
from .base import BaseCommand


class Command(BaseCommand):
    NAME = "SweptVolume_Overlap"
    TEXT = QT_TRANSLATE_NOOP("SweptVolume", "Check reserved spaces")
    TIP = QT_TRANSLATE_NOOP(
        "SweptVolume",
        "Measures the distances between envelopes, solids of envelopes, and parts that do not "
        "move. If two of them overlap, also measures the volume they share. Select two or more "
        "objects. To recompute an existing shared volume, select it",
    )

    def run(self, document):
        from ..features.shared import Plan
        from ..panels import overlap_panel, run_panel, selection, tasks

        obj = selection.shared()
        if obj is not None:
            run_panel.show(tasks.SharedTask(document, Plan.of(obj), obj), self.NAME)
        else:
            overlap_panel.show(document, selection.spaces())
