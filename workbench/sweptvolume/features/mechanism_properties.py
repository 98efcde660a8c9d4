# SPDX-License-Identifier: LGPL-2.1-or-later
"""The properties of a check of a mechanism: type, name, help, default; those of results are the clearance
check's."""
from ..texts import mark
from . import clearance_properties
from .neighbour_rules import PARTS_PROPERTY

#: What it has as the clearance check has it.
_SAME = ("Neighbours", "RequiredDistance", "Accuracy", "MeshDeflection", "RuleKinds")
_GIVEN = {
    name: (kind, name, text, default) for kind, name, text, default in clearance_properties.INPUT
}

INPUT = [
    (
        "App::PropertyLinkSubListGlobal",
        "MovingParts",
        mark("Properties", "Parts that move, in the order of Motions"),
        None,
    ),
    (
        "App::PropertyLinkListGlobal",
        "Motions",
        mark("Properties", "One motion for each of MovingParts, on a common time axis"),
        None,
    ),
    (
        "App::PropertyBool",
        "AllVisible",
        mark(
            "Properties",
            "All other visible parts are neighbours that stand still, instead of Neighbours",
        ),
        False,
    ),
    (
        "App::PropertyLength",
        "Range",
        mark(
            "Properties",
            "Pairs of parts that come nearer than this are listed; 0: a tenth of the size of the "
            "parts",
        ),
        0.0,
    ),
    (
        "App::PropertyLinkSubListGlobal",
        PARTS_PROPERTY,
        mark(
            "Properties",
            "Pairs of parts, or of groups, that have a rule of their own: first, second, first ...",
        ),
        None,
    ),
    (
        "App::PropertyFloatList",
        "RuleLengths",
        mark(
            "Properties",
            "For each pair of RuleParts, in mm: its required distance, or how deep the parts may "
            "overlap in allowed contact",
        ),
        None,
    ),
] + [_GIVEN[name] for name in _SAME]
RESULT = [
    row for row in clearance_properties.RESULT if row[1] not in ("MapDistances", "Checked")
] + [
    (
        "App::PropertyInteger",
        "Checked",
        mark("Properties", "Number of pairs checked, including those beyond Range"),
        1,
    ),
]
