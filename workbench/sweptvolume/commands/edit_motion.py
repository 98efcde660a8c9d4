# SPDX-License-Identifier: LGPL-2.1-or-later
"""Edit motion: opens the motion editor for an existing motion."""
from ..texts import QT_TRANSLATE_NOOP
from .base import BaseCommand


class Command(BaseCommand):
    NAME = "SweptVolume_EditMotion"
    TEXT = QT_TRANSLATE_NOOP("SweptVolume", "Edit motion...")
    TIP = QT_TRANSLATE_NOOP(
        "SweptVolume",
        "Edits the keys of the selected motion in a table and in the 3D view, and plays the "
        "motion",
    )

    def missing(self, document):
        from ..panels import selection

        return selection.missing_motion_text(document)

    def run(self, document):
        from ..panels import motion_panel, selection

        obj = selection.the_motion(document)
        motion_panel.show(document, obj)
