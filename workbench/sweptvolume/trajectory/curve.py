# SPDX-License-Identifier: LGPL-2.1-or-later
"""Poses along a wire, edge, sketch or Draft wire. The position follows the arc length. The
orientation is fixed, follows the tangent with the least turn, or follows a second curve. It
never flips.

The ends of all edges are poses; between them there are as many poses as the accuracy requires. At a
corner, a part that follows the tangent turns in place."""
import bisect
import math

import FreeCAD as App
import Part

from ..convert import InputProblem, global_placement, root_path
from ..quantities import count, quantity
from ..texts import translate
from .poses import Poses, even_times

#: Fixed: the part does not turn. Tangent: the x axis of the part follows the tangent. SecondCurve:
#: x follows the tangent, and z points to the point of a second curve at the same fraction of its
#: length.
ORIENTATIONS = ["Fixed", "Tangent", "SecondCurve"]
#: Default (mm) for how far the straight line between two poses may deviate from the curve. It is
#: the smallest value that FreeCAD's fields show in mm; a smaller one would be shown in micrometres,
#: and a number typed then would be in micrometres, too.
ACCURACY = 0.1
#: A motion with more poses would block the window for seconds at each recompute.
MAX_POSES = 20_000
#: An edge is halved at most this often. Its pieces are then about as short as the smallest distance
#: between two points that can be distinguished.
MAX_HALVINGS = 24
#: A smaller turn (rad) between two edges is ignored. At a distance of 500 m, this turn moves a
#: point by half a millimetre.
CORNER = 1e-6
#: Fractions between two poses at which the deviation of the curve is measured. Two are irrational:
#: at simple fractions alone, a helix of several turns would look straight.
TEST_FRACTIONS = (math.sqrt(5) - 2, 0.5, math.sqrt(0.5))
#: Duration of a full turn in place, as a fraction of the duration of the path.
TURN_FRACTION = 0.25
#: Below this fraction of a length, two points count as equal and two directions as parallel.
SMALL = 1e-9


def is_curve(obj):
    """Returns whether an object consists of edges only (no faces)."""
    shape = getattr(obj, "Shape", None)
    return shape is not None and bool(shape.Edges) and not shape.Faces


def poses(objects, count, orientation, duration):
    """Returns `count` poses at equal arc lengths over `duration` s, regardless of corners, for
    motions of older documents. objects: the path, then for SecondCurve the curve that sets the
    orientation."""
    edges = _path(objects, orientation)
    if count < 2:
        raise InputProblem(
            translate(
                "SweptVolume",
                "A curve needs at least two poses: set Count to 2 or more, or to 0 (Accuracy "
                "then determines the number).",
            )
        )
    track = _Track(edges)
    samples = [track.sample(track.total * i / (count - 1)) for i in range(count)]
    fractions = [i / (count - 1) for i in range(count)]
    turns = _turns(samples, fractions, orientation, objects)
    placements = [App.Placement(point, turn) for (point, _), turn in zip(samples, turns)]
    return Poses(even_times(count, duration / (count - 1)), placements)


def poses_within(objects, accuracy, orientation, duration):
    """Returns poses over `duration` s. The straight line between two poses deviates from the curve
    by at most `accuracy` (mm). For a part that turns and is about as large as the path, this
    holds for all its points. objects: the path, then for SecondCurve the curve that sets the
    orientation."""
    edges = _path(objects, orientation)
    if not accuracy > 0:
        raise InputProblem(
            translate("SweptVolume", "The accuracy is {0}: enter a value greater than 0.").format(
                quantity(accuracy)
            )
        )
    track = _Track(edges)
    samples, lengths, clock = _adaptive(track, accuracy, orientation != "Fixed")
    fractions = [length / track.total for length in lengths]
    turns = _turns(samples, fractions, orientation, objects)
    placements = [App.Placement(point, turn) for (point, _), turn in zip(samples, turns)]
    return Poses([duration * passed / clock[-1] for passed in clock], placements)


def _path(objects, orientation):
    """Returns the edges of the path. Raises InputProblem."""
    wanted = 2 if orientation == "SecondCurve" else 1
    if len(objects) < wanted or not all(is_curve(obj) for obj in objects[:wanted]):
        raise InputProblem(
            translate(
                "SweptVolume",
                "Select two wires: the curve to follow, then the curve that sets the orientation.",
            )
            if wanted == 2
            else translate("SweptVolume", "Select one wire, edge or sketch to follow.")
        )
    return _edges(objects[0])


class _Track:
    """Successive edges, parametrised by arc length (mm)."""

    def __init__(self, edges):
        self.edges = edges
        self.ends = [0.0]
        for edge in edges:
            self.ends.append(self.ends[-1] + edge.Length)
        self.total = self.ends[-1]

    def sample(self, length):
        """Returns (point, unit tangent) at a length. At a corner, both belong to the edge before
        it."""
        k = bisect.bisect_left(self.ends, length, 1, len(self.edges)) - 1
        return self.on_edge(k, length - self.ends[k])

    def on_edge(self, k, along):
        edge = self.edges[k]
        along = min(max(along, 0.0), edge.Length)
        back = edge.Orientation == "Reversed"
        parameter = edge.getParameterByLength(edge.Length - along if back else along)
        return self._there(edge, parameter, back)

    def at_part(self, k, part):
        """Returns (point, unit tangent) on edge k at a fraction of its parameter range. Much faster
        than sample()."""
        return self._there(
            self.edges[k], self._parameter(k, part), self.edges[k].Orientation == "Reversed"
        )

    def length_between(self, k, a, b):
        """Returns the arc length (mm) between two fractions of edge k."""
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
    """Returns samples (point, tangent), their lengths on the track, and a clock. The clock follows
    the length; for a part that turns, it also advances at corners."""
    box = Part.Compound(track.edges).BoundBox
    reach = box.DiagonalLength if turning else 0.0
    samples, lengths, clock = [track.at_part(0, 0.0)], [0.0], [0.0]

    def put(sample, length, time):
        if len(samples) >= MAX_POSES:
            raise InputProblem(
                translate(
                    "SweptVolume",
                    "An accuracy of {0} needs more than {1} poses on this curve: enter a larger "
                    "value, which is less accurate.",
                ).format(quantity(accuracy), count(MAX_POSES))
            )
        samples.append(sample)
        lengths.append(length)
        clock.append(time)

    for k in range(len(track.edges)):
        first = track.at_part(k, 0.0)
        if turning and _angle(first[1], samples[-1][1]) > CORNER:
            for step, tangent in _turn_in_place(samples[-1][1], first[1]):
                put(
                    (first[0], tangent),
                    track.ends[k],
                    clock[-1] + step * TURN_FRACTION * track.total,
                )
        here, done = first, 0.0
        waiting = [(track.at_part(k, 1.0), 1.0, 0)]
        while waiting:
            there, part, depth = waiting[-1]
            may_halve = depth < MAX_HALVINGS
            if may_halve and _deviation(track, k, done, here, part, there, reach) > accuracy:
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


def _deviation(track, k, a, here, b, there, reach):
    """Returns how far (mm) the straight line between two samples deviates from edge k. Also
    accounts for the turn between their tangents at a distance `reach`. Measured at TEST_FRACTIONS.
    """
    turn, line, most = _least_turn(here[1], there[1]), there[0] - here[0], 0.0
    for u in TEST_FRACTIONS:
        point, tangent = track.at_part(k, a + (b - a) * u)
        fraction = (point - here[0]).dot(line) / max(line.dot(line), 1e-300)
        fraction = min(max(fraction, 0.0), 1.0)  # the nearest point of the straight line
        off = (point - here[0] - line * fraction).Length
        if reach:
            part = App.Rotation(turn.Axis, math.degrees(turn.Angle) * fraction)
            off += reach * _angle(part.multVec(here[1]), tangent)
        most = max(most, off)
    return most


def _turn_in_place(before, behind):
    """Returns (fraction of a full turn, tangent) for each step of the turn between two directions.
    Each step is at most a right angle, so that the sense of rotation is unambiguous."""
    turn = _least_turn(before, behind)
    steps = 2 if turn.Angle > math.pi / 2 else 1
    part = turn.Angle / (2 * math.pi) / steps
    half = App.Rotation(turn.Axis, math.degrees(turn.Angle) / 2).multVec(before)
    return [(part, half), (part, behind)] if steps == 2 else [(part, behind)]


def _turns(samples, fractions, orientation, objects):
    """Returns the rotation of the part at each sample. fractions: position of each sample along the
    path, 0 to 1."""
    if orientation == "SecondCurve":
        track = _Track(_edges(objects[1]))
        ends, start = [track.sample(x)[0] for x in (0.0, track.total)], samples[0][0]
        if (ends[0] - start).Length > (ends[1] - start).Length:
            # The second curve runs in the opposite direction.
            fractions = [1.0 - fraction for fraction in fractions]
        others = [track.sample(track.total * fraction)[0] for fraction in fractions]
        return _turns_by_second(samples, others, objects)
    if orientation == "Tangent":
        return _turns_by_tangent(samples)
    return [App.Rotation()] * len(samples)


def _turns_by_tangent(samples):
    """Returns rotations that turn x to the first tangent, and then from tangent to tangent, always
    by the least turn."""
    turns, turn, before = [], App.Rotation(), App.Vector(1, 0, 0)
    for _, tangent in samples:
        turn = _least_turn(before, tangent).multiply(turn)
        turns.append(turn)
        before = tangent
    return turns


def _turns_by_second(samples, others, objects):
    """Returns rotations: x points along the tangent, z as closely as possible to the point of the
    second curve. If that point lies on the line of the tangent, the rotation of the pose before
    turns with the tangent."""
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
                    "SweptVolume",
                    'At the start of the curve "{1}", its tangent passes through the second '
                    'curve "{0}". So the second curve does not define the z axis there: move it '
                    "away from this tangent.",
                ).format(objects[1].Label, objects[0].Label)
            )
        turns.append(turn)
        before = turn
    return turns


def _edges(obj):
    """Returns the edges of an object in order, in world coordinates."""
    shape = obj.Shape.copy()
    shape.Placement = global_placement(*root_path(obj))
    groups = Part.sortEdges(shape.Edges)
    if len(groups) != 1:
        raise InputProblem(
            translate(
                "SweptVolume",
                '"{0}" has {1} separate pieces: join them into one curve, or select one piece.',
            ).format(obj.Label, len(groups))
        )
    return groups[0]


def _angle(a, b):
    """Returns the angle between two directions (rad). FreeCAD's own function returns 0 for small
    angles."""
    return math.atan2(a.cross(b).Length, a.dot(b))


def _least_turn(a, b):
    """Returns the smallest rotation from direction a to b. For opposite directions it is half a
    turn about any normal."""
    angle = _angle(a, b)
    if angle > math.pi - SMALL:
        other = App.Vector(0, 0, 1) if abs(a.z) < 0.9 else App.Vector(0, 1, 0)
        return App.Rotation(a.cross(other), 180)
    if angle < SMALL:  # FreeCAD's own rotation would be NaN here
        return App.Rotation()
    return App.Rotation(a.cross(b), math.degrees(angle))
