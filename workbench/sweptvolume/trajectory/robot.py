# SPDX-License-Identifier: LGPL-2.1-or-later
"""Poses from a Robot trajectory (Robot::TrajectoryObject and similar objects)."""
from ..convert import InputProblem
from ..texts import translate
from .poses import Poses


def is_trajectory(obj):
    return "Trajectory" in getattr(obj, "PropertiesList", [])


def poses(objects, count):
    """Returns `count` poses at equal times, interpolated by the Robot workbench (with its ramps)."""
    if len(objects) != 1 or not is_trajectory(objects[0]):
        raise InputProblem(translate("SweptVolume", "Select one Robot trajectory."))
    obj = objects[0]
    path = obj.Trajectory
    if len(path.Waypoints) < 2 or path.Duration <= 0:
        raise InputProblem(
            translate(
                "SweptVolume",
                '"{0}" has {1} waypoints, but a motion needs at least two: add waypoints.',
            ).format(obj.Label, len(path.Waypoints))
        )
    times = [path.Duration * i / (count - 1) for i in range(count)]
    base = getattr(obj, "Base", None)
    found = [path.position(t) for t in times]
    if base is not None:
        found = [base.multiply(p) for p in found]
    return Poses(times, found)
