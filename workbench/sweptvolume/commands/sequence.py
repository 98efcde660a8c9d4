# SPDX-License-Identifier: LGPL-2.1-or-later
"""Sequence: parts that are installed one after the other."""
from ..texts import mark
from .base import BaseCommand


class Command(BaseCommand):
    NAME = "SweptVolume_Sequence"
    TEXT = mark("Commands", "Sequence...")
    TIP = mark(
        "Commands",
        "Installs the selected parts one after the other, each clear of all that is there by then: finds "
        "their ways in this order, or an order, and plays them as one. Or opens the selected sequence",
    )

    def run(self, document):
        from ..panels import selection, sequence_panel

        found = selection.sequence()
        if found is not None:
            sequence_panel.show(document, obj=found)
        else:
            sequence_panel.show(document, pairs=selection.parts())
