# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the core knows of ways between neighbours: it finds them, and measures one placement after another."""
from . import core


class PathRequest:
    """Input of one search: plain arrays, independent of any document.

    vertices (n,3) mm in the coordinates that the placements place, triangles (m,3); goal, start (4,4);
    extract: mm, or a direction (x, y, z), instead of a start; neighbours in the world: (name, vertices,
    triangles, chord, clearance or None); options: as the module's find_path()."""

    def __init__(self, vertices, triangles, goal, neighbours, start, extract, options):
        self.vertices = vertices
        self.triangles = triangles
        self.goal = goal
        self.neighbours = neighbours
        self.start = start
        self.extract = extract
        self.options = options


def watch():
    """What farthest() tells of a search: the placement (4,4) that came farthest out so far, or None."""
    return core.module().PathWatch()


def find_path(request, control, seen=None):
    """(report, motion): dict, and (times, translations, rotations) or None. seen: a watch(). Raises
    CoreError."""
    with core.errors():
        report, found = core.module().find_path(
            request.vertices,
            request.triangles,
            request.goal,
            request.neighbours,
            start=request.start,
            extract=request.extract,
            run=control.context,
            watch=seen,
            **request.options,
        )
    if found is None:
        return report, None
    times, rotations, translations = found
    return report, (times, translations, rotations)


def live_clearance(vertices, triangles, neighbours, control):
    """Prepared for at(pose) and reached(from, to, apart) of the module's LiveClearance. neighbours: (name,
    vertices, triangles). Raises CoreError."""
    with core.errors():
        return core.module().LiveClearance(vertices, triangles, neighbours, run=control.context)
