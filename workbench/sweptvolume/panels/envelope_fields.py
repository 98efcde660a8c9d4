# SPDX-License-Identifier: LGPL-2.1-or-later
"""The fields of the panel of an envelope: accuracy and method, and their values."""
from PySide import QtCore

from ..convert import InputProblem
from ..features.envelope_properties import BACKENDS, COMPONENTS, MADE_BY
from ..texts import translate
from . import widgets
from .widgets import QtWidgets

#: Largest number of cells that can be typed. The core reports its limit; a smaller limit of the
#: field would silently cut off digits.
MOST_TYPED = 999999999
#: Steps of the quality slider, in cells along the longest side.
QUALITIES = [32, 48, 64, 96, 128, 192, 256, 384, 512, 768, 1024]

DEFAULTS = {
    "Accuracy": 0.0,
    "Resolution": 128,
    "CellSize": 0.0,
    "MeshDeflection": 0.1,
    "Tolerance": 0.0,
    "Offset": 0.0,
    "Conservative": False,
    "KeepCavities": False,
    "PositionFilter": 0.0,
    "Components": "Consistent",
    "Backend": "Auto",
    "MadeBy": "Off",
}


class EnvelopeFields:
    """Base of the panel. The panel has the attribute `layout`, and _changed() is called after each
    change of a field."""

    def build_accuracy(self, values):
        rows = widgets.group(translate("SweptVolume", "Accuracy"), self.layout)
        given = [name for name in ("Accuracy", "CellSize") if values[name] > 0]
        self.by = widgets.choice(
            ["Accuracy", "Resolution", "CellSize"],
            (given + ["Resolution"])[0],
            [
                translate("SweptVolume", "Accuracy"),
                translate("SweptVolume", "Resolution"),
                translate("SweptVolume", "Cell size"),
            ],
        )
        self.accuracy = widgets.length(values["Accuracy"] or 1.0)
        self.accuracy.setObjectName("SweptVolumeAccuracy")
        widgets.hint(
            self.accuracy,
            translate(
                "SweptVolume",
                "Largest distance allowed between the computed surface and the true one. It sets "
                "the cell size and the tolerance",
            ),
        )
        self.resolution = QtWidgets.QSpinBox()
        self.resolution.setRange(0, MOST_TYPED)
        self.resolution.setSingleStep(16)
        self.resolution.setGroupSeparatorShown(True)
        self.resolution.setValue(values["Resolution"])
        self.resolution.setObjectName("SweptVolumeResolution")
        tip = translate(
            "SweptVolume",
            "Number of cells along the longest side of the box around the swept volume",
        )
        widgets.hint(self.resolution, tip)
        self.quality = QtWidgets.QSlider(QtCore.Qt.Horizontal)
        self.quality.setObjectName("SweptVolumeQuality")
        self.quality.setRange(0, len(QUALITIES) - 1)
        self.quality.setPageStep(1)
        self.quality.setTickPosition(QtWidgets.QSlider.TicksBelow)
        widgets.hint(
            self.quality,
            translate("SweptVolume", "Coarse and fast on the left, fine and slow on the right"),
        )
        self.cell = widgets.length(values["CellSize"] or 1.0)
        self.tolerance = widgets.length(values["Tolerance"])
        self.offset = widgets.length(values["Offset"])
        widgets.hint(
            self.tolerance,
            translate(
                "SweptVolume", "How far simplification may move the surface. 0: no simplification"
            ),
        )
        widgets.hint(
            self.offset,
            translate("SweptVolume", "Grows the envelope by this distance on all sides"),
        )
        rows.addRow(translate("SweptVolume", "Accuracy"), self.accuracy)
        rows.addRow(translate("SweptVolume", "Set cell size by"), self.by)
        rows.addRow(translate("SweptVolume", "Resolution"), self.resolution)
        rows.addRow(translate("SweptVolume", "Quality"), self.quality)
        rows.addRow(translate("SweptVolume", "Cell size"), self.cell)
        self.estimate_label = QtWidgets.QLabel()
        self.estimate_label.setWordWrap(True)
        rows.addRow(self.estimate_label)
        rows.addRow(translate("SweptVolume", "Tolerance"), self.tolerance)
        rows.addRow(translate("SweptVolume", "Offset"), self.offset)
        self.conservative = widgets.check_box(
            translate("SweptVolume", "Conservative"),
            values["Conservative"],
            translate(
                "SweptVolume", "Grows the envelope until it provably contains the swept volume"
            ),
        )
        self.cavities = widgets.check_box(
            translate("SweptVolume", "Keep cavities"),
            values["KeepCavities"],
            translate(
                "SweptVolume", "Keeps enclosed cavities as inner shells; otherwise they are filled"
            ),
        )
        rows.addRow(self.conservative)
        rows.addRow(self.cavities)
        self.preview_box = QtWidgets.QCheckBox(translate("SweptVolume", "Show a coarse envelope"))
        self.preview_box.setObjectName("SweptVolumePreview")
        self.preview_text = widgets.message_label()
        rows.addRow(self.preview_box)
        rows.addRow(self.preview_text)
        self.deflection = values["MeshDeflection"]

    def build_method(self, values):
        rows = widgets.group(translate("SweptVolume", "Method"), self.layout)
        self.components = widgets.choice(list(COMPONENTS), values["Components"])
        widgets.hint(
            self.components,
            translate(
                "SweptVolume",
                "How pieces of surface inside one cell are separated. For research only: keep Consistent, "
                "which alone guarantees that the envelope is closed",
            ),
        )
        self.backend = widgets.choice(list(BACKENDS), values["Backend"])
        self.filter = widgets.length(values["PositionFilter"])
        widgets.hint(
            self.filter,
            translate(
                "SweptVolume",
                "For recordings with very many poses. Poses are skipped as long as no point of "
                "the part has moved farther than this length since the last pose used. 0: every "
                "pose is used",
            ),
        )
        rows.addRow(translate("SweptVolume", "Components"), self.components)
        rows.addRow(translate("SweptVolume", "Backend"), self.backend)
        rows.addRow(translate("SweptVolume", "Position filter"), self.filter)
        self.made_by = widgets.choice(MADE_BY, values["MadeBy"])
        self.made_by.setObjectName("SweptVolumeMadeBy")
        widgets.hint(
            self.made_by,
            translate(
                "SweptVolume",
                "Records for each triangle which face or edge of which part made it, "
                'and when. The command "What made this?" shows the record. If it is '
                "stored in the document, the file becomes larger",
            ),
        )
        rows.addRow(translate("SweptVolume", "Made by"), self.made_by)

    def connect_fields(self):
        """Connects the fields with each other and with _changed()."""
        self.by.currentIndexChanged.connect(self._accuracy_changed)
        self.quality.valueChanged.connect(lambda i: self.resolution.setValue(QUALITIES[i]))
        self.resolution.valueChanged.connect(self._show_quality)
        for signal in (
            self.resolution.valueChanged,
            self.backend.currentIndexChanged,
            self.accuracy.valueChanged,
            self.cell.valueChanged,
            self.tolerance.valueChanged,
            self.offset.valueChanged,
            self.conservative.toggled,
            self.cavities.toggled,
            self.filter.valueChanged,
        ):
            signal.connect(self._changed)
        self._show_quality()
        self._accuracy_changed()

    def _show_quality(self, *ignored):
        """Moves the slider to the step nearest to the number of cells."""
        cells = self.resolution.value()
        nearest = min(range(len(QUALITIES)), key=lambda i: abs(QUALITIES[i] - cells))
        self.quality.blockSignals(True)
        self.quality.setValue(nearest)
        self.quality.blockSignals(False)

    def _accuracy_changed(self, *ignored):
        by = self.by.currentData()
        self.accuracy.setEnabled(by == "Accuracy")
        self.tolerance.setEnabled(by != "Accuracy")
        self.cell.setEnabled(by == "CellSize")
        self.resolution.setEnabled(by == "Resolution")
        self.quality.setEnabled(by == "Resolution")
        self._changed()

    def values(self):
        return {
            "Accuracy": self._given("Accuracy", self.accuracy),
            "Resolution": self.resolution.value(),
            "CellSize": self._given("CellSize", self.cell),
            "MeshDeflection": self.deflection,
            "Tolerance": float(self.tolerance.property("rawValue")),
            "Offset": float(self.offset.property("rawValue")),
            "Conservative": self.conservative.isChecked(),
            "KeepCavities": self.cavities.isChecked(),
            "PositionFilter": float(self.filter.property("rawValue")),
            "Components": self.components.currentData(),
            "Backend": self.backend.currentData(),
            "MadeBy": self.made_by.currentData(),
        }

    def _given(self, name, field):
        """Returns the length in a field (mm) if this field determines the cell size, otherwise
        0."""
        return float(field.property("rawValue")) if self.by.currentData() == name else 0.0

    def check_size(self):
        """Raises InputProblem if the length that determines the cell size is 0."""
        by = self.by.currentData()
        if by == "CellSize" and not self._given(by, self.cell) > 0:
            raise InputProblem(
                translate("SweptVolume", "The cell size must be above 0 mm: enter a larger value.")
            )
        if by == "Accuracy" and not self._given(by, self.accuracy) > 0:
            raise InputProblem(
                translate("SweptVolume", "The accuracy must be above 0 mm: enter a larger value.")
            )
