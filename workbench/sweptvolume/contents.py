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

#: Directions in which the outermost points of a part are looked for, and the chords of the mesh that is
#: looked at, of its size: the box of a turning ball is then right to 0.3 %.
DIRECTIONS, OUTLINE_CHORD = 642, 0.002

_shapes, _meshes, _outlines = {}, {}, {}
_observer = None


class _Observer:
    """Forgets meshes that were changed, and objects and documents that are gone."""

    def slotChangedObject(self, obj, name):  # noqa: N802
        if name == "Mesh":
            _meshes.pop(_key(obj), None)

    def slotDeletedObject(self, obj):  # noqa: N802
        for known in (_shapes, _meshes, _outlines):
            known.pop(_key(obj), None)

    def slotDeletedDocument(self, document):  # noqa: N802
        for known in (_shapes, _meshes, _outlines):
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
            words.append(text_of(linked))
    return "\n".join(words)


def text_of(obj):
    """Text of a shape or a mesh, without its placement."""
    return mesh_text(obj) if obj.isDerivedFrom("Mesh::Feature") else shape_text(obj)


class KeptBodies:
    """Triangles of parts as they were read last, for whoever asks for the same ones again and again."""

    MOST = 4

    def __init__(self):
        self._kept = []

    def read(self, pairs, deflection):
        """As convert.body_from."""
        key = signature(pairs), deflection
        found = [body for known, body in self._kept if known == key]
        body = found[0] if found else convert.body_from(pairs, deflection)
        others = [kept for kept in self._kept if kept[0] != key]
        self._kept = [(key, body)] + others[: self.MOST - 1]
        return body


def outline(pairs):
    """World points (k,3) of parts that lie outermost in many directions, for the box of a sweep. Kept as the
    texts are. Raises InputProblem."""
    found = []
    for root, sub in pairs:
        parts = convert.leaves(root, sub)
        for linked, path in parts:
            if len(parts) == 1 or convert.solid_like(linked):
                try:
                    points = _outline_of(linked)
                except convert.InputProblem as problem:
                    label = convert.label_of(root, sub)
                    raise convert.InputProblem('"{}": {}'.format(label, problem)) from None
                found.append(convert.transform(convert.global_matrix(root, path), points))
    if not found:
        raise convert.InputProblem(convert.no_part_text())
    return np.vstack(found)


def _outline_of(obj):
    text, key = text_of(obj), _key(obj)
    known = _outlines.get(key)
    if known is None or known[0] != text:
        mesh = obj.isDerivedFrom("Mesh::Feature")
        size = 0.0 if mesh else obj.Shape.BoundBox.DiagonalLength
        points = convert.reader(obj, max(OUTLINE_CHORD * size, 1e-6))()[0]
        known = _outlines[key] = text, points[_outermost(points)]
    return known[1]


def _outermost(points):
    """Indices of the points that lie outermost in evenly spread directions."""
    count = np.arange(DIRECTIONS) + 0.5
    down, round_ = np.arccos(1 - 2 * count / DIRECTIONS), np.pi * (1 + 5**0.5) * count
    ways = np.stack([np.cos(round_) * np.sin(down), np.sin(round_) * np.sin(down), np.cos(down)])
    found = [(points @ ways[:, k : k + 32]).argmax(axis=0) for k in range(0, DIRECTIONS, 32)]
    return np.unique(np.concatenate(found))


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
