# SPDX-License-Identifier: LGPL-2.1-or-later
"""Parts that are installed one after the other."""
from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Dict, Iterable, List, Optional, Sequence, Tuple, Union

import numpy.typing as npt

from . import _core
from ._calls import RunContext, _log
from ._clearance import Neighbour, _neighbour
from ._values import (
    MeshLike,
    Motion,
    MotionLike,
    extraction_of,
    matrix,
    mesh_of,
    motion_arguments,
    motion_of,
)


@dataclass(frozen=True)
class SequencePart:
    """A part, its installed position, and how the part gets there. goal, start, via: matrices (4, 4).
    Without a goal, the part is installed where its mesh is. extract, in place of a start: a radius in mm
    or a direction (x, y, z). motion, in place of goal, start, via and extract: a motion that ends in the
    installed position. chord_error in mm; default: that of the mesh."""

    name: str
    mesh: MeshLike
    goal: Optional[npt.ArrayLike] = None
    start: Optional[npt.ArrayLike] = None
    extract: Union[float, Sequence[float], None] = None
    via: Sequence[npt.ArrayLike] = ()
    motion: Optional[MotionLike] = None
    chord_error: Optional[float] = None

    def _tuple(self) -> Tuple[Any, ...]:
        mesh = mesh_of(self.mesh)
        chord = mesh.chord_error if self.chord_error is None else self.chord_error
        motion = motion_arguments(self.motion)
        ends = ((self.goal, "goal"), (self.start, "start"))
        goal, start = (None if end is None else matrix(end, name) for end, name in ends)
        via = [matrix(place, "via") for place in self.via]
        ends_and_via = (goal, start, extraction_of(self.extract), via)
        return (self.name, mesh.vertices, mesh.triangles, chord, *ends_and_via, *motion)


def find_sequence(
    parts: Iterable[SequencePart],
    neighbours: Iterable[Neighbour] = (),
    *,
    order: str = "given",
    clearance: float = 0.0,
    release: float = 0.0,
    translation_only: bool = False,
    max_angle: Optional[float] = None,
    interpolation: str = "linear",
    tolerance: float = 0.01,
    budget: float = 60.0,
    most_moves: Optional[int] = None,
    seed: int = 1,
    ignored: Iterable[Tuple[str, str]] = (),
    rules: Iterable[Tuple[str, str, Union[str, float]]] = (),
    run: Optional[RunContext] = None,
) -> Tuple[Dict[str, Any], Optional[Dict[str, Motion]]]:
    """Searches for motions of parts that are installed one after the other. Each part keeps its distance
    from the neighbours and from the parts already installed. order: "given", or "find" to search for an
    order by taking the parts out. rules: (name, name, rule) for single pairs. A rule is a required
    distance (mm), or "ignore" (as for the pairs in `ignored`). The budget (s) is for all searches
    together. most_moves limits the moves of a search with turns; the result is then the same on every
    machine. The other arguments are those of find_path(). Returns the report (docs/paths.md), and a dict
    with the motion of each part on a common time axis, or None if not all parts have a path. Raises
    InvalidInput (NoParts, PartTwice, PartsIntersect, PartsTooNear, ... and the codes of find_path()),
    Cancelled."""
    given: List[SequencePart] = list(parts)
    report, arrays = _core.find_sequence(
        [part._tuple() for part in given],
        [_neighbour(item) for item in neighbours],
        order,
        clearance,
        release,
        translation_only,
        max_angle,
        interpolation,
        tolerance,
        budget,
        most_moves,
        seed,
        [(*pair, "ignore") for pair in ignored] + [(a, b, str(rule)) for a, b, rule in rules],
        run,
        None,
    )
    _log(report["warnings"])
    if arrays is None:
        return report, None
    motions = {}
    for part, keys in zip(given, arrays):
        if part.motion is None:
            motions[part.name] = Motion(*keys, interpolation=interpolation)
        else:
            own = motion_of(part.motion, None)
            motions[part.name] = Motion(*keys, interpolation=own.interpolation, pivot=own.pivot)
    return report, motions
