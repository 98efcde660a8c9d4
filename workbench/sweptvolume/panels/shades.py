# SPDX-License-Identifier: LGPL-2.1-or-later
"""Text colours that are legible on their background in every theme."""
from PySide import QtCore, QtGui

from .widgets import QtWidgets


def luminance(colour):
    """Returns the relative luminance of a QColor, 0 (black) to 1 (WCAG 2.1)."""
    parts = (colour.redF(), colour.greenF(), colour.blueF())
    linear = [p / 12.92 if p <= 0.04045 else ((p + 0.055) / 1.055) ** 2.4 for p in parts]
    return 0.2126 * linear[0] + 0.7152 * linear[1] + 0.0722 * linear[2]


def contrast(one, other):
    """Returns the contrast of two QColors, 1 to 21 (WCAG 2.1 requires 4.5 for text)."""
    low, high = sorted((luminance(one), luminance(other)))
    return (high + 0.05) / (low + 0.05)


def ink_on(colour):
    """Returns black or white (QColor), whichever is more legible on a QColor."""
    return max((QtGui.QColor("black"), QtGui.QColor("white")), key=lambda c: contrast(c, colour))


def alarm(widget):
    """Returns the name of a red for text in a widget of a panel. It is lighter in a dark theme,
    where the panel's texts are light."""
    ink = widget.parentWidget().palette().color(QtGui.QPalette.WindowText)
    return "#ff7d7d" if luminance(ink) > 0.5 else "#d01020"


class ShadedCells(QtWidgets.QStyledItemDelegate):
    """Paints cells that have their own background. The style sheets of FreeCAD 1.0's themes give
    all cells the same text colour and ignore the colour of the cell, so these cells are painted
    here.
    """

    def paint(self, painter, option, index):
        behind = index.data(QtCore.Qt.BackgroundRole)
        if behind is None:
            super().paint(painter, option, index)
            return
        margin = option.fontMetrics.averageCharWidth() // 2
        painter.save()
        painter.fillRect(option.rect, behind)
        painter.setFont(option.font)
        painter.setPen(ink_on(QtGui.QBrush(behind).color()))
        painter.drawText(
            option.rect.adjusted(margin, 0, -margin, 0),
            QtCore.Qt.AlignVCenter | QtCore.Qt.TextWordWrap,
            index.data(QtCore.Qt.DisplayRole),
        )
        painter.restore()
