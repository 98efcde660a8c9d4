# SPDX-License-Identifier: LGPL-2.1-or-later
"""Poses along a wire, edge, sketch or Draft wire: position by arc length; orientation fixed, along the
tangent with the least turn, or by a second curve. None of them flips.

The ends of all edges are poses; between them there are as many as an accuracy asks for. At a corner a part
that follows the tangent turns in place."""
import bisect
import math

import FreeCAD as App
import Part

from ..convert import InputProblem, global_placement, root_path
from ..quantities import count, quantity
from ..texts import translate
from .poses import Poses, even_times

#: Fixed: none. Tangent: x of the part stays on the tangent. SecondCurve: x on the tangent, z towards
#: the point of a second curve at the same part of its length.
ORIENTATIONS = ["Fixed", "Tangent", "SecondCurve"]
#: How far (mm) the straight way between two poses may leave the curve where nothing else is asked for: the
#: least that FreeCAD's fields show in mm; a number typed into a field of micrometres would be one of those.
ACCURACY = 0.1
#: A motion of more takes the window's time for seconds at every recompute.
MAX_POSES = 20_000
#: An edge is halved at most this often; its pieces are then about as near as points can be told apart.
MAX_HALVINGS = 24
#: Smaller turns (rad) between two edges are none: half a millimetre at a distance of 500 m.
CORNER = 1e-6
#: Fractions between two poses at which the deviation of the curve is measured. They are irrational: at
#: simple fractions a helix of several turns looks straight.
LOOK_AT = (math.sqrt(5) - 2, 0.5, math.sqrt(0.5))
#: A whole turn in place takes as long as this share of the path.
TURN_SHARE = 0.25
#: Below this share of a length, two points are one and two directions parallel.
SMALL = 1e-9


def is_curve(obj):
    """Whether an object is a line of edges (no faces)."""
    shape = getattr(obj, "Shape", None)
    return shape is not None and bool(shape.Edges) and not shape.Faces


def poses(objects, count, orientation, duration):
    """`count` poses evenly by arc length over `duration` s, corners or not: motions of older documents.
    objects: the path, then for SecondCurve the curve that orients."""
    edges = _path(objects, orientation)
    if count < 2:
        raise InputProblem(
            translate(
                "Messages", "A curve needs at least two poses: set Count to 0, or to 2 or more."
            )
        )
    track = _Track(edges)
    samples = [track.sample(track.total * i / (count - 1)) for i in range(count)]
    shares = [i / (count - 1) for i in range(count)]
    turns = _turns(samples, shares, orientation, objects)
    placements = [App.Placement(point, turn) for (point, _), turn in zip(samples, turns)]
    return Poses(even_times(count, duration / (count - 1)), placements)


def poses_within(objects, accuracy, orientation, duration):
    """Poses over `duration` s; the straight way between two leaves the curve by at most `accuracy` (mm). For
    a part that turns and is about as large as the path that holds for all its points.
    objects: the path, then for SecondCurve the curve that orients."""
    edges = _path(objects, orientation)
    if not accuracy > 0:
        raise InputProblem(
            translate("Messages", "The accuracy is {0}: enter a value greater than 0.").format(
                quantity(accuracy)
            )
        )
    track = _Track(edges)
    samples, lengths, clock = _adaptive(track, accuracy, orientation != "Fixed")
    shares = [length / track.total for length in lengths]
    turns = _turns(samples, shares, orientation, objects)
    placements = [App.Placement(point, turn) for (point, _), turn in zip(samples, turns)]
    return Poses([duration * passed / clock[-1] for passed in clock], placements)


def _path(objects, orientation):
    """The edges of the path. Raises InputProblem."""
    wanted = 2 if orientation == "SecondCurve" else 1
    if len(objects) < wanted or not all(is_curve(obj) for obj in objects[:wanted]):
        raise InputProblem(
            translate(
                "Messages",
                "Select two wires: the curve to follow, then the curve that sets the orientation.",
            )
            if wanted == 2
            else translate("Messages", "Select one wire, edge or sketch to follow.")
        )
    return _edges(objects[0])


class _Track:
    """Edges one after the other, by arc length (mm)."""

    def __init__(self, edges):
        self.edges = edges
        self.ends = [0.0]
        for edge in edges:
            self.ends.append(self.ends[-1] + edge.Length)
        self.total = self.ends[-1]

    def sample(self, length):
        """(point, unit tangent) at a length; at a corner those of the edge before it."""
        k = bisect.bisect_left(self.ends, length, 1, len(self.edges)) - 1
        return self.on_edge(k, length - self.ends[k])

    def on_edge(self, k, along):
        edge = self.edges[k]
        along = min(max(along, 0.0), edge.Length)
        back = edge.Orientation == "Reversed"
        parameter = edge.getParameterByLength(edge.Length - along if back else along)
        return self._there(edge, parameter, back)

    def at_part(self, k, part):
        """(point, unit tangent) on edge k, by the part of its range of parameters: quicker by far."""
        return self._there(
            self.edges[k], self._parameter(k, part), self.edges[k].Orientation == "Reversed"
        )

    def length_between(self, k, a, b):
        """Arc length (mm) between two parts of edge k."""
        ends = sorted((self._parameter(k, a), self._parameter(k, b)))
        return self.edges[k].Curve.length(*ends)

    def _parameter(self, k, part):
        first, last = self.edges[k].ParameterRange
        if self.edges[k].Orientation == "Reversed":
            first, last = last, first
        return first + (last - first) * part

    @staticmethod
    def _there(edge, parameter, back):
        tangent = edge.Curve.tangent(parameter)[0] * (-1.0 if back else 1.0)
        return edge.valueAt(parameter), App.Vector(tangent).normalize()


def _adaptive(track, accuracy, turning):
    """Samples (point, tangent), their lengths on the track, and a clock that goes with the length and, for
    a part that is turning, goes on at corners."""
    box = Part.Compound(track.edges).BoundBox
    reach = box.DiagonalLength if turning else 0.0
    samples, lengths, clock = [track.at_part(0, 0.0)], [0.0], [0.0]

    def put(sample, length, time):
        if len(samples) >= MAX_POSES:
            raise InputProblem(
                translate(
                    "Messages",
                    "An accuracy of {0} needs more than {1} poses on this curve: choose a "
                    "larger accuracy value.",
                ).format(quantity(accuracy), count(MAX_POSES))
            )
        samples.append(sample)
        lengths.append(length)
        clock.append(time)

    for k in range(len(track.edges)):
        first = track.at_part(k, 0.0)
        if turning and _angle(first[1], samples[-1][1]) > CORNER:
            for step, tangent in _turn_in_place(samples[-1][1], first[1]):
                put((first[0], tangent), track.ends[k], clock[-1] + step * TURN_SHARE * track.total)
        here, done = first, 0.0
        waiting = [(track.at_part(k, 1.0), 1.0, 0)]
        while waiting:
            there, part, depth = waiting[-1]
            ask = depth < MAX_HALVINGS
            if ask and _leaves(track, k, done, here, part, there, reach) > accuracy:
                middle = 0.5 * (done + part)
                waiting[-1] = (there, part, depth + 1)
                waiting.append((track.at_part(k, middle), middle, depth + 1))
            else:
                step = track.length_between(k, done, part)
                put(there, min(lengths[-1] + step, track.total), clock[-1] + step)
                here, done = there, part
                waiting.pop()
        lengths[-1] = track.ends[k + 1]
    return samples, lengths, clock


def _leaves(track, k, a, here, b, there, reach):
    """How far (mm) the straight way between two samples leaves edge k, at a distance `reach` from it with
    the turn between their tangents, looked at at three points."""
    turn, way, most = _least_turn(here[1], there[1]), there[0] - here[0], 0.0
    for u in LOOK_AT:
        point, tangent = track.at_part(k, a + (b - a) * u)
        share = (point - here[0]).dot(way) / max(way.dot(way), 1e-300)
        share = min(max(share, 0.0), 1.0)  # where the straight way is nearest
        off = (point - here[0] - way * share).Length
        if reach:
            part = App.Rotation(turn.Axis, math.degrees(turn.Angle) * share)
            off += reach * _angle(part.multVec(here[1]), tangent)
        most = max(most, off)
    return most


def _turn_in_place(before, behind):
    """(part of a whole turn, tangent) of each step of the turn between two directions; at most a right
    angle each, so that the way round is never in doubt."""
    turn = _least_turn(before, behind)
    steps = 2 if turn.Angle > math.pi / 2 else 1
    part = turn.Angle / (2 * math.pi) / steps
    half = App.Rotation(turn.Axis, math.degrees(turn.Angle) / 2).multVec(before)
    return [(part, half), (part, behind)] if steps == 2 else [(part, behind)]


def _turns(samples, shares, orientation, objects):
    """Rotation of the part at each sample. shares: how far along the path each is, 0 to 1."""
    if orientation == "SecondCurve":
        track = _Track(_edges(objects[1]))
        ends, start = [track.sample(x)[0] for x in (0.0, track.total)], samples[0][0]
        if (ends[0] - start).Length > (ends[1] - start).Length:
            shares = [1.0 - share for share in shares]  # it was drawn the other way round
        others = [track.sample(track.total * share)[0] for share in shares]
        return _turns_by_second(samples, others, objects)
    if orientation == "Tangent":
        return _turns_by_tangent(samples)
    return [App.Rotation()] * len(samples)


def _turns_by_tangent(samples):
    """The first tangent from x with the least turn, then from tangent to tangent."""
    turns, turn, before = [], App.Rotation(), App.Vector(1, 0, 0)
    for _, tangent in samples:
        turn = _least_turn(before, tangent).multiply(turn)
        turns.append(turn)
        before = tangent
    return turns


def _turns_by_second(samples, others, objects):
    """x along the tangent, z as near as possible to the point of the second curve. Where that point
    lies on the tangent line, z is carried on from the pose before."""
    turns, before = [], None
    for (point, tangent), other in zip(samples, others):
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
                    'The second curve "{0}" lies on the tangent of the curve "{1}" at its '
                    "start, so it does not define the z axis: move the second curve "
                    "sideways.",
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
            translate(
                "Messages",
                '"{0}" has {1} separate pieces: join them into one curve, or select one piece.',
            ).format(obj.Label, len(groups))
        )
    return groups[0]


def _angle(a, b):
    """Between two directions (rad). FreeCAD's own is 0 for small angles."""
    return math.atan2(a.cross(b).Length, a.dot(b))


def _least_turn(a, b):
    """Smallest rotation from direction a to b; half a turn about any normal where they are opposite."""
    angle = _angle(a, b)
    if angle > math.pi - SMALL:
        other = App.Vector(0, 0, 1) if abs(a.z) < 0.9 else App.Vector(0, 1, 0)
        return App.Rotation(a.cross(other), 180)
    if angle < SMALL:  # FreeCAD's own rotation between such two has no numbers
        return App.Rotation()
    return App.Rotation(a.cross(b), math.degrees(angle))
