# SPDX-License-Identifier: LGPL-2.1-or-later
"""The properties of an envelope for Feature.properties(). Inputs: type, name, group, help, default,
mode. Results: type, name, help."""
from ..texts import QT_TRANSLATE_NOOP
from .base import HIDDEN

#: Name in the property -> name in the core.
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
        QT_TRANSLATE_NOOP(
            "App::Property",
            "Solids and meshes that move together. A group or link stands for all the parts in it",
        ),
        None,
        0,
    ),
    (
        "App::PropertyLinkGlobal",
        "Motion",
        "Input",
        QT_TRANSLATE_NOOP("App::Property", "Motion of the parts"),
        None,
        0,
    ),
    (
        "App::PropertyLinkListGlobal",
        "Motions",
        "Input",
        QT_TRANSLATE_NOOP(
            "App::Property",
            "One motion for each entry of MovingParts, if the parts move "
            "independently. Empty: all parts follow Motion",
        ),
        None,
        0,
    ),
    (
        "App::PropertyLinkSubGlobal",
        "Reference",
        "Input",
        QT_TRANSLATE_NOOP(
            "App::Property",
            "Reference part: the envelope is computed as seen from this part, which itself "
            "moves. Empty: in the coordinates of the document",
        ),
        None,
        0,
    ),
    (
        "App::PropertyLinkGlobal",
        "ReferenceMotion",
        "Input",
        QT_TRANSLATE_NOOP("App::Property", "Motion of the reference part"),
        None,
        0,
    ),
]
ACCURACY = [
    (
        "App::PropertyLength",
        "Accuracy",
        "Accuracy",
        QT_TRANSLATE_NOOP(
            "App::Property",
            "Largest distance allowed between the computed surface and the true one. It sets the "
            "cell size and the tolerance. 0: the cell size comes from CellSize or Resolution, "
            "the tolerance from Tolerance",
        ),
        None,
        0,
    ),
    (
        "App::PropertyInteger",
        "Resolution",
        "Accuracy",
        QT_TRANSLATE_NOOP(
            "App::Property",
            "Number of cells along the longest side of the box around the swept volume. "
            "Used if CellSize is 0",
        ),
        128,
        0,
    ),
    (
        "App::PropertyLength",
        "CellSize",
        "Accuracy",
        QT_TRANSLATE_NOOP(
            "App::Property",
            "Edge length of a cell of the grid. 0: computed from Resolution",
        ),
        None,
        0,
    ),
    (
        "App::PropertyFloat",
        "MeshDeflection",
        "Accuracy",
        QT_TRANSLATE_NOOP(
            "App::Property",
            "How far the triangle mesh of a solid may deviate from the solid, as a fraction of "
            "the cell size",
        ),
        0.1,
        0,
    ),
    (
        "App::PropertyLength",
        "Tolerance",
        "Accuracy",
        QT_TRANSLATE_NOOP(
            "App::Property", "How far simplification may move the surface. 0: no simplification"
        ),
        None,
        0,
    ),
    (
        "App::PropertyLength",
        "Offset",
        "Accuracy",
        QT_TRANSLATE_NOOP("App::Property", "Distance by which the envelope is grown on all sides"),
        None,
        0,
    ),
    (
        "App::PropertyBool",
        "Conservative",
        "Accuracy",
        QT_TRANSLATE_NOOP("App::Property", "True: the envelope provably contains the swept volume"),
        None,
        0,
    ),
    (
        "App::PropertyBool",
        "KeepCavities",
        "Accuracy",
        QT_TRANSLATE_NOOP(
            "App::Property",
            "True: enclosed cavities are kept as inner shells. False: they are filled",
        ),
        None,
        0,
    ),
    (
        "App::PropertyLength",
        "PositionFilter",
        "Method",
        QT_TRANSLATE_NOOP(
            "App::Property",
            "Poses are skipped as long as no point of the part has moved farther than this "
            "length since the last pose used. 0: every pose is used",
        ),
        None,
        0,
    ),
    (
        "App::PropertyEnumeration",
        "Components",
        "Method",
        QT_TRANSLATE_NOOP(
            "App::Property",
            "How separate pieces of surface inside one cell are recognised. For research: only "
            "Consistent guarantees that the envelope is closed",
        ),
        list(COMPONENTS),
        0,
    ),
    (
        "App::PropertyEnumeration",
        "Backend",
        "Method",
        QT_TRANSLATE_NOOP(
            "App::Property",
            "Processor that computes the envelope: CPU, GPU (graphics processor), or Auto, which "
            "chooses one of them",
        ),
        list(BACKENDS),
        0,
    ),
    (
        "App::PropertyEnumeration",
        "MadeBy",
        "Result",
        QT_TRANSLATE_NOOP(
            "App::Property",
            "Whether to record which face or edge made each triangle. Off: no "
            "record. Session: kept until the document is closed. Document: stored in "
            "the document, which makes the file larger",
        ),
        MADE_BY,
        0,
    ),
]
#: Placement of the result when it was stored. It shows whether the result was moved afterwards.
PLACED = (
    "App::PropertyPlacement",
    "Placed",
    "Result",
    QT_TRANSLATE_NOOP(
        "App::Property",
        "Placement of the result at the time it was stored. If the current placement differs, "
        "the result was moved",
    ),
    None,
    HIDDEN,
)
RESULT = [
    ("App::PropertyString", "Status", QT_TRANSLATE_NOOP("App::Property", "State of the result")),
    (
        "App::PropertyString",
        "Message",
        QT_TRANSLATE_NOOP("App::Property", "Why the last run failed, and its findings"),
    ),
    ("App::PropertyVolume", "Volume", QT_TRANSLATE_NOOP("App::Property", "Volume of the envelope")),
    (
        "App::PropertyArea",
        "Area",
        QT_TRANSLATE_NOOP("App::Property", "Surface area of the envelope"),
    ),
    (
        "App::PropertyInteger",
        "Triangles",
        QT_TRANSLATE_NOOP("App::Property", "Number of triangles of the envelope"),
    ),
    (
        "App::PropertyInteger",
        "Shells",
        QT_TRANSLATE_NOOP("App::Property", "Number of separate closed surfaces of the envelope"),
    ),
    (
        "App::PropertyInteger",
        "SelfIntersections",
        QT_TRANSLATE_NOOP(
            "App::Property", "Number of pairs of triangles that intersect. -1: not counted"
        ),
    ),
    (
        "App::PropertyLength",
        "UsedCellSize",
        QT_TRANSLATE_NOOP("App::Property", "Edge length of the grid cells used for this result"),
    ),
    (
        "App::PropertyLength",
        "AccuracyBound",
        QT_TRANSLATE_NOOP(
            "App::Property",
            "No point of the surface lies farther than this length from the true surface. 0: not "
            "known",
        ),
    ),
    (
        "App::PropertyFloat",
        "Seconds",
        QT_TRANSLATE_NOOP("App::Property", "Duration of the run (s)"),
    ),
]
