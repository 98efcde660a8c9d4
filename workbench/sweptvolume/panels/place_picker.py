# SPDX-License-Identifier: LGPL-2.1-or-later
"""Handles clicks on an envelope in the 3D view: finds the triangle, and what made it."""
import FreeCAD as App
import FreeCADGui as Gui
import numpy as np
from PySide import QtCore

from .. import convert
from ..features import made_by
from ..features.envelope import is_envelope


def nearest_triangle(point, vertices, triangles, towards=None):
    """Returns the index of the triangle nearest to a point (3,). towards: direction of view;
    triangles seen from behind are skipped, unless all are."""
    corners = vertices[triangles]
    a, b, c = corners[:, 0], corners[:, 1], corners[:, 2]
    which = np.arange(len(triangles))
    if towards is not None:
        seen = np.einsum("nk,k->n", np.cross(b - a, c - a), towards) < 0
        which = which[seen] if seen.any() else which
    middle = (a + b + c)[which] / 3
    reach = np.linalg.norm(corners[which] - middle[:, None], axis=2).max(axis=1)
    to_middle = np.linalg.norm(middle - point, axis=1)
    which = which[to_middle - reach <= to_middle.min()]
    return int(which[np.argmin(_distances(point, a[which], b[which], c[which]))])


def _distances(p, a, b, c):
    """Returns the distances of a point from triangles with corners a, b, c, (n,3) each."""
    normal = np.cross(b - a, c - a)
    normal /= np.maximum(np.linalg.norm(normal, axis=1), 1e-300)[:, None]
    off = np.einsum("nk,nk->n", p - a, normal)
    foot = p - off[:, None] * normal
    inside, border = np.ones(len(a), bool), np.full(len(a), np.inf)
    for start, end in ((a, b), (b, c), (c, a)):
        edge = end - start
        inside &= np.einsum("nk,nk->n", foot - start, np.cross(normal, edge)) >= 0
        length = np.maximum(np.einsum("nk,nk->n", edge, edge), 1e-300)
        fraction = np.clip(np.einsum("nk,nk->n", p - start, edge) / length, 0, 1)
        to_edge = np.linalg.norm(p - start - fraction[:, None] * edge, axis=1)
        border = np.minimum(border, to_edge)
    return np.where(inside, np.abs(off), border)


class Places:
    """Finds what made points of one envelope in its present state. Reads its mesh at the first
    call."""

    def __init__(self, obj):
        self.obj, self.record = obj, made_by.find(obj)
        self._arrays = None

    def is_current(self):
        return made_by.find(self.obj) is self.record

    def answer(self, point, towards=None):
        """Returns what made the envelope at a point in world coordinates (3,), or None if it is not
        known."""
        if self.record is None:
            return None
        if self._arrays is None:
            self._arrays = convert.arrays_from_mesh(self.obj.Mesh)
        back = np.linalg.inv(convert.global_matrix(*convert.root_path(self.obj)))
        here = convert.transform(back, np.array([point], float))[0]
        if towards is not None:
            towards = back[:3, :3] @ np.array(towards, float)
        return self.record.answer(nearest_triangle(here, *self._arrays, towards))


class PlacePicker:
    """Calls found(envelope, answer) for each click on an envelope of a document in its 3D view,
    until stop(). answer is None if there is no record of what made this point. The envelope is
    deselected, so that FreeCAD reports the next click and its colours are visible."""

    def __init__(self, document, found):
        self.document, self.found, self._places = document.Name, found, {}
        Gui.Selection.addObserver(self)

    def stop(self):
        Gui.Selection.removeObserver(self)

    def addSelection(self, document, name, sub, point):  # noqa: N802
        """Called by FreeCAD with the selected object and the point. Selections in the tree have no
        point."""
        if document != self.document or not any(point):
            return
        obj = App.getDocument(document).getObject(name)
        target = obj.getSubObject(sub, retType=1) if obj is not None and sub else obj
        if target is None or not is_envelope(target):
            return
        # Called later from the event loop, because FreeCAD has not finished the selection yet.
        QtCore.QTimer.singleShot(0, lambda: self._report(target, (document, name, sub), point))

    def _report(self, obj, selected, point):
        try:
            Gui.Selection.removeSelection(*selected)
            view = Gui.getDocument(self.document).activeView()
            towards = view.getViewDirection() if hasattr(view, "getViewDirection") else None
            answer = self.places(obj).answer(point, towards)
        except (ReferenceError, NameError):  # the object or its document was deleted meanwhile
            return
        self.found(obj, answer)

    def places(self, obj):
        known = self._places.get(obj.Name)
        if known is None or not known.is_current():
            known = self._places[obj.Name] = Places(obj)
        return known
