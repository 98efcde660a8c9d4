# SPDX-License-Identifier: LGPL-2.1-or-later
"""Choice of the pivot, the point that moves in a straight line between two keys: a row of the
motion editor."""
import FreeCAD as App
import FreeCADGui as Gui
from PySide import QtCore

from .. import convert, quantities
from ..convert import InputProblem
from ..texts import translate
from . import widgets
from .widgets import QtWidgets

#: Significant digits of a coordinate.
PLACE_DIGITS = 6

#: mm: a point this close to the middle of the part counts as the middle.
SAME = 1e-6


class PivotBox(QtWidgets.QWidget):
    """Origin of the poses, middle of the part, or a selected point. Signals: `changed()`: another
    point was chosen; `failed(text)`: no point could be taken."""

    changed = QtCore.Signal()
    failed = QtCore.Signal(str)

    def __init__(self, pair):
        super().__init__()
        self.pair, self.middle, self.point = pair, None, App.Vector()
        texts = {
            "Middle": translate("SweptVolume", "Middle of the part"),
            "Origin": translate("SweptVolume", "Origin of the poses"),
            "Point": translate("SweptVolume", "Selected point"),
        }
        self.kind = widgets.choice(list(texts), "Origin", list(texts.values()))
        self.kind.setObjectName("SweptVolumePivot")
        self.take = QtWidgets.QPushButton(translate("SweptVolume", "Ta&ke"))
        self.take.setObjectName("SweptVolumeTakePivot")
        self.take.setToolTip(
            translate(
                "SweptVolume",
                "Uses the selected vertex, or the centre of the selected edge or "
                "face, as the pivot",
            )
        )
        line = QtWidgets.QHBoxLayout(self)
        line.setContentsMargins(0, 0, 0, 0)
        line.addWidget(self.kind, 1)
        line.addWidget(self.take)
        self.kind.currentIndexChanged.connect(lambda *ignored: self._chosen())
        self.take.clicked.connect(lambda *ignored: self._take())
        self._explain()
        self.setEnabled(False)  # without a part there is no choice, so disabled until begin()

    def begin(self, middle, point):
        """Shows the pivot of a part. middle, point: in coordinates of the part (mm). point None:
        the origin of the poses."""
        self.middle = middle
        near = point is not None and (point - middle).Length <= SAME
        self.point = middle if point is None or near else point
        self._set("Origin" if point is None else "Middle" if near else "Point")
        self.setEnabled(True)

    def follow(self, kind, point):
        """Copies the choice of another box for the same part."""
        self.point = point
        self._set(kind)

    def show_fixed(self, pivot):
        """Shows the pivot of a motion without a part. The user cannot change it."""
        self._set("Point" if pivot.Length else "Origin")

    def in_part(self):
        """Returns the pivot in coordinates of the part (mm), or None for the origin of the poses."""
        return None if self.kind.currentData() == "Origin" else self.point

    def _set(self, kind):
        self.kind.blockSignals(True)
        self.kind.setCurrentIndex(self.kind.findData(kind))
        self.kind.blockSignals(False)
        self._explain()

    def _chosen(self):
        if self.kind.currentData() == "Middle" and self.middle is not None:
            self.point = self.middle
        self._explain()
        self.changed.emit()

    def _explain(self):
        text = translate(
            "SweptVolume",
            "Between two keys, the pivot follows the straight line (Linear) or the curve "
            "(Spline), and the part turns about it. The x, y and z of a key are the coordinates "
            "of the pivot, or its displacement if the pose type is Relative.",
        )
        if self.in_part() is not None:
            here = translate("SweptVolume", "In the coordinates of the part: {0}, {1}, {2}")
            text += "\n" + here.format(*(quantities.quantity(x, PLACE_DIGITS) for x in self.point))
        self.kind.setToolTip(text)

    def _take(self):
        try:
            world = selected_point()
        except InputProblem as problem:
            self.failed.emit(str(problem))
            return
        self.point = convert.global_placement(*self.pair).inverse().multVec(world)
        self._set("Point")
        self.changed.emit()


def selected_point():
    """Returns the point that was selected last, in world coordinates (mm). Raises InputProblem."""
    for item in reversed(Gui.Selection.getSelectionEx("", 0)):
        for sub in reversed(item.SubElementNames):
            shape = item.Object.getSubObject(sub) if sub and not sub.endswith(".") else None
            if getattr(shape, "ShapeType", "") in _POINTS:
                return App.Vector(_POINTS[shape.ShapeType](shape))
    raise InputProblem(
        translate(
            "SweptVolume",
            "Select a vertex, an edge or a face in the 3D view first. The vertex, or the centre "
            "of the edge or face, becomes the pivot.",
        )
    )


def _centre_of_edge(edge):
    """Returns the centre of a circle or ellipse, and the middle of any other edge."""
    try:
        return edge.Curve.Center
    except AttributeError:
        return edge.valueAt(edge.getParameterByLength(edge.Length / 2))


_POINTS = {
    "Vertex": lambda vertex: vertex.Point,
    "Edge": _centre_of_edge,
    "Face": lambda face: face.CenterOfMass,
}
