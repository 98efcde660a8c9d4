# SPDX-License-Identifier: LGPL-2.1-or-later
"""Demo: opens the example."""
from ..texts import mark
from .base import BaseCommand


class Command(BaseCommand):
    NAME = "SweptVolume_Demo"
    TEXT = mark("Commands", "Open the demo")
    TIP = mark(
        "Commands",
        "Opens an example, in which a starter motor is installed past the parts around it",
    )
    NEEDS_DOCUMENT = False

    def run(self, document):
        from .. import demo

        demo.build()
