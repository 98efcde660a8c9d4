# SPDX-License-Identifier: LGPL-2.1-or-later
"""Converts parts that move rigidly together, their motion and their reference part from the
document to plain arrays for the core. Reads documents only in the GUI thread.
"""
import FreeCAD as App
import numpy as np

from .. import contents, convert, core
from ..convert import InputProblem, matrix_of, transform
from ..quantities import number, quantity
from ..texts import translate
from ..trajectory import sources
from ..trajectory.poses import (
    INTERPOLATIONS,
    Poses,
    at_time,
    base_of,
    between,
    course,
    shift_to,
    straightened,
)
from . import motion as motion_feature


def _in_world(motion, standing):
    """Returns (poses, base). poses: those of the motion's pivot, in world coordinates. base: the
    present placement of the frame that these poses move. standing: the present placement of the
    part."""
    poses = motion_feature.world_poses_of(motion)
    base = base_of(poses, motion.PoseType, standing, motion_feature.container_of(motion))
    return poses.carried(), base.multiply(shift_to(poses.pivot))


#: Deviation over one step, as a fraction of the deviation over two steps: the deviation grows with
#: the square of the length.
SINGLE_STEP = 0.25


def middle_of(pairs, placement):
    """Returns the middle of the parts' common bounding box (Vector, mm), in the coordinates to
    which their placement applies."""
    inside = transform(matrix_of(placement.inverse()), convert.box_corners(pairs))
    middle = (0.5 * (inside.max(axis=0) + inside.min(axis=0))).round(6) + 0.0
    return App.Vector(*map(float, middle))


class BodyInFrame:
    """A convert.Body in another frame, for any thread. matrix: 4x4 from the world to that frame;
    motion: the object that moves the body, for its sources."""

    def __init__(self, body, matrix, motion=None):
        self.body, self.matrix = body, matrix
        self.motion = motion.Name if motion is not None else ""

    @property
    def vertices(self):
        return self.body.seen(self.matrix)

    @property
    def triangles(self):
        return self.body.triangles

    @property
    def faces(self):
        return self.body.faces

    @property
    def parts(self):
        return [dict(part, motion=self.motion) for part in self.body.parts]


def grouped(pairs, motions, *reference):
    """Returns the parts that move together, as a list of Moving. motions: one for each of pairs;
    reference: arguments of Moving."""
    groups = []
    for pair, motion in zip(pairs, motions):
        for group in groups:
            if group.motion is motion:
                group.pairs.append(pair)
                break
        else:
            groups.append(Moving([pair], motion, *reference))
    return groups


class RigidMotion:
    """The motion of parts that move rigidly together. Created in the GUI thread, where it reads the
    document; its methods then work in any thread. moving: a Moving that was checked."""

    def __init__(self, moving):
        motion = moving.motion
        self.label, self.from_joints = motion.Label, motion.SourceType in sources.FROM_JOINTS
        self.interpolation = motion.Interpolation
        self.poses, base = _in_world(motion, convert.global_placement(*moving.pairs[0]))
        self.into_base = matrix_of(base.inverse())
        self._reference, self._found = None, {}
        if moving.reference_motion is not None:
            standing = convert.global_placement(*moving.reference)
            kind = moving.reference_motion.Interpolation
            self._reference = (*_in_world(moving.reference_motion, standing), kind)
        self._corners = None
        if self.curved() or self.from_joints:
            self._corners = transform(self.into_base, convert.box_corners(moving.pairs))

    def curved(self):
        """Returns whether straight segments approximate a curved motion for the core."""
        return self._reference is not None or self.interpolation == "Spline"

    def course(self):
        """Returns the placements of trajectory() as a function of time (s)."""
        return course(self.poses, self.interpolation)

    def frame_deviation(self):
        """Returns the same as Moving.frame_deviation()."""
        if not self.from_joints or self.interpolation == "None":
            return 0.0, ""
        poses = self.poses
        if len(poses) < 3:
            return 0.0, ""
        there = [self._without(k) for k in range(1, len(poses) - 1)]
        off = convert.matrices_from(*convert.pose_arrays(there))
        off -= convert.matrices_from(*poses.arrays())[1:-1]
        moved = np.einsum("kij,pj->kpi", off[:, :3, :3], self._corners) + off[:, None, :3, 3]
        reach = SINGLE_STEP * np.linalg.norm(moved, axis=2).max(axis=1)
        most, where = float(reach.max()), poses.times[1 + int(reach.argmax())]
        text = translate(
            "SweptVolume",
            'The steps of "{0}" are large: near t = {1} s the part may be about {2} away from '
            "its true position. Record the motion again with smaller steps.",
        ).format(self.label, number(where), quantity(most))
        return most, text

    def _without(self, k):
        """Returns the placement at the time of frame k, interpolated between the frames before and
        after it."""
        times, placements = self.poses.times, self.poses.placements
        a, b = times[k - 1], times[k + 1]
        if self.interpolation == "Spline" or a == b:
            two = Poses([a, b], [placements[k - 1], placements[k + 1]])
            return at_time(two, self.interpolation, times[k])
        u = (times[k] - a) / (b - a)
        return between(placements[k - 1], placements[k + 1], u, self.interpolation)

    def trajectory(self, tolerance):
        """Returns the same as Moving.trajectory()."""
        if not self.curved():
            return self.poses, INTERPOLATIONS[self.interpolation]
        at, knots = self.course(), self.poses.times
        if self._reference is not None:
            self.poses.check_function()
            at, knots, steps = self._seen_from_reference(at, knots)
            if steps or self.interpolation == "None":
                return Poses(knots, [at(t) for t in knots]), INTERPOLATIONS["None"]
        reach = float(np.linalg.norm(self._corners, axis=1).max())
        return straightened(at, knots, reach, tolerance), INTERPOLATIONS["Linear"]

    def _seen_from_reference(self, at, knots):
        poses, base, kind = self._reference
        poses.check_function()
        there = course(poses, kind)

        def seen(time):
            return base.multiply(there(time).inverse()).multiply(at(time))

        inside = [t for t in poses.times if knots[0] < t < knots[-1]]
        return seen, sorted(set(knots).union(inside)), kind == "None"

    def request(self, body, tolerance, options):
        """Returns the core.Request that moves a body. The body is in the base frame. tolerance: as
        in trajectory()."""
        if tolerance not in self._found:
            poses, interpolation = self.trajectory(tolerance)
            times = np.array(poses.times, dtype=float)
            self._found[tolerance] = (times, *poses.arrays(), interpolation)
        return core.Request(body, *self._found[tolerance], options)


class Moving:
    """Moving parts with one motion. reference: (root, sub) of a part that reference_motion moves.
    The result is then relative to this part at its present placement."""

    def __init__(self, pairs, motion, reference=None, reference_motion=None):
        self.pairs = list(pairs)
        self.motion = motion
        self.reference = reference
        self.reference_motion = reference_motion

    def check(self):
        """Raises InputProblem if an input is missing."""
        if self.motion is None or not motion_feature.is_motion(self.motion):
            raise InputProblem(
                translate(
                    "SweptVolume", "No motion is chosen: choose one, or make one with New motion."
                )
            )
        motion_feature.check_usable(self.motion)
        if not self.pairs:
            raise InputProblem(convert.no_part_text())
        given = self.reference_motion
        if given is not None and not motion_feature.is_motion(given):
            raise InputProblem(
                translate("SweptVolume", '"{0}" is not a motion: choose a motion.').format(
                    given.Label
                )
            )
        if given is None and self.reference is not None:
            raise InputProblem(
                translate(
                    "SweptVolume",
                    "The reference part has no motion: choose its motion, or clear the "
                    "reference part.",
                )
            )
        if given is not None:
            motion_feature.check_usable(given)
        if given is not None and self.reference is None:
            raise InputProblem(
                translate(
                    "SweptVolume",
                    "A reference motion is chosen, but no reference part: choose the "
                    "reference part too, or clear the reference motion.",
                )
            )

    def words(self):
        """Returns what identifies geometry and motion: texts and apart.Apart objects, as from
        contents.words(). Raises InputProblem."""
        self.check()
        words = contents.words(self.pairs) + motion_feature.words(self.motion)
        if self.reference_motion is not None:
            standing = convert.global_placement(*self.reference)
            words.append(contents.matrices(convert.matrix_of(standing)))
            words += motion_feature.words(self.reference_motion)
        return words

    def words_of_before(self):
        """Returns the words of version 1, to recognise its results."""
        self.check()
        words = [contents.signature_of_before(self.pairs)]
        words += motion_feature.words_of_before(self.motion)
        if self.reference_motion is not None:
            standing = convert.global_placement(*self.reference)
            words.append(np.array2string(convert.matrix_of(standing), precision=9))
            words += motion_feature.words_of_before(self.reference_motion)
        return words

    def rigid_motion(self):
        """Returns the RigidMotion, which reads the document. Raises InputProblem."""
        self.check()
        return RigidMotion(self)

    def into_base(self):
        """Returns the 4x4 matrix from the present world coordinates to the frame to which the
        placements apply."""
        return self.rigid_motion().into_base

    def corners(self):
        """Returns the corners of the parts' bounding boxes in the base frame (k,3). Fast."""
        return convert.transform(self.into_base(), convert.box_corners(self.pairs))

    def frame_deviation(self):
        """Returns (mm, text): how far the part may deviate from its interpolated path between two
        frames of a mechanism. The estimate compares each frame with the placement interpolated
        between the frames before and after it. 0 if the poses are keys."""
        return self.rigid_motion().frame_deviation()

    def outline(self):
        """Returns a function for any thread. It returns the outermost points of the parts in the
        base frame (k,3) as a body, with triangles that connect them."""
        matrix, outline = self.into_base(), contents.outline(self.pairs)

        def found():
            points = convert.transform(matrix, outline())
            strip = np.arange(len(points))[:, None] + np.arange(3)
            return core.Triangles(points, (strip % len(points)).astype(np.int32))

        return found

    def course(self):
        """Returns the placements of trajectory() as a function of time (s)."""
        return self.rigid_motion().course()

    def trajectory(self, tolerance):
        """Returns (Poses, interpolation of the core). tolerance: mm by which straight segments may
        deviate from a curved motion."""
        return self.rigid_motion().trajectory(tolerance)

    def request(self, body, tolerance, options):
        """Returns the core.Request that moves a body. The body is in the base frame."""
        return self.rigid_motion().request(body, tolerance, options)

    def body_request(self, deflection, tolerance, options, read=convert.body_from):
        """Returns the core.Request that moves the parts themselves. deflection: mm, for solids;
        read: a function like convert.body_from()."""
        rigid_motion = self.rigid_motion()
        body = BodyInFrame(read(self.pairs, deflection), rigid_motion.into_base, self.motion)
        return rigid_motion.request(body, tolerance, options)
