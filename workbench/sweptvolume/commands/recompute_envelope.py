# SPDX-License-Identifier: LGPL-2.1-or-later
"""Recompute envelope: a new run with the present inputs."""
from ..convert import InputProblem
from ..features.base import objects_of_kind
from ..features.envelope import UP_TO_DATE, Envelope
from ..texts import mark, translate
from .base import BaseCommand


class Command(BaseCommand):
    NAME = "SweptVolume_Recompute"
    TEXT = mark("Commands", "Recompute envelope")
    TIP = mark(
        "Commands",
        "Computes the selected envelope again from its present parts and motion; without a selection the "
        "first one that is stale",
    )

    def run(self, document):
        from ..panels import envelope_panel, selection

        obj = selection.envelope()
        if obj is None:
            stale = [o for o in objects_of_kind(document, Envelope.KIND) if o.Status != UP_TO_DATE]
            if not stale:
                raise InputProblem(
                    translate("Messages", "No envelope is stale. Select one to compute it again.")
                )
            obj = stale[0]
        envelope_panel.show(document, obj=obj, start=True)
