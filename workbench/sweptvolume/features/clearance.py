# SPDX-License-Identifier: LGPL-2.1-or-later
"""Clearance check: smallest distances of a moving part from its neighbours, kept in the document.

As with the envelope, `execute` only updates the state. A run consists of Plan.request(), work() and
apply(). The distances are measured along the motion, not on an envelope. If an envelope is given,
its points are coloured by distance.
"""
import json
import sys

import numpy as np

from .. import core
from ..texts import QT_TRANSLATE_NOOP, translate
from . import check, containers, missing, neighbour_rules, status
from .base import (  # noqa: F401 (the states are read from here as well)
    CANCELLED,
    FAILED,
    HIDDEN,
    NOT_COMPUTED,
    READ_ONLY,
    STALE,
    UP_TO_DATE,
    add_object,
    inputs_and_results,
    kind_of,
    quietly,
    stored,
)
from .check import Check, fail, follow_all_visible  # noqa: F401 (fail is read from here as well)
from .clearance_plan import Plan
from .clearance_properties import INPUT, RESULT
from .clearance_table import summary, worst

TYPE = "App::FeaturePython"
FAR = 1e9  # mm, distance if there is no neighbour

#: Verdict of the core -> text for users.
VERDICTS = {
    "clear": QT_TRANSLATE_NOOP("SweptVolume", "Clear"),
    "below": QT_TRANSLATE_NOOP("SweptVolume", "Below required"),
    "contact": QT_TRANSLATE_NOOP("SweptVolume", "Contact"),
    "clash": QT_TRANSLATE_NOOP("SweptVolume", "Clash"),
}
_POINT = (float, float, float)
POSE = {"translation": _POINT, "quaternion_xyzw": (float,) * 4}
#: The entries of a row in a stored report that are used, with their shapes (base.fits()).
ROW = {
    "name": str,
    "verdict": set(VERDICTS),
    "distance": float,
    "guaranteed": float,
    "time_seconds": float,
    "pose": POSE,
    "point_on_body": _POINT,
    "point_on_neighbour": _POINT,
    "below": [(float, float)],
    "curve": [(float, float)],
}
REPORT = {"summary": str, "required": float, "neighbours": [ROW]}
containers.watch()
missing.watch()


class Clearance(Check):
    """Proxy of the clearance check."""

    KIND = "SweptVolume::Clearance"
    PLAN = Plan
    RULES = neighbour_rules

    def properties(self):
        return inputs_and_results(INPUT, RESULT)

    def report_of(self, obj):
        return report_of(obj)

    def summary(self, report):
        return summary(report)

    def onDocumentRestored(self, obj):
        from_old_version = "Seen" not in obj.PropertiesList
        with quietly(obj):
            super().onDocumentRestored(obj)
            containers.shorten(obj)  # documents of earlier versions may have circular links
            if from_old_version:
                follow_all_visible(obj)
                plan = Plan.of(obj)
                status.renew(obj, status.hash_or_problem(plan.hash_of_before)[0], plan.hash())


def is_clearance(obj):
    return kind_of(obj) == Clearance.KIND


class Outcome:
    """The report (dict), and the distance at each point of the envelope (or None)."""

    def __init__(self, report, distances, notes):
        self.report = report
        self.distances = distances
        self.notes = notes


def work(request, control):
    """Runs the check, in any thread. Raises core.CoreError, InputProblem."""
    neighbours = request.rows()
    report = core.clearance(request.body, neighbours, request.options, control)
    for row, neighbour in zip(report["neighbours"], request.neighbours):
        row["place"] = neighbour.place
    if request.ignored:
        report["ignored"], report["ignored_places"] = map(list, zip(*request.ignored))
    distances = None
    if request.points is not None:
        distances = np.full(len(request.points), FAR)
        for _, vertices, triangles, _, rule in neighbours:
            if rule is not None and rule.startswith("contact"):
                continue  # the colours would show only this contact, not the distance of other parts
            found = core.distance_to_mesh(request.points, vertices, triangles, control)
            distances = np.minimum(distances, found)
    return Outcome(report, distances, request.notes)


def apply(obj, outcome, hash_at_start):
    """Writes the result of a check into the object."""
    report = dict(outcome.report, notes=outcome.notes)
    obj.Report = json.dumps(report)
    obj.Summary = summary(report)
    obj.Checked = len(report["neighbours"])
    obj.Verdict = worst(report)
    obj.Smallest = report["neighbours"][report["smallest"]]["distance"]
    obj.MapDistances = [] if outcome.distances is None else [float(d) for d in outcome.distances]
    check.keep(obj, hash_at_start)


def first_contacts(plan, control=None):
    """Returns {(root, sub): Rule}: for each neighbour that the part touches at the first pose, the
    rule that would allow this contact. Raises core.CoreError, InputProblem."""
    request = plan.request()
    return contacts_from(request, offered(request, control or core.Control()))


def offered(request, control):
    """Returns, for each neighbour, the rule as text that would allow its contact. Any thread."""
    return core.first_contacts(request.body, request.rows(), request.options, control)


def contacts_from(request, texts):
    """Returns the rules of offered() as a dict with (root, sub) as keys."""
    found = zip((n.pair for n in request.neighbours), texts)
    return {pair: neighbour_rules.from_text(text) for pair, text in found if text}


def compute(obj, control=None):
    """Runs the check in this thread (for scripts without a GUI) as one undo step. Raises
    core.CoreError."""
    title = translate("SweptVolume", "Check clearance")
    return check.compute(obj, sys.modules[__name__], title, control).report


def report_of(obj):
    """Returns the stored report (dict), or None if there is none or it is damaged."""
    return stored(obj.Report, REPORT)


def make_clearance(document, label=None, **settings):
    """Creates a clearance check, not yet computed. `settings`: property names with values."""
    label = label or translate("SweptVolume", "Clearance")
    view = "sweptvolume.views.clearance_view:ClearanceView"
    return add_object(document, TYPE, "Clearance", Clearance, label, settings, view)
