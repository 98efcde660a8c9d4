# SPDX-License-Identifier: LGPL-2.1-or-later
"""A motion as a plain value: times (s) and placements (mm), with checks and interpolation."""
import FreeCAD as App
import numpy as np

from ..convert import InputProblem, matrices_from, pose_arrays
from ..texts import QT_TRANSLATE_NOOP, translate
from .spline import Spline, rotation_vector

#: Name in the property -> name in the core. A spline is converted to straight segments.
INTERPOLATIONS = {"None": "none", "Linear": "linear", "Screw": "screw", "Spline": "linear"}
#: A curved path is halved until its straight segments are accurate enough, at most this often.
MOST_HALVINGS = 10

#: Values of the property PoseType: what a pose means for the part.
FRAMES = ["Absolute", "Relative", "RelativeToFirst"]
FRAME_HELP = QT_TRANSLATE_NOOP(
    "App::Property",
    "What a pose means.\n"
    "Absolute: the pose replaces the current placement of the part. This is the default; "
    "captured placements and recorded motions use it.\n"
    "Relative: the pose is added to the current placement of the part. A pose without shift and "
    "rotation leaves the part in place.\n"
    "RelativeToFirst: as Relative, but measured from the first pose. The motion starts at the "
    "current placement of the part.\n"
    "Several parts move together as one rigid body; with Absolute, the poses are those of the "
    "first part. A motion in a group (App::Part) uses the coordinates of the group and moves with the group.",
)


class Poses:
    """Times and placements, checked. `tangents` (spline.py) are used by the interpolation Spline.
    note: a note from reading the poses. pivot: the point (mm, in the coordinates to which the
    placements apply) that moves along the straight line or spline between two poses, and whose
    velocities the tangents give. `moved`: other objects that the source moves, if that was
    recorded."""

    def __init__(self, times, placements, tangents=(), note="", pivot=None):
        self.note, self.moved = note, []
        self.pivot = App.Vector(pivot) if pivot is not None else App.Vector()
        self.tangents = list(tangents)
        self.times = [float(t) for t in times]
        self.placements = list(placements)
        self._arrays = None
        if len(self.times) != len(self.placements):
            raise InputProblem(
                translate(
                    "SweptVolume",
                    "The motion has {0} times but {1} placements: give one time for each placement.",
                ).format(len(self.times), len(self.placements))
            )
        self._check_times()

    def _check_times(self):
        times = np.array(self.times)
        for i in np.flatnonzero(~np.isfinite(times))[:1]:
            text = translate(
                "SweptVolume",
                "Pose {0}: the time is {1:g}, but must be a finite number. Correct it.",
            )
            raise InputProblem(text.format(i + 1, times[i]))
        for i in np.flatnonzero(times[1:] < times[:-1])[:1]:
            text = translate(
                "SweptVolume",
                "Pose {0}: its time {1:g} s is earlier than the time {2:g} s of the pose before. "
                "Correct one of these times; times must not decrease.",
            )
            raise InputProblem(text.format(i + 2, times[i + 1], times[i]))

    def __len__(self):
        return len(self.times)

    def know_arrays(self, translations, rotations):
        """Sets the result of arrays(), if the caller already knows it."""
        self._arrays = translations, rotations

    def arrays(self):
        """Returns translations (n,3) in mm and quaternions (n,4) as x, y, z, w, as
        convert.pose_arrays() does."""
        return self._arrays or pose_arrays(self.placements)

    def check_function(self):
        """Raises InputProblem if two poses have the same time. The part then still moves between
        them, but its placement is not a function of time. Splines and moving reference parts need
        such a function.
        """
        for i in range(1, len(self.times)):
            if self.times[i] == self.times[i - 1]:
                raise InputProblem(
                    translate(
                        "SweptVolume",
                        "Poses {0} and {1} have the same time ({2:g} s): give them different "
                        "times, because the motion is a spline or has a reference part.",
                    ).format(i, i + 1, self.times[i])
                )

    def carried(self):
        """Returns the same motion for coordinates with the pivot as origin."""
        if not self.pivot.Length:
            return self
        shift = shift_to(self.pivot)
        return Poses(self.times, [p.multiply(shift) for p in self.placements], self.tangents)


def shift_to(pivot):
    """Returns the transformation from coordinates with the pivot as origin to those in which the
    pivot is given."""
    return App.Placement(pivot, App.Rotation())


def even_times(count, step=1.0):
    """Returns evenly spaced times for poses without times; step in s."""
    return [i * step for i in range(count)]


def base_of(poses, frame, standing, container=None):
    """Returns the frame in which the body must be given: x_world(t) = placement(t) * base^-1 *
    x_world(now). standing: present placement of the first part. container: placement of the
    group that holds the motion, in whose coordinates displacements are given; None for a motion
    outside groups."""
    if not poses.placements:
        raise InputProblem(translate("SweptVolume", "The motion has no poses: add at least one."))
    if frame == "Absolute":
        return App.Placement(standing)
    if frame == "Relative":
        return App.Placement(container or App.Placement())
    if frame == "RelativeToFirst":
        return App.Placement(poses.placements[0])
    raise InputProblem(
        translate("SweptVolume", 'The pose type "{0}" is unknown: use one of these: {1}.').format(
            frame, ", ".join(FRAMES)
        )
    )


def swept_box(points, poses):
    """Returns the lower and upper corner (mm) of points (k,3) moved to every pose: the size of the
    sweep."""
    matrices = matrices_from(*poses.arrays())
    moved = np.einsum("nij,kj->nki", matrices[:, :3, :3], points) + matrices[:, None, :3, 3]
    return moved.min(axis=(0, 1)), moved.max(axis=(0, 1))


def at_time(poses, interpolation, time):
    """Returns the placement at a time, interpolated as in the core. Without interpolation, returns
    the last pose that was reached."""
    return course(poses, interpolation)(time)


def course(poses, interpolation):
    """Returns the motion as a function time -> Placement. It is constant before the first and after
    the last pose. Of several poses with the same time, the last one counts. Raises InputProblem
    for a spline through such poses."""
    if poses.pivot.Length:
        carried, back = course(poses.carried(), interpolation), shift_to(-poses.pivot)
        return lambda time: carried(time).multiply(back)
    times, placements, spline = poses.times, poses.placements, None
    if interpolation == "Spline":
        poses.check_function()
        spline = Spline(times, placements, poses.tangents)

    def at(time):
        if time <= times[0]:
            return App.Placement(placements[0])
        if time >= times[-1]:
            return App.Placement(placements[-1])
        if spline is not None:
            return spline.at(time)
        k = int(np.searchsorted(times, time, side="right")) - 1
        a, b = placements[k], placements[k + 1]
        u = (time - times[k]) / (times[k + 1] - times[k])
        return App.Placement(a) if interpolation == "None" else between(a, b, u, interpolation)

    return at


def between(a, b, u, interpolation):
    """Returns the placement between two others. u: 0 to 1. interpolation: Linear or Screw."""
    if interpolation == "Screw":
        return a.sclerp(b, u)
    return App.Placement(a.Base + (b.Base - a.Base) * u, a.Rotation.slerp(b.Rotation, u))


def straightened(at, knots, reach, tolerance):
    """Converts a function time -> Placement to poses that the core may connect by straight segments
    (Linear).

    knots: times (s) that must be poses. reach: largest distance of a point of the part from the
    origin of the poses. tolerance: mm by which such a point may deviate from its path, tested at
    three points of each segment.
    """
    times, placements = [knots[0]], [at(knots[0])]
    for last in knots[1:]:
        waiting = [(last, at(last), 0)]
        while waiting:
            b, there, depth = waiting[-1]
            a, here = times[-1], placements[-1]
            if depth < MOST_HALVINGS and _deviation(at, a, here, b, there, reach) > tolerance:
                middle = 0.5 * (a + b)
                waiting[-1] = (b, there, depth + 1)
                waiting.append((middle, at(middle), depth + 1))
            else:
                times.append(b)
                placements.append(there)
                waiting.pop()
    return Poses(times, placements)


def _deviation(at, a, here, b, there, reach):
    """Returns how far (mm) a point within `reach` can be from its place on the straight segment, at
    three times between a and b."""
    most = 0.0
    for u in (0.25, 0.5, 0.75):
        true = at(a + (b - a) * u)
        base = here.Base + (there.Base - here.Base) * u
        turn = here.Rotation.slerp(there.Rotation, u)
        angle = rotation_vector(true.Rotation.inverted().multiply(turn)).Length
        most = max(most, (true.Base - base).Length + reach * angle)
    return most
