# SPDX-License-Identifier: LGPL-2.1-or-later
"""States of a mechanism check whose parts, neighbours and motions are in links and groups, and which has
rules. After each change of the table, the check may be up to date only if a fresh computation gives the
same.
"""
import Part

from case import V, shift, turn
from sweptvolume.features import envelope, mechanism, motion
from sweptvolume.features.base import UP_TO_DATE
from table_case import Table, add_box, changes, put_into, rows

#: name -> what a user does to the document of Grouped.setUp().
CHANGES, change = changes()


@change
def the_linked_part_grows(doc):
    doc.Box.Length = 12


@change
def the_link_shows_another_part(doc):
    doc.Link.LinkedObject = doc.Spare


@change
def the_link_is_scaled(doc):
    doc.Link.Scale = 1.5


@change
def the_link_stands_elsewhere(doc):
    doc.Link.Placement = shift(0, -14)


@change
def the_link_goes(doc):
    doc.removeObject("Link")


@change
def the_arm_is_turned(doc):
    doc.Arm.Placement = turn(15, base=V(0, 40, 0))


@change
def the_group_of_the_arm_is_in_another(doc):
    put_into(doc.Frame, doc.Arm)


@change
def a_part_of_the_arm_is_hidden(doc):
    doc.Nose.Visibility = False


@change
def the_arm_gets_a_part(doc):
    doc.Arm.addObject(add_box(doc, "More", shift(0, -2)))


@change
def the_arm_loses_a_part(doc):
    doc.Arm.removeObject(doc.Nose)


@change
def a_part_of_the_arm_is_deleted(doc):
    doc.removeObject("Nose")


@change
def the_walls_move(doc):
    doc.Walls.Placement = shift(0, 2)


@change
def the_walls_get_one_more(doc):
    doc.Walls.addObject(add_box(doc, "Third", shift(0, -40)))


@change
def one_of_the_walls_is_hidden(doc):
    doc.Near.Visibility = False


@change
def the_walls_are_hidden(doc):
    doc.Walls.Visibility = False


@change
def the_wire_is_bent(doc):
    doc.Wire.Shape = Part.makeLine(V(), V(25, 3, 0))


@change
def the_wire_is_in_a_group(doc):
    put_into(doc.Frame, doc.Wire)


@change
def the_wire_lasts_longer(doc):
    doc.Motion.SourceDuration = 2


@change
def the_wire_goes(doc):
    doc.removeObject("Wire")


@change
def a_motion_is_in_a_group(doc):
    put_into(doc.Frame, doc.Motion001)


@change
def a_motion_has_a_pivot(doc):
    doc.Motion001.Pivot = V(5, 5, 5)


@change
def a_motion_is_smooth(doc):
    doc.Motion001.Interpolation = "Spline"


@change
def a_motion_is_not_relative(doc):
    doc.Motion001.PoseType = "Absolute"


@change
def motions_are_exchanged(doc):
    doc.Mechanism.Motions = list(reversed(doc.Mechanism.Motions))


@change
def a_wall_moves_along(doc):
    doc.Mechanism.MovingParts = doc.Mechanism.MovingParts + [(doc.Walls, "Near.")]
    doc.Mechanism.Motions = doc.Mechanism.Motions + [doc.Motion001]


@change
def the_rule_is_of_another_wall(doc):
    doc.Mechanism.RuleParts = [(doc.Link, ""), (doc.Walls, "Far.")]


@change
def the_rule_is_gone(doc):
    doc.Mechanism.RuleParts, doc.Mechanism.RuleKinds, doc.Mechanism.RuleLengths = [], [], []


@change
def required_by_an_expression(doc):
    doc.Mechanism.setExpression("RequiredDistance", "Values.distance")


@change
def another_unit_of_the_sheet(doc):
    doc.Values.set("A1", "0.7 cm")


@change
def the_check_is_in_a_group(doc):
    put_into(doc.Frame, doc.Mechanism)


@change
def the_envelope_is_a_neighbour(doc):
    doc.Mechanism.Neighbours = [(doc.Envelope, "")]


@change
def all_that_is_visible(doc):
    doc.Mechanism.AllVisible = True


@change
def all_that_is_visible_and_one_more(doc):
    doc.Mechanism.AllVisible = True
    add_box(doc, "Fourth", shift(0, -60))


@change
def copied_alone(doc):
    doc.copyObject(doc.Mechanism, False)


@change
def copied_with_all_that_it_needs(doc):
    doc.copyObject(doc.Mechanism, True)


@change
def other_names(doc):
    for obj in doc.Objects:
        obj.Label = "New " + obj.Label


@rows
class Grouped(Table):
    CHANGES = CHANGES

    def setUp(self):
        super().setUp()
        doc = self.doc
        box, spare, nose = self.box(), self.box("Spare", 7), self.box("Nose", 4)
        link = doc.addObject("App::Link", "Link")
        link.LinkedObject, link.Placement = box, shift(0, -15)
        box.Visibility = spare.Visibility = False
        arm = doc.addObject("App::Part", "Arm")
        doc.addObject("App::Part", "Frame")
        arm.Placement = shift(0, 40)
        base = self.box("Base", 6)
        arm.addObject(base)
        arm.addObject(nose)
        nose.Placement = shift(1, 1, 6)
        walls, near, far = doc.addObject("App::Part", "Walls"), self.box("Near"), self.box("Far")
        walls.addObject(near)
        walls.addObject(far)
        near.Placement, far.Placement = shift(50), shift(90)
        wire = self.straight_wire()
        self.sheet("distance", "6 mm")
        doc.recompute()
        motion.motion_from_source(doc, "Curve", [wire])
        relative = motion.motion_from_poses(doc, [0, 1], [shift(), turn(20, base=V(10, -5, 0))])
        doc.Motion.PoseType = relative.PoseType = "RelativeToFirst"
        doc.recompute()
        self.envelope([link], doc.Motion, Resolution=16)
        check = mechanism.make_mechanism(
            doc,
            MovingParts=[(link, ""), (arm, "")],
            Motions=[doc.Motion, relative],
            Neighbours=[(walls, "")],
        )
        check.RuleParts = [(link, ""), (walls, "Near.")]
        check.RuleKinds, check.RuleLengths = ["Required"], [9]
        doc.recompute()
        envelope.compute(doc.Envelope)
        mechanism.compute(check)
        doc.recompute()

    def test_nothing_changes_nothing(self):
        self.assertEqual({o.Status for o in self.results()}, {UP_TO_DATE})
        self.check_states("nothing")

    def test_saved_and_opened(self):
        before = {obj.Name: self.content(obj) for obj in self.results()}
        self.reopen()
        self.doc.recompute(None, True)
        self.assertEqual({obj.Name: self.content(obj) for obj in self.results()}, before)
        self.assertEqual({o.Status for o in self.results()}, {UP_TO_DATE})
        self.check_states("opened")
