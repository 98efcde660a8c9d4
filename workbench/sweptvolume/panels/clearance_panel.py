# SPDX-License-Identifier: LGPL-2.1-or-later
"""Task panel of a clearance check: inputs, run, table, graph, colours, export. Writes nothing to
the document before a run has succeeded."""
import contextlib

import FreeCADGui as Gui

from ..convert import InputProblem, label_of
from ..features import clearance, motion, neighbour_rules
from ..features.base import objects_of_kind
from ..features.clearance_properties import ACCURACY_HELP
from ..features.envelope import Envelope
from ..features.envelope_plan import Plan as EnvelopePlan
from ..texts import translate
from . import focus, guard, selection, widgets
from .check_run import CheckRun
from .clearance_result import ResultPanel
from .rules_table import RulesTable
from .tasks import ClearanceTask, FirstContactsTask
from .widgets import QtWidgets

DEFAULTS = {"RequiredDistance": 5.0, "Accuracy": 0.01, "MeshDeflection": 0.05}


class ClearancePanel(CheckRun, ResultPanel):
    """Creates a new check (obj None), or shows and repeats an existing one."""

    TASK = ClearanceTask
    CONTACTS = FirstContactsTask

    def __init__(self, document, envelope=None, pairs=(), motion_obj=None, neighbours=(), obj=None):
        self.document = document
        self.obj = obj
        self.run, self.hidden = None, None  # hidden: the envelope hidden by its coloured copy
        self.rules, self.listed = {}, None
        values, all_visible = DEFAULTS, not neighbours
        if obj is not None:
            plan = clearance.Plan.of(obj)
            envelope, pairs, motion_obj = plan.envelope, plan.pairs, plan.motion
            neighbours, all_visible, values = plan.neighbours, plan.all_visible, plan.values
            self.rules = plan.rules
        self.pairs, self.motion, self.neighbours = list(pairs), motion_obj, list(neighbours)
        title = translate("SweptVolume", "Clearance")
        self.form, self.layout = widgets.window(title, "SweptVolume_Clearance")
        self.box = widgets.RunBox()
        self.message = widgets.message_label()
        self.layout.addWidget(self.box)
        self.layout.addWidget(self.message)
        self._build_inputs(envelope, all_visible, values)
        self._build_result()
        self._show_neighbours()
        self.show_result()
        if obj is not None and plan.lost:
            widgets.show_message(self.message, plan.lost)
        self.watch = self.watched()

    # --- building

    def _build_inputs(self, envelope, all_visible, values):
        rows = widgets.group(translate("SweptVolume", "Check"), self.layout)
        names = [o.Name for o in objects_of_kind(self.document, Envelope.KIND)]
        texts = [self.document.getObject(n).Label for n in names]
        own = translate("SweptVolume", "(parts and motion below)")
        now = (
            envelope.Name if envelope is not None else ("" if self.pairs or not names else names[0])
        )
        self.source = widgets.choice([""] + names, now, [own] + texts)
        self.source.setObjectName("SweptVolumeClearanceSource")
        rows.addRow(translate("SweptVolume", "Envelope"), self.source)
        motions = objects_of_kind(self.document, motion.Motion.KIND)
        self.path = widgets.choice(
            [o.Name for o in motions],
            self.motion.Name if self.motion is not None else "",
            [o.Label for o in motions],
        )
        if self.obj is not None and self.motion is None and envelope is None:
            self.path.setCurrentIndex(-1)  # a missing motion must not be replaced silently
        self.moving = QtWidgets.QLabel(", ".join(label_of(*p) for p in self.pairs) or "-")
        rows.addRow(translate("SweptVolume", "Moving parts"), self.moving)
        rows.addRow(translate("SweptVolume", "Motion"), self.path)
        self.all = widgets.check_box(
            translate("SweptVolume", "All visible"),
            bool(all_visible),
            translate("SweptVolume", "All other visible parts are neighbours"),
        )
        self.chosen = QtWidgets.QLabel()
        self.chosen.setWordWrap(True)
        self.take = QtWidgets.QPushButton(translate("SweptVolume", "Ta&ke selected as neighbours"))
        self.take.setObjectName("SweptVolumeTakeNeighbours")
        rows.addRow(self.all)
        rows.addRow(self.chosen)
        rows.addRow(self.take)
        self._build_rules(rows)
        self.required = widgets.length(values["RequiredDistance"], 0.0, 0.5)
        self.tolerance = widgets.hint(
            widgets.length(values["Accuracy"], 1e-6, 0.01),
            translate("App::Property", ACCURACY_HELP),
        )
        self.deflection = widgets.length(values["MeshDeflection"], 1e-4, 0.01)
        rows.addRow(translate("SweptVolume", "Required distance"), self.required)
        rows.addRow(translate("SweptVolume", "Accuracy"), self.tolerance)
        rows.addRow(translate("SweptVolume", "Mesh deflection"), self.deflection)
        self.check = QtWidgets.QPushButton(translate("SweptVolume", "Check"))
        self.check.setObjectName("SweptVolumeCheck")
        self.check.setDefault(True)  # Enter presses this button
        rows.addRow(self.check)
        self.check.clicked.connect(lambda *ignored: self.start())
        self.take.clicked.connect(lambda *ignored: self._take())
        self.all.toggled.connect(lambda *ignored: self._show_neighbours())
        self.source.currentIndexChanged.connect(lambda *ignored: self._show_neighbours())

    def _build_rules(self, rows):
        self.asked = RulesTable(
            "SweptVolumeRules", translate("SweptVolume", "Distance"), height=130
        )
        self.touching = widgets.hint(
            QtWidgets.QPushButton(translate("SweptVolume", "Allow initial con&tacts")),
            translate(
                "SweptVolume",
                "Allows contact with the neighbours that the moving parts touch at the first pose",
            ),
        )
        self.touching.setObjectName("SweptVolumeTouching")
        self.touching.clicked.connect(lambda *ignored: self.allow_touching())
        rows.addRow(self.asked)
        rows.addRow(self.touching)

    # --- inputs

    @guard.shows_problems
    def _take(self):
        self.neighbours = selection.parts()
        self.all.setChecked(False)
        self._show_neighbours()

    def plan(self):
        name = self.source.currentData()
        envelope = self.document.getObject(name) if name else None
        pairs, path = self.pairs, None
        if envelope is not None:
            moving = EnvelopePlan.of(envelope)
            pairs, path = moving.pairs, moving.motion
        elif self.path.currentData():
            path = self.document.getObject(self.path.currentData())
        values = {
            "RequiredDistance": float(self.required.property("rawValue")),
            "Accuracy": float(self.tolerance.property("rawValue")),
            "MeshDeflection": float(self.deflection.property("rawValue")),
        }
        chosen, every = self.neighbours, self.all.isChecked()
        plan = clearance.Plan(self.document, pairs, path, chosen, every, values, envelope)
        plan.rules = neighbour_rules.merged(self.rules, self.asked.pairs, self.asked.rules())
        return plan

    def renew_inputs(self):
        if self.pairs and not all(widgets.alive(root) for root, _ in self.pairs):
            self.pairs = []
        self.neighbours = [pair for pair in self.neighbours if widgets.alive(pair[0])]
        self._show_neighbours()

    @guard.shows_problems
    def _show_neighbours(self):
        try:
            found = self.plan().leaves()
        except (InputProblem, RuntimeError) as problem:
            self.chosen.setText(str(problem))
            self._list([], [])
            return
        names = [label_of(*pair) for pair in found]
        self._list(found, names)
        more = "" if len(names) <= 6 else " ..."
        text = translate("SweptVolume", "Neighbours ({0}): {1}")
        self.chosen.setText(text.format(len(names), ", ".join(names[:6]) + more))
        own = not self.source.currentData()
        self.moving.setText(", ".join(label_of(*p) for p in self.plan().pairs) or "-")
        self.path.setEnabled(own)
        self.moving.setEnabled(own)

    def _list(self, found, names):
        """Shows the rules of these neighbours. Rules of other neighbours are kept for later."""
        if (found, names) == self.listed:  # the user may be editing a rule
            return
        with contextlib.suppress(InputProblem):  # a rule may be unreadable
            self.rules = neighbour_rules.merged(self.rules, self.asked.pairs, self.asked.rules())
        new = [pair for pair in found if pair not in self.asked.pairs]
        self.asked.show_pairs(found, {p: neighbour_rules.of(self.rules, *p) for p in new})
        self.listed = found, names

    # --- run

    def label_of(self, pair):
        return label_of(*pair)

    def check_succeeded(self, plan):
        self.rules = plan.rules
        Gui.Selection.clearSelection()  # the green of the selection would hide the colours
        self.required_band.setProperty("rawValue", self.obj.RequiredDistance.Value)


def show(document, **given):
    panel = ClearancePanel(document, **given)
    focus.show(panel)
    return panel
