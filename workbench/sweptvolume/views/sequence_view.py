# SPDX-License-Identifier: LGPL-2.1-or-later
"""A sequence in the tree. Its panel draws in the 3D view."""
from ..texts import translate
from .base import verdict_icon
from .mechanism_view import MechanismView


class SequenceView(MechanismView):
    """View provider of the sequence."""

    EDITOR = "SweptVolume_Sequence"

    def getIcon(self):
        return verdict_icon("SweptVolume_Sequence", self.Object)

    def setupContextMenu(self, view, menu):
        self.add_commands(
            menu, view.Object, ((translate("SweptVolume", "Sequence..."), self.EDITOR),)
        )
