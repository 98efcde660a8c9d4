# SPDX-License-Identifier: LGPL-2.1-or-later
"""Start or goal of a part: a combo box, with the numbers that belong to the choice."""
import re

import FreeCAD as App
import FreeCADGui as Gui

from .. import quantities
from ..convert import InputProblem, global_placement, root_path
from ..texts import translate
from ..trajectory.edit import as_numbers, from_numbers, number_from
from . import selection, widgets
from .widgets import QtCore, QtWidgets

#: What the part does: Now (its present placement), Place (a given placement), Out (out by a
#: distance in mm), Along (out in a direction).
TEXTS = {
    "Now": lambda: translate("SweptVolume", "Current placement"),
    "Place": lambda: translate("SweptVolume", "Given placement"),
    "Out": lambda: translate("SweptVolume", "Out by a distance"),
    "Along": lambda: translate("SweptVolume", "Out in a direction"),
}


def numbers_from(text, units):
    """Reads numbers, with or without units, separated by blanks or semicolons. units: (name, size
    of the unit in mm or degrees) of each number. Raises InputProblem if their count differs."""
    parts = [part for part in re.split(r"\s*;\s*|\s+", text.strip()) if part]
    if len(parts) != len(units):
        raise InputProblem(
            translate("SweptVolume", '"{0}": enter {1} numbers, separated by spaces.').format(
                text, len(units)
            )
        )
    return [number_from(part, unit) * one for part, (unit, one) in zip(parts, units)]


class PlaceField(QtWidgets.QWidget):
    """A combo box of kinds, and the fields of the chosen kind below it. Signal `failed(text)`: the
    selection could not be used."""

    failed = QtCore.Signal(str)

    def __init__(self, name, kinds, part, distance=0.0):
        """part(): returns (root, sub) of the part, or None."""
        super().__init__()
        self.part = part
        one, unit = quantities.length_unit()
        self.units = [(unit, one)] * 3 + [("deg", 1.0)] * 3
        self.kind = widgets.choice(kinds, kinds[0], [TEXTS[kind]() for kind in kinds])
        self.kind.setObjectName(name + "Kind")
        self.numbers = QtWidgets.QLineEdit()
        self.numbers.setObjectName(name + "Numbers")
        self.take = QtWidgets.QPushButton(translate("SweptVolume", "Take"))
        self.take.setObjectName(name + "Take")
        self.distance = widgets.length(distance, 0.0, 10.0)
        self.distance.setObjectName(name + "Distance")
        column = QtWidgets.QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        line = QtWidgets.QHBoxLayout()
        line.addWidget(self.kind, 1)
        line.addWidget(self.take)
        column.addLayout(line)
        column.addWidget(self.numbers)
        column.addWidget(self.distance)
        self.kind.currentIndexChanged.connect(lambda *ignored: self._show())
        self.take.clicked.connect(lambda *ignored: self._take())
        self._show()

    def _show(self):
        kind = self.kind.currentData()
        self.numbers.setVisible(kind in ("Place", "Along"))
        self.distance.setVisible(kind == "Out")
        self.take.setVisible(kind in ("Place", "Along"))
        if kind == "Place":
            tip = translate(
                "SweptVolume",
                "x, y, z ({0}), yaw, pitch, roll (degrees) of the part in the "
                "document. The button Take enters the placement of the selected "
                "object, or of the part if nothing is selected",
            ).format(self.units[0][0])
        else:
            tip = translate(
                "SweptVolume",
                "Direction (x, y, z) in which the part leaves its installed position. The button "
                "Take enters the normal of the selected face, or the direction of the selected "
                "edge",
            )
        for field in (self.numbers, self.take):
            field.setToolTip(tip)

    def show_placement(self, placement):
        """Shows a placement in world coordinates."""
        self.kind.setCurrentIndex(self.kind.findData("Place"))
        self._write(as_numbers(placement), self.units)

    def _write(self, numbers, units):
        shown = (round(n / one, 6) + 0.0 for n, (_, one) in zip(numbers, units))
        self.numbers.setText(" ".join("{:.9g}".format(n) for n in shown))

    def _take(self):
        try:
            if self.kind.currentData() == "Along":
                self._write(selected_direction(), [("", 1.0)] * 3)
            else:
                self.show_placement(self._selected_place())
        except InputProblem as problem:
            self.failed.emit(str(problem))

    def _selected_place(self):
        pair = self.part()
        chosen = selection.placed()
        if chosen:
            return global_placement(*root_path(chosen[0]))
        if pair is None:
            raise InputProblem(
                translate("SweptVolume", "Select the moving part in the tree or in the 3D view.")
            )
        return global_placement(*pair)

    def placement(self):
        """Returns the placement, or None for another kind. Raises InputProblem."""
        if self.kind.currentData() != "Place":
            return None
        return from_numbers(numbers_from(self.numbers.text(), self.units))

    def extract(self):
        """Returns a distance (mm) or a direction, or None for another kind. Raises InputProblem."""
        kind = self.kind.currentData()
        if kind == "Out":
            return float(self.distance.property("rawValue"))
        if kind == "Along":
            return App.Vector(*numbers_from(self.numbers.text(), [("mm", 1.0)] * 3))
        return None


def selected_direction():
    """Returns the normal of the face, or the direction of the edge, that was selected last. Raises
    InputProblem."""
    for item in reversed(Gui.Selection.getSelectionEx("", 0)):
        for sub in reversed(item.SubElementNames):
            shape = item.Object.getSubObject(sub) if sub and not sub.endswith(".") else None
            kind = getattr(shape, "ShapeType", "")
            if kind == "Face":
                u0, u1, v0, v1 = shape.ParameterRange
                return tuple(shape.normalAt(0.5 * (u0 + u1), 0.5 * (v0 + v1)))
            if kind == "Edge":
                return tuple(shape.tangentAt(shape.FirstParameter))
    raise InputProblem(
        translate(
            "SweptVolume", "Select a face or an edge in the 3D view first, to set the direction."
        )
    )
