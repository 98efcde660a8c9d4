# SPDX-License-Identifier: LGPL-2.1-or-later
"""The coarse envelope that follows a panel: computed beside the GUI, newest wish wins, drawn in the
view only."""
import numpy as np

from .. import convert, core, runner, settings
from ..convert import InputProblem
from ..features import envelope
from ..runner import Task
from ..trajectory.poses import INTERPOLATIONS, base_of, course, straightened

OPTIONS = {"components": "consistent", "backend": "auto"}


#: Straight pieces of a smooth motion leave it by at most this part of the path's size.
STRAIGHT = 1e-3


def request_for(body, poses, frame, interpolation, resolution):
    """Run for a body as it stands now (convert.Body), no document behind it."""
    into_base = convert.matrix_of(base_of(poses, frame, body.placement).inverse())
    vertices = convert.transform(into_base, body.vertices)
    if interpolation == "Spline":
        reach = float(np.linalg.norm(vertices, axis=1).max())
        size = float(np.ptp(convert.pose_arrays(poses.placements)[0], axis=0).max()) + reach
        poses = straightened(course(poses, "Spline"), poses.times, reach, STRAIGHT * size)
    translations, rotations = convert.pose_arrays(poses.placements)
    return core.Request(
        vertices,
        body.triangles,
        np.array(poses.times, dtype=float),
        translations,
        rotations,
        INTERPOLATIONS[interpolation],
        dict(OPTIONS, resolution=resolution),
    )


class _PreviewTask(Task):
    writes = False

    def __init__(self, document, requests, show):
        self.title = "Preview"
        self.document = document
        self.requests = requests
        self.show = show

    def work(self, control):
        return envelope.work(self.requests, self.requests[0].options, control)

    def finish(self, value):
        self.show(value.vertices, value.triangles)


class Preview:
    """Keeps at most one run under way; a new wish takes its place.

    A wish is a function: cells along the longest side -> requests for the core. show(vertices,
    triangles) draws a result, report(text) tells of a failure ("": none).
    """

    def __init__(self, document, show, report):
        self.document, self.show, self.report = document, show, report
        self.run, self.next, self.updates = None, None, 0

    def want(self, wish):
        self.next = wish
        if self.run is None:
            self._start()
        else:
            self.run.cancel()

    def _start(self):
        wish, self.next = self.next, None
        if wish is None:
            return
        try:
            requests = wish(settings.preview_resolution())
            self.run = runner.start(_PreviewTask(self.document, requests, self.show))
        except (InputProblem, core.CoreMissing) as problem:
            self.report(str(problem))
            return
        self.run.ended.connect(self._ended)

    def _ended(self, run):
        self.run = None
        if run.state == "ok":
            self.updates += 1
        if run.state != "cancelled":
            self.report(run.message)
        self._start()

    def stop(self):
        self.next = None
        if self.run is not None:
            self.run.ended.disconnect(self._ended)
            self.run.cancel()
            self.run = None
