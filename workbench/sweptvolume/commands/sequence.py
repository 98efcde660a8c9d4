# SPDX-License-Identifier: LGPL-2.1-or-later
"""Sequence: finds paths for parts that are installed one after the other."""
from ..texts import QT_TRANSLATE_NOOP
from .base import BaseCommand


class Command(BaseCommand):
    NAME = "SweptVolume_Sequence"
    TEXT = QT_TRANSLATE_NOOP("SweptVolume", "Sequence...")
    TIP = QT_TRANSLATE_NOOP(
        "SweptVolume",
        "Finds installation paths for the selected parts, one after the other. Each "
        "part keeps its distance from the parts already in place. You give the "
        "order, or the search finds one. If a sequence is selected, it is opened",
    )

    def run(self, document):
        from ..panels import selection, sequence_panel

        found = selection.sequence()
        if found is not None:
            sequence_panel.show(document, obj=found)
        else:
            sequence_panel.show(document, pairs=selection.parts())
