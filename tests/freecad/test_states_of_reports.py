# SPDX-License-Identifier: LGPL-2.1-or-later
"""The page of a check after each change of the document: its names, verdicts, rules, inputs and colours are
those of a page after a fresh computation. A result that is not up to date gives no page.
"""
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.realpath(__file__)), "..", "python"))
from page_check import cells, data  # noqa: E402

from case import shift, turn  # noqa: E402
from sweptvolume import core, page  # noqa: E402
from sweptvolume.convert import InputProblem  # noqa: E402
from sweptvolume.features import clearance, mechanism, neighbour_rules  # noqa: E402
from sweptvolume.features import pair_rules  # noqa: E402
from sweptvolume.features.base import UP_TO_DATE  # noqa: E402
from sweptvolume.features.neighbour_rules import CONTACT, IGNORE, Rule  # noqa: E402
from table_case import Table, add_box, changes, put_into, rows  # noqa: E402

CHANGES, change = changes()


# --- names


@change
def the_neighbour_has_another_name(doc):
    doc.Wall.Label = "Gate"


@change
def neighbours_exchange_their_names(doc):
    doc.Wall.Label, doc.Post.Label = "Name", "Wall"
    doc.Wall.Label = "Post"


@change
def two_neighbours_have_one_name(doc):
    doc.Post.Label = doc.Wall.Label = "Twin"


@change
def an_ignored_neighbour_has_another_name(doc):
    doc.Table.Label = "Bench"


@change
def the_moving_part_has_another_name(doc):
    doc.Box.Label = "Slider"


@change
def the_motion_has_another_name(doc):
    doc.Motion.Label = "There and back"


@change
def the_envelope_has_another_name(doc):
    doc.Envelope.Label = "Room of the box"


@change
def the_checks_have_other_names(doc):
    doc.Clearance.Label, doc.Mechanism.Label = "First", "Second"


@change
def the_group_has_another_name(doc):
    doc.Group.Label = "Frame"


# --- contents


@change
def the_neighbour_grows(doc):
    doc.Wall.Height = 12


@change
def the_neighbour_is_hidden(doc):
    doc.Post.Visibility = False


@change
def the_neighbour_is_in_a_group(doc):
    put_into(doc.Group, doc.Wall, shift())


@change
def the_neighbour_is_in_a_group_that_stands_elsewhere(doc):
    put_into(doc.Group, doc.Wall)


@change
def the_neighbour_leaves_its_group(doc):
    doc.Group.removeObject(doc.Inner)


@change
def the_neighbour_is_gone(doc):
    doc.removeObject("Post")


@change
def one_more_neighbour(doc):
    add_box(doc, "More", shift(0, 0, 50))


@change
def the_part_turns(doc):
    doc.Motion.Placements = [shift(), turn(40)]


@change
def later(doc):
    doc.Motion.Times = [1, 3]


@change
def the_envelope_is_finer(doc):
    doc.Envelope.Resolution = 20


# --- rules


@change
def required(doc):
    doc.Clearance.RequiredDistance = doc.Mechanism.RequiredDistance = 25


@change
def required_by_an_expression(doc):
    for name in ("Clearance", "Mechanism"):
        doc.getObject(name).setExpression("RequiredDistance", "Values.length")


@change
def contact_is_allowed(doc):
    neighbour_rules.write(doc.Clearance, {(doc.Wall, ""): Rule(CONTACT)})
    pair = pair_rules.key((doc.Box, ""), (doc.Wall, ""))
    pair_rules.write(doc.Mechanism, {pair: Rule(CONTACT)})


@change
def a_neighbour_is_ignored(doc):
    neighbour_rules.write(doc.Clearance, {(doc.Post, ""): Rule(IGNORE)})


@rows
class Reports(Table):
    CHANGES = CHANGES

    def setUp(self):
        super().setUp()
        doc = self.doc
        box = self.box()
        for name, place in (("Wall", shift(43.5)), ("Post", shift(0, 22))):
            add_box(doc, name, place)
        table = add_box(doc, "Table", shift(0, 0, -10.1))
        group = doc.addObject("App::Part", "Group")
        group.addObject(add_box(doc, "Inner", shift(0, -30)))
        self.sheet("length", "8 mm")
        self.line()
        self.envelope([box], doc.Motion, Resolution=16)
        clearance.make_clearance(doc, Envelope=doc.Envelope, AllVisible=True, RequiredDistance=5.0)
        mechanism.make_mechanism(
            doc,
            MovingParts=[(box, "")],
            Motions=[doc.Motion],
            AllVisible=True,
            RequiredDistance=5.0,
        )
        neighbour_rules.write(doc.Clearance, {(table, ""): Rule(IGNORE)})
        pair_rules.write(doc.Mechanism, {pair_rules.key((box, ""), (table, "")): Rule(IGNORE)})
        doc.recompute()
        for obj in self.computed():
            self.modules()[obj.Proxy.KIND].compute(obj)
        doc.recompute()

    def computed(self):
        return self.doc.Envelope, self.doc.Clearance, self.doc.Mechanism

    def results(self):
        """In a fresh document, computes the envelope before the check that uses it."""
        return [
            obj for obj in self.doc.Objects if obj.Name in ("Envelope", "Clearance", "Mechanism")
        ]

    def content(self, obj):
        if obj.Name == "Envelope":
            return super().content(obj)
        text = page.text(page.request(obj), core.Control())
        tables = [cells(text, name)[1:] for name in ("verdicts", "rules", "inputs")]
        tables[2] = [row for row in tables[2] if row[0] != "document"]
        if core.has_page_view():
            seen = data(text, "scene")["parts"]
            tables.append([(part["name"], part["kind"], part["verdict"]) for part in seen])
        return [obj.Label, obj.Summary] + [sorted(map(tuple, rows)) for rows in tables]

    def check_states(self, name):
        super().check_states(name)
        for obj in self.results():
            if obj.Status != UP_TO_DATE and obj.Name != "Envelope":
                with self.subTest(change=name, result=obj.Name):
                    with self.assertRaisesRegex(InputProblem, "up to date"):
                        page.request(obj)

    def test_a_name_counts_at_once(self):
        """FreeCAD does not recompute after this change."""
        self.doc.Wall.Label = "Gate"
        self.assertIn("(Gate)", self.doc.Clearance.Summary)
        self.assertIn("Gate", self.doc.Mechanism.Summary)
        rows = clearance.report_of(self.doc.Clearance)["neighbours"]
        self.assertEqual({row["name"] for row in rows}, {"Gate", "Post", "Inner"})

    def test_a_page_that_tells_of_before_is_seen(self):
        """The table above fails for a wrong page."""
        kept = self.content(self.doc.Clearance)
        self.doc.Wall.Placement = shift(50)
        self.doc.recompute()
        clearance.compute(self.doc.Clearance)
        self.assertNotEqual(self.content(self.doc.Clearance), kept)
