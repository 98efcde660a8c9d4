# SPDX-License-Identifier: LGPL-2.1-or-later
"""Task panel of an envelope: parts, motion, accuracy, estimate, coarse preview, run, result. Writes
nothing to the document before a run has succeeded."""
import FreeCADGui as Gui
from PySide import QtCore

from .. import contents, quantities, reading, settings
from ..features.envelope_plan import Plan
from ..texts import translate
from ..views.ghost import CoarseEnvelope
from . import focus, guard, widgets
from .background_estimate import BackgroundEstimate
from .envelope_fields import DEFAULTS, EnvelopeFields
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
#: The panel opened last, for tests and macros. FreeCAD does not give access to it.
opened = []


class EnvelopePanel(EnvelopeFields, StartPanel):
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
        self.build_accuracy(values)
        self.build_method(values)
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

    def _connect(self):
        self.connect_fields()
        self.preview_box.toggled.connect(self._changed)
        self.parts.changed.connect(self._changed)

    # --- values

    def plan(self):
        self.check_size()
        parts = self.parts
        return Plan(
            parts.pairs, parts.motion(), self.values(), parts.own_motions(), *parts.seen_from()
        )

    def _words(self):
        return self.plan().words()

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
