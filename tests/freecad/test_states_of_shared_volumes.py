# SPDX-License-Identifier: LGPL-2.1-or-later
"""States of shared volumes: of parts, of a moving part at one time, of envelopes and links. After each
change of the table, a result may be up to date only if a fresh computation gives the same result.
"""
import FreeCAD as App

from case import V, shift, turn
from sweptvolume import convert
from sweptvolume.features import envelope, shared
from sweptvolume.features.base import FAILED, UP_TO_DATE
from table_case import Table, add_box, changes, hidden_link, put_into, rows

#: name -> what a user does to the document of States.setUp().
CHANGES, change = changes()


# --- the sides


@change
def a_side_grows(doc):
    doc.Box.Length = 12


@change
def a_side_grows_where_nothing_is_shared(doc):
    doc.Wall.Height = 14


@change
def a_side_moves(doc):
    doc.Wall.Placement = shift(7, 1, 1)


@change
def a_side_turns(doc):
    doc.Wall.Placement = turn(20, base=V(6, 1, 1))


@change
def a_side_goes_away(doc):
    doc.Wall.Placement = shift(60)


@change
def a_side_is_deleted(doc):
    doc.removeObject("Wall")


@change
def a_side_is_hidden(doc):
    doc.Wall.Visibility = False


@change
def a_side_has_another_name(doc):
    doc.Wall.Label = "Gate"


@change
def both_sides_have_one_name(doc):
    doc.Wall.Label = doc.Box.Label = "Twin"


@change
def a_side_is_in_a_group(doc):
    put_into(doc.addObject("App::Part", "Group"), doc.Wall, shift())


@change
def a_side_is_in_a_group_that_stands_elsewhere(doc):
    put_into(doc.addObject("App::Part", "Group"), doc.Wall)


@change
def both_sides_are_in_a_group_that_turns(doc):
    group = doc.addObject("App::Part", "Group")
    for obj in (doc.Box, doc.Wall):
        group.addObject(obj)
    doc.recompute()
    group.Placement = turn(30)


@change
def the_volume_is_in_a_group_that_stands_elsewhere(doc):
    put_into(doc.addObject("App::Part", "Group"), doc.SharedVolume)


@change
def a_side_is_a_link(doc):
    doc.SharedVolume.Neighbours = [(doc.Link, "")]


@change
def a_link_shows_another_part(doc):
    doc.SharedVolume.Neighbours = [(doc.Link, "")]
    doc.recompute()
    doc.Link.LinkedObject = doc.Post


@change
def a_link_shows_nothing(doc):
    doc.SharedVolume.Neighbours = [(doc.Link, "")]
    doc.recompute()
    doc.Link.LinkedObject = None


@change
def a_side_more(doc):
    doc.SharedVolume.Neighbours = [(doc.Wall, ""), (doc.Post, "")]


@change
def no_second_side(doc):
    doc.SharedVolume.Neighbours = []


@change
def one_part_on_both_sides(doc):
    doc.SharedVolume.Neighbours = [(doc.Wall, ""), (doc.Box, "")]


@change
def the_sides_the_other_way_round(doc):
    obj = doc.SharedVolume
    obj.MovingParts, obj.Neighbours = obj.Neighbours, obj.MovingParts


@change
def something_new(doc):
    add_box(doc, "Fresh", shift(3, 3, 3))


# --- motions, envelopes, settings


@change
def another_time(doc):
    doc.SharedVolume001.Time = 0.6


@change
def a_time_behind_the_end(doc):
    doc.SharedVolume001.Time = 9


@change
def time_by_an_expression(doc):
    doc.SharedVolume001.setExpression("Time", "Values.at")


@change
def a_value_of_an_expression(doc):
    doc.Values.set("A1", "0.75")


@change
def the_motion_goes_farther(doc):
    doc.Motion.Placements = [shift(), shift(34)]


@change
def the_motion_goes_another_way(doc):
    doc.Motion.Placements = [shift(), turn(40, base=V(30, 0, 0))]
    doc.Motion.Interpolation = "Screw"


@change
def the_motion_turns_about_another_point(doc):
    doc.Motion.Pivot = V(0, 0, 5)


@change
def the_motion_is_deleted(doc):
    doc.removeObject("Motion")


@change
def no_motion(doc):
    doc.SharedVolume001.Motion = None


@change
def the_other_side_moves_too(doc):
    doc.SharedVolume001.NeighbourMotion = doc.Motion


@change
def the_envelope_is_finer(doc):
    doc.Envelope.Resolution = 20


@change
def the_envelope_stands_elsewhere(doc):
    doc.Envelope.Placement = shift(0, 3)


@change
def coarser(doc):
    doc.SharedVolume.MeshDeflection = 0.2


@change
def the_volume_is_moved(doc):
    doc.SharedVolume.Placement = shift(0, 0, 4)


@rows
class States(Table):
    CHANGES = CHANGES

    def setUp(self):
        super().setUp()
        doc = self.doc
        box, wall, post = self.box(), self.box("Wall"), self.box("Post", 6)
        wall.Placement, post.Placement = shift(6, 1, 1), shift(34, 2, 2)
        hidden_link(doc, "Link", wall)
        self.sheet("at", "0.5")
        self.line(30)
        self.envelope([box], doc.Motion, Resolution=12)
        envelope.compute(doc.Envelope)
        sides = [[convert.root_path(obj)] for obj in (box, wall, post, doc.Envelope)]
        first, second, third, swept = sides
        shared.make_shared(doc, first, second)
        shared.make_shared(doc, first, third, Motion=doc.Motion, Time=0.9)
        shared.make_shared(doc, swept, third)
        doc.recompute()
        for obj in self.results():
            shared.compute(obj)
        doc.recompute()

    def results(self):
        """Tests the shared volumes only; envelopes have tables of their own."""
        return [obj for obj in super().results() if shared.is_shared(obj)]

    def test_nothing_changes_nothing(self):
        self.assertEqual({o.Status for o in self.results()}, {UP_TO_DATE})
        self.assertEqual(len(self.results()), 3)
        self.assertTrue(all(o.Volume.Value > 1 for o in self.results()))
        self.check_states("nothing")

    def test_an_envelope_that_is_computed_anew(self):
        self.doc.Envelope.Resolution = 20
        self.doc.recompute()
        envelope.compute(self.doc.Envelope)
        self.doc.recompute()
        self.check_states("computed")
        self.assertNotEqual(self.doc.SharedVolume002.Status, UP_TO_DATE)
        self.doc.undo()
        self.doc.Envelope.Resolution = 12
        self.doc.recompute()
        self.check_states("undone")
        self.assertEqual({o.Status for o in self.results()}, {UP_TO_DATE})

    def test_a_side_of_another_document(self):
        there = App.newDocument("Elsewhere")
        block = add_box(there, "Block", shift())
        there.recompute()
        there.saveAs(self.folder + "/elsewhere.FCStd")
        self.doc.saveAs(self.folder + "/here.FCStd")
        link, obj = self.doc.addObject("App::Link", "There"), self.doc.SharedVolume
        link.LinkedObject, link.Placement = block, shift(4, 4, 4)
        obj.Neighbours = [(link, "")]
        self.doc.recompute()
        shared.compute(obj)
        self.check_states("a side of another document")
        block.Length = 5
        there.recompute()
        self.doc.recompute()
        self.check_states("it has shrunk there")
        self.assertNotEqual(obj.Status, UP_TO_DATE)
        block.Length = 10
        there.recompute()
        self.doc.recompute()
        self.assertEqual(obj.Status, UP_TO_DATE)
        App.closeDocument("Elsewhere")
        self.doc.recompute()
        self.assertEqual(obj.Status, FAILED)
        self.assertTrue(obj.Message)
