# SPDX-License-Identifier: LGPL-2.1-or-later
"""A table of the rows of a report, with coloured verdicts."""
from PySide import QtCore, QtGui

from ..features import clearance_table
from ..views.clearance_view import BANDS
from .shades import ShadedCells
from .widgets import QtWidgets


class _Header(QtWidgets.QHeaderView):
    """A horizontal header with columns as narrow as their titles allow. Qt leaves room for the arrow
    of the sorted column in every column, and too much for a title of two lines."""

    def __init__(self):
        super().__init__(QtCore.Qt.Horizontal)
        self.setSectionsClickable(True)
        self.setHighlightSections(True)

    def sectionSizeFromContents(self, column):
        size = super().sectionSizeFromContents(column)
        metrics = self.fontMetrics()
        lines = str(self.model().headerData(column, QtCore.Qt.Horizontal) or "").split("\n")
        width = max(metrics.boundingRect(line).width() for line in lines)
        width += 3 * metrics.averageCharWidth()
        if self.isSortIndicatorShown() and column == self.sortIndicatorSection():
            width += metrics.height()  # the arrow
        return QtCore.QSize(min(size.width(), width), size.height())


class VerdictTable(QtWidgets.QTableWidget):
    """The first column shows the name of a row, the second its verdict. Each cell keeps the index
    of its row in the report, so the table can be sorted."""

    def __init__(self, name, heads):
        super().__init__(0, len(heads))
        self.setObjectName(name)
        self.setHorizontalHeader(_Header())
        self.setHorizontalHeaderLabels(heads)
        self.shades = ShadedCells()  # the table does not keep a reference to it
        self.setItemDelegateForColumn(1, self.shades)
        self.setSelectionBehavior(QtWidgets.QAbstractItemView.SelectRows)
        self.setSelectionMode(QtWidgets.QAbstractItemView.SingleSelection)
        self.setEditTriggers(QtWidgets.QAbstractItemView.NoEditTriggers)
        self.verticalHeader().hide()
        self.setTabKeyNavigation(False)  # Tab leaves the table
        self.setMinimumHeight(140)
        modes = QtWidgets.QHeaderView
        # Long names may take two lines; numbers show all their digits.
        for column in range(len(heads)):
            mode = modes.ResizeToContents if column else modes.Stretch
            self.horizontalHeader().setSectionResizeMode(column, mode)

    def put(self, line, cells, index, row):
        """Fills a line of the table with cells. index: of the row in the report; row: this row,
        with the keys that clearance_table reads."""
        rank = clearance_table.WORST_FIRST.index(clearance_table.judged(row))
        cells[0].setToolTip(cells[0].text())
        cells[1].setBackground(QtGui.QColor.fromRgbF(*BANDS[rank]))
        for column, cell in enumerate(cells):
            cell.setData(QtCore.Qt.UserRole, index)
            self.setItem(line, column, cell)

    def chosen(self):
        """Returns the index, in the report, of the chosen row, or -1."""
        items = self.selectedItems()
        return items[0].data(QtCore.Qt.UserRole) if items else -1

    def choose(self, index):
        """Chooses a row by its index in the report."""
        for line in range(self.rowCount()):
            if self.item(line, 0).data(QtCore.Qt.UserRole) == index:
                self.selectRow(line)
                self.scrollToItem(self.item(line, 0))
