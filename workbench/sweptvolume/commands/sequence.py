# SPDX-License-Identifier: LGPL-2.1-or-later
"""Sequence: parts that are installed one after the other."""
from ..texts import mark
from .base import BaseCommand


class Command(BaseCommand):
    NAME = "SweptVolume_Sequence"
    TEXT = mark("Commands", "Sequence...")
    TIP = mark(
        "Commands",
        "Finds installation paths for the selected parts, one after the other: each part keeps "
        "clear of those already in place. The order is given or found. Opens a selected "
        "sequence",
    )

    def run(self, document):
        from ..panels import selection, sequence_panel

        found = selection.sequence()
        if found is not None:
            sequence_panel.show(document, obj=found)
        else:
            sequence_panel.show(document, pairs=selection.parts())
