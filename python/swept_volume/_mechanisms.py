# SPDX-License-Identifier: LGPL-2.1-or-later
"""Clearances of mechanisms: parts that move at the same time."""
from __future__ import annotations

from typing import Any, Dict, Iterable, Optional, Sequence, Tuple, Union

from . import _core
from ._calls import RunContext, _log
from ._values import MeshLike, MotionLike, mesh_of, motion_arguments

MechanismPart = Union[
    Tuple[str, MeshLike, Optional[MotionLike]], Tuple[str, MeshLike, Optional[MotionLike], float]
]


def _part(item: MechanismPart) -> Tuple[Any, ...]:
    parts: Sequence[Any] = item if isinstance(item, (tuple, list)) else ()
    if len(parts) not in (3, 4):
        raise TypeError("a part is (name, mesh, motion) or (name, mesh, motion, chord error in mm)")
    mesh = mesh_of(parts[1])
    motion = motion_arguments(parts[2])
    chord = float(parts[3]) if len(parts) == 4 else mesh.chord_error
    return (parts[0], mesh.vertices, mesh.triangles, *motion, chord)


def mechanism(
    parts: Iterable[MechanismPart],
    *,
    required: float = 0.0,
    tolerance: float = 0.01,
    range: Optional[float] = None,
    interval_tolerance: Optional[float] = None,
    curve: int = 200,
    penetration: bool = True,
    ignored: Iterable[Tuple[str, str]] = (),
    rules: Iterable[Tuple[str, str, Union[str, float]]] = (),
    run: Optional[RunContext] = None,
) -> Dict[str, Any]:
    """Measures the smallest distance of every pair of parts over the time interval that all motions
    have in common. No approach between two poses is missed. parts: (name, mesh, motion) or (name, mesh,
    motion, chord error). A part with the motion None stands still where its mesh is. Times in s, lengths
    in mm. Pairs that come closer than `range` (None: a tenth of the median size of the parts) are measured
    and listed.
    ignored: pairs of names that are not checked. rules: (name, name, rule) for single pairs, with rules
    as for clearance() (mm, 'contact', 'contact:MM', 'ignore'). Returns the report (docs/clearance.md).
    Raises InvalidInput (NoParts, PartTwice, UnknownPart, BadRule, NothingMoves, NoCommonTime,
    NotInterpolated, EqualTimes), Cancelled.
    """
    report: Dict[str, Any] = _core.mechanism(
        [_part(item) for item in parts],
        required,
        tolerance,
        range,
        interval_tolerance,
        curve,
        penetration,
        [(*pair, "ignore") for pair in ignored] + [(a, b, str(rule)) for a, b, rule in rules],
        run,
    )
    _log(report["warnings"])
    return report
