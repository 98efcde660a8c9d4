# SPDX-License-Identifier: LGPL-2.1-or-later
"""The properties of a mechanism check: type, name, help, default. The result properties are the
same as in the clearance check, except two."""
from ..texts import QT_TRANSLATE_NOOP
from . import clearance_properties
from .neighbour_rules import PARTS_PROPERTY

#: Properties that are the same as in the clearance check.
_SAME = ("Neighbours", "RequiredDistance", "Accuracy", "MeshDeflection", "RuleKinds")
_GIVEN = {
    name: (kind, name, text, default) for kind, name, text, default in clearance_properties.INPUT
}

INPUT = [
    (
        "App::PropertyLinkSubListGlobal",
        "MovingParts",
        QT_TRANSLATE_NOOP("App::Property", "Parts that move, in the order of Motions"),
        None,
    ),
    (
        "App::PropertyLinkListGlobal",
        "Motions",
        QT_TRANSLATE_NOOP(
            "App::Property",
            "One motion for each entry of MovingParts. All motions use the same time axis",
        ),
        None,
    ),
    (
        "App::PropertyBool",
        "AllVisible",
        QT_TRANSLATE_NOOP(
            "App::Property",
            "True: all other visible parts are neighbours that stand still, and the "
            "list Neighbours is not used",
        ),
        False,
    ),
    (
        "App::PropertyLength",
        "Range",
        QT_TRANSLATE_NOOP(
            "App::Property",
            "Pairs of parts that come closer than this length are listed. 0: a tenth of the "
            "median size of the parts, or more if a rule needs it",
        ),
        0.0,
    ),
    (
        "App::PropertyLinkSubListGlobal",
        PARTS_PROPERTY,
        QT_TRANSLATE_NOOP(
            "App::Property",
            "Parts or groups of each pair that has its own rule, two entries for "
            "each pair: first, second, first, second ...",
        ),
        None,
    ),
    (
        "App::PropertyFloatList",
        "RuleLengths",
        QT_TRANSLATE_NOOP(
            "App::Property",
            "A length (mm) for each pair of RuleParts. Rule Required: the required "
            "distance. Rule Contact: the largest depth to which the parts may overlap",
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
        QT_TRANSLATE_NOOP(
            "App::Property",
            "Number of pairs checked, including pairs that stay farther apart than Range",
        ),
        1,
    ),
]
