# SPDX-License-Identifier: LGPL-2.1-or-later
"""Edit envelope: opens the panel of an existing envelope."""
from ..texts import QT_TRANSLATE_NOOP
from .base import BaseCommand


class Command(BaseCommand):
    NAME = "SweptVolume_EditEnvelope"
    TEXT = QT_TRANSLATE_NOOP("SweptVolume", "Edit envelope...")
    TIP = QT_TRANSLATE_NOOP(
        "SweptVolume", "Changes the parts, motion or settings of the selected envelope"
    )
    ICON = "SweptVolume_Envelope"

    def missing(self, document):
        from ..panels import selection

        return selection.missing_envelope_text(document)

    def run(self, document):
        from ..panels import envelope_panel, selection

        obj = selection.the_envelope(document)
        envelope_panel.show(document, obj=obj)
