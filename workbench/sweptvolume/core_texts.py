# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the core says, in the user's language: by the code of a finding. The numbers stand in the core's
own sentence, which follows in brackets; where there is no translation it stands alone."""
from .texts import mark, translate

#: Code -> what happened and what to do.
_TEXTS = {
    # failures
    "EmptyMesh": mark("Core", "The part has no surface: choose a solid or a mesh with triangles."),
    "NonFiniteVertex": mark(
        "Core", "The mesh has points that are no numbers: repair or export it."
    ),
    "NoVolume": mark("Core", "The part encloses no volume: choose a solid or a closed mesh."),
    "OpenMesh": mark(
        "Core",
        "The part is open, and its motion does not close it: close its holes, or check where the "
        "outside leaks in.",
    ),
    "PrecisionTooCoarse": mark(
        "Core", "The part is too far from the origin for its size: move it nearer."
    ),
    "OutOfRange": mark("Core", "The part or the motion is too large: check the unit of length."),
    "CellTooLarge": mark("Core", "The cell is too large for the part: take a smaller one."),
    "BadOption": mark("Core", "A setting is outside what is allowed."),
    "EmptyTrajectory": mark("Core", "The motion has no poses: give at least one."),
    "NotRigid": mark(
        "Core", "A pose scales, shears or mirrors the part: give turns and shifts only."
    ),
    "BadPose": mark("Core", "A pose or its time cannot be used: times may not go back."),
    "AmbiguousTurn": mark(
        "Core", "Between two poses the part makes half a turn: put a pose between them."
    ),
    "PartsIntersect": mark(
        "Core", "Two parts lie in each other where they belong: move one, or ignore the pair."
    ),
    "PartsTooNear": mark(
        "Core",
        "Two parts are nearer where they belong than is asked for: ask for less, or allow contact there.",
    ),
    "BadFile": mark("Core", "The file cannot be read as it stands."),
    "BadFormat": mark("Core", "The ending of the file's name is not one that is known here."),
    "FileTooLarge": mark("Core", "The file is larger than may be read."),
    "ResourceLimit": mark(
        "Core", "This would take more than it may: take a larger cell, or raise the memory limit."
    ),
    "TooManyTriangles": mark("Core", "There are too many triangles: take a larger cell."),
    "TooManyFaces": mark(
        "Core", "The solid would have too many faces: give a tolerance, or keep the mesh."
    ),
    "OutOfMemory": mark("Core", "The memory was not enough: take a larger cell."),
    "Cancelled": mark("Core", "Cancelled."),
    "NoNeighbours": mark("Core", "There is no neighbour to be checked against."),
    "BadRule": mark("Core", "A rule for a neighbour cannot be used: correct or remove it."),
    "BadTemplate": mark(
        "Core",
        "The template for reports has a placeholder that is not known: correct the template.",
    ),
    "GoalBlocked": mark(
        "Core", "The part does not fit where it belongs: a neighbour is in the way."
    ),
    "StartBlocked": mark("Core", "The part does not fit where it comes from."),
    "ViaBlocked": mark("Core", "The part does not fit at a place that it has to pass."),
    "SamePose": mark("Core", "The part is where it belongs already."),
    "NoStart": mark("Core", "It is not said where the part comes from."),
    "WriteFailed": mark("Core", "The file could not be written: check folder and free space."),
    "KernelFailure": mark(
        "Core", "The kernel for solids failed: give a tolerance, or a mesh file."
    ),
    "DeviceUnavailable": mark(
        "Core", "There is no graphics device that can be used: choose the backend CPU."
    ),
    "DeviceLost": mark("Core", "The graphics device failed: choose the backend CPU."),
    "OverlappingShells": mark(
        "Core", "A part lies in itself: give each of its solids by itself, or join them first."
    ),
    # findings
    "NoSharedVolume": mark("Core", "It cannot be told what two of the parts share."),
    "OpenEdges": mark("Core", "The part is open; its motion closes it."),
    "DegenerateTriangles": mark("Core", "Triangles without an area were left out."),
    "DuplicateTriangles": mark("Core", "Triangles that repeat others were left out."),
    "OppositeTriangles": mark("Core", "Triangles back to back were left out."),
    "ContactNotProven": mark("Core", "How deep an allowed contact goes is not proven."),
    "EqualTimes": mark("Core", "Poses have the time of the one before; their order was kept."),
    "Flipped": mark("Core", "The part was inside out and was turned over."),
    "MixedOrientation": mark("Core", "Triangles of the part face different ways."),
    "NotOrientable": mark("Core", "The surface of the part has one side only."),
    "NonManifoldEdges": mark("Core", "More than two triangles meet at edges of the part."),
    "InsideOut": mark("Core", "The part crosses itself and is inside out in places."),
    "Cavities": mark("Core", "The part has hollow spaces inside."),
    "NestedShells": mark("Core", "The part has bodies inside others; they count as material."),
    "RepeatedPoses": mark("Core", "Poses that repeat the one before were left out."),
    "RotationMended": mark("Core", "Poses that were not quite rigid were mended."),
    "CavitiesFilled": mark("Core", "Hollow spaces inside the envelope were filled."),
    "SelfIntersections": mark("Core", "Triangles of the envelope cross each other."),
    "NotSimplified": mark("Core", "The envelope was not simplified."),
    "SimplifiedLess": mark("Core", "The envelope was simplified less than the tolerance allows."),
    "NotChecked": mark("Core", "It was not checked whether triangles cross each other."),
}


def said(code, text):
    """A message of the core: code of the finding, its own sentence."""
    known = _TEXTS.get(code, "")
    ours = translate("Core", known) if known else ""
    return text if ours == known else "{} ({})".format(ours, text) if text else ours
