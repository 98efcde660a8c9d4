# SPDX-License-Identifier: LGPL-2.1-or-later
"""The envelope that follows a panel: coarse during changes, then fine. Computed in the background and
only drawn in the view."""
import numpy as np
from PySide import QtCore

from .. import convert, core, core_previews, runner, settings
from ..convert import InputProblem
from ..features import envelope
from ..trajectory.poses import INTERPOLATIONS, course, shift_to, straightened
from ..views.surface import drawn
from .newest import NewestTask
from .widgets import alive

OPTIONS = {"components": "consistent", "backend": "auto"}
#: Largest number of triangles drawn, because each envelope must be sent to the view and is visible
#: only briefly.
MOST_TRIANGLES = 30000
#: Largest number of cells of the fine envelope. More would occupy the processor without a request
#: by the user.
MOST_CELLS = 192
#: Time (ms) without a change until the fine envelope is computed.
REST = 300
#: Time (ms) after the last request until the panel checks for results by itself. Each request draws
#: the view anyway, and drawing it twice would take time. So this time is longer than the interval
#: between two requests of a dragger (its POLL).
POLL_DELAY = 100
#: Times (s): above SLOW the next coarse run is coarser, below QUICK it is finer, by the factor
#: STEP; smallest number of cells.
SLOW, QUICK, STEP, LEAST_CELLS = 0.12, 0.04, 0.7, 32
#: Largest deviation of the straight segments that approximate a smooth motion, as a fraction of the
#: path's size.
STRAIGHT = 1e-3


def request_for(body, poses, base, interpolation, resolution):
    """Returns a run for a body at its present placement (convert.Body), independent of any
    document. base: as poses.base_of()."""
    base = base.multiply(shift_to(poses.pivot))
    poses = poses.carried()
    vertices = body.seen(convert.matrix_of(base.inverse()))
    if interpolation == "Spline":
        reach = float(np.linalg.norm(vertices, axis=1).max())
        size = float(np.ptp(convert.pose_arrays(poses.placements)[0], axis=0).max()) + reach
        poses = straightened(course(poses, "Spline"), poses.times, reach, STRAIGHT * size)
    translations, rotations = convert.pose_arrays(poses.placements)
    return core.Request(
        core.Triangles(vertices, body.triangles),
        np.array(poses.times, dtype=float),
        translations,
        rotations,
        INTERPOLATIONS[interpolation],
        dict(OPTIONS, resolution=resolution),
    )


class _PreviewTask(NewestTask):
    """Computes envelopes for requests. Each result is (drawn, seconds).

    compute: core.compute(), or core_previews.Sessions.compute(), which keeps data about the body.
    settle(request, control): called after each run, in the same thread."""

    def __init__(self, document, requests, compute, settle=None):
        super().__init__(document, "Preview", requests)
        self.compute, self.settle = compute, settle

    def make(self, requests, control):
        found = envelope.work(requests, requests[0].options, control, self.compute)
        made = drawn(found.vertices, found.triangles, MOST_TRIANGLES)
        return made, found.report["seconds"]["total"]

    def after_request(self, requests, control):
        for request in requests if self.settle is not None else ():
            self.settle(request, control)


class Preview:
    """Keeps at most one run in progress. While requests come, it computes coarse envelopes one
    after the other, each for the newest request, without waiting for the window to draw. After a
    pause it computes a fine envelope, which replaces the coarse one.

    make_requests is a function: number of cells along the longest side -> requests for the core.
    show(drawn) draws (views/surface.py). report(text) shows a failure ("": none). finest() returns
    the number of cells of the fine run.
    """

    def __init__(self, document, show, report, finest):
        self.document, self.show, self.report, self.finest = document, show, report, finest
        self.sessions = core_previews.Sessions()
        self.run, self.make_requests = None, None
        self.waiting, self.fine = False, False
        self.cells, self.adapts = settings.preview_resolution(), True
        self.warm_cells = 0
        self.updates, self.fine_updates = 0, 0
        self.timer = QtCore.QTimer()
        self.timer.setSingleShot(True)
        self.timer.timeout.connect(self._refine)
        self.poll_timer = QtCore.QTimer()
        self.poll_timer.timeout.connect(self.take)

    def want(self, make_requests, take=True):
        """Requests an envelope. take=False: the caller calls take() whenever it draws."""
        self.make_requests = make_requests
        self.timer.stop()
        if self.run is None:
            self._start(fine=False)
        elif self.fine:
            self.waiting = True
            self.run.cancel()
        else:
            if take:
                self.take()
            self.poll_timer.start(
                POLL_DELAY
            )  # the next picture is drawn anyway, so no extra one is needed
            requests = self._requests(min(self.cells, self.finest()))
            self.waiting = requests is not None and not self.run.task.offer(requests)

    def has_result(self):
        """Returns whether take() has something to show."""
        return self.run is not None and self.run.task.has_result()

    def settled(self):
        """Returns whether no run is in progress and none will follow."""
        return self.run is None and not self.timer.isActive()

    def _requests(self, cells):
        """Returns the requests for the core. If they cannot be made, reports the problem and
        returns None."""
        try:
            return self.make_requests(cells)
        except (InputProblem, core.CoreMissing, core.CoreError) as problem:
            self.report(str(problem))
            return None

    def _start(self, fine):
        self.waiting = False
        if not alive(self.document):
            self.stop()
            return
        finest = self.finest()
        requests = self._requests(finest if fine else min(self.cells, finest))
        if requests is None:
            return
        self.fine = fine
        compute = core.compute if fine else self.sessions.compute
        try:
            settle = self.sessions.lighten if fine else None
            self.run = runner.start(_PreviewTask(self.document, requests, compute, settle))
        except core.CoreMissing as problem:
            self.report(str(problem))
            return
        self.run.ended.connect(self._ended)
        self.poll_timer.start(POLL_DELAY)

    def _refine(self):
        if self.run is None and self.make_requests is not None and self.finest() > self.cells:
            self._start(fine=True)

    def take(self):
        """Shows the newest result since the last check."""
        made = self.run.task.take() if self.run is not None else None
        if made is None:
            return
        self.show(made[0])
        if self.fine:
            self.fine_updates += 1
        else:
            self.updates += 1
            self._adapt(made[1])

    def _ended(self, run):
        self.take()
        self.poll_timer.stop()
        self.run = None
        if run.state != "cancelled":
            self.report(run.message)
        if self.waiting:
            self._start(fine=False)
        elif not self.fine:
            self.timer.start(REST)

    def _adapt(self, seconds):
        """Makes the envelopes coarser while runs are slow, and finer again up to the number of
        cells in the preferences."""
        if self.cells != self.warm_cells:
            self.warm_cells = self.cells  # the first run with a new number of cells is slower
        elif self.adapts and seconds > SLOW:
            self.cells = max(LEAST_CELLS, int(self.cells * STEP))
        elif self.adapts and seconds < QUICK:
            self.cells = min(settings.preview_resolution(), int(self.cells / STEP) + 1)

    def stop(self):
        self.make_requests, self.waiting = None, False
        self.timer.stop()
        self.poll_timer.stop()
        if self.run is not None:
            self.run.ended.disconnect(self._ended)
            self.run.cancel()
            self.run = None
