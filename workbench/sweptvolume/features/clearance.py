# SPDX-License-Identifier: LGPL-2.1-or-later
"""Clearance: smallest distances of a moving part to its neighbours, kept in the document.

As with the envelope, `execute` only marks; a run is Plan.request() - work() - apply(). The distances
come from the true motion; the envelope, where one is given, is only coloured by them.
"""
import contextlib
import json

import numpy as np

from .. import convert, core
from ..convert import InputProblem
from ..core_texts import said
from ..texts import mark, translate
from . import containers, missing, neighbour_rules, status
from .base import (  # noqa: F401 (the states are read from here as well)
    CANCELLED,
    FAILED,
    HIDDEN,
    NOT_COMPUTED,
    READ_ONLY,
    STALE,
    UP_TO_DATE,
    Feature,
    attach_view,
    kind_of,
    quietly,
    set_changed,
    stored,
)
from .clearance_plan import Plan
from .clearance_properties import INPUT, RESULT
from .clearance_table import summary, worst
from .neighbour_rules import PARTS_PROPERTY

TYPE = "App::FeaturePython"
FAR = 1e9  # mm, where nothing stands

#: Verdict of the core -> what people read.
VERDICTS = {
    "clear": mark("Messages", "Clear"),
    "below": mark("Messages", "Too near"),
    "contact": mark("Messages", "Contact"),
    "clash": mark("Messages", "Clash"),
}
_POINT = (float, float, float)
#: What is read of a stored report.
REPORT = {
    "summary": str,
    "required": float,
    "neighbours": [
        {
            "name": str,
            "verdict": set(VERDICTS),
            "distance": float,
            "guaranteed": float,
            "time_seconds": float,
            "pose": {"translation": _POINT, "quaternion_xyzw": (float,) * 4},
            "point_on_body": _POINT,
            "point_on_neighbour": _POINT,
            "below": [(float, float)],
            "curve": [(float, float)],
        }
    ],
}
containers.watch()
missing.watch()


class Clearance(Feature):
    """Proxy of the clearance check."""

    KIND = "SweptVolume::Clearance"

    def properties(self):
        given = [(k, n, "Input", text, default, 0) for k, n, text, default in INPUT]
        return given + [(k, n, "Result", text, None, mode) for k, n, text, mode in RESULT]

    def __init__(self, obj):
        super().__init__(obj)
        obj.Status = NOT_COMPUTED

    def execute(self, obj):
        """Marks the result stale or current; keeps it."""
        follow_all_visible(obj)
        update_status(obj)

    def look(self, obj):
        update_status(obj)

    def onChanged(self, obj, name):
        missing.changed(obj, name)

    def shortened(self, obj):
        """Links begin below the groups around the check, those of rules too."""
        if PARTS_PROPERTY in obj.PropertiesList:
            with contextlib.suppress(InputProblem):
                neighbour_rules.write(obj, neighbour_rules.read(obj))

    def lost(self, obj, gone):
        neighbour_rules.drop(obj, gone)

    def onDocumentRestored(self, obj):
        of_before = "Seen" not in obj.PropertiesList
        with quietly(obj):
            super().onDocumentRestored(obj)
            containers.shorten(obj)  # documents of before may have circles
            if of_before:
                follow_all_visible(obj)
                plan = Plan.of(obj)
                status.renew(obj, status.hash_or_problem(plan.hash_of_before)[0], plan.hash())


def is_clearance(obj):
    return kind_of(obj) == Clearance.KIND


class Outcome:
    """Report (dict) and the distance at each point of the envelope (or None)."""

    def __init__(self, report, distances, notes):
        self.report = report
        self.distances = distances
        self.notes = notes


def work(request, control):
    """Any thread: the check itself. Raises core.CoreError, InputProblem."""
    neighbours = request.rows()
    report = core.clearance(request.body, neighbours, request.options, control)
    if request.ignored:
        report["ignored"] = request.ignored
    distances = None
    if request.points is not None:
        distances = np.full(len(request.points), FAR)
        for _, vertices, triangles, _, rule in neighbours:
            if rule is not None and rule.startswith("contact"):
                continue  # what is meant to touch would hide what comes near
            found = core.distance_to_mesh(request.points, vertices, triangles, control)
            distances = np.minimum(distances, found)
    return Outcome(report, distances, request.notes)


def apply(obj, outcome, hash_at_start):
    """Writes the result of a check."""
    report = dict(outcome.report, notes=outcome.notes)
    obj.Report = json.dumps(report)
    obj.Summary = summary(report)
    obj.Checked = len(report["neighbours"])
    obj.Verdict = worst(report)
    obj.Smallest = report["neighbours"][report["smallest"]]["distance"]
    obj.MapDistances = [] if outcome.distances is None else [float(d) for d in outcome.distances]
    obj.InputHash, obj.TriedHash = hash_at_start, ""
    follow_all_visible(obj)
    update_status(obj)


def first_contacts(plan, control=None):
    """What touches at the first pose of a plan's motion: {(root, sub): Rule} that would allow it. Raises
    core.CoreError, InputProblem."""
    request = plan.request()
    return contacts_from(request, offered(request, control or core.Control()))


def offered(request, control):
    """Any thread: the rules, as texts, of the neighbours of a request."""
    return core.first_contacts(request.body, request.rows(), request.options, control)


def contacts_from(request, texts):
    """The rules of offered(), by parts."""
    found = zip((n.pair for n in request.neighbours), texts)
    return {pair: neighbour_rules.from_text(text) for pair, text in found if text}


def notes_of(obj):
    """What is to be said of the stored result."""
    report = report_of(obj) if obj.Report else None
    if report is None:
        return ""
    found = [said(w["code"], w["text"]) for w in report.get("warnings", [])]
    return "\n".join(list(report.get("notes", [])) + found)


def fail(obj, text, tried, cancelled=False):
    """Remembers a run that gave nothing; the stored result stays. tried: hash of its inputs."""
    status.mark_failure(obj, Plan.of(obj).hash, text, tried, cancelled)


def follow_all_visible(obj):
    """Links to all that AllVisible looks at, hidden things too: what is shown, moved or changed there
    then makes the result stale. Not to what depends on the check itself."""
    found = []
    if obj.AllVisible:
        above = set(obj.InListRecursive)
        roots = [
            root
            for root, _ in containers.links_for(obj, [(o, "") for o in Plan.of(obj).candidates()])
        ]
        found = [o for o in roots if o not in above and o is not obj]
    if obj.Seen != found:
        obj.Seen = found


def update_status(obj):
    """Compares inputs and stored result."""
    plan = Plan.of(obj)
    now, problem, waits = status.inputs_of(obj, plan.words, plan.checked_hash)
    if waits:
        return
    waiting = any(map(status.is_behind, plan.objects() + convert.targets(plan.neighbours)))
    status.judge(obj, now, problem, waiting, notes_of(obj))


def compute(obj, control=None):
    """Checks in this thread (scripts, no GUI): one undo step. Raises core.CoreError."""
    plan = Plan.of(obj)
    hash_at_start = plan.hash()
    try:
        outcome = work(plan.request(), control or core.Control())
    except (core.CoreError, InputProblem) as error:
        fail(obj, str(error), hash_at_start, getattr(error, "status", "") == "Cancelled")
        raise
    obj.Document.openTransaction(translate("Messages", "Check clearance"))
    apply(obj, outcome, hash_at_start)
    obj.purgeTouched()
    obj.Document.commitTransaction()
    return outcome.report


def report_of(obj):
    """The stored report (dict); None if there is none, or a damaged one."""
    return stored(obj.Report, REPORT)


def make_clearance(document, label=None, **settings):
    """A clearance object, not yet computed. `settings` are property names with values."""
    obj = document.addObject(TYPE, "Clearance")
    Clearance(obj)
    obj.Label = label or translate("Messages", "Clearance")
    for name, value in settings.items():
        setattr(obj, name, value)
    attach_view(obj, "sweptvolume.views.clearance_view:ClearanceView")
    return obj
