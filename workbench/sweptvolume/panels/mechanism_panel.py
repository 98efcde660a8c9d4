# SPDX-License-Identifier: LGPL-2.1-or-later
"""Task panel of a mechanism check: parts with their motions, parts that stand still, rules of
pairs, run, result. Writes nothing to the document before a run has succeeded, except motions
from a driver or a simulation."""
import FreeCADGui as Gui

from ..convert import InputProblem, label_of
from ..features import mechanism, pair_rules
from ..features.clearance_properties import ACCURACY_HELP
from ..texts import translate
from . import focus, guard, selection, widgets
from .check_run import CheckRun
from .mechanism_result import ResultPanel
from .moving_box import MovingBox
from .rules_table import RulesTable
from .tasks import MechanismTask, PairContactsTask
from .widgets import QtWidgets

DEFAULTS = {"RequiredDistance": 5.0, "Accuracy": 0.01, "MeshDeflection": 0.05, "Range": 0.0}
#: If there are more pairs, the table lists only those that came close or have a rule.
MOST_PAIRS = 300


class MechanismPanel(CheckRun, ResultPanel):
    """Creates a new check (obj None), or shows and repeats an existing one."""

    TASK = MechanismTask
    CONTACTS = PairContactsTask

    def __init__(self, document, pairs=(), motions=(), obj=None):
        self.document, self.obj, self.run, self.report = document, obj, None, None
        self.rules, self.neighbours, all_visible, values = {}, [], False, DEFAULTS
        self.listed = None
        if obj is not None:
            plan = mechanism.Plan.of(obj)
            pairs, motions, self.neighbours = plan.pairs, plan.motions, plan.neighbours
            self.rules, all_visible, values = plan.pair_rules, plan.all_visible, plan.values
        title = translate("SweptVolume", "Mechanism")
        self.form, self.layout = widgets.window(title, "SweptVolume_Mechanism")
        self.box = widgets.RunBox()
        self.message = widgets.message_label()
        self.layout.addWidget(self.box)
        self.layout.addWidget(self.message)
        self.moving = MovingBox(document, pairs, motions, self.layout, self.message)
        self._build_inputs(all_visible, values)
        self._build_result()
        self.moving.changed.connect(self.show_inputs)
        self.show_inputs()
        self.show_result()
        if obj is not None and plan.lost:
            widgets.show_message(self.message, plan.lost)
        self.watch = self.watched()

    # --- building

    def _build_inputs(self, all_visible, values):
        rows = widgets.group(translate("SweptVolume", "Check"), self.layout)
        self.all = widgets.check_box(
            translate("SweptVolume", "All visible"),
            bool(all_visible),
            translate("SweptVolume", "All other visible parts are neighbours that stand still"),
        )
        self.all.setObjectName("SweptVolumeStanding")
        self.chosen = QtWidgets.QLabel()
        self.chosen.setWordWrap(True)
        self.take = QtWidgets.QPushButton(translate("SweptVolume", "Ta&ke selected as neighbours"))
        self.take.setObjectName("SweptVolumeTakeStanding")
        self.asked = RulesTable(
            "SweptVolumePairRules",
            translate("SweptVolume", "Distance"),
            height=130,
            label=pair_rules.label_of,
            title=translate("SweptVolume", "Pair"),
        )
        self.touching = widgets.hint(
            QtWidgets.QPushButton(translate("SweptVolume", "Allow initial con&tacts")),
            translate(
                "SweptVolume",
                "Allows contact between parts that touch at the start, for example at their joints",
            ),
        )
        self.touching.setObjectName("SweptVolumeTouchingPairs")
        for widget in (self.all, self.chosen, self.take, self.asked, self.touching):
            rows.addRow(widget)
        self.fields = {
            "RequiredDistance": (translate("SweptVolume", "Required distance"), 0.0, 0.5),
            "Range": (translate("SweptVolume", "Range"), 0.0, 1.0),
            "Accuracy": (translate("SweptVolume", "Accuracy"), 1e-6, 0.01),
            "MeshDeflection": (translate("SweptVolume", "Mesh deflection"), 1e-4, 0.01),
        }
        for name, (text, least, step) in self.fields.items():
            field = widgets.length(values[name], least, step)
            field.setObjectName("SweptVolumeMechanism" + name)
            rows.addRow(text, field)
            self.fields[name] = field
        tip = translate(
            "SweptVolume",
            "Pairs of parts that come closer than this length are listed. 0: a tenth of the "
            "median size of the parts, or more if a rule needs it",
        )
        widgets.hint(self.fields["Range"], tip)
        widgets.hint(self.fields["Accuracy"], translate("App::Property", ACCURACY_HELP))
        self.check = QtWidgets.QPushButton(translate("SweptVolume", "Check"))
        self.check.setObjectName("SweptVolumeCheckMechanism")
        self.check.setDefault(True)  # Enter presses this button
        rows.addRow(self.check)
        self.check.clicked.connect(lambda *ignored: self.start())
        self.touching.clicked.connect(lambda *ignored: self.allow_touching())
        self.take.clicked.connect(lambda *ignored: self._take())
        self.all.toggled.connect(lambda *ignored: self.show_inputs())

    # --- inputs

    @guard.shows_problems
    def _take(self):
        moving = self.moving.pairs
        self.neighbours = [pair for pair in selection.parts() if pair not in moving]
        self.all.setChecked(False)
        self.show_inputs()

    def plan(self):
        values = {name: float(f.property("rawValue")) for name, f in self.fields.items()}
        pairs, motions, standing = self.moving.pairs, self.moving.motions, self.all.isChecked()
        plan = mechanism.Plan(self.document, pairs, motions, self.neighbours, standing, values)
        plan.pair_rules = pair_rules.merged(self.rules, self.asked.pairs, self.asked.rules())
        return plan

    def renew_inputs(self):
        self.neighbours = [pair for pair in self.neighbours if widgets.alive(pair[0])]
        self.show_inputs()

    @guard.shows_problems
    def show_inputs(self):
        """Shows the parts that stand still, and the pairs with their rules."""
        try:
            plan = self.plan()
            standing, pairs = plan.leaves(), self._listed(plan)
        except (InputProblem, RuntimeError) as problem:
            self.chosen.setText(str(problem))
            return
        names = [label_of(*pair) for pair in standing]
        more = "" if len(names) <= 6 else " ..."
        text = translate("SweptVolume", "{0} neighbours that stand still: {1}")
        self.chosen.setText(text.format(len(names), (", ".join(names[:6]) or "-") + more))
        new = [pair for pair in pairs if pair not in self.asked.pairs]
        listed = pairs, [pair_rules.label_of(pair) for pair in pairs]
        if listed != self.listed:  # otherwise the user may be editing a rule
            self.rules = plan.pair_rules  # includes rules of parts that are hidden now
            self.asked.show_pairs(pairs, {p: pair_rules.of(self.rules, *p) for p in new})
            self.listed = listed

    def _listed(self, plan):
        """Returns the pairs that the table lists."""
        if plan.count_pairs() <= MOST_PAIRS:
            return plan.checked_pairs()
        near, rules = self._near(plan), self.rules
        found = plan.checked_pairs() if near or rules else []
        return [p for p in found if p in near or rules and pair_rules.of(rules, *p).asks()]

    def _near(self, plan):
        """Returns the keys of the pairs in the stored result."""
        report = mechanism.report_of(self.obj) if self.obj is not None else None
        parts = {name: pair for pair, name in plan.names().items()}
        rows = report["pairs"] if report else []
        names = [(row["first"], row["second"]) for row in rows]
        return {pair_rules.key(parts[a], parts[b]) for a, b in names if a in parts and b in parts}

    # --- run

    def label_of(self, pair):
        return pair_rules.label_of(pair)

    def check_succeeded(self, plan):
        self.rules = plan.pair_rules
        Gui.Selection.clearSelection()
        self.show_inputs()


def show(document, **given):
    panel = MechanismPanel(document, **given)
    focus.show(panel)
    return panel
