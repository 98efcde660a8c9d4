# SPDX-License-Identifier: LGPL-2.1-or-later
"""The properties of a clearance check: type, name, help, default; of results type, name, help, mode."""
from ..texts import mark
from . import missing, neighbour_rules
from .base import HIDDEN, READ_ONLY

INPUT = [
    (
        "App::PropertyLinkGlobal",
        "Envelope",
        mark("Properties", "Envelope whose parts and motion are checked, and which is coloured"),
        None,
    ),
    (
        "App::PropertyLinkSubListGlobal",
        "MovingParts",
        mark("Properties", "Parts that move together, where no envelope is given"),
        None,
    ),
    (
        "App::PropertyLinkGlobal",
        "Motion",
        mark("Properties", "Motion, where no envelope is given"),
        None,
    ),
    (
        "App::PropertyLinkSubListGlobal",
        "Neighbours",
        mark("Properties", "Parts that stand still, seen through groups and links"),
        None,
    ),
    (
        "App::PropertyBool",
        "AllVisible",
        mark("Properties", "Check all other visible parts instead of Neighbours"),
        True,
    ),
    ("App::PropertyLength", "RequiredDistance", mark("Properties", "Distance asked for"), 5.0),
    (
        "App::PropertyLength",
        "Accuracy",
        mark("Properties", "How far the smallest distance may be off between two poses"),
        0.01,
    ),
    (
        "App::PropertyLength",
        "MeshDeflection",
        mark(
            "Properties",
            "Chord error to which solids are meshed; it is subtracted from the distances",
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
            "The rule of each of RuleParts: Required (a distance of its own), Contact (may be touched at "
            "any time), Ignore",
        ),
        None,
    ),
    (
        "App::PropertyFloatList",
        "RuleLengths",
        mark(
            "Properties",
            "mm for each of RuleParts: the distance that it asks for, or how deep a contact may be",
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
        mark("Properties", "Worst verdict against the rules: clear, below, contact or clash"),
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
        mark("Properties", "Inputs of the last run that gave nothing"),
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
        mark("Properties", "What AllVisible looks at, so that a change of it is noticed"),
        HIDDEN,
    ),
]
