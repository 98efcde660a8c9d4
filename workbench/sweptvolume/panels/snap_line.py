# SPDX-License-Identifier: LGPL-2.1-or-later
"""The increments when a key is dragged in the 3D view, and the button that rounds a key to them."""
from PySide import QtCore

from ..texts import translate
from . import widgets
from .widgets import QtWidgets


class SnapLine(QtWidgets.QHBoxLayout):
    """Two fields, `length` (mm) and `angle` (degrees), and a button. Signals: changed (after a change
    of a field), rounding (the button was pressed)."""

    changed = QtCore.Signal()
    rounding = QtCore.Signal()

    def __init__(self):
        super().__init__()
        self.length = widgets.length(1.0, 0.0, 1.0)
        self.angle = widgets.angle(5.0, 0.0, 5.0)
        tip = translate(
            "SweptVolume",
            "Increment when you drag an arrow (mm) or an arc (degrees) in the 3D view. 0: no "
            "increments",
        )
        for field in (self.length, self.angle):
            field.setToolTip(tip)
            field.setMinimumWidth(82)
            self.addWidget(field, 1)
            field.valueChanged.connect(lambda *ignored: self.changed.emit())
        button = QtWidgets.QPushButton(translate("SweptVolume", "R&ound"))
        button.setObjectName("SweptVolumeRound")
        button.setToolTip(
            translate(
                "SweptVolume",
                "Rounds the placement of the chosen key to multiples of these increments",
            )
        )
        button.clicked.connect(lambda *ignored: self.rounding.emit())
        self.addWidget(button)
