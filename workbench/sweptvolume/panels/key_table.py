# SPDX-License-Identifier: LGPL-2.1-or-later
"""Table of key placements, with its buttons and keyboard shortcuts. The panel carries out the
actions."""
from PySide import QtCore

from ..quantities import length_unit
from ..texts import QT_TRANSLATE_NOOP, translate
from ..trajectory.edit import rows_from
from . import widgets
from .widgets import QtWidgets

COLUMNS = ["t", "x", "y", "z"]
ANGLES = [
    QT_TRANSLATE_NOOP("SweptVolume", "yaw"),
    QT_TRANSLATE_NOOP("SweptVolume", "pitch"),
    QT_TRANSLATE_NOOP("SweptVolume", "roll"),
]
#: (key, with Ctrl) -> name of an action.
KEYS = {
    (QtCore.Qt.Key_Insert, False): "Insert",
    (QtCore.Qt.Key_Delete, False): "Delete",
    (QtCore.Qt.Key_Up, True): "Up",
    (QtCore.Qt.Key_Down, True): "Down",
    (QtCore.Qt.Key_D, True): "Duplicate",
    (QtCore.Qt.Key_Return, True): "Capture",
    (QtCore.Qt.Key_V, True): "Paste",
    (QtCore.Qt.Key_C, True): "Copy",
}
_ENTER = QtCore.Qt.Key_Return, QtCore.Qt.Key_Enter
#: First characters of a number.
_NUMBERS = set("0123456789+-.,")


def actions():
    """Returns (name, text, tool tip) of each button, in order."""

    return [
        (
            "Capture",
            translate("SweptVolume", "&Capture"),
            translate(
                "SweptVolume", "Adds the current placement of the part as a key (Ctrl+Return)"
            ),
        ),
        (
            "Update",
            translate("SweptVolume", "&Update"),
            translate(
                "SweptVolume",
                "Replaces the placement of this key with the current placement of the part",
            ),
        ),
        (
            "Insert",
            translate("SweptVolume", "&Insert"),
            translate("SweptVolume", "Adds a key halfway to the next one (Insert)"),
        ),
        (
            "Duplicate",
            translate("SweptVolume", "&Duplicate"),
            translate("SweptVolume", "Adds the same placement again (Ctrl+D)"),
        ),
        (
            "Delete",
            translate("SweptVolume", "De&lete"),
            translate("SweptVolume", "Removes the key (Delete)"),
        ),
        (
            "Reverse",
            translate("SweptVolume", "&Reverse"),
            translate(
                "SweptVolume",
                "Reverses the order of the keys. The time between neighbouring keys stays the same",
            ),
        ),
        (
            "Up",
            translate("SweptVolume", "Up"),
            translate("SweptVolume", "Moves the key one place earlier (Ctrl+Up)"),
        ),
        (
            "Down",
            translate("SweptVolume", "Down"),
            translate("SweptVolume", "Moves the key one place later (Ctrl+Down)"),
        ),
        (
            "Even",
            translate("SweptVolume", "Eve&n times"),
            translate("SweptVolume", "Sets the times one second apart"),
        ),
    ]


def short(number):
    """Formats a number for a narrow column. The tool tip and the key have all digits."""
    digits = max(0, 4 - len(str(int(abs(number)))) - (number < 0))
    return "{:g}".format(round(number, digits) + 0.0)


def units():
    """Returns (name, size of the unit in s, mm or degrees) of each column, from FreeCAD's
    preferences."""
    one, name = length_unit()
    return [("s", 1.0)] + [(name, one)] * 3 + [("deg", 1.0)] * 3


class KeyTable(QtCore.QObject):
    """Signals: `wanted(name)`: an action was requested; `typed(row, column, text)`: a cell was
    edited; `chosen(row)`: another key became the current one."""

    wanted = QtCore.Signal(str)
    typed = QtCore.Signal(int, int, str)
    chosen = QtCore.Signal(int)

    def __init__(self, rows):
        super().__init__()
        self.filling = False
        self.units = units()
        self.table = QtWidgets.QTableWidget(0, len(self.units))
        self.table.setObjectName("SweptVolumeKeys")
        angles = [translate("SweptVolume", name) for name in ANGLES]
        heads = zip(COLUMNS + angles, self.units)
        self.table.setHorizontalHeaderLabels(["{}\n{}".format(n, unit) for n, (unit, _) in heads])
        self.table.setSelectionBehavior(QtWidgets.QAbstractItemView.SelectRows)
        self.table.setMinimumHeight(150)
        self.table.setTabKeyNavigation(
            False
        )  # Tab leaves the table, so that the panel works without a mouse
        modes = QtWidgets.QHeaderView
        for column in range(len(self.units)):  # headings of angles are long, their numbers short
            mode = modes.ResizeToContents if column >= len(COLUMNS) else modes.Stretch
            self.table.horizontalHeader().setSectionResizeMode(column, mode)
        self.table.verticalHeader().setDefaultSectionSize(self.table.fontMetrics().height() + 8)
        font = self.table.font()
        font.setPointSizeF(font.pointSizeF() * 0.9)
        self.table.setFont(font)
        self.table.itemChanged.connect(self._edited)
        self.table.currentCellChanged.connect(self._current)
        self.table.installEventFilter(self)
        rows.addRow(self.table)
        grid = QtWidgets.QGridLayout()
        grid.setSpacing(4)
        self.buttons = {}
        for i, (name, text, tip) in enumerate(actions()):
            button = QtWidgets.QPushButton(text)
            button.setObjectName("SweptVolume" + name)
            button.setToolTip(tip)
            button.clicked.connect(lambda checked=False, name=name: self.wanted.emit(name))
            grid.addWidget(button, i // 3, i % 3)
            self.buttons[name] = button
        rows.addRow(grid)

    def row(self):
        return self.table.currentRow()

    def fill(self, keys, current):
        """Shows all keys and makes one of them current."""
        self.filling = True
        self.table.setRowCount(len(keys))
        for row in range(len(keys)):
            self._fill(keys, row)
        if len(keys):
            # Selects only this row. Without this flag, the view would extend the selection while
            # Ctrl is held.
            alone = QtCore.QItemSelectionModel.ClearAndSelect | QtCore.QItemSelectionModel.Rows
            self.table.setCurrentCell(max(0, min(current, len(keys) - 1)), 1, alone)
        self.filling = False

    def show_row(self, keys, row):
        """Shows one key that changed."""
        self.filling = True
        self._fill(keys, row)
        self.filling = False

    def _fill(self, keys, row):
        right = QtCore.Qt.AlignRight | QtCore.Qt.AlignVCenter
        for column, number in enumerate((keys.times[row],) + keys.numbers(row)):
            unit, one = self.units[column]
            item = QtWidgets.QTableWidgetItem(short(number / one))
            item.setTextAlignment(widgets.number_of(right))
            item.setToolTip("{:.9g} {}".format(number / one, unit))
            self.table.setItem(row, column, item)

    def copy(self, keys):
        """Copies the chosen rows to the clipboard, as tab-separated text for spreadsheets."""
        lines = []
        for row in sorted({index.row() for index in self.table.selectedIndexes()}):
            numbers = (keys.times[row],) + keys.numbers(row)
            lines.append(
                "\t".join("{:.9g}".format(n / one) for n, (_, one) in zip(numbers, self.units))
            )
        QtWidgets.QApplication.clipboard().setText("\n".join(lines))

    def pasted(self):
        """Returns the rows of numbers (s, mm, degrees) on the clipboard. Raises InputProblem."""
        return rows_from(QtWidgets.QApplication.clipboard().text(), self.units)

    def _edited(self, item):
        if not self.filling:
            self.typed.emit(item.row(), item.column(), item.text())

    def _current(self, row, *ignored):
        if not self.filling and row >= 0:
            self.chosen.emit(row)

    def eventFilter(self, watched, event):  # noqa: N802
        """Handles keys for the table before FreeCAD's shortcuts, which belong to the whole window
        (keyboard.py tests this)."""
        if event.type() not in (QtCore.QEvent.ShortcutOverride, QtCore.QEvent.KeyPress):
            return super().eventFilter(watched, event)
        pressed = event.type() == QtCore.QEvent.KeyPress
        if self.table.state() == QtWidgets.QTableWidget.EditingState:
            # Enter ends the typing. Without this, it would also press the panel's OK.
            return pressed and event.key() in _ENTER
        control = bool(event.modifiers() & QtCore.Qt.ControlModifier)
        name = KEYS.get((event.key(), control))
        if name and pressed:
            self.wanted.emit(name)
        if name or not pressed and event.text() in _NUMBERS:
            event.accept()  # a digit starts typing; FreeCAD would turn the view
            return True
        return super().eventFilter(watched, event)


def add_to(layout, part, source=""):
    """Adds the table in a box with a title, below the names of the part and of the source of the
    keys."""
    rows = widgets.group(translate("SweptVolume", "Key placements"), layout)
    button = QtWidgets.QPushButton(translate("SweptVolume", "&Pick"))
    button.setObjectName("SweptVolumeChoosePart")
    button.setToolTip(
        translate("SweptVolume", "Takes the part that is selected in the tree or in the 3D view")
    )
    line = QtWidgets.QHBoxLayout()
    line.addWidget(_name(part), 1)
    line.addWidget(button)
    rows.addRow(translate("SweptVolume", "Part"), line)
    if source:
        rows.addRow(translate("SweptVolume", "Source"), _name(source))
    table = KeyTable(rows)
    table.part = button
    # The button of the part comes last in the tab order, so the list of keys is the first field.
    QtWidgets.QWidget.setTabOrder(list(table.buttons.values())[-1], button)
    return table


def _name(text):
    label = QtWidgets.QLabel(text)
    label.setWordWrap(True)
    return label
