# SPDX-License-Identifier: LGPL-2.1-or-later
"""The properties of a shared volume for Feature.properties(): type, name, group, help, default,
mode."""
from ..texts import mark
from . import missing
from .base import HIDDEN, READ_ONLY
from .envelope_properties import PLACED

INPUT = [
    (
        "App::PropertyLinkSubListGlobal",
        "MovingParts",
        "Input",
        mark(
            "Properties",
            "First of the two sides that are compared: parts, envelopes or other reserved spaces",
        ),
        None,
        0,
    ),
    (
        "App::PropertyLinkSubListGlobal",
        "Neighbours",
        "Input",
        mark(
            "Properties",
            "Second of the two sides that are compared: parts, envelopes or other reserved spaces",
        ),
        None,
        0,
    ),
    (
        "App::PropertyLinkGlobal",
        "Motion",
        "Input",
        mark("Properties", "Motion of the first side. None: the first side stands still"),
        None,
        0,
    ),
    (
        "App::PropertyLinkGlobal",
        "NeighbourMotion",
        "Input",
        mark("Properties", "Motion of the second side. None: the second side stands still"),
        None,
        0,
    ),
    (
        "App::PropertyFloat",
        "Time",
        "Input",
        mark("Properties", "Time at which both sides are compared (s)"),
        0.0,
        0,
    ),
    (
        "App::PropertyLength",
        "MeshDeflection",
        "Input",
        mark("Properties", "How far the triangle mesh of a solid may deviate from the solid"),
        0.05,
        0,
    ),
]
RESULT = [
    (kind, name, "Result", text, None, READ_ONLY)
    for kind, name, text in (
        ("App::PropertyString", "Status", mark("Properties", "Whether the result is current")),
        ("App::PropertyString", "Message", mark("Properties", "Remarks about the result")),
        ("App::PropertyVolume", "Volume", mark("Properties", "Volume that both sides share")),
        (
            "App::PropertyLength",
            "Distance",
            mark("Properties", "Smallest distance between the sides, if they share no volume"),
        ),
        (
            "App::PropertyLength",
            "Depth",
            mark("Properties", "How deep one of the two sides penetrates the other"),
        ),
    )
] + [
    ("App::PropertyString", name, "Result", text, None, HIDDEN)
    for name, text in (
        ("InputHash", mark("Properties", "Inputs of the stored result")),
        ("TriedHash", mark("Properties", "Inputs of the last run that failed")),
        (missing.PROPERTY, mark("Properties", "Inputs that were deleted (JSON)")),
    )
]
PROPERTIES = INPUT + RESULT + [PLACED]
