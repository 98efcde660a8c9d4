# SPDX-License-Identifier: LGPL-2.1-or-later
"""The properties of a solid for Feature.properties(): type, name, group, help, default, mode."""
from ..texts import QT_TRANSLATE_NOOP
from . import missing
from .base import HIDDEN, NOT_COMPUTED, READ_ONLY
from .envelope_properties import PLACED

#: Limit of faces of a new solid.
MAX_FACES = 20000
PROPERTIES = [
    (
        "App::PropertyLinkGlobal",
        "Source",
        "Solid",
        QT_TRANSLATE_NOOP(
            "App::Property", "Envelope or other closed mesh that is converted to a solid"
        ),
        None,
        0,
    ),
    (
        "App::PropertyBool",
        "MergeCoplanar",
        "Solid",
        QT_TRANSLATE_NOOP(
            "App::Property", "Whether adjacent coplanar triangles are merged into one flat face"
        ),
        True,
        0,
    ),
    (
        "App::PropertyInteger",
        "MaxFaces",
        "Solid",
        QT_TRANSLATE_NOOP(
            "App::Property",
            "Largest number of faces. If Tolerance is 0 and the exact solid would have more "
            "faces, the solid is simplified with the smallest tolerance that is enough",
        ),
        MAX_FACES,
        0,
    ),
    (
        "App::PropertyLength",
        "Tolerance",
        "Solid",
        QT_TRANSLATE_NOOP(
            "App::Property",
            "Largest deviation from the mesh to aim at. Not guaranteed: Deviation is "
            "the measured value. Within this tolerance, cylinders, spheres and other surfaces are "
            "recognised, and the rest is simplified. 0: exact, unless MaxFaces requires a "
            "tolerance",
        ),
        0.0,
        0,
    ),
    (
        "App::PropertyLength",
        "Deviation",
        "Result",
        QT_TRANSLATE_NOOP(
            "App::Property", "Largest distance of the mesh from the solid, as measured"
        ),
        None,
        READ_ONLY,
    ),
    (
        "App::PropertyLength",
        "EdgeTolerance",
        "Result",
        QT_TRANSLATE_NOOP(
            "App::Property",
            "Largest gap between two faces that share an edge",
        ),
        None,
        READ_ONLY,
    ),
    (
        "App::PropertyString",
        "Status",
        "Result",
        QT_TRANSLATE_NOOP("App::Property", "State of the result"),
        NOT_COMPUTED,
        READ_ONLY,
    ),
    (
        "App::PropertyString",
        "Message",
        "Result",
        QT_TRANSLATE_NOOP("App::Property", "Why the last run failed"),
        None,
        READ_ONLY,
    ),
    (
        "App::PropertyInteger",
        "Faces",
        "Result",
        QT_TRANSLATE_NOOP("App::Property", "Faces of the solid"),
        None,
        READ_ONLY,
    ),
    (
        "App::PropertyVolume",
        "Volume",
        "Result",
        QT_TRANSLATE_NOOP("App::Property", "Volume of the solid"),
        None,
        READ_ONLY,
    ),
    (
        "App::PropertyString",
        "InputHash",
        "Result",
        QT_TRANSLATE_NOOP("App::Property", "Checksum of the inputs of the stored result"),
        None,
        HIDDEN,
    ),
    (
        "App::PropertyString",
        "TriedHash",
        "Result",
        QT_TRANSLATE_NOOP("App::Property", "Checksum of the inputs of the last failed run"),
        None,
        HIDDEN,
    ),
    (
        "App::PropertyString",
        missing.PROPERTY,
        "Result",
        QT_TRANSLATE_NOOP("App::Property", "Inputs that were deleted (JSON)"),
        None,
        HIDDEN,
    ),
    PLACED,
]
