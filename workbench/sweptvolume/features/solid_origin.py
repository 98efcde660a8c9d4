# SPDX-License-Identifier: LGPL-2.1-or-later
"""What an envelope was made from: the part with its CAD faces, and the motion. The core takes the
faces of a solid from them. No GUI."""
import numpy as np

from .. import apart, convert, core
from ..convert import InputProblem
from ..safe_file import no_room_text, passing
from .base import UP_TO_DATE
from .envelope_plan import Plan

#: How far the matrix of a link may differ from a rigid one.
SAME = 1e-9
#: With more poses, the core recognises the faces in the mesh even for a part with one face.
MOST_POSES = 2001


class Origin:
    """The part and the motion, independent of any document. part: an apart.Apart after detached();
    matrix: 4x4, from its coordinates to the frame that the poses move; motion: (times, matrices), to
    the coordinates of the mesh; interpolation: of the core."""

    def __init__(self, part, matrix, motion, interpolation):
        self._part, self._matrix = part, matrix
        self._motion, self._interpolation = motion, interpolation
        self._shape = None

    def argument(self, control):
        """Returns the argument `origin` of core.write_solid(). Any thread. Raises CoreError."""
        if self._shape is None:
            shape = self._part.copy().copy()
            shape.transformShape(_as_matrix(self._matrix))
            with passing(".brep") as path:
                try:
                    shape.exportBrep(path)
                except Exception:  # if the disk is full, FreeCAD raises an error without a reason
                    raise core.CoreError("ExportFailed", "WriteFailed", no_room_text()) from None
                self._shape = core.read_body_shape(path, control)
        return self._motion, self._interpolation, self._shape


def of(envelope, into_mesh):
    """Returns the Origin of an up-to-date envelope, or None if the core has to recognise the faces
    in the mesh: the envelope is grown or made of several parts, the part is a mesh, or its motion
    is curved or has too many poses. into_mesh: 4x4 from the world to the coordinates of the mesh.
    """
    if not core.has_solids() or envelope.Status != UP_TO_DATE:
        return None
    if envelope.Offset > 0 or envelope.Conservative or envelope.PositionFilter > 0:
        return None
    try:
        groups = Plan.of(envelope).groups()
        leaves = [leaf for pair in groups[0].pairs for leaf in convert.solid_leaves(*pair)]
        if len(groups) > 1 or len(leaves) > 1:
            return None
        moving = groups[0].rigid_motion()
    except InputProblem:
        return None
    (linked, path), (root, _) = leaves[0], groups[0].pairs[0]
    part = apart.of(linked)
    matrix = moving.into_base @ convert.global_matrix(root, path)
    if moving.curved() or part.is_mesh or len(part.shape.Solids) != 1 or not _is_rigid(matrix):
        return None
    poses, interpolation = moving.trajectory(0.0)
    if len(poses.times) > MOST_POSES:
        return None
    placed = into_mesh @ convert.matrices_from(*poses.arrays())
    times = np.array(poses.times, dtype=float)
    return Origin(part.detached(), matrix, (times, placed), interpolation)


def _is_rigid(matrix):
    turn = matrix[:3, :3]
    return np.allclose(turn.T @ turn, np.eye(3), atol=SAME) and np.linalg.det(turn) > 0


def _as_matrix(matrix):
    import FreeCAD as App

    return App.Matrix(*map(float, matrix.ravel()))
