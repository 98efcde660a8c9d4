# SPDX-License-Identifier: LGPL-2.1-or-later
"""Table of neighbours with their rules. Each row has a length and a kind of rule, which the user
edits in the cells."""
from .. import convert, quantities
from ..convert import InputProblem
from ..features.neighbour_rules import CONTACT, IGNORE, KINDS, REQUIRED, Rule
from ..texts import QT_TRANSLATE_NOOP, translate
from ..trajectory.edit import number_from
from . import widgets
from .widgets import QtCore, QtGui, QtWidgets

NAMES = {
    REQUIRED: QT_TRANSLATE_NOOP("SweptVolume", "Distance"),
    CONTACT: QT_TRANSLATE_NOOP("SweptVolume", "Contact allowed"),
    IGNORE: QT_TRANSLATE_NOOP("SweptVolume", "Ignored"),
}
NEIGHBOUR, LENGTH, KIND = range(3)


def _name(kind):
    return translate("SweptVolume", NAMES[kind])


def _item(text, data):
    item = QtWidgets.QTableWidgetItem(text)
    item.setData(QtCore.Qt.UserRole, data)
    return item


def _state(item):
    """Returns the text and the data of a cell, so that another cell can get them."""
    return item.text(), item.data(QtCore.Qt.UserRole)


class _KindDelegate(QtWidgets.QStyledItemDelegate):
    """A combo box of kinds, created only while a cell is edited, so that tables of thousands of
    rows stay fast."""

    def __init__(self, kinds, parent):
        super().__init__(parent)
        self.kinds = kinds

    def createEditor(self, parent, option, index):  # noqa: N802
        box = QtWidgets.QComboBox(parent)
        for kind in self.kinds:
            box.addItem(_name(kind), kind)
        box.activated.connect(lambda *ignored: self.commitData.emit(box))
        return box

    def setEditorData(self, box, index):  # noqa: N802
        box.setCurrentIndex(max(0, box.findData(index.data(QtCore.Qt.UserRole))))

    def setModelData(self, box, model, index):  # noqa: N802
        model.setData(index, box.currentData(), QtCore.Qt.UserRole)
        model.setData(index, box.currentText(), QtCore.Qt.EditRole)


class RulesTable(QtWidgets.QTableWidget):
    """kinds: the kinds of rules that can be chosen. head: title of the column of lengths, without
    the unit. label: function that returns the text for a row; title: title of the first column."""

    def __init__(self, name, head, kinds=KINDS, height=110, label=None, title=""):
        super().__init__(0, 3)
        self.label = label or (lambda pair: convert.label_of(*pair))
        self.setObjectName(name)
        self.pairs = []
        self.one, self.unit = quantities.length_unit()
        self.setHorizontalHeaderLabels(
            [
                title or translate("SweptVolume", "Neighbour"),
                "{} ({})".format(head, self.unit),
                translate("SweptVolume", "Rule"),
            ]
        )
        self.horizontalHeaderItem(LENGTH).setToolTip(
            translate(
                "SweptVolume",
                "Required distance for this row (empty: the value of Required distance below). "
                "If contact is allowed: how deep the parts may overlap (empty: no deeper than the "
                "accuracy plus the mesh deflections of both parts)",
            )
            if CONTACT in kinds
            else translate(
                "SweptVolume",
                "Required distance for this row (empty: the value of Required distance below)",
            )
        )
        self.horizontalHeaderItem(KIND).setToolTip(
            translate("SweptVolume", "Double-click a cell, or press F2, to choose another rule")
        )
        self._delegate = _KindDelegate(kinds, self)
        self.setItemDelegateForColumn(KIND, self._delegate)
        self.setFixedHeight(height)
        self.verticalHeader().hide()
        self.setTabKeyNavigation(False)
        self.setSelectionBehavior(QtWidgets.QAbstractItemView.SelectRows)
        modes = QtWidgets.QHeaderView
        for column in (NEIGHBOUR, LENGTH, KIND):
            self.horizontalHeader().setSectionResizeMode(
                column, modes.ResizeToContents if column else modes.Stretch
            )

    def show_pairs(self, pairs, rules=None):
        """Shows these rows. Rows that were shown before keep their rules. rules: {pair: Rule} to
        show instead."""
        given = {
            pair: [self.item(row, column) for column in (LENGTH, KIND)]
            for row, pair in enumerate(self.pairs)
        }
        given = {pair: [_state(item) for item in items] for pair, items in given.items()}
        for pair, rule in (rules or {}).items():
            text = self._length_text(rule)
            given[pair] = [(text, (text, rule.length)), (_name(rule.kind), rule.kind)]
        self.pairs = list(pairs)
        self.setRowCount(len(self.pairs))
        for row, pair in enumerate(self.pairs):
            length_state, kind_state = given.get(pair, [("", None), (_name(REQUIRED), REQUIRED)])
            name = QtWidgets.QTableWidgetItem(self.label(pair))
            name.setFlags(QtCore.Qt.ItemIsEnabled | QtCore.Qt.ItemIsSelectable)
            name.setToolTip(name.text())
            length = _item(*length_state)
            length.setTextAlignment(
                widgets.number_of(QtCore.Qt.AlignRight | QtCore.Qt.AlignVCenter)
            )
            choice = _item(*kind_state)
            for column, item in ((NEIGHBOUR, name), (LENGTH, length), (KIND, choice)):
                self.setItem(row, column, item)
        if len(self.pairs) <= 200:  # each row is measured, which is slow for many rows
            self.resizeRowsToContents()

    def _length_text(self, rule):
        if rule.length is None:
            return ""
        return quantities.number(rule.length / self.one, quantities.TABLE_DIGITS)

    def rules(self):
        """Returns {pair: Rule} for the rows with their own rule. Raises InputProblem."""
        found = {}
        for row, pair in enumerate(self.pairs):
            text = self.item(row, LENGTH).text().strip()
            rule = Rule(self.item(row, KIND).data(QtCore.Qt.UserRole))
            if text and rule.kind != IGNORE:
                shown = self.item(row, LENGTH).data(QtCore.Qt.UserRole)
                # The text was not edited, so the length keeps all its digits.
                if shown and shown[0] == text:
                    rule.length = shown[1]
                else:
                    rule.length = number_from(text, self.unit) * self.one
                if rule.length < 0:
                    self.setCurrentCell(row, LENGTH)
                    raise InputProblem(
                        translate(
                            "SweptVolume",
                            'The distance in the rule of "{0}" is {1}: enter 0 or more.',
                        ).format(self.label(pair), text)
                    )
            if rule.asks():
                found[pair] = rule
        return found

    def mark(self, names):
        """Writes the names of these neighbours in bold, because they are obstacles."""
        for row in range(self.rowCount()):
            item = self.item(row, NEIGHBOUR)
            font = QtGui.QFont(self.font())
            font.setBold(item.text() in names)
            item.setFont(font)
