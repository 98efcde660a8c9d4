# SPDX-License-Identifier: LGPL-2.1-or-later
"""Comparison of parts that stand still: distances, depths and shared solids."""
from __future__ import annotations

from typing import Any, Dict, Iterable, List, Optional, Sequence, Tuple, Union

from . import _core
from ._calls import RunContext, _log
from ._values import Mesh, MeshLike, mesh_of

OverlapPart = Union[Tuple[str, MeshLike], Tuple[str, MeshLike, float]]


def _part(item: OverlapPart) -> Tuple[Any, ...]:
    parts: Sequence[Any] = item if isinstance(item, (tuple, list)) else ()
    if len(parts) not in (2, 3):
        raise TypeError("a part is (name, mesh) or (name, mesh, chord error in mm)")
    mesh = mesh_of(parts[1])
    chord = float(parts[2]) if len(parts) == 3 else mesh.chord_error
    return parts[0], mesh.vertices, mesh.triangles, chord


def overlap(
    parts: Iterable[OverlapPart],
    *,
    required: float = 0.0,
    tolerance: float = 0.01,
    shared: bool = True,
    run: Optional[RunContext] = None,
) -> Tuple[Dict[str, Any], List[Optional[Mesh]]]:
    """Compares every pair of parts that stand still. Measures their smallest distance or, if they
    overlap, the depth of the overlap and the shared volume. parts: (name, mesh) or (name, mesh, chord
    error in mm), such as envelopes and other reserved spaces. Lengths in mm, volumes in mm^3. Returns
    the report (docs/overlap.md), and for each pair of the report the mesh of the shared volume. A mesh
    is None if there is no shared volume, or with shared=False. Raises InvalidInput (NoParts,
    PartTwice), Cancelled.
    """
    report, found = _core.overlap([_part(item) for item in parts], required, tolerance, shared, run)
    _log(report["warnings"])
    return report, [Mesh(*arrays) if len(arrays[1]) else None for arrays in found]
