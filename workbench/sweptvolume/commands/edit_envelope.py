# SPDX-License-Identifier: LGPL-2.1-or-later
"""Edit envelope: the panel of an existing envelope."""
from ..convert import InputProblem
from ..texts import mark, translate
from .base import BaseCommand


class Command(BaseCommand):
    NAME = "SweptVolume_EditEnvelope"
    TEXT = mark("Commands", "Edit envelope...")
    TIP = mark("Commands", "Changes parts, motion or accuracy of the selected envelope")
    ICON = "SweptVolume_Envelope"

    def run(self, document):
        from ..panels import envelope_panel, selection

        obj = selection.envelope()
        if obj is None:
            raise InputProblem(translate("Messages", "Select an envelope first."))
        envelope_panel.show(document, obj=obj)
