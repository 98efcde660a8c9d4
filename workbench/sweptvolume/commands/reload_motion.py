# SPDX-License-Identifier: LGPL-2.1-or-later
"""Reload motion: reads the file or the source of a motion again."""
from .. import runner
from ..features import joint_motions, motion
from ..texts import QT_TRANSLATE_NOOP, translate
from .base import BaseCommand


class Command(BaseCommand):
    NAME = "SweptVolume_ReloadMotion"
    TEXT = QT_TRANSLATE_NOOP("SweptVolume", "Reload motion")
    TIP = QT_TRANSLATE_NOOP(
        "SweptVolume",
        "Reads the file or source of the selected motion again. All motions of the same driving "
        "value or simulation are read together",
    )

    def missing(self, document):
        from ..panels import selection

        return selection.missing_motion_text(document)

    def run(self, document):
        from ..panels import selection

        obj = selection.the_motion(document)
        with runner.transaction(document, translate("SweptVolume", self.TEXT)):
            # One run reads the motions of all parts of the mechanism.
            if len(joint_motions.alike(obj)) > 1:
                joint_motions.reload(obj)
            else:
                motion.reload_source(obj)
            document.recompute()
