# SPDX-License-Identifier: LGPL-2.1-or-later
"""Texts of the core's findings in the user's language, by the code of the finding. The core's own
sentence, with the numbers, follows in brackets. Without a translation it stands alone."""
from .texts import mark, translate

#: Maps a code to a text that says what happened and what to do.
_TEXTS = {
    # failures
    "EmptyMesh": mark("Core", "The part has no surface: choose a solid or a mesh with triangles."),
    "NonFiniteVertex": mark(
        "Core",
        "Some vertices of the mesh have coordinates that are not finite numbers: "
        "repair the mesh, or export it again.",
    ),
    "NoVolume": mark("Core", "The part encloses no volume: choose a solid or a closed mesh."),
    "OpenMesh": mark(
        "Core",
        "A mesh has gaps (open edges), so it has no clear inside and outside: close the gaps.",
    ),
    "PrecisionTooCoarse": mark(
        "Core",
        "The part is so far from the origin that its coordinates are not exact "
        "enough: move the part and its motion closer to the origin.",
    ),
    "OutOfRange": mark(
        "Core",
        "The part or the motion reaches more than 1e9 mm from the origin: check the unit "
        "of length.",
    ),
    "CellTooLarge": mark(
        "Core",
        "The cell is too large for the part: the part is smaller, or thinner everywhere, than "
        "one cell. Choose a smaller cell or a higher resolution.",
    ),
    "BadOption": mark(
        "Core",
        "A setting is not allowed: the text in brackets names the setting and says "
        "what is allowed.",
    ),
    "EmptyTrajectory": mark("Core", "The motion has no poses: give at least one."),
    "NotRigid": mark(
        "Core",
        "A pose scales, shears or mirrors the part: use poses that only rotate and " "translate.",
    ),
    "BadPose": mark(
        "Core",
        "A pose cannot be used: all its numbers must be finite, and the times must "
        "not decrease.",
    ),
    "AmbiguousTurn": mark(
        "Core",
        "The part turns by 180 degrees, or nearly so, between two poses, so the direction of "
        "the turn is ambiguous: add a pose between them.",
    ),
    "PartsIntersect": mark(
        "Core",
        "Two parts overlap in their installed positions: move one of them, or set the rule of "
        "the pair to Ignored.",
    ),
    "PartsTooNear": mark(
        "Core",
        "Two parts are below the required distance in their installed positions: "
        "reduce the required distance, or set a release distance.",
    ),
    "BadFile": mark("Core", "The file cannot be read: the text in brackets says where and why."),
    "BadFormat": mark(
        "Core",
        "The file extension is not supported: use one of those listed in brackets.",
    ),
    "FileTooLarge": mark(
        "Core", "The file is larger than the limit for input files: split it, or reduce it."
    ),
    "ResourceLimit": mark(
        "Core",
        "The computation exceeds a limit, usually the memory limit: choose a larger cell, or "
        "raise the limit in the preferences.",
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
        "Core", "The computer ran out of memory: choose a larger cell or a lower resolution."
    ),
    "Cancelled": mark("Core", "Cancelled."),
    "NoNeighbours": mark(
        "Core", "There is no neighbour to check: choose at least one part as a neighbour."
    ),
    "BadRule": mark("Core", "A rule cannot be applied: correct the rule, or remove it."),
    "BadTemplate": mark(
        "Core",
        "The report template has an error: the text in brackets names the line. "
        "Correct the template.",
    ),
    "GoalBlocked": mark(
        "Core",
        "At the goal, the part is too close to a neighbour, or overlaps it: move the "
        "neighbour, reduce the required distance, or set a release distance.",
    ),
    "StartBlocked": mark(
        "Core",
        "At the start, the part is too close to a neighbour, or overlaps it: move "
        "the neighbour, reduce the required distance, or set a release distance.",
    ),
    "ViaBlocked": mark(
        "Core",
        "At a locked key, the part is too close to a neighbour, or overlaps it: move "
        "the neighbour, reduce the required distance, or unlock the key.",
    ),
    "SamePose": mark("Core", "Start and goal are the same: choose another start."),
    "NoStart": mark("Core", "No start is given: enter a placement, a distance or a direction."),
    "WriteFailed": mark(
        "Core",
        "The file could not be written: check the folder, its permissions and the free disk "
        "space.",
    ),
    "KernelFailure": mark(
        "Core",
        "OpenCASCADE could not build the solid: set a larger Tolerance for the "
        "solid, or export a mesh file (STL, PLY).",
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
        "The shared volume of two parts could not be computed: repair their meshes, "
        "or move one part slightly.",
    ),
    "OpenEdges": mark(
        "Core", "The part has gaps (open edges). Its envelope is closed all the same."
    ),
    "OpenSheets": mark(
        "Core",
        "The part has gaps that its motion does not close. There, its walls became thin sheets "
        "of the envelope: close the gaps to get the space between the walls.",
    ),
    "DegenerateTriangles": mark("Core", "Triangles with zero area were removed."),
    "DuplicateTriangles": mark("Core", "Duplicate triangles were removed."),
    "OppositeTriangles": mark(
        "Core", "Pairs of triangles with the same corners but opposite directions were removed."
    ),
    "ContactNotProven": mark(
        "Core",
        "The depth of an allowed contact was measured, but the parts may overlap more deeply at "
        "another point.",
    ),
    "EqualTimes": mark("Core", "Some poses have the same time."),
    "Flipped": mark(
        "Core",
        "The triangles of the part, or of one of its bodies, faced inwards. They were " "reversed.",
    ),
    "MixedOrientation": mark(
        "Core",
        "Some adjacent triangles face opposite ways: check the mesh if the result " "looks wrong.",
    ),
    "NotOrientable": mark(
        "Core", "The surface of the part has only one side, like a Möbius strip: check the mesh."
    ),
    "NonManifoldEdges": mark(
        "Core", "More than two triangles meet at some edges of the part: check the mesh."
    ),
    "InsideOut": mark(
        "Core", "The part intersects itself, and some of its regions face inwards: repair the mesh."
    ),
    "Cavities": mark(
        "Core",
        "The part has cavities. They change the envelope only if Keep cavities is set.",
    ),
    "NestedShells": mark(
        "Core", "Some bodies of the part lie inside other bodies. They count as material."
    ),
    "RepeatedPoses": mark(
        "Core", "Poses with the same placement as the pose before were left out."
    ),
    "RotationMended": mark(
        "Core", "The rotations of some poses had small rounding errors, which were corrected."
    ),
    "CavitiesFilled": mark(
        "Core",
        "Cavities inside the envelope were filled. To keep them, set Keep cavities, and close the "
        "gaps of the part if it is open.",
    ),
    "SelfIntersections": mark(
        "Core",
        "Some triangles of the envelope intersect. If you need a solid, change the "
        "cell size slightly.",
    ),
    "NotSimplified": mark(
        "Core", "The envelope was not simplified: the text in brackets says why."
    ),
    "SimplifiedLess": mark(
        "Core",
        "The envelope was simplified less than the tolerance allows, so it has more "
        "triangles than necessary.",
    ),
    "NotChecked": mark(
        "Core",
        "This surface is a preview. It was not checked for errors such as intersecting "
        "triangles.",
    ),
}


def said(code, text):
    """Returns the message for the code of a finding and the core's own sentence."""
    known = _TEXTS.get(code, "")
    ours = translate("Core", known) if known else ""
    return text if ours == known else "{} ({})".format(ours, text) if text else ours
