# SPDX-License-Identifier: LGPL-2.1-or-later
"""Joins several envelopes to one, with plain arrays, in any thread."""
import collections

import numpy as np

from . import core


#: Fields of an Outcome that are still needed after its envelope was joined to others.
_Joined = collections.namedtuple("_Joined", "report sources parts")


def join(outcomes, options, control):
    """Returns the outer surface of several envelopes. Their meshes are put together into one body,
    which is sampled without a motion.

    The report includes the effort and the warnings of the earlier runs. Raises CoreError.
    """
    counts = np.cumsum([0] + [len(o.vertices) for o in outcomes])
    vertices = np.vstack([o.vertices for o in outcomes])
    triangles = np.vstack([o.triangles + n for o, n in zip(outcomes, counts)]).astype(np.int32)
    still = np.zeros(1), np.zeros((1, 3)), np.array([[0.0, 0.0, 0.0, 1.0]])
    request = core.Request(core.Triangles(vertices, triangles), *still, "none", options)
    joined = core.compute(request, control)
    earlier = [_Joined(o.report, o.sources, o.parts) for o in outcomes]
    if joined.result is not None:
        # core.recut() calls this function, so that its outcome gets the earlier runs, too.
        joined.result = joined.result[:2] + (lambda outcome: _completed(outcome, earlier),)
    return _completed(joined, earlier)


def _completed(joined, earlier):
    """Adds the sources, warnings and effort of the earlier runs to the outcome of the joining
    run."""
    if joined.sources is not None:
        _copy_sources(joined, earlier)
    report = joined.report
    report["joined"] = len(earlier)
    # Where two envelopes barely overlap, a gap may remain between their meshes. So the errors of
    # the runs do not add up to a bound.
    report.pop("accuracy_bound", None)
    for before in earlier:
        report["placements"] += before.report["placements"]
        report["warnings"] = before.report["warnings"] + report["warnings"]
        report["seconds"]["total"] += before.report["seconds"]["total"]
        peak = max(report["peak_memory_bytes"], before.report["peak_memory_bytes"])
        report["peak_memory_bytes"] = peak
    return joined


def _copy_sources(joined, outcomes):
    """Copies the sources: a joined triangle gets the source of the triangle of an envelope on which
    it lies."""
    kinds, faces, times, parts, first = [], [], [], [], 0
    for outcome in outcomes:
        kind, of, time = outcome.sources
        kinds.append(kind)
        faces.append(np.where(of >= 0, of + first, -1))
        times.append(time)
        parts += [dict(part, first=part["first"] + first) for part in outcome.parts]
        first += sum(part["count"] for part in outcome.parts)
    on = joined.sources[1][:, 0]
    known = on >= 0
    kind, of, time = np.concatenate(kinds)[on], np.concatenate(faces)[on], np.concatenate(times)[on]
    kind[~known], of[~known], time[~known] = -1, -1, np.nan
    joined.sources, joined.parts = (kind, of, time), parts
