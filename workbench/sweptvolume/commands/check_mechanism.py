# SPDX-License-Identifier: LGPL-2.1-or-later
"""Check mechanism: smallest distances between parts that move at the same time."""
from ..texts import QT_TRANSLATE_NOOP
from .base import BaseCommand


class Command(BaseCommand):
    NAME = "SweptVolume_Mechanism"
    TEXT = QT_TRANSLATE_NOOP("SweptVolume", "Check mechanism")
    TIP = QT_TRANSLATE_NOOP(
        "SweptVolume",
        "Measures the smallest distance of every pair of parts that move at the same time, over "
        "the whole motion. Select their motions, or an existing check. Without a selection, all "
        "motions that have parts assigned are checked",
    )

    def run(self, document):
        from ..features import motion
        from ..features.base import objects_of_kind
        from ..panels import mechanism_panel, selection

        found = selection.mechanism()
        if found is not None:
            mechanism_panel.show(document, obj=found)
            return
        chosen = selection.motions() or objects_of_kind(document, motion.Motion.KIND)
        parts = {}
        for path in chosen:
            for pair in motion.parts_of(path):
                parts.setdefault(pair, path)
        mechanism_panel.show(document, pairs=list(parts), motions=list(parts.values()))
