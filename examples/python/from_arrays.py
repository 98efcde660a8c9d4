# SPDX-License-Identifier: LGPL-2.1-or-later
"""Computes the envelope of a mesh object of another library, which is moved by matrices.

    python3 from_arrays.py envelope.ply

Any object with vertices (N, 3) and faces (M, 3) can be used, such as a trimesh.Trimesh.
"""
import sys
from typing import NamedTuple

import numpy as np
import numpy.typing as npt

import swept_volume as sv


class Shape(NamedTuple):
    """Stands for the mesh class of another library."""

    vertices: npt.NDArray[np.float64]
    faces: npt.NDArray[np.int64]


def octahedron(radius: float) -> Shape:
    points = np.vstack([np.eye(3), -np.eye(3)]) * radius
    faces = [(0, 1, 2), (3, 2, 1), (3, 4, 2), (0, 2, 4), (3, 1, 5), (0, 5, 1), (0, 4, 5), (3, 5, 4)]
    return Shape(points, np.array(faces))


def main(path: str) -> None:
    shape = octahedron(10.0)
    angles = np.linspace(0, np.pi / 2, 31)
    matrices = np.tile(np.eye(4), (len(angles), 1, 1))
    matrices[:, 0, 0] = matrices[:, 1, 1] = np.cos(angles)
    matrices[:, 1, 0], matrices[:, 0, 1] = np.sin(angles), -np.sin(angles)
    matrices[:, 0, 3] = 40 * np.sin(angles)  # mm, along x
    result = sv.compute(sv.Mesh(shape.vertices, shape.faces), matrices, resolution=64)
    result.mesh.write(path)
    print(result)


if __name__ == "__main__":
    main(sys.argv[1])
