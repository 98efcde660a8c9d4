# SPDX-License-Identifier: LGPL-2.1-or-later
"""Installation paths: the search for a path, and the improvement of a given path."""
from __future__ import annotations

from typing import Any, Dict, Iterable, Optional, Sequence, Tuple, Union

import numpy.typing as npt

from . import _core
from ._calls import RunContext, _log
from ._clearance import Neighbour, Rules, _neighbour, rule_texts
from ._values import MeshLike, Motion, MotionLike, extraction_of, matrix, mesh_of, motion_of


def find_path(
    mesh: MeshLike,
    goal: npt.ArrayLike,
    neighbours: Iterable[Neighbour],
    *,
    start: Optional[npt.ArrayLike] = None,
    extract: Union[float, Sequence[float], None] = None,
    via: Iterable[npt.ArrayLike] = (),
    clearance: float = 0.0,
    release: float = 0.0,
    translation_only: bool = False,
    max_angle: Optional[float] = None,
    interpolation: str = "linear",
    tolerance: float = 0.01,
    body_chord: Optional[float] = None,
    budget: float = 60.0,
    seed: int = 1,
    rules: Optional[Rules] = None,
    run: Optional[RunContext] = None,
) -> Tuple[Dict[str, Any], Optional[Motion]]:
    """Searches for a motion that brings a part to its goal and keeps the clearance (mm) from every
    neighbour, also between its keys. goal, start, via: matrices (4, 4). extract, in place of a
    start: a radius in mm or a direction (x, y, z). Contact is allowed while every point of the part
    is within `release` (mm) of its position at the start or at the goal. rules: as for clearance(),
    but without contact. max_angle in rad, budget in s. Returns the report (docs/paths.md) and the
    motion, or None in place of the motion if none was found.
    """
    body = mesh_of(mesh)
    report, arrays = _core.find_path(
        body.vertices,
        body.triangles,
        matrix(goal, "goal"),
        [_neighbour(item) for item in neighbours],
        None if start is None else matrix(start, "start"),
        extraction_of(extract),
        [matrix(place, "via") for place in via],
        clearance,
        release,
        translation_only,
        max_angle,
        interpolation,
        tolerance,
        body.chord_error if body_chord is None else body_chord,
        budget,
        seed,
        run,
        None,
        rule_texts(rules),
    )
    _log(report["warnings"])
    return report, None if arrays is None else motion_of(arrays, interpolation)


def improve_path(
    mesh: MeshLike,
    motion: MotionLike,
    neighbours: Iterable[Neighbour],
    *,
    locked: Iterable[int] = (),
    more_clearance: bool = False,
    clearance: float = 0.0,
    release: float = 0.0,
    translation_only: bool = False,
    max_angle: Optional[float] = None,
    interpolation: Optional[str] = None,
    tolerance: float = 0.01,
    body_chord: Optional[float] = None,
    budget: float = 60.0,
    seed: int = 1,
    rules: Optional[Rules] = None,
    run: Optional[RunContext] = None,
) -> Tuple[Dict[str, Any], Optional[Motion]]:
    """Improves a motion. Sections that are closer to a neighbour than the clearance (mm) get another
    path if the search finds one. All other sections become shorter and get fewer keys. With
    more_clearance=True, their distance from the neighbours becomes as large as possible instead. The
    ends and the keys in `locked` (indices from 0) do not change. Sections within `release` (mm) of the
    ends may be closer and do not change. Returns the report (docs/paths.md) and the motion, or None in
    place of the motion if no motion was found that keeps the clearance."""
    body, path = mesh_of(mesh), motion_of(motion, interpolation)
    report, arrays = _core.improve_path(
        body.vertices,
        body.triangles,
        path._arrays(),
        [_neighbour(item) for item in neighbours],
        path.interpolation,
        list(locked),
        more_clearance,
        clearance,
        release,
        translation_only,
        max_angle,
        tolerance,
        body.chord_error if body_chord is None else body_chord,
        budget,
        seed,
        run,
        rule_texts(rules),
    )
    _log(report["warnings"])
    return report, None if arrays is None else motion_of(arrays, path.interpolation)
