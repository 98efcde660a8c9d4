# SPDX-License-Identifier: LGPL-2.1-or-later
"""The properties of a solid, as Feature.properties() takes them: type, name, group, help, default, mode."""
from ..texts import mark
from . import missing
from .base import HIDDEN, NOT_COMPUTED, READ_ONLY
from .envelope_properties import PLACED

#: Budget of faces of a new solid.
MAX_FACES = 20000
PROPERTIES = [
    (
        "App::PropertyLinkGlobal",
        "Source",
        "Solid",
        mark("Properties", "Envelope (or any closed mesh) of which this is the solid"),
        None,
        0,
    ),
    (
        "App::PropertyBool",
        "MergeCoplanar",
        "Solid",
        mark("Properties", "Flat regions become single faces"),
        True,
        0,
    ),
    (
        "App::PropertyInteger",
        "MaxFaces",
        "Solid",
        mark("Properties", "At most this many faces; without a Tolerance it is chosen so"),
        MAX_FACES,
        0,
    ),
    (
        "App::PropertyLength",
        "Tolerance",
        "Solid",
        mark(
            "Properties",
            "The solid may leave the mesh by this: cylinders, spheres and the like are found, "
            "the rest is simplified. 0: exact, unless MaxFaces asks for more",
        ),
        0.0,
        0,
    ),
    (
        "App::PropertyLength",
        "Deviation",
        "Result",
        mark("Properties", "Largest distance of the mesh from the solid, as measured"),
        None,
        READ_ONLY,
    ),
    (
        "App::PropertyLength",
        "EdgeTolerance",
        "Result",
        mark(
            "Properties",
            "Largest tolerance of an edge of the solid: its faces meet within it",
        ),
        None,
        READ_ONLY,
    ),
    (
        "App::PropertyString",
        "Status",
        "Result",
        mark("Properties", "State of the result"),
        NOT_COMPUTED,
        READ_ONLY,
    ),
    (
        "App::PropertyString",
        "Message",
        "Result",
        mark("Properties", "Why the last run failed"),
        None,
        READ_ONLY,
    ),
    (
        "App::PropertyInteger",
        "Faces",
        "Result",
        mark("Properties", "Faces of the solid"),
        None,
        READ_ONLY,
    ),
    (
        "App::PropertyVolume",
        "Volume",
        "Result",
        mark("Properties", "Volume of the solid"),
        None,
        READ_ONLY,
    ),
    (
        "App::PropertyString",
        "InputHash",
        "Result",
        mark("Properties", "Inputs of the stored result"),
        None,
        HIDDEN,
    ),
    (
        "App::PropertyString",
        "TriedHash",
        "Result",
        mark("Properties", "Inputs of the last run that gave nothing"),
        None,
        HIDDEN,
    ),
    (
        "App::PropertyString",
        missing.PROPERTY,
        "Result",
        mark("Properties", "Inputs that were deleted (JSON)"),
        None,
        HIDDEN,
    ),
    PLACED,
]
