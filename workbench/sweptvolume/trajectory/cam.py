# SPDX-License-Identifier: LGPL-2.1-or-later
"""Poses of a cutter from CAM (Path) commands: G0 to G3 with X Y Z I J K and A B C words.

Convention: the pose is that of the tool, its tip at X Y Z; A, B, C (degrees) turn it about the fixed
axes x, then y, then z. G2/G3 in the xy plane with I J (centre relative to the start), also as helix.
Feed is in mm/s; G0 is taken at `rapid` mm/s.
"""
import math

import FreeCAD as App

from ..convert import InputProblem
from ..texts import translate
from .poses import Poses

#: Arcs are cut into pieces of at most this angle (rad); shortest time of a command (s).
ARC_STEP, SHORTEST = math.radians(10), 1e-4
MOVES = {"G0": 0, "G00": 0, "G1": 1, "G01": 1, "G2": 2, "G02": 2, "G3": 3, "G03": 3}


def is_path(obj):
    return hasattr(getattr(obj, "Path", None), "Commands")


def poses(objects, rapid=100.0):
    """All moves of one CAM object."""
    if len(objects) != 1 or not is_path(objects[0]):
        raise InputProblem(translate("Messages", "choose one CAM (Path) object."))
    state = {axis: 0.0 for axis in "XYZABC"}
    feed, time = rapid, 0.0
    times, found = [], []
    for command in objects[0].Path.Commands:
        kind = MOVES.get(command.Name.upper())
        if kind is None:
            continue
        words = command.Parameters
        feed = words.get("F", feed) or feed
        target = {axis: words.get(axis, state[axis]) for axis in state}
        if (
            not found
        ):  # where the tool comes from is not known: the motion starts at the first target
            times, found, state = [0.0], [_placement(target)], target
            continue
        for step in _steps(state, target, words, kind):
            length = _distance(state, step)
            time += max(length / (rapid if kind == 0 else feed), SHORTEST)
            times.append(time)
            found.append(_placement(step))
            state = step
    if len(found) < 2:
        raise InputProblem(
            translate("Messages", '"{0}" has no moves (G0 to G3).').format(objects[0].Label)
        )
    return Poses(times, found)


def _placement(state):
    turn = App.Rotation(state["C"], state["B"], state["A"])  # yaw, pitch, roll
    return App.Placement(App.Vector(state["X"], state["Y"], state["Z"]), turn)


def _distance(a, b):
    return math.sqrt(sum((a[axis] - b[axis]) ** 2 for axis in "XYZ"))


def _steps(state, target, words, kind):
    if kind < 2 or not ("I" in words or "J" in words):
        return [target]
    cx, cy = state["X"] + words.get("I", 0.0), state["Y"] + words.get("J", 0.0)
    radius = math.hypot(state["X"] - cx, state["Y"] - cy)
    first = math.atan2(state["Y"] - cy, state["X"] - cx)
    last = math.atan2(target["Y"] - cy, target["X"] - cx)
    sweep = last - first
    if kind == 2 and sweep >= -1e-9:
        sweep -= 2 * math.pi
    if kind == 3 and sweep <= 1e-9:
        sweep += 2 * math.pi
    count = max(1, int(math.ceil(abs(sweep) / ARC_STEP)))
    steps = []
    for i in range(1, count):
        u = i / count
        step = {axis: state[axis] + (target[axis] - state[axis]) * u for axis in state}
        step["X"] = cx + radius * math.cos(first + sweep * u)
        step["Y"] = cy + radius * math.sin(first + sweep * u)
        steps.append(step)
    return steps + [target]
