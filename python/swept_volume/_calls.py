# SPDX-License-Identifier: LGPL-2.1-or-later
"""Computes envelopes and solids. Options have names, results can be pickled, findings go to the log."""
from __future__ import annotations

import logging
from types import TracebackType
from typing import Any, Callable, Dict, List, Optional, Tuple, Type

import numpy as np
import numpy.typing as npt

from . import _core

from ._sources import Sources
from ._values import (
    Floats,
    Integers,
    Mesh,
    MeshLike,
    MotionLike,
    Path,
    bad_option,
    frozen,
    mesh_of,
    motion_of,
    refuse_both,
)

logger = logging.getLogger("swept_volume")

Report = Dict[str, Any]


class RunContext(_core.RunContext):
    """Watches and cancels one run, from any thread: cancel(), cancelled, progress (0 to 1), phase.
    threads: None for all cores; memory_limit_mb: None for three quarters of the free memory. In a with
    statement, the run is cancelled if an exception leaves the block."""

    def __init__(
        self, threads: Optional[int] = None, memory_limit_mb: Optional[float] = None
    ) -> None:
        super().__init__(threads, memory_limit_mb)

    def __enter__(self) -> RunContext:
        return self

    def __exit__(
        self,
        kind: Optional[Type[BaseException]],
        error: Optional[BaseException],
        trace: Optional[TracebackType],
    ) -> None:
        if kind is not None:
            self.cancel()

    def __repr__(self) -> str:
        state = "cancelled" if self.cancelled else f"{self.phase}, {100 * self.progress:.0f} %"
        return f"<RunContext: {state}>"


class Result:
    """The result of compute(): mesh, report (dict), contact_time (float64 (N,): time in s at which the
    body touches the vertex; may be empty), feature_edges (int32 (E, 2): pairs of vertices along creases;
    may be empty), sources (Sources; None unless requested). The arrays are read-only."""

    __slots__ = ("mesh", "report", "contact_time", "feature_edges", "_sources", "_core")
    mesh: Mesh
    report: Report
    contact_time: Floats
    feature_edges: Integers
    _sources: Optional[Sources]

    def __init__(
        self,
        mesh: Mesh,
        report: Report,
        contact_time: npt.ArrayLike = (),
        feature_edges: Optional[npt.ArrayLike] = None,
        sources: Optional[Sources] = None,
    ) -> None:
        edges = np.empty((0, 2), np.int32) if feature_edges is None else feature_edges
        self.mesh, self.report = mesh, report
        self.contact_time = frozen(contact_time, np.float64, (-1,), "contact_time")
        self.feature_edges = frozen(edges, np.int32, (-1, 2), "feature_edges")
        self._sources = sources
        self._core: Optional[_core.Result] = None

    @classmethod
    def _of_core(cls, core: _core.Result) -> Result:
        made = cls.__new__(cls)
        made.mesh, made.report = Mesh._of_core(core.mesh), core.report
        made.contact_time, made.feature_edges = core.contact_time, core.feature_edges
        made._sources, made._core = None, core
        return made

    @property
    def sources(self) -> Optional[Sources]:
        """Returns what made each triangle; None unless requested. The first call makes the arrays."""
        if self._sources is None and self._core is not None and self._core.sources is not None:
            self._sources = Sources._of_core(self._core.sources)
        return self._sources

    @property
    def vertices(self) -> Floats:
        """Returns the vertices of the mesh."""
        return self.mesh.vertices

    @property
    def triangles(self) -> Integers:
        """Returns the triangles of the mesh."""
        return self.mesh.triangles

    def recut(self, tolerance: float, *, run: Optional[RunContext] = None) -> Result:
        """Returns the same envelope, simplified with another tolerance (mm; 0: no simplification), without
        sampling again. The result must have been computed with a tolerance. A pickled copy cannot be
        recut, because it lacks the surface before simplification."""
        if self._core is None:
            raise bad_option(
                "a pickled copy of a result cannot be simplified again with recut(); compute the result again"
            )
        return Result._of_core(self._core.recut(tolerance, run))

    def __reduce__(self) -> Tuple[Any, ...]:
        return Result, (
            self.mesh,
            self.report,
            np.array(self.contact_time),
            np.array(self.feature_edges),
            self.sources,
        )

    def __repr__(self) -> str:
        return (
            f"<Result: {len(self.triangles)} triangles, {self.report['volume']:.6g} mm^3, "
            f"cell {self.report['cell']:.4g} mm>"
        )


def _given(**options: Any) -> Dict[str, Any]:
    """Returns the options that the caller has set. Raises an error for resolution with cell, and for
    accuracy with resolution, cell, tolerance or chord_tolerance, as the program does."""
    refuse_both(options.get("resolution"), options.get("cell"))
    if options.get("accuracy") is not None:
        for name in ("resolution", "cell", "tolerance", "chord_tolerance"):
            if options.get(name):
                raise bad_option(f"accuracy and {name} exclude one another; give one of them")
        options.pop("tolerance", None)
    if options.get("cell") is not None and not options["cell"] > 0:
        raise bad_option("cell must be greater than 0 mm")
    return {name: value for name, value in options.items() if value is not None}


def _log(warnings: List[Dict[str, Any]]) -> None:
    for finding in warnings:
        logger.info("%s: %s", finding["code"], finding["text"])


def compute(
    mesh: MeshLike,
    motion: MotionLike,
    *,
    interpolation: Optional[str] = None,
    accuracy: Optional[float] = None,
    resolution: Optional[int] = None,
    cell: Optional[float] = None,
    tolerance: float = 0.0,
    offset: float = 0.0,
    conservative: bool = False,
    keep_cavities: bool = False,
    components: str = "consistent",
    backend: str = "auto",
    cull: bool = True,
    position_filter: float = 0.0,
    chord_tolerance: Optional[float] = None,
    weld_tolerance: Optional[float] = None,
    sources: bool = False,
    threads: Optional[int] = None,
    memory_limit_mb: Optional[float] = None,
    run: Optional[RunContext] = None,
) -> Result:
    """Computes the envelope of a body that moves along a motion.

    interpolation   between two poses: none, linear or screw; default: that of the motion
    accuracy        mm: how far the surface may lie from the exact one (accuracy_bound in the report).
                    Determines cell, tolerance and chord_tolerance, so neither these nor resolution may
                    be given
    resolution      cells along the longest side of the grid (default 128); or give cell
    cell            size of a cell, mm
    tolerance       mm, how far simplification may move the surface
    offset          mm, distance by which the envelope is grown
    conservative    make an envelope that provably contains the swept volume
    keep_cavities   keep enclosed cavities as inner shells
    components      method of contouring, for research; only 'consistent' guarantees a closed manifold
    backend         auto, cpu or gpu
    cull            leave out faces that are provably enclosed
    position_filter mm; skips a pose if no point of the body has moved farther since the last pose used
    chord_tolerance mm, largest deviation of the computed motion from the exact one, up to the size of a
                    cell (default: 0.02 of a cell)
    weld_tolerance  mm, joins closer vertices along open edges (default: 1e-6 of the diagonal of the
                    body's bounding box; at most a hundredth of it)
    sources         record what made each triangle (Result.sources); not with offset or conservative
    threads         None: all cores
    memory_limit_mb None: three quarters of the free memory
    run             watches and cancels the run

    Raises Error with .status, .code and .report; TypeError and ValueError for wrong types and shapes.
    """
    body, trajectory = mesh_of(mesh), motion_of(motion, interpolation)
    options = _given(
        accuracy=accuracy,
        resolution=resolution,
        cell=cell,
        tolerance=tolerance,
        offset=offset,
        conservative=conservative,
        keep_cavities=keep_cavities,
        components=components,
        backend=backend,
        cull=cull,
        position_filter=position_filter,
        chord_tolerance=chord_tolerance,
        weld_tolerance=weld_tolerance,
        sources=sources,
        threads=threads,
        memory_limit_mb=memory_limit_mb,
    )
    core = _core.compute(
        body.vertices,
        body.triangles,
        trajectory._arrays(),
        trajectory.interpolation,
        run,
        body.faces if sources else None,
        **options,
    )
    result = Result._of_core(core)
    result.report["warnings"][:0] = body.findings
    _log(result.report["warnings"])
    return result


def estimate(
    mesh: MeshLike,
    motion: MotionLike,
    *,
    interpolation: Optional[str] = None,
    resolution: Optional[int] = None,
    cell: Optional[float] = None,
    trial: bool = True,
    run: Optional[RunContext] = None,
    **options: Any,
) -> Dict[str, Any]:
    """Estimates compute() with the same options. Returns grid (3 ints), cell (mm), memory_bytes,
    seconds and triangles. Also returns useful_filter (mm) if a position_filter of this length would
    leave out most poses and change the result by no more than the chord error. trial=True samples
    some steps, which takes up to a second. Without a trial, memory, seconds and triangles are rough.
    """
    body, trajectory = mesh_of(mesh), motion_of(motion, interpolation)
    given = _given(resolution=resolution, cell=cell, **options)
    return _core.estimate(
        body.vertices,
        body.triangles,
        trajectory._arrays(),
        trajectory.interpolation,
        trial,
        run,
        **given,
    )


class PreviewSession:
    """Computes quick, coarse envelopes of one body while its motion is edited. The checked body is
    kept between calls. The options are those of compute() and hold for all calls."""

    def __init__(
        self,
        mesh: MeshLike,
        *,
        resolution: Optional[int] = None,
        cell: Optional[float] = None,
        **options: Any,
    ) -> None:
        body = mesh_of(mesh)
        given = _given(resolution=resolution, cell=cell, **options)
        faces = body.faces if given.get("sources") else None
        self._session = _core.PreviewSession(body.vertices, body.triangles, faces, **given)

    def compute(
        self,
        motion: MotionLike,
        *,
        interpolation: Optional[str] = None,
        sketch: bool = False,
        run: Optional[RunContext] = None,
    ) -> Result:
        """Does the same as the function compute(). Only one thread may call it at a time. sketch=True, for
        drawing, neither repairs nor checks the surface (finding NotChecked), and takes half the time.
        """
        trajectory = motion_of(motion, interpolation)
        return Result._of_core(
            self._session.compute(trajectory._arrays(), trajectory.interpolation, run, sketch)
        )


def check_mesh(mesh: MeshLike, *, run: Optional[RunContext] = None) -> Dict[str, Any]:
    """Checks a mesh. Returns passes, closed, manifold, oriented, self_intersections, volume (mm^3) ..."""
    body = mesh_of(mesh)
    return _core.check_mesh(body.vertices, body.triangles, run)


def write_solid(
    path: Path,
    mesh: MeshLike,
    *,
    tolerance: float = 0.0,
    exact: bool = False,
    recognise: bool = True,
    max_faces: int = 20000,
    max_megabytes: Optional[float] = None,
    schema: str = "ap214",
    product_name: str = "Swept envelope",
    author: str = "",
    organization: str = "",
    colour: Tuple[float, float, float] = (0.93, 0.78, 0.20),
    strict: bool = False,
    no_clobber: bool = False,
    reader: Optional[Callable[[bytes], Dict[str, Any]]] = None,
    run: Optional[RunContext] = None,
    origin: Optional[Tuple[Mesh, MotionLike]] = None,
) -> Dict[str, Any]:
    """Converts a closed mesh to a solid in a STEP (.step, .stp) or BREP (.brep, .brp) file. The new file
    is read back and checked before it replaces an old one. With no_clobber=True, an old file is never
    replaced. tolerance: mm; 0 for an exact solid, unless a limit requires a tolerance. strict=True
    refuses a solid that deviates by more than the tolerance. Returns solids, faces, faces_by_kind,
    valid, tolerance, deviation, volume, warnings ...; see "solid" in docs/report.md.

    reader: a function that checks the text of a STEP file in place of OpenCASCADE. A core from a wheel
    has no OpenCASCADE and needs it. help(_swept.write_solid) says what it must return.

    origin: (body, motion), of which the mesh is the envelope. With a tolerance, the solid then gets the
    exact faces that the body sweeps, if it moves in straight lines or turns about fixed axes. body: from
    read_body() of a STEP or BREP file. Raises ExportFailed (BadOption) if the body has no faces."""
    body = mesh_of(mesh)
    report = _core.write_solid(
        path,
        body.vertices,
        body.triangles,
        run,
        no_clobber,
        reader,
        tolerance=tolerance,
        exact=exact,
        recognise=recognise,
        max_faces=max_faces,
        max_megabytes=max_megabytes,
        schema=schema,
        product_name=product_name,
        author=author,
        organization=organization,
        colour=colour,
        strict=strict,
        origin=None if origin is None else _origin_of(*origin),
    )
    _log(report["warnings"])
    return report


def _origin_of(body: Mesh, motion: MotionLike) -> Tuple[Any, ...]:
    """Returns the argument `origin` of write_solid() in the form that the core expects."""
    if body.shape is None:
        raise bad_option("the body has no faces: read it with read_body() from a STEP or BREP file")
    trajectory = motion_of(motion)
    return trajectory._arrays(), trajectory.interpolation, body.shape


def estimate_solid(
    mesh: MeshLike,
    *,
    run: Optional[RunContext] = None,
    format: str = "step",
    quick: bool = False,
    **options: Any,
) -> Dict[str, Any]:
    """Estimates write_solid() with the same options by a trial, which builds the solid but makes no file.
    Returns triangles, faces, megabytes (of a 'step' or 'brep' file), seconds (expected duration of
    write_solid()), tolerance and deviation (mm), tried (True).

    quick=True makes no trial (tried is False) and takes microseconds for each triangle. Then faces,
    megabytes and seconds are upper bounds, far too large if surfaces are recognised. Raises ExportFailed
    if write_solid() would refuse the mesh or its options, Cancelled."""
    body = mesh_of(mesh)
    return _core.estimate_solid(body.vertices, body.triangles, run, format, quick, **options)
