# SPDX-License-Identifier: LGPL-2.1-or-later
"""Small bodies and motions, computed from formulas, for property tests and the corpus."""
import numpy as np


def box(low, high):
    """Returns a box: vertices (8, 3), triangles (12, 3), facing outward."""
    axes = [(low[i], high[i]) for i in range(3)]
    vertices = np.array([[x, y, z] for x in axes[0] for y in axes[1] for z in axes[2]], float)
    quads = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]
    return vertices, np.array([t for a, b, c, d in quads for t in ((a, b, c), (a, c, d))])


def prism(sides, radius, height, taper=1.0):
    """Returns a prism round the z axis, or a frustum if taper is not 1."""
    angle = 2 * np.pi * np.arange(sides) / sides
    ring = np.stack([np.cos(angle), np.sin(angle)], axis=1) * radius
    low = np.column_stack([ring, np.zeros(sides)])
    high = np.column_stack([ring * taper, np.full(sides, height)])
    vertices = np.vstack([low, high, [[0, 0, 0], [0, 0, height]]])
    triangles = []
    for i in range(sides):
        j = (i + 1) % sides
        triangles += [(i, j, sides + j), (i, sides + j, sides + i)]
        triangles += [(2 * sides, j, i), (2 * sides + 1, sides + i, sides + j)]
    return vertices, np.array(triangles)


def torus(ring, tube, around, across):
    """Returns a torus round the z axis."""
    u, v = np.meshgrid(
        2 * np.pi * np.arange(around) / around, 2 * np.pi * np.arange(across) / across,
        indexing="ij",
    )  # fmt: skip
    wide = ring + tube * np.cos(v)
    vertices = np.stack([wide * np.cos(u), wide * np.sin(u), tube * np.sin(v)], axis=-1)
    triangles = []
    for i in range(around):
        for j in range(across):
            a, b = i * across + j, (i + 1) % around * across + j
            c = (i + 1) % around * across + (j + 1) % across
            d = i * across + (j + 1) % across
            triangles += [(a, b, c), (a, c, d)]
    return vertices.reshape(-1, 3), np.array(triangles)


def ball(radius, around=16, across=8):
    """Returns a ball with vertices on parallels and meridians."""
    rows = [[(0.0, 0.0, -radius)]]
    for k in range(1, across):
        polar = -np.pi / 2 + np.pi * k / across
        rows.append(
            [
                (
                    radius * np.cos(polar) * np.cos(2 * np.pi * i / around),
                    radius * np.cos(polar) * np.sin(2 * np.pi * i / around),
                    radius * np.sin(polar),
                )
                for i in range(around)
            ]
        )
    rows.append([(0.0, 0.0, radius)])
    vertices = np.array([p for row in rows for p in row])
    triangles = []
    last = len(vertices) - 1
    for i in range(around):
        j = (i + 1) % around
        triangles.append((0, 1 + j, 1 + i))
        triangles.append((last, last - around + i, last - around + j))
        for k in range(across - 2):
            a, b = 1 + k * around + i, 1 + k * around + j
            triangles += [(a, b, b + around), (a, b + around, a + around)]
    return vertices, np.array(triangles)


def joined(*parts):
    """Returns several bodies as one mesh."""
    vertices = np.vstack([v for v, _ in parts])
    starts = np.cumsum([0] + [len(v) for v, _ in parts[:-1]])
    return vertices, np.vstack([t + start for start, (_, t) in zip(starts, parts)])


def rotation(axis, degrees):
    """Returns the 3 x 3 matrix of a turn about an axis."""
    x, y, z = np.asarray(axis, float) / np.linalg.norm(axis)
    c, s = np.cos(np.radians(degrees)), np.sin(np.radians(degrees))
    cross = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    return np.eye(3) + s * cross + (1 - c) * cross @ cross


def frame(axis, degrees, shift):
    """Returns the 4 x 4 matrix of a turn about an axis through the origin, followed by a shift."""
    matrix = np.eye(4)
    matrix[:3, :3], matrix[:3, 3] = rotation(axis, degrees), shift
    return matrix


def moved(body, matrix):
    return body[0] @ matrix[:3, :3].T + matrix[:3, 3], body[1]
