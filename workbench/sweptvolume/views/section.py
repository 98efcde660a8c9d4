# SPDX-License-Identifier: LGPL-2.1-or-later
"""A section in the 3D view while a panel needs it: everything between the camera and a plane is
hidden. Not part of any document."""
import numpy as np

from .ghost import view_of

#: Distance from the line to the plane in front of it, as a fraction of the line's length, so that
#: the line is visible.
BEFORE = 0.01


class SectionPlane:
    """Has no effect before the first show()."""

    def __init__(self, document):
        self.view = view_of(document)
        self.graph, self.plane = self.view.getSceneGraph(), None

    def show(self, ends):
        """Cuts along the line between two points (mm, world coordinates). The plane contains the
        direction of the line and is otherwise as parallel to the screen as possible, so that the
        whole line is visible."""
        from pivy import coin

        a, b = (np.asarray(end, dtype=float) for end in ends)
        away = np.array(tuple(self.view.getViewDirection()))  # direction away from the camera
        along = b - a
        length = float(np.linalg.norm(along))
        if length > 1e-9:
            flat = away - along * (away @ along) / length**2
            if np.linalg.norm(flat) > 0.2:  # otherwise the line points at the camera
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
