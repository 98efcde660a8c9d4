# SPDX-License-Identifier: LGPL-2.1-or-later
"""Cells of tables that people sort."""
from .widgets import QtWidgets


class SortedCell(QtWidgets.QTableWidgetItem):
    """A cell that sorts by a key and shows a text."""

    def __init__(self, text, key):
        super().__init__(text)
        self.key = key

    def __lt__(self, other):
        return self.key < other.key
