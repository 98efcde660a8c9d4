# SPDX-License-Identifier: LGPL-2.1-or-later
"""Draws a motion: the path of its pivot as a line, with a small frame at each pose."""
import numpy as np

from ..convert import InputProblem, matrix_of, pose_arrays
from ..trajectory.poses import course
from .surface import fill

LINE = (0.85, 0.45, 0.05)
AXES = ((0.85, 0.15, 0.15), (0.15, 0.65, 0.15), (0.20, 0.35, 0.90))
#: Points drawn between two poses; largest number of poses that get a frame; largest number of poses
#: that are drawn smoothly.
BETWEEN, MOST_FRAMES, MOST_SMOOTH = 8, 200, 2000


class PathLines:
    """Coin nodes of the path and its frames, kept from picture to picture."""

    def __init__(self):
        from pivy import coin

        self.root, self.shown = coin.SoSeparator(), coin.SoSwitch()
        self.line, self.axes = _Lines(LINE, 3.0), [_Lines(colour, 2.0) for colour in AXES]
        for lines in [self.line] + self.axes:
            self.shown.addChild(lines.root)
        self.root.addChild(self.shown)

    def show(self, poses, interpolation, width=3.0, size=0.0):
        """Draws Poses. width: pixels; size: mm of the frames' axes, 0: depends on the path."""
        poses = poses.carried()
        self.shown.whichChild = -3 if len(poses) else -1  # -3: all children, -1: none
        if not len(poses):
            return
        points = points_of(poses, interpolation)
        self.line.fill(points, [len(points)], width)
        step = max(1, len(poses) // MOST_FRAMES)
        frames = np.array([matrix_of(p) for p in poses.placements[::step]])
        size = size or frame_size(poses)
        middles = frames[:, :3, 3]
        for axis, lines in enumerate(self.axes):
            ends = np.stack([middles, middles + size * frames[:, :3, axis]], axis=1)
            lines.fill(ends.reshape(-1, 3), [2] * len(frames), 2.0)


def points_of(poses, interpolation):
    """Returns the points (n,3) of the path of the poses' origin."""
    straight = interpolation in ("None", "Linear")
    if straight or not 2 <= len(poses) <= MOST_SMOOTH:
        return pose_arrays(poses.placements)[0]
    try:
        at, fine = course(poses, interpolation), []
    except InputProblem:  # an invalid spline; other code reports it
        return pose_arrays(poses.placements)[0]
    for a, b in zip(poses.times, poses.times[1:]):
        fine += [a + (b - a) * k / BETWEEN for k in range(BETWEEN)]
    fine.append(poses.times[-1])
    return np.array([tuple(at(t).Base) for t in fine])


def frame_size(poses):
    """Returns a suitable length of the axes for a path (mm)."""
    points = pose_arrays(poses.placements)[0]
    size = float((points.max(axis=0) - points.min(axis=0)).max()) if len(points) else 0.0
    return size * 0.05 or 1.0


class _Lines:
    """Lines of one colour."""

    def __init__(self, colour, width):
        from pivy import coin

        self.root, self.width = coin.SoSeparator(), width
        shade, self.style = coin.SoBaseColor(), coin.SoDrawStyle()
        shade.rgb = colour
        self.style.lineWidth = width
        light = coin.SoLightModel()
        light.model = coin.SoLightModel.BASE_COLOR
        self.where, self.lines = coin.SoCoordinate3(), coin.SoLineSet()
        for node in (light, shade, self.style, self.where, self.lines):
            self.root.addChild(node)
        self.lengths = []

    def fill(self, points, lengths, width):
        """Sets the lines. points (n,3); lengths: number of points in each line."""
        fill(self.where.point, np.asarray(points, np.float32))
        if lengths != self.lengths:
            self.lengths = lengths
            fill(self.lines.numVertices, np.array(lengths, np.int32))
        if width != self.width:
            self.width = self.style.lineWidth = width
