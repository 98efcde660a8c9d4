# SPDX-License-Identifier: LGPL-2.1-or-later
"""The result of a mechanism check in its panel: a player shows all moving parts at a time, a row of the
table its two parts when they are nearest, with the line between them."""
import numpy as np

from .. import quantities, runner
from ..features import mechanism, mechanism_table
from ..texts import mark, translate
from ..views.clearance_view import zoom_to
from ..views.ghost import MOVING_TRIANGLES, MovingParts
from ..views.live_distance import LiveDistance
from . import check_result, guard, widgets
from .player import Player
from .tasks import ShapesTask


class ResultPanel(check_result.ResultPanel):
    """`obj`, `document`, `message` are the panel's."""

    NAME = mark("Panels", "Pair")
    TABLE = mechanism_table

    def stored_report(self):
        return mechanism.report_of(self.obj)

    def rows_of(self, report):
        return mechanism_table.as_rows(report)

    def build_more(self, rows):
        self.shapes, self.ghosts, self.line, self.courses = None, None, None, []
        self.wanted = None  # what is to be shown once the parts are read: a row, or nothing
        self.player = Player()
        self.player.moved.connect(self._moved)
        rows.addWidget(self.player)
        self.table.itemDoubleClicked.connect(lambda *ignored: self._look())

    def shown(self):
        self.clear_view()
        times = {row["time_seconds"] for row in self.report["neighbours"]}
        ends = {self.whole["from_seconds"], self.whole["to_seconds"]}
        self.player.blockSignals(True)  # nothing is drawn before somebody asks for it
        self.player.set_times(sorted(times | ends))
        self.player.blockSignals(False)

    def show_row(self, index):
        """All parts at the time of a row, its two in another colour, and the line."""
        self.wanted = index
        if index is None:
            if self.line is not None:
                self.line.hide()
            return
        if self._ready():
            self._draw_row(index)

    def _draw_row(self, index):
        pair = self.whole["pairs"][index]
        row = pair["clearance"]
        self.player.go_to(row["time_seconds"])
        self.wanted = index  # go_to() forgot it
        self._place(row["time_seconds"], (pair["first"], pair["second"]))
        ends = row["point_on_body"], row["point_on_neighbour"]
        deep = row.get("penetration", {}) if row["verdict"] == "clash" else {}
        if deep:
            ends = deep["point"], deep["surface"]
        length = quantities.quantity(deep.get("depth", row["distance"]), quantities.TABLE_DIGITS)
        text = translate("Panels", "{0} deep").format(length) if deep else length
        middle = [(a + b) / 2.0 for a, b in zip(*ends)]
        self.line.show(middle, [text], ends, bool(deep))

    @guard.told
    def _look(self):
        """The camera goes to the row."""
        items = self.table.selectedItems()
        if items and self.wanted is not None and self.ghosts is not None:
            row = self.report["neighbours"][self.wanted]
            pair = self.whole["pairs"][self.wanted]
            marked = self._numbers((pair["first"], pair["second"]))
            zoom_to(np.vstack([self.points[k] for k in marked]), row)

    def _numbers(self, names):
        """Which of the moving parts have these names."""
        return [k for k, name in enumerate(self.names) if name in names]

    @guard.told
    def _moved(self):
        """The player stands at another time."""
        if getattr(self, "report", None) is None or not self.result.isVisible():
            return
        self.wanted = None
        if self.line is not None:
            self.line.hide()
        if self.player.times and self._ready():
            self._place(self.player.now())

    def _place(self, time, names=()):
        self.ghosts.show([course(time) for course in self.courses], self._numbers(names))

    # --- the parts, read beside the window

    def _ready(self):
        """Whether the parts are drawn; else they are read, and what is wanted follows."""
        if self.ghosts is not None:
            return True
        if self.shapes is None and self.obj is not None:
            plan = mechanism.Plan.of(self.obj)
            names = plan.names()
            self.names = [names[pair] for pair in plan.pairs]
            self.shapes = runner.start(ShapesTask(plan, MOVING_TRIANGLES))
            self.shapes.ended.connect(self._read)
        return False

    @guard.told
    def _read(self, run):
        self.shapes = None
        if run.state != "ok" or not widgets.alive(self.document):
            return
        self.courses = [course for _, _, course in run.task.found]
        self.points = [np.asarray(drawn[0], dtype=float) for drawn, _, _ in run.task.found]
        self.ghosts = MovingParts(self.document, [found[:2] for found in run.task.found])
        self.line = LiveDistance(self.document)
        if self.wanted is not None:
            self._draw_row(self.wanted)
        else:
            self._place(self.player.now())

    def clear_view(self):
        """Nothing is drawn any more; the parts are read again when they are wanted."""
        self.player.stop()
        if self.shapes is not None:
            self.shapes.ended.disconnect(self._read)
            self.shapes.cancel()
        if widgets.alive(self.document):
            for drawn in (self.ghosts, self.line):
                if drawn is not None:
                    drawn.remove()
        self.shapes, self.ghosts, self.line, self.courses = None, None, None, []

    def standing_rows(self):
        plan = mechanism.Plan.of(self.obj)
        parts = {name: pair for pair, name in plan.names().items() if pair not in plan.pairs}
        return [
            (parts[name], pair["clearance"])
            for pair in self.whole["pairs"]
            for name in (pair["first"], pair["second"])
            if name in parts
        ]

    def leave(self):
        super().leave()
        self.clear_view()
