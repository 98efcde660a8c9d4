# SPDX-License-Identifier: LGPL-2.1-or-later
"""The table of a study's panel: a row for each run, with its state."""
from PySide import QtCore, QtGui

from ..features import study_table
from ..texts import translate
from ..views.clearance_view import BANDS
from . import focus
from .shades import ShadedCells
from .sorted_cell import SortedCell
from .widgets import QtWidgets

#: State of a run -> colour behind it (of BANDS), None: none.
_COLOURS = {"failed": 0, "not clear": 1, "not run": None, "done": 3}
_ORDER = list(study_table.STATES)


class RowTable(QtWidgets.QTableWidget):
    """Rows in the order of the study until somebody sorts them."""

    def __init__(self):
        super().__init__(0, 4)
        self.setObjectName("SweptVolumeStudyTable")
        self.rows, self.places = [], {}
        heads = (
            translate("Panels", "Run"),
            translate("Panels", "State"),
            translate("Panels", "Verdict"),
            translate("Panels", "Distance"),
        )
        self.setHorizontalHeaderLabels(heads)
        self.shades = ShadedCells()  # the table does not keep it
        self.setItemDelegateForColumn(1, self.shades)
        self.setSelectionBehavior(QtWidgets.QAbstractItemView.SelectRows)
        self.setSelectionMode(QtWidgets.QAbstractItemView.SingleSelection)
        self.setEditTriggers(QtWidgets.QAbstractItemView.NoEditTriggers)
        self.verticalHeader().hide()
        font = self.font()
        font.setPointSizeF(font.pointSizeF() * 0.9)
        self.setFont(font)
        self.horizontalHeader().setFont(font)
        modes = QtWidgets.QHeaderView
        for column in range(4):
            self.horizontalHeader().setSectionResizeMode(
                column, modes.Interactive if column else modes.Stretch
            )
        self.setMinimumHeight(180)
        self.setTabKeyNavigation(False)  # Tab leaves the table
        self.keys = focus.SortKeys(self)

    def begin(self, names):
        """A run of these begins: nothing has ended yet."""
        self._fill([{"run": name, "state": "not run"} for name in names])

    def take(self, found):
        """found: {name of a run: its row} of those that have ended."""
        for name, row in found.items():
            place = self.places.get(name)
            if place is not None and self.rows[place] != row:
                self.rows[place] = row
                self._write(place)

    def show_report(self, report):
        self._fill(report["runs"])
        names = [row["run"] for row in self.rows]
        if report["worst"] in names:
            self.scrollToItem(self.item(names.index(report["worst"]), 0))

    def chosen(self):
        """The row that is selected; None: none is."""
        items = self.selectedItems()
        return self.rows[items[0].data(QtCore.Qt.UserRole)] if items else None

    def _fill(self, rows):
        self.setSortingEnabled(False)
        self.clearSelection()
        self.rows = list(rows)
        self.places = {row["run"]: place for place, row in enumerate(self.rows)}
        self.setUpdatesEnabled(False)
        self.setRowCount(len(self.rows))
        for place in range(len(self.rows)):
            self._write(place)
        self.setUpdatesEnabled(True)
        for column in (1, 2, 3):
            self.resizeColumnToContents(column)

    def _write(self, place):
        row = self.rows[place]
        state = row["state"]
        clash = -row.get("depth", 0.0) if row.get("verdict") == "clash" else 0.0
        cells = (
            SortedCell(row["run"], row["run"].lower()),
            SortedCell(study_table.state_text(row), _ORDER.index(state)),
            SortedCell(study_table.verdict_text(row), study_table.verdict_text(row)),
            SortedCell(study_table.length_text(row), clash or row.get("distance", float("inf"))),
        )
        for column, cell in enumerate(cells):
            cell.setData(QtCore.Qt.UserRole, place)
            cell.setToolTip(study_table.told(row))
            self.setItem(place, column, cell)
        if _COLOURS[state] is not None:
            cells[1].setBackground(QtGui.QColor.fromRgbF(*BANDS[_COLOURS[state]]))
