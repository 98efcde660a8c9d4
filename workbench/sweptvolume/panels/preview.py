# SPDX-License-Identifier: LGPL-2.1-or-later
"""The envelope that follows a panel: coarse while something changes, then fine; computed beside the GUI
and drawn in the view only."""
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
#: Triangles that are drawn: each new one has to reach the view, and is seen for a moment.
MOST_TRIANGLES = 30000
#: Cells of the fine envelope at most; more would keep the cores busy without being asked.
MOST_CELLS = 192
#: ms without a change before the fine envelope is computed.
REST = 300
#: ms between two looks for what a run has made, if no wish comes meanwhile: with a wish the view is
#: drawn anyway, and each picture takes time. Longer than between two wishes of a dragger (its POLL).
LOOK = 100
#: s that a coarse run may take, and below which the next one may be finer by the factor STEP.
SLOW, QUICK, STEP, LEAST_CELLS = 0.12, 0.04, 0.7, 32
#: Straight pieces of a smooth motion leave it by at most this part of the path's size.
STRAIGHT = 1e-3


def request_for(body, poses, base, interpolation, resolution):
    """Run for a body as it stands now (convert.Body), no document behind it. base: as poses.base_of()."""
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
    """Envelopes of wishes (requests for the core): (drawn, seconds) each.

    compute: core.compute, or that of sessions which know the body already. settle(request, control): what
    is done after each, in the same thread."""

    def __init__(self, document, requests, compute, settle=None):
        super().__init__(document, "Preview", requests)
        self.compute, self.settle = compute, settle

    def make(self, requests, control):
        found = envelope.work(requests, requests[0].options, control, self.compute)
        made = drawn(found.vertices, found.triangles, MOST_TRIANGLES)
        return made, found.report["seconds"]["total"]

    def rest(self, requests, control):
        for request in requests if self.settle is not None else ():
            self.settle(request, control)


class Preview:
    """Keeps at most one run under way. While wishes come, it makes coarse envelopes one after the other,
    each of the newest wish, and does not wait for the window to show them; when no wish came for a
    moment, a fine one follows and replaces what is shown.

    A wish is a function: cells along the longest side -> requests for the core. show(drawn) draws
    (views/surface.py), report(text) tells of a failure ("": none), finest() gives the cells of the
    fine run.
    """

    def __init__(self, document, show, report, finest):
        self.document, self.show, self.report, self.finest = document, show, report, finest
        self.sessions = core_previews.Sessions()
        self.run, self.wish = None, None
        self.waiting, self.fine = False, False
        self.cells, self.adapts = settings.preview_resolution(), True
        self.warm_cells = 0
        self.updates, self.fine_updates = 0, 0
        self.timer = QtCore.QTimer()
        self.timer.setSingleShot(True)
        self.timer.timeout.connect(self._refine)
        self.looks = QtCore.QTimer()
        self.looks.timeout.connect(self.take)

    def want(self, wish, take=True):
        """take False: whoever wishes calls take() as often as it draws."""
        self.wish = wish
        self.timer.stop()
        if self.run is None:
            self._start(fine=False)
        elif self.fine:
            self.waiting = True
            self.run.cancel()
        else:
            if take:
                self.take()
            self.looks.start(LOOK)  # a picture is drawn anyway: not one more in between
            requests = self._requests(min(self.cells, self.finest()))
            self.waiting = requests is not None and not self.run.task.offer(requests)

    def has_made(self):
        """Whether take() has something to show."""
        return self.run is not None and self.run.task.has_made()

    def settled(self):
        """Whether nothing is under way and nothing is to follow."""
        return self.run is None and not self.timer.isActive()

    def _requests(self, cells):
        """The wish for the core; None, and a report, if it cannot be had."""
        try:
            return self.wish(cells)
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
        self.looks.start(LOOK)

    def _refine(self):
        if self.run is None and self.wish is not None and self.finest() > self.cells:
            self._start(fine=True)

    def take(self):
        """Shows what was made since the last look."""
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
        self.looks.stop()
        self.run = None
        if run.state != "cancelled":
            self.report(run.message)
        if self.waiting:
            self._start(fine=False)
        elif not self.fine:
            self.timer.start(REST)

    def _adapt(self, seconds):
        """Coarser while runs take too long, finer again up to what the preferences want."""
        if self.cells != self.warm_cells:
            self.warm_cells = self.cells  # the first run with a number of cells is a slow one
        elif self.adapts and seconds > SLOW:
            self.cells = max(LEAST_CELLS, int(self.cells * STEP))
        elif self.adapts and seconds < QUICK:
            self.cells = min(settings.preview_resolution(), int(self.cells / STEP) + 1)

    def stop(self):
        self.wish, self.waiting = None, False
        self.timer.stop()
        self.looks.stop()
        if self.run is not None:
            self.run.ended.disconnect(self._ended)
            self.run.cancel()
            self.run = None
