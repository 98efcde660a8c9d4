# SPDX-License-Identifier: LGPL-2.1-or-later
"""Cells of sortable tables."""
from .widgets import QtWidgets


class SortedCell(QtWidgets.QTableWidgetItem):
    """A cell that shows a text and sorts by a key."""

    def __init__(self, text, key):
        super().__init__(text)
        self.key = key

    def __lt__(self, other):
        return self.key < other.key
