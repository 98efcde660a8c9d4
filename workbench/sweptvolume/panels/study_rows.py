# SPDX-License-Identifier: LGPL-2.1-or-later
"""The table of a study's panel: a row for each run, with its state. Texts are created only for
visible rows, because a study may have thousands."""
from PySide import QtCore, QtGui

from ..features import study_table
from ..texts import translate
from ..views.clearance_view import BANDS
from . import focus
from .shades import ShadedCells
from .widgets import QtWidgets

#: State of a run -> index of its background colour in BANDS. Other states have none.
_COLOURS = {"failed": 0, "not clear": 1, "done": 3}
_ORDER = list(study_table.STATES)
#: Number of rows that determine the width of a column.
_MEASURED_ROWS = 50
_TEXTS = (
    lambda row: row["run"],
    study_table.state_text,
    study_table.verdict_text,
    study_table.length_text,
)


def _length_key(row):
    """Returns the sort key: clashes first, the deepest before all others."""
    if row.get("verdict") == "clash":
        return -row.get("depth", 0.0)
    return row.get("distance", float("inf"))


_KEYS = (
    lambda row: row["run"].lower(),
    lambda row: _ORDER.index(row["state"]),
    study_table.verdict_text,
    _length_key,
)


class _Rows(QtCore.QAbstractTableModel):
    """Rows of a study in the order in which they are shown."""

    def __init__(self):
        super().__init__()
        self.rows, self.numbers = [], {}
        self.heads = (
            translate("SweptVolume", "Run"),
            translate("SweptVolume", "State"),
            translate("SweptVolume", "Verdict"),
            translate("SweptVolume", "Distance"),
        )

    def rowCount(self, parent=None):  # noqa: N802
        return 0 if parent is not None and parent.isValid() else len(self.rows)

    def columnCount(self, parent=None):  # noqa: N802
        return 0 if parent is not None and parent.isValid() else len(self.heads)

    def headerData(self, section, orientation, role=QtCore.Qt.DisplayRole):  # noqa: N802
        shown = orientation == QtCore.Qt.Horizontal and role == QtCore.Qt.DisplayRole
        return self.heads[section] if shown else None

    def data(self, index, role=QtCore.Qt.DisplayRole):
        row, column = self.rows[index.row()], index.column()
        if role == QtCore.Qt.DisplayRole:
            return _TEXTS[column](row)
        if role == QtCore.Qt.ToolTipRole:
            return study_table.line_of(row)
        if role == QtCore.Qt.BackgroundRole and column == 1 and row["state"] in _COLOURS:
            return QtGui.QBrush(QtGui.QColor.fromRgbF(*BANDS[_COLOURS[row["state"]]]))
        return None

    def sort(self, column, order=QtCore.Qt.AscendingOrder):
        if column < 0:
            return
        self.layoutAboutToBeChanged.emit()
        self.rows.sort(key=_KEYS[column], reverse=order == QtCore.Qt.DescendingOrder)
        self._number()
        self.layoutChanged.emit()

    def fill(self, rows):
        self.beginResetModel()
        self.rows = list(rows)
        self._number()
        self.endResetModel()

    def take(self, found):
        """Stores rows. found: {name of a run: its row}."""
        for name, row in found.items():
            number = self.numbers.get(name)
            if number is not None and self.rows[number] != row:
                self.rows[number] = row
                self.dataChanged.emit(self.index(number, 0), self.index(number, 3))

    def _number(self):
        self.numbers = {row["run"]: number for number, row in enumerate(self.rows)}


class RowTable(QtWidgets.QTableView):
    """Rows in the order of the study until the user sorts them. Signal `chose`: another row is
    selected."""

    chose = QtCore.Signal()

    def __init__(self):
        super().__init__()
        self.setObjectName("SweptVolumeStudyTable")
        self.rows = _Rows()
        self.setModel(self.rows)
        self.shades = ShadedCells()  # the table does not keep a reference to it
        self.setItemDelegateForColumn(1, self.shades)
        self.setSelectionBehavior(QtWidgets.QAbstractItemView.SelectRows)
        self.setSelectionMode(QtWidgets.QAbstractItemView.SingleSelection)
        self.setEditTriggers(QtWidgets.QAbstractItemView.NoEditTriggers)
        self.verticalHeader().hide()
        font = self.font()
        font.setPointSizeF(font.pointSizeF() * 0.9)
        self.setFont(font)
        header, modes = self.horizontalHeader(), QtWidgets.QHeaderView
        header.setFont(font)
        header.setSectionResizeMode(0, modes.Stretch)
        header.setHighlightSections(False)
        header.setResizeContentsPrecision(_MEASURED_ROWS)
        header.setSortIndicator(-1, QtCore.Qt.AscendingOrder)  # no sorting: the order of the study
        self.setSortingEnabled(True)
        self.setMinimumHeight(180)
        self.setTabKeyNavigation(False)  # Tab leaves the table
        self.keys = focus.SortKeys(self)
        self.selectionModel().selectionChanged.connect(lambda *ignored: self.chose.emit())

    def currentColumn(self):  # noqa: N802 (as focus.SortKeys asks of tables)
        return self.currentIndex().column()

    def sortItems(self, column, order):  # noqa: N802
        self.sortByColumn(column, order)

    def begin(self, names):
        """Clears the rows when a run of these names begins."""
        self._fill([{"run": name, "state": "not run"} for name in names])

    def take(self, found):
        """Shows rows. found: {name of a run: its row} of the runs that have ended."""
        self.rows.take(found)

    def show_report(self, report):
        self._fill(report["runs"])
        number = self.rows.numbers.get(report["worst"])
        if number is not None:
            self.scrollTo(self.rows.index(number, 0))

    def chosen(self):
        """Returns the selected row, or None."""
        chosen = self.selectionModel().selectedRows()
        return self.rows.rows[chosen[0].row()] if chosen else None

    def _fill(self, rows):
        self.clearSelection()
        self.rows.fill(rows)
        header = self.horizontalHeader()
        if header.sortIndicatorSection() >= 0:
            self.rows.sort(header.sortIndicatorSection(), header.sortIndicatorOrder())
        for column in (1, 2, 3):
            self.resizeColumnToContents(column)
