# SPDX-License-Identifier: LGPL-2.1-or-later
"""Transparent copies of a part in the 3D view that belong to no document: at each key and on the way."""
import FreeCADGui as Gui
import numpy as np

from ..convert import matrix_of

KEY_COLOUR, MOVING_COLOUR = (0.95, 0.75, 0.20), (0.20, 0.70, 0.30)
ENVELOPE_COLOUR = (0.35, 0.60, 0.90)


class Ghosts:
    """Draws (vertices, triangles) at placements in the active view of a document until removed."""

    def __init__(self, document, vertices, triangles):
        from pivy import coin

        self.graph = Gui.getDocument(document.Name).activeView().getSceneGraph()
        self.root = coin.SoSeparator()
        pick = coin.SoPickStyle()
        pick.style = coin.SoPickStyle.UNPICKABLE
        self.root.addChild(pick)
        shape = self._shape(coin, vertices, triangles)
        self.copies = coin.SoMultipleCopy()
        self.copies.addChild(shape)
        self.moving = coin.SoMatrixTransform()
        self._add(coin, KEY_COLOUR, 0.75, [self.copies])
        self._add(coin, MOVING_COLOUR, 0.35, [self.moving, shape])
        self.envelope = coin.SoGroup()
        self._add(coin, ENVELOPE_COLOUR, 0.6, [self.envelope])
        self.graph.addChild(self.root)

    def show_envelope(self, vertices, triangles):
        """The coarse envelope; empty arrays take it away."""
        from pivy import coin

        self.envelope.removeAllChildren()
        if len(triangles):
            self.envelope.addChild(self._shape(coin, vertices, triangles))

    def _shape(self, coin, vertices, triangles):
        group = coin.SoGroup()
        points, faces, hints = coin.SoCoordinate3(), coin.SoIndexedFaceSet(), coin.SoShapeHints()
        hints.vertexOrdering = coin.SoShapeHints.COUNTERCLOCKWISE
        hints.creaseAngle = 0.5
        points.point.setValues(0, len(vertices), np.asarray(vertices, dtype=float).tolist())
        ends = np.full((len(triangles), 1), -1, dtype=np.int64)
        indices = np.hstack([triangles, ends]).ravel().tolist()
        faces.coordIndex.setValues(0, len(indices), indices)
        for node in (hints, points, faces):
            group.addChild(node)
        return group

    def _add(self, coin, colour, transparency, nodes):
        part, material = coin.SoSeparator(), coin.SoMaterial()
        material.diffuseColor = colour
        material.transparency = transparency
        part.addChild(material)
        for node in nodes:
            part.addChild(node)
        self.root.addChild(part)

    def show_keys(self, placements):
        self.copies.matrix.setNum(len(placements))
        for i, placement in enumerate(placements):
            self.copies.matrix.set1Value(i, _matrix(placement))

    def show_moving(self, placement):
        self.moving.matrix = _matrix(placement)

    def remove(self):
        if self.root is not None:
            self.graph.removeChild(self.root)
            self.root = None


def _matrix(placement):
    """Coin multiplies rows: the transpose."""
    from pivy import coin

    return coin.SbMatrix(*[float(x) for x in matrix_of(placement).T.ravel()])
