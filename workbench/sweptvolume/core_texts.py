# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the core says, in the user's language: by the code of a finding. The numbers stand in the core's
own sentence, which follows in brackets; where there is no translation it stands alone."""
from .texts import mark, translate

#: Code -> what happened and what to do.
_TEXTS = {
    # failures
    "EmptyMesh": mark("Core", "The part has no surface: choose a solid or a mesh with triangles."),
    "NonFiniteVertex": mark(
        "Core",
        "The mesh has vertices whose coordinates are not numbers: repair the mesh or export it "
        "again.",
    ),
    "NoVolume": mark("Core", "The part encloses no volume: choose a solid or a closed mesh."),
    "OpenMesh": mark(
        "Core",
        "The part has holes that its motion does not close, so inside and outside cannot be "
        "told apart: close the holes.",
    ),
    "PrecisionTooCoarse": mark(
        "Core",
        "The part is too far from the origin for its size to be computed exactly: move it "
        "closer to the origin.",
    ),
    "OutOfRange": mark("Core", "The part or the motion is too large: check the unit of length."),
    "CellTooLarge": mark(
        "Core", "The cell is larger than the part: choose a smaller cell or a higher resolution."
    ),
    "BadOption": mark(
        "Core",
        "A setting is outside its allowed range: the text in brackets names it and the range.",
    ),
    "EmptyTrajectory": mark("Core", "The motion has no poses: give at least one."),
    "NotRigid": mark(
        "Core", "A pose scales, shears or mirrors the part: a pose may only rotate and translate."
    ),
    "BadPose": mark(
        "Core", "A pose cannot be used: its numbers must be finite, and times must not decrease."
    ),
    "AmbiguousTurn": mark(
        "Core",
        "The part turns by 180 degrees between two poses, so the direction is ambiguous: add a "
        "pose between them.",
    ),
    "PartsIntersect": mark(
        "Core",
        "Two parts overlap in their installed positions: move one of them, or set the rule of "
        "the pair to Ignore.",
    ),
    "PartsTooNear": mark(
        "Core",
        "Two parts are nearer than the required distance in their installed positions: reduce "
        "the required distance, or allow contact for the pair.",
    ),
    "BadFile": mark(
        "Core", "The file cannot be read: the text in brackets says where it is damaged."
    ),
    "BadFormat": mark("Core", "The file extension is not supported: use one of those in brackets."),
    "FileTooLarge": mark(
        "Core", "The file is larger than the limit for reading: split it or reduce it."
    ),
    "ResourceLimit": mark(
        "Core",
        "The computation needs more memory than allowed: choose a larger cell, or raise the "
        "memory limit in the preferences.",
    ),
    "TooManyTriangles": mark(
        "Core",
        "The result would have too many triangles: choose a larger cell or a lower resolution.",
    ),
    "TooManyFaces": mark(
        "Core",
        "The solid would have too many faces: set a larger tolerance, or export a mesh file.",
    ),
    "OutOfMemory": mark(
        "Core", "There was not enough memory: choose a larger cell or a lower resolution."
    ),
    "Cancelled": mark("Core", "Cancelled."),
    "NoNeighbours": mark(
        "Core", "There is no neighbour to check: choose at least one part that stands still."
    ),
    "BadRule": mark("Core", "A rule cannot be applied: correct it or remove it."),
    "BadTemplate": mark(
        "Core",
        "The report template has an unknown placeholder: correct the template.",
    ),
    "GoalBlocked": mark(
        "Core",
        "A neighbour is in the way at the goal: move it, reduce the required distance, or "
        "allow contact.",
    ),
    "StartBlocked": mark(
        "Core",
        "A neighbour is in the way at the start: move it, reduce the required distance, or "
        "allow contact.",
    ),
    "ViaBlocked": mark(
        "Core",
        "A neighbour is in the way at a locked key: move it, reduce the required distance, or "
        "unlock the key.",
    ),
    "SamePose": mark("Core", "Start and goal are the same: choose another start."),
    "NoStart": mark("Core", "No start is given: give a placement, a distance or a direction."),
    "WriteFailed": mark(
        "Core",
        "The file could not be written: check the folder, its permissions and the free disk "
        "space.",
    ),
    "KernelFailure": mark(
        "Core", "OpenCASCADE could not build the solid: set a tolerance, or export a mesh file."
    ),
    "DeviceUnavailable": mark("Core", "No usable graphics device was found: set Backend to CPU."),
    "DeviceLost": mark(
        "Core", "The graphics device failed during the computation: set Backend to CPU."
    ),
    "OverlappingShells": mark(
        "Core", "Solids of one part overlap: select each solid on its own, or fuse them first."
    ),
    # findings
    "NoSharedVolume": mark(
        "Core",
        "The volume that two parts share cannot be computed: repair the meshes, or move one "
        "part slightly.",
    ),
    "OpenEdges": mark(
        "Core", "The part has holes, but its motion closes them; the result is valid."
    ),
    "DegenerateTriangles": mark("Core", "Triangles with zero area were removed."),
    "DuplicateTriangles": mark("Core", "Duplicate triangles were removed."),
    "OppositeTriangles": mark(
        "Core", "Pairs of coincident triangles with opposite orientation were removed."
    ),
    "ContactNotProven": mark(
        "Core", "The depth of an allowed contact was measured, but is not proven to be the largest."
    ),
    "EqualTimes": mark(
        "Core", "Some poses have the same time as the pose before; their order was kept."
    ),
    "Flipped": mark("Core", "The triangles of the part faced inwards; all were reversed."),
    "MixedOrientation": mark(
        "Core", "Neighbouring triangles of the part have opposite orientations: check the mesh."
    ),
    "NotOrientable": mark(
        "Core", "The surface of the part cannot be oriented (as a Möbius strip): check the mesh."
    ),
    "NonManifoldEdges": mark(
        "Core", "Some edges of the part have more than two triangles: check the mesh."
    ),
    "InsideOut": mark(
        "Core", "The part intersects itself, and some of its regions face inwards: repair the mesh."
    ),
    "Cavities": mark(
        "Core",
        "The part has cavities; they do not change the envelope unless Keep cavities is set.",
    ),
    "NestedShells": mark(
        "Core", "Some bodies of the part lie inside others; they count as material."
    ),
    "RepeatedPoses": mark("Core", "Poses equal to the one before were removed."),
    "RotationMended": mark(
        "Core", "Poses with small rounding errors were corrected to rigid movements."
    ),
    "CavitiesFilled": mark(
        "Core", "Cavities inside the envelope were filled; set Keep cavities to keep them."
    ),
    "SelfIntersections": mark(
        "Core",
        "Some triangles of the envelope intersect: change the cell size slightly if you need a "
        "solid.",
    ),
    "NotSimplified": mark(
        "Core", "The envelope was not simplified: the text in brackets says why."
    ),
    "SimplifiedLess": mark(
        "Core",
        "The envelope was simplified less than the tolerance allows; it has more triangles "
        "than necessary.",
    ),
    "NotChecked": mark("Core", "Intersections between triangles were not checked."),
}


def said(code, text):
    """A message of the core: code of the finding, its own sentence."""
    known = _TEXTS.get(code, "")
    ours = translate("Core", known) if known else ""
    return text if ours == known else "{} ({})".format(ours, text) if text else ours
