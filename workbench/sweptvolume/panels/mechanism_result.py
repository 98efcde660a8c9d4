# SPDX-License-Identifier: LGPL-2.1-or-later
"""The result of a mechanism check in its panel. A player shows all moving parts at a time. A row of
the table shows its two parts at their smallest distance, with the line between them."""
import numpy as np

from .. import convert
from ..features import clearance_table, mechanism, mechanism_table, shared
from ..texts import QT_TRANSLATE_NOOP
from ..views.clearance_view import zoom_to
from . import guard, played_result
from .played_result import RowScene, gone


class ResultPanel(played_result.PlayedPanel):
    """The panel provides `obj`, `document` and `message`."""

    NAME = QT_TRANSLATE_NOOP("SweptVolume", "Pair")
    TABLE = mechanism_table

    def stored_report(self):
        return mechanism.report_of(self.obj)

    def rows_of(self, report):
        return mechanism_table.as_rows(report)

    def build_more(self, rows):
        self.wanted = None  # what to show after the parts are read: a row, or nothing
        self.build_played(rows)
        self.table.itemDoubleClicked.connect(lambda *ignored: self._zoom_to_row())

    def shown(self):
        self.clear_view()
        times = {row["time_seconds"] for row in self.report["neighbours"]}
        self.set_span(times | {self.whole["from_seconds"], self.whole["to_seconds"]})

    def plan_shown(self):
        plan = mechanism.Plan.of(self.obj)
        names = plan.names()
        self.names = [names[pair] for pair in plan.pairs]
        return plan

    def show_row(self, index):
        """Shows all parts at the time of a row, with the two parts of the row in another colour and
        the shortest line between them."""
        self.wanted = index
        self.show_buttons(index)
        if index is None:
            if self.line is not None:
                self.line.hide()
            return
        if self.ready():
            self._draw_row(index)

    def _draw_row(self, index):
        row = self.whole["pairs"][index]["clearance"]
        self.go_to(row["time_seconds"])
        self.show_parts_at(row["time_seconds"], self.marked(index))
        self.draw_line(*clearance_table.line_of(row))

    @guard.shows_problems
    def _zoom_to_row(self):
        """Moves the camera to the shortest line of the chosen row."""
        if self.chosen_row() >= 0 and self.wanted is not None and self.ghosts is not None:
            marked = self.marked(self.wanted)
            points = np.vstack([self.points[k] for k in marked])
            zoom_to(points, self.report["neighbours"][self.wanted])

    def marked(self, index):
        """Returns the indices of the moving parts of a row."""
        pair = self.whole["pairs"][index]
        return [k for k, name in enumerate(self.names) if name in (pair["first"], pair["second"])]

    def left_row(self):
        self.wanted = None

    def parts_read(self):
        if self.wanted is not None:
            self._draw_row(self.wanted)
        else:
            super().parts_read()

    # --- the two parts of a row

    def _two(self, plan, index):
        """Returns ((root, sub) of both parts, the motions of both). Raises InputProblem."""
        parts = {name: pair for pair, name in plan.names().items()}
        sides = [parts.get(self.whole["pairs"][index][side]) for side in ("first", "second")]
        if None in sides:
            raise gone()
        motions = dict(zip(plan.pairs, plan.motions))
        return sides, [motions.get(pair) for pair in sides]

    def row_scene(self, index):
        plan = mechanism.Plan.of(self.obj)
        seen, deflection = dict(zip(plan.pairs, plan.seen())), plan.seen_deflection()
        found = [
            seen[pair] if pair in seen else (convert.body_from([pair], deflection), None)
            for pair in self._two(plan, index)[0]
        ]
        bodies, courses = zip(*found)
        return RowScene(*bodies, courses, deflection)

    def clash_plan(self, index):
        plan = mechanism.Plan.of(self.obj)
        time = self.report["neighbours"][index]["time_seconds"]
        (first, second), motions = self._two(plan, index)
        return shared.Plan(
            self.document, [first], [second], motions, time, plan.values["MeshDeflection"]
        )

    def standing_rows(self):
        plan = mechanism.Plan.of(self.obj)
        parts = {name: pair for pair, name in plan.names().items() if pair not in plan.pairs}
        return [
            (parts[name], pair["clearance"])
            for pair in self.whole["pairs"]
            for name in (pair["first"], pair["second"])
            if name in parts
        ]
