# SPDX-License-Identifier: LGPL-2.1-or-later
"""Converts between FreeCAD meshes and numpy arrays. Units: mm. No GUI.

Meshes are passed as binary PLY, which was measured to be the fastest form.
"""
import io

import FreeCAD as App
import numpy as np

from . import core
from .body import InputProblem
from .safe_file import no_room_text, passing


def _far_middle(vertices):
    """Returns the middle, in whole mm, of a mesh that is farther from the origin than 32 times its
    size; otherwise None."""
    if not len(vertices) or not np.isfinite(vertices).all():
        return None
    low, high = vertices.min(axis=0), vertices.max(axis=0)
    middle = np.round((low + high) / 2)
    return middle if np.abs(middle).max() > 32 * (high - low).max() else None


def _ply(vertices, triangles):
    """Returns the bytes of a binary PLY file for FreeCAD."""
    head = (
        "ply\nformat binary_little_endian 1.0\nelement vertex {}\nproperty float x\n"
        "property float y\nproperty float z\nelement face {}\n"
        "property list uchar int vertex_indices\nend_header\n"
    ).format(len(vertices), len(triangles))
    faces = np.zeros(len(triangles), dtype=[("c", "u1"), ("i", "<i4", 3)])
    faces["c"] = 3
    faces["i"] = triangles
    return head.encode() + np.ascontiguousarray(vertices, "<f4").tobytes() + faces.tobytes()


class _Stream:
    """A stream of bytes in Python. FreeCAD reads a few hundred bytes at a time. Between two reads
    other threads can run, which would not happen with a stream in compiled code."""

    def __init__(self, data):
        self._inner = io.BytesIO(data)

    def read(self, size=-1):
        return self._inner.read(size)

    def seek(self, *where):
        return self._inner.seek(*where)

    def tell(self):
        return self._inner.tell()


def mesh_from_arrays(vertices, triangles, beside=False):
    """Returns a Mesh.Mesh from (n,3) and (m,3) arrays, with the points in the same order. `beside`:
    the call is in another thread than the window's, and must not block the window.

    Far from the origin, single precision would distort the mesh. Such a mesh gets local coordinates
    and a placement.
    """
    import Mesh

    middle = _far_middle(vertices)
    if middle is not None:
        mesh = mesh_from_arrays(vertices - middle, triangles, beside)
        mesh.Placement = App.Placement(App.Vector(*middle), App.Rotation())
        return mesh
    mesh = Mesh.Mesh()
    if beside:
        try:
            mesh.read(_Stream(core.mesh_file(vertices, triangles)), "BMS")
        except Exception as problem:  # this version of FreeCAD does not accept such a stream
            App.Console.PrintLog("Swept Volume: mesh not read as BMS: {}\n".format(problem))
        if (mesh.CountPoints, mesh.CountFacets) == (len(vertices), len(triangles)):
            return mesh
        mesh = Mesh.Mesh()
    mesh.read(io.BytesIO(_ply(vertices, triangles)), "PLY")
    return mesh


def arrays_from_mesh(mesh):
    """Returns the vertices and triangles of a Mesh.Mesh in its own frame, without its Placement."""
    local = mesh
    # Copied only if needed, because the copy blocks all other threads.
    if not mesh.Placement.isIdentity():
        local = mesh.copy()
        local.Placement = App.Placement()
    with passing(".ply") as path:
        local.write(path)
        with open(path, "rb") as file:
            data = file.read()
    if b"end_header\n" not in data:
        raise InputProblem(no_room_text())
    start = data.index(b"end_header\n") + len(b"end_header\n")
    head = data[:start].decode("ascii")
    points = int(head.split("element vertex ")[1].split()[0])
    facets = int(head.split("element face ")[1].split()[0])
    if len(data) < start + 12 * points + 13 * facets:
        raise InputProblem(no_room_text())
    vertices = np.frombuffer(data, "<f4", points * 3, start).reshape(-1, 3).astype(float)
    kind = [("c", "u1"), ("i", "<i4", 3)]
    triangles = np.frombuffer(data, kind, facets, start + 12 * points)["i"].astype(np.int32)
    return vertices, triangles
