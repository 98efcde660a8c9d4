# SPDX-License-Identifier: LGPL-2.1-or-later
"""Surfaces for the 3D view, simplified so that the window never freezes.

drawn() may run in any thread; group_of() and changes of FreeCAD's own display must run in the
window's thread. Without a graphics card, a picture of a million triangles takes the window 0.2 s of
CPU. A picture of a simplified copy that looks the same takes 0.03 s. While the view rotates, each
picture takes this time.
"""
import ctypes

import FreeCAD as App
import numpy as np
from PySide import QtCore

from .. import convert, core, runner
from ..features import envelope
from ..features.base import kind_of, objects_of_kind

#: Approximate number of triangles drawn of one surface; edges where the surface turns by more than
#: CREASE (rad) are drawn sharp.
MOST, CREASE = 40000, 0.6


def drawn(vertices, triangles, most=MOST):
    """Returns a mesh for group_of(): points, normals (may be empty) and indices."""
    try:
        return core.drawable(vertices, triangles, most, CREASE)
    except core.CoreMissing:
        indices = np.full((len(triangles), 4), -1, dtype=np.int32)
        indices[:, :3] = triangles
        return np.array(vertices, np.float32), np.zeros((0, 3), np.float32), indices.ravel()


#: Field of Coin -> type and shape of one of its values in an array.
_VALUES = {
    "MFVec3f": (np.float32, (3,)),
    "MFMatrix": (np.float32, (16,)),
    "MFInt32": (np.int32, ()),
}


def fill(field, values):
    """Copies an array into a field of Coin.

    Coin's own function makes a Python object of each number. For 40,000 triangles this takes 8 ms
    of CPU, blocks all other threads, and happens at each step of a drag with a preview. This
    function takes 0.1 ms."""
    values = np.ascontiguousarray(values)
    kind = field.getTypeId().getName().getString()
    if (values.dtype, values.shape[1:]) != _VALUES[kind]:
        raise TypeError("{} {} for a field {}".format(values.dtype, values.shape, kind))
    field.setNum(len(values))
    if not len(values):
        return
    start = field.startEditing()
    # Coin returns a pointer: for numbers directly, for vectors and matrices inside the wrapper of
    # the first one.
    ctypes.memmove(int(getattr(start, "this", start)), values.ctypes.data, values.nbytes)
    field.finishEditing()


def is_solid(vertices, triangles):
    """Returns whether only the outside of a mesh is visible: its area and volume suggest that it is
    closed and oriented outwards."""
    corners = vertices[triangles] - vertices[:1]
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    open_area = np.linalg.norm(normals.sum(axis=0))
    return bool(
        open_area < 1e-6 * np.linalg.norm(normals, axis=1).sum()
        and np.einsum("ij,ij->", corners[:, 0], normals) > 0
    )


def nodes_of(points, normals, indices, solid=False):
    """Returns Coin nodes that draw a result of drawn(). solid: leaves out the insides, which halves
    the time."""
    from pivy import coin

    where, faces, hints = coin.SoCoordinate3(), coin.SoIndexedFaceSet(), coin.SoShapeHints()
    hints.vertexOrdering = coin.SoShapeHints.COUNTERCLOCKWISE
    hints.creaseAngle = CREASE
    if solid:
        hints.shapeType = coin.SoShapeHints.SOLID
    fill(where.point, points)
    fill(faces.coordIndex, indices)
    nodes = [hints, where, faces]
    if len(normals):
        across, binding = coin.SoNormal(), coin.SoNormalBinding()
        fill(across.vector, normals)
        binding.value = coin.SoNormalBinding.PER_VERTEX_INDEXED
        nodes[2:2] = [across, binding]
    return nodes


def group_of(surface, solid=False):
    """Returns the nodes of nodes_of() as one group."""
    from pivy import coin

    group = coin.SoGroup()
    for node in nodes_of(*surface, solid):
        group.addChild(node)
    return group


def unsorted_blending():
    """Returns a Coin node that draws transparent triangles in any order. Sorting them would take
    12 ms of CPU for each picture of a simplified copy, and 0.4 s for a million triangles."""
    from pivy import coin

    blend = coin.SoTransparencyType()
    blend.value = coin.SoGLRenderAction.DELAYED_BLEND
    return blend


def most_of(obj):
    """Returns the largest number of triangles drawn of an envelope (None: of a new one); 0: all."""
    import Mesh  # noqa: F401 (a module of FreeCAD is loaded in the window's thread, ready() needs it)

    if not App.GuiUp:
        return 0
    return getattr(obj.ViewObject, "DrawnTriangles", MOST) if obj is not None else MOST


def ready(outcome, most):
    """Prepares the slow steps of storing an envelope (core.Outcome) in its object. Any thread."""
    outcome.mesh = convert.mesh_from_arrays(outcome.vertices, outcome.triangles, beside=True)
    if 0 < most < len(outcome.triangles):
        local = outcome.vertices - np.array(tuple(outcome.mesh.Placement.Base))
        outcome.drawn = drawn(local, outcome.triangles, most)
    return outcome


#: Bytes that FreeCAD needs for a facet and for a point of a mesh, in the document and in the view.
_FACET, _POINT = 64 + 16, 24 + 12


#: Largest number of triangles of an envelope that Undo keeps. FreeCAD copies a mesh several times
#: for each Undo: with 23 million triangles the window froze for 10 to 20 s, with this number for
#: about one second.
MOST_UNDONE = 2000000


def undoable(outcome):
    """Returns whether a result is small enough to be kept for Undo."""
    return len(outcome.triangles) <= MOST_UNDONE


def room(obj, outcome):
    """Returns the bytes needed to write an envelope to its object (None: a new one)."""
    meshes = [outcome.mesh]
    if obj is not None and obj.Document.UndoMode and undoable(outcome):
        meshes.append(obj.Mesh)  # kept for Undo
    return sum(_FACET * m.CountFacets + _POINT * m.CountPoints for m in meshes)


def show(obj, outcome):
    """Draws the simplified copy of an envelope that was just written to its object."""
    if outcome.drawn is not None:
        obj.ViewObject.Proxy.display.show(outcome.drawn)


class _Undone:
    """Updates the states of results that Undo does not keep, after Undo has restored their
    inputs."""

    def slotUndoDocument(self, document):  # noqa: N802
        for obj in objects_of_kind(document, envelope.Envelope.KIND):
            envelope.update_status(obj)

    slotRedoDocument = slotUndoDocument


_undone = []


def watch_undo():
    """From now on, updates states after each Undo."""
    if not _undone:
        _undone.append(_Undone())
        App.addDocumentObserver(_undone[0])


class LightDisplay:
    """Replaces FreeCAD's drawing of a large mesh by a simplified copy. The mesh itself, its colour
    and its display modes do not change. most(): largest number of triangles drawn; 0: all.
    """

    def __init__(self, obj, most):
        self.obj, self.most = obj, most
        self._parent, self._own, self._round = None, [], 0

    def full(self):
        """Restores FreeCAD's own display."""
        self._round += 1
        if self._parent is not None:
            self._fill(self._own)
            self._parent = None

    def show(self, surface):
        """Draws a result of drawn()."""
        self.show_nodes(nodes_of(*surface))

    def show_nodes(self, nodes):
        """Draws these nodes instead of FreeCAD's own."""
        self.full()
        self._parent = _parent_of_faces(self.obj.ViewObject)
        if self._parent is not None:
            self._own = [self._parent.getChild(i) for i in range(self._parent.getNumChildren())]
            self._fill(nodes)

    def _fill(self, nodes):
        self._parent.removeAllChildren()
        for node in nodes:
            self._parent.addChild(node)

    def heavy(self):
        return 0 < self.most() < self.obj.Mesh.CountFacets

    def later(self):
        """Draws the present mesh. If it is large, the simplified copy follows as soon as it is
        ready."""
        self.full()
        if self.heavy():
            # Called later from the event loop, not while the document is opened or Undo runs.
            QtCore.QTimer.singleShot(0, lambda now=self._round: self._start(now))

    def _start(self, now):
        try:
            if now == self._round and self.heavy():
                runner.start(_Thinning(self, now))
        except (ReferenceError, RuntimeError):
            pass  # the object was deleted meanwhile, or there is no core to simplify it

    def take(self, surface, now):
        if now == self._round:
            self.show(surface)


class LightParts:
    """Meshes of a part that are drawn simplified until remove(), if they are large and have one
    colour."""

    def __init__(self, pair, most):
        parts = [linked for linked, _ in convert.leaves(*pair)]
        parts = [o for o in parts if o.isDerivedFrom("Mesh::Feature") and not kind_of(o)]
        parts = [o for o in parts if not getattr(o.ViewObject, "Coloring", False)]
        self.displays = [LightDisplay(o, lambda: most) for o in parts]
        for display in self.displays:
            display.later()

    def remove(self):
        for display in self.displays:
            try:
                display.full()
            except ReferenceError:
                pass  # the object was deleted meanwhile


class _Thinning(runner.Task):
    """Makes the simplified copy of a mesh in the background."""

    writes = False

    def __init__(self, display, now):
        self.title, self.document = "Display", display.obj.Document
        self.display, self.now, self.most = display, now, display.most()
        self.mesh = display.obj.Mesh.copy()

    def work(self, control):
        return drawn(*convert.arrays_from_mesh(self.mesh), self.most)

    def finish(self, surface):
        self.display.take(surface, self.now)


def _parent_of_faces(view):
    """Returns the node with the points and faces that FreeCAD draws of a mesh, or None."""
    from pivy import coin

    kind = coin.SoType.fromName("SoFCIndexedFaceSet")
    if kind.isBad():
        return None
    search = coin.SoSearchAction()
    search.setType(kind)
    search.setSearchingAll(True)
    search.apply(view.RootNode)
    path = search.getPath()
    return path.getNodeFromTail(1) if path is not None and path.getLength() > 1 else None
