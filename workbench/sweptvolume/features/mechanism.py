# SPDX-License-Identifier: LGPL-2.1-or-later
"""Mechanism check: smallest distances between all pairs of several parts that move at the same
time, and to parts that stand still; kept in the document (core: docs/clearance.md,
"Mechanisms")."""
import json
import sys

import numpy as np

from .. import core
from ..texts import translate
from . import check, mechanism_table, neighbour_rules, pair_rules
from .base import (  # noqa: F401 (the states are read from here as well)
    NOT_COMPUTED,
    UP_TO_DATE,
    add_object,
    inputs_and_results,
    kind_of,
    stored,
)
from .check import Check, fail  # noqa: F401 (fail is read from here as well)
from .clearance import POSE, ROW
from .mechanism_plan import Plan
from .mechanism_properties import INPUT, RESULT

TYPE = "App::FeaturePython"

#: The entries of a stored report that are used, with their shapes (base.fits()).
REPORT = {
    "summary": str,
    "required": float,
    "range": float,
    "from_seconds": float,
    "to_seconds": float,
    "far_pairs": int,
    "pairs": [
        {"first": str, "second": str, "required": float, "pose_of_second": POSE, "clearance": ROW}
    ],
    "joined": [(str, str)],
    "ignored": [(str, str)],
}


class Mechanism(Check):
    """Proxy of the mechanism check."""

    KIND = "SweptVolume::Mechanism"
    PLAN = Plan
    RULES = pair_rules

    def properties(self):
        return inputs_and_results(INPUT, RESULT)

    def report_of(self, obj):
        return report_of(obj)

    def summary(self, report):
        return mechanism_table.summary(report)


def is_mechanism(obj):
    return kind_of(obj) == Mechanism.KIND


class Outcome:
    """The report (dict) and the notes to show."""

    def __init__(self, report, notes):
        self.report, self.notes = report, notes


def work(request, control):
    """Runs the check, in any thread. Raises core.CoreError, InputProblem."""
    rows = request.rows()
    options = dict(request.options, rules=request.own_rules())
    report = core.mechanism(rows, options, control)
    places = {part.name: part.place for part in request.parts}
    report["places"] = [places[name] for name in report["parts"]]
    return Outcome(report, request.notes)


def apply(obj, outcome, hash_at_start):
    """Writes the result of a check into the object."""
    report = dict(outcome.report, notes=outcome.notes)
    obj.Report = json.dumps(report)
    obj.Summary = mechanism_table.summary(report)
    obj.Checked = mechanism_table.count(report)
    obj.Verdict = mechanism_table.worst(report)
    obj.Smallest = mechanism_table.smallest(report)
    check.keep(obj, hash_at_start)


def offered(request, control):
    """Returns {key of pair_rules: Rule}, the rules that would allow the contacts at the beginning
    of the common time. Any thread. Raises core.CoreError, InputProblem."""
    request.rows()
    parts = request.parts
    start = max(float(part.run.times[0]) for part in parts if part.moves())
    placed = [(part, part.points_at(start)) for part in parts]
    still = np.array([0.0]), np.zeros((1, 3)), np.array([[0.0, 0.0, 0.0, 1.0]])
    found = {}
    for k, (one, points) in enumerate(placed):
        control.enter(k, len(placed))
        beside = [
            (other, there)
            for other, there in placed[k + 1 :]
            if (one.moves() or other.moves())
            and _boxes_meet(points, there, one.chord + other.chord)
        ]
        rows = [(o.name, there, o.body.triangles, o.chord, None) for o, there in beside]
        body = core.Request(core.Triangles(points, one.body.triangles), *still, "none", {})
        options = {"tolerance": request.options["tolerance"], "body_chord": one.chord}
        texts = core.first_contacts(body, rows, options, control) if rows else []
        for (other, _), text in zip(beside, texts):
            if text:
                pair = pair_rules.key(one.pair, other.pair)
                found[pair] = neighbour_rules.from_text(text)
    return found


def _boxes_meet(a, b, slack):
    """Returns whether the boxes of two sets of points come closer than slack (mm) along each axis."""
    gaps = np.maximum(a.min(axis=0) - b.max(axis=0), b.min(axis=0) - a.max(axis=0))
    return bool((gaps <= slack).all())


def compute(obj, control=None):
    """Runs the check in this thread (for scripts without a GUI) as one undo step. Raises
    core.CoreError."""
    title = translate("SweptVolume", "Check mechanism")
    return check.compute(obj, sys.modules[__name__], title, control).report


def report_of(obj):
    """Returns the stored report (dict), or None if there is none or it is damaged."""
    return stored(obj.Report, REPORT)


def make_mechanism(document, label=None, **settings):
    """Creates a mechanism check, not yet computed. `settings`: property names with values."""
    label = label or translate("SweptVolume", "Mechanism")
    view = "sweptvolume.views.mechanism_view:MechanismView"
    return add_object(document, TYPE, "Mechanism", Mechanism, label, settings, view)
