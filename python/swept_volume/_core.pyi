# SPDX-License-Identifier: LGPL-2.1-or-later
"""Types of the compiled module. Use the package swept_volume, which has the documented interface."""
from typing import Any, Callable, Dict, List, Optional, Sequence, Tuple

import numpy as np
import numpy.typing as npt

#: path, linear (mm) and angular deflection (rad) -> (name, vertices, triangles, faces or None)
SolidReader = Callable[
    [str, float, float],
    Sequence[Tuple[str, npt.ArrayLike, npt.ArrayLike, Optional[npt.ArrayLike]]],
]
HAS_SOLIDS: bool
__version__: str

class Error(RuntimeError):
    status: str
    code: str
    report: Optional[Dict[str, Any]]

class InvalidInput(Error, ValueError): ...
class ResourceLimit(Error): ...
class OutOfMemory(Error): ...
class Cancelled(Error): ...
class DeviceUnavailable(Error): ...
class DeviceLost(Error): ...
class ExportFailed(Error): ...
class InternalError(Error): ...

class RunContext:
    threads: Optional[int]
    def __init__(
        self, threads: Optional[int] = None, memory_limit_mb: Optional[float] = None
    ) -> None: ...
    def cancel(self) -> None: ...
    @property
    def cancelled(self) -> bool: ...
    @property
    def progress(self) -> float: ...
    @property
    def phase(self) -> str: ...

class BodyShape: ...

class Mesh:
    @property
    def shape(self) -> Optional[BodyShape]: ...
    @property
    def vertices(self) -> npt.NDArray[np.float64]: ...
    @property
    def triangles(self) -> npt.NDArray[np.int32]: ...
    @property
    def faces(self) -> Optional[npt.NDArray[np.int32]]: ...
    @property
    def chord_error(self) -> float: ...
    @property
    def findings(self) -> List[Dict[str, Any]]: ...

class Sources:
    KINDS: Tuple[str, str, str]
    def __len__(self) -> int: ...
    @property
    def kind(self) -> npt.NDArray[np.int8]: ...
    @property
    def faces(self) -> npt.NDArray[np.int32]: ...
    @property
    def step(self) -> npt.NDArray[np.int32]: ...
    @property
    def time(self) -> npt.NDArray[np.float64]: ...
    @property
    def point(self) -> npt.NDArray[np.float64]: ...

class Result:
    @property
    def mesh(self) -> Mesh: ...
    @property
    def vertices(self) -> npt.NDArray[np.float64]: ...
    @property
    def triangles(self) -> npt.NDArray[np.int32]: ...
    @property
    def report(self) -> Dict[str, Any]: ...
    @property
    def contact_time(self) -> npt.NDArray[np.float64]: ...
    @property
    def feature_edges(self) -> npt.NDArray[np.int32]: ...
    @property
    def sources(self) -> Optional[Sources]: ...
    def recut(self, tolerance: float, run: Optional[RunContext] = None) -> Result: ...

class PreviewSession:
    def __init__(
        self,
        vertices: npt.ArrayLike,
        triangles: npt.ArrayLike,
        faces: Optional[npt.ArrayLike] = None,
        **options: Any,
    ) -> None: ...
    def compute(
        self,
        motion: Any,
        interpolation: str = "linear",
        run: Optional[RunContext] = None,
        sketch: bool = False,
    ) -> Result: ...

def compute(
    vertices: npt.ArrayLike,
    triangles: npt.ArrayLike,
    motion: Any,
    interpolation: str = "linear",
    run: Optional[RunContext] = None,
    faces: Optional[npt.ArrayLike] = None,
    **options: Any,
) -> Result: ...
def estimate(
    vertices: npt.ArrayLike,
    triangles: npt.ArrayLike,
    motion: Any,
    interpolation: str = "linear",
    trial: bool = False,
    run: Optional[RunContext] = None,
    **options: Any,
) -> Dict[str, Any]: ...
def costs_accuracy(code: str) -> bool: ...
def options_of_accuracy(accuracy: float) -> Dict[str, float]: ...
def check_mesh(
    vertices: npt.ArrayLike, triangles: npt.ArrayLike, run: Optional[RunContext] = None
) -> Dict[str, Any]: ...
def read_mesh(path: Any, unit: str = "mm") -> Mesh: ...
def read_body(
    path: Any,
    unit: str = "mm",
    tolerance: Optional[float] = None,
    cell: Optional[float] = None,
    resolution: int = 128,
    run: Optional[RunContext] = None,
    angle: float = 0.2,
    reader: Optional[SolidReader] = None,
) -> Mesh: ...
def read_parts(
    path: Any,
    unit: str = "mm",
    chord_error: float = 0.0,
    deflection: float = 0.05,
    run: Optional[RunContext] = None,
    reader: Optional[SolidReader] = None,
) -> List[Tuple[str, Mesh]]: ...
def write_mesh(
    path: Any, vertices: npt.ArrayLike, triangles: npt.ArrayLike, no_clobber: bool = False
) -> None: ...

_Poses = Tuple[npt.NDArray[np.float64], npt.NDArray[np.float64], npt.NDArray[np.float64]]

def read_trajectory_csv(path: Any, unit: str = "mm") -> _Poses: ...
def poses_from_matrices(times: npt.ArrayLike, matrices: npt.ArrayLike) -> _Poses: ...
def write_solid(
    path: Any,
    vertices: npt.ArrayLike,
    triangles: npt.ArrayLike,
    run: Optional[RunContext] = None,
    no_clobber: bool = False,
    reader: Optional[Callable[[bytes], Dict[str, Any]]] = None,
    **options: Any,
) -> Dict[str, Any]: ...
def estimate_solid(
    vertices: npt.ArrayLike,
    triangles: npt.ArrayLike,
    run: Optional[RunContext] = None,
    format: str = "step",
    quick: bool = False,
    **options: Any,
) -> Dict[str, Any]: ...
def clearance(
    vertices: npt.ArrayLike,
    triangles: npt.ArrayLike,
    motion: Any,
    neighbours: Any,
    interpolation: str = "linear",
    required: float = 0.0,
    tolerance: float = 0.01,
    body_chord: float = 0.0,
    interval_tolerance: Optional[float] = None,
    curve: int = 200,
    penetration: bool = True,
    run: Optional[RunContext] = None,
    rules: Sequence[str] = (),
) -> Dict[str, Any]: ...
def rules_for(rules: Sequence[str], names: Optional[Sequence[str]] = None) -> List[str]: ...
def first_contacts(
    vertices: npt.ArrayLike,
    triangles: npt.ArrayLike,
    motion: Any,
    neighbours: Any,
    interpolation: str = "linear",
    tolerance: float = 0.01,
    body_chord: float = 0.0,
    run: Optional[RunContext] = None,
) -> List[str]: ...
def mechanism(
    parts: Any,
    required: float = 0.0,
    tolerance: float = 0.01,
    range: Optional[float] = None,
    interval_tolerance: Optional[float] = None,
    curve: int = 200,
    penetration: bool = True,
    rules: Any = (),
    run: Optional[RunContext] = None,
) -> Dict[str, Any]: ...
def overlap(
    parts: Any,
    required: float = 0.0,
    tolerance: float = 0.01,
    shared: bool = True,
    run: Optional[RunContext] = None,
) -> Tuple[Dict[str, Any], List[Any]]: ...
def find_path(
    vertices: npt.ArrayLike,
    triangles: npt.ArrayLike,
    goal: npt.ArrayLike,
    neighbours: Any,
    start: Optional[npt.ArrayLike] = None,
    extract: Any = None,
    via: Any = (),
    clearance: float = 0.0,
    release: float = 0.0,
    translation_only: bool = False,
    max_angle: Optional[float] = None,
    interpolation: str = "linear",
    tolerance: float = 0.01,
    body_chord: float = 0.0,
    budget: float = 60.0,
    seed: int = 1,
    run: Optional[RunContext] = None,
    watch: Optional[PathWatch] = None,
    rules: Sequence[str] = (),
) -> Tuple[Dict[str, Any], Any]: ...
def improve_path(
    vertices: npt.ArrayLike,
    triangles: npt.ArrayLike,
    motion: Any,
    neighbours: Any,
    interpolation: str = "linear",
    locked: Any = (),
    more_clearance: bool = False,
    clearance: float = 0.0,
    release: float = 0.0,
    translation_only: bool = False,
    max_angle: Optional[float] = None,
    tolerance: float = 0.01,
    body_chord: float = 0.0,
    budget: float = 60.0,
    seed: int = 1,
    run: Optional[RunContext] = None,
    rules: Sequence[str] = (),
) -> Tuple[Dict[str, Any], Any]: ...

class PathWatch:
    def __init__(self) -> None: ...
    def farthest(self) -> Optional[npt.NDArray[np.float64]]: ...

class SequenceWatch:
    def __init__(self) -> None: ...
    def seen(self) -> Tuple[Optional[int], int, Optional[npt.NDArray[np.float64]]]: ...

def find_sequence(
    parts: Any,
    still: Any = (),
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
    rules: Any = (),
    run: Optional[RunContext] = None,
    watch: Optional[SequenceWatch] = None,
) -> Tuple[Dict[str, Any], Any]: ...

class LiveClearance:
    def __init__(
        self,
        vertices: npt.ArrayLike,
        triangles: npt.ArrayLike,
        neighbours: Any,
        run: Optional[RunContext] = None,
    ) -> None: ...
    def at(self, pose: npt.ArrayLike) -> Tuple[int, float, bool, Any, Any]: ...
    def reached(
        self, from_pose: npt.ArrayLike, to_pose: npt.ArrayLike, apart: float
    ) -> npt.NDArray[np.float64]: ...

def distance_to_mesh(
    points: npt.ArrayLike,
    vertices: npt.ArrayLike,
    triangles: npt.ArrayLike,
    run: Optional[RunContext] = None,
) -> npt.NDArray[np.float64]: ...
def check_page_template(template: str) -> None: ...
def report_page(
    report: str,
    title: str = "",
    language: str = "en",
    version: str = "",
    date: str = "",
    template: str = "",
    inputs: Any = (),
    parts: Any = (),
    pictures: Any = (),
    view_triangles: int = 50000,
    run: Optional[RunContext] = None,
) -> str: ...
def page_template(name: str = "page") -> str: ...
def page_has_view() -> bool: ...
