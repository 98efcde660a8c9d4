# SPDX-License-Identifier: LGPL-2.1-or-later
"""The parts of a sequence in their order: a table with the motion of each part (or "find a path"),
and the progress of the search."""
from .. import convert
from ..features import motion as motion_feature
from ..features.base import objects_of_kind
from ..texts import translate
from . import selection, widgets
from .widgets import QtCore, QtWidgets


class SequenceRows(QtCore.QObject):
    """Signal `changed`: other parts, another order or another motion."""

    changed = QtCore.Signal()

    def __init__(self, document, layout):
        super().__init__()
        self.document, self.pairs, self.motions, self.states = document, [], [], []
        rows = widgets.group(
            translate("SweptVolume", "Moving parts, in order of installation"), layout
        )
        self.table = QtWidgets.QTableWidget(0, 3)
        self.table.setObjectName("SweptVolumeSequenceParts")
        self.table.setHorizontalHeaderLabels(
            [
                translate("SweptVolume", "Part"),
                translate("SweptVolume", "Motion"),
                translate("SweptVolume", "State"),
            ]
        )
        self.table.verticalHeader().hide()
        self.table.setTabKeyNavigation(False)
        self.table.setSelectionBehavior(QtWidgets.QAbstractItemView.SelectRows)
        self.table.setSelectionMode(QtWidgets.QAbstractItemView.SingleSelection)
        self.table.setEditTriggers(QtWidgets.QAbstractItemView.NoEditTriggers)
        self.table.horizontalHeader().setStretchLastSection(True)
        self.table.setMinimumHeight(150)
        rows.addRow(self.table)
        line = QtWidgets.QHBoxLayout()
        for name, text, tip, act in (
            (
                "AddParts",
                translate("SweptVolume", "A&dd selected"),
                translate("SweptVolume", "Adds the parts selected in the tree or in the view"),
                self.add_selected,
            ),
            (
                "RemovePart",
                translate("SweptVolume", "Re&move"),
                translate("SweptVolume", "Removes the selected part from the sequence"),
                self.remove,
            ),
            (
                "PartUp",
                translate("SweptVolume", "&Up"),
                translate("SweptVolume", "Moves the selected part one step earlier"),
                lambda: self.move(-1),
            ),
            (
                "PartDown",
                translate("SweptVolume", "D&own"),
                translate("SweptVolume", "Moves the selected part one step later"),
                lambda: self.move(1),
            ),
        ):
            button = QtWidgets.QPushButton(text)
            button.setObjectName("SweptVolume" + name)
            widgets.hint(button, tip)
            button.clicked.connect(lambda checked=False, act=act: act())
            line.addWidget(button)
        rows.addRow(line)

    def show_rows(self, pairs, motions=None, states=None):
        """Shows the parts. motions, states: one for each part. No motion: a path is searched for.
        No state: the cell is empty."""
        self.pairs = list(pairs)
        self.motions = list(motions or [None] * len(self.pairs))
        self.states = list(states or [""] * len(self.pairs))
        self.table.setRowCount(len(self.pairs))
        for row, pair in enumerate(self.pairs):
            self._write(row, 0, convert.label_of(*pair))
            self.table.setCellWidget(row, 1, self._choice(row))
            self._write(row, 2, self.states[row])
        self.table.resizeColumnToContents(0)
        self.table.resizeColumnToContents(1)

    def _write(self, row, column, text):
        item = QtWidgets.QTableWidgetItem(text)
        item.setToolTip(text)
        self.table.setItem(row, column, item)

    def _choice(self, row):
        """Returns a combo box with "find a path" and the motions that list the part."""
        pair, now = self.pairs[row], self.motions[row]
        known = [
            m
            for m in objects_of_kind(self.document, motion_feature.Motion.KIND)
            if pair in motion_feature.parts_of(m) or m is now
        ]
        labels = [translate("SweptVolume", "find a path")] + [m.Label for m in known]
        names = [""] + [m.Name for m in known]
        box = widgets.choice(names, now.Name if now is not None else "", labels)
        box.setObjectName("SweptVolumeSequenceMotion{}".format(row))
        box.currentIndexChanged.connect(lambda *ignored: self._chosen(row, box.currentData()))
        return box

    def _chosen(self, row, name):
        self.motions[row] = self.document.getObject(name) if name else None
        self.set_state(row, "")
        self.changed.emit()

    def set_state(self, row, text):
        self.states[row] = text
        self._write(row, 2, text)

    def add_selected(self):
        new = [pair for pair in selection.parts() if pair not in self.pairs]
        count = len(new)
        self.show_rows(self.pairs + new, self.motions + [None] * count, self.states + [""] * count)
        self.changed.emit()

    def remove(self):
        row = self.table.currentRow()
        if 0 <= row < len(self.pairs):
            for column in (self.pairs, self.motions, self.states):
                del column[row]
            self.show_rows(self.pairs, self.motions, self.states)
            self.changed.emit()

    def move(self, by):
        """Moves the selected part one step earlier (-1) or later (1)."""
        row = self.table.currentRow()
        if row < 0 or not 0 <= row + by < len(self.pairs):
            return
        for column in (self.pairs, self.motions, self.states):
            column[row], column[row + by] = column[row + by], column[row]
        self.show_rows(self.pairs, self.motions, [""] * len(self.pairs))
        self.table.selectRow(row + by)
        self.changed.emit()
