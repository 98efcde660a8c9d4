# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the panels draw in the 3D view that belongs to no document: the part at each key and on the way,
the way itself, a coarse envelope."""
import FreeCADGui as Gui
import numpy as np
from PySide import QtCore

from ..convert import matrix_of
from . import path

KEY_COLOUR, MOVING_COLOUR = (0.95, 0.75, 0.20), (0.20, 0.70, 0.30)
ENVELOPE_COLOUR = (0.35, 0.60, 0.90)
#: A ghost is drawn many times, and only to be looked through.
GHOST_TRIANGLES = 3000
#: Triangles that are drawn anew within one turn of the event loop, and ms between two of them.
PIECE, PAUSE = 30000, 20


class Overlay:
    """Nodes in the active view of a document until removed; the mouse does not see them."""

    def __init__(self, document):
        from pivy import coin

        self.graph = Gui.getDocument(document.Name).activeView().getSceneGraph()
        self.root = coin.SoSeparator()
        pick = coin.SoPickStyle()
        pick.style = coin.SoPickStyle.UNPICKABLE
        self.root.addChild(pick)
        # Sorting the triangles by depth would take most of the time of a picture.
        blend = coin.SoTransparencyType()
        blend.value = coin.SoGLRenderAction.DELAYED_BLEND
        self.root.addChild(blend)
        self.graph.addChild(self.root)

    def add(self, colour, transparency, *nodes):
        from pivy import coin

        part, material = coin.SoSeparator(), coin.SoMaterial()
        material.diffuseColor = colour
        material.transparency = transparency
        part.addChild(material)
        for node in nodes:
            part.addChild(node)
        self.root.addChild(part)

    def remove(self):
        if self.root is not None:
            self.graph.removeChild(self.root)
            self.root = None


class CoarseEnvelope(Overlay):
    """One translucent surface."""

    def __init__(self, document):
        from pivy import coin

        super().__init__(document)
        self.surface = coin.SoGroup()
        self.add(ENVELOPE_COLOUR, 0.6, self.surface)
        self.next, self.left, self.group = None, [], None

    def show(self, pieces):
        """Draws pieces_of() a mesh, one a turn of the event loop, so that none stands in the way of
        input for long. What was drawn before stays until the last is there."""
        self.next = pieces
        if self.group is None:
            self._begin()

    def _begin(self):
        from pivy import coin

        if self.next is not None:
            self.left, self.next, self.group = list(self.next), None, coin.SoGroup()
            self.surface.addChild(self.group)
            self._grow()

    def _grow(self):
        if self.group is None or self.root is None:
            return
        if self.left:
            self.group.addChild(shape_of(*self.left.pop(0)))
        if self.left:
            QtCore.QTimer.singleShot(PAUSE, self._grow)
            return
        while self.surface.getNumChildren() > 1:
            self.surface.removeChild(0)
        self.group = None
        self._begin()

    def clear(self):
        """Takes the surface away, and what is still to be drawn."""
        self.next, self.left, self.group = None, [], None
        self.surface.removeAllChildren()


class Ghosts(Overlay):
    """A part (vertices, triangles) at its keys and on the way, and the way with its frames."""

    def __init__(self, document, vertices, triangles):
        from pivy import coin

        super().__init__(document)
        shape = coin.SoGroup()
        for piece in pieces_of(*thinned(vertices, triangles)):
            shape.addChild(shape_of(*piece))
        self.copies, self.moving = coin.SoMultipleCopy(), coin.SoMatrixTransform()
        self.copies.addChild(shape)
        self.path = coin.SoAnnotation()  # seen through the parts
        self.root.addChild(self.path)
        self.add(KEY_COLOUR, 0.75, self.copies)
        self.add(MOVING_COLOUR, 0.35, self.moving, shape)

    def show_keys(self, placements):
        self.copies.matrix.setNum(len(placements))
        for i, placement in enumerate(placements):
            self.copies.matrix.set1Value(i, _matrix(placement))

    def show_path(self, poses, interpolation):
        """The way as a line with frames."""
        self.path.removeAllChildren()
        self.path.addChild(path.drawn(poses, interpolation))

    def show_moving(self, placement):
        self.moving.matrix = _matrix(placement)


def pieces_of(vertices, triangles):
    """A mesh as Coin takes it, cut in pieces of at most PIECE triangles: list of arguments of
    shape_of(). Slow enough to be made in any thread but the window's."""
    found = []
    for start in range(0, len(triangles), PIECE):
        corners = triangles[start : start + PIECE]
        used = np.zeros(len(vertices), dtype=bool)
        used[corners] = True
        indices = np.full((len(corners), 4), -1, dtype=np.int32)
        indices[:, :3] = (np.cumsum(used, dtype=np.int32) - 1)[corners]
        found.append((np.asarray(vertices[used], dtype=np.float32), indices.ravel().tolist()))
    return found


def thinned(vertices, triangles):
    """A mesh of at most about GHOST_TRIANGLES: what lies in one cell of a grid becomes one point."""
    cells, low, size = 128, vertices.min(axis=0), float(np.ptp(vertices, axis=0).max()) or 1.0
    points, faces = vertices, triangles
    while len(faces) > GHOST_TRIANGLES and cells > 8:
        keys = np.floor((vertices - low) * (cells / size)).astype(np.int64)
        keys = keys[:, 0] + (keys[:, 1] << 20) + (keys[:, 2] << 40)
        _, cell_of, counts = np.unique(keys, return_inverse=True, return_counts=True)
        points = np.stack([np.bincount(cell_of, vertices[:, k]) for k in range(3)], axis=1)
        points /= counts[:, None]
        faces = cell_of[triangles]
        a, b, c = faces.T
        faces = faces[(a != b) & (b != c) & (c != a)]
        cells = cells * 3 // 4
    return points, faces


def shape_of(where, indices):
    """Coin node of one of pieces_of()."""
    from pivy import coin

    group = coin.SoGroup()
    points, faces, hints = coin.SoCoordinate3(), coin.SoIndexedFaceSet(), coin.SoShapeHints()
    hints.vertexOrdering = coin.SoShapeHints.COUNTERCLOCKWISE
    hints.creaseAngle = 0.5
    points.point.setValues(0, len(where), where)
    faces.coordIndex.setValues(0, len(indices), indices)
    for node in (hints, points, faces):
        group.addChild(node)
    return group


def _matrix(placement):
    """Coin multiplies rows: the transpose."""
    from pivy import coin

    return coin.SbMatrix(*[float(x) for x in matrix_of(placement).T.ravel()])
