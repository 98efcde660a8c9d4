# SPDX-License-Identifier: LGPL-2.1-or-later
"""The properties of a shared volume for Feature.properties(): type, name, group, help, default,
mode."""
from ..texts import QT_TRANSLATE_NOOP
from . import missing
from .base import HIDDEN, READ_ONLY
from .envelope_properties import PLACED

INPUT = [
    (
        "App::PropertyLinkSubListGlobal",
        "MovingParts",
        "Input",
        QT_TRANSLATE_NOOP(
            "App::Property",
            "First of the two sides that are compared: parts, envelopes or other reserved spaces",
        ),
        None,
        0,
    ),
    (
        "App::PropertyLinkSubListGlobal",
        "Neighbours",
        "Input",
        QT_TRANSLATE_NOOP(
            "App::Property",
            "Second of the two sides that are compared: parts, envelopes or other reserved spaces",
        ),
        None,
        0,
    ),
    (
        "App::PropertyLinkGlobal",
        "Motion",
        "Input",
        QT_TRANSLATE_NOOP(
            "App::Property", "Motion of the first side. Empty: the first side stands still"
        ),
        None,
        0,
    ),
    (
        "App::PropertyLinkGlobal",
        "NeighbourMotion",
        "Input",
        QT_TRANSLATE_NOOP(
            "App::Property", "Motion of the second side. Empty: the second side stands still"
        ),
        None,
        0,
    ),
    (
        "App::PropertyFloat",
        "Time",
        "Input",
        QT_TRANSLATE_NOOP("App::Property", "Time at which both sides are compared (s)"),
        0.0,
        0,
    ),
    (
        "App::PropertyLength",
        "MeshDeflection",
        "Input",
        QT_TRANSLATE_NOOP(
            "App::Property", "How far the triangle mesh of a solid may deviate from the solid"
        ),
        0.05,
        0,
    ),
]
RESULT = [
    (kind, name, "Result", text, None, READ_ONLY)
    for kind, name, text in (
        (
            "App::PropertyString",
            "Status",
            QT_TRANSLATE_NOOP("App::Property", "Whether the result is current"),
        ),
        (
            "App::PropertyString",
            "Message",
            QT_TRANSLATE_NOOP("App::Property", "Remarks about the result"),
        ),
        (
            "App::PropertyVolume",
            "Volume",
            QT_TRANSLATE_NOOP("App::Property", "Volume that both sides share"),
        ),
        (
            "App::PropertyLength",
            "Distance",
            QT_TRANSLATE_NOOP(
                "App::Property", "Smallest distance between the parts, if they share no volume"
            ),
        ),
        (
            "App::PropertyLength",
            "Depth",
            QT_TRANSLATE_NOOP(
                "App::Property", "How deep one of the two parts lies inside the other"
            ),
        ),
    )
] + [
    ("App::PropertyString", name, "Result", text, None, HIDDEN)
    for name, text in (
        (
            "InputHash",
            QT_TRANSLATE_NOOP("App::Property", "Checksum of the inputs of the stored result"),
        ),
        (
            "TriedHash",
            QT_TRANSLATE_NOOP("App::Property", "Checksum of the inputs of the last failed run"),
        ),
        (missing.PROPERTY, QT_TRANSLATE_NOOP("App::Property", "Inputs that were deleted (JSON)")),
    )
]
PROPERTIES = INPUT + RESULT + [PLACED]
