# SPDX-License-Identifier: LGPL-2.1-or-later
"""Coarse runs of the core, for a picture that follows the user's movements."""
import threading

import numpy as np

from .core import arguments, errors, module, outcome_of

#: HEAVY: a body with more triangles is simplified for previews. LIGHT_CELLS: number of cells along
#: its longest side when it is simplified.
HEAVY, LIGHT_CELLS = 20000, 64


def _lightened(vertices, triangles, control):
    """Simplifies a large body for previews: returns the envelope of the body at rest, with far
    fewer triangles. May take seconds."""
    still = np.zeros(1), np.array([[0.0, 0.0, 0.0, 1.0]]), np.zeros((1, 3))
    tolerance = 0.5 * float(np.ptp(vertices, axis=0).max()) / LIGHT_CELLS
    options = {"resolution": LIGHT_CELLS, "tolerance": tolerance}
    try:
        found = module().compute(vertices, triangles, still, "none", run=control.context, **options)
    except module().InvalidInput:  # an open body has no envelope at rest
        return vertices, triangles
    lighter = len(found.triangles) < len(triangles) / 2
    return (found.vertices, found.triangles) if lighter else (vertices, triangles)


def _same_body(one, other):
    pairs = (one.vertices, other.vertices), (one.triangles, other.triangles)
    return all(a is b or np.array_equal(a, b) for a, b in pairs)


class Sessions:
    """Computes coarse envelopes of bodies whose motion is edited. Keeps the core's data about a
    body from run to run, for the last few bodies and settings. Any thread may call it, one run at a
    time.
    """

    MOST = 4

    def __init__(self):
        self._kept, self._light, self._lock = [], [], threading.Lock()

    def compute(self, request, control):
        """Returns an Outcome like core.compute(), but its surface is only accurate enough for
        display."""
        with self._lock, errors():
            session = self._session(request)
            _, _, motion, interpolation = arguments(request)
            sketch = not request.options.get("conservative")
            found = session.compute(motion, interpolation, run=control.context, sketch=sketch)
        return outcome_of(found)

    def lighten(self, request, control):
        """Simplifies a large body while the program is idle; later runs use the simplified body."""
        with self._lock, errors():
            if len(request.body.triangles) <= HEAVY or self._light_of(request):
                return
            body = _lightened(request.body.vertices, request.body.triangles, control)
            self._light = [(request, body)] + self._light[: self.MOST - 1]
            self._kept = [kept for kept in self._kept if not _same_body(kept[0].body, request.body)]

    def _light_of(self, request):
        for known, body in self._light:
            if _same_body(known.body, request.body):
                return body
        return None

    def _session(self, request):
        for kept in self._kept:
            known, session = kept
            if known.options == request.options and _same_body(known.body, request.body):
                self._kept.remove(kept)
                break
        else:
            body = self._light_of(request) or (request.body.vertices, request.body.triangles)
            session = module().PreviewSession(*body, **request.options)
        self._kept = [(request, session)] + self._kept[: self.MOST - 1]
        return session
