# SPDX-License-Identifier: LGPL-2.1-or-later
"""Task panel of an envelope: parts, motion, accuracy, estimate, coarse preview, run, result. Writes
nothing to the document before a run has succeeded."""
import FreeCADGui as Gui
from PySide import QtCore

from .. import contents, quantities, reading, settings
from ..convert import InputProblem
from ..features.envelope_plan import Plan
from ..features.envelope_properties import BACKENDS, COMPONENTS, MADE_BY
from ..texts import translate
from ..views.ghost import CoarseEnvelope
from . import focus, guard, widgets
from .background_estimate import BackgroundEstimate
from .parts_box import PartsBox
from .preview import MOST_CELLS, Preview
from .read_outs import ReadOuts
from .run_panel import StartPanel
from .tasks import EnvelopeTask
from .widgets import QtWidgets

#: Time (ms) from the last change to a new estimate and preview.
ESTIMATE_DELAY = 250
#: Time (ms) from the end of a run to closing the panel. The window draws the result in this time.
CLOSE_DELAY = 150
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

#: The panel opened last, for tests and macros. FreeCAD does not give access to it.
opened = []


class EnvelopePanel(StartPanel):
    """Creates a new envelope (obj None), or changes an existing one."""

    STARTERS = ("Ok", "Apply")

    def __init__(self, document, pairs=(), motion_obj=None, obj=None):
        self.document = document
        self.obj = obj
        self.run = None
        self.buttons = []
        self.closed = False
        self.close_when_done = True
        values = dict(
            DEFAULTS,
            Resolution=settings.resolution(),
            Tolerance=settings.tolerance(),
            Backend=settings.backend(),
        )
        plan = Plan(pairs, motion_obj, values) if obj is None else Plan.of(obj)
        values = plan.values
        title = translate("SweptVolume", "Swept envelope")
        self.form, self.layout = widgets.window(title, "SweptVolume_Envelope")
        self.box = widgets.RunBox()
        self.message = widgets.message_label()
        self.read_outs = ReadOuts(document)
        for widget in (self.box, self.message, self.read_outs):
            self.layout.addWidget(widget)  # on top, visible without scrolling
        self.parts = PartsBox(document, plan, self.layout, obj is not None)
        self._build_accuracy(values)
        self._build_method(values)
        self.layout.addStretch(1)
        self.timer = QtCore.QTimer(self.form)
        self.timer.setSingleShot(True)
        self.timer.timeout.connect(self.settled)
        self.coarse = None
        self.bodies = contents.KeptBodies()
        self.background = BackgroundEstimate(document, self.show_estimate, self.report_estimate)
        self.preview = Preview(document, self.show_preview, self.report_preview, self.finest)
        self._connect()
        self.read_outs.show_result(obj)
        if obj is not None:
            widgets.show_message(self.message, plan.lost)

    # --- building

    def _build_accuracy(self, values):
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
        tip = translate("SweptVolume", "Number of cells along the longest side of the swept volume")
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
        self.conservative = QtWidgets.QCheckBox(translate("SweptVolume", "Conservative"))
        self.conservative.setChecked(values["Conservative"])
        widgets.hint(
            self.conservative,
            translate(
                "SweptVolume", "Grows the envelope until it provably contains the swept volume"
            ),
        )
        self.cavities = QtWidgets.QCheckBox(translate("SweptVolume", "Keep cavities"))
        self.cavities.setChecked(values["KeepCavities"])
        widgets.hint(
            self.cavities,
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

    def _build_method(self, values):
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

    def _connect(self):
        self.by.currentIndexChanged.connect(self._accuracy_changed)
        self.quality.valueChanged.connect(lambda i: self.resolution.setValue(QUALITIES[i]))
        self.resolution.valueChanged.connect(self._show_quality)
        self.preview_box.toggled.connect(self._changed)
        self.parts.changed.connect(self._changed)
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

    # --- values

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

    def plan(self):
        by = self.by.currentData()
        if by == "CellSize" and not self._given(by, self.cell) > 0:
            raise InputProblem(
                translate("SweptVolume", "The cell size must be above 0 mm: enter a larger value.")
            )
        if by == "Accuracy" and not self._given(by, self.accuracy) > 0:
            raise InputProblem(
                translate("SweptVolume", "The accuracy must be above 0 mm: enter a larger value.")
            )
        parts = self.parts
        return Plan(
            parts.pairs, parts.motion(), self.values(), parts.own_motions(), *parts.seen_from()
        )

    def _words(self):
        return self.plan().words()

    def _accuracy_changed(self, *ignored):
        by = self.by.currentData()
        self.accuracy.setEnabled(by == "Accuracy")
        self.tolerance.setEnabled(by != "Accuracy")
        self.cell.setEnabled(by == "CellSize")
        self.resolution.setEnabled(by == "Resolution")
        self.quality.setEnabled(by == "Resolution")
        self._changed()

    def _changed(self, *ignored):
        self.timer.start(ESTIMATE_DELAY)

    def settled(self):
        """Called some time after the last change: updates estimate and preview."""
        if not widgets.alive(self.document):
            self._close()
            return
        if reading.first(
            self.document, self._words, id(self.form), lambda: self._read(self._changed)
        ):
            text = translate("SweptVolume", "Reading the parts ...")
            widgets.show_message(self.estimate_label, text)
            return
        self.estimate()
        self.ask_preview()

    def ask_preview(self):
        """Requests a coarse envelope for the present inputs, or removes it."""
        if not self.preview_box.isChecked() or self.run is not None:
            self.preview.stop()
            self._remove_coarse()
            return
        plan = self.plan()
        self.preview.want(plan.coarse_requests)

    def finest(self):
        """Returns the number of cells of the fine preview: the requested number, but at most
        MOST_CELLS."""
        by_cells = self.by.currentData() == "Resolution"
        return min(self.resolution.value(), MOST_CELLS) if by_cells else MOST_CELLS

    def show_preview(self, surface):
        if self.coarse is None:
            self.coarse = CoarseEnvelope(self.document)
        self.coarse.show(surface)

    def _remove_coarse(self):
        if self.coarse is not None and widgets.alive(self.document):
            self.coarse.remove()
        self.coarse = None

    def report_preview(self, text):
        widgets.show_message(self.preview_text, text)

    def estimate(self):
        """Shows the grid at once, and memory and time a moment later."""
        if self.run is not None:
            return
        try:
            guard.check_fields(self.form)
            plan = self.plan()
            text = self._grid_text(plan.estimate()) if plan.is_outlined() else ""
            self.background.want(plan.closer_estimate(self.bodies.read))
        except Exception as problem:
            self.background.stop()
            guard.show_problem(self.estimate_label, problem)
            return
        if text:
            self._show_estimate(text)

    def show_estimate(self, found):
        more = translate("SweptVolume", "; needs about {0} of memory and {1}")
        took = quantities.megabytes(found["memory_bytes"]), quantities.seconds(found["seconds"])
        text = self._grid_text(found) + more.format(*took)
        if found.get("useful_filter"):
            hint = translate(
                "SweptVolume",
                "Most poses are nearly equal: a position filter of {0} skips them and makes the "
                "run much faster.",
            )
            text += "\n" + hint.format(quantities.quantity(found["useful_filter"]))
        self._show_estimate(text)

    def report_estimate(self, text):
        widgets.show_message(self.estimate_label, text)

    def _show_estimate(self, text):
        widgets.show_message(self.estimate_label, text + self._one_pose())

    @staticmethod
    def _grid_text(found):
        text = translate("SweptVolume", "{0} x {1} x {2} cells of {3}")
        cells = map(quantities.count, found["grid"])
        return text.format(*cells, quantities.quantity(found["cell"]))

    def _one_pose(self):
        """Returns a hint if the motion has only one pose, otherwise ""."""
        motion = self.parts.motion()
        if motion is None or len(motion.Placements) != 1:
            return ""
        return "\n" + translate(
            "SweptVolume",
            "The motion has only one pose, so the parts do not move: add another pose.",
        )

    # --- run

    def start(self, close_when_done=True):
        """Reads the document and starts the run. Problems are shown in the panel."""
        self.close_when_done = close_when_done
        if not self.begin(
            lambda: EnvelopeTask(self.document, self.plan(), self.obj),
            self.ended,
            self._words,
            lambda: self.start(close_when_done),
        ):
            return False
        self.preview_box.setChecked(False)
        self.background.stop()
        self.preview.stop()
        self._remove_coarse()
        self._enable(False)
        return True

    def _enable(self, on):
        for box in self.form.findChildren(QtWidgets.QGroupBox):
            if box not in (self.box, self.read_outs):
                box.setEnabled(on)
        self.enable_buttons(on)

    def ended(self, run):
        self.run = None
        if not widgets.alive(self.document):
            self._close()
            return
        if self.obj is not None and not widgets.alive(self.obj):
            self.obj = None  # the object was deleted meanwhile, so OK creates a new one
        if run.state == "ok":
            self.obj = run.task.obj
            Gui.Selection.clearSelection()
            if self.close_when_done:
                QtCore.QTimer.singleShot(CLOSE_DELAY, self._close)
                return
            self.read_outs.show_result(self.obj)
        else:
            widgets.show_failure(self.message, run)
        self._enable(True)
        self.box.leave(self.form)

    # --- task panel

    def clicked(self, button):
        apply = widgets.number_of(QtWidgets.QDialogButtonBox.Apply)
        if widgets.number_of(button) == apply and self.run is None:
            self.start(close_when_done=False)

    def _close(self):
        if self.closed:  # the document was closed, and a run or the timer already closed the panel
            return True
        self.closed = True
        self.timer.stop()
        self.background.stop()
        self.preview.stop()
        self.read_outs.stop()
        self._remove_coarse()
        self.close_dialog()
        return True


def show(document, pairs=(), motion_obj=None, obj=None, start=False):
    """Opens the panel. `start`: starts the run at once (Recompute)."""
    panel = EnvelopePanel(document, pairs, motion_obj, obj)
    opened[:] = [panel]
    focus.show(panel)
    if start and not panel.message.text():  # a message says that an input is missing
        panel.start()
    return panel
