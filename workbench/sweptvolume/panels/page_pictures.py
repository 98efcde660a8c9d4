# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pictures of the worst rows of a check, taken in the document's 3D view, for pages without their
own 3D view.

The view belongs to the window's thread. Work in this thread is divided into steps, between which
the window handles events. Other threads read the parts of a mechanism and compress the pictures.
"""
import os
import shutil
import tempfile
import threading

import FreeCADGui as Gui
import numpy as np
from PySide import QtCore, QtGui

from ..features import clearance_table, mechanism, mechanism_table
from ..views.clearance_view import zoom_to
from ..views.ghost import MOVING_TRIANGLES, MovingParts
from ..views.live_distance import LiveDistance
from . import widgets
from .tasks import ShapesTask

MOST = 3
SIZE = (1200, 750)
#: Interval (ms) between two checks whether the parts have been read.
_POLL = 20


class _RowDrawing:
    """Shows the rows of a check one after the other."""

    def __init__(self, obj, report):
        self.obj, self.report = obj, report

    def prepare(self, control):
        """A generator, as Task.steps()."""
        return iter(())

    def rows(self):
        """Returns the rows of the report, with the keys that clearance_table reads."""
        raise NotImplementedError

    def show(self, index):
        raise NotImplementedError

    def clear(self):
        raise NotImplementedError


class _ClearanceDrawing(_RowDrawing):
    """Shows the moving part at the time of a row, with the line to its neighbour."""

    def prepare(self, control):
        self.shown = self.obj.ViewObject.Visibility
        self.obj.ViewObject.Visibility = True
        return iter(())

    def rows(self):
        return self.report

    def show(self, index):
        self.obj.ViewObject.Proxy.show_row(self.obj, index)

    def clear(self):
        self.obj.ViewObject.Proxy.hide_row()
        self.obj.ViewObject.Visibility = self.shown


class _Reading(threading.Thread):
    """Work of a task in a background thread."""

    def __init__(self, task, control):
        super().__init__(daemon=True)
        self.task, self.control, self.found, self.problem = task, control, None, None

    def run(self):
        try:
            self.found = self.task.work(self.control)
        except Exception as problem:  # raised again in the window's thread
            self.problem = problem


class _MechanismDrawing(_RowDrawing):
    """Shows all moving parts at the time of a row, its two parts in another colour, with the line
    between them."""

    def __init__(self, obj, report):
        super().__init__(obj, report)
        self.drawn = []

    def prepare(self, control):
        plan = mechanism.Plan.of(self.obj)
        names = plan.names()
        self.names = [names[pair] for pair in plan.pairs]
        reading = _Reading(ShapesTask(plan, MOVING_TRIANGLES), control)
        reading.start()
        while reading.is_alive():
            yield _POLL
        if reading.problem is not None:
            raise reading.problem
        found = reading.found
        self.courses = [course for _, _, course in found]
        self.points = [np.asarray(drawn[0], dtype=float) for drawn, _, _ in found]
        self.parts = MovingParts(self.obj.Document, [part[:2] for part in found])
        self.drawn.append(self.parts)
        self.line = LiveDistance(self.obj.Document)
        self.drawn.append(self.line)

    def rows(self):
        return mechanism_table.as_rows(self.report)

    def show(self, index):
        pair = self.report["pairs"][index]
        row = pair["clearance"]
        names = pair["first"], pair["second"]
        marked = [k for k, name in enumerate(self.names) if name in names]
        self.parts.show([course(row["time_seconds"]) for course in self.courses], marked)
        ends, _, clash = clearance_table.line_of(row)
        self.line.show_between(ends, "", clash)
        points = [self.points[k] for k in marked]
        if points:
            zoom_to(np.vstack(points), row)

    def clear(self):
        for drawn in self.drawn:
            drawn.remove()


class Pictures:
    """The pictures of a check. First steps() fills `found`; then any thread may call packed()."""

    def __init__(self, obj, report):
        kind = _MechanismDrawing if mechanism.is_mechanism(obj) else _ClearanceDrawing
        self.document, self.drawing = obj.Document, kind(obj, report)
        self.found = []  # (caption, bytes of a bitmap)

    def steps(self, control):
        """Makes the pictures. A generator, as Task.steps(). Without a 3D view, there are none."""
        gui = Gui.getDocument(self.document.Name)
        view = gui.ActiveView if gui is not None else None
        if view is None or not hasattr(view, "saveImage"):
            return
        rows, camera = self.drawing.rows(), view.getCamera()
        folder = tempfile.mkdtemp()
        path = os.path.join(folder, "view.bmp")  # PNG would block the window three times as long
        try:
            yield from self.drawing.prepare(control)
            for index in clearance_table.worst_rows(rows)[:MOST]:
                self.drawing.show(index)
                yield 0
                view.saveImage(path, *SIZE, "White")
                with open(path, "rb") as file:
                    self.found.append((rows["neighbours"][index]["name"], file.read()))
                yield 0
        finally:
            shutil.rmtree(folder, ignore_errors=True)
            if widgets.alive(self.document):
                self.drawing.clear()
                view.setCamera(camera)

    def packed(self):
        """Returns [(caption, media type, bytes)]."""
        return [(caption, "image/png", _png(data)) for caption, data in self.found]


def _png(data):
    """Compresses a bitmap to PNG, in any thread."""
    image, content = QtGui.QImage.fromData(data), QtCore.QByteArray()
    target = QtCore.QBuffer(content)
    target.open(QtCore.QIODevice.WriteOnly)
    image.save(target, "PNG")
    target.close()
    return bytes(content.data())
