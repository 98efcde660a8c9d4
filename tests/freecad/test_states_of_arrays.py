# SPDX-License-Identifier: LGPL-2.1-or-later
"""States of checks whose moving parts and neighbours are link arrays, groups of links and plain
groups, with hidden members. After each change, a check may be up to date only if a fresh
computation gives the same result. gui/shown.py compares the parts that a check uses with those that
FreeCAD draws.
"""
import FreeCAD as App
import numpy as np

from case import Case, shift, turn
from sweptvolume import convert
from sweptvolume.features import clearance, envelope
from sweptvolume.features.base import STALE, UP_TO_DATE
from table_case import Table, add_box, changes, put_into, rows

#: name -> what a user does to the document of StatesOfArrays.setUp().
CHANGES, change = changes()


@change
def an_element_is_hidden(doc):
    doc.Row.setElementVisible("1", False)


@change
def the_original_is_shown(doc):
    doc.Pin.Visibility = True


@change
def an_element_more(doc):
    doc.Row.ElementCount = 4


@change
def an_element_less(doc):
    doc.Row.ElementCount = 2


@change
def an_element_moves(doc):
    doc.Row.PlacementList = [shift(0, 8), shift(0, 17, 3), shift(0, 24)]


@change
def the_original_grows(doc):
    doc.Pin.Height = 5


@change
def the_array_moves(doc):
    doc.Row.Placement = turn(30, base=shift(0, 3).Base)


@change
def the_array_is_in_a_group(doc):
    put_into(doc.Moved, doc.Row)


@change
def an_element_of_the_linked_array_is_hidden(doc):
    doc.Posts.setElementVisible("0", False)


@change
def the_link_of_the_array_is_hidden(doc):
    doc.LinkOfPosts.Visibility = False


@change
def an_element_of_the_group_of_links_is_hidden(doc):
    doc.Several.setElementVisible("Peg", False)


@change
def the_original_of_an_element_is_hidden(doc):
    doc.Peg.Visibility = False


@change
def the_group_of_links_gets_another(doc):
    doc.Several.setLink([doc.Peg, doc.Stop, doc.Spare])


@change
def a_plain_group_is_hidden(doc):
    doc.Plain.Visibility = False


@change
def a_member_of_a_plain_group_is_hidden(doc):
    doc.Loose.Visibility = False


@change
def a_plain_group_in_a_group(doc):
    put_into(doc.Moved, doc.Plain)


@change
def a_group_is_hidden(doc):
    doc.Holder.Visibility = False


@rows
class StatesOfArrays(Table):
    """Three pins in a row move. Around them are a link to an array of two posts, two parts in a group
    of links, one in a plain group, and one in a group with a plain group."""

    CHANGES = CHANGES

    def setUp(self):
        super().setUp()
        doc = self.doc
        pin, post = self.box("Pin", 3), self.box("Post", 2)
        row, posts = doc.addObject("App::Link", "Row"), doc.addObject("App::Link", "Posts")
        row.LinkedObject, posts.LinkedObject = pin, post
        for array, count, place in ((row, 3, shift(0, 8)), (posts, 2, shift(0, 0, 30))):
            array.ShowElement, array.ElementCount = False, count
            step = place.Base
            array.PlacementList = [shift(*(step * (k + 1))) for k in range(count)]
        link = doc.addObject("App::Link", "LinkOfPosts")
        link.LinkedObject = posts
        several = doc.addObject("App::LinkGroup", "Several")
        several.setLink(
            [add_box(doc, "Peg", shift(0, 0, -30)), add_box(doc, "Stop", shift(0, 50, -30))]
        )
        plain, holder = doc.addObject("App::DocumentObjectGroup", "Plain"), doc.addObject(
            "App::Part", "Holder"
        )
        plain.addObject(add_box(doc, "Loose", shift(60)))
        inner = doc.addObject("App::DocumentObjectGroup", "Inner")
        holder.addObject(inner)
        inner.addObject(add_box(doc, "Held", shift(60, 40)))
        add_box(doc, "Spare", shift(0, -60)).Visibility = False
        doc.addObject("App::Part", "Moved")
        for hidden in (pin, post, posts):
            hidden.Visibility = False
        doc.recompute()
        path = self.line()
        self.envelope([row], path, Resolution=20)
        clearance.make_clearance(doc, MovingParts=[(doc.Row, "0.")], Motion=path)
        chosen = [(several, ""), (link, ""), (plain, ""), (holder, "")]
        clearance.make_clearance(
            doc, MovingParts=[(row, "")], Motion=path, AllVisible=False, Neighbours=chosen
        )
        doc.recompute()
        envelope.compute(doc.Envelope)
        for obj in (doc.Clearance, doc.Clearance001):
            clearance.compute(obj)
        doc.recompute()

    def test_nothing_changes_nothing(self):
        self.assertEqual({o.Status for o in self.results()}, {UP_TO_DATE})
        self.check_states("nothing")

    def seen(self):
        """Computes the check with all visible parts again. Returns the places of the parts that it
        names."""
        clearance.compute(self.doc.Clearance)
        return {tuple(r["place"]) for r in clearance.report_of(self.doc.Clearance)["neighbours"]}

    def test_all_that_is_visible_is_checked_and_nothing_else(self):
        doc = self.doc
        every = {("Row", "1."), ("Row", "2."), ("LinkOfPosts", "0."), ("LinkOfPosts", "1.")}
        every |= {("Several", "Peg."), ("Several", "Stop."), ("Plain", "Loose.")}
        every |= {("Holder", "Inner.Held.")}
        self.assertEqual(self.seen(), every)
        for hide, show, place in (
            (
                lambda: doc.Row.setElementVisible("2", False),
                lambda: doc.Row.setElementVisible("2", True),
                ("Row", "2."),
            ),
            (
                lambda: doc.Posts.setElementVisible("0", False),
                lambda: doc.Posts.setElementVisible("0", True),
                ("LinkOfPosts", "0."),
            ),
            (
                lambda: doc.Several.setElementVisible("Peg", False),
                lambda: doc.Several.setElementVisible("Peg", True),
                ("Several", "Peg."),
            ),
        ):
            with self.subTest(place=place):
                hide()
                doc.recompute()
                self.assertEqual(doc.Clearance.Status, STALE)
                self.assertEqual(self.seen(), every - {place})
                show()
                doc.recompute()
                self.assertEqual(doc.Clearance.Status, STALE)
                self.assertEqual(self.seen(), every)
        for whole in (doc.Plain, doc.Inner):
            whole.Visibility = False
            for member in whole.Group:
                member.Visibility = True
        self.assertEqual(self.seen(), every)
        doc.Holder.Visibility = False
        self.assertEqual(self.seen(), every - {("Holder", "Inner.Held.")})


class Shown(Case):
    def test_a_hidden_original_does_not_hide_its_array(self):
        pin = self.box("Pin", 3)
        row = self.doc.addObject("App::Link", "Row")
        row.LinkedObject, row.ShowElement, row.ElementCount = pin, False, 2
        pin.Visibility = False
        self.doc.recompute()
        self.assertEqual([path for _, path in convert.solid_leaves(row, "")], ["0.", "1."])


class Mirrored(Case):
    NEEDS_CORE = True

    def test_a_mirrored_link_faces_outwards(self):
        pin = self.box("Pin")
        pin.Width = 3
        link = self.doc.addObject("App::Link", "Mirror")
        link.LinkedObject, link.ScaleVector = pin, App.Vector(-1, 1, 1)
        self.doc.recompute()
        body = convert.body_from([(link, "")], 0.1)
        corners = body.vertices[body.triangles]
        inside = np.cross(corners[:, 0], corners[:, 1])
        volume = np.einsum("ij,ij->", inside, corners[:, 2]) / 6
        self.assertAlmostEqual(volume, 300.0)
        self.assertAlmostEqual(body.vertices[:, 0].min(), -10.0)
        swept = self.envelope([link], self.line(), Resolution=20)
        envelope.compute(swept)
        self.assertEqual((swept.Status, swept.Message), (UP_TO_DATE, ""))

    def test_a_face_that_is_linked_stands_for_its_part(self):
        pin = self.box("Pin")
        self.box("Wall").Placement = shift(60)
        self.doc.recompute()
        check = clearance.make_clearance(self.doc, MovingParts=[(pin, "Face2")], Motion=self.line())
        self.doc.recompute()
        clearance.compute(check)
        places = [r["place"] for r in clearance.report_of(check)["neighbours"]]
        self.assertEqual(places, [["Wall", ""]])


class PlainGroups(Case):
    """A part in a plain group inside a group with a placement: FreeCAD lists it as a member of both."""

    NEEDS_CORE = True

    def test_such_a_part_is_there_once(self):
        doc = self.doc
        holder, outer, inner = (
            doc.addObject("App::Part", "Holder"),
            doc.addObject("App::DocumentObjectGroup", "Outer"),
            doc.addObject("App::DocumentObjectGroup", "Inner"),
        )
        holder.addObject(outer)
        outer.addObject(inner)
        pin = self.box("Pin")
        inner.addObject(pin)
        link = doc.addObject("App::Link", "Link")
        link.LinkedObject, link.Placement = holder, shift(0, 90)
        doc.recompute()
        self.assertEqual(len(holder.getSubObjects()), 3)
        path = "Outer.Inner.Pin."
        for root in (holder, link):
            self.assertEqual([place for _, place in convert.leaves(root)], [path])
        whole = convert.pairs_of([(pin, "Face1"), (holder, "Pin."), (link, "Pin.")])
        self.assertEqual(whole, [(holder, path), (holder, path), (link, path)])
        check = clearance.make_clearance(doc, MovingParts=[(pin, "")], Motion=self.line())
        swept = self.envelope([holder], doc.Motion, Resolution=20)
        clearance.compute(check)
        envelope.compute(swept)
        places = [r["place"] for r in clearance.report_of(check)["neighbours"]]
        self.assertEqual(places, [["Link", path]])  # not the part itself
        self.assertEqual((swept.Status, swept.Message), (UP_TO_DATE, ""))
        # A plain group chosen as the moving part moves its members.
        check.MovingParts = [(outer, "")]
        doc.recompute()
        clearance.compute(check)
        places = [r["place"] for r in clearance.report_of(check)["neighbours"]]
        self.assertEqual(places, [["Link", path]])
