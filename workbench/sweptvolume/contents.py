# SPDX-License-Identifier: LGPL-2.1-or-later
"""What parts are made of, as short texts: another geometry or another place gives another text.

A shape is read by points of all its edges and faces and by the poles of its free forms, a mesh by all its
points and triangles. What was read is kept for each object: a shape's text as long as the object holds
the very same shape (wherever it is placed), a mesh's until FreeCAD tells that it was changed.
Cost: about 0.05 ms a face when a shape is new, 0.3 s for a new mesh of 1M triangles, else some microseconds.
"""
import hashlib

import FreeCAD as App
import numpy as np

from . import convert

#: Points nearer than this (mm) are the same: ten times what FreeCAD takes for one point.
SAME = 1e-6
#: Places of matrices are rounded to so many decimals: documents keep sixteen digits.
DECIMALS = 9
#: Where edges and faces are looked at, as parts of their range: ends, and points that no symmetry of
#: two, three or four joins.
_EDGE = (0.0, 0.27, 0.5, 0.81, 1.0)
_FACE = (0.13, 0.5, 0.92)

_shapes, _meshes = {}, {}
_observer = None


class _Observer:
    """Forgets meshes that were changed, and objects and documents that are gone."""

    def slotChangedObject(self, obj, name):  # noqa: N802
        if name == "Mesh":
            _meshes.pop(_key(obj), None)

    def slotDeletedObject(self, obj):  # noqa: N802
        for known in (_shapes, _meshes):
            known.pop(_key(obj), None)

    def slotDeletedDocument(self, document):  # noqa: N802
        for known in (_shapes, _meshes):
            for key in [key for key in known if key[0] == document.Name]:
                del known[key]


def _watch():
    global _observer
    if _observer is None:
        _observer = _Observer()
        App.addDocumentObserver(_observer)


def _key(obj):
    return obj.Document.Name, obj.Name


def digest(numbers):
    """Short text of an array as it is."""
    return hashlib.sha256(np.ascontiguousarray(numbers).tobytes()).hexdigest()[:32]


def _rounded(numbers, unit):
    return np.rint(np.asarray(numbers, dtype=float) / unit) + 0.0  # no -0


def matrices(found):
    """Text of 4x4 matrices."""
    return digest(_rounded(found, 10.0**-DECIMALS))


def _poles(geometry):
    """Of a curve or surface of free form: it may change between the points that are looked at."""
    if not hasattr(geometry, "getPoles"):
        return []
    poles = geometry.getPoles()
    if poles and isinstance(poles[0], (list, tuple)):
        poles = [pole for row in poles for pole in row]
    return poles


def _edge_points(edge):
    try:
        curve, (low, high) = edge.Curve, edge.ParameterRange
        return [edge.valueAt(low + (high - low) * u) for u in _EDGE] + _poles(curve)
    except (TypeError, RuntimeError, AttributeError):  # the pole of a sphere has no curve
        return [vertex.Point for vertex in edge.Vertexes]


def _face_points(face):
    u0, u1, v0, v1 = face.ParameterRange
    found = [face.valueAt(u0 + (u1 - u0) * u, v0 + (v1 - v0) * v) for u in _FACE for v in _FACE]
    return found + _poles(face.Surface)


def _read_shape(shape):
    import Part

    local = Part.Shape(shape)
    local.Placement = App.Placement()
    points, counts = [], [len(local.Solids), len(local.Shells), len(local.Faces)]
    for items, look in ((local.Faces, _face_points), (local.Edges, _edge_points)):
        for item in items:
            found = look(item)
            points += found
            counts.append(len(found))
    points += [vertex.Point for vertex in local.Vertexes]
    rows = _rounded([tuple(point) for point in points], SAME)
    return digest(rows) + digest(np.array(counts))


def shape_text(obj):
    """Text of the shape of a Part::Feature, without its placement."""
    _watch()
    shape, key = obj.Shape, _key(obj)
    known = _shapes.get(key)
    if known is None or not known[0].isPartner(shape):
        known = _shapes[key] = shape, _read_shape(shape)
    return known[1]


def mesh_text(obj):
    """Text of the mesh of a Mesh::Feature, without its placement."""
    _watch()
    key = _key(obj)
    if key not in _meshes:
        vertices, triangles = convert.arrays_from_mesh(obj.Mesh)
        _meshes[key] = digest(vertices) + digest(triangles)
    return _meshes[key]


def signature(pairs):
    """Text of parts given as (root, sub): what they are made of and where they stand."""
    words = []
    for root, sub in pairs:
        for linked, path in convert.leaves(root, sub):
            words.append(matrices(convert.global_matrix(root, path)))
            mesh = linked.isDerivedFrom("Mesh::Feature")
            words.append(mesh_text(linked) if mesh else shape_text(linked))
    return "\n".join(words)


# --- documents of before


def signature_of_before(pairs):
    """The same as version 1 had it, to know its results again: sizes only."""
    words = []
    for root, sub in pairs:
        for linked, path in convert.leaves(root, sub):
            words.append(np.array2string(convert.global_matrix(root, path), precision=9))
            if linked.isDerivedFrom("Mesh::Feature"):
                data = linked.Mesh
                size = (
                    data.CountPoints,
                    data.CountFacets,
                    round(data.Area, 6),
                    round(data.Volume, 6),
                )
            else:
                data = linked.Shape
                size = (
                    len(data.Faces),
                    len(data.Vertexes),
                    round(data.Area, 6),
                    round(data.Length, 6),
                )
                if data.Solids:
                    size += tuple(round(s.Volume, 6) for s in data.Solids)
            box = data.BoundBox
            if box.isValid():  # an empty mesh has none
                size += (round(box.DiagonalLength, 7), tuple(box.Center))
            words.append(repr(size))
    return "\n".join(words)
