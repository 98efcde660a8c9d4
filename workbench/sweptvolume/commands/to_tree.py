# SPDX-License-Identifier: LGPL-2.1-or-later
"""Keyboard to the tree or panel: lets the user select parts without a mouse."""
from ..texts import QT_TRANSLATE_NOOP
from .base import BaseCommand


class Command(BaseCommand):
    NAME = "SweptVolume_ToTree"
    TEXT = QT_TRANSLATE_NOOP("SweptVolume", "Keyboard to the tree or panel")
    TIP = QT_TRANSLATE_NOOP(
        "SweptVolume",
        "Moves the keyboard focus to the tree. There the arrow keys select; Ctrl "
        "with the arrow keys and Space selects more objects. If the focus is in the "
        "tree, moves it to the open panel",
    )
    ACCEL = "Ctrl+T"
    #: With this kind, FreeCAD keeps the command enabled while a panel is open.
    KIND = "ForEdit"

    def IsActive(self):
        return True

    def run(self, document):
        from ..panels import focus

        focus.to_tree_or_panel()
