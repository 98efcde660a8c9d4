# SPDX-License-Identifier: LGPL-2.1-or-later
"""Colours that show what made each triangle of an envelope."""
import colorsys

import numpy as np

from .. import convert, runner
from ..features import made_by
from ..features.made_by import CAP, EDGE, GRAZE
from ..texts import QT_TRANSLATE_NOOP
from . import surface

#: What the colours of an envelope can show; the first entry: its own colour.
CHOICES = [
    QT_TRANSLATE_NOOP("SweptVolume", "Nothing"),
    QT_TRANSLATE_NOOP("SweptVolume", "Part"),
    QT_TRANSLATE_NOOP("SweptVolume", "Face"),
    QT_TRANSLATE_NOOP("SweptVolume", "Kind"),
    QT_TRANSLATE_NOOP("SweptVolume", "Time"),
]
#: Number of hues for faces (faces with adjacent numbers differ clearly), and for times (from blue
#: to red).
FACE_HUES, TIME_HUES = 24, 24
#: Colours by kind: cap, edge, graze; colour of triangles with an unknown source.
OF_KIND = ((0.25, 0.55, 0.95), (0.95, 0.55, 0.15), (0.30, 0.75, 0.40))
UNKNOWN = (0.5, 0.5, 0.5)
#: Brightness of faces, by the kind of source: cap, edge, graze.
VALUE = {CAP: 0.95, EDGE: 0.55, GRAZE: 0.75}
#: Factor on the transparency of the envelope.
CLEARER = 0.25
#: A coloured surface with more triangles than this is simplified for drawing.
MOST_WHOLE = 300000


def _hue(number, count):
    golden = 0.61803398875
    return int((number * golden % 1.0) * count) / count


def _tables(record, by):
    """Returns (index of a colour for each triangle, those colours)."""
    known, face = record.kind >= 0, record.faces[:, 0]
    if by == "Kind":
        return record.kind.astype(int), list(OF_KIND)
    if by == "Part":
        starts = np.array([part["first"] for part in record.parts])
        of = np.searchsorted(starts, face, side="right") - 1
        hues = [_hue(n + 0.6, 360) for n in range(len(record.parts))]
        return np.where(known, of, -1), [colorsys.hsv_to_rgb(h, 0.65, 0.9) for h in hues]
    if by == "Time":
        times = np.where(known, record.time, np.nan)
        low, high = (np.nanmin(times), np.nanmax(times)) if known.any() else (0.0, 0.0)
        part = (times - low) / (high - low) if high > low else np.zeros(len(times))
        of = np.where(known, np.minimum(np.nan_to_num(part) * TIME_HUES, TIME_HUES - 1), -1)
        hues = [0.66 * (1 - n / (TIME_HUES - 1)) for n in range(TIME_HUES)]
        return of.astype(int), [colorsys.hsv_to_rgb(h, 0.85, 0.9) for h in hues]
    numbers = np.arange(FACE_HUES)
    order = np.argsort(np.argsort(numbers * 0.61803398875 % 1.0))
    of = order[np.maximum(face, 0) % FACE_HUES] * 3 + np.maximum(record.kind, 0)
    colours = [
        colorsys.hsv_to_rgb(n / FACE_HUES, 0.65, VALUE[kind])
        for n in range(FACE_HUES)
        for kind in (CAP, EDGE, GRAZE)
    ]
    return np.where(known, of, -1), colours


def pieces(record, by, vertices, triangles, most):
    """Returns the surface in pieces of one colour: [(colour, surface.drawn())]. Any thread. most:
    approximate number of triangles drawn of a large surface; 0: all."""
    of, colours = _tables(record, by)
    found = []
    if len(triangles) <= max(MOST_WHOLE, most) or not most:
        points, normals, indices = surface.drawn(vertices, triangles, len(triangles))
        rows = np.asarray(indices).reshape(-1, 4)
        for number in np.unique(of):
            some = np.ascontiguousarray(rows[of == number].ravel())
            found.append((_colour(number, colours), (points, normals, some)))
        return found
    for number in np.unique(of):
        own = triangles[of == number]
        used, renumbered = np.unique(own, return_inverse=True)
        limit = max(int(MOST_WHOLE * len(own) / len(triangles)), 4)
        small = renumbered.reshape(-1, 3).astype(np.int32)
        found.append((_colour(number, colours), surface.drawn(vertices[used], small, limit)))
    return found


def _colour(number, colours):
    return UNKNOWN if number < 0 else colours[number]


def nodes_of(coloured, transparency):
    """Returns Coin nodes that draw pieces(). Pieces with the same points use the same node."""
    from pivy import coin

    nodes, last = [], None
    for colour, (points, normals, indices) in coloured:
        material = coin.SoMaterial()
        material.diffuseColor = tuple(map(float, colour))
        material.transparency = transparency
        nodes.append(material)
        if points is last:
            faces = coin.SoIndexedFaceSet()
            surface.fill(faces.coordIndex, indices)
            nodes.append(faces)
        else:
            nodes += surface.nodes_of(points, normals, indices)
        last = points
    return nodes


class Colouring(runner.Task):
    """Makes the coloured surface of an envelope in the background, and then calls show(nodes)."""

    writes = False

    def __init__(self, obj, record, by, most, show):
        self.title, self.document, self.watched = "Colours", obj.Document, [obj]
        self.record, self.by, self.most, self.show = record, by, most, show
        self.mesh = obj.Mesh.copy()

    def work(self, control):
        vertices, triangles = convert.arrays_from_mesh(self.mesh)
        return pieces(self.record, self.by, vertices, triangles, self.most)

    def finish(self, coloured):
        self.show(coloured)


def record_to_show(view):
    """Returns (record, choice) for the colours of an envelope, or (None, "") for its own colour."""
    by = getattr(view, "ColourBy", CHOICES[0])
    if by == CHOICES[0]:
        return None, ""
    record = made_by.find(view.Object)
    return (record, by) if record is not None else (None, "")
