# SPDX-License-Identifier: LGPL-2.1-or-later
"""Recompute envelope: computes an envelope again with its present inputs."""
from ..convert import InputProblem
from ..features.base import objects_of_kind
from ..features.envelope import UP_TO_DATE, Envelope
from ..texts import QT_TRANSLATE_NOOP, translate
from .base import BaseCommand


class Command(BaseCommand):
    NAME = "SweptVolume_Recompute"
    TEXT = QT_TRANSLATE_NOOP("SweptVolume", "Recompute envelope")
    TIP = QT_TRANSLATE_NOOP(
        "SweptVolume",
        "Recomputes the selected envelope from its current parts and motion. Without "
        "a selection, recomputes the first envelope that is not up to date, or the only envelope",
    )

    def find(self, document):
        """Returns the selected envelope. Without a selection, returns the first envelope that is
        not up to date, or the only one."""
        from ..panels import selection

        known = objects_of_kind(document, Envelope.KIND)
        waiting = [o for o in known if o.Status != UP_TO_DATE]
        only = known if len(known) == 1 else []
        return selection.envelope() or next(iter(waiting or only), None)

    def missing(self, document):
        from ..panels import selection

        if self.find(document) is not None:
            return ""
        if not objects_of_kind(document, Envelope.KIND):
            return selection.missing_envelope_text(document)
        return translate(
            "SweptVolume",
            "All envelopes are up to date. To compute one of them again anyway, select it.",
        )

    def run(self, document):
        from ..panels import envelope_panel

        obj = self.find(document)
        if obj is None:
            raise InputProblem(self.missing(document))
        envelope_panel.show(document, obj=obj, start=True)
