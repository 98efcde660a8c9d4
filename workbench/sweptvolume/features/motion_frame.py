# SPDX-License-Identifier: LGPL-2.1-or-later
"""Poses of a motion in a group: they count there, as the line that is drawn does."""
from ..convert import global_placement, root_path
from ..trajectory.poses import Poses


def container_of(obj):
    """Placement of the group that holds a motion, through all groups around it."""
    return global_placement(*root_path(obj))


def seen_from_document(poses, container):
    """Poses of a group with that placement, as the document sees them."""
    if container.isIdentity():
        return poses
    tangents = [
        (kind, None if v is None else container.Rotation.multVec(v)) for kind, v in poses.tangents
    ]
    placements = [container.multiply(p) for p in poses.placements]
    return Poses(poses.times, placements, tangents, pivot=poses.pivot)


def from_world(obj, placement):
    """A pose of a motion (by its Frame) that is given as seen from the document."""
    container = container_of(obj)
    inside = container.inverse().multiply(placement)
    return inside.multiply(container) if obj.PoseType == "Relative" else inside
