# SPDX-License-Identifier: LGPL-2.1-or-later
"""Graph of distance over time, with one line for each neighbour and lines for the required
distances. The scale is asinh, as in the report: linear near 0 and logarithmic above, so that 5 mm
and 365 mm are both visible. Pointing at a line shows its name; a click on a line chooses its
row."""
import numpy as np
from PySide import QtCore, QtGui

from ..features import clearance_table, neighbour_rules
from ..quantities import TABLE_DIGITS, length_unit, number
from ..texts import translate
from .widgets import QtWidgets

COLOURS = ("#1f77b4", "#d95f02", "#2ca02c", "#9467bd", "#8c564b", "#17becf", "#7f7f7f", "#bcbd22")
#: Colour of all further lines; their names are not listed at the side.
OTHERS = "#609a9a9a"
LEFT, RIGHT, TOP, BOTTOM = 46, 8, 8, 30
#: The scale changes from linear to logarithmic at the smallest required distance divided by BEND.
#: Without a required distance, it changes at the largest distance divided by LINEAR_PART. ABOVE: how far
#: the scale extends beyond required distances, as a factor.
BEND, LINEAR_PART, ABOVE = 1.5, 20.0, 1.2
#: In pixels: least distance between two numbers of the scale; largest distance at which the mouse
#: points at a line.
TICK_GAP, NEAR = 15, 7


class Scale:
    """Maps distances (in the unit of the preferences) to positions: 0 for distance 0, 1 for
    `most`."""

    def __init__(self, most, required):
        self.most = max([most, 1e-3] + [ABOVE * value for value in required])
        self.bend = min(required) / BEND if required else self.most / LINEAR_PART

    def position(self, distance):
        """Returns the position on the scale for a number or an array."""
        return np.arcsinh(np.asarray(distance) / self.bend) / np.arcsinh(self.most / self.bend)

    def ticks(self, gap):
        """Returns round numbers from 0 whose positions differ by at least `gap` (as a fraction of
        the scale)."""
        found, last = [0.0], 0.0
        for decade in range(-4, 10):
            for step in (1, 2, 5):
                value = step * 10.0**decade
                place = float(self.position(value))
                if value <= self.most and place - last >= gap:
                    found.append(value)
                    last = place
        return found


class DistanceGraph(QtWidgets.QWidget):
    """Draws curves [(name, times, distances)...]; times and distances are arrays. The chosen curve
    is thick. `picked(index)`: the user clicked a curve."""

    picked = QtCore.Signal(int)

    def __init__(self):
        super().__init__()
        self.setObjectName("SweptVolumeDistanceGraph")
        self.setMinimumHeight(150)
        self.setMouseTracking(True)
        self.curves, self.order, self.required = [], [], []
        self.chosen, self.moment = -1, None
        self.pointed, self.picture, self.ends = -1, None, None

    def show_report(self, report):
        one, self.unit = length_unit()
        curves = []
        for row in report["neighbours"]:
            points = np.array(row["curve"], dtype=float).reshape(-1, 2)
            curves.append((row["name"], points[:, 0], points[:, 1] / one))
        self.curves = curves
        rules = [clearance_table.rule_of(row, report) for row in report["neighbours"]]
        required = {length for kind, length in rules if kind == neighbour_rules.REQUIRED}
        self.required = sorted(length / one for length in required if length > 0)
        order = [k for k, (_, times, _) in enumerate(curves) if len(times)]
        self.order = sorted(order, key=lambda k: curves[k][2].min())  # the nearest first
        self.chosen, self.moment, self.pointed = -1, None, -1
        self._renew()

    def choose(self, index, moment):
        """Draws one curve thick and marks a time."""
        if index != self.chosen:
            self.chosen = index
            self._renew()
        self.mark(moment)

    def mark(self, moment):
        """Marks a time (s); None: no time."""
        self.moment = moment
        self.update()

    def _renew(self):
        self.picture, self.ends = None, None
        self.update()

    def colour(self, index):
        """Returns the colour of a curve."""
        place = self.order.index(index)
        return COLOURS[place] if place < len(COLOURS) else OTHERS

    # --- positions

    def _box(self):
        return QtCore.QRectF(LEFT, TOP, self.width() - LEFT - RIGHT, self.height() - TOP - BOTTOM)

    def _measure(self):
        self.start = min(float(self.curves[k][1].min()) for k in self.order)
        self.end = max(float(self.curves[k][1].max()) for k in self.order)
        most = max(float(self.curves[k][2].max()) for k in self.order)
        self.scale = Scale(most, self.required)

    def x_of(self, times):
        """Returns the x coordinates (pixels) for a time or an array of times."""
        box, span = self._box(), self.end - self.start
        part = (np.asarray(times) - self.start) / span if span > 0 else 0.5 + 0 * np.asarray(times)
        return box.left() + box.width() * part

    def y_of(self, distances):
        box = self._box()
        return box.bottom() - box.height() * self.scale.position(distances)

    def _polygon(self, index):
        _, times, distances = self.curves[index]
        places = zip(self.x_of(times).tolist(), self.y_of(distances).tolist())
        return QtGui.QPolygonF([QtCore.QPointF(*place) for place in places])

    # --- painting

    def paintEvent(self, event):  # noqa: N802
        painter = QtGui.QPainter(self)
        if not self.order:
            painter.setPen(self._ink())
            text = translate("SweptVolume", "There is no graph yet: run the check first.")
            painter.drawText(self.rect(), QtCore.Qt.AlignCenter, text)
            painter.end()
            return
        self._measure()
        if self.picture is None or self.picture.size() / self._ratio() != self.size():
            self._draw_picture()
        painter.drawPixmap(0, 0, self.picture)
        painter.setRenderHint(QtGui.QPainter.Antialiasing)
        if self.pointed >= 0:
            painter.setPen(QtGui.QPen(QtGui.QColor(self.colour(self.pointed)), 3.0))
            painter.drawPolyline(self._polygon(self.pointed))
        if self.moment is not None:
            box, x = self._box(), float(self.x_of(self.moment))
            painter.setPen(QtGui.QPen(QtGui.QColor("#d8009a"), 1.2, QtCore.Qt.DashLine))
            painter.drawLine(QtCore.QPointF(x, box.top()), QtCore.QPointF(x, box.bottom()))
        painter.end()

    def _ratio(self):
        return self.devicePixelRatioF()

    def _draw_picture(self):
        """Draws everything that does not depend on the mouse; hundreds of curves take some time."""
        self.picture = QtGui.QPixmap(self.size() * self._ratio())
        self.picture.setDevicePixelRatio(self._ratio())
        self.picture.fill(QtCore.Qt.transparent)
        painter = QtGui.QPainter(self.picture)
        painter.setFont(self.font())
        painter.setRenderHint(QtGui.QPainter.Antialiasing)
        self._axes(painter)
        for index in reversed(self.order):
            if index != self.chosen:
                painter.setPen(QtGui.QPen(QtGui.QColor(self.colour(index)), 1.3))
                painter.drawPolyline(self._polygon(index))
        if self.chosen in self.order:
            painter.setPen(QtGui.QPen(QtGui.QColor(self.colour(self.chosen)), 3.0))
            painter.drawPolyline(self._polygon(self.chosen))
        self._names(painter)
        painter.end()

    def _ink(self):
        """Returns the text colour of the panel. No background is drawn, because a style sheet may
        give a panel other colours than its palette."""
        return self.palette().color(QtGui.QPalette.WindowText)

    def _axes(self, painter):
        box = self._box()
        painter.setPen(QtGui.QPen(QtGui.QColor("#888a85"), 1))
        painter.drawRect(box)
        faint = QtGui.QPen(QtGui.QColor(136, 138, 133, 70), 1)
        for distance in self.scale.ticks(TICK_GAP / max(box.height(), 1.0)):
            y = float(self.y_of(distance))
            painter.setPen(faint)
            painter.drawLine(QtCore.QPointF(box.left(), y), QtCore.QPointF(box.right(), y))
            painter.setPen(self._ink())
            painter.drawText(
                QtCore.QRectF(0, y - 8, LEFT - 4, 16),
                QtCore.Qt.AlignRight | QtCore.Qt.AlignVCenter,
                number(distance, 4),
            )
        for k in range(5):
            t = self.start + (self.end - self.start) * k / 4.0
            painter.drawText(
                QtCore.QRectF(min(self.x_of(t) - 30, box.right() - 52), box.bottom() + 1, 60, 14),
                QtCore.Qt.AlignCenter,
                number(t, 3),
            )
        painter.drawText(
            QtCore.QRectF(box.left(), box.bottom() + 14, box.width(), 16),
            QtCore.Qt.AlignCenter,
            translate("SweptVolume", "distance ({0}) over time (s)").format(self.unit),
        )
        painter.setPen(QtGui.QPen(QtGui.QColor("#cc0000"), 1.2, QtCore.Qt.DotLine))
        for distance in self.required:
            y = float(self.y_of(distance))
            painter.drawLine(QtCore.QPointF(box.left(), y), QtCore.QPointF(box.right(), y))

    def _names(self, painter):
        box, light = self._box(), self._ink().lightness() > 127
        behind_names = QtGui.QColor(40, 40, 40, 200) if light else QtGui.QColor(255, 255, 255, 200)
        for k, index in enumerate(self.order[: len(COLOURS)]):
            painter.setPen(QtGui.QColor(COLOURS[k]))
            text = painter.fontMetrics().elidedText(
                self.curves[index][0], QtCore.Qt.ElideRight, int(box.width() / 2)
            )
            where = QtCore.QRectF(box.left(), box.top() + 2 + 13 * k, box.width() - 6, 14)
            behind = painter.boundingRect(where, QtCore.Qt.AlignRight, text)
            painter.fillRect(behind, behind_names)
            painter.drawText(where, QtCore.Qt.AlignRight, text)

    # --- pointing

    def _segments(self):
        """Returns (first ends (k,2), second ends, index of the curve (k,)) in pixels. A curve with
        a single point gives a segment of length 0."""
        if self.ends is None:
            parts = []
            for index in self.order:
                _, times, distances = self.curves[index]
                places = np.column_stack([self.x_of(times), self.y_of(distances)])
                first, second = (places[:-1], places[1:]) if len(places) > 1 else (places, places)
                parts.append((first, second, np.full(len(first), index)))
            self.ends = tuple(np.concatenate(group) for group in zip(*parts))
        return self.ends

    def curve_at(self, x, y):
        """Returns the index of the curve at which the mouse points, or -1."""
        if not self.order:
            return -1
        self._measure()
        first, second, of = self._segments()
        along, to = second - first, np.array([x, y]) - first
        squared = np.maximum((along**2).sum(axis=1), 1e-12)
        part = np.clip((along * to).sum(axis=1) / squared, 0.0, 1.0)
        off = np.linalg.norm(to - part[:, None] * along, axis=1)
        nearest = int(off.argmin())
        return int(of[nearest]) if off[nearest] <= NEAR else -1

    def text_at(self, index, x):
        """Returns the text about a curve at the mouse: name, distance and time."""
        name, times, distances = self.curves[index]
        box = self._box()
        part = min(max((x - box.left()) / max(box.width(), 1.0), 0.0), 1.0)
        time = self.start + part * (self.end - self.start)
        distance = float(np.interp(time, times, distances))
        text = translate("SweptVolume", "{0}: {1} {2} at {3} s")
        return text.format(name, number(distance, TABLE_DIGITS), self.unit, number(time, 3))

    def mouseMoveEvent(self, event):  # noqa: N802
        where = event.pos()
        pointed = self.curve_at(where.x(), where.y())
        if pointed != self.pointed:
            self.pointed = pointed
            self.update()
        if pointed >= 0:
            QtWidgets.QToolTip.showText(
                self.mapToGlobal(where), self.text_at(pointed, where.x()), self
            )
        else:
            QtWidgets.QToolTip.hideText()

    def mousePressEvent(self, event):  # noqa: N802
        index = self.curve_at(event.pos().x(), event.pos().y())
        if index >= 0:
            self.picked.emit(index)

    def leaveEvent(self, event):  # noqa: N802
        self.pointed = -1
        self.update()

    def resizeEvent(self, event):  # noqa: N802
        self._renew()
