# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the core knows of ways between neighbours: it finds them, and measures one placement after another."""
from . import core


class PathRequest:
    """Input of one search, independent of any document.

    body: has vertices (n,3) mm, in the coordinates that the placements place, and triangles (m,3), made in
    any thread; goal, start: (4,4); extract, instead of a start: mm, or a direction (x, y, z); neighbours:
    (name, body in the world, chord, rule as text or None); options: as the module's find_path()."""

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
    """Neighbours as the module takes them. Raises InputProblem where one gives no triangles."""
    return [
        (name, body.vertices, body.triangles, chord, own) for name, body, chord, own in neighbours
    ]


def watch():
    """What farthest() tells of a search: the placement (4,4) that came farthest out so far, or None."""
    return core.module().PathWatch()


def find_path(request, control, seen=None):
    """(report, motion): dict, and (times, translations, rotations) or None. seen: a watch(). Raises
    CoreError, InputProblem."""
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
    """What the module gives as a motion, in the order of core.Request; None where there is none."""
    if found is None:
        return None
    times, rotations, translations = found[:3]
    return times, translations, rotations


def improve_path(request, neighbours, options, control):
    """As find_path(), of a core.Request; neighbours: as PathRequest.rows() gives them. Raises CoreError."""
    vertices, triangles, motion, interpolation = core.arguments(request)
    with core.errors():
        report, found = core.module().improve_path(
            vertices, triangles, motion, neighbours, interpolation, run=control.context, **options
        )
    return report, _keys(found)


def live_clearance(vertices, triangles, neighbours, control):
    """Prepared for at(pose) and reached(from, to, apart) of the module's LiveClearance. neighbours: (name,
    vertices, triangles). Raises CoreError."""
    with core.errors():
        return core.module().LiveClearance(vertices, triangles, neighbours, run=control.context)


def sequence_watch():
    """What seen() tells of a search for a sequence: (number of the part or -1, parts with a path, the
    placement (4,4) that came farthest out or None)."""
    return core.module().SequenceWatch()


def find_sequence(rows, still, order, options, control, seen=None):
    """Report (dict, docs/paths.md). rows, still: as the module's find_sequence() takes them; order: "given"
    or "find"; seen: a sequence_watch(). Raises CoreError."""
    with core.errors():
        return core.module().find_sequence(
            rows, still, order, run=control.context, watch=seen, **options
        )[0]
