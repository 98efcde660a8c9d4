# SPDX-License-Identifier: LGPL-2.1-or-later
"""The properties of a motion for Feature.properties(): type, name, group, help, default, mode."""
from ..texts import QT_TRANSLATE_NOOP
from ..trajectory import sources
from ..trajectory.cam import CONVENTIONS
from ..trajectory.curve import ACCURACY, ORIENTATIONS
from ..trajectory.poses import FRAME_HELP, FRAMES, INTERPOLATIONS
from . import missing
from .base import HIDDEN, READ_ONLY

UNITS = ["mm", "cm", "m", "in"]

PROPERTIES = [
    (
        "App::PropertyFloatList",
        "Times",
        "Motion",
        QT_TRANSLATE_NOOP("App::Property", "Time of each pose (s), in ascending order"),
        None,
        0,
    ),
    (
        "App::PropertyPlacementList",
        "Placements",
        "Motion",
        QT_TRANSLATE_NOOP(
            "App::Property",
            "Placement of each pose. PoseType says whether it replaces the placement of the part "
            "or is a displacement from it",
        ),
        None,
        0,
    ),
    (
        "App::PropertyEnumeration",
        "Interpolation",
        "Motion",
        QT_TRANSLATE_NOOP(
            "App::Property",
            "How the part moves between two poses. Linear: along a straight line, turning at a "
            "constant rate. Screw: turning about an axis and moving along it, like a screw. "
            "Spline: along a smooth curve through all poses. None: only the poses themselves "
            "count, there is no motion between them",
        ),
        list(INTERPOLATIONS),
        0,
    ),
    ("App::PropertyEnumeration", "PoseType", "Motion", FRAME_HELP, list(FRAMES), 0),
    (
        "App::PropertyVectorDistance",
        "Pivot",
        "Motion",
        QT_TRANSLATE_NOOP(
            "App::Property",
            "Point of the part that follows the straight line (Linear) or the curve "
            "(Spline) between two poses, and about which the part turns. Coordinates: "
            "those of the part if PoseType is Absolute; those of the document, or of the "
            "group that holds the motion, if it is Relative; those with the position and "
            "orientation of the first pose if it is RelativeToFirst",
        ),
        None,
        0,
    ),
    (
        "App::PropertyLinkSubListHidden",
        "Parts",
        "Motion",
        QT_TRANSLATE_NOOP(
            "App::Property",
            "Parts that this motion moves. The motion editor shows the first part",
        ),
        None,
        0,
    ),
    (
        "App::PropertyLinkListHidden",
        "MovedToo",
        "Motion",
        QT_TRANSLATE_NOOP(
            "App::Property",
            "Other parts that moved too when this motion was recorded from an assembly "
            "simulation or a driving value",
        ),
        None,
        READ_ONLY,
    ),
    (
        "App::PropertyStringList",
        "Tangents",
        "Motion",
        QT_TRANSLATE_NOOP(
            "App::Property",
            "Tangent of the spline at each pose. Auto: from the poses before and "
            "after. Stop: the part comes to rest. Corner: the direction may change "
            "abruptly. Given: the velocity in Velocities. Missing entries count as "
            "Auto",
        ),
        None,
        0,
    ),
    (
        "App::PropertyVectorList",
        "Velocities",
        "Motion",
        QT_TRANSLATE_NOOP(
            "App::Property",
            "Velocity of the spline (mm/s), one entry for each pose. Used only if the "
            "tangent at the pose is Given",
        ),
        None,
        0,
    ),
    (
        "App::PropertyEnumeration",
        "SourceType",
        "Source",
        QT_TRANSLATE_NOOP("App::Property", "Where the poses come from"),
        list(sources.KINDS),
        READ_ONLY,
    ),
    (
        "App::PropertyFile",
        "SourceFile",
        "Source",
        QT_TRANSLATE_NOOP(
            "App::Property", "File from which the poses were read. Reload motion reads it again"
        ),
        None,
        0,
    ),
    (
        "App::PropertyEnumeration",
        "SourceUnit",
        "Source",
        QT_TRANSLATE_NOOP("App::Property", "Unit of the lengths in the file"),
        list(UNITS),
        0,
    ),
    (
        "App::PropertyLinkListGlobal",
        "SourceObjects",
        "Source",
        QT_TRANSLATE_NOOP(
            "App::Property", "Objects from whose placements or shapes the poses are read"
        ),
        None,
        0,
    ),
    (
        "App::PropertyString",
        "SourceSettings",
        "Source",
        QT_TRANSLATE_NOOP("App::Property", "Settings of the source"),
        None,
        HIDDEN,
    ),
    (
        "App::PropertyInteger",
        "Count",
        "Result",
        QT_TRANSLATE_NOOP("App::Property", "Number of poses"),
        None,
        READ_ONLY,
    ),
    (
        "App::PropertyFloat",
        "Duration",
        "Result",
        QT_TRANSLATE_NOOP("App::Property", "Last time minus first time (s)"),
        None,
        READ_ONLY,
    ),
    (
        "App::PropertyString",
        "Status",
        "Result",
        QT_TRANSLATE_NOOP(
            "App::Property", "What is wrong with the motion. Empty: the motion can be used"
        ),
        None,
        READ_ONLY,
    ),
    (
        "App::PropertyString",
        "Message",
        "Result",
        QT_TRANSLATE_NOOP("App::Property", "Remarks from reading the poses"),
        None,
        READ_ONLY,
    ),
    (
        "App::PropertyString",
        "SourceHash",
        "Source",
        QT_TRANSLATE_NOOP(
            "App::Property",
            "Checksum of the source at the time it was read. If the source changes after that, "
            "the motion is stale",
        ),
        None,
        HIDDEN,
    ),
    (
        "App::PropertyString",
        missing.PROPERTY,
        "Source",
        QT_TRANSLATE_NOOP("App::Property", "Inputs that were deleted (JSON)"),
        None,
        HIDDEN,
    ),
]

#: Setting of a source (trajectory/sources.py) -> type, name, help and default of its property.
_SETTINGS = {
    "count": (
        "App::PropertyInteger",
        "SourceCount",
        QT_TRANSLATE_NOOP(
            "App::Property",
            "Number of poses to read. 0 (only for curves): as many poses as SourceAccuracy "
            "requires",
        ),
        0,
    ),
    "accuracy": (
        "App::PropertyLength",
        "SourceAccuracy",
        QT_TRANSLATE_NOOP(
            "App::Property",
            "How far the straight line between two poses may deviate from the curve",
        ),
        ACCURACY,
    ),
    "orientation": (
        "App::PropertyEnumeration",
        "SourceOrientation",
        QT_TRANSLATE_NOOP(
            "App::Property",
            "Orientation of the part. Fixed: it never turns. Tangent: its x axis "
            "follows the tangent. SecondCurve: as Tangent, and its z axis points to "
            "the second curve",
        ),
        ORIENTATIONS,
    ),
    "duration": (
        "App::PropertyFloat",
        "SourceDuration",
        QT_TRANSLATE_NOOP("App::Property", "Time from the first to the last pose (s)"),
        10.0,
    ),
    "step": (
        "App::PropertyFloat",
        "SourceStep",
        QT_TRANSLATE_NOOP("App::Property", "Time from one pose to the next (s)"),
        1.0,
    ),
    "rapid": (
        "App::PropertySpeed",
        "SourceRapid",
        QT_TRANSLATE_NOOP("App::Property", "Speed of rapid moves (G0)"),
        100.0,
    ),
    "convention": (
        "App::PropertyEnumeration",
        "SourceRotaryAxes",
        QT_TRANSLATE_NOOP(
            "App::Property", "What the G-code words A, B and C rotate: the tool head or the table"
        ),
        CONVENTIONS,
    ),
    "property": (
        "App::PropertyString",
        "SourceValue",
        QT_TRANSLATE_NOOP("App::Property", "Name of the value that is changed to move the part"),
        None,
    ),
    "start": (
        "App::PropertyFloat",
        "SourceStart",
        QT_TRANSLATE_NOOP(
            "App::Property",
            "Number to which the driving value (SourceValue) is set at the first pose, in its "
            "own unit (such as mm or degrees)",
        ),
        None,
    ),
    "end": (
        "App::PropertyFloat",
        "SourceEnd",
        QT_TRANSLATE_NOOP(
            "App::Property",
            "Number to which the driving value (SourceValue) is set at the last pose, in its own "
            "unit (such as mm or degrees)",
        ),
        None,
    ),
}
#: Hidden, except for the settings that the kind of source uses (motion_source.show_settings()).
SETTINGS = [
    (kind, name, "Source", text, default, HIDDEN)
    for kind, name, text, default in _SETTINGS.values()
]
NAMES = {key: entry[1] for key, entry in _SETTINGS.items()}
#: Kind of source -> its settings.
USED = {
    "Placements": ("step",),
    "Curve": ("accuracy", "count", "orientation", "duration"),
    "Robot": ("count",),
    "Array": ("step",),
    "CAM": ("rapid", "convention"),
    "Driven": ("property", "start", "end", "count", "duration"),
}
