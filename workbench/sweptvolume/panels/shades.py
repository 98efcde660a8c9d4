# SPDX-License-Identifier: LGPL-2.1-or-later
"""Text that is seen on the colour behind it, whatever the theme."""
from PySide import QtCore, QtGui

from .widgets import QtWidgets


def luminance(colour):
    """Relative luminance of a QColor, 0 (black) to 1 (WCAG 2.1)."""
    parts = (colour.redF(), colour.greenF(), colour.blueF())
    linear = [p / 12.92 if p <= 0.04045 else ((p + 0.055) / 1.055) ** 2.4 for p in parts]
    return 0.2126 * linear[0] + 0.7152 * linear[1] + 0.0722 * linear[2]


def contrast(one, other):
    """Of two QColors, 1 to 21 (WCAG 2.1: text wants 4.5)."""
    low, high = sorted((luminance(one), luminance(other)))
    return (high + 0.05) / (low + 0.05)


def ink_on(colour):
    """Black or white (QColor): the one that is better read on a QColor."""
    return max((QtGui.QColor("black"), QtGui.QColor("white")), key=lambda c: contrast(c, colour))


def alarm(widget):
    """A red (its name) for text in a widget of a panel: light in a dark theme, which is known by the
    colour of the panel's texts."""
    ink = widget.parentWidget().palette().color(QtGui.QPalette.WindowText)
    return "#ff7d7d" if luminance(ink) > 0.5 else "#d01020"


class ShadedCells(QtWidgets.QStyledItemDelegate):
    """Cells with a background of their own. The style sheets of FreeCAD 1.0's themes give every cell their
    own colour of text and leave out the one that a cell asks for, so these cells are painted here.
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
