# SPDX-License-Identifier: LGPL-2.1-or-later
"""Poses along a wire, edge, sketch or Draft wire: position by arc length; orientation fixed, along the
tangent with the least turn, or by a second curve. None of them flips."""
import math

import FreeCAD as App
import Part

from ..convert import InputProblem, global_placement, root_path
from ..texts import translate
from .poses import Poses, even_times

#: Fixed: none. Tangent: x of the part stays on the tangent. SecondCurve: x on the tangent, z towards
#: the point of a second curve at the same part of its length.
ORIENTATIONS = ["Fixed", "Tangent", "SecondCurve"]
#: Below this share of a length, two points are one and two directions parallel.
SMALL = 1e-9


def is_curve(obj):
    """Whether an object is a line of edges (no faces)."""
    shape = getattr(obj, "Shape", None)
    return shape is not None and bool(shape.Edges) and not shape.Faces


def poses(objects, count, orientation, duration):
    """`count` poses evenly by arc length over `duration` s. objects: the path, then for SecondCurve
    the curve that orients."""
    wanted = 2 if orientation == "SecondCurve" else 1
    if len(objects) < wanted or not all(is_curve(obj) for obj in objects[:wanted]):
        raise InputProblem(
            translate("Messages", "choose two wires: the path, then the curve that orients.")
            if wanted == 2
            else translate("Messages", "choose one wire, edge or sketch as the path.")
        )
    if count < 2:
        raise InputProblem(translate("Messages", "a path needs at least two poses."))
    samples = _samples(_edges(objects[0]), count)
    if orientation == "SecondCurve":
        turns = _turns_by_second(samples, _edges(objects[1]), objects)
    elif orientation == "Tangent":
        turns = _turns_by_tangent(samples)
    else:
        turns = [App.Rotation()] * count
    placements = [App.Placement(point, turn) for (point, _), turn in zip(samples, turns)]
    return Poses(even_times(count, duration / (count - 1)), placements)


def _turns_by_tangent(samples):
    """The first tangent from x with the least turn, then from tangent to tangent."""
    turns, turn, before = [], App.Rotation(), App.Vector(1, 0, 0)
    for _, tangent in samples:
        turn = _least_turn(before, tangent).multiply(turn)
        turns.append(turn)
        before = tangent
    return turns


def _turns_by_second(samples, edges, objects):
    """x along the tangent, z as near as possible to the point of the second curve. Where that point
    lies on the tangent line, z is carried on from the pose before."""
    others = _samples(edges, len(samples))
    if (others[0][0] - samples[0][0]).Length > (others[-1][0] - samples[0][0]).Length:
        others.reverse()  # a second curve drawn the other way round
    turns, before = [], None
    for (point, tangent), (other, _) in zip(samples, others):
        up = other - point
        across = up - tangent * up.dot(tangent)
        if across.Length > SMALL * max(up.Length, 1.0):
            turn = App.Rotation(tangent, App.Vector(), across, "XZY")
        elif before is not None:
            turn = _least_turn(before.multVec(App.Vector(1, 0, 0)), tangent).multiply(before)
        else:
            raise InputProblem(
                translate(
                    "Messages",
                    '"{0}" begins in the direction of the path "{1}": it does not say where up is. '
                    "Move it sideways.",
                ).format(objects[1].Label, objects[0].Label)
            )
        turns.append(turn)
        before = turn
    return turns


def _edges(obj):
    """The edges of an object in order, seen from the document."""
    shape = obj.Shape.copy()
    shape.Placement = global_placement(*root_path(obj))
    groups = Part.sortEdges(shape.Edges)
    if len(groups) != 1:
        raise InputProblem(
            translate("Messages", '"{0}" has {1} separate pieces; a path must be one.').format(
                obj.Label, len(groups)
            )
        )
    return groups[0]


def _samples(edges, count):
    """(point, unit tangent) at even arc lengths."""
    total = sum(edge.Length for edge in edges)
    found, k, passed = [], 0, 0.0
    for i in range(count):
        at = total * i / (count - 1)
        while k + 1 < len(edges) and at > passed + edges[k].Length:
            passed += edges[k].Length
            k += 1
        edge = edges[k]
        along = min(max(at - passed, 0.0), edge.Length)
        back = edge.Orientation == "Reversed"
        parameter = edge.getParameterByLength(edge.Length - along if back else along)
        tangent = edge.Curve.tangent(parameter)[0] * (-1.0 if back else 1.0)
        found.append((edge.valueAt(parameter), App.Vector(tangent).normalize()))
    return found


def _least_turn(a, b):
    """Smallest rotation from direction a to b; half a turn about any normal where they are opposite."""
    if a.getAngle(b) > math.pi - 1e-9:
        other = App.Vector(0, 0, 1) if abs(a.z) < 0.9 else App.Vector(0, 1, 0)
        return App.Rotation(a.cross(other), 180)
    return App.Rotation(a, b)
