# SPDX-License-Identifier: LGPL-2.1-or-later
"""A motion drawn: the way of the poses' origin as a line, with a small frame at each pose."""
import numpy as np

from ..convert import matrix_of, pose_arrays
from ..trajectory.poses import course
from .surface import fill

LINE = (0.85, 0.45, 0.05)
AXES = ((0.85, 0.15, 0.15), (0.15, 0.65, 0.15), (0.20, 0.35, 0.90))
#: Points drawn between two poses, the most poses that get a frame, and that are drawn smoothly.
BETWEEN, MOST_FRAMES, MOST_SMOOTH = 8, 200, 2000


def drawn(poses, interpolation, width=3.0, size=0.0):
    """Coin node of Poses. width: pixels; size: mm of the frames' axes, 0: from the path."""
    from pivy import coin

    group = coin.SoSeparator()
    if not len(poses):
        return group
    group.addChild(_line(points_of(poses, interpolation), LINE, width))
    step = max(1, len(poses) // MOST_FRAMES)
    frames = np.array([matrix_of(p) for p in poses.placements[::step]])
    for axis in range(3):
        group.addChild(_axes(frames, axis, size or frame_size(poses)))
    return group


def points_of(poses, interpolation):
    """Points (n,3) of the way of the poses' origin."""
    straight = interpolation in ("None", "Linear")
    if straight or not 2 <= len(poses) <= MOST_SMOOTH:
        return pose_arrays(poses.placements)[0]
    at, fine = course(poses, interpolation), []
    for a, b in zip(poses.times, poses.times[1:]):
        fine += [a + (b - a) * k / BETWEEN for k in range(BETWEEN)]
    fine.append(poses.times[-1])
    return np.array([tuple(at(t).Base) for t in fine])


def frame_size(poses):
    """Length of the axes that suits a path (mm)."""
    points = pose_arrays(poses.placements)[0]
    size = float((points.max(axis=0) - points.min(axis=0)).max()) if len(points) else 0.0
    return size * 0.05 or 1.0


def _line(points, colour, width):
    return _lines(points, [len(points)], colour, width)


def _axes(frames, axis, size):
    """One axis of all frames (n,4,4) as one line set."""
    middles = frames[:, :3, 3]
    points = np.stack([middles, middles + size * frames[:, :3, axis]], axis=1).reshape(-1, 3)
    return _lines(points, [2] * len(frames), AXES[axis], 2.0)


def _lines(points, lengths, colour, width):
    """Lines of so many points each."""
    from pivy import coin

    group = coin.SoSeparator()
    shade, style = coin.SoBaseColor(), coin.SoDrawStyle()
    shade.rgb = colour
    style.lineWidth = width
    light = coin.SoLightModel()
    light.model = coin.SoLightModel.BASE_COLOR
    where, lines = coin.SoCoordinate3(), coin.SoLineSet()
    fill(where.point, np.asarray(points, np.float32))
    fill(lines.numVertices, np.array(lengths, np.int32))
    for node in (light, shade, style, where, lines):
        group.addChild(node)
    return group
