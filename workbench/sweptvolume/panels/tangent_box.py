# SPDX-License-Identifier: LGPL-2.1-or-later
"""The tangent of one key of a spline motion: its kind and velocity."""
import FreeCAD as App
from PySide import QtCore

from ..texts import translate
from ..trajectory.spline import TANGENTS
from . import widgets
from .widgets import QtWidgets


class TangentBox(QtWidgets.QGroupBox):
    """Signal `changed(kind, velocity)`: the user chose another tangent for the key shown."""

    changed = QtCore.Signal(str, object)

    def __init__(self):
        super().__init__(translate("SweptVolume", "Tangent at the key"))
        texts = {
            "Auto": translate("SweptVolume", "Automatic"),
            "Stop": translate("SweptVolume", "Stop"),
            "Corner": translate("SweptVolume", "Corner"),
            "Given": translate("SweptVolume", "Given velocity"),
        }
        self.kind = widgets.choice(TANGENTS, "Auto", [texts[k] for k in TANGENTS])
        self.kind.setObjectName("SweptVolumeTangent")
        self.kind.setToolTip(
            translate(
                "SweptVolume",
                "Automatic: from the keys before and after. Stop: the part comes to "
                "rest. Corner: arrives in the direction from the previous key, leaves in the "
                "direction to the next key. Given velocity: as entered below",
            )
        )
        self.speeds = [QtWidgets.QDoubleSpinBox() for _ in range(3)]
        line = QtWidgets.QHBoxLayout()
        for axis, field in zip("xyz", self.speeds):
            field.setRange(-1e6, 1e6)
            field.setDecimals(2)
            field.setObjectName("SweptVolumeSpeed" + axis)
            field.setToolTip(translate("SweptVolume", "Velocity along {0} (mm/s)").format(axis))
            field.setButtonSymbols(QtWidgets.QAbstractSpinBox.NoButtons)
            field.setMinimumWidth(40)
            line.addWidget(field)
            field.valueChanged.connect(self._emit)
        self.unit = QtWidgets.QLabel("mm/s")
        line.addWidget(self.unit)
        column = QtWidgets.QVBoxLayout(self)
        column.setContentsMargins(*widgets.MARGINS)
        column.addWidget(self.kind)
        column.addLayout(line)
        self.kind.currentIndexChanged.connect(self._emit)
        self.showing = False
        self._enable()

    def show_tangent(self, kind, velocity):
        """Shows a key's tangent. velocity: the present one (mm/s), whatever its kind."""
        self.showing = True
        self.kind.setCurrentIndex(TANGENTS.index(kind))
        for field, value in zip(self.speeds, velocity):
            field.setValue(value)
        self._enable()
        self.showing = False

    def _enable(self):
        for field in self.speeds:
            field.setEnabled(self.kind.currentData() == "Given")

    def _emit(self, *ignored):
        self._enable()
        if not self.showing:
            velocity = App.Vector(*[field.value() for field in self.speeds])
            self.changed.emit(self.kind.currentData(), velocity)
