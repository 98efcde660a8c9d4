# SPDX-License-Identifier: LGPL-2.1-or-later
"""A motion that is to be made better: document objects -> input of the core -> another motion beside it."""
import numpy as np

from .. import convert, core, core_paths
from ..convert import InputProblem, matrix_of
from ..texts import translate
from ..trajectory.poses import INTERPOLATIONS, Poses
from . import still_parts
from . import path_plan
from .moving import Moving


class ImprovePlan:
    """motion: of ours; pairs: (root, sub) of the parts that move with it; locked: indices of keys that stay;
    more: as much clearance as can be had; the rest as path_plan.PathPlan has it."""

    def __init__(self, motion, pairs, neighbours, locked=(), more=False, rules=None, **values):
        self.motion, self.pairs, self.neighbours = motion, list(pairs), list(neighbours)
        self.document = motion.Document
        self.locked, self.more = sorted(locked), more
        self.rules = dict(rules or {})
        self.values = dict(path_plan.DEFAULTS, **values)

    def objects(self):
        """Document objects that a run needs to its end."""
        return [root for root, _ in self.pairs] + [self.motion]

    def request(self):
        """The run without a document. Raises InputProblem."""
        if self.motion.Interpolation == "None":
            raise InputProblem(
                translate(
                    "Messages",
                    '"{0}" has the interpolation None: choose another interpolation first.',
                ).format(self.motion.Label)
            )
        if not self.neighbours:
            raise InputProblem(
                translate(
                    "Messages",
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
    """body: core.Request; neighbours: as core_paths.PathRequest has them; part: 4x4, from the part's own
    coordinates to those that the poses place."""

    def __init__(self, body, neighbours, options, part):
        self.body = body
        self.neighbours = neighbours
        self.options = options
        self.part = part


def work(request, control):
    """Any thread: the run itself (path_plan.Outcome). Raises core.CoreError, InputProblem."""
    neighbours = core_paths.rows_of(request.neighbours)
    report, found = core_paths.improve_path(request.body, neighbours, request.options, control)
    if found is None:
        return path_plan.Outcome(report, None)
    times, translations, rotations = found
    to_part = path_plan.placement_of(request.part)
    placed = [p.multiply(to_part) for p in convert.placements_from(translations, rotations)]
    pivot = to_part.inverse().Base  # the point that went straight, in the part's coordinates
    return path_plan.Outcome(report, Poses(times, placed, pivot=pivot))


def make(plan, outcome):
    """The better motion, beside the one that was there."""
    names = {core_name: name for name, core_name in INTERPOLATIONS.items() if name != "Spline"}
    label = translate("Messages", "{0}, improved").format(plan.motion.Label)
    kind = names[outcome.report["interpolation"]]
    return path_plan.make(plan.document, plan.pairs, outcome.poses, label, kind)


def improve(plan, control=None):
    """Improves in this thread (scripts, no GUI): (report, motion or None), one undo step. Raises
    core.CoreError, InputProblem."""
    outcome = work(plan.request(), control or core.Control())
    if outcome.poses is None:
        return outcome.report, None
    plan.document.openTransaction(translate("Commands", "Improve path"))
    obj = make(plan, outcome)
    plan.document.commitTransaction()
    return outcome.report, obj
