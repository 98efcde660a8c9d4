# SPDX-License-Identifier: LGPL-2.1-or-later
"""Solids have the stored bytes, whether the core's OpenCASCADE or FreeCAD's judges them. So a core
from a wheel, which has no OpenCASCADE, can be compared with the others. SWEPT_STORE_HASHES=1 stores
the bytes again."""
import hashlib
import math
import os
import pathlib
import sys

import numpy as np
import pytest

from sweptvolume import core
from sweptvolume.features import step_reader

if not core.available():
    pytest.skip("the compiled core _swept is not built", allow_module_level=True)
sys.path.append(os.path.dirname(core.module().__file__))  # the package lies beside its module
import swept_volume as swept  # noqa: E402

STORED = pathlib.Path(__file__).with_name("solid_hashes.txt")


def grid(around, along, at, closed):
    """Returns the mesh (points, triangles) of a surface of revolution with the points at(angle, j).
    They are rounded, so that the last digit of a sine does not matter. The grid is open in j unless
    closed."""
    points = [
        [round(x, 9) for x in at(2 * math.pi * i / around, j)]
        for i in range(around)
        for j in range(along)
    ]
    triangles = []
    for i in range(around):
        for j in range(along if closed else along - 1):
            a, b = i * along, (i + 1) % around * along
            j, k = j, (j + 1) % along
            triangles += [[a + j, b + j, b + k], [a + j, b + k, a + k]]
    return points, triangles


def capped(around, along, points, triangles, low, high):
    """Closes a grid that is open in j with two points. Returns (points, triangles)."""
    n = len(points)
    for i in range(around):
        a, b = i * along, (i + 1) % around * along
        triangles += [[n, b, a], [n + 1, a + along - 1, b + along - 1]]
    return points + [low, high], triangles


def torus(radius, minor, around, along):
    def at(u, j):
        v = 2 * math.pi * j / along
        reach = radius + minor * math.cos(v)
        return reach * math.cos(u), reach * math.sin(u), minor * math.sin(v)

    return grid(around, along, at, True)


def cone(low, high, height, around):
    """Returns the mesh of a truncated cone; of a cylinder if both radii are equal."""

    def at(u, j):
        return (high if j else low) * math.cos(u), (high if j else low) * math.sin(u), j * height

    return capped(around, 2, *grid(around, 2, at, False), [0, 0, 0], [0, 0, height])


def ball(radius, steps):
    def at(u, j):
        v = math.pi * (j + 1) / steps
        reach = radius * math.sin(v)
        return reach * math.cos(u), reach * math.sin(u), -radius * math.cos(v)

    ends = [0, 0, -radius], [0, 0, radius]
    return capped(2 * steps, steps - 1, *grid(2 * steps, steps - 1, at, False), *ends)


def box(*size):
    corners = [[x, y, z] for z in (0, size[2]) for y in (0, size[1]) for x in (0, size[0])]
    sides = "021 123 456 576 014 154 263 367 042 246 135 375".split()
    return corners, [[int(corner) for corner in side] for side in sides]


def both(one, other, shift):
    """Returns two bodies as one mesh, the other one moved along x."""
    n = len(one[0])
    moved = [[x + shift, y, z] for x, y, z in other[0]]
    return one[0] + moved, one[1] + [[a + n, b + n, c + n] for a, b, c in other[1]]


SLIDE = ([0, 1], [[0, 0, 0, 1]] * 2, [[0, 0, 0], [30, 4, 0]])
TURN = ([0, 1], [[0, 0, 0, 1], [0, 0, 0.28, 0.96]], [[0, 0, 0], [20, 0, 5]])
#: name -> (mesh, tolerance, motion). With a motion, the solid is that of the envelope of the mesh.
#: Of these solids, no edge lies off its faces: the core's kernel would cut it, FreeCAD as a reader
#: does not find it.
CASES = {
    "box": (box(3, 2, 1), 0, None),
    "cylinder": (cone(4, 4, 12, 96), 0.02, None),
    "fine cylinder": (cone(4, 4, 12, 96), 0.005, None),
    "cone": (cone(5, 2, 8, 96), 0.01, None),
    "torus": (torus(20, 6, 96, 48), 0.1, None),
    "torus as it is": (torus(20, 6, 24, 12), 0, None),
    "two bodies": (both(torus(20, 6, 96, 48), box(4, 3, 2), 40), 0.1, None),
    "ball": (ball(7, 24), 0.05, None),
    "box along x": (box(10, 20, 30), 0.1, SLIDE),
    "box that turns": (box(10, 20, 30), 0.15, TURN),
    "cylinder along x": (cone(6, 6, 10, 64), 0.2, SLIDE),
    "ball along x": (ball(6, 24), 0.2, SLIDE),
}


def written(name, path, reader):
    """Returns (hash of the data of the STEP file, report). The hash leaves out the header with its
    time."""
    (vertices, triangles), tolerance, motion = CASES[name]
    body = swept.Mesh(np.array(vertices, float), np.array(triangles, np.int32))
    options = {"tolerance": tolerance, "reader": reader}
    if motion:
        motion = swept.Motion(*motion, interpolation="screw")
        body = swept.compute(body, motion, resolution=48).mesh
    report = swept.write_solid(path, body, **options)
    data = pathlib.Path(path).read_bytes().partition(b"DATA;")[2]
    return hashlib.sha256(data).hexdigest()[:16], report


def stored():
    lines = STORED.read_text().splitlines() if STORED.exists() else []
    return dict(reversed(line.split(" ", 1)) for line in lines)


@pytest.mark.parametrize("name", CASES)
def test_the_solid_has_the_stored_bytes_with_freecads_kernel(name, tmp_path):
    found, report = written(name, tmp_path / "freecads.step", step_reader.read)
    assert report["valid"]
    if os.environ.get("SWEPT_STORE_HASHES"):
        known = dict(stored(), **{name: found})
        STORED.write_text("".join(f"{known[n]} {n}\n" for n in CASES if n in known))
    assert stored()[name] == found


@pytest.mark.skipif(not core.has_solids(), reason="the core was built without OpenCASCADE")
@pytest.mark.parametrize("name", CASES)
def test_the_cores_kernel_gives_the_same_bytes(name, tmp_path):
    found, report = written(name, tmp_path / "ours.step", None)
    assert report["valid"]
    assert found == stored()[name]
