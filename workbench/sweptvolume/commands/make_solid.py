# SPDX-License-Identifier: LGPL-2.1-or-later
"""Make solid: converts the selected envelope to a B-rep solid."""
from ..texts import QT_TRANSLATE_NOOP
from .base import BaseCommand


class Command(BaseCommand):
    NAME = "SweptVolume_Solid"
    TEXT = QT_TRANSLATE_NOOP("SweptVolume", "Make solid")
    TIP = QT_TRANSLATE_NOOP(
        "SweptVolume",
        "Converts the selected envelope to a solid for Boolean operations, measuring and STEP. "
        "A selected solid is converted again",
    )

    def missing(self, document):
        from ..panels import selection

        if selection.source() is not None or selection.solid() is not None:
            return ""
        return selection.missing_envelope_text(document)

    def run(self, document):
        from ..panels import selection, solid_panel

        obj, source = selection.solid(), selection.source()
        if obj is None and source is None:
            source = selection.the_envelope(document)
        solid_panel.show(source or obj.Source, obj)
