# SPDX-License-Identifier: LGPL-2.1-or-later
"""Task panel of a sequence: parts in their order with their motions, parts that stand still, rules.
Finds the paths in this order, or finds an order, and plays all paths as one motion. Writes nothing
before a search has found all paths. Then it writes their motions and the sequence as one undo
step."""
from PySide import QtCore

from .. import runner
from ..features import pair_rules, path_plan, sequence, sequence_plan
from ..features.base import STALE
from ..texts import QT_TRANSLATE_NOOP, translate
from ..views.ghost import MOVING_TRIANGLES, MovingPart, MovingParts
from . import focus, guard, widgets
from .path_tasks import SequenceTask
from .player import Player
from .search_panel import SearchPanel
from .sequence_rows import SequenceRows
from .tasks import ShapesTask
from .widgets import QtWidgets

#: Interval (ms) between two checks of the search's progress.
POLL = 200
#: The panel opened last, for tests and macros. FreeCAD does not give access to it.
opened = []


class SequencePanel(SearchPanel):
    """Creates a new sequence (obj None), or shows an existing one and searches again."""

    TITLE, ICON = QT_TRANSLATE_NOOP("SweptVolume", "Sequence"), "SweptVolume_Sequence"
    BUTTON = QT_TRANSLATE_NOOP("SweptVolume", "&Find paths in this order")

    def __init__(self, document, pairs=(), obj=None):
        self.obj, self.ghost, self.ghosts, self.shapes, self.courses = obj, None, None, None, []
        self.looked = -1
        # Settings of the object that no field shows are kept: the accuracy, and rules for pairs of
        # moving parts.
        self.tolerance, self.own_rules = path_plan.DEFAULTS["Accuracy"], {}
        self.poll_timer = QtCore.QTimer()
        self.poll_timer.timeout.connect(self._poll)
        plan = sequence.Plan.of(obj) if obj is not None else None
        super().__init__(document, plan.pairs if plan else pairs)
        self.rows.changed.connect(self._parts_changed)
        if plan is not None:
            self._show_plan(plan)

    # --- building

    def build_task(self):
        self.order_button = QtWidgets.QPushButton(translate("SweptVolume", "Find an &order"))
        self.order_button.setObjectName("SweptVolumeFindOrder")
        widgets.hint(
            self.order_button,
            translate(
                "SweptVolume",
                "Finds an order in which the parts can be installed: searches for an order in "
                "which they can be removed, and reverses it",
            ),
        )
        self.layout.insertWidget(self.layout.indexOf(self.start_button) + 1, self.order_button)
        self.order_button.clicked.connect(lambda *ignored: self.start("find"))
        self.rows = SequenceRows(self.document, self.layout)
        self.rows.show_rows(self.pairs)
        self.out = widgets.length(sequence_plan.SEARCH["Out"], 1.0, 10.0)
        self.out.setObjectName("SweptVolumeOut")
        widgets.hint(
            self.out,
            translate(
                "SweptVolume",
                "A part counts as removed when it is this far from its installed position",
            ),
        )
        self.player = Player()
        self.player.hide()
        self.player.moved.connect(self._moved)
        self.layout.addWidget(self.player)

    def build_rules(self, rows):
        self.straight = QtWidgets.QCheckBox(translate("SweptVolume", "The parts never turn"))
        self.straight.setObjectName("SweptVolumeTranslationOnly")
        rows.addRow(translate("SweptVolume", "Removal distance"), self.out)
        rows.addRow(self.straight)

    @guard.shows_problems
    def _show_plan(self, plan):
        states = [sequence.step_text(step) for step in plan.steps]
        self.rows.show_rows(plan.pairs, plan.motions, states)
        self.tolerance = plan.values["Accuracy"]
        self.own_rules = {
            both: rule
            for both, rule in plan.pair_rules.items()
            if all(part in plan.pairs for part in both)
        }
        self.required.setProperty("rawValue", plan.values["RequiredDistance"])
        self.release.setProperty("rawValue", plan.values["ReleaseDistance"])
        self.deflection.setProperty("rawValue", plan.values["MeshDeflection"])
        self.take_neighbours(plan.leaves() if plan.all_visible else plan.neighbours)
        kept = {
            pair: pair_rules.of(plan.pair_rules, plan.pairs[0], pair) for pair in self.beside.pairs
        }
        self.beside.table.show_pairs(self.beside.pairs, kept)
        self._show_state()
        self._show_player()

    def _show_state(self):
        text = self.obj.Message
        if self.obj.Status == STALE:
            text = translate("SweptVolume", "{0} (stale: check again)").format(self.obj.Summary)
        widgets.show_message(self.message, text)
        self.note_state()

    def show_result(self):
        """Shows another state of the sequence, and keeps what was typed."""
        states = []
        if self.obj is not None:
            self._show_state()
            plan = sequence.Plan.of(self.obj)
            if (plan.pairs, plan.motions) == (self.rows.pairs, self.rows.motions):
                states = [sequence.step_text(step) for step in plan.steps]
        for row in range(len(self.rows.pairs)):
            self.rows.set_state(row, states[row] if states else "")
        self._show_player()

    # --- inputs

    def _parts_changed(self):
        self.pairs = self.rows.pairs
        self.beside.drop_moving()
        self.player.hide()
        self.clear_view()

    def plan(self, order):
        """Returns the plan from the fields. Raises InputProblem."""
        values = {
            "RequiredDistance": float(self.required.property("rawValue")),
            "ReleaseDistance": float(self.release.property("rawValue")),
            "Accuracy": self.tolerance,
            "MeshDeflection": float(self.deflection.property("rawValue")),
        }
        rules = dict(self.own_rules)
        rules.update(
            (pair_rules.key(part, beside), rule)
            for beside, rule in self.beside.rules().items()
            for part in self.rows.pairs
        )
        plan = sequence.Plan(
            self.document,
            self.rows.pairs,
            self.rows.motions,
            self.beside.pairs,
            False,
            values,
            rules,
        )
        plan.search.update(
            Order=order,
            Out=float(self.out.property("rawValue")),
            TranslationOnly=self.straight.isChecked(),
            Budget=self.budget.value(),
            Seed=self.seed.value(),
        )
        return plan

    # --- run

    def start(self, order="given"):
        self.beside.mark([])
        self.clear_view()
        self.looked = -1
        if not self.begin(
            lambda: SequenceTask(self.plan(order), self.obj),
            self.ended,
            lambda: self.plan(order).words(),
            lambda: self.start(order),
        ):
            return False
        for button in (self.start_button, self.order_button):
            button.setEnabled(False)
        for row in range(len(self.rows.pairs)):
            self.rows.set_state(row, "")
        self.poll_timer.start(POLL)
        return True

    def _poll(self):
        """Shows the current part of the search, and its farthest placement."""
        if self.run is None:
            return
        row, found, farthest = self.run.task.seen.seen()
        if row is None:
            return
        if row != self.looked:
            if 0 <= self.looked:
                self.rows.set_state(self.looked, "")
            self._forget_ghost()
            self.looked = row
        text = translate("SweptVolume", "searching ({0} of {1} found)")
        self.rows.set_state(row, text.format(found, len(self.rows.pairs)))
        searched = self.run.task.request.rows[row]
        if farthest is not None and searched.pivot is not None:
            if self.ghost is None:
                body = searched.part.body
                self.ghost = MovingPart(self.document, body.vertices, body.triangles)
            self.ghost.show(path_plan.placement_of(farthest))

    def ended(self, run):
        self.poll_timer.stop()
        self.run = None
        if not widgets.alive(self.document):
            return
        self._forget_ghost()
        for button in (self.start_button, self.order_button):
            button.setEnabled(True)
        self.box.leave(self.form)
        if run.state != "ok":
            self.rows.show_rows(self.rows.pairs, self.rows.motions)
            widgets.show_failure(self.message, run)
            return
        self.found(run.task)

    def found(self, task):
        report = task.outcome.report
        widgets.show_message(self.message, sequence.description(report))
        states = [sequence.step_text(step) for step in report["steps"]]
        if task.obj is not None:
            self.obj = task.obj
            self.rows.show_rows(task.plan.pairs, task.plan.motions, states)
            self.pairs = self.rows.pairs
            self.note_state()
            self._show_player()
            return
        for number, text in zip(task.outcome.order, states):
            self.rows.set_state(number, text)
        blockers = [
            name
            for step in report["steps"]
            if step["verdict"] != "found"
            for name in step["escape"]["blockers"][:1]
        ]
        self.beside.mark(blockers)

    # --- played as one

    def _show_player(self):
        steps = sequence.Plan.of(self.obj).steps if self.obj is not None else []
        self.clear_view()
        self.player.setVisible(bool(steps))
        if steps:
            times = {step["begin"] for step in steps} | {step["end"] for step in steps}
            self.player.blockSignals(True)
            self.player.set_times(sorted(times))
            self.player.blockSignals(False)

    @guard.shows_problems
    def _moved(self):
        if self.ghosts is not None:
            self.ghosts.show([course(self.player.now()) for course in self.courses])
        elif self.shapes is None and self.obj is not None:
            self.shapes = runner.start(ShapesTask(sequence.Plan.of(self.obj), MOVING_TRIANGLES))
            self.shapes.ended.connect(self._shapes_read)

    @guard.shows_problems
    def _shapes_read(self, run):
        self.shapes = None
        if run.state != "ok" or not widgets.alive(self.document):
            return
        self.courses = [course for _, _, course in run.task.found]
        self.ghosts = MovingParts(self.document, [found[:2] for found in run.task.found])
        self._moved()

    def _forget_ghost(self):
        if self.ghost is not None and widgets.alive(self.document):
            self.ghost.remove()
        self.ghost = None

    def clear_view(self):
        """Removes all drawings."""
        self.player.stop()
        self._forget_ghost()
        if self.shapes is not None:
            self.shapes.ended.disconnect(self._shapes_read)
            self.shapes.cancel()
        if self.ghosts is not None and widgets.alive(self.document):
            self.ghosts.remove()
        self.shapes, self.ghosts, self.courses = None, None, []

    def leave(self):
        self.poll_timer.stop()
        self.clear_view()


def show(document, **given):
    panel = SequencePanel(document, **given)
    opened[:] = [panel]
    focus.show(panel)
    return panel
