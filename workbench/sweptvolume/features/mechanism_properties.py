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
        mark("Properties", "Parts that move, each with the motion of the same number"),
        None,
    ),
    (
        "App::PropertyLinkListGlobal",
        "Motions",
        mark("Properties", "The motion of each of the moving parts, over common time"),
        None,
    ),
    (
        "App::PropertyBool",
        "AllVisible",
        mark(
            "Properties",
            "Check the other visible parts as well, which stand still, instead of Neighbours",
        ),
        False,
    ),
    (
        "App::PropertyLength",
        "Range",
        mark(
            "Properties",
            "Pairs that come nearer than this are listed; 0: a tenth of the size of the parts",
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
            "mm for each pair of RuleParts: the distance that it asks for, or how deep a contact may be",
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
        mark("Properties", "Pairs of parts that were checked, far ones as well"),
        1,
    ),
]
