# SPDX-License-Identifier: LGPL-2.1-or-later
"""Meshes for FreeCAD's 3D view and for its mesh files."""
import struct

import numpy as np
import pytest

import _swept


def ball(rings, radius=10.0):
    """Returns a closed sphere of rings x 2 rings quadrilaterals."""
    u = np.linspace(0, np.pi, rings + 1)[1:-1]
    v = np.linspace(0, 2 * np.pi, 2 * rings, endpoint=False)
    u, v = np.meshgrid(u, v, indexing="ij")
    points = np.stack([np.sin(u) * np.cos(v), np.sin(u) * np.sin(v), np.cos(u)], -1)
    points = np.vstack([points.reshape(-1, 3), [[0, 0, 1], [0, 0, -1]]]) * radius
    around, faces = 2 * rings, []
    for i in range(rings - 2):
        for j in range(around):
            a, b = i * around + j, i * around + (j + 1) % around
            faces += [(a, a + around, b), (b, a + around, b + around)]
    top, bottom, last = len(points) - 2, len(points) - 1, (rings - 2) * around
    for j in range(around):
        faces.append((top, j, (j + 1) % around))
        faces.append((bottom, last + (j + 1) % around, last + j))
    return points, np.array(faces, dtype=np.int32)


def test_a_cube_keeps_its_edges(box):
    points, normals, indices = _swept.drawable(*box)
    assert points.dtype == normals.dtype == np.float32 and indices.dtype == np.int32
    assert len(points) == 24, "three normals at each corner"
    corners = indices.reshape(-1, 4)
    assert (corners[:, 3] == -1).all() and len(corners) == len(box[1])
    assert np.array_equal(points[corners[:, :3]], np.float32(box[0])[box[1]])
    assert np.allclose(np.abs(normals).max(axis=1), 1)


def test_a_ball_is_smooth_and_points_outward():
    points, normals, indices = _swept.drawable(*ball(30))
    assert len(points) == len(ball(30)[0]), "no vertex is split"
    assert (np.einsum("ij,ij->i", points / 10, normals) > 0.99).all()


def test_thinning_keeps_to_the_number_and_to_the_surface():
    vertices, triangles = ball(150)
    points, _, indices = _swept.drawable(vertices, triangles, most=5000)
    corners = indices.reshape(-1, 4)[:, :3]
    assert 2000 < len(corners) < 6500 and corners.max() < len(points)
    assert abs(np.linalg.norm(points, axis=1) - 10).max() < 0.1


def test_thinning_keeps_corners():
    n = 60
    step = np.linspace(-1, 1, n + 1)
    a, b = (x.ravel() for x in np.meshgrid(step, step, indexing="ij"))
    i = np.arange(n)[:, None] * (n + 1) + np.arange(n)[None]
    quads = np.stack([i, i + n + 1, i + n + 2, i + 1], -1).reshape(-1, 4)
    faces = np.vstack([quads[:, [0, 1, 2]], quads[:, [0, 2, 3]]])
    vertices, triangles = [], []
    for k, (axis, side) in enumerate((x, s) for x in range(3) for s in (-1, 1)):
        part = np.zeros((len(a), 3))
        part[:, axis], part[:, (axis + 1) % 3], part[:, (axis + 2) % 3] = side, a, b * side
        vertices.append(part)
        triangles.append(faces + k * len(a))
    points, _, indices = _swept.drawable(np.vstack(vertices), np.vstack(triangles), most=4000)
    assert len(indices) // 4 < 5000
    assert np.allclose(np.abs(points).max(axis=1), 1, atol=1e-3), "a point has left the cube"


def test_an_empty_mesh_and_bad_input():
    points, normals, indices = _swept.drawable(np.zeros((0, 3)), np.zeros((0, 3), int), most=1)
    assert len(points) == len(normals) == len(indices) == 0
    with pytest.raises(_swept.InvalidInput):
        _swept.drawable(np.zeros((2, 3)), [[0, 1, 2]])


def test_mesh_file_knows_neighbours(box):
    data = _swept.freecad_mesh(*box)
    points, facets = struct.unpack_from("<II", data, 264)
    assert (points, facets) == (len(box[0]), len(box[1]))
    rows = np.frombuffer(data, "<u4", 6 * facets, 272 + 12 * points).reshape(-1, 6)
    assert np.array_equal(rows[:, :3], box[1])
    for t, row in enumerate(rows):
        for k in range(3):
            edge = {row[k], row[(k + 1) % 3]}
            assert row[3 + k] != t and edge < set(rows[row[3 + k], :3]), "not across that edge"


def test_mesh_file_of_an_open_mesh_has_borders():
    data = _swept.freecad_mesh(np.eye(3), [[0, 1, 2]])
    assert np.frombuffer(data, "<u4", 6, 272 + 36).tolist()[3:] == [0xFFFFFFFF] * 3
