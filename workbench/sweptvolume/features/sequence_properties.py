# SPDX-License-Identifier: LGPL-2.1-or-later
"""The properties of a sequence: type, name, help, default. Some of them are the same as in the
mechanism check."""
from ..texts import QT_TRANSLATE_NOOP
from . import mechanism_properties, path_plan

_SAME = ("Neighbours", "AllVisible", "Accuracy", "MeshDeflection")
_SAME += ("RuleParts", "RuleKinds", "RuleLengths")
_GIVEN = {row[1]: row for row in mechanism_properties.INPUT}

INPUT = [
    (
        "App::PropertyLinkSubListGlobal",
        "MovingParts",
        QT_TRANSLATE_NOOP("App::Property", "Parts, in the order in which they are installed"),
        None,
    ),
    (
        "App::PropertyLinkListGlobal",
        "Motions",
        QT_TRANSLATE_NOOP(
            "App::Property", "One motion for each part. It ends where the part is installed"
        ),
        None,
    ),
    (
        "App::PropertyLength",
        "RequiredDistance",
        QT_TRANSLATE_NOOP(
            "App::Property", "Distance that each part must keep from the parts already in place"
        ),
        path_plan.DEFAULTS["RequiredDistance"],
    ),
    (
        "App::PropertyLength",
        "ReleaseDistance",
        QT_TRANSLATE_NOOP(
            "App::Property",
            "Release distance. At the start or end of its motion, a part may touch another part. "
            "This contact may last until some point of the moving part has moved farther than "
            "this length",
        ),
        path_plan.DEFAULTS["ReleaseDistance"],
    ),
] + [_GIVEN[name] for name in _SAME]
RESULT = [row for row in mechanism_properties.RESULT if row[1] != "Checked"] + [
    (
        "App::PropertyInteger",
        "Checked",
        QT_TRANSLATE_NOOP("App::Property", "Number of parts that have a path"),
        1,
    ),
]
