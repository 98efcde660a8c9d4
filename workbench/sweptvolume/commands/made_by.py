# SPDX-License-Identifier: LGPL-2.1-or-later
"""What made this?: shows which face of which part created a point of an envelope, and when."""
from ..texts import QT_TRANSLATE_NOOP
from .base import BaseCommand


class Command(BaseCommand):
    NAME = "SweptVolume_MadeBy"
    TEXT = QT_TRANSLATE_NOOP("SweptVolume", "What made this?")
    TIP = QT_TRANSLATE_NOOP(
        "SweptVolume",
        "Colours the selected envelope by the faces that made it. Click on the "
        "envelope to see which part passed there, with which face or edge, and when",
    )

    def missing(self, document):
        from ..panels import selection

        return selection.missing_envelope_text(document)

    def run(self, document):
        from ..panels import made_panel, selection

        obj = selection.the_envelope(document)
        made_panel.show(document, obj)
