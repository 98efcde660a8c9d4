# SPDX-License-Identifier: LGPL-2.1-or-later
"""Moving parts as triangles that are made when they are first asked for. Units: mm. No GUI."""
import threading

import numpy as np


class InputProblem(ValueError):
    """Something selected cannot be swept; the text says what, why and what to do."""


def transform(matrix, points):
    """Applies a 4x4 matrix to (n,3) points."""
    return points @ matrix[:3, :3].T + matrix[:3, 3]


class Body:
    """Parts as they stood when they were read, as triangles in world coordinates (mm), and the placement
    of the first one.

    The triangles are made when they are first asked for, in any thread: FreeCAD's mesher lets the window
    go on. Raises InputProblem then if a part gives none."""

    def __init__(self, parts, placement, labels):
        self._parts = parts  # (label, 4x4 to the world, what reader() gives, label, root and sub)
        self.placement = placement
        self.labels = labels
        self._arrays, self._seen, self._lock = None, None, threading.Lock()

    @property
    def vertices(self):
        return self.arrays()[0]

    @property
    def triangles(self):
        return self.arrays()[1]

    def arrays(self):
        """Vertices (n,3) and triangles (m,3)."""
        with self._lock:
            if self._arrays is None:
                self._arrays = self._made()
                self._parts = None
        return self._arrays[:2]

    @property
    def faces(self):
        """(m,): number of the face that each triangle is a piece of."""
        self.arrays()
        return self._arrays[2]

    @property
    def parts(self):
        """Whose the faces are: dicts, as features.made_by has them."""
        self.arrays()
        return self._arrays[3]

    def _made(self):
        vertices, triangles, count = [], [], 0
        faces, parts, known = [], [], 0
        for label, matrix, read, own in self._parts:
            try:
                points, facets, of = read()
            except InputProblem as problem:
                raise InputProblem('"{}": {}'.format(label, problem)) from None
            vertices.append(transform(matrix, points))
            triangles.append(facets + count)
            count += len(points)
            single = of is None  # each triangle for itself
            of = np.arange(len(facets), dtype=np.int32) if single else of
            parts.append(dict(own, facets=single, first=known, count=int(of.max()) + 1))
            faces.append(of + known)
            known += int(of.max()) + 1
        triangles = np.vstack(triangles).astype(np.int32)
        return np.vstack(vertices), triangles, np.concatenate(faces), parts

    def seen(self, matrix):
        """The vertices moved by a 4x4 matrix; those of the last call are kept."""
        if self._seen is None or not np.array_equal(self._seen[0], matrix):
            self._seen = matrix, transform(matrix, self.vertices)
        return self._seen[1]
