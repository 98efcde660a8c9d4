# SPDX-License-Identifier: LGPL-2.1-or-later
"""The properties of a clearance check. Inputs: type, name, help, default. Results: type, name,
help, mode."""
from ..texts import QT_TRANSLATE_NOOP
from . import missing, neighbour_rules
from .base import HIDDEN, READ_ONLY

ACCURACY_HELP = QT_TRANSLATE_NOOP(
    "App::Property",
    "Largest allowed error of the smallest distance. If the motion has the interpolation Spline, "
    "or is relative to a moving part, half of this value is subtracted in addition from the "
    "guaranteed distance and in the verdict",
)

INPUT = [
    (
        "App::PropertyLinkGlobal",
        "Envelope",
        QT_TRANSLATE_NOOP(
            "App::Property",
            "Envelope that is checked, with its parts and its motion. The envelope "
            "can be coloured by distance",
        ),
        None,
    ),
    (
        "App::PropertyLinkSubListGlobal",
        "MovingParts",
        QT_TRANSLATE_NOOP(
            "App::Property", "Parts that move together. Used if no envelope is given"
        ),
        None,
    ),
    (
        "App::PropertyLinkGlobal",
        "Motion",
        QT_TRANSLATE_NOOP("App::Property", "Motion of the parts. Used if no envelope is given"),
        None,
    ),
    (
        "App::PropertyLinkSubListGlobal",
        "Neighbours",
        QT_TRANSLATE_NOOP(
            "App::Property",
            "Parts that stand still. A group or link stands for all the parts in it",
        ),
        None,
    ),
    (
        "App::PropertyBool",
        "AllVisible",
        QT_TRANSLATE_NOOP(
            "App::Property",
            "True: all other visible parts are neighbours, and the list Neighbours is " "not used",
        ),
        True,
    ),
    (
        "App::PropertyLength",
        "RequiredDistance",
        QT_TRANSLATE_NOOP(
            "App::Property",
            "Distance that the parts must keep from the neighbours during the motion",
        ),
        5.0,
    ),
    (
        "App::PropertyLength",
        "Accuracy",
        ACCURACY_HELP,
        0.01,
    ),
    (
        "App::PropertyLength",
        "MeshDeflection",
        QT_TRANSLATE_NOOP(
            "App::Property",
            "How far the triangle mesh of a solid may deviate from the solid. This deviation is "
            "subtracted from guaranteed distances",
        ),
        0.05,
    ),
    (
        "App::PropertyLinkSubListGlobal",
        neighbour_rules.PARTS_PROPERTY,
        QT_TRANSLATE_NOOP(
            "App::Property", "Neighbours, or groups of neighbours, that have their own rule"
        ),
        None,
    ),
    (
        "App::PropertyStringList",
        "RuleKinds",
        QT_TRANSLATE_NOOP(
            "App::Property",
            "The rule of each entry of RuleParts. Required: its own required "
            "distance. Contact: contact is allowed. Ignore: not checked",
        ),
        None,
    ),
    (
        "App::PropertyFloatList",
        "RuleLengths",
        QT_TRANSLATE_NOOP(
            "App::Property",
            "A length (mm) for each entry of RuleParts. Rule Required: the required "
            "distance. Rule Contact: the largest depth to which the parts may overlap",
        ),
        None,
    ),
]
RESULT = [
    (
        "App::PropertyString",
        "Status",
        QT_TRANSLATE_NOOP("App::Property", "State of the result"),
        READ_ONLY,
    ),
    (
        "App::PropertyString",
        "Message",
        QT_TRANSLATE_NOOP("App::Property", "Why the last run failed, and its findings"),
        READ_ONLY,
    ),
    (
        "App::PropertyString",
        "Summary",
        QT_TRANSLATE_NOOP("App::Property", "Result in one line"),
        READ_ONLY,
    ),
    (
        "App::PropertyInteger",
        "Checked",
        QT_TRANSLATE_NOOP("App::Property", "Number of neighbours checked"),
        READ_ONLY,
    ),
    (
        "App::PropertyString",
        "Verdict",
        QT_TRANSLATE_NOOP(
            "App::Property",
            "Worst verdict of all rows: clear, below (below required), contact or clash",
        ),
        READ_ONLY,
    ),
    (
        "App::PropertyLength",
        "Smallest",
        QT_TRANSLATE_NOOP("App::Property", "Smallest distance"),
        READ_ONLY,
    ),
    (
        "App::PropertyString",
        "Report",
        QT_TRANSLATE_NOOP("App::Property", "Report of the run (JSON)"),
        HIDDEN,
    ),
    (
        "App::PropertyFloatList",
        "MapDistances",
        QT_TRANSLATE_NOOP(
            "App::Property",
            "Distance of each vertex of the envelope from the nearest neighbouring part, for the "
            "colours of the envelope",
        ),
        HIDDEN,
    ),
    (
        "App::PropertyString",
        "InputHash",
        QT_TRANSLATE_NOOP("App::Property", "Checksum of the inputs of the stored result"),
        HIDDEN,
    ),
    (
        "App::PropertyString",
        "TriedHash",
        QT_TRANSLATE_NOOP("App::Property", "Checksum of the inputs of the last failed run"),
        HIDDEN,
    ),
    (
        "App::PropertyString",
        missing.PROPERTY,
        QT_TRANSLATE_NOOP("App::Property", "Inputs that were deleted (JSON)"),
        HIDDEN,
    ),
    (
        "App::PropertyLinkListGlobal",
        "Seen",
        QT_TRANSLATE_NOOP(
            "App::Property",
            "Parts that were visible in the last run (stored only if AllVisible was true). If "
            "one of them changes, the result is stale",
        ),
        HIDDEN,
    ),
]
