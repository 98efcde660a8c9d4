# SPDX-License-Identifier: LGPL-2.1-or-later
"""Poses of a cutter from CAM (Path) commands: G0 to G3 with X Y Z I J K R and A B C words.

Convention: a pose is the placement of the tool relative to the workpiece, with the tip of the tool
at the programmed point. A, B, C are in degrees. Head: they turn the tool about the fixed axes x,
then y, then z (R = Rz Ry Rx); X Y Z are coordinates of the workpiece. Table: they turn the
workpiece with its coordinates about the axes of the machine, in that order; X Y Z are coordinates
of the machine, and the tool keeps its direction. G2 and G3 lie in the plane of G17 (xy), G18 (zx)
or G19 (yz). The centre is relative to the start (G91.1, as in Path), or a radius R is given;
helices are possible. G90 and G91 are supported. Feed is in mm/s, as Path stores it; G0 moves at
`rapid` mm/s.
"""
import math

import FreeCAD as App

from ..convert import InputProblem
from ..texts import translate
from .poses import Poses

#: Largest angle (rad) of the pieces into which arcs and turns of A, B and C are divided; shortest
#: time of a command (s).
ARC_STEP, SHORTEST = math.radians(10), 1e-4
MOVES = {"G0": 0, "G00": 0, "G1": 1, "G01": 1, "G2": 2, "G02": 2, "G3": 3, "G03": 3}
#: Word for the plane -> (first axis, second axis, first word for the centre, second word for the
#: centre).
PLANES = {
    "G17": ("X", "Y", "I", "J"),
    "G18": ("Z", "X", "K", "I"),
    "G19": ("Y", "Z", "J", "K"),
}
CONVENTIONS = ["Head", "Table"]


def is_path(obj):
    return hasattr(getattr(obj, "Path", None), "Commands")


def poses(objects, rapid=100.0, convention="Head"):
    """Returns the poses of all moves of one CAM object."""
    if len(objects) != 1 or not is_path(objects[0]):
        raise InputProblem(translate("SweptVolume", "Select one CAM (Path) operation."))
    placement_of = {"Head": _by_head, "Table": _by_table}[convention]
    times, found = _Reader(rapid, placement_of).read(objects[0].Path.Commands)
    if len(found) < 2:
        raise InputProblem(
            translate(
                "SweptVolume", '"{0}" has no moves (G0 to G3): choose another operation.'
            ).format(objects[0].Label)
        )
    return Poses(times, found)


class _Reader:
    """Follows commands. Its state holds the words that remain in force."""

    def __init__(self, rapid, placement_of):
        self.rapid, self.placement_of, self.feed = rapid, placement_of, rapid
        self.state = {axis: 0.0 for axis in "XYZABC"}
        self.plane, self.relative = PLANES["G17"], False
        self.times, self.found = [], []

    def read(self, commands):
        for command in commands:
            name = command.Name.upper()
            if name in PLANES:
                self.plane = PLANES[name]
            elif name in ("G90", "G91"):
                self.relative = name == "G91"
            elif name in MOVES:
                self._move(MOVES[name], command.Parameters)
        return self.times, self.found

    def _move(self, kind, words):
        self.feed = words.get("F", self.feed) or self.feed
        target = dict(self.state)
        for axis in target:
            if axis in words:
                target[axis] = words[axis] + (self.state[axis] if self.relative else 0.0)
        # The position before the first move is not known, so the motion begins at the target of
        # this move.
        if not self.found:
            self._arrive(target, 0.0)
            return
        for step in _steps(self.state, target, words, kind, self.plane):
            speed = self.rapid if kind == 0 else self.feed
            self._arrive(step, max(_distance(self.state, step) / speed, SHORTEST))

    def _arrive(self, state, seconds):
        self.times.append(self.times[-1] + seconds if self.times else 0.0)
        self.found.append(self.placement_of(state))
        self.state = state


def _by_head(state):
    turn = App.Rotation(state["C"], state["B"], state["A"])  # yaw, pitch, roll
    return App.Placement(App.Vector(state["X"], state["Y"], state["Z"]), turn)


def _by_table(state):
    turn = App.Rotation(state["C"], state["B"], state["A"]).inverted()
    point = turn.multVec(App.Vector(state["X"], state["Y"], state["Z"]))
    return App.Placement(point, turn)


def _distance(a, b):
    return math.sqrt(sum((a[axis] - b[axis]) ** 2 for axis in "XYZ"))


def _centre(state, target, words, kind, plane):
    """Returns the centre of an arc in its plane, or None if the words do not define it."""
    first, second, i, j = plane
    if i in words or j in words:
        return state[first] + words.get(i, 0.0), state[second] + words.get(j, 0.0)
    if "R" not in words:
        return None
    dx, dy = target[first] - state[first], target[second] - state[second]
    chord = math.hypot(dx, dy)
    if chord < 1e-12:
        return None
    height = math.sqrt(max(words["R"] ** 2 - chord**2 / 4, 0.0))
    # For a clockwise arc of less than half a circle, the centre lies to the right. R < 0 means the
    # longer arc.
    side = (1.0 if kind == 3 else -1.0) * (1.0 if words["R"] > 0 else -1.0)
    x, y = (state[first] + target[first]) / 2, (state[second] + target[second]) / 2
    return x - side * height * dy / chord, y + side * height * dx / chord


def _between(state, target, u):
    """Returns the state at the fraction u of a straight move."""
    return {axis: state[axis] + (target[axis] - state[axis]) * u for axis in state}


def _steps(state, target, words, kind, plane):
    """Returns the states along the move, the target last."""
    centre = _centre(state, target, words, kind, plane) if kind >= 2 else None
    # Between two poses a part always turns the shorter way, so a turn by 270 degrees needs more
    # poses.
    turn = math.radians(max(abs(target[axis] - state[axis]) for axis in "ABC"))
    if centre is None:
        count = max(1, int(math.ceil(turn / ARC_STEP - 1e-9)))
        return [_between(state, target, i / count) for i in range(1, count)] + [target]
    axes = plane[:2]
    start = [state[axis] - c for axis, c in zip(axes, centre)]
    end = [target[axis] - c for axis, c in zip(axes, centre)]
    radius, first = math.hypot(*start), math.atan2(start[1], start[0])
    sweep = math.atan2(end[1], end[0]) - first
    if kind == 2 and sweep >= -1e-9:
        sweep -= 2 * math.pi
    if kind == 3 and sweep <= 1e-9:
        sweep += 2 * math.pi
    count = max(1, int(math.ceil(max(abs(sweep), turn) / ARC_STEP)))
    steps = []
    for i in range(1, count):
        u = i / count
        step = _between(state, target, u)
        step[axes[0]] = centre[0] + radius * math.cos(first + sweep * u)
        step[axes[1]] = centre[1] + radius * math.sin(first + sweep * u)
        steps.append(step)
    return steps + [target]
