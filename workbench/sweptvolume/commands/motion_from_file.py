# SPDX-License-Identifier: LGPL-2.1-or-later
"""Motion from file: reads a CSV file with a given unit."""
from ..texts import QT_TRANSLATE_NOOP
from .base import BaseCommand


class Command(BaseCommand):
    NAME = "SweptVolume_MotionFromFile"
    TEXT = QT_TRANSLATE_NOOP("SweptVolume", "Motion from file...")
    TIP = QT_TRANSLATE_NOOP(
        "SweptVolume",
        "Reads a motion from a CSV file. Each row holds time, position and "
        "quaternion (t,tx,ty,tz,qx,qy,qz,qw), or the 16 numbers of a matrix",
    )

    def run(self, document):
        from ..panels import file_panel

        path = file_panel.ask_file()
        if path:
            file_panel.show(document, path)
