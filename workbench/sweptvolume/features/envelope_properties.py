# SPDX-License-Identifier: LGPL-2.1-or-later
"""The properties of an envelope, as Feature.properties() takes them: type, name, group, help, default, mode;
of results type, name, help."""
from ..texts import mark
from .base import HIDDEN

#: Name in the property -> name the core knows.
COMPONENTS = {
    "Consistent": "consistent",
    "DualContouring": "dc",
    "DualMarchingCubes": "dmc",
    "Equivalence": "equivalence",
    "Greedy": "greedy",
}
MADE_BY = ["Off", "Session", "Document"]
BACKENDS = {"Auto": "auto", "CPU": "cpu", "GPU": "gpu"}
INPUT = [
    (
        "App::PropertyLinkSubListGlobal",
        "MovingParts",
        "Input",
        mark("Properties", "Solids and meshes that move together, seen through groups and links"),
        None,
        0,
    ),
    (
        "App::PropertyLinkGlobal",
        "Motion",
        "Input",
        mark("Properties", "Motion of the parts"),
        None,
        0,
    ),
    (
        "App::PropertyLinkListGlobal",
        "Motions",
        "Input",
        mark(
            "Properties",
            "One motion for each of MovingParts, where they move by themselves; empty: all by Motion",
        ),
        None,
        0,
    ),
    (
        "App::PropertyLinkSubGlobal",
        "Reference",
        "Input",
        mark("Properties", "Part that moves itself; the envelope is what it sees"),
        None,
        0,
    ),
    (
        "App::PropertyLinkGlobal",
        "ReferenceMotion",
        "Input",
        mark("Properties", "Motion of the reference part"),
        None,
        0,
    ),
]
ACCURACY = [
    (
        "App::PropertyInteger",
        "Resolution",
        "Accuracy",
        mark("Properties", "Cells along the longest side of the sweep; used while CellSize is 0"),
        128,
        0,
    ),
    (
        "App::PropertyLength",
        "CellSize",
        "Accuracy",
        mark("Properties", "Edge of a cell of the sampling grid; 0: from Resolution"),
        None,
        0,
    ),
    (
        "App::PropertyFloat",
        "MeshDeflection",
        "Accuracy",
        mark("Properties", "How far the triangles of a solid may leave it, in cells"),
        0.1,
        0,
    ),
    (
        "App::PropertyLength",
        "Tolerance",
        "Accuracy",
        mark("Properties", "Simplification: largest deviation allowed; 0: none"),
        None,
        0,
    ),
    (
        "App::PropertyLength",
        "Offset",
        "Accuracy",
        mark("Properties", "Safety distance by which the envelope is grown"),
        None,
        0,
    ),
    (
        "App::PropertyBool",
        "Conservative",
        "Accuracy",
        mark("Properties", "The envelope provably contains the swept volume"),
        None,
        0,
    ),
    (
        "App::PropertyBool",
        "KeepCavities",
        "Accuracy",
        mark("Properties", "Keep sealed hollow spaces as inner shells"),
        None,
        0,
    ),
    (
        "App::PropertyLength",
        "PositionFilter",
        "Method",
        mark(
            "Properties",
            "Poses are left out while no point of the part has moved farther than this from the last "
            "one kept; 0: none",
        ),
        None,
        0,
    ),
    (
        "App::PropertyEnumeration",
        "Components",
        "Method",
        mark("Properties", "How surface pieces inside one cell are told apart"),
        list(COMPONENTS),
        0,
    ),
    (
        "App::PropertyEnumeration",
        "Backend",
        "Method",
        mark("Properties", "Where the sampling runs"),
        list(BACKENDS),
        0,
    ),
    (
        "App::PropertyEnumeration",
        "MadeBy",
        "Result",
        mark(
            "Properties",
            "Whether it is remembered which face or edge made each triangle: Off; Session: until the "
            "document is closed; Document: stored with it, which makes it larger",
        ),
        MADE_BY,
        0,
    ),
]
#: Where the result was put, to notice when it is moved.
PLACED = (
    "App::PropertyPlacement",
    "Placed",
    "Result",
    mark("Properties", "Where the result was put in the document"),
    None,
    HIDDEN,
)
RESULT = [
    ("App::PropertyString", "Status", mark("Properties", "State of the result")),
    ("App::PropertyString", "Message", mark("Properties", "Why the last run failed; warnings")),
    ("App::PropertyVolume", "Volume", mark("Properties", "Volume of the envelope")),
    ("App::PropertyArea", "Area", mark("Properties", "Area of the envelope")),
    ("App::PropertyInteger", "Triangles", mark("Properties", "Triangles of the envelope")),
    ("App::PropertyInteger", "Shells", mark("Properties", "Closed surfaces of the envelope")),
    (
        "App::PropertyInteger",
        "SelfIntersections",
        mark("Properties", "Pairs of triangles that cross each other; -1: not counted"),
    ),
    ("App::PropertyLength", "UsedCellSize", mark("Properties", "Edge of a cell in this result")),
    ("App::PropertyFloat", "Seconds", mark("Properties", "Duration of the run (s)")),
]
