# SPDX-License-Identifier: LGPL-2.1-or-later
"""Task panel of an envelope: parts, motion, accuracy, estimate, run. Nothing is written to the
document before a run has ended well."""
import FreeCAD as App
import FreeCADGui as Gui
from PySide import QtCore

from .. import convert, core, runner, settings
from ..convert import InputProblem
from ..features import motion
from ..features.base import objects_of_kind
from ..features.envelope import BACKENDS, COMPONENTS, Plan
from ..texts import translate
from . import selection, widgets
from .tasks import EnvelopeTask
from .widgets import QtWidgets

#: ms after the last change before the estimate is made anew.
ESTIMATE_DELAY = 250

DEFAULTS = {
    "Resolution": 128,
    "CellSize": 0.0,
    "MeshDeflection": 0.1,
    "Tolerance": 0.0,
    "Offset": 0.0,
    "Conservative": False,
    "KeepCavities": False,
    "Components": "Consistent",
    "Backend": "Auto",
}


class EnvelopePanel:
    """Makes a new envelope (obj None) or changes one."""

    def __init__(self, document, pairs=(), motion_obj=None, obj=None):
        self.document = document
        self.obj = obj
        self.run = None
        self.buttons = []
        self.close_when_done = True
        values = dict(
            DEFAULTS,
            Resolution=settings.resolution(),
            Tolerance=settings.tolerance(),
            Backend=settings.backend(),
        )
        if obj is not None:
            plan = Plan.of(obj)
            pairs, motion_obj, values = plan.pairs, plan.motion, plan.values
        self.pairs = list(pairs)
        title = translate("Panels", "Swept envelope")
        self.form, self.layout = widgets.window(title, "SweptVolume_Envelope")
        self.box = widgets.RunBox()
        self.message = widgets.message_label()
        self.layout.addWidget(self.box)  # on top: visible without scrolling
        self.layout.addWidget(self.message)
        self._build_inputs(motion_obj)
        self._build_accuracy(values)
        self._build_method(values)
        self.layout.addStretch(1)
        self.timer = QtCore.QTimer(self.form)
        self.timer.setSingleShot(True)
        self.timer.timeout.connect(self.estimate)
        self._connect()
        self._show_parts()

    # --- building

    def _build_inputs(self, motion_obj):
        rows = widgets.group(translate("Panels", "Moving parts"), self.layout)
        self.parts = QtWidgets.QListWidget()
        self.parts.setObjectName("SweptVolumeParts")
        self.parts.setMaximumHeight(72)
        self.parts.setSelectionMode(QtWidgets.QAbstractItemView.ExtendedSelection)
        self.add = QtWidgets.QPushButton(translate("Panels", "Add selected"))
        self.remove = QtWidgets.QPushButton(translate("Panels", "Remove"))
        widgets.hint(
            self.add, translate("Panels", "Adds the solids and meshes selected in the tree")
        )
        buttons = QtWidgets.QHBoxLayout()
        buttons.addWidget(self.add)
        buttons.addWidget(self.remove)
        rows.addRow(self.parts)
        rows.addRow(buttons)
        motions = objects_of_kind(self.document, motion.Motion.KIND)
        self.motions = QtWidgets.QComboBox()
        self.motions.setObjectName("SweptVolumeMotion")
        for candidate in motions:
            self.motions.addItem(candidate.Label, candidate.Name)
        if motion_obj in motions:
            self.motions.setCurrentIndex(motions.index(motion_obj))
        rows.addRow(translate("Panels", "Motion"), self.motions)

    def _build_accuracy(self, values):
        rows = widgets.group(translate("Panels", "Accuracy"), self.layout)
        self.by = widgets.choice(
            ["Resolution", "CellSize"],
            "CellSize" if values["CellSize"] > 0 else "Resolution",
            [translate("Panels", "Number of cells"), translate("Panels", "Cell size")],
        )
        self.resolution = QtWidgets.QSpinBox()
        self.resolution.setRange(8, 4096)
        self.resolution.setSingleStep(16)
        self.resolution.setValue(values["Resolution"])
        self.resolution.setObjectName("SweptVolumeResolution")
        tip = translate("Panels", "Cells along the longest side of the sweep")
        widgets.hint(self.resolution, tip)
        self.cell = widgets.length(values["CellSize"] or 1.0)
        self.tolerance = widgets.length(values["Tolerance"])
        self.offset = widgets.length(values["Offset"])
        widgets.hint(
            self.tolerance, translate("Panels", "Largest deviation by simplification; 0: none")
        )
        widgets.hint(self.offset, translate("Panels", "Safety distance around the swept volume"))
        rows.addRow(translate("Panels", "Given by"), self.by)
        rows.addRow(translate("Panels", "Cells"), self.resolution)
        rows.addRow(translate("Panels", "Cell size"), self.cell)
        self.estimate_label = QtWidgets.QLabel()
        self.estimate_label.setWordWrap(True)
        rows.addRow(self.estimate_label)
        rows.addRow(translate("Panels", "Simplification"), self.tolerance)
        rows.addRow(translate("Panels", "Offset"), self.offset)
        self.conservative = QtWidgets.QCheckBox(translate("Panels", "Contain the sweep provably"))
        self.conservative.setChecked(values["Conservative"])
        self.cavities = QtWidgets.QCheckBox(translate("Panels", "Keep enclosed cavities"))
        self.cavities.setChecked(values["KeepCavities"])
        rows.addRow(self.conservative)
        rows.addRow(self.cavities)
        self.deflection = values["MeshDeflection"]

    def _build_method(self, values):
        rows = widgets.group(translate("Panels", "Method"), self.layout)
        self.components = widgets.choice(list(COMPONENTS), values["Components"])
        self.backend = widgets.choice(list(BACKENDS), values["Backend"])
        rows.addRow(translate("Panels", "Components"), self.components)
        rows.addRow(translate("Panels", "Backend"), self.backend)

    def _connect(self):
        self.add.clicked.connect(self.add_selected)
        self.remove.clicked.connect(self.remove_chosen)
        self.by.currentIndexChanged.connect(self._accuracy_changed)
        for signal in (
            self.motions.currentIndexChanged,
            self.resolution.valueChanged,
            self.backend.currentIndexChanged,
        ):
            signal.connect(self._changed)
        self.cell.valueChanged.connect(self._changed)
        self.offset.valueChanged.connect(self._changed)
        self._accuracy_changed()

    # --- parts

    def _show_parts(self):
        self.parts.clear()
        for root, sub in self.pairs:
            text = convert.label_of(root, sub)
            if sub.count(".") >= 1:
                text += "  ({})".format(root.Label)
            self.parts.addItem(text)
        self._changed()

    def add_selected(self):
        for pair in selection.parts():
            if pair not in self.pairs:
                self.pairs.append(pair)
        self._show_parts()

    def remove_chosen(self):
        rows = {index.row() for index in self.parts.selectedIndexes()}
        self.pairs = [pair for i, pair in enumerate(self.pairs) if i not in rows]
        self._show_parts()

    # --- values

    def motion_object(self):
        name = self.motions.currentData()
        return self.document.getObject(name) if name else None

    def values(self):
        by_cell = self.by.currentData() == "CellSize"
        return {
            "Resolution": self.resolution.value(),
            "CellSize": float(self.cell.property("rawValue")) if by_cell else 0.0,
            "MeshDeflection": self.deflection,
            "Tolerance": float(self.tolerance.property("rawValue")),
            "Offset": float(self.offset.property("rawValue")),
            "Conservative": self.conservative.isChecked(),
            "KeepCavities": self.cavities.isChecked(),
            "Components": self.components.currentData(),
            "Backend": self.backend.currentData(),
        }

    def plan(self):
        return Plan(self.pairs, self.motion_object(), self.values())

    def _accuracy_changed(self, *ignored):
        by_cell = self.by.currentData() == "CellSize"
        self.cell.setEnabled(by_cell)
        self.resolution.setEnabled(not by_cell)
        self._changed()

    def _changed(self, *ignored):
        if hasattr(self, "timer"):
            self.timer.start(ESTIMATE_DELAY)

    def estimate(self):
        """Shows grid, memory and time before anything is started."""
        if not widgets.alive(self.document):
            Gui.Control.closeDialog()
            return
        try:
            e = self.plan().estimate()
        except (InputProblem, core.CoreError, core.CoreMissing) as problem:
            self.estimate_label.setText(str(problem))
            return
        cell = App.Units.Quantity(e["cell"], App.Units.Length).UserString
        text = translate("Panels", "{0} x {1} x {2} cells of {3}; about {4:.0f} MB and {5:.1f} s")
        self.estimate_label.setText(
            text.format(*e["grid"], cell, e["memory_bytes"] / 1e6, e["seconds"])
        )

    # --- run

    def start(self, close_when_done=True):
        """Reads the document and starts the run; problems are shown in the panel."""
        self.close_when_done = close_when_done
        widgets.show_message(self.message, "")
        try:
            task = EnvelopeTask(self.document, self.plan(), self.obj)
        except (InputProblem, core.CoreMissing) as problem:
            widgets.show_message(self.message, str(problem))
            return False
        self.run = runner.start(task)
        self.box.follow(self.run)
        self._enable(False)
        self.run.ended.connect(self.ended)
        return True

    def _enable(self, on):
        for box in self.form.findChildren(QtWidgets.QGroupBox):
            if box is not self.box:
                box.setEnabled(on)
        for button in self.buttons:
            button.setEnabled(on)

    def ended(self, run):
        self.run = None
        if not widgets.alive(self.document):
            self.timer.stop()
            Gui.Control.closeDialog()
            return
        if self.obj is not None and not widgets.alive(self.obj):
            self.obj = None  # deleted meanwhile: OK makes a new one
        self.box.hide()
        self._enable(True)
        if run.state == "ok":
            self.obj = run.task.obj
            Gui.Selection.clearSelection()
            if self.close_when_done:
                Gui.Control.closeDialog()
            else:
                widgets.show_message(self.message, summary(self.obj))
            return
        text = run.message
        if run.state == "cancelled":
            text = translate("Messages", "Cancelled. Nothing was changed.")
        widgets.show_message(self.message, text)

    # --- task panel

    def getStandardButtons(self):
        box = QtWidgets.QDialogButtonBox
        return widgets.standard_buttons(box.Ok, box.Apply, box.Cancel)

    def modifyStandardButtons(self, box):
        """FreeCAD hands over the buttons of the open panel."""
        kinds = (QtWidgets.QDialogButtonBox.Ok, QtWidgets.QDialogButtonBox.Apply)
        self.buttons = [box.button(kind) for kind in kinds]
        self._button_box = box  # keeps the wrappers of the buttons alive

    def clicked(self, button):
        if int(button) == int(QtWidgets.QDialogButtonBox.Apply) and self.run is None:
            self.start(close_when_done=False)

    def accept(self):
        if self.run is None:
            self.start()
        return False

    def reject(self):
        """Cancel: stops a run first; nothing was written before it ended."""
        if self.run is not None:
            self.run.ended.disconnect(self.ended)
            self.run.cancel()
        self.timer.stop()
        Gui.Control.closeDialog()
        return True


def summary(obj):
    """One line on a result."""
    return translate("Panels", "{0}: {1} triangles, {2}, {3:.2f} s").format(
        obj.Label, obj.Triangles, obj.Volume.UserString, obj.Seconds
    )


def show(document, pairs=(), motion_obj=None, obj=None, start=False):
    """Opens the panel; `start`: begins at once (Recompute)."""
    panel = EnvelopePanel(document, pairs, motion_obj, obj)
    Gui.Control.showDialog(panel)
    if start:
        panel.start()
    return panel
