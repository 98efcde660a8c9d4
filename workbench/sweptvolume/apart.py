# SPDX-License-Identifier: LGPL-2.1-or-later
"""The geometry of one shape or mesh of a document, as a text that identifies it. Units: mm. No GUI.

The text of a shape comes from points of all its edges and faces and from the poles of its free-form
geometry. The text of a mesh comes from all its points and triangles. Different geometry gives a
different text. The text is kept for each object: for a shape as long as the object holds the same
shape (at any placement), for a mesh until FreeCAD reports a change.

Cost: 0.1 to 0.3 ms for each face of a new shape, 0.3 s for a new mesh of 1M triangles, otherwise
some microseconds.

FreeCAD writes display triangles into the topology of its shapes, so only the window's thread may
read a shape. For other threads, the window's thread writes the shape as the bytes of a binary file
(0.01 ms for each face; a copy by FreeCAD takes 0.05 ms). Another thread creates its own shape from
the bytes (0.01 ms for each face).
"""
import collections
import hashlib
import itertools
import threading

import FreeCAD as App
import numpy as np

from . import meshes
from .body import InputProblem
from .safe_file import no_room_text, passing

#: Points closer than this (mm) count as equal. Ten times the distance at which FreeCAD joins
#: points.
SAME = 1e-6
#: Parameters of edges and faces at which points are read, as fractions of the range: the ends, and
#: values that no two-, three- or fourfold symmetry maps onto each other.
_EDGE = (0.0, 0.27, 0.5, 0.81, 1.0)
_FACE = (0.13, 0.5, 0.92)
#: Number of mesh triangles that take as long to read as one face of a shape.
_PER_FACE = 700

_known = {}  # (document, object) -> Apart
_observer = None


class Apart:
    """A shape or a mesh in its own coordinates. Created in the window's thread. After detached(),
    any thread may read it. The text, the corners and other values are computed on first use and
    kept."""

    def __init__(self, obj):
        self.is_mesh = obj.isDerivedFrom("Mesh::Feature")
        self.shape = None if self.is_mesh else obj.Shape
        self._mesh = obj.Mesh if self.is_mesh else None
        self._taken, self._copy, self._kept, self._broken = None, None, {}, False
        # One lock for each value, because a thread that computes one value may need another.
        self._locks = collections.defaultdict(threading.Lock)

    def is_of(self, obj):
        """Returns whether an object still holds this geometry. For a mesh always true, because
        _Observer removes changed meshes."""
        return self.is_mesh or self.shape.isPartner(obj.Shape)

    def detached(self):
        """Allows any thread to call text() and, for a shape, copy(). Called in the window's thread.
        Returns self."""
        if not self.is_detached():
            if self.is_mesh:
                self._copy = self._local_mesh()
            elif self.shape.isNull():
                self._copy = self.shape
            else:
                self._taken = _bytes_of(self.shape)
        return self

    def is_detached(self):
        return self._taken is not None or self._copy is not None

    def copy(self):
        """Returns the shape without triangles. FreeCAD does not draw this copy; callers must not
        change it. Any thread may call this after detached()."""
        with self._locks["copy"]:
            if self._copy is None:
                self._copy, self._taken = _shape_of(self._taken), None
            return self._copy

    def cost(self):
        """Returns how much must be read before text() is known, as a number of faces. 0 if text()
        is known or the geometry could not be read."""
        if self.knows("text") or self._broken:
            return 0
        if self.is_mesh:
            return self._mesh.CountFacets // _PER_FACE
        return self.shape.countElement("Face")

    def knows(self, name):
        return name in self._kept

    def once(self, name, read):
        """Returns the value of read(), which is called only once for each name."""
        with self._locks[name]:
            if name not in self._kept:
                self._kept[name] = read()
            return self._kept[name]

    def text(self):
        """Returns the text that identifies the shape or mesh."""
        try:
            return self.once("text", self._read)
        except Exception:
            self._broken = True
            raise

    def _read(self):
        if not self.is_mesh:
            return _read_shape(self.copy() if self.is_detached() else self.shape)
        vertices, triangles = meshes.arrays_from_mesh(self._copy or self._mesh)
        self._copy = None  # frees the copy, which may be large
        return digest(vertices) + digest(triangles)

    def corners(self):
        """Returns the corners of the bounding box (8,3), or None for empty geometry. Does not mesh."""
        return self.once("corners", self._corners)

    def _corners(self):
        if not self.is_mesh and self.shape.isNull():
            return None
        if self.is_mesh:
            box = self._local_mesh().BoundBox
        else:
            # After a shape was drawn, its bounding box is that of its display triangles. So a copy
            # without triangles is used.
            box = self.detached().copy().BoundBox
        if not box.isValid():
            return None
        ranges = (box.XMin, box.XMax), (box.YMin, box.YMax), (box.ZMin, box.ZMax)
        return np.array(list(itertools.product(*ranges)))

    def _local_mesh(self):
        """Returns a copy of the mesh without its placement."""
        mesh = self._mesh.copy()
        mesh.Placement = App.Placement()
        return mesh


def _bytes_of(shape):
    """Returns a shape as the bytes of FreeCAD's binary file, without its placement and triangles."""
    local = _local(shape)
    with passing(".bin") as path:
        local.exportBinary(path)
        with open(path, "rb") as file:
            return file.read()


def _shape_of(data):
    """Returns the shape from the bytes of _bytes_of()."""
    import Part

    shape = Part.Shape()
    with passing(".bin") as path:
        with open(path, "wb") as file:
            file.write(data)
        try:
            shape.importBinary(path)
        except Exception:  # if the disk is full, FreeCAD raises an error without a reason
            raise InputProblem(no_room_text()) from None
    return shape


def of(obj):
    """Returns the Apart of the present geometry of a Part::Feature or Mesh::Feature. Call it in the
    window's thread."""
    global _observer
    if _observer is None:
        _observer = _Observer()
        App.addDocumentObserver(_observer)
    key = obj.Document.Name, obj.Name
    known = _known.get(key)
    if known is None or not known.is_of(obj):
        known = _known[key] = Apart(obj)
    return known


class _Observer:
    """Removes changed meshes, and deleted objects and documents, from _known. Without it, a change
    would be found only by comparing the triangles, which takes 0.3 s for a million. The observer
    takes 1 us for each change of any property."""

    def slotChangedObject(self, obj, name):  # noqa: N802
        if name == "Mesh":
            self.slotDeletedObject(obj)

    def slotDeletedObject(self, obj):  # noqa: N802
        _known.pop((obj.Document.Name, obj.Name), None)

    def slotDeletedDocument(self, document):  # noqa: N802
        for key in [key for key in _known if key[0] == document.Name]:
            del _known[key]


def digest(numbers):
    """Returns a short text that identifies the values of an array."""
    return hashlib.sha256(np.ascontiguousarray(numbers).tobytes()).hexdigest()[:32]


def rounded(numbers, unit):
    return np.rint(np.asarray(numbers, dtype=float) / unit) + 0.0  # adding 0.0 turns -0.0 into 0.0


def _poles(geometry):
    """Returns the poles (control points) of a free-form curve or surface. Two such curves may agree
    at all points that are read."""
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
    except (TypeError, RuntimeError, AttributeError):  # the edge at a sphere's pole has no curve
        return [vertex.Point for vertex in edge.Vertexes]


def _face_points(face):
    u0, u1, v0, v1 = face.ParameterRange
    found = [face.valueAt(u0 + (u1 - u0) * u, v0 + (v1 - v0) * v) for u in _FACE for v in _FACE]
    return found + _poles(face.Surface)


def _local(shape):
    """Returns a copy of the shape without its placement. Copy and original share their topology."""
    import Part

    local = Part.Shape(shape)
    if not local.isNull():
        local.Placement = App.Placement()
    return local


def _read_shape(shape):
    local = _local(shape)
    points, counts = [], [len(local.Solids), len(local.Shells), len(local.Faces)]
    for items, points_of in ((local.Faces, _face_points), (local.Edges, _edge_points)):
        for item in items:
            found = points_of(item)
            points += found
            counts.append(len(found))
    points += [vertex.Point for vertex in local.Vertexes]
    rows = rounded([tuple(point) for point in points], SAME)
    return digest(rows) + digest(np.array(counts))
