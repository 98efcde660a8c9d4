# SPDX-License-Identifier: LGPL-2.1-or-later
"""Texts that identify the geometry and the placements of parts. Different geometry or placements
give a different text. apart.py reads single shapes and meshes.
"""
import hashlib

import numpy as np

from . import apart, convert
from .apart import digest, rounded

#: Entries of matrices are rounded to this number of decimals, because documents keep only sixteen
#: digits.
DECIMALS = 9
#: Largest number of faces that are read at once in the window's thread, which takes about a
#: thirtieth of a second.
MOST_AT_ONCE = 150

#: Number of directions in which the outermost points of a part are searched, and deflection of the
#: mesh used, as a fraction of the part's size. The bounding box of a turning ball is then accurate
#: to 0.3 %.
DIRECTIONS, OUTLINE_CHORD = 642, 0.002


def steady(value):
    """Rounds a number, or the numbers in a dict, to twelve digits. A saved document keeps sixteen:
    a hash of later digits would make every result stale after reopening."""
    if isinstance(value, dict):
        return {name: steady(one) for name, one in value.items()}
    return float("{:.12g}".format(value)) if isinstance(value, float) else value


def matrices(found):
    """Returns a text that identifies 4x4 matrices."""
    return digest(rounded(found, 10.0**-DECIMALS))


def words(pairs):
    """Returns what identifies the geometry and placements of parts given as (root, sub): texts, and
    apart.Apart objects whose text may not have been read yet. Raises InputProblem if a path leads
    to no object with geometry."""
    found = []
    for root, sub in pairs:
        leaves = convert.leaves(root, sub)
        if not leaves:
            raise convert.holds_nothing(root, sub)
        for linked, path in leaves:
            found += [matrices(convert.global_matrix(root, path)), apart.of(linked)]
    return found or [""]


def texts(found):
    """Returns the texts for the result of words(). Any thread may call this after prepared()."""
    return [word.text() if isinstance(word, apart.Apart) else word for word in found]


def short(lines):
    """Returns a text of 32 characters that identifies these lines."""
    return hashlib.sha256("\n".join(lines).encode()).hexdigest()[:32]


def unread(found):
    """Returns the apart.Apart objects that must be read before the texts of words() are known."""
    return [word for word in found if isinstance(word, apart.Apart) and word.cost()]


def is_much(found):
    """Returns whether reading these parts (from unread()) would block the window noticeably."""
    return sum(part.cost() for part in found) > MOST_AT_ONCE


def prepared(found):
    """Prepares the result of words() for another thread and returns it."""
    for part in unread(found):
        part.detached()
    return found


def signature(pairs):
    """Returns the text that identifies parts given as (root, sub): their geometry and
    placements."""
    return "\n".join(texts(words(pairs)))


def text_of(obj):
    """Returns the text that identifies a shape or a mesh, without its placement."""
    return apart.of(obj).text()


class KeptBodies:
    """Keeps the triangles of the parts read last, for callers that need the same parts repeatedly."""

    MOST = 4

    def __init__(self):
        self._kept = []

    def read(self, pairs, deflection):
        """Does the same as convert.body_from()."""
        key = words(pairs), deflection
        found = [body for known, body in self._kept if known == key]
        body = found[0] if found else convert.body_from(pairs, deflection)
        others = [kept for kept in self._kept if kept[0] != key]
        self._kept = [(key, body)] + others[: self.MOST - 1]
        return body


def outline(pairs):
    """Returns a function that may be called in any thread. It returns the outermost points of the
    parts in many directions, in world coordinates (k,3), for the bounding box of a sweep. The
    points are kept for later calls, like the texts of words(). outline() and the function raise
    InputProblem."""
    found = []
    for root, sub in pairs:
        label = convert.label_of(root, sub)
        for linked, path in convert.solid_leaves(root, sub):
            found.append((label, convert.global_matrix(root, path), _outline_reader(linked, label)))
    if not found:
        raise convert.InputProblem(convert.no_part_text())
    return lambda: np.vstack(
        [convert.transform(matrix, _named(label, read)) for label, matrix, read in found]
    )


def is_outlined(pairs):
    """Returns whether the points of outline() are already known."""
    parts = [linked for pair in pairs for linked, _ in convert.solid_leaves(*pair)]
    return all(apart.of(linked).knows("outermost") for linked in parts)


def _named(label, read):
    try:
        return read()
    except convert.InputProblem as problem:
        raise convert.InputProblem('"{}": {}'.format(label, problem)) from None


def _outline_reader(obj, label):
    part = apart.of(obj)
    if part.knows("outermost"):
        return lambda: part.once("outermost", None)
    corners = part.corners()
    size = 0.0 if corners is None else float(np.linalg.norm(np.ptp(corners, axis=0)))
    read = _named(label, lambda: convert.reader(obj, max(OUTLINE_CHORD * size, 1e-6)))

    def outermost():
        points = read()[0]
        return points[_outermost(points)]

    return lambda: part.once("outermost", outermost)


def _outermost(points):
    """Returns the indices of the outermost points in evenly distributed directions."""
    count = np.arange(DIRECTIONS) + 0.5
    down, round_ = np.arccos(1 - 2 * count / DIRECTIONS), np.pi * (1 + 5**0.5) * count
    directions = np.stack(
        [np.cos(round_) * np.sin(down), np.sin(round_) * np.sin(down), np.cos(down)]
    )
    found = [(points @ directions[:, k : k + 32]).argmax(axis=0) for k in range(0, DIRECTIONS, 32)]
    return np.unique(np.concatenate(found))


# --- documents of earlier versions


def signature_of_before(pairs):
    """Returns the signature that version 1 of the workbench stored, to recognise its results. This
    signature contains only placements and sizes."""
    words = []
    for root, sub in pairs:
        for linked, path in convert.leaves(root, sub):
            words.append(np.array2string(convert.global_matrix(root, path), precision=9))
            if linked.isDerivedFrom("Mesh::Feature"):
                data = linked.Mesh
                size = (
                    data.CountPoints,
                    data.CountFacets,
                    round(data.Area, 6),
                    round(data.Volume, 6),
                )
            else:
                data = linked.Shape
                size = (
                    len(data.Faces),
                    len(data.Vertexes),
                    round(data.Area, 6),
                    round(data.Length, 6),
                )
                if data.Solids:
                    size += tuple(round(s.Volume, 6) for s in data.Solids)
            box = data.BoundBox
            if box.isValid():  # an empty mesh has no valid box
                size += (round(box.DiagonalLength, 7), tuple(box.Center))
            words.append(repr(size))
    return "\n".join(words)
