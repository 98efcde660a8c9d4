# SPDX-License-Identifier: LGPL-2.1-or-later
"""Graph of distance over time, one line a neighbour, with the required distance."""
from PySide import QtCore, QtGui

from ..quantities import length_unit, number
from ..texts import translate
from .widgets import QtWidgets

COLOURS = ("#1f77b4", "#d95f02", "#2ca02c", "#9467bd", "#8c564b", "#17becf", "#7f7f7f", "#bcbd22")
#: More lines than this and only the nearest are drawn.
MOST_LINES = 8
LEFT, RIGHT, TOP, BOTTOM = 46, 8, 8, 30


class DistanceGraph(QtWidgets.QWidget):
    """Draws curves [(name, [(t, mm)...])]; the chosen one is thick."""

    def __init__(self):
        super().__init__()
        self.setObjectName("SweptVolumeDistanceGraph")
        self.setMinimumHeight(150)
        self.curves, self.required, self.chosen, self.moment = [], 0.0, -1, None

    def show_report(self, report):
        one, self.unit = length_unit()
        self.curves = [
            (row["name"], [(t, d / one) for t, d in row["curve"]]) for row in report["neighbours"]
        ]
        self.required = report["required"] / one
        self.chosen, self.moment = -1, None
        self.update()

    def choose(self, index, moment):
        """Makes one curve thick and marks a time."""
        self.chosen, self.moment = index, moment
        self.update()

    def _drawn(self):
        order = sorted(
            (i for i, (_, curve) in enumerate(self.curves) if curve),
            key=lambda i: min(d for _, d in self.curves[i][1]),
        )[:MOST_LINES]
        if 0 <= self.chosen < len(self.curves) and self.chosen not in order:
            order.append(self.chosen)
        return order

    def _limits(self, order):
        times = [t for i in order for t, _ in self.curves[i][1]]
        most = max((d for i in order for _, d in self.curves[i][1]), default=1.0)
        return min(times), max(times), max(most, self.required * 1.2, 1e-9) * 1.05

    def paintEvent(self, event):  # noqa: N802
        painter = QtGui.QPainter(self)
        painter.setRenderHint(QtGui.QPainter.Antialiasing)
        painter.setPen(self._ink())
        order = self._drawn()
        if not order:
            text = translate("Panels", "No curve yet: check first.")
            painter.drawText(self.rect(), QtCore.Qt.AlignCenter, text)
            painter.end()
            return
        start, end, most = self._limits(order)
        box = QtCore.QRectF(LEFT, TOP, self.width() - LEFT - RIGHT, self.height() - TOP - BOTTOM)

        def at(t, d):
            x = box.left() + box.width() * ((t - start) / (end - start) if end > start else 0.5)
            return QtCore.QPointF(x, box.bottom() - box.height() * d / most)

        self._axes(painter, box, start, end, most, at)
        for k, i in enumerate(order):
            pen = QtGui.QPen(
                QtGui.QColor(COLOURS[k % len(COLOURS)]), 3.0 if i == self.chosen else 1.3
            )
            painter.setPen(pen)
            painter.drawPolyline(QtGui.QPolygonF([at(t, d) for t, d in self.curves[i][1]]))
        if self.moment is not None:
            painter.setPen(QtGui.QPen(QtGui.QColor("#d8009a"), 1.2, QtCore.Qt.DashLine))
            painter.drawLine(at(self.moment, 0), at(self.moment, most))
        self._names(painter, box, order)
        painter.end()

    def _ink(self):
        """The colour of the panel's own texts. What lies behind is left as it is: a style sheet may give a
        panel other colours than its palette has."""
        return self.palette().color(QtGui.QPalette.WindowText)

    def _axes(self, painter, box, start, end, most, at):
        painter.setPen(QtGui.QPen(QtGui.QColor("#888a85"), 1))
        painter.drawRect(box)
        painter.setPen(self._ink())
        for k in range(5):
            d, t = most * k / 4.0, start + (end - start) * k / 4.0
            y, x = at(start, d).y(), at(t, 0).x()
            painter.drawText(
                QtCore.QRectF(0, y - 8, LEFT - 4, 16),
                QtCore.Qt.AlignRight | QtCore.Qt.AlignVCenter,
                number(d, 2),
            )
            painter.drawText(
                QtCore.QRectF(min(x - 30, box.right() - 52), box.bottom() + 1, 60, 14),
                QtCore.Qt.AlignCenter,
                number(t, 3),
            )
        painter.drawText(
            QtCore.QRectF(box.left(), box.bottom() + 14, box.width(), 16),
            QtCore.Qt.AlignCenter,
            translate("Panels", "distance ({0}) over time (s)").format(self.unit),
        )
        if self.required > 0:
            painter.setPen(QtGui.QPen(QtGui.QColor("#cc0000"), 1, QtCore.Qt.DotLine))
            painter.drawLine(at(start, self.required), at(end, self.required))

    def _names(self, painter, box, order):
        light = self._ink().lightness() > 127
        behind_names = QtGui.QColor(40, 40, 40, 200) if light else QtGui.QColor(255, 255, 255, 200)
        for k, i in enumerate(order):
            painter.setPen(QtGui.QColor(COLOURS[k % len(COLOURS)]))
            text = painter.fontMetrics().elidedText(
                self.curves[i][0], QtCore.Qt.ElideRight, int(box.width() / 2)
            )
            where = QtCore.QRectF(box.left(), box.top() + 2 + 13 * k, box.width() - 6, 14)
            behind = painter.boundingRect(where, QtCore.Qt.AlignRight, text)
            painter.fillRect(behind, behind_names)
            painter.drawText(where, QtCore.Qt.AlignRight, text)
