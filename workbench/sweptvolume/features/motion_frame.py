# SPDX-License-Identifier: LGPL-2.1-or-later
"""The coordinates of a motion in a group: its poses and the line that shows it are in the
coordinates of the group."""
from ..convert import global_placement, root_path
from ..trajectory.poses import Poses


def container_of(obj):
    """Returns the placement, in the document, of the group that holds a motion."""
    return global_placement(*root_path(obj))


def seen_from_document(poses, container):
    """Converts poses from the coordinates of a group with this placement to world coordinates."""
    if container.isIdentity():
        return poses
    tangents = [
        (kind, None if v is None else container.Rotation.multVec(v)) for kind, v in poses.tangents
    ]
    placements = [container.multiply(p) for p in poses.placements]
    return Poses(poses.times, placements, tangents, pivot=poses.pivot)


def from_world(obj, placement):
    """Converts a placement in world coordinates to a pose of a motion (by its PoseType)."""
    container = container_of(obj)
    inside = container.inverse().multiply(placement)
    return inside.multiply(container) if obj.PoseType == "Relative" else inside
