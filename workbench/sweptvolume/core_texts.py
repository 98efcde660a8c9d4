# SPDX-License-Identifier: LGPL-2.1-or-later
"""Texts of the core's findings in the user's language, by the code of the finding. The core's own
English sentence, with the numbers, follows in parentheses. In English, and if there is no
translation, the message is that sentence alone: it also says what to do."""
from .texts import QT_TRANSLATE_NOOP, translate

#: Maps a code to a text that says what happened and what to do.
_TEXTS = {
    # failures
    "EmptyMesh": QT_TRANSLATE_NOOP(
        "SweptVolume", "The part has no surface: choose a solid or a mesh with triangles."
    ),
    "NonFiniteVertex": QT_TRANSLATE_NOOP(
        "SweptVolume",
        "Some vertices of the mesh have coordinates that are not finite numbers: "
        "repair the mesh, or export it again.",
    ),
    "NoVolume": QT_TRANSLATE_NOOP(
        "SweptVolume", "The part encloses no volume: choose a solid or a closed mesh."
    ),
    "OpenMesh": QT_TRANSLATE_NOOP(
        "SweptVolume",
        "A mesh has gaps (open edges), so it has no definite inside and outside: close the gaps.",
    ),
    "PrecisionTooCoarse": QT_TRANSLATE_NOOP(
        "SweptVolume",
        "The part is so far from the origin that its coordinates are not exact "
        "enough: move the part and its motion closer to the origin.",
    ),
    "OutOfRange": QT_TRANSLATE_NOOP(
        "SweptVolume",
        "The part or the motion reaches more than 1e9 mm from the origin: check the unit "
        "of length.",
    ),
    "CellTooLarge": QT_TRANSLATE_NOOP(
        "SweptVolume",
        "The cell is too large for the part: the part is smaller than one cell, or everywhere "
        "thinner than one cell. Choose a smaller value of Accuracy, a smaller cell or a higher "
        "resolution.",
    ),
    "BadOption": QT_TRANSLATE_NOOP(
        "SweptVolume",
        "A setting is not allowed: correct it. The details in parentheses name the setting and "
        "say what is allowed.",
    ),
    "EmptyTrajectory": QT_TRANSLATE_NOOP(
        "SweptVolume", "The motion has no poses: add at least one."
    ),
    "NotRigid": QT_TRANSLATE_NOOP(
        "SweptVolume",
        "A pose scales, shears or mirrors the part: use poses that only rotate and " "translate.",
    ),
    "BadPose": QT_TRANSLATE_NOOP(
        "SweptVolume",
        "A pose cannot be used: all its numbers must be finite, and the times must "
        "not decrease.",
    ),
    "AmbiguousTurn": QT_TRANSLATE_NOOP(
        "SweptVolume",
        "The part turns by 180 degrees, or nearly so, between two poses, so the direction of the "
        "turn is ambiguous: add a pose between them. The details in parentheses name the poses.",
    ),
    "PartsIntersect": QT_TRANSLATE_NOOP(
        "SweptVolume",
        "Two parts overlap in their installed positions, by more than the release distance "
        "allows: move one of them, or increase the release distance. The details in parentheses "
        "name the parts.",
    ),
    "PartsTooNear": QT_TRANSLATE_NOOP(
        "SweptVolume",
        "Two parts are closer than the required distance in their installed positions: reduce "
        "the required distance, or set a release distance, which allows contact near the "
        "installed positions. The details in parentheses name the parts.",
    ),
    "BadFile": QT_TRANSLATE_NOOP(
        "SweptVolume", "The file cannot be read: the details in parentheses say where and why."
    ),
    "BadFormat": QT_TRANSLATE_NOOP(
        "SweptVolume",
        "The file extension is not supported: choose another one. The details in parentheses "
        "list the supported ones.",
    ),
    "FileTooLarge": QT_TRANSLATE_NOOP(
        "SweptVolume", "The file is larger than the limit for input files: split it, or reduce it."
    ),
    "ResourceLimit": QT_TRANSLATE_NOOP(
        "SweptVolume",
        "The computation exceeds a limit, usually the memory limit: choose a larger cell, or "
        "raise the limit in the preferences.",
    ),
    "TooManyTriangles": QT_TRANSLATE_NOOP(
        "SweptVolume",
        "The result would have too many triangles: choose a larger cell or a lower resolution.",
    ),
    "TooManyFaces": QT_TRANSLATE_NOOP(
        "SweptVolume",
        "The solid would have too many faces: set a larger tolerance, or export a mesh file.",
    ),
    "OutOfMemory": QT_TRANSLATE_NOOP(
        "SweptVolume", "The computer ran out of memory: choose a larger cell or a lower resolution."
    ),
    "Cancelled": QT_TRANSLATE_NOOP("SweptVolume", "Cancelled."),
    "NoNeighbours": QT_TRANSLATE_NOOP(
        "SweptVolume", "There is no neighbour to check: choose at least one part as a neighbour."
    ),
    "BadRule": QT_TRANSLATE_NOOP(
        "SweptVolume",
        "A rule cannot be applied: correct the rule, or remove it. The details in "
        "parentheses name the rule.",
    ),
    "BadTemplate": QT_TRANSLATE_NOOP(
        "SweptVolume",
        "The report template has an error: correct the template. The details in parentheses name "
        "the line.",
    ),
    "GoalBlocked": QT_TRANSLATE_NOOP(
        "SweptVolume",
        "At the goal, the part is too close to a neighbour, or overlaps it: move the neighbour, "
        "reduce the required distance, or set a release distance, which allows contact near the "
        "goal. The details in parentheses name the neighbour.",
    ),
    "StartBlocked": QT_TRANSLATE_NOOP(
        "SweptVolume",
        "At the start, the part is too close to a neighbour, or overlaps it: move the neighbour, "
        "reduce the required distance, or set a release distance, which allows contact near the "
        "start. The details in parentheses name the neighbour.",
    ),
    "ViaBlocked": QT_TRANSLATE_NOOP(
        "SweptVolume",
        "At a pose on the way, the part is too close to a neighbour, or overlaps it: reduce the "
        "required distance, or move or remove this pose. The details in parentheses name the pose "
        "and the neighbour.",
    ),
    "SamePose": QT_TRANSLATE_NOOP(
        "SweptVolume", "Start and goal are the same: choose another start or goal."
    ),
    "NoStart": QT_TRANSLATE_NOOP(
        "SweptVolume", "No start is given: enter a placement, a distance or a direction."
    ),
    "WriteFailed": QT_TRANSLATE_NOOP(
        "SweptVolume",
        "The file could not be written: check the folder, its permissions and the free disk "
        "space.",
    ),
    "KernelFailure": QT_TRANSLATE_NOOP(
        "SweptVolume",
        "OpenCASCADE could not build the solid: set a larger Tolerance for the "
        "solid, or export a mesh file (STL, PLY).",
    ),
    "DeviceUnavailable": QT_TRANSLATE_NOOP(
        "SweptVolume", "No usable GPU (graphics processor) was found: set Backend to CPU."
    ),
    "DeviceLost": QT_TRANSLATE_NOOP(
        "SweptVolume",
        "The GPU (graphics processor) failed during the computation: set Backend to CPU.",
    ),
    "OverlappingShells": QT_TRANSLATE_NOOP(
        "SweptVolume",
        "The solids of a part overlap one another: select each solid on its own, or fuse them "
        "first. The details in parentheses name the part.",
    ),
    # findings
    "NoSharedVolume": QT_TRANSLATE_NOOP(
        "SweptVolume",
        "The shared volume of two parts could not be computed: repair their meshes, or move one "
        "part slightly. The details in parentheses name the parts and the cause.",
    ),
    "OpenEdges": QT_TRANSLATE_NOOP(
        "SweptVolume", "The part has gaps (open edges). Its envelope is closed all the same."
    ),
    "OpenSheets": QT_TRANSLATE_NOOP(
        "SweptVolume",
        "The part has gaps (open edges) that its motion does not close. There, the part does not "
        "count as solid, and the envelope is only a thin sheet along each wall of the part: "
        "close the gaps if the part is solid there.",
    ),
    "DegenerateTriangles": QT_TRANSLATE_NOOP(
        "SweptVolume", "Triangles with zero area were removed."
    ),
    "DuplicateTriangles": QT_TRANSLATE_NOOP("SweptVolume", "Duplicate triangles were removed."),
    "OppositeTriangles": QT_TRANSLATE_NOOP(
        "SweptVolume",
        "Pairs of triangles with the same corners but opposite directions were removed.",
    ),
    "ContactNotProven": QT_TRANSLATE_NOOP(
        "SweptVolume",
        "The depth of an allowed contact was measured, but the parts may overlap more deeply at "
        "another point.",
    ),
    "EqualTimes": QT_TRANSLATE_NOOP("SweptVolume", "Some poses have the same time."),
    "Flipped": QT_TRANSLATE_NOOP(
        "SweptVolume",
        "The triangles of the part, or of one of its shells (connected pieces of surface), faced "
        "inwards. They were reversed.",
    ),
    "MixedOrientation": QT_TRANSLATE_NOOP(
        "SweptVolume",
        "Some adjacent triangles face opposite ways: check the mesh if the result " "looks wrong.",
    ),
    "NotOrientable": QT_TRANSLATE_NOOP(
        "SweptVolume",
        "The surface of the part has only one side, like a Möbius strip: repair the mesh.",
    ),
    "NonManifoldEdges": QT_TRANSLATE_NOOP(
        "SweptVolume",
        "More than two triangles meet at some edges of the part: repair the mesh if the "
        "result looks wrong.",
    ),
    "InsideOut": QT_TRANSLATE_NOOP(
        "SweptVolume",
        "The part intersects itself, and some of its regions face inwards: repair the mesh.",
    ),
    "Cavities": QT_TRANSLATE_NOOP(
        "SweptVolume",
        "The part has cavities. They change the envelope only if Keep cavities is ticked.",
    ),
    "NestedShells": QT_TRANSLATE_NOOP(
        "SweptVolume",
        "Some shells (connected pieces of surface) of the part lie inside other shells. They count "
        "as material.",
    ),
    "RepeatedPoses": QT_TRANSLATE_NOOP(
        "SweptVolume", "Poses with the same placement as the pose before were left out."
    ),
    "RotationMended": QT_TRANSLATE_NOOP(
        "SweptVolume",
        "The rotations of some poses had small rounding errors, which were corrected.",
    ),
    "CavitiesFilled": QT_TRANSLATE_NOOP(
        "SweptVolume",
        "Cavities inside the envelope were filled, because the part has gaps: close them to keep "
        "the cavities.",
    ),
    "SelfIntersections": QT_TRANSLATE_NOOP(
        "SweptVolume",
        "Some triangles of the envelope intersect. If you need a solid, change the "
        "cell size slightly.",
    ),
    "NotSimplified": QT_TRANSLATE_NOOP(
        "SweptVolume", "The envelope was not simplified: the details in parentheses say why."
    ),
    "SimplifiedLess": QT_TRANSLATE_NOOP(
        "SweptVolume",
        "The envelope is correct, but its simplification stopped early: it has more triangles "
        "than the tolerance requires.",
    ),
    "NotChecked": QT_TRANSLATE_NOOP(
        "SweptVolume",
        "This surface is a preview. It was not checked for errors such as intersecting "
        "triangles.",
    ),
}


#: Codes that share the text of another code.
_SAME = {
    "DeviceGarbage": "DeviceLost",
    "ShaderFailed": "DeviceUnavailable",
    "BadSuffix": "BadFormat",
    "ReadOnly": "WriteFailed",
    "MissingFolder": "WriteFailed",
    "BadTarget": "WriteFailed",
    "InvalidFaces": "KernelFailure",
}


def english(code):
    """Returns the English text for a code; empty if it has none."""
    return _TEXTS.get(_SAME.get(code, code), "")


def said(code, text):
    """Returns the message for the code of a finding and the core's own sentence."""
    known = english(code)
    ours = translate("SweptVolume", known) if known else ""
    if not text:
        return ours
    return text if ours == known else "{} ({})".format(ours, text)
