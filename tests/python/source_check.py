# SPDX-License-Identifier: LGPL-2.1-or-later
"""Checks the sources that an envelope reports against the body and the motion as they were given. Uses no
code of the core: a point that belongs to a triangle is moved back by the pose at the named time, computed
here. Then its distance to the named triangles or edges of the body is measured. Lengths in mm.
"""
import numpy as np

CAP, EDGE, GRAZE = range(3)


def _rotations(vectors):
    """Converts rotation vectors (n, 3), rad, to matrices (n, 3, 3), by Rodrigues' formula."""
    angle = np.linalg.norm(vectors, axis=1)
    axis = vectors / np.where(angle > 0, angle, 1)[:, None]
    zero = np.zeros(len(axis))
    x, y, z = axis.T
    cross = np.array([[zero, -z, y], [z, zero, -x], [-y, x, zero]]).transpose(2, 0, 1)
    sine, cosine = np.sin(angle)[:, None, None], np.cos(angle)[:, None, None]
    return np.eye(3) + sine * cross + (1 - cosine) * cross @ cross


def matrices_of(quaternions):
    """Converts quaternions x, y, z, w (n, 4) to matrices (n, 3, 3)."""
    x, y, z, w = (quaternions / np.linalg.norm(quaternions, axis=1)[:, None]).T
    return np.array(
        [
            [1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
            [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
            [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)],
        ]
    ).transpose(2, 0, 1)


def _turns(first, second):
    """Returns rotation vectors (n, 3): the shorter rotations from first to second, relative to first."""
    turn = np.einsum("nji,njk->nik", first, second)
    cosine = np.clip((np.trace(turn, axis1=1, axis2=2) - 1) / 2, -1, 1)
    off = np.stack(
        [
            turn[:, 2, 1] - turn[:, 1, 2],
            turn[:, 0, 2] - turn[:, 2, 0],
            turn[:, 1, 0] - turn[:, 0, 1],
        ],
        axis=1,
    )
    sine = np.linalg.norm(off, axis=1) / 2
    angle = np.arctan2(sine, cosine)
    return off / 2 * np.where(sine > 1e-12, angle / np.maximum(sine, 1e-12), 1)[:, None]


def moved_back(points, sources, motion, steps_are_poses=False):
    """Returns points (n, 3) of the envelope in the coordinates of the body at the times of their
    sources. motion: times, quaternions, translations, pivot, interpolated linearly. Points whose time
    is outside their step become nan."""
    times, quaternions, translations, pivot = motion
    rotations = matrices_of(np.asarray(quaternions, float))
    centres = translations + rotations @ pivot
    first = sources.step
    second = np.where(sources.kind == CAP, first, np.minimum(first + 1, len(times) - 1))
    length = times[second] - times[first]
    part = np.where(length > 0, (sources.time - times[first]) / np.where(length > 0, length, 1), 0)
    turn = _turns(rotations[first], rotations[second])
    rotation = rotations[first] @ _rotations(turn * part[:, None])
    centre = centres[first] + part[:, None] * (centres[second] - centres[first])
    back = np.einsum("nji,nj->ni", rotation, points - centre) + pivot
    beside = (part < -1e-9) | (part > 1 + 1e-9)
    beside |= (sources.kind == CAP) & (sources.time != times[first])
    back[beside] = np.nan
    return back


def _to_segments(points, a, b):
    """Returns the distances (n, m) of points (n, 3) from the segments from a to b, (m, 3) each."""
    d = b - a
    along = np.einsum("nmk,mk->nm", points[:, None] - a, d) / np.maximum((d * d).sum(1), 1e-300)
    nearest = a + np.clip(along, 0, 1)[:, :, None] * d
    return np.linalg.norm(points[:, None] - nearest, axis=2)


def to_triangles(points, corners):
    """Returns the distances (n,) of points (n, 3) from the nearest of triangles (m, 3, 3)."""
    a, b, c = corners.transpose(1, 0, 2)
    normal = np.cross(b - a, c - a)
    normal /= np.maximum(np.linalg.norm(normal, axis=1), 1e-300)[:, None]
    off = np.einsum("nmk,mk->nm", points[:, None] - a, normal)
    foot = points[:, None] - off[:, :, None] * normal
    inside = np.ones(off.shape, bool)
    for p, q in ((a, b), (b, c), (c, a)):
        inside &= np.einsum("nmk,mk->nm", foot - p, np.cross(normal, q - p)) >= 0
    to_border = np.min([_to_segments(points, p, q) for p, q in ((a, b), (b, c), (c, a))], axis=0)
    return np.where(inside, np.abs(off), to_border).min(axis=1)


class BodyFaces:
    """The triangles and edges of a body, by face. faces: (M,) numbers, or None: each triangle is a face."""

    def __init__(self, vertices, triangles, faces=None):
        points, place = np.unique(vertices, axis=0, return_inverse=True)
        self.corners = vertices[triangles]
        self.faces = np.arange(len(triangles)) if faces is None else np.asarray(faces)
        self.triangles_of = {}
        for n, face in enumerate(self.faces):
            self.triangles_of.setdefault(int(face), []).append(n)
        beside = {}
        for n, t in enumerate(place.reshape(-1)[triangles]):
            for k in range(3):
                ends = tuple(sorted((int(t[k]), int(t[(k + 1) % 3]))))
                beside.setdefault(ends, []).append(int(self.faces[n]))
        self.edges_of = {}
        for ends, of in beside.items():
            pair = (min(of), max(of)) if len(of) == 2 else (min(of), -1)
            self.edges_of.setdefault(pair, []).append(points[list(ends)])

    def distance(self, points, kind, faces):
        """Returns the distances of points (n, 3), in the coordinates of the body, from the named faces
        or edges; inf where the body has none."""
        if kind == EDGE or faces[1] >= 0:
            edges = np.array(self.edges_of.get(tuple(faces), []))
            if not len(edges):
                return np.full(len(points), np.inf)
            return _to_segments(points, edges[:, 0], edges[:, 1]).min(axis=1)
        own = self.triangles_of.get(faces[0], [])
        return to_triangles(points, self.corners[own]) if own else np.full(len(points), np.inf)


def residuals(points, sources, body, motion):
    """Returns (n,): the distance (mm) of the point of each row of sources from the face or edge
    that the row names. inf if the body has no such face or edge, or if the time is not in the step;
    nan if the row names none."""
    found = np.full(len(points), np.nan)
    known = np.nonzero(sources.kind >= 0)[0]
    rows = Rows(sources, known)
    back = moved_back(points[known], rows, motion)
    keys = np.column_stack([rows.kind, rows.faces])
    groups, of = np.unique(keys, axis=0, return_inverse=True)
    order = np.argsort(of.reshape(-1), kind="stable")
    ends = np.cumsum(np.bincount(of.reshape(-1), minlength=len(groups)))
    for key, part in zip(groups, np.split(order, ends[:-1])):
        for some in np.array_split(part, max(1, len(part) // 500)):
            found[known[some]] = body.distance(back[some], key[0], tuple(map(int, key[1:])))
    beside = known[np.isnan(back).any(axis=1)]
    found[beside] = np.inf
    return found


class Rows:
    """The rows of sources that an index or a mask selects."""

    NAMES = ("kind", "faces", "step", "time", "point")

    def __init__(self, sources, which):
        for name in self.NAMES:
            setattr(self, name, np.array(getattr(sources, name)[which]))
