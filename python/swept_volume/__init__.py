# SPDX-License-Identifier: LGPL-2.1-or-later
"""Envelopes of moving bodies: the space that a part takes up along a motion, as a closed mesh.

    import swept_volume as sv

    part = sv.read_body("gripper.step")
    motion = sv.Motion.read("arm.csv", unit="m")
    result = sv.compute(part, motion, cell=0.5)
    result.mesh.write("envelope.ply")

Lengths are in mm, times in s. A mesh is a Mesh or a pair (vertices, triangles); a motion is a Motion,
(times, quaternions, translations), (times, matrices), matrices (K, 4, 4) or a list of matrices (4, 4).
Long calls release the interpreter's lock; watch and cancel them from another thread through a
RunContext. Failures raise Error or one of its subclasses; a missing file raises FileNotFoundError.
Findings of a run go to the logger "swept_volume" and are listed in Result.report["warnings"].
"""
from ._core import (
    HAS_SOLIDS,
    Cancelled,
    DeviceLost,
    DeviceUnavailable,
    Error,
    ExportFailed,
    InternalError,
    InvalidInput,
    OutOfMemory,
    ResourceLimit,
    __version__,
)

from ._calls import (
    PreviewSession,
    Result,
    RunContext,
    check_mesh,
    compute,
    estimate,
    estimate_solid,
    write_solid,
)
from ._clearance import clearance, distance_to_mesh, first_contacts
from ._mechanisms import mechanism
from ._overlaps import overlap
from ._pages import page_template, report_page
from ._paths import find_path, improve_path
from ._sequences import SequencePart, find_sequence
from ._sources import Sources
from ._study import run_study, study_page
from ._values import (
    Mesh,
    MeshLike,
    Motion,
    MotionLike,
    read_body,
    read_mesh,
    read_motion,
    read_parts,
    write_mesh,
)

__all__ = [
    "Cancelled",
    "DeviceLost",
    "DeviceUnavailable",
    "Error",
    "ExportFailed",
    "HAS_SOLIDS",
    "InternalError",
    "InvalidInput",
    "Mesh",
    "MeshLike",
    "Motion",
    "MotionLike",
    "OutOfMemory",
    "PreviewSession",
    "ResourceLimit",
    "Result",
    "RunContext",
    "SequencePart",
    "Sources",
    "__version__",
    "check_mesh",
    "clearance",
    "compute",
    "distance_to_mesh",
    "estimate",
    "estimate_solid",
    "find_path",
    "find_sequence",
    "first_contacts",
    "improve_path",
    "mechanism",
    "overlap",
    "page_template",
    "read_body",
    "read_mesh",
    "read_motion",
    "read_parts",
    "report_page",
    "run_study",
    "study_page",
    "write_mesh",
    "write_solid",
]
