# SPDX-License-Identifier: LGPL-2.1-or-later
"""Demo: opens the example."""
from ..texts import QT_TRANSLATE_NOOP
from .base import BaseCommand


class Command(BaseCommand):
    NAME = "SweptVolume_Demo"
    TEXT = QT_TRANSLATE_NOOP("SweptVolume", "Open the demo")
    TIP = QT_TRANSLATE_NOOP(
        "SweptVolume",
        "Opens an example: a starter motor is moved past the parts around it into its installed "
        "position",
    )
    NEEDS_DOCUMENT = False

    def run(self, document):
        from .. import demo

        demo.build()
