# SPDX-License-Identifier: LGPL-2.1-or-later
"""Table: every input of a study, of the document and of a file, changed in every way; the state afterwards is
what a fresh computation justifies."""
import os

from case import shift, turn
from sweptvolume.features import clearance, neighbour_rules, study
from sweptvolume.features.base import UP_TO_DATE
from sweptvolume.features.neighbour_rules import CONTACT, Rule
from table_case import Table, changes, rows

CHANGES, change = changes()


@change
def part_grows(doc):
    doc.Box.Length = 12


@change
def wall_moves(doc):
    doc.Wall.Placement = shift(55)


@change
def wall_is_gone(doc):
    doc.removeObject("Wall")


@change
def motion_goes_farther(doc):
    doc.Motion.Placements = [shift(), shift(33)]


@change
def motion_between_poses(doc):
    doc.Motion.Placements = [shift(), turn(90, base=shift(20).Base)]
    doc.Motion.Interpolation = "Screw"


@change
def check_asks_for_more(doc):
    doc.Clearance.Required = 25


@change
def check_has_another_rule(doc):
    neighbour_rules.write(doc.Clearance, {(doc.Wall, ""): Rule(CONTACT)})


@change
def check_sees_all(doc):
    doc.Clearance.AllVisible = True


@change
def envelope_is_finer(doc):
    doc.Envelope.Resolution = 20


@change
def envelope_is_grown(doc):
    doc.Envelope.Offset = 1.0


@change
def envelope_is_no_source(doc):
    doc.Study.Sources = [doc.Clearance]


@change
def the_other_way_round(doc):
    doc.Study.Sources = [doc.Envelope, doc.Clearance]


@change
def more_jobs(doc):
    doc.Study.Jobs = 2


@change
def a_source_is_gone(doc):
    doc.removeObject("Clearance")


@change
def no_source(doc):
    doc.Study.Sources = []


@change
def a_part_is_a_source(doc):
    doc.Study.Sources = [doc.Box]


@rows
class OfADocument(Table):
    CHANGES = CHANGES

    def setUp(self):
        super().setUp()
        doc = self.doc
        box, wall = self.box(), self.box("Wall")
        wall.Placement = shift(60)
        self.line(30)
        self.envelope([box], doc.Motion, Resolution=16)
        clearance.make_clearance(
            doc,
            Generators=[(box, "")],
            Motion=doc.Motion,
            Neighbours=[(wall, "")],
            AllVisible=False,
            Required=5.0,
        )
        study.make_study(
            doc,
            Sources=[doc.Clearance, doc.Envelope],
            Folder=os.path.join(self.folder, "study"),
            Jobs=1,
        )
        doc.recompute()
        study.compute(doc.Study)
        doc.recompute()

    def results(self):
        """The study alone: what it is made of has tables of its own."""
        return [obj for obj in super().results() if study.is_study(obj)]

    def test_nothing_changes_nothing(self):
        self.assertEqual({o.Status for o in self.results()}, {UP_TO_DATE})
        self.look("nothing")
        self.doc.Box.Label = "Another name"
        self.doc.recompute()
        self.look("label of a part")
        self.assertEqual(self.doc.Study.Status, UP_TO_DATE)
