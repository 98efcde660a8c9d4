# SPDX-License-Identifier: LGPL-2.1-or-later
"""Moving parts as triangles, which are created on first use. Units: mm. No GUI."""
import threading

import numpy as np


class InputProblem(ValueError):
    """Input that cannot be used. The text says what is wrong, why, and what to do."""


def transform(matrix, points):
    """Applies a 4x4 matrix to (n,3) points."""
    return points @ matrix[:3, :3].T + matrix[:3, 3]


class Body:
    """Parts as triangles in world coordinates (mm), as placed when they were read, and the
    placement of the first part.

    The triangles are created on first use, in any thread. The first use raises InputProblem if a
    part gives no triangles."""

    def __init__(self, parts, placement, labels):
        # Per part: label, 4x4 matrix to the world, the function that convert.reader() has returned, and
        # the result of convert.owner().
        self._parts = parts
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
        """Returns vertices (n,3) and triangles (m,3)."""
        with self._lock:
            if self._arrays is None:
                self._arrays = self._made()
                self._parts = None
        return self._arrays[:2]

    @property
    def faces(self):
        """Returns, for each triangle, the index of its face (m,)."""
        self.arrays()
        return self._arrays[2]

    @property
    def parts(self):
        """Returns to which parts the faces belong, as a list of dicts (convert.owner())."""
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
            if np.linalg.det(matrix[:3, :3]) < 0:
                facets = facets[:, ::-1]  # the triangles of a mirrored link would face inwards
            triangles.append(facets + count)
            count += len(points)
            single = of is None  # without face numbers, each triangle is its own face
            of = np.arange(len(facets), dtype=np.int32) if single else of
            parts.append(dict(own, facets=single, first=known, count=int(of.max()) + 1))
            faces.append(of + known)
            known += int(of.max()) + 1
        triangles = np.vstack(triangles).astype(np.int32)
        return np.vstack(vertices), triangles, np.concatenate(faces), parts

    def seen(self, matrix):
        """Returns the vertices moved by a 4x4 matrix. Keeps the result of the last call."""
        if self._seen is None or not np.array_equal(self._seen[0], matrix):
            self._seen = matrix, transform(matrix, self.vertices)
        return self._seen[1]
