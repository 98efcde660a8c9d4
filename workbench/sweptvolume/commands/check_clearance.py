# SPDX-License-Identifier: LGPL-2.1-or-later
"""Check clearance: smallest distances of the moving parts to their neighbours."""
from ..texts import QT_TRANSLATE_NOOP
from .base import BaseCommand


class Command(BaseCommand):
    NAME = "SweptVolume_Clearance"
    TEXT = QT_TRANSLATE_NOOP("SweptVolume", "Check clearance")
    TIP = QT_TRANSLATE_NOOP(
        "SweptVolume",
        "Measures the smallest distance between the moving parts and each neighbour "
        "over the whole motion. Select an envelope, or parts and a motion, or an "
        "existing check",
    )

    def run(self, document):
        from ..panels import clearance_panel, selection

        found, envelope = selection.clearance(), selection.envelope()
        if found is not None:
            clearance_panel.show(document, obj=found)
        elif envelope is not None:
            clearance_panel.show(document, envelope=envelope, neighbours=selection.parts())
        else:
            clearance_panel.show(document, pairs=selection.parts(), motion_obj=selection.motion())
