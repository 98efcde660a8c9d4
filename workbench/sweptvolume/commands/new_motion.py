# SPDX-License-Identifier: LGPL-2.1-or-later
"""New motion: opens the motion editor with an empty motion."""
from ..texts import QT_TRANSLATE_NOOP
from .base import BaseCommand


class Command(BaseCommand):
    NAME = "SweptVolume_NewMotion"
    TEXT = QT_TRANSLATE_NOOP("SweptVolume", "New motion...")
    TIP = QT_TRANSLATE_NOOP(
        "SweptVolume",
        "Opens the motion editor: move the selected part step by step and capture its placements",
    )

    def run(self, document):
        from ..panels import motion_panel

        motion_panel.show(document)
