# SPDX-License-Identifier: LGPL-2.1-or-later
"""For tests of sequences: two blocks that are lowered into a shaft, one after the other."""
from case import V
from sweptvolume.features.sequence_plan import Plan

VALUES = {"RequiredDistance": 0.4, "ReleaseDistance": 0.0, "Accuracy": 0.01, "MeshDeflection": 0.05}


def solid(doc, name, sizes, at):
    obj = doc.addObject("Part::Box", name)
    obj.Length, obj.Width, obj.Height = sizes
    obj.Placement.Base = V(*at)
    return obj


def shaft(doc, height=40):
    """Returns four walls and a floor: 20 mm wide inside, open at the top."""
    return [
        solid(doc, "Floor", (26, 26, 3), (-13, -13, -3)),
        solid(doc, "West", (3, 26, height), (-13, -13, 0)),
        solid(doc, "East", (3, 26, height), (10, -13, 0)),
        solid(doc, "South", (20, 3, height), (-10, -13, 0)),
        solid(doc, "North", (20, 3, height), (-10, 10, 0)),
    ]


def stack(doc):
    """Returns the blocks in the shaft, from the top to the bottom. The lower one must be installed
    first."""
    return [
        solid(doc, "Upper", (18, 18, 9), (-9, -9, 11)),
        solid(doc, "Lower", (18, 18, 9), (-9, -9, 1)),
    ]


def plan_of(doc, parts, walls, motions=None, **search):
    pairs = [(part, "") for part in parts]
    beside = [(wall, "") for wall in walls]
    plan = Plan(doc, pairs, motions or [None] * len(pairs), beside, False, VALUES)
    plan.search.update(Out=90.0, Budget=600.0, **search)
    return plan
