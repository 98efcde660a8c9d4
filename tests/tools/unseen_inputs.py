# SPDX-License-Identifier: LGPL-2.1-or-later
"""Random inputs of very different sizes: a part and a motion for each seed.

    for case in cases(seed=1, count=40): run(case.mesh, case.motion, **case.options)

The same seed gives the same arrays on every machine with the same numpy. Lengths in mm, times in s.
    parts       100 to 300,000 triangles; 1 mm to 1 m; boxes, prisms, tori, balls with relief, rims of
                perforated plates, combs of thin walls
    motions     1 to 200,000 poses; 0.01 to 100 part sizes of travel; along lines, arcs, helices and random
                smooth curves, some to and fro; with and without turns; with and without the noise of a
                recording
    options     24 to 160 cells along the longest side; all three interpolations
"""
import dataclasses
import math
import pathlib
import sys

import numpy as np

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "python"))

import bodies  # noqa: E402

LARGEST_TURN = 0.9 * math.pi  # between two poses; at half a turn the direction would be ambiguous


@dataclasses.dataclass(frozen=True)
class Case:
    """Keyword arguments of a run: mesh (vertices, triangles), motion (times, quaternions x y z w,
    translations), options (resolution, interpolation)."""

    name: str
    mesh: tuple
    motion: tuple
    options: dict

    @property
    def copies(self):
        """Returns triangles times poses: the number of triangles in a union of whole copies."""
        return len(self.mesh[1]) * len(self.motion[0])


def _logarithmic(rng, low, high):
    return math.exp(rng.uniform(math.log(low), math.log(high)))


def _ball(rng, triangles):
    """Returns a ball with a wavy surface."""
    across = max(4, round(math.sqrt(triangles / 4)))
    vertices, faces = bodies.ball(1.0, 2 * across, across)
    waves, depth = rng.integers(2, 9, 3), rng.uniform(0, 0.2)
    relief = np.prod(np.cos(vertices * waves), axis=1, keepdims=True)
    return vertices * (1 + depth * relief), faces


def _torus(rng, triangles):
    across = max(3, round(math.sqrt(triangles / 8)))
    return bodies.torus(1.0, rng.uniform(0.1, 0.6), 4 * across, across)


def _prism(rng, triangles):
    """Returns a prism with long triangles, as CAD programs make them."""
    return bodies.prism(max(3, triangles // 4), rng.uniform(0.05, 1), 2.0, rng.uniform(0.3, 1))


def _comb(rng, triangles):
    """Returns thin walls beside each other."""
    count = max(2, min(40, triangles // 12))
    side = max(1, round(math.sqrt(triangles / (12 * count))))
    wall = rng.uniform(0.1, 0.9) * 2 / count
    return bodies.joined(*(_grid_box((2 * i / count, 0, 0), (wall, 1, 1), side)
                           for i in range(count)))  # fmt: skip


def _grid_box(corner, size, side):
    """Returns a box; each of its faces has side x side squares."""
    step = np.linspace(0, 1, side + 1)
    u, v = (a.ravel() for a in np.meshgrid(step, step, indexing="ij"))
    i, j = (a.ravel() for a in np.meshgrid(np.arange(side), np.arange(side), indexing="ij"))
    a = i * (side + 1) + j
    square = np.stack([a, a + side + 1, a + side + 2, a + 1], axis=1)
    points, faces = [], []
    for axis in range(3):
        for end in (0, 1):
            places = np.empty((len(u), 3))
            places[:, axis], places[:, axis - 2], places[:, axis - 1] = end, u, v
            corners = square if end else square[:, ::-1]
            corners = corners + sum(map(len, points))
            faces += [corners[:, [0, 1, 2]], corners[:, [0, 2, 3]]]
            points.append(places)
    vertices, where = np.unique(np.vstack(points).round(12), axis=0, return_inverse=True)
    return vertices * size + corner, where.reshape(-1)[np.vstack(faces)]


PARTS = (_ball, _torus, _prism, _comb)


def draw_part(rng, triangles):
    """Returns vertices (N, 3) in mm and about `triangles` triangles (M, 3), closed and facing outwards."""
    vertices, faces = PARTS[rng.integers(len(PARTS))](rng, triangles)
    stretch = rng.uniform(0.3, 1, 3)
    vertices = vertices * stretch * _logarithmic(rng, 1, 1000) / 2
    return vertices @ bodies.rotation(rng.normal(size=3), rng.uniform(0, 180)).T, faces


def _curve(rng, s):
    """Returns the points (K, 3) at the fractions s of a random curve of length about 1."""
    kind = rng.integers(4)
    if kind == 0:
        curve = s[:, None] * [1.0, 0, 0]
    elif kind == 1:
        whole = rng.uniform(0.3, 2 * math.pi)
        curve = np.stack([np.cos(whole * s), np.sin(whole * s), 0 * s], axis=1) / whole
    elif kind == 2:
        whole = 2 * math.pi * rng.integers(2, 12)
        angle = whole * s
        curve = np.stack([np.cos(angle), np.sin(angle), angle / 6], axis=1) / whole
    else:
        waves = rng.normal(size=(6, 3)) / np.arange(1, 7)[:, None]
        phases = rng.uniform(0, 2 * math.pi, (6, 3))
        curve = sum(w * np.sin((k + 1) * math.pi * s[:, None] + p)
                    for k, (w, p) in enumerate(zip(waves, phases))) / 6  # fmt: skip
    return curve @ bodies.rotation(rng.normal(size=3), rng.uniform(0, 180)).T


def draw_motion(rng, poses, size):
    """Returns times (K,), quaternions (K, 4) and translations (K, 3) of a part of `size` mm."""
    s = np.linspace(0, 1, poses) if poses > 1 else np.ones(1)
    if rng.random() < 0.2:  # to and fro
        s = 0.5 - 0.5 * np.cos(2 * math.pi * rng.integers(1, 6) * s)
    travel = _logarithmic(rng, 0.01, 100) * size
    places = travel * _curve(rng, s)
    turn = rng.uniform(0, 4 * math.pi) if rng.random() < 0.5 else 0.0
    turn = min(turn, LARGEST_TURN * max(1, poses - 1))
    axis = rng.normal(size=3)
    axis /= np.linalg.norm(axis)
    vectors = turn * s[:, None] * axis
    if rng.random() < 0.4:  # with the noise of a recorder
        noise = _logarithmic(rng, 1e-5, 1e-2)
        places = places + rng.normal(size=places.shape) * noise * size
        vectors = vectors + rng.normal(size=vectors.shape) * noise / 4
    angles = np.linalg.norm(vectors, axis=1, keepdims=True)
    axes = np.divide(vectors, angles, out=np.zeros_like(vectors), where=angles > 0)
    quaternions = np.hstack([axes * np.sin(angles / 2), np.cos(angles / 2)])
    return np.arange(poses) * 0.01, quaternions, places


def draw_case(seed, most_triangles=300_000, most_poses=200_000):
    """Returns the case of one seed."""
    rng = np.random.default_rng(seed)
    mesh = draw_part(rng, int(_logarithmic(rng, 100, most_triangles)))
    poses = int(_logarithmic(rng, 1, most_poses))
    size = float(np.linalg.norm(np.ptp(mesh[0], axis=0)))
    motion = draw_motion(rng, poses, size)
    # Cells larger than the whole part are refused.
    fewest = 1.25 * (np.ptp(motion[2], axis=0).max() + size) / np.ptp(mesh[0], axis=0).max()
    options = {
        "resolution": max(int(_logarithmic(rng, 24, 160)), math.ceil(fewest)),
        "interpolation": str(rng.choice(["linear", "linear", "none", "screw"])),
    }
    name = f"{seed}: {len(mesh[1])} triangles, {poses} poses, {options}"
    return Case(name, mesh, motion, options)


def cases(seed, count, **limits):
    """Yields `count` cases, with the limits of draw_case()."""
    for number in range(count):
        yield draw_case(1_000_003 * seed + number, **limits)
