# SPDX-License-Identifier: LGPL-2.1-or-later
"""How a sequence looks in the tree; what it shows in the 3D view belongs to its panel."""
from ..texts import translate
from .base import verdict_icon
from .mechanism_view import MechanismView


class SequenceView(MechanismView):
    """View provider of the sequence."""

    EDITOR = "SweptVolume_Sequence"

    def getIcon(self):
        return verdict_icon("SweptVolume_Sequence", self.Object)

    def setupContextMenu(self, view, menu):
        self.add_commands(menu, view.Object, ((translate("Commands", "Sequence..."), self.EDITOR),))
