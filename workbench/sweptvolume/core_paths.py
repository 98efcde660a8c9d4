# SPDX-License-Identifier: LGPL-2.1-or-later
"""Functions of the core for paths between neighbours: searches, and distances at one placement
after another."""
from . import core


class PathRequest:
    """Input of one search, independent of any document.

    body: has vertices (n,3) mm, in the coordinates to which the placements apply, and triangles
    (m,3); any thread may create them. goal, start: (4,4). extract (if start is None): a distance in
    mm, or a direction (x, y, z). neighbours: (name, body in the world, mesh deflection in mm, rule
    as text or None). options: those of the module's find_path()."""

    def __init__(self, body, goal, neighbours, start, extract, options):
        self.body = body
        self.goal = goal
        self.neighbours = neighbours
        self.start = start
        self.extract = extract
        self.options = options

    def rows(self):
        return rows_of(self.neighbours)


def rows_of(neighbours):
    """Returns neighbours as the module takes them. Raises InputProblem if one gives no
    triangles."""
    return [
        (name, body.vertices, body.triangles, chord, own) for name, body, chord, own in neighbours
    ]


def watch():
    """Returns an observer of find_path(). Its farthest() returns the placement (4,4), among those
    found so far, that is farthest from the goal, or None."""
    return core.module().PathWatch()


def find_path(request, control, seen=None):
    """Returns (report, motion): a dict, and (times, translations, rotations) or None. seen: a
    watch(). Raises CoreError, InputProblem."""
    body, neighbours = request.body, request.rows()
    with core.errors():
        report, found = core.module().find_path(
            body.vertices,
            body.triangles,
            request.goal,
            neighbours,
            start=request.start,
            extract=request.extract,
            run=control.context,
            watch=seen,
            **request.options,
        )
    return report, _keys(found)


def _keys(found):
    """Returns a motion of the module in the order of core.Request, or None if there is none."""
    if found is None:
        return None
    times, rotations, translations = found[:3]
    return times, translations, rotations


def improve_path(request, neighbours, options, control):
    """Improves the motion of a core.Request. neighbours: the result of PathRequest.rows(). Returns
    and raises the same as find_path()."""
    vertices, triangles, motion, interpolation = core.arguments(request)
    with core.errors():
        report, found = core.module().improve_path(
            vertices, triangles, motion, neighbours, interpolation, run=control.context, **options
        )
    return report, _keys(found)


def live_clearance(vertices, triangles, neighbours, control):
    """Returns the module's LiveClearance with at(pose) and reached(from, to, apart). neighbours:
    (name, vertices, triangles). Raises CoreError."""
    with core.errors():
        return core.module().LiveClearance(vertices, triangles, neighbours, run=control.context)


def sequence_watch():
    """Returns an observer of find_sequence(). Its seen() returns (index of the current part or -1,
    number of parts with a path, farthest placement (4,4) or None)."""
    return core.module().SequenceWatch()


def find_sequence(rows, still, order, options, control, seen=None):
    """Returns the report (dict, docs/paths.md). rows, still: as the module's find_sequence() takes
    them. order: "given" or "find". seen: a sequence_watch(). Raises CoreError."""
    with core.errors():
        return core.module().find_sequence(
            rows, still, order, run=control.context, watch=seen, **options
        )[0]
