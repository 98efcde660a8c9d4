# SPDX-License-Identifier: LGPL-2.1-or-later
"""Distances of a moving body from its neighbours over a whole motion, and rules for neighbours."""
from __future__ import annotations

from typing import Any, Dict, Iterable, List, Mapping, Optional, Sequence, Tuple, Union

import numpy as np
import numpy.typing as npt

from . import _core
from ._calls import RunContext, _log
from ._values import Floats, Integers, MeshLike, MotionLike, frozen, mesh_of, motion_of

Neighbour = Union[Tuple[str, MeshLike], Tuple[str, MeshLike, float]]
#: Names of neighbours, with wildcards * and ? -> distance in mm, "contact", "contact:MM" or "ignore".
Rules = Mapping[str, Union[float, str]]


def rule_texts(rules: Optional[Rules]) -> List[str]:
    """Returns the rules as texts "NAME=RULE" for the core. Raises TypeError."""
    texts = []
    for name, rule in (rules or {}).items():
        if isinstance(rule, bool) or not isinstance(rule, (str, int, float, np.number)):
            raise TypeError(
                f"the rule for {name!r} is {rule!r}: a rule is a distance in mm, 'contact', "
                "'contact:MM' or 'ignore'"
            )
        texts.append(f"{name}={rule if isinstance(rule, str) else repr(float(rule))}")
    return texts


def _neighbour(item: Neighbour) -> Tuple[str, Floats, Integers, float]:
    parts: Sequence[Any] = item if isinstance(item, (tuple, list)) else ()
    if len(parts) not in (2, 3):
        raise TypeError("a neighbour is (name, mesh) or (name, mesh, chord error in mm)")
    mesh = mesh_of(parts[1])
    chord = float(parts[2]) if len(parts) == 3 else mesh.chord_error
    return parts[0], mesh.vertices, mesh.triangles, chord


def clearance(
    mesh: MeshLike,
    motion: MotionLike,
    neighbours: Iterable[Neighbour],
    *,
    interpolation: Optional[str] = None,
    required: float = 0.0,
    tolerance: float = 0.01,
    body_chord: Optional[float] = None,
    interval_tolerance: Optional[float] = None,
    curve: int = 200,
    penetration: bool = True,
    rules: Optional[Rules] = None,
    run: Optional[RunContext] = None,
) -> Dict[str, Any]:
    """Measures the smallest distance of a moving body from each neighbour over the whole motion. No
    approach between two poses is missed. neighbours: (name, mesh) or (name, mesh, chord error). Lengths
    in mm. The default of a chord error is the chord_error of the mesh. rules: for neighbours with
    another rule than the distance `required`: {"bolt*": "contact:0.1", "cover": 5.0, "hose": "ignore"}.
    Returns the report (docs/clearance.md)."""
    body, trajectory = mesh_of(mesh), motion_of(motion, interpolation)
    report: Dict[str, Any] = _core.clearance(
        body.vertices,
        body.triangles,
        trajectory._arrays(),
        [_neighbour(item) for item in neighbours],
        trajectory.interpolation,
        required,
        tolerance,
        body.chord_error if body_chord is None else body_chord,
        interval_tolerance,
        curve,
        penetration,
        run,
        rule_texts(rules),
    )
    _log(report["warnings"])
    return report


def first_contacts(
    mesh: MeshLike,
    motion: MotionLike,
    neighbours: Iterable[Neighbour],
    *,
    interpolation: Optional[str] = None,
    tolerance: float = 0.01,
    body_chord: Optional[float] = None,
    run: Optional[RunContext] = None,
) -> Dict[str, str]:
    """Returns the contacts of the body at the first pose of its motion, as rules for clearance() that
    allow them: {"flange": "contact", "bearing": "contact:0.09"}. Remove contacts that are not intended.
    The arguments are those of clearance()."""
    body, trajectory = mesh_of(mesh), motion_of(motion, interpolation)
    parts = [_neighbour(item) for item in neighbours]
    texts = _core.first_contacts(
        body.vertices,
        body.triangles,
        trajectory._arrays(),
        parts,
        trajectory.interpolation,
        tolerance,
        body.chord_error if body_chord is None else body_chord,
        run,
    )
    found: Dict[str, str] = {}
    # Of several neighbours with the same name, the deepest contact counts.
    for (name, *_), text in zip(parts, texts):
        depth = [float(t.partition(":")[2] or 0) for t in (text, found.get(name, ""))]
        if text and (name not in found or depth[0] > depth[1]):
            found[name] = text
    return found


def distance_to_mesh(
    points: npt.ArrayLike, mesh: MeshLike, *, run: Optional[RunContext] = None
) -> Floats:
    """Returns the distance of each point (N, 3) from a mesh, mm; negative inside a closed mesh."""
    body = mesh_of(mesh)
    checked = frozen(points, np.float64, (-1, 3), "points")
    return _core.distance_to_mesh(checked, body.vertices, body.triangles, run)
