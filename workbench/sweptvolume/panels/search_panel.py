# SPDX-License-Identifier: LGPL-2.1-or-later
"""Base of the panels that search for a path between neighbours: neighbours, rules, run, and the
paths found. Each path is a motion and one undo step. Nothing else is written."""
from .. import convert
from ..features import path_plan
from ..texts import translate
from . import guard, paths_table, widgets
from .neighbours_box import NeighboursBox
from .run_panel import StayingPanel
from .widgets import QtWidgets


class SearchPanel(StayingPanel):
    """Subclasses define TITLE, ICON, BUTTON (texts and names), build_task(), build_rules(rows),
    task(), and found(task), which handles the result."""

    def __init__(self, document, pairs):
        self.document, self.pairs, self.run = document, list(pairs), None
        self.form, self.layout = widgets.window(translate("SweptVolume", self.TITLE), self.ICON)
        self.box, self.message = widgets.RunBox(), widgets.message_label()
        self.start_button = QtWidgets.QPushButton(translate("SweptVolume", self.BUTTON))
        self.start_button.setObjectName("SweptVolumeFind")
        self.start_button.setDefault(True)  # Enter presses this button
        self.start_button.clicked.connect(lambda *ignored: self.start())
        for widget in (self.start_button, self.box, self.message):  # visible without scrolling
            self.layout.addWidget(widget)
        self.paths = paths_table.PathsTable(document, self.layout)
        self.build_task()
        self.beside = NeighboursBox(document, lambda: self.pairs, self.layout)
        self._build_rules()
        self.layout.addStretch(1)
        self.watch = self.watched()
        self.beside.take_visible()

    def _build_rules(self):
        rows = widgets.group(translate("SweptVolume", "Rules"), self.layout)
        now = path_plan.DEFAULTS
        self.required = widgets.hint(
            widgets.length(now["RequiredDistance"], 0.0, 0.5),
            translate(
                "SweptVolume",
                "Distance that the path keeps from every neighbour. The default is smaller than "
                "that of a clearance check, because a larger distance closes narrow passages",
            ),
        )
        self.required.setObjectName("SweptVolumePathClearance")
        self.release = widgets.hint(
            widgets.length(now["ReleaseDistance"], 0.0, 5.0),
            translate(
                "SweptVolume",
                "If the part is closer to a neighbour than required at the start or the goal, this "
                "is also allowed nearby: until some point of the part has moved farther than this "
                "length from the start or the goal",
            ),
        )
        self.release.setObjectName("SweptVolumeRelease")
        rows.addRow(translate("SweptVolume", "Required distance"), self.required)
        rows.addRow(translate("SweptVolume", "Release distance"), self.release)
        self.build_rules(rows)
        self.budget = widgets.hint(
            QtWidgets.QDoubleSpinBox(),
            translate(
                "SweptVolume",
                "If no path has been found after this time, the search fails. If one has been "
                "found, the search stops improving it",
            ),
        )
        self.budget.setObjectName("SweptVolumeBudget")
        self.budget.setRange(0.0, 86400.0)
        self.budget.setDecimals(1)
        self.budget.setSuffix(" s")
        self.budget.setValue(now["Budget"])
        self.seed = widgets.hint(
            QtWidgets.QSpinBox(),
            translate(
                "SweptVolume", "The search uses random numbers; another seed may find another path"
            ),
        )
        self.seed.setObjectName("SweptVolumeSeed")
        self.seed.setRange(1, 1000000)
        self.deflection = widgets.length(now["MeshDeflection"], 1e-4, 0.01)
        rows.addRow(translate("SweptVolume", "Time limit"), self.budget)
        rows.addRow(translate("SweptVolume", "Seed"), self.seed)
        rows.addRow(translate("SweptVolume", "Mesh deflection"), self.deflection)

    def rules(self):
        """Returns the values of the fields that all searches have."""
        return {
            "RequiredDistance": float(self.required.property("rawValue")),
            "ReleaseDistance": float(self.release.property("rawValue")),
            "Budget": self.budget.value(),
            "Seed": self.seed.value(),
            "MeshDeflection": float(self.deflection.property("rawValue")),
        }

    def part_text(self):
        none = translate("SweptVolume", "none: select the part, then press Pick")
        return ", ".join(convert.label_of(*p) for p in self.pairs) or none

    @guard.shows_problems
    def take_neighbours(self, pairs):
        self.beside.take(pairs)

    def start(self):
        self.beside.mark([])
        if not self.begin(self.task, self.ended):
            return False
        self.start_button.setEnabled(False)
        return True

    def ended(self, run):
        self.run = None
        if not widgets.alive(self.document):
            return
        self.start_button.setEnabled(True)
        self.box.leave(self.form)
        if run.state != "ok":
            widgets.show_failure(self.message, run)
            return
        if run.task.obj is not None:
            self.paths.add(run.task.obj, run.task.outcome.report)
        self.found(run.task)
