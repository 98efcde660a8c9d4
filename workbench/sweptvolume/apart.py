# SPDX-License-Identifier: LGPL-2.1-or-later
"""One shape or mesh of a document as it is now, known by what it is made of. Units: mm. No GUI.

A shape is read by points of all its edges and faces and by the poles of its free forms, a mesh by all its
points and triangles; another geometry gives another text. What was read is kept for each object: a
shape's as long as the object holds the very same shape (wherever it is placed), a mesh's until FreeCAD says
that it was changed.
Cost: about 0.1 to 0.3 ms a face when a shape is new, 0.3 s for a new mesh of 1M triangles, else some
microseconds. FreeCAD writes the triangles that it draws into the topology of its shapes, so no other thread
may read those. For another thread a shape is therefore written as the bytes of a binary file (0.01 ms a face
in the window's thread; a copy by FreeCAD takes 0.05), and that thread makes its own shape of them (0.01 ms).
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

#: Points nearer than this (mm) are the same: ten times what FreeCAD takes for one point.
SAME = 1e-6
#: Where edges and faces are looked at, as parts of their range: ends, and points that no symmetry of
#: two, three or four joins.
_EDGE = (0.0, 0.27, 0.5, 0.81, 1.0)
_FACE = (0.13, 0.5, 0.92)
#: Triangles of a mesh that are read in the time of a face.
_PER_FACE = 700

_known = {}  # (document, object) -> Apart
_observer = None


class Apart:
    """A shape or a mesh in its own coordinates. Made in the window's thread; what it tells is read by whoever
    asks first, in any thread once detached() was called."""

    def __init__(self, obj):
        self.is_mesh = obj.isDerivedFrom("Mesh::Feature")
        self.shape = None if self.is_mesh else obj.Shape
        self._mesh = obj.Mesh if self.is_mesh else None
        self._taken, self._copy, self._kept, self._broken = None, None, {}, False
        self._locks = collections.defaultdict(threading.Lock)  # one may be needed to read another

    def is_of(self, obj):
        """Whether an object still holds the same; changes of meshes are told by the observer."""
        return self.is_mesh or self.shape.isPartner(obj.Shape)

    def detached(self):
        """Lets any thread call text() and, of a shape, copy(). Called in the window's thread; returns
        itself."""
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
        """The shape without triangles, which FreeCAD does not draw into; callers must not change it. Any
        thread, once detached."""
        with self._locks["copy"]:
            if self._copy is None:
                self._copy, self._taken = _shape_of(self._taken), None
            return self._copy

    def cost(self):
        """What is to be read before text() can tell, in faces of a shape; 0: nothing, or what could not be
        read before."""
        if self.knows("text") or self._broken:
            return 0
        if self.is_mesh:
            return self._mesh.CountFacets // _PER_FACE
        return self.shape.countElement("Face")

    def knows(self, name):
        return name in self._kept

    def once(self, name, read):
        """What read() gives, kept under a name."""
        with self._locks[name]:
            if name not in self._kept:
                self._kept[name] = read()
            return self._kept[name]

    def text(self):
        """Text of the shape or mesh."""
        try:
            return self.once("text", self._read)
        except Exception:
            self._broken = True
            raise

    def _read(self):
        if not self.is_mesh:
            return _read_shape(self.copy() if self.is_detached() else self.shape)
        vertices, triangles = meshes.arrays_from_mesh(self._copy or self._mesh)
        self._copy = None  # may be large
        return digest(vertices) + digest(triangles)

    def corners(self):
        """Corners of the box (8,3), None: it is empty. No meshing."""
        return self.once("corners", self._corners)

    def _corners(self):
        if not self.is_mesh and self.shape.isNull():
            return None
        if self.is_mesh:
            box = self._local_mesh().BoundBox
        else:
            # Not of the shape itself: once it was drawn, its box is that of its triangles.
            box = self.detached().copy().BoundBox
        if not box.isValid():
            return None
        ranges = (box.XMin, box.XMax), (box.YMin, box.YMax), (box.ZMin, box.ZMax)
        return np.array(list(itertools.product(*ranges)))

    def _local_mesh(self):
        """A copy of the mesh without its placement."""
        mesh = self._mesh.copy()
        mesh.Placement = App.Placement()
        return mesh


def _bytes_of(shape):
    """The bytes of FreeCAD's binary file of a shape, without its placement and triangles."""
    local = _local(shape)
    with passing(".bin") as path:
        local.exportBinary(path)
        with open(path, "rb") as file:
            return file.read()


def _shape_of(taken):
    """The shape that _bytes_of() has written."""
    import Part

    shape = Part.Shape()
    with passing(".bin") as path:
        with open(path, "wb") as file:
            file.write(taken)
        try:
            shape.importBinary(path)
        except Exception:  # FreeCAD writes on where a folder is full, and names no reason here
            raise InputProblem(no_room_text()) from None
    return shape


def of(obj):
    """The Apart of a Part::Feature or Mesh::Feature as it is; window's thread."""
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
    """Forgets meshes that were changed, and objects and documents that are gone. A mesh has no identity that
    tells of a change, and to compare one of a million triangles takes 0.3 s; this takes 1 us for a change of
    any property."""

    def slotChangedObject(self, obj, name):  # noqa: N802
        if name == "Mesh":
            self.slotDeletedObject(obj)

    def slotDeletedObject(self, obj):  # noqa: N802
        _known.pop((obj.Document.Name, obj.Name), None)

    def slotDeletedDocument(self, document):  # noqa: N802
        for key in [key for key in _known if key[0] == document.Name]:
            del _known[key]


def digest(numbers):
    """Short text of an array as it is."""
    return hashlib.sha256(np.ascontiguousarray(numbers).tobytes()).hexdigest()[:32]


def rounded(numbers, unit):
    return np.rint(np.asarray(numbers, dtype=float) / unit) + 0.0  # no -0


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


def _local(shape):
    """The same topology without its placement."""
    import Part

    local = Part.Shape(shape)
    if not local.isNull():
        local.Placement = App.Placement()
    return local


def _read_shape(shape):
    local = _local(shape)
    points, counts = [], [len(local.Solids), len(local.Shells), len(local.Faces)]
    for items, look in ((local.Faces, _face_points), (local.Edges, _edge_points)):
        for item in items:
            found = look(item)
            points += found
            counts.append(len(found))
    points += [vertex.Point for vertex in local.Vertexes]
    rows = rounded([tuple(point) for point in points], SAME)
    return digest(rows) + digest(np.array(counts))
