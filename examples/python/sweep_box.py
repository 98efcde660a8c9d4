# SPDX-License-Identifier: LGPL-2.1-or-later
"""Computes the envelope of a box that slides and turns, and its smallest distance from a post.

    python3 sweep_box.py envelope.ply
"""
import logging
import sys
from typing import Sequence

import numpy as np

import swept_volume as sv


def box(size: Sequence[float], corner: Sequence[float] = (0.0, 0.0, 0.0)) -> sv.Mesh:
    corners = [[x, y, z] for z in (0, 1) for y in (0, 1) for x in (0, 1)]
    triangles = [
        (0, 2, 1), (1, 2, 3), (4, 5, 6), (5, 7, 6), (0, 1, 4), (1, 5, 4),
        (2, 6, 3), (3, 6, 7), (0, 4, 2), (2, 4, 6), (1, 3, 5), (3, 7, 5),
    ]  # fmt: skip
    return sv.Mesh(np.array(corners) * size + corner, triangles)


def slide_and_turn() -> sv.Motion:
    turn = 0.7
    quaternions = [[0, 0, 0, 1], [0, 0, np.sin(turn / 2), np.cos(turn / 2)]]
    return sv.Motion([0, 1], quaternions, [[0, 0, 0], [50, 0, 0]], interpolation="screw")


def main(path: str) -> None:
    logging.basicConfig(level=logging.INFO)
    body, motion = box([10, 20, 30]), slide_and_turn()
    with sv.RunContext() as run:
        result = sv.compute(body, motion, resolution=64, run=run)
    result.mesh.write(path)
    print(result)
    report = sv.clearance(body, motion, [("post", box([5, 5, 40], [40, 60, 0]))])
    print(report["summary"])


if __name__ == "__main__":
    main(sys.argv[1])
