# SPDX-License-Identifier: LGPL-2.1-or-later
"""Table of the paths that were found. Each path is a motion of the document; only the chosen one is
visible."""
from .. import quantities
from ..texts import translate
from . import widgets
from .widgets import QtCore, QtWidgets


class PathsTable(QtCore.QObject):
    """Signal `chosen(obj)`: another motion was chosen. The table is hidden while it is empty."""

    chosen = QtCore.Signal(object)

    def __init__(self, document, layout):
        super().__init__()
        self.document, self.names = document, []
        one, unit = quantities.length_unit()
        self.one = one
        self.group = QtWidgets.QGroupBox(translate("SweptVolume", "Paths"))
        rows = QtWidgets.QVBoxLayout(self.group)
        rows.setContentsMargins(*widgets.MARGINS)
        self.table = QtWidgets.QTableWidget(0, 5)
        self.table.setObjectName("SweptVolumePaths")
        self.table.setHorizontalHeaderLabels(
            [
                translate("SweptVolume", "Motion"),
                translate("SweptVolume", "Keys"),
                "{}\n{}".format(translate("SweptVolume", "Length"), unit),
                "{}\ndeg".format(translate("SweptVolume", "Turns")),
                "{}\n{}".format(translate("SweptVolume", "Clearance"), unit),
            ]
        )
        self.table.verticalHeader().hide()
        self.table.setTabKeyNavigation(False)
        self.table.setSelectionBehavior(QtWidgets.QAbstractItemView.SelectRows)
        self.table.setSelectionMode(QtWidgets.QAbstractItemView.SingleSelection)
        self.table.setEditTriggers(QtWidgets.QAbstractItemView.NoEditTriggers)
        modes = QtWidgets.QHeaderView
        for column in range(5):
            mode = modes.ResizeToContents if column else modes.Stretch
            self.table.horizontalHeader().setSectionResizeMode(column, mode)
        self.table.setFixedHeight(96)
        rows.addWidget(self.table)
        layout.addWidget(self.group)
        self.group.hide()
        self.table.itemSelectionChanged.connect(self._chosen)

    def add(self, obj, report):
        """Adds a motion with the figures of its report, and chooses it."""
        row = self.table.rowCount()
        self.table.setRowCount(row + 1)
        self.names.append(obj.Name)
        texts = (
            obj.Label,
            str(report["keys"]),
            quantities.number(report["length"] / self.one),
            quantities.number(report["turn_degrees"]),
            quantities.number(report["clearance"] / self.one),
        )
        right = widgets.number_of(QtCore.Qt.AlignRight | QtCore.Qt.AlignVCenter)
        for column, text in enumerate(texts):
            item = QtWidgets.QTableWidgetItem(text)
            item.setToolTip(text)
            if column:
                item.setTextAlignment(right)
            self.table.setItem(row, column, item)
        self.group.show()
        self.table.selectRow(row)

    def motion(self):
        """Returns the chosen motion, or None if there is none or it was deleted."""
        row = self.table.currentRow()
        return self.document.getObject(self.names[row]) if 0 <= row < len(self.names) else None

    def _chosen(self):
        """Shows the chosen path and hides the others of the table."""
        now = self.motion()
        for name in self.names:
            obj = self.document.getObject(name)
            if obj is not None:
                obj.ViewObject.Visibility = obj is now
        if now is not None:
            self.chosen.emit(now)
