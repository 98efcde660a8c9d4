# SPDX-License-Identifier: LGPL-2.1-or-later
"""What parts are made of and where they stand, as short texts: another geometry or place gives another
text. What one shape or mesh is made of is read in apart.py.
"""
import hashlib

import numpy as np

from . import apart, convert
from .apart import digest, rounded

#: Places of matrices are rounded to so many decimals: documents keep sixteen digits.
DECIMALS = 9
#: Faces that may be read before a window waits: about a thirtieth of a second.
MOST_AT_ONCE = 150

#: Directions in which the outermost points of a part are looked for, and the chords of the mesh that is
#: looked at, of its size: the box of a turning ball is then right to 0.3 %.
DIRECTIONS, OUTLINE_CHORD = 642, 0.002


def steady(value):
    """A number, or a dict of such, as a document that is saved and opened brings it back: it keeps sixteen
    digits, and a hash that tells the seventeenth would call every result stale then."""
    if isinstance(value, dict):
        return {name: steady(one) for name, one in value.items()}
    return float("{:.12g}".format(value)) if isinstance(value, float) else value


def matrices(found):
    """Text of 4x4 matrices."""
    return digest(rounded(found, 10.0**-DECIMALS))


def words(pairs):
    """What parts given as (root, sub) are made of and where they stand: texts, and apart.Apart where the text
    may have to be read first. Raises InputProblem where a path leads to nothing that has a form."""
    found = []
    for root, sub in pairs:
        leaves = convert.leaves(root, sub)
        if not leaves:
            raise convert.holds_nothing(root, sub)
        for linked, path in leaves:
            found += [matrices(convert.global_matrix(root, path)), apart.of(linked)]
    return found or [""]


def texts(found):
    """The texts of words; any thread, where those were prepared() for that."""
    return [word.text() if isinstance(word, apart.Apart) else word for word in found]


def short(lines):
    """A text of 32 characters that stands for these lines."""
    return hashlib.sha256("\n".join(lines).encode()).hexdigest()[:32]


def unread(found):
    """What is to be read before the texts of words are known."""
    return [word for word in found if isinstance(word, apart.Apart) and word.cost()]


def is_much(found):
    """Whether reading so much (as unread() gives it) would hold up a window."""
    return sum(part.cost() for part in found) > MOST_AT_ONCE


def prepared(found):
    """The words, ready for another thread."""
    for part in unread(found):
        part.detached()
    return found


def signature(pairs):
    """Text of parts given as (root, sub): what they are made of and where they stand."""
    return "\n".join(texts(words(pairs)))


def text_of(obj):
    """Text of a shape or a mesh, without its placement."""
    return apart.of(obj).text()


class KeptBodies:
    """Triangles of parts as they were read last, for whoever asks for the same ones again and again."""

    MOST = 4

    def __init__(self):
        self._kept = []

    def read(self, pairs, deflection):
        """As convert.body_from."""
        key = words(pairs), deflection
        found = [body for known, body in self._kept if known == key]
        body = found[0] if found else convert.body_from(pairs, deflection)
        others = [kept for kept in self._kept if kept[0] != key]
        self._kept = [(key, body)] + others[: self.MOST - 1]
        return body


def outline(pairs):
    """A function for any thread: world points (k,3) of parts that lie outermost in many directions, for the
    box of a sweep. Kept as the texts are. Raises InputProblem, and so does the function."""
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
    """Whether outline() is known and need not be read."""
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
    """Indices of the points that lie outermost in evenly spread directions."""
    count = np.arange(DIRECTIONS) + 0.5
    down, round_ = np.arccos(1 - 2 * count / DIRECTIONS), np.pi * (1 + 5**0.5) * count
    ways = np.stack([np.cos(round_) * np.sin(down), np.sin(round_) * np.sin(down), np.cos(down)])
    found = [(points @ ways[:, k : k + 32]).argmax(axis=0) for k in range(0, DIRECTIONS, 32)]
    return np.unique(np.concatenate(found))


# --- documents of before


def signature_of_before(pairs):
    """The same as version 1 had it, to know its results again: sizes only."""
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
            if box.isValid():  # an empty mesh has none
                size += (round(box.DiagonalLength, 7), tuple(box.Center))
            words.append(repr(size))
    return "\n".join(words)
