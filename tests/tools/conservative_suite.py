#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Conservative envelopes of the shared meshes and motions against 2,000 random points of each sweep.

The points lie on the body's surface at random times (slerp and straight line between poses); none may lie
outside the envelope. The bound in the report must be at most three cells. No vertex of the envelope may be
farther from the moving body than this bound: 100 vertices are measured over the whole motion.
Usage: conservative_suite.py BUILD [RESOLUTION] [MESH...]     ends with 1 if a case fails
"""
import pathlib
import sys

import numpy as np

from shared_data import FOLDER, MOTIONS, matrices, rotate, scaled_motion

POINTS = 2000
MEASURED = 100


def slerp(a, b, s):
    """Interpolates between the rows of a and b (unit quaternions), along the shorter arc."""
    dot = np.sum(a * b, axis=1, keepdims=True)
    b = np.where(dot < 0, -b, b)
    angle = np.arccos(np.clip(np.abs(dot), 0, 1))
    sine = np.sin(angle)
    near = sine < 1e-9
    safe = np.where(near, 1, sine)
    first = np.where(near, 1 - s, np.sin((1 - s) * angle) / safe)
    second = np.where(near, s, np.sin(s * angle) / safe)
    q = first * a + second * b
    return q / np.linalg.norm(q, axis=1, keepdims=True)


def sweep_points(body, q, t, random):
    """Returns random points of the true sweep."""
    vertices, triangles = np.asarray(body.vertices), np.asarray(body.triangles)
    chosen = triangles[random.integers(0, len(triangles), POINTS)]
    weights = random.dirichlet((1, 1, 1), POINTS)
    weights[::5] = (1, 0, 0)  # a fifth of the points: corners, which are lost first
    x = np.einsum("nk,nkd->nd", weights, vertices[chosen])
    k = random.integers(0, max(len(q) - 1, 1), POINTS)
    s = random.random((POINTS, 1)) if len(q) > 1 else np.zeros((POINTS, 1))
    after = np.minimum(k + 1, len(q) - 1)
    return rotate(slerp(q[k], q[after], s), x) + (1 - s) * t[k] + s * t[after]


def farthest_vertex(swept, body, poses, result, random):
    """Returns the largest distance (cells) from some vertices of the result to the moving body."""
    cell = result.report["cell"]
    vertices = np.asarray(result.vertices)
    speck = 1e-6 * cell * np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0]], dtype=float)
    parts = [
        (str(i), speck + vertices[i], np.array([[0, 1, 2]]))
        for i in random.integers(0, len(vertices), MEASURED)
    ]
    found = swept.clearance(
        body.vertices,
        body.triangles,
        poses,
        parts,
        tolerance=0.01 * cell,
        curve=0,
        penetration=False,
    )
    return max(row["distance"] for row in found["neighbours"]) / cell


def main():
    build = pathlib.Path(sys.argv[1])
    resolution = int(sys.argv[2]) if len(sys.argv) > 2 else 64
    sys.path.insert(0, str(build / "python"))
    import _swept

    if not FOLDER.exists():
        print("shared test data not found: {}".format(FOLDER))
        return 0
    failed = 0
    for mesh in sorted((FOLDER / "meshes").glob("*.ply")):
        if len(sys.argv) > 3 and not any(word in mesh.name for word in sys.argv[3:]):
            continue
        body = _swept.read_mesh(str(mesh))
        size = np.ptp(np.asarray(body.vertices), axis=0).max()
        for motion in MOTIONS:
            quaternions, translations = scaled_motion(_swept, motion, size)
            poses = matrices(quaternions, translations)
            name = "{} {}".format(mesh.stem, motion[:12])
            try:
                result = _swept.compute(
                    body.vertices, body.triangles, poses, resolution=resolution, conservative=True
                )
            except _swept.Error as error:
                print("{}: {} {}".format(name, error.code, error), flush=True)
                failed += error.code not in ("OpenMesh", "AmbiguousTurn")
                continue
            random = np.random.default_rng(3)
            points = sweep_points(body, quaternions, translations, random)
            distance = _swept.distance_to_mesh(points, result.vertices, result.triangles)
            outside = int(np.sum(np.asarray(distance) >= 0))
            cells = result.report["conservative_bound"] / result.report["cell"]
            most = farthest_vertex(_swept, body, poses, result, random)
            # The search over the motion may stop 0.01 cell above the smallest distance.
            bad = outside > 0 or not 0 < cells <= 3 or most > cells + 0.01
            failed += bad
            print(
                "{}: {} of {} points outside, bound {:.2f} cells, measured {:.2f}, {:.1f} s{}".format(
                    name,
                    outside,
                    POINTS,
                    cells,
                    most,
                    result.report["seconds"]["total"],
                    "   BAD" if bad else "",
                ),
                flush=True,
            )
    print("conservative: {} bad cases".format(failed))
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
