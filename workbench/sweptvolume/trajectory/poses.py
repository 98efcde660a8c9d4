# SPDX-License-Identifier: LGPL-2.1-or-later
"""A motion as a plain value: times (s) and placements (mm), with the rules for using it."""
import FreeCAD as App
import numpy as np

from ..convert import InputProblem, matrix_of, transform
from ..texts import mark, translate

#: Name in the property -> name the core knows.
INTERPOLATIONS = {"None": "none", "Linear": "linear", "Screw": "screw"}

#: What a pose of the motion means for the part (property Frame).
FRAMES = ["Absolute", "Relative", "RelativeToFirst"]
FRAME_HELP = mark(
    "Properties",
    "What a pose means.\n"
    "Absolute: the placement the part has at that time, instead of the one it has now (default; "
    "captured placements and recorded motions are of this kind).\n"
    "Relative: a displacement on top of where the part stands now; the identity leaves it there.\n"
    "RelativeToFirst: as Relative, measured from the first pose: the motion starts where the part "
    "stands now.\n"
    "Several parts move rigidly together; Absolute places the first of them.",
)


class Poses:
    """Times and placements, checked."""

    def __init__(self, times, placements):
        self.times = [float(t) for t in times]
        self.placements = [App.Placement(p) for p in placements]
        if len(self.times) != len(self.placements):
            raise InputProblem(
                translate("Messages", "the motion has {0} times and {1} placements.").format(
                    len(self.times), len(self.placements)
                )
            )
        for i in range(1, len(self.times)):
            if not self.times[i] > self.times[i - 1]:
                raise InputProblem(
                    translate(
                        "Messages",
                        "pose {0}: its time {1:g} s is not after the {2:g} s of the pose before; times "
                        "must grow.",
                    ).format(i + 1, self.times[i], self.times[i - 1])
                )

    def __len__(self):
        return len(self.times)


def even_times(count, step=1.0):
    """Times for poses that come without any: one a step (s)."""
    return [i * step for i in range(count)]


def in_frame(poses, frame, standing):
    """Placements to apply to the body, and the frame in which the body is to be given.

    Returns (placements, base): x_world(t) = placement(t) * base^-1 * x_world(now).
    """
    if not poses.placements:
        raise InputProblem(translate("Messages", "the motion has no poses: add at least one."))
    if frame == "Absolute":
        return list(poses.placements), App.Placement(standing)
    if frame == "Relative":
        return list(poses.placements), App.Placement()
    if frame == "RelativeToFirst":
        back = poses.placements[0].inverse()
        return [p.multiply(back) for p in poses.placements], App.Placement()
    raise InputProblem(
        translate("Messages", 'the frame "{0}" is unknown; allowed: {1}.').format(
            frame, ", ".join(FRAMES)
        )
    )


def swept_box(points, placements):
    """Lower and upper corner (mm) of points moved to every placement: the size of the sweep."""
    low, high = np.full(3, np.inf), np.full(3, -np.inf)
    for placement in placements:
        moved = transform(matrix_of(placement), points)
        low = np.minimum(low, moved.min(axis=0))
        high = np.maximum(high, moved.max(axis=0))
    return low, high


def at_time(poses, interpolation, time):
    """Placement at a time, as the core interpolates (none: the last pose reached)."""
    times = poses.times
    if time <= times[0]:
        return App.Placement(poses.placements[0])
    if time >= times[-1]:
        return App.Placement(poses.placements[-1])
    k = int(np.searchsorted(times, time, side="right")) - 1
    a, b = poses.placements[k], poses.placements[k + 1]
    u = (time - times[k]) / (times[k + 1] - times[k])
    if interpolation == "None":
        return App.Placement(a)
    if interpolation == "Screw":
        return a.sclerp(b, u)
    base = a.Base + (b.Base - a.Base) * u
    return App.Placement(base, a.Rotation.slerp(b.Rotation, u))
