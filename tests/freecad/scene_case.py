# SPDX-License-Identifier: LGPL-2.1-or-later
"""Shared by the tests of several features: a part, and one result of each kind that is computed from it."""
import Part

from case import Case, V, shift
from sweptvolume.features import clearance, envelope, neighbour_rules, solid
from sweptvolume.features.neighbour_rules import CONTACT, Rule


def plate(hole):
    """Returns a plate with a round hole at x = hole. Number of faces, area, lengths of edges, volume
    and bounding box do not depend on x."""
    return Part.makeBox(40, 20, 4).cut(Part.makeCylinder(3, 4, V(hole, 10, 0)))


class Slide(Case):
    """A box that slides on a table, which it may touch, up to a distance of 3.5 mm from a wall."""

    NEEDS_CORE = True
    WALL = "Wall"

    def setUp(self):
        super().setUp()
        self.part = self.box("Schieber")
        self.path = self.line()  # 30 mm along x: the box ends at x = 40
        self.wall = self.box("Wall")
        self.wall.Label = self.WALL
        self.wall.Placement = shift(x=43.5)
        self.table = self.box("Table")
        self.table.Length, self.table.Width, self.table.Height = 80, 40, 5
        self.table.Placement = shift(x=-20, y=-15, z=-5)
        self.doc.recompute()

    def check(self, required=5.0, label="Check"):
        obj = clearance.make_clearance(
            self.doc,
            label,
            MovingParts=[(self.part, "")],
            Motion=self.path,
            RequiredDistance=required,
        )
        neighbour_rules.write(obj, {(self.table, ""): Rule(CONTACT)})
        return obj


class Scene(Case):
    """A box that moves, its envelope and solid, and a check with all visible parts. All are computed."""

    NEEDS_CORE = True

    def setUp(self):
        super().setUp()
        self.part = self.doc.addObject("Part::Feature", "Plate")
        self.part.Shape = plate(10)
        self.path = self.line()
        self.wall = self.box("Wall")
        self.wall.Placement = shift(80)
        self.swept = self.envelope([self.part], self.path, Resolution=24)
        envelope.compute(self.swept)
        self.body = solid.make_solid(self.doc, self.swept)
        self.check = clearance.make_clearance(
            self.doc, MovingParts=[(self.part, "")], Motion=self.path
        )
        self.doc.recompute()
        solid.compute(self.body)
        clearance.compute(self.check)
        self.doc.recompute()
        self.assert_states(envelope.UP_TO_DATE, envelope.UP_TO_DATE, envelope.UP_TO_DATE)

    def states(self):
        return self.swept.Status, self.body.Status, self.check.Status

    def assert_states(self, *wanted):
        self.assertEqual(self.states(), wanted)
