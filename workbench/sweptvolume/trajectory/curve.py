# SPDX-License-Identifier: LGPL-2.1-or-later
"""Poses along a wire, edge, sketch or Draft wire: position by arc length, orientation fixed or along
the tangent, carried on without flips."""
import math

import FreeCAD as App
import Part

from ..convert import InputProblem, global_placement, root_path
from ..texts import translate
from .poses import Poses, even_times

ORIENTATIONS = ["Fixed", "Tangent"]


def is_curve(obj):
    """Whether an object is a line of edges (no faces)."""
    shape = getattr(obj, "Shape", None)
    return shape is not None and bool(shape.Edges) and not shape.Faces


def poses(objects, count, orientation, duration):
    """`count` poses evenly by arc length over `duration` s."""
    if len(objects) != 1 or not is_curve(objects[0]):
        raise InputProblem(translate("Messages", "choose one wire, edge or sketch as the path."))
    obj = objects[0]
    if count < 2:
        raise InputProblem(translate("Messages", "a path needs at least two poses."))
    shape = obj.Shape.copy()
    shape.Placement = global_placement(*root_path(obj))
    samples = _samples(_edges(shape, obj.Label), count)
    placements = []
    turn = App.Rotation()
    before = None
    for point, tangent in samples:
        if orientation == "Tangent":
            start = App.Vector(1, 0, 0) if before is None else before
            turn = _least_turn(start, tangent).multiply(turn)
            before = tangent
        placements.append(App.Placement(point, turn))
    return Poses(even_times(count, duration / (count - 1)), placements)


def _edges(shape, label):
    groups = Part.sortEdges(shape.Edges)
    if len(groups) != 1:
        raise InputProblem(
            translate("Messages", '"{0}" has {1} separate pieces; a path must be one.').format(
                label, len(groups)
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
