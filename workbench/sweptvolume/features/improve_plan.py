# SPDX-License-Identifier: LGPL-2.1-or-later
"""Improves a motion: reads the document, runs the core, and creates a new motion. The given motion
does not change."""
import numpy as np

from .. import convert, core, core_paths
from ..convert import InputProblem, matrix_of
from ..texts import translate
from ..trajectory.poses import INTERPOLATIONS, Poses
from . import still_parts
from . import path_plan
from .moving import Moving


class ImprovePlan:
    """The inputs of a run. motion: a motion object; pairs: (root, sub) of the parts that move with
    it; locked: indices of keys that must not change; more: make the clearance as large as possible.
    The other arguments are as in path_plan.PathPlan."""

    def __init__(self, motion, pairs, neighbours, locked=(), more=False, rules=None, **values):
        self.motion, self.pairs, self.neighbours = motion, list(pairs), list(neighbours)
        self.document = motion.Document
        self.locked, self.more = sorted(locked), more
        self.rules = dict(rules or {})
        self.values = dict(path_plan.DEFAULTS, **values)

    def objects(self):
        """Returns the document objects that a run needs until its end."""
        return [root for root, _ in self.pairs] + [self.motion]

    def request(self):
        """Returns the inputs of the run as plain values. Raises InputProblem."""
        if self.motion.Interpolation == "None":
            raise InputProblem(
                translate(
                    "SweptVolume",
                    '"{0}" has the interpolation None: choose another interpolation first.',
                ).format(self.motion.Label)
            )
        if not self.neighbours:
            raise InputProblem(
                translate(
                    "SweptVolume",
                    "There is no neighbour: choose parts as neighbours, or make other "
                    "parts visible.",
                )
            )
        moving, v = Moving(self.pairs, self.motion), self.values
        deflection = max(float(v["MeshDeflection"]), 1e-4)
        body = moving.body_request(deflection, 0.5 * float(v["Accuracy"]), {})
        times = [self.motion.Times[k] for k in self.locked]
        options = {
            "locked": [int(np.argmin(np.abs(body.times - time))) for time in times],
            "more_clearance": self.more,
            "clearance": float(v["RequiredDistance"]),
            "release": float(v["ReleaseDistance"]),
            "budget": float(v["Budget"]),
            "seed": int(v["Seed"]),
            "tolerance": float(v["Accuracy"]),
            "body_chord": still_parts.chord_of(self.pairs, deflection),
        }
        rows = path_plan.rows_beside(
            self.document, self.pairs, self.neighbours, self.rules, deflection
        )
        standing = matrix_of(convert.global_placement(*self.pairs[0]))
        return ImproveRequest(body, rows, options, moving.into_base() @ standing)


class ImproveRequest:
    """Input of one run. body: core.Request; neighbours: as in core_paths.PathRequest; part: 4x4
    matrix from the part's own coordinates to those to which the poses apply."""

    def __init__(self, body, neighbours, options, part):
        self.body = body
        self.neighbours = neighbours
        self.options = options
        self.part = part


def work(request, control):
    """Runs the core, in any thread. Returns path_plan.Outcome. Raises core.CoreError, InputProblem."""
    neighbours = core_paths.rows_of(request.neighbours)
    report, found = core_paths.improve_path(request.body, neighbours, request.options, control)
    if found is None:
        return path_plan.Outcome(report, None)
    times, translations, rotations = found
    to_part = path_plan.placement_of(request.part)
    placed = [p.multiply(to_part) for p in convert.placements_from(translations, rotations)]
    # The point of the part that moves in straight lines between keys, in coordinates of the part.
    pivot = to_part.inverse().Base
    return path_plan.Outcome(report, Poses(times, placed, pivot=pivot))


def make(plan, outcome):
    """Creates the improved motion. The given motion does not change."""
    names = {core_name: name for name, core_name in INTERPOLATIONS.items() if name != "Spline"}
    label = translate("SweptVolume", "{0}, improved").format(plan.motion.Label)
    kind = names[outcome.report["interpolation"]]
    return path_plan.make(plan.document, plan.pairs, outcome.poses, label, kind)


def improve(plan, control=None):
    """Improves the motion in this thread (for scripts without a GUI) as one undo step. Returns
    (report, motion or None). Raises core.CoreError, InputProblem."""
    outcome = work(plan.request(), control or core.Control())
    if outcome.poses is None:
        return outcome.report, None
    plan.document.openTransaction(translate("SweptVolume", "Improve path"))
    obj = make(plan, outcome)
    plan.document.commitTransaction()
    return outcome.report, obj
