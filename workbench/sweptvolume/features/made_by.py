# SPDX-License-Identifier: LGPL-2.1-or-later
"""Records of what made each triangle of an envelope: which face or edge of which part, and when. No
GUI.

A record belongs to one result, which the hash of its inputs and its number of triangles identify.
So Undo finds the record of the result that it restores. A record is kept until the document is
closed. The document stores it only if the property MadeBy requires this; each triangle then takes
some bytes.
"""
import base64
import bisect
import collections
import contextlib
import io
import json
import zipfile

import FreeCAD as App
import numpy as np

from .. import convert
from ..convert import InputProblem
from ..texts import QT_TRANSLATE_NOOP, translate
from . import row_names
from .base import UP_TO_DATE, fits
from .envelope_plan import Plan

PROPERTY = "MadeByData"
CAP, EDGE, GRAZE = range(3)
#: Number of results of one envelope whose records are kept, for Undo.
MOST_KEPT = 3
KINDS = (
    QT_TRANSLATE_NOOP(
        "SweptVolume",
        "Made by the face itself at one of the poses, not by its motion between the poses",
    ),
    QT_TRANSLATE_NOOP("SweptVolume", "Swept by an edge that passed here"),
    QT_TRANSLATE_NOOP("SweptVolume", "Swept by a face that passed here"),
)
_PART = {
    "first": int,
    "count": int,
    "label": str,
    "root": str,
    "sub": str,
    "facets": bool,
    "motion": str,
}

#: What made one triangle. kind: CAP, EDGE or GRAZE; faces: one or two of (part, face number from
#: 1); time: s; motion: name of the motion object.
Answer = collections.namedtuple("Answer", "kind faces time motion")

_kept = {}  # (document, object) -> records, the newest first
_observer = None


class Record:
    """kind int8 (m,), -1: not known; faces int32 (m,2); time float64 (m,), s. parts: dicts with
    first and count of their faces, label, root and sub, id (convert.object_id(); not in records of
    earlier versions), facets (whether the faces are triangles of a mesh) and motion."""

    def __init__(self, key, kind, faces, time, parts):
        self.key, self.kind, self.faces, self.time = key, kind, faces, time
        self.parts = sorted(parts, key=lambda part: part["first"])
        self._first = [part["first"] for part in self.parts]

    def owner(self, face):
        """Returns (part, number of its face from 1) for a face index."""
        part = self.parts[bisect.bisect_right(self._first, face) - 1]
        return part, int(face) - part["first"] + 1

    def answer(self, triangle):
        """Returns what made a triangle, or None if it is not known."""
        if self.kind[triangle] < 0:
            return None
        faces = [self.owner(face) for face in self.faces[triangle] if face >= 0]
        return Answer(
            int(self.kind[triangle]), faces, float(self.time[triangle]), faces[0][0]["motion"]
        )

    def packed(self):
        """Returns the record as text that can be stored in a document."""
        out = io.BytesIO()
        head = json.dumps({"key": self.key, "parts": self.parts})
        np.savez_compressed(
            out,
            head=np.frombuffer(head.encode(), np.uint8),
            kind=self.kind,
            faces=self.faces,
            time=self.time,
        )
        return base64.b64encode(out.getvalue()).decode()


def unpacked(text):
    """Returns the record stored in a document, or None if there is none or it is damaged."""
    try:
        with np.load(io.BytesIO(base64.b64decode(text))) as data:
            head = json.loads(data["head"].tobytes().decode())
            kind, faces, time = data["kind"], data["faces"], data["time"]
    except (ValueError, KeyError, OSError, EOFError, zipfile.BadZipFile):
        return None
    if not fits(head, {"key": (str, int), "parts": [_PART]}):
        return None
    most = max([part["first"] + part["count"] for part in head["parts"]], default=0)
    shapes = kind.shape == time.shape == (len(kind),) and faces.shape == (len(kind), 2)
    sound = shapes and kind.dtype == np.int8 and faces.dtype == np.int32 and time.dtype == float
    if not sound or len(kind) and (kind.max() > GRAZE or faces.max() >= most):
        return None
    if (faces[kind >= 0, 0] < 0).any():
        return None
    return Record(head["key"], kind, faces, time, head["parts"])


def _key(obj):
    return [obj.InputHash, obj.Mesh.CountFacets]


def keep(obj, outcome):
    """Keeps the record of the result that was just written."""
    if outcome.sources is not None:
        _remember(obj, Record(_key(obj), *outcome.sources, outcome.parts))
    _store(obj)


def _remember(obj, record):
    global _observer
    names = obj.Document.Name, obj.Name
    others = [known for known in _kept.get(names, []) if known.key != record.key]
    _kept[names] = [record] + others[: MOST_KEPT - 1]
    if _observer is None:
        _observer = _Observer()
        App.addDocumentObserver(_observer)


def _store(obj):
    """Stores the record in the document, or removes it, depending on MadeBy."""
    record = find(obj) if obj.MadeBy == "Document" else None
    text = record.packed() if record is not None else ""
    if getattr(obj, PROPERTY) != text:
        setattr(obj, PROPERTY, text)


def find(obj):
    """Returns the record of the stored result of an envelope, or None. Parts and motions have their
    present labels."""
    record = _find(obj)
    if record is not None:
        with contextlib.suppress(InputProblem):
            _rename(obj, record)
    return record


def _rename(obj, record):
    """Updates labels and paths in a record, so that they stay correct after renaming and
    regrouping. If the result is up to date, its parts have the order of the inputs, which
    identifies them."""
    if obj.Status != UP_TO_DATE:
        for part in record.parts:
            pair = row_names.pair_at(obj.Document, [part["root"], part["sub"]])
            # Another object may have got the name of a deleted part.
            if pair and part.get("id") in (None, convert.object_id(*pair)):
                part["label"] = convert.label_of(*pair)
        return
    now = [
        dict(convert.owner(root, path), motion=group.motion.Name)
        for group in Plan.of(obj).groups()
        for root, sub in group.pairs
        for _, path in convert.solid_leaves(root, sub)
    ]
    if len(now) == len(record.parts):
        for part, own in zip(record.parts, now):
            part.update(own)


def _find(obj):
    key = _key(obj)
    for record in _kept.get((obj.Document.Name, obj.Name), []):
        if record.key == key:
            return record
    record = unpacked(getattr(obj, PROPERTY)) if getattr(obj, PROPERTY) else None
    if record is None or record.key != key or len(record.kind) != key[1]:
        return None
    _remember(obj, record)
    return record


def changed(obj, name):
    """Handles a change of MadeBy by the user: stores the record, or removes it from the document."""
    if name != "MadeBy" or PROPERTY not in obj.PropertiesList:
        return
    if not (obj.Document.Restoring or getattr(obj.Document, "Transacting", False)):
        _store(obj)


def name_of(part, number):
    """Returns the text for a face: "Face3 of Bracket"."""
    if part["facets"]:
        return translate("SweptVolume", "triangle {0} of {1}").format(number, part["label"])
    return translate("SweptVolume", "Face{0} of {1}").format(number, part["label"])


def text_of(answer):
    """Returns an answer as text."""
    names = [name_of(*face) for face in answer.faces]
    what = names[0]
    if len(names) == 2:
        what = translate("SweptVolume", "the edge between {0} and {1}").format(*names)
    when = translate("SweptVolume", "{0}, at {1:.3f} s")
    return when.format(what, answer.time) + "\n" + translate("SweptVolume", KINDS[answer.kind])


class _Observer:
    def slotDeletedDocument(self, document):  # noqa: N802
        for names in [names for names in _kept if names[0] == document.Name]:
            del _kept[names]
