# SPDX-License-Identifier: LGPL-2.1-or-later
"""A search for an installation path: reads the document, runs the core, and creates a motion.

A run consists of PathPlan.request(), work() and make(). The core gets the poses of the pivot of the
new motion, which is the middle of the part. So the core certifies exactly the motion that the part
makes between its keys."""
import math

import FreeCAD as App
import numpy as np

from .. import convert, core, core_paths
from ..convert import InputProblem, matrix_of
from ..texts import translate
from ..trajectory.poses import Poses, shift_to
from . import clearance_plan, still_parts
from . import motion as motion_feature
from .moving import BodyInFrame, middle_of

#: Lengths in mm, the time limit in s, the largest turn in degrees.
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
    """The task of a search. Reads documents only in the GUI thread.

    pairs: (root, sub) of the parts that move together. goal: Placement of the first part in world
    coordinates, or None for its present placement. start: also a Placement, or None with `extract`:
    a distance in mm or a direction (Vector). neighbours: (root, sub) of parts that stand still.
    rules: {(root, sub): neighbour_rules.Rule} of the neighbours with their own rule."""

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
        """Returns the document objects that a run needs until its end."""
        return [root for root, _ in self.pairs]

    def check(self):
        """Raises InputProblem if an input is missing."""
        if not self.pairs:
            raise InputProblem(convert.no_part_text())
        if not self.neighbours:
            raise InputProblem(
                translate(
                    "SweptVolume",
                    "There is no neighbour: choose parts as neighbours, or make other "
                    "parts visible.",
                )
            )
        if self.start is None and self.extract is None:
            raise InputProblem(
                translate(
                    "SweptVolume",
                    "No start is given: enter a placement, a distance or a direction.",
                )
            )

    def request(self):
        """Returns the inputs of the search as plain values, and stores the pivot in the plan.
        Raises InputProblem."""
        self.check()
        deflection = max(float(self.values["MeshDeflection"]), 1e-4)
        body = convert.body_from(self.pairs, deflection)
        self.pivot = middle_of(self.pairs, body.placement)
        base = body.placement.multiply(shift_to(self.pivot))
        return core_paths.PathRequest(
            BodyInFrame(body, matrix_of(base.inverse())),
            self._placed(self.goal if self.goal is not None else body.placement),
            self._still_parts(deflection),
            None if self.start is None else self._placed(self.start),
            tuple(self.extract) if isinstance(self.extract, App.Vector) else self.extract,
            self._options(deflection),
        )

    def _placed(self, placement):
        return matrix_of(placement.multiply(shift_to(self.pivot)))

    def _still_parts(self, deflection):
        """Returns the neighbours as core_paths.PathRequest takes them."""
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
    """Returns a plan whose leaves() and still_parts() are the neighbours of the moving parts.
    neighbours None: all visible parts."""
    return clearance_plan.Plan(document, pairs, None, neighbours or [], neighbours is None, {})


def rows_beside(document, pairs, neighbours, rules, deflection):
    """Returns the neighbours as core_paths.PathRequest takes them."""
    still = beside(document, pairs, neighbours)
    still.rules = rules
    return [
        (part.name, part.body, part.chord, part.rule.text())
        for part in still.still_parts(deflection)[0]
    ]


class Outcome:
    """Result of a search: report (dict, docs/paths.md), and poses (Poses of the part, or None if no
    path was found)."""

    def __init__(self, report, poses):
        self.report = report
        self.poses = poses

    def farthest(self):
        """Returns the placement of the pivot farthest from the goal that a failed search reached,
        as a Placement."""
        pose = self.report["escape"]["pose"]
        return convert.placements_from([pose["translation"]], [pose["quaternion_xyzw"]])[0]


def placement_of(matrix):
    """Converts a rigid 4x4 matrix to a Placement."""
    return App.Placement(App.Matrix(*np.asarray(matrix).ravel()))


def work(request, pivot, control, seen=None):
    """Runs the search, in any thread. Raises core.CoreError, InputProblem."""
    report, found = core_paths.find_path(request, control, seen)
    return Outcome(report, None if found is None else poses_from(found, pivot))


def poses_from(found, pivot):
    """Converts (times, translations, rotations) of the pivot to Poses of the part."""
    times, translations, rotations = found
    back = shift_to(-pivot)
    placements = [p.multiply(back) for p in convert.placements_from(translations, rotations)]
    return Poses(times, placements, pivot=pivot)


def make(document, pairs, poses, label=None, interpolation=INTERPOLATION):
    """Creates the motion of a path that was found."""
    obj = motion_feature.make_motion(document, label or label_for(pairs))
    motion_feature.store(obj, poses)
    obj.Interpolation, obj.PoseType = interpolation, "Absolute"
    obj.Pivot = poses.pivot
    motion_feature.set_parts(obj, pairs)
    document.recompute([obj])
    return obj


def label_for(pairs):
    return translate("SweptVolume", "Path of {0}").format(convert.label_of(*pairs[0]))


def find(plan, control=None):
    """Searches in this thread (for scripts without a GUI) as one undo step. Returns (report, motion
    or None). Raises core.CoreError, InputProblem."""
    request = plan.request()
    outcome = work(request, plan.pivot, control or core.Control())
    if outcome.poses is None:
        return outcome.report, None
    plan.document.openTransaction(translate("SweptVolume", "Find path"))
    obj = make(plan.document, plan.pairs, outcome.poses)
    plan.document.commitTransaction()
    return outcome.report, obj
