# SPDX-License-Identifier: LGPL-2.1-or-later
"""Meshes and motions. Their arrays are checked once and read-only. Both can be pickled."""
from __future__ import annotations

import os
from typing import Any, Dict, List, Optional, Sequence, Tuple, Type, TypeVar, Union

import numpy as np
import numpy.typing as npt

from . import _core

Failure = TypeVar("Failure", bound=_core.Error)
Path = Union[str, bytes, "os.PathLike[str]", "os.PathLike[bytes]"]
Floats = npt.NDArray[np.float64]
Integers = npt.NDArray[np.int32]


def core_error(kind: Type[Failure], code: str, message: str) -> Failure:
    """Returns an error of the class `kind` with the attributes that the core gives to its errors."""
    error = kind(message)
    error.status, error.code, error.report = kind.__name__, code, None
    return error


def bad_option(message: str) -> _core.InvalidInput:
    """Returns the error for options that are not allowed."""
    return core_error(_core.InvalidInput, "BadOption", message)


def refuse_both(resolution: Optional[int], cell: Optional[float]) -> None:
    """Raises InvalidInput (BadOption) if both are given."""
    if resolution is not None and cell is not None:
        raise bad_option("resolution and cell exclude one another; give only one of them")


def require_file(path: Path) -> None:
    """Raises the error of the system (FileNotFoundError, PermissionError ...) if a file cannot be read."""
    with open(path, "rb"):
        pass


def frozen(values: Any, dtype: Any, shape: Tuple[int, ...], name: str) -> npt.NDArray[Any]:
    """Returns a read-only copy of an array with this shape, in which -1 stands for any length. Raises
    TypeError, ValueError."""
    if isinstance(values, np.ma.MaskedArray):
        raise TypeError(f"{name} is a masked array: fill or remove the masked entries first")
    given = np.asarray(values)
    if given.dtype.kind not in "fiu" and given.size > 0:
        raise TypeError(f"{name} must be an array of numbers")
    if np.dtype(dtype).kind == "i" and given.dtype.kind == "f" and given.size > 0:
        raise TypeError(f"{name} must be an array of integers")
    if given.ndim != len(shape) or any(w not in (-1, h) for w, h in zip(shape, given.shape)):
        wanted = tuple("N" if n < 0 else n for n in shape)
        raise ValueError(f"{name} has shape {given.shape}; expected {wanted}")
    if np.dtype(dtype).kind == "i" and given.size > 0:
        limits = np.iinfo(dtype)
        if given.min() < limits.min or given.max() > limits.max:
            raise ValueError(f"{name} contains numbers beyond 32 bits")
    array = np.array(given, dtype=dtype, order="C")
    array.setflags(write=False)
    return array


def matrix(values: npt.ArrayLike, name: str) -> Floats:
    """Returns a placement as a read-only matrix (4, 4)."""
    return frozen(values, np.float64, (4, 4), name)


def extraction_of(extract: Union[float, Sequence[float], None]) -> Union[float, Floats, None]:
    """Returns the argument `extract`, converted: a radius in mm, a direction (3,), or None."""
    if extract is None or np.ndim(extract) == 0:
        return extract if extract is None else float(extract)  # type: ignore[arg-type]
    return frozen(extract, np.float64, (3,), "extract")


class Mesh:
    """A triangle mesh. vertices: float64 (N, 3) in mm. triangles: int32 (M, 3), counter-clockwise seen
    from outside. Both are read-only. chord_error: how far (mm) the triangles of a tessellated solid may
    deviate from its surface. findings: the findings from reading the file, as in the warnings of a
    report. faces: int32 (M,), for each triangle the index of its face of the solid, in the order of the
    file; None if the faces are not known. shape: the faces and edges of the solid, for write_solid();
    None if the file was a mesh, and after unpickling."""

    __slots__ = ("vertices", "triangles", "chord_error", "findings", "faces", "shape")
    vertices: Floats
    triangles: Integers
    chord_error: float
    findings: List[Dict[str, Any]]
    faces: Optional[Integers]
    shape: Optional[_core.BodyShape]

    def __init__(
        self,
        vertices: npt.ArrayLike,
        triangles: npt.ArrayLike,
        *,
        chord_error: float = 0.0,
        findings: Sequence[Dict[str, Any]] = (),
        faces: Optional[npt.ArrayLike] = None,
    ) -> None:
        self.vertices = frozen(vertices, np.float64, (-1, 3), "vertices")
        self.triangles = frozen(triangles, np.int32, (-1, 3), "triangles")
        self.chord_error = float(chord_error)
        self.findings = list(findings)
        count = len(self.triangles)
        self.faces = None if faces is None else frozen(faces, np.int32, (count,), "faces")
        self.shape = None

    @classmethod
    def _of_core(cls, mesh: _core.Mesh) -> Mesh:
        """Returns a mesh with the read-only arrays of the core, without a copy."""
        made = cls.__new__(cls)
        made.vertices, made.triangles = mesh.vertices, mesh.triangles
        made.chord_error, made.findings = mesh.chord_error, list(mesh.findings)
        made.faces, made.shape = mesh.faces, mesh.shape
        return made

    @classmethod
    def read(cls, path: Path, *, unit: str = "mm") -> Mesh:
        """Reads PLY, STL, OBJ or OFF. unit: unit of the numbers in the file (mm, cm, m, in)."""
        require_file(path)
        return cls._of_core(_core.read_mesh(path, unit))

    def write(self, path: Path, *, no_clobber: bool = False) -> None:
        """Writes PLY, OBJ, OFF or 3MF (double precision), or STL (single precision). Replaces an old file
        only when the new file is complete, and not at all with no_clobber=True."""
        _core.write_mesh(path, self.vertices, self.triangles, no_clobber)

    def __reduce__(self) -> Tuple[Any, ...]:
        return _mesh_again, (
            np.array(self.vertices),
            np.array(self.triangles),
            self.chord_error,
            self.findings,
            None if self.faces is None else np.array(self.faces),
        )

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Mesh):
            return NotImplemented
        return np.array_equal(self.vertices, other.vertices) and np.array_equal(
            self.triangles, other.triangles
        )

    __hash__ = None  # type: ignore[assignment]

    def __repr__(self) -> str:
        text = f"<Mesh: {len(self.vertices)} vertices, {len(self.triangles)} triangles"
        if len(self.vertices):
            size = np.ptp(self.vertices, axis=0)
            text += " in a box of {:.6g} x {:.6g} x {:.6g} mm".format(*size)
        return text + ">"


def _mesh_again(
    vertices: Floats,
    triangles: Integers,
    chord_error: float,
    findings: List[Dict[str, Any]],
    faces: Optional[Integers] = None,
) -> Mesh:
    return Mesh(vertices, triangles, chord_error=chord_error, findings=findings, faces=faces)


class Motion:
    """Poses in the order of time. times: float64 (K,) in s. quaternions: float64 (K, 4) in the order
    x, y, z, w. translations: float64 (K, 3) in mm; x_world = R x + t. All are read-only. interpolation:
    how the body moves between two poses: "linear" (straight line and slerp), "screw", or "none" (the
    body does not move; it is copied to each pose). pivot: float64 (3,), mm, in coordinates of the body:
    the point that moves along a straight line if the interpolation is linear."""

    __slots__ = ("times", "quaternions", "translations", "interpolation", "pivot")
    times: Floats
    quaternions: Floats
    translations: Floats
    interpolation: str
    pivot: Floats

    def __init__(
        self,
        times: npt.ArrayLike,
        quaternions: npt.ArrayLike,
        translations: npt.ArrayLike,
        *,
        interpolation: str = "linear",
        pivot: npt.ArrayLike = (0.0, 0.0, 0.0),
    ) -> None:
        self.times = frozen(times, np.float64, (-1,), "times")
        count = len(self.times)
        self.quaternions = frozen(quaternions, np.float64, (count, 4), "quaternions")
        self.translations = frozen(translations, np.float64, (count, 3), "translations")
        if interpolation not in ("none", "linear", "screw"):
            raise bad_option(f"interpolation is '{interpolation}'; allowed: none, linear, screw")
        self.interpolation = interpolation
        self.pivot = frozen(pivot, np.float64, (3,), "pivot")

    @classmethod
    def from_matrices(
        cls,
        matrices: npt.ArrayLike,
        times: Optional[npt.ArrayLike] = None,
        *,
        interpolation: str = "linear",
        pivot: npt.ArrayLike = (0.0, 0.0, 0.0),
    ) -> Motion:
        """Returns the motion for rigid matrices (K, 4, 4). Without times, the poses are at 0, 1, 2
        ... s."""
        checked = frozen(matrices, np.float64, (-1, 4, 4), "matrices")
        at = np.arange(len(checked), dtype=np.float64) if times is None else times
        at = frozen(at, np.float64, (len(checked),), "times")
        arrays = _core.poses_from_matrices(at, checked)
        return cls(*arrays, interpolation=interpolation, pivot=pivot)

    @classmethod
    def read(
        cls,
        path: Path,
        *,
        unit: str = "mm",
        interpolation: str = "linear",
        pivot: npt.ArrayLike = (0.0, 0.0, 0.0),
    ) -> Motion:
        """Reads a table of poses, which may be compressed with gzip or xz. unit: unit of the translations."""
        require_file(path)
        arrays = _core.read_trajectory_csv(path, unit)
        return cls(*arrays, interpolation=interpolation, pivot=pivot)

    def with_pivot(self, pivot: npt.ArrayLike) -> Motion:
        """Returns the same poses with another pivot (3,), mm: the point of the body that moves in a straight
        line between them."""
        arrays = self.times, self.quaternions, self.translations
        return Motion(*arrays, interpolation=self.interpolation, pivot=pivot)

    def _arrays(self) -> Tuple[Floats, Floats, Floats, Floats]:
        """Returns the motion as arrays for the core."""
        return self.times, self.quaternions, self.translations, self.pivot

    def __len__(self) -> int:
        return len(self.times)

    def __reduce__(self) -> Tuple[Any, ...]:
        times, quaternions, translations, pivot = map(np.array, self._arrays())
        return _motion_again, (times, quaternions, translations, self.interpolation, pivot)

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Motion):
            return NotImplemented
        return self.interpolation == other.interpolation and all(
            np.array_equal(getattr(self, name), getattr(other, name))
            for name in ("times", "quaternions", "translations", "pivot")
        )

    __hash__ = None  # type: ignore[assignment]

    def __repr__(self) -> str:
        text = f"<Motion: {len(self)} poses, {self.interpolation}"
        if len(self):
            text += f", from {self.times[0]:.6g} to {self.times[-1]:.6g} s"
        if self.pivot.any():
            text += ", pivot {:.6g}, {:.6g}, {:.6g} mm".format(*self.pivot)
        return text + ">"


def _motion_again(
    times: Floats,
    quaternions: Floats,
    translations: Floats,
    interpolation: str,
    pivot: npt.ArrayLike = (0.0, 0.0, 0.0),
) -> Motion:
    return Motion(times, quaternions, translations, interpolation=interpolation, pivot=pivot)


MeshLike = Union[Mesh, Tuple[npt.ArrayLike, npt.ArrayLike]]
MotionLike = Union[
    Motion,
    Tuple[npt.ArrayLike, npt.ArrayLike, npt.ArrayLike],
    Tuple[npt.ArrayLike, npt.ArrayLike],
    npt.NDArray[Any],
    Sequence[npt.NDArray[Any]],
]


def mesh_of(mesh: MeshLike) -> Mesh:
    """Returns the given Mesh, or makes one of a pair of arrays. Raises TypeError, ValueError."""
    if isinstance(mesh, Mesh):
        return mesh
    if isinstance(mesh, (tuple, list)) and len(mesh) == 2:
        return Mesh(mesh[0], mesh[1])
    raise TypeError("a mesh is a Mesh or a pair (vertices, triangles)")


def motion_of(motion: MotionLike, interpolation: Optional[str] = None) -> Motion:
    """Returns the given Motion, or makes one of arrays. interpolation, if given, replaces the
    interpolation of the motion."""
    parts: Sequence[Any] = motion if isinstance(motion, (tuple, list)) else ()
    if isinstance(motion, Motion):
        made = motion
    elif parts and all(np.shape(part) == (4, 4) for part in parts):
        made = Motion.from_matrices(np.array(parts))
    elif len(parts) == 3:
        made = Motion(*parts)
    elif len(parts) == 2:
        made = Motion.from_matrices(parts[1], parts[0])
    elif isinstance(motion, np.ndarray):
        made = Motion.from_matrices(motion)
    else:
        raise TypeError(
            "a motion is a Motion, (times, quaternions, translations), (times, matrices), an array "
            "(K, 4, 4) or a list of matrices (4, 4)"
        )
    if interpolation is None or interpolation == made.interpolation:
        return made
    arrays = made.times, made.quaternions, made.translations
    return Motion(*arrays, interpolation=interpolation, pivot=made.pivot)


def motion_arguments(motion: Optional[MotionLike]) -> Tuple[Any, str]:
    """Returns the arrays of a motion and its interpolation, as the core takes them. None: no motion."""
    if motion is None:
        return None, "linear"
    given = motion_of(motion)
    return given._arrays(), given.interpolation


def read_mesh(path: Path, *, unit: str = "mm") -> Mesh:
    """Reads a mesh file, as Mesh.read() does."""
    return Mesh.read(path, unit=unit)


def write_mesh(path: Path, mesh: MeshLike, *, no_clobber: bool = False) -> None:
    """Writes a mesh file, as Mesh.write() does."""
    mesh_of(mesh).write(path, no_clobber=no_clobber)


def read_motion(
    path: Path,
    *,
    unit: str = "mm",
    interpolation: str = "linear",
    pivot: npt.ArrayLike = (0.0, 0.0, 0.0),
) -> Motion:
    """Reads a table of poses, as Motion.read() does."""
    return Motion.read(path, unit=unit, interpolation=interpolation, pivot=pivot)


def read_body(
    path: Path,
    *,
    unit: str = "mm",
    tolerance: Optional[float] = None,
    cell: Optional[float] = None,
    resolution: Optional[int] = None,
    accuracy: Optional[float] = None,
    angle: float = 0.2,
    reader: Optional["_core.SolidReader"] = None,
) -> Mesh:
    """Reads a moving part: a mesh file as read_mesh() does, or all solids of a STEP or BREP file as one
    body. Solids are approximated by triangles, with a deviation of at most tolerance (mm). Without a
    tolerance, give accuracy (mm), cell (mm) or resolution of the envelope that will be computed. The
    deviation is then at most 0.01 of the accuracy, 0.02 of the cell, or 0.02 of the smallest cell that
    the resolution (default 128) can give. angle: largest angle (rad) between adjacent triangles. reader:
    a function that reads STEP and BREP files in place of OpenCASCADE. A core from a wheel has no
    OpenCASCADE and needs it (help(swept_volume._core.read_body))."""
    refuse_both(resolution, cell)
    require_file(path)
    if tolerance is None and accuracy is not None:
        tolerance = 0.01 * accuracy
    cells = 128 if resolution is None else resolution
    return Mesh._of_core(
        _core.read_body(path, unit, tolerance, cell, cells, angle=angle, reader=reader)
    )


def read_parts(
    path: Path,
    *,
    unit: str = "mm",
    chord_error: float = 0.0,
    deflection: float = 0.05,
    reader: Optional["_core.SolidReader"] = None,
) -> List[Tuple[str, Mesh]]:
    """Reads parts with their names, for example as neighbours for clearance(). A mesh file is one part,
    named after the file. Each solid of a STEP or BREP file is one part, named after its product. Its
    triangles deviate from it by at most deflection (mm). chord_error: how far (mm) the triangles of a
    mesh file deviate from the exact surface. reader: as for read_body()."""
    require_file(path)
    parts = _core.read_parts(path, unit, chord_error, deflection, reader=reader)
    return [(name, Mesh._of_core(mesh)) for name, mesh in parts]
