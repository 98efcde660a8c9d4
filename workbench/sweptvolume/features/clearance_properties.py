# SPDX-License-Identifier: LGPL-2.1-or-later
"""The properties of a clearance check. Inputs: type, name, help, default. Results: type, name,
help, mode."""
from ..texts import mark
from . import missing, neighbour_rules
from .base import HIDDEN, READ_ONLY

INPUT = [
    (
        "App::PropertyLinkGlobal",
        "Envelope",
        mark(
            "Properties",
            "Envelope that is checked, with its parts and its motion. The envelope "
            "can be coloured by distance",
        ),
        None,
    ),
    (
        "App::PropertyLinkSubListGlobal",
        "MovingParts",
        mark("Properties", "Parts that move together, if no envelope is given"),
        None,
    ),
    (
        "App::PropertyLinkGlobal",
        "Motion",
        mark("Properties", "Motion of the parts, if no envelope is given"),
        None,
    ),
    (
        "App::PropertyLinkSubListGlobal",
        "Neighbours",
        mark(
            "Properties", "Parts that stand still. A group or link stands for all the parts in it"
        ),
        None,
    ),
    (
        "App::PropertyBool",
        "AllVisible",
        mark(
            "Properties",
            "True: all other visible parts are neighbours, and the list Neighbours is " "not used",
        ),
        True,
    ),
    (
        "App::PropertyLength",
        "RequiredDistance",
        mark(
            "Properties", "Distance that the parts must keep from the neighbours during the motion"
        ),
        5.0,
    ),
    (
        "App::PropertyLength",
        "Accuracy",
        mark("Properties", "Largest allowed error of the smallest distance"),
        0.01,
    ),
    (
        "App::PropertyLength",
        "MeshDeflection",
        mark(
            "Properties",
            "How far the triangle mesh of a solid may deviate from the solid. This deviation is "
            "subtracted from guaranteed distances",
        ),
        0.05,
    ),
    (
        "App::PropertyLinkSubListGlobal",
        neighbour_rules.PARTS_PROPERTY,
        mark("Properties", "Neighbours, or groups of neighbours, that have their own rule"),
        None,
    ),
    (
        "App::PropertyStringList",
        "RuleKinds",
        mark(
            "Properties",
            "The rule of each entry of RuleParts. Required: its own required "
            "distance. Contact: contact is allowed. Ignore: not checked",
        ),
        None,
    ),
    (
        "App::PropertyFloatList",
        "RuleLengths",
        mark(
            "Properties",
            "A length (mm) for each entry of RuleParts. Rule Required: the required "
            "distance. Rule Contact: the largest depth to which the parts may overlap",
        ),
        None,
    ),
]
RESULT = [
    ("App::PropertyString", "Status", mark("Properties", "State of the result"), READ_ONLY),
    (
        "App::PropertyString",
        "Message",
        mark("Properties", "Why the last run failed, and notes"),
        READ_ONLY,
    ),
    ("App::PropertyString", "Summary", mark("Properties", "Result in one line"), READ_ONLY),
    ("App::PropertyInteger", "Checked", mark("Properties", "Neighbours checked"), READ_ONLY),
    (
        "App::PropertyString",
        "Verdict",
        mark(
            "Properties",
            "Worst verdict of all rows: clear, below (below required), contact or clash",
        ),
        READ_ONLY,
    ),
    ("App::PropertyLength", "Smallest", mark("Properties", "Smallest distance"), READ_ONLY),
    ("App::PropertyString", "Report", mark("Properties", "Report of the run (JSON)"), HIDDEN),
    (
        "App::PropertyFloatList",
        "MapDistances",
        mark("Properties", "Distance at each vertex of the envelope, for its colours"),
        HIDDEN,
    ),
    ("App::PropertyString", "InputHash", mark("Properties", "Inputs of the stored result"), HIDDEN),
    (
        "App::PropertyString",
        "TriedHash",
        mark("Properties", "Inputs of the last run that failed"),
        HIDDEN,
    ),
    (
        "App::PropertyString",
        missing.PROPERTY,
        mark("Properties", "Inputs that were deleted (JSON)"),
        HIDDEN,
    ),
    (
        "App::PropertyLinkListGlobal",
        "Seen",
        mark(
            "Properties",
            "Parts that were visible in the last run, recorded if AllVisible was true. If one of "
            "them changes, the result is stale",
        ),
        HIDDEN,
    ),
]
