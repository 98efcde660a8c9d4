# SPDX-License-Identifier: LGPL-2.1-or-later
"""Measures the distance from the nearest neighbour while a part is dragged, in a background
thread."""
import threading

from PySide import QtCore

from .. import convert, core_paths, runner
from ..features import clearance_plan, path_plan, still_parts
from ..features.moving import BodyInFrame
from .newest import NewestTask

#: Deflection (mm) of solids for this measurement.
DEFLECTION = 0.05
#: Interval (ms) between two checks for an answer, if no request comes meanwhile.
POLL = 20


class Answer:
    """The answer to a request. number: number of the request; matrix: placement of the part (4x4);
    distance: to the nearest neighbour (mm; 0: clash); name: of this neighbour; points: the two
    nearest points (mm, world), both None if one part lies inside the other."""

    def __init__(self, number, matrix, distance, name, points):
        self.number = number
        self.matrix = matrix
        self.distance = distance
        self.name = name
        self.points = points


class Scene:
    """The parts to measure, read in the window's thread and prepared at the first request. chord:
    mm; a distance below it counts as contact. Subclasses define make()."""

    def __init__(self, chord):
        self.chord = chord
        self.live, self.names, self._lock = None, [], threading.Lock()

    def make(self, control):
        """Returns (result of core_paths.live_clearance(), names of the neighbours). Any thread.
        Raises CoreError, InputProblem."""
        raise NotImplementedError

    def ready(self, control):
        """Returns the result of make(), which is called only once. Any thread. Raises CoreError,
        InputProblem."""
        with self._lock:
            if self.live is None:
                self.live, self.names = self.make(control)
        return self.live


class VisibleScene(Scene):
    """A part and all visible parts around it. matrix: 4x4 from the world to the coordinates of the
    requests."""

    def __init__(self, document, pair, matrix):
        body = convert.body_from([pair], DEFLECTION)
        self.body = BodyInFrame(body, matrix)
        still, notes, _ = path_plan.beside(document, [pair]).still_parts(DEFLECTION)
        self.beside = clearance_plan.Request(None, still, True, {}, None, notes)
        super().__init__(still_parts.chord_of([pair], DEFLECTION) + max(n.chord for n in still))

    def make(self, control):
        rows = self.beside.rows()
        body = self.body.vertices, self.body.triangles
        made = core_paths.live_clearance(*body, [row[:3] for row in rows], control)
        return made, [row[0] for row in rows]


class _LiveTask(NewestTask):
    """Requests are (number, from, to, apart): from and to 4x4; apart: None if the part need not
    stop."""

    def __init__(self, document, scene, request):
        super().__init__(document, "Clearance", request)
        self.scene = scene

    def make(self, request, control):
        number, before, to, apart = request
        live = self.scene.ready(control)
        if apart is not None:
            to = live.reached(before, to, apart)
        index, distance, inside, a, b = live.at(to)
        points = (None, None) if inside else (a, b)
        return Answer(number, to, distance, self.scene.names[index], points)


class LiveClearance:
    """Answers requests for distances in the background, with at most one run in progress. Calls
    show(answer) and report(text) in the window's thread."""

    def __init__(self, document, scene, show, report):
        self.document, self.show, self.report = document, show, report
        self.scene = scene
        self.run, self.again, self.number, self.answers = None, None, 0, 0
        self.poll_timer = QtCore.QTimer()
        self.poll_timer.timeout.connect(self.take)

    def apart(self):
        """Returns the distance (mm) between the triangles at which a part stops: the largest one
        that still counts as contact."""
        return self.scene.chord + 0.01

    def want(self, before, to, stop=False):
        """Sends a request and returns its number. stop: also asks how far the part can move in a
        straight line from `before`."""
        self.number += 1
        request = (self.number, before, to, self.apart() if stop else None)
        self.take()
        if self.run is None:
            self._start(request)
        elif not self.run.task.offer(request):
            self.again = request
        return self.number

    def _start(self, request):
        self.again = None
        self.run = runner.start(_LiveTask(self.document, self.scene, request))
        self.run.ended.connect(self._ended)
        self.poll_timer.start(POLL)

    def take(self):
        """Shows the newest answer since the last check."""
        made = self.run.task.take() if self.run is not None else None
        if made is not None:
            self.answers += 1
            self.show(made)

    def _ended(self, run):
        self.take()
        self.poll_timer.stop()
        self.run = None
        if run.state == "failed":
            self.report(run.message)
        elif self.again is not None:
            self._start(self.again)

    def stop(self):
        self.poll_timer.stop()
        self.again = None
        if self.run is not None:
            self.run.ended.disconnect(self._ended)
            self.run.cancel()
            self.run = None
