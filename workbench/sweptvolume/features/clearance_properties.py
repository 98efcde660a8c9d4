# SPDX-License-Identifier: LGPL-2.1-or-later
"""The properties of a clearance check: type, name, help, default; of results type, name, help, mode."""
from ..texts import mark
from . import missing, neighbour_rules
from .base import HIDDEN, READ_ONLY

INPUT = [
    (
        "App::PropertyLinkGlobal",
        "Envelope",
        mark(
            "Properties", "Envelope whose parts and motion are checked; it is coloured by distance"
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
        mark("Properties", "Parts that stand still; groups and links stand for what they contain"),
        None,
    ),
    (
        "App::PropertyBool",
        "AllVisible",
        mark("Properties", "All other visible parts are neighbours, instead of Neighbours"),
        True,
    ),
    (
        "App::PropertyLength",
        "RequiredDistance",
        mark("Properties", "Distance from the neighbours that the motion must keep"),
        5.0,
    ),
    (
        "App::PropertyLength",
        "Accuracy",
        mark("Properties", "Largest error of the smallest distance"),
        0.01,
    ),
    (
        "App::PropertyLength",
        "MeshDeflection",
        mark(
            "Properties",
            "How far the triangles of solids may deviate from them; it is subtracted from "
            "guaranteed distances",
        ),
        0.05,
    ),
    (
        "App::PropertyLinkSubListGlobal",
        neighbour_rules.PARTS_PROPERTY,
        mark("Properties", "Neighbours, or groups of them, that have a rule of their own"),
        None,
    ),
    (
        "App::PropertyStringList",
        "RuleKinds",
        mark(
            "Properties",
            "The rule of each of RuleParts: Required (its own required distance), Contact (contact "
            "is allowed), Ignore (not checked)",
        ),
        None,
    ),
    (
        "App::PropertyFloatList",
        "RuleLengths",
        mark(
            "Properties",
            "For each of RuleParts, in mm: its required distance, or how deep the parts may "
            "overlap in allowed contact",
        ),
        None,
    ),
]
RESULT = [
    ("App::PropertyString", "Status", mark("Properties", "State of the result"), READ_ONLY),
    (
        "App::PropertyString",
        "Message",
        mark("Properties", "Why the last run failed; notes"),
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
        mark("Properties", "Distance at each point"),
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
        mark("Properties", "Parts that AllVisible found, to notice when they change"),
        HIDDEN,
    ),
]
