# SPDX-License-Identifier: LGPL-2.1-or-later
"""Sequence: parts that are installed one after the other, each on its own motion, clear of all
parts installed before. It is kept in the document (core: docs/paths.md, "Sequences").

The paths that are found become motion objects. The sequence holds them in the order of the parts,
and shows whether they are still the certified ones. Recomputing the object checks its motions
again."""
import json

import numpy as np

from .. import core, core_paths, quantities
from ..core_texts import said
from ..texts import translate
from . import check, pair_rules, path_plan
from .base import add_object, inputs_and_results, kind_of, stored
from .check import Check, fail  # noqa: F401 (fail is read from here as well)
from .sequence_plan import Plan
from .sequence_properties import INPUT, RESULT

TYPE = "App::FeaturePython"
#: Number of obstacles named for a part, the worst first.
MOST_NAMES = 3

#: The entries of a stored report that are used, with their shapes (base.fits()).
REPORT = {
    "verdict": {"found", "not_found", "no_order"},
    "required": float,
    "steps": [{"part": str, "verdict": str, "summary": str}],
}
_TIMED = {"begin": float, "end": float, "length": float}


class Sequence(Check):
    """Proxy of the sequence."""

    KIND = "SweptVolume::Sequence"
    PLAN = Plan
    RULES = pair_rules

    def properties(self):
        return inputs_and_results(INPUT, RESULT)

    def report_of(self, obj):
        return report_of(obj)

    def summary(self, report):
        return summary(report)


def is_sequence(obj):
    return kind_of(obj) == Sequence.KIND


class Outcome:
    """report: dict, docs/paths.md; notes; order: for each step, the index of its part in the
    request; found: {index: Poses} for each part that was searched for and has a path."""

    def __init__(self, report, notes, order, found):
        self.report, self.notes, self.order, self.found = report, notes, order, found

    def is_found(self):
        return self.report["verdict"] == "found"


def work(request, control, seen=None):
    """Runs the search, in any thread. Raises core.CoreError, InputProblem."""
    rows = request.parts()
    options = dict(request.options, rules=request.own_rules())
    order = request.search["Order"]
    report = core_paths.find_sequence(rows, request.standing(), order, options, control, seen)
    numbers = {row.part.name: k for k, row in enumerate(request.rows)}
    report["places"] = [request.rows[numbers[name]].part.place for name in report["parts"]]
    standing = {part.name: part.place for part in request.still}
    report["still_places"] = [standing[name] for name in report["still"]]
    found = {}
    for step in report["steps"]:
        row = request.rows[numbers[step["part"]]]
        if step["verdict"] == "found" and row.pivot is not None:
            found[numbers[step["part"]]] = path_plan.poses_from(_keys(step), row.pivot)
    return Outcome(report, request.notes, [numbers[s["part"]] for s in report["steps"]], found)


def _keys(step):
    poses = step["path"]
    return (
        np.array([pose["t"] for pose in poses]),
        np.array([pose["translation"] for pose in poses]),
        np.array([pose["quaternion_xyzw"] for pose in poses]),
    )


def make_motions(plan, outcome):
    """Creates motions from the paths that were found, and puts the parts of the plan into the order
    that was found."""
    motions = [
        motion or path_plan.make(plan.document, [pair], outcome.found[k])
        for k, (pair, motion) in enumerate(zip(plan.pairs, plan.motions))
    ]
    plan.take(outcome.order, motions)


def apply(obj, outcome, hash_at_start):
    """Writes the result of a search that found all paths into the object."""
    report = dict(outcome.report, notes=outcome.notes)
    obj.Report = json.dumps(report)
    obj.Summary = summary(report)
    obj.Checked = sum(step["verdict"] == "found" for step in report["steps"])
    obj.Verdict = "clear" if outcome.is_found() else "clash"
    obj.Smallest = max(report.get("clearance", 0.0), 0.0)
    check.keep(obj, hash_at_start)


def summary(report):
    """Returns the result in one line."""
    found = sum(step["verdict"] == "found" for step in report["steps"])
    if report["verdict"] != "found":
        text = translate("SweptVolume", "{0} of {1} parts have a path")
        return text.format(found, len(report["steps"]))
    names = ", ".join(step["part"] for step in report["steps"])
    text = translate("SweptVolume", "{0} parts, in this order: {1}").format(found, names)
    if "clearance" in report:
        more = translate("SweptVolume", "clearance at least {0}")
        text += "; " + more.format(quantities.quantity(report["clearance"]))
    return text


def step_text(step):
    """Returns the text about one part."""
    if step["verdict"] == "found":
        length = quantities.quantity(step["length"])
        if step.get("clearance") is None:
            return translate("SweptVolume", "path of {0}, no obstacles").format(length)
        return translate("SweptVolume", "path of {0}, clearance {1}").format(
            length, quantities.quantity(step["clearance"])
        )
    blockers = step["escape"]["blockers"]
    if step["verdict"] == "no_translation":
        return translate("SweptVolume", "it is proven that no path exists without turning the part")
    if not blockers:
        return step["summary"]
    names = ", ".join('"{}"'.format(name) for name in blockers[:MOST_NAMES])
    return translate("SweptVolume", "no path found; blocked by {1} after {0} of travel").format(
        quantities.quantity(step["escape"]["distance"]), names
    )


def description(report):
    """Returns all texts about a report."""
    lines = [summary(report)]
    if report["verdict"] == "no_order":
        lines.append(
            translate(
                "SweptVolume",
                "It is proven that the parts cannot be installed one after the other "
                "in any order.",
            )
        )
    for step in report["steps"]:
        if step["verdict"] != "found":
            lines.append('"{}": {}'.format(step["part"], step_text(step)))
    lines += [said(w["code"], w["text"]) for w in report["warnings"]]
    return "\n".join(lines)


def compute(obj, control=None):
    """Checks the motions again in this thread (for scripts without a GUI) as one undo step. Raises
    core.CoreError."""
    import sys

    title = translate("SweptVolume", "Check sequence")
    return check.compute(obj, sys.modules[__name__], title, control).report


def find(plan, control=None):
    """Searches in this thread (for scripts without a GUI) as one undo step. Returns (report,
    sequence or None). Raises core.CoreError, InputProblem."""
    outcome = work(plan.request(), control or core.Control())
    if not outcome.is_found():
        return outcome.report, None
    plan.document.openTransaction(translate("SweptVolume", "Sequence"))
    obj = keep(plan, outcome)
    plan.document.commitTransaction()
    return outcome.report, obj


def keep(plan, outcome, obj=None):
    """Returns the object (a new one unless given) with the motions of a search that found all
    paths."""
    make_motions(plan, outcome)
    if obj is None:
        obj = make_sequence(plan.document)
    plan.write(obj)
    apply(obj, outcome, plan.hash())
    obj.purgeTouched()
    return obj


def report_of(obj):
    """Returns the stored report (dict), or None if there is none or it is damaged."""
    report = stored(obj.Report, REPORT)
    if report is not None and report["verdict"] == "found":
        return stored(obj.Report, dict(REPORT, steps=[dict(REPORT["steps"][0], **_TIMED)]))
    return report


def make_sequence(document, label=None, **settings):
    """Creates a sequence, not yet computed. `settings`: property names with values."""
    label = label or translate("SweptVolume", "Sequence")
    view = "sweptvolume.views.sequence_view:SequenceView"
    return add_object(document, TYPE, "Sequence", Sequence, label, settings, view)
