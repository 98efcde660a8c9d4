# SPDX-License-Identifier: LGPL-2.1-or-later
"""A section through a place of the 3D view, for as long as a panel wants it: what lies between the eye and a
plane is not drawn. It belongs to no document."""
import numpy as np

from .ghost import view_of

#: How far before the line the plane lies, of its length: the line itself is seen.
BEFORE = 0.01


class SectionPlane:
    """Not there before the first show()."""

    def __init__(self, document):
        self.view = view_of(document)
        self.graph, self.plane = self.view.getSceneGraph(), None

    def show(self, ends):
        """Cuts through two points (mm, world) along the line between them, as flat to the screen as that
        allows: the line is seen in its full length."""
        from pivy import coin

        a, b = (np.asarray(end, dtype=float) for end in ends)
        away = np.array(tuple(self.view.getViewDirection()))  # from the eye
        along = b - a
        length = float(np.linalg.norm(along))
        if length > 1e-9:
            flat = away - along * (away @ along) / length**2
            if np.linalg.norm(flat) > 0.2:  # else the line points at the eye
                away = flat / np.linalg.norm(flat)
        if self.plane is None:
            self.plane = coin.SoClipPlane()
            self.graph.insertChild(self.plane, 0)
        middle = 0.5 * (a + b) - max(BEFORE * length, 1e-3) * away
        normal = coin.SbVec3f(*map(float, away))
        self.plane.plane = coin.SbPlane(normal, coin.SbVec3f(*map(float, middle)))

    def remove(self):
        if self.plane is not None:
            number = self.graph.findChild(self.plane)
            if number >= 0:
                self.graph.removeChild(number)
            self.plane = None
