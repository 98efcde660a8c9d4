# SPDX-License-Identifier: LGPL-2.1-or-later
"""A search for an installation path: document objects -> input of the core -> a motion of ours.

A run is PathPlan.request() - work() - make(). The poses that the core places are those of the pivot of the
motion to come, the middle of the part: what it certifies is then what the motion does between its keys."""
import math

import FreeCAD as App
import numpy as np

from .. import convert, core, core_paths
from ..convert import InputProblem, matrix_of
from ..texts import translate
from ..trajectory.poses import Poses, shift_to
from . import clearance_plan, still_parts
from . import motion as motion_feature
from .moving import Seen, middle_of

#: mm; the budget in s, the largest turn in degrees.
DEFAULTS = {
    "RequiredDistance": 1.0,
    "ReleaseDistance": 20.0,
    "TranslationOnly": False,
    "LargestTurn": 180.0,
    "Budget": 60.0,
    "Seed": 1,
    "Accuracy": 0.01,
    "MeshDeflection": 0.05,
}
INTERPOLATION = "Linear"


class PathPlan:
    """What is searched for. Reads documents only in the thread of the GUI.

    pairs: (root, sub) of the parts that move together; goal: Placement of the first of them seen from the
    document, None: where it stands now; start: likewise, or None with `extract`: mm to get out by, or a
    direction (Vector); neighbours: (root, sub) of parts that stand still; rules: {(root, sub):
    neighbour_rules.Rule} of those that do not ask for the common distance."""

    def __init__(
        self,
        document,
        pairs,
        neighbours,
        start=None,
        extract=None,
        goal=None,
        rules=None,
        **values,
    ):
        self.document = document
        self.pairs = list(pairs)
        self.neighbours = list(neighbours)
        self.start, self.extract, self.goal = start, extract, goal
        self.rules = dict(rules or {})
        self.values = dict(DEFAULTS, **values)

    def objects(self):
        """Document objects that a run needs to its end."""
        return [root for root, _ in self.pairs]

    def check(self):
        """Raises InputProblem while something is missing."""
        if not self.pairs:
            raise InputProblem(convert.no_part_text())
        if not self.neighbours:
            raise InputProblem(
                translate(
                    "Messages",
                    "There is no neighbour: choose parts as neighbours, or make other "
                    "parts visible.",
                )
            )
        if self.start is None and self.extract is None:
            raise InputProblem(
                translate(
                    "Messages", "No start is given: enter a placement, a distance or a direction."
                )
            )

    def request(self):
        """The search without a document; notes the pivot. Raises InputProblem."""
        self.check()
        deflection = max(float(self.values["MeshDeflection"]), 1e-4)
        body = convert.body_from(self.pairs, deflection)
        self.pivot = middle_of(self.pairs, body.placement)
        base = body.placement.multiply(shift_to(self.pivot))
        return core_paths.PathRequest(
            Seen(body, matrix_of(base.inverse())),
            self._placed(self.goal if self.goal is not None else body.placement),
            self._still_parts(deflection),
            None if self.start is None else self._placed(self.start),
            tuple(self.extract) if isinstance(self.extract, App.Vector) else self.extract,
            self._options(deflection),
        )

    def _placed(self, placement):
        return matrix_of(placement.multiply(shift_to(self.pivot)))

    def _still_parts(self, deflection):
        """As the core takes them."""
        return rows_beside(self.document, self.pairs, self.neighbours, self.rules, deflection)

    def _options(self, deflection):
        v = self.values
        return {
            "clearance": float(v["RequiredDistance"]),
            "release": float(v["ReleaseDistance"]),
            "translation_only": bool(v["TranslationOnly"]),
            "max_angle": None if v["LargestTurn"] >= 180.0 else math.radians(v["LargestTurn"]),
            "budget": float(v["Budget"]),
            "seed": int(v["Seed"]),
            "tolerance": float(v["Accuracy"]),
            "body_chord": still_parts.chord_of(self.pairs, deflection),
        }


def beside(document, pairs, neighbours=None):
    """What stands beside parts: leaves() and still_parts() of a check. neighbours None: all visible ones."""
    return clearance_plan.Plan(document, pairs, None, neighbours or [], neighbours is None, {})


def rows_beside(document, pairs, neighbours, rules, deflection):
    """Neighbours as core_paths.PathRequest has them."""
    still = beside(document, pairs, neighbours)
    still.rules = rules
    return [
        (part.name, part.body, part.chord, part.rule.text())
        for part in still.still_parts(deflection)[0]
    ]


class Outcome:
    """What a search found: report (dict, docs/paths.md), poses (Poses of the part; None: nothing)."""

    def __init__(self, report, poses):
        self.report = report
        self.poses = poses

    def farthest(self):
        """Where the part came to that found no way, for the pivot (4x4 as Placement)."""
        pose = self.report["escape"]["pose"]
        return convert.placements_from([pose["translation"]], [pose["quaternion_xyzw"]])[0]


def placement_of(matrix):
    """A rigid 4x4 as Placement."""
    return App.Placement(App.Matrix(*np.asarray(matrix).ravel()))


def work(request, pivot, control, seen=None):
    """Any thread: the search itself. Raises core.CoreError, InputProblem."""
    report, found = core_paths.find_path(request, control, seen)
    return Outcome(report, None if found is None else poses_from(found, pivot))


def poses_from(found, pivot):
    """(times, translations, rotations) of the pivot -> Poses of the part."""
    times, translations, rotations = found
    back = shift_to(-pivot)
    placements = [p.multiply(back) for p in convert.placements_from(translations, rotations)]
    return Poses(times, placements, pivot=pivot)


def make(document, pairs, poses, label=None, interpolation=INTERPOLATION):
    """The motion of a path that was found."""
    obj = motion_feature.make_motion(document, label or label_for(pairs))
    motion_feature.store(obj, poses)
    obj.Interpolation, obj.PoseType = interpolation, "Absolute"
    obj.Pivot = poses.pivot
    motion_feature.set_parts(obj, pairs)
    document.recompute([obj])
    return obj


def label_for(pairs):
    return translate("Messages", "Path of {0}").format(convert.label_of(*pairs[0]))


def find(plan, control=None):
    """Searches in this thread (scripts, no GUI): (report, motion or None), one undo step. Raises
    core.CoreError, InputProblem."""
    request = plan.request()
    outcome = work(request, plan.pivot, control or core.Control())
    if outcome.poses is None:
        return outcome.report, None
    plan.document.openTransaction(translate("Commands", "Find path"))
    obj = make(plan.document, plan.pairs, outcome.poses)
    plan.document.commitTransaction()
    return outcome.report, obj
