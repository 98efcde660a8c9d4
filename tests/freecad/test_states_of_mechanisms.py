# SPDX-License-Identifier: LGPL-2.1-or-later
"""States of a mechanism check. After each change of the table, the check may be up to date only if a fresh
computation gives the same result.
"""
from case import V, shift, turn
from sweptvolume.features import mechanism
from sweptvolume.features.base import UP_TO_DATE
from sweptvolume.features.motion import motion_from_poses
from table_case import Table, changes, put_into, rows

#: name -> what a user does to the document of Mechanisms.setUp().
CHANGES, change = changes()


@change
def a_part_grows(doc):
    doc.Box.Length = 12


@change
def the_other_part_stands_elsewhere(doc):
    doc.Other.Placement = shift(0, 13)


@change
def a_motion_goes_elsewhere(doc):
    doc.Motion001.Placements = [shift(60, 11.5), shift(-20, 11.5)]


@change
def a_motion_is_later(doc):
    doc.Motion001.Times = [0.5, 1.5]


@change
def motions_without_common_time(doc):
    doc.Motion001.Times = [2, 3]


@change
def a_motion_only_jumps(doc):
    doc.Motion.Interpolation = "None"


@change
def a_motion_by_screws(doc):
    doc.Motion.Interpolation = "Screw"


@change
def a_motion_is_deleted(doc):
    doc.removeObject("Motion001")


@change
def both_have_one_motion(doc):
    doc.Mechanism.Motions = [doc.Motion, doc.Motion]


@change
def a_motion_is_missing(doc):
    doc.Mechanism.Motions = [doc.Motion]


@change
def a_part_is_deleted(doc):
    doc.removeObject("Other")


@change
def a_part_is_there_twice(doc):
    doc.Mechanism.MovingParts = [(doc.Box, ""), (doc.Box, "")]


@change
def another_distance_is_required(doc):
    doc.Mechanism.RequiredDistance = 4


@change
def distance_by_expression(doc):
    doc.Mechanism.setExpression("RequiredDistance", "Box.Length / 4")


@change
def a_wider_range(doc):
    doc.Mechanism.Range = 200


@change
def coarser(doc):
    doc.Mechanism.Accuracy = 0.3


@change
def a_pair_is_ignored(doc):
    doc.Mechanism.RuleParts = [(doc.Other, ""), (doc.Box, "")]
    doc.Mechanism.RuleKinds, doc.Mechanism.RuleLengths = ["Ignore"], [0]


@change
def a_pair_asks_for_more(doc):
    doc.Mechanism.RuleParts = [(doc.Box, ""), (doc.Wall, "")]
    doc.Mechanism.RuleKinds, doc.Mechanism.RuleLengths = ["Required"], [7]


@change
def a_rule_that_does_not_fit(doc):
    doc.Mechanism.RuleKinds = ["Ignore"]


@change
def the_wall_moves(doc):
    doc.Wall.Placement = shift(50)


@change
def the_wall_moves_by_itself_too(doc):
    doc.Mechanism.Neighbours = [(doc.Wall, ""), (doc.Box, "")]


@change
def the_wall_is_hidden(doc):
    doc.Wall.Visibility = False


@change
def no_neighbour(doc):
    doc.Mechanism.Neighbours = []


@change
def all_that_is_visible(doc):
    doc.Mechanism.AllVisible = True


@change
def into_a_group(doc):
    put_into(doc.Group, doc.Box, turn(20, base=V(0, 2, 0)))


@rows
class Mechanisms(Table):
    CHANGES = CHANGES

    def setUp(self):
        super().setUp()
        doc = self.doc
        box, other, wall = self.box(), self.box("Other"), self.box("Wall")
        wall.Placement = shift(60)
        doc.addObject("App::Part", "Group")
        self.line(30)
        motion_from_poses(doc, [0, 1], [shift(40, 12), shift(-40, 12)])
        self.envelope([box], doc.Motion, Resolution=16)
        mechanism.make_mechanism(
            doc,
            MovingParts=[(box, ""), (other, "")],
            Motions=[doc.Motion, doc.Motion001],
            Neighbours=[(wall, "")],
        )
        doc.recompute()
        for obj in self.results():
            self.modules()[obj.Proxy.KIND].compute(obj)
        doc.recompute()

    def test_nothing_changes_nothing(self):
        self.assertEqual({o.Status for o in self.results()}, {UP_TO_DATE})
        self.check_states("nothing")
        self.doc.Box.Label = "Another name"
        self.doc.recompute()
        self.assertEqual({o.Status for o in self.results()}, {UP_TO_DATE})
