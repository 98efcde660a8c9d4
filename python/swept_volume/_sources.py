# SPDX-License-Identifier: LGPL-2.1-or-later
"""The sources of the triangles of an envelope, as arrays that can be pickled."""
from __future__ import annotations

from typing import Any, Tuple

import numpy as np
import numpy.typing as npt

from . import _core

from ._values import Floats, Integers, frozen


class Sources:
    """What made each of the M triangles of an envelope. All arrays are read-only.

    kind    int8 (M,): index into KINDS; -1: unknown
    faces   int32 (M, 2): for a cap or graze, the face and -1; for an edge, or for a graze between faces
            that meet smoothly, the two faces, the lower number first
    step    int32 (M,): index (from 0) of the pose of a cap, or of the pose at which the motion step of
            an edge or graze begins
    time    float64 (M,), s; nan: unknown
    point   float64 (M, 3), mm: a point of the exact surface near the triangle, through which the face
            or edge passes at that time; nan: unknown

    A cap is a face of the body at one pose. An edge was swept by an edge of the body, where two faces meet
    at 8 degrees or more. A graze was swept by the interior of a face that touches the envelope along a
    curve, by a face that slides along itself, or by two faces that meet smoothly. Faces are numbered as in
    Mesh.faces; if the mesh has none, each triangle of the body is a face. A triangle of a simplified
    envelope has the source that made the largest part of its area.
    """

    KINDS = ("cap", "edge", "graze")
    __slots__ = ("kind", "faces", "step", "time", "point")
    kind: npt.NDArray[np.int8]
    faces: Integers
    step: Integers
    time: Floats
    point: Floats

    def __init__(
        self,
        kind: npt.ArrayLike,
        faces: npt.ArrayLike,
        step: npt.ArrayLike,
        time: npt.ArrayLike,
        point: npt.ArrayLike,
    ) -> None:
        self.kind = frozen(kind, np.int8, (-1,), "kind")
        count = len(self.kind)
        self.faces = frozen(faces, np.int32, (count, 2), "faces")
        self.step = frozen(step, np.int32, (count,), "step")
        self.time = frozen(time, np.float64, (count,), "time")
        self.point = frozen(point, np.float64, (count, 3), "point")

    @classmethod
    def _of_core(cls, core: _core.Sources) -> Sources:
        return cls(core.kind, core.faces, core.step, core.time, core.point)

    def __len__(self) -> int:
        return len(self.kind)

    def __reduce__(self) -> Tuple[Any, ...]:
        return Sources, tuple(np.array(getattr(self, name)) for name in self.__slots__)

    def __repr__(self) -> str:
        counts = np.bincount(self.kind[self.kind >= 0], minlength=len(self.KINDS))
        kinds = ", ".join(f"{n} {kind}" for n, kind in zip(counts, self.KINDS))
        return f"<Sources: {kinds}, {int((self.kind < 0).sum())} not known>"
