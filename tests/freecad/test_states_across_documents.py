# SPDX-License-Identifier: LGPL-2.1-or-later
"""States of mechanism checks, sequences, shared volumes, studies and records of what made an envelope, whose
parts, neighbours and values are in another document. After each change, in either document, a result may be
up to date only if a fresh computation gives what the result shows.
"""
import os

import FreeCAD as App

from case import shift, turn
from other_document_case import COMMON_CHANGES, OtherDocumentTable, elsewhere
from shaft import plan_of, shaft, stack
from sweptvolume.features import clearance, mechanism, sequence, shared, study
from sweptvolume.features.base import FAILED, UP_TO_DATE
from table_case import add_box, changes, put_into, rows

CHANGES, change = changes(COMMON_CHANGES)


# --- changes in the other document


@change
def the_part_grows_by_an_expression(doc):
    elsewhere().Part.setExpression("Height", "Values.length")


@change
def the_obstacle_grows(doc):
    elsewhere().Wall.Height = 14


@change
def the_obstacle_is_deleted_there(doc):
    elsewhere().removeObject("Wall")


@change
def a_part_of_the_group_has_another_name(doc):
    elsewhere().Inner.Label = "Another name"


@change
def other_names_there(doc):
    for name in ("Part", "Wall", "Group", "Block"):
        getattr(elsewhere(), name).Label = "Another " + name


@change
def the_block_of_the_shaft_is_too_large(doc):
    elsewhere().Block.Length = 20.5


@change
def the_block_of_the_shaft_is_smaller(doc):
    elsewhere().Block.Length = 17


@change
def the_block_is_in_a_group_there(doc):
    other = elsewhere()
    put_into(other.addObject("App::Part", "Outer"), other.Block)


# --- changes in this document


@change
def other_names_here(doc):
    for name in ("PartLink", "WallLink", "GroupLink", "BlockLink"):
        getattr(doc, name).Label = "Another " + name


@change
def the_obstacle_turns_here(doc):
    doc.WallLink.Placement = turn(20, base=shift(34, 2, 2).Base)


@change
def the_links_are_in_a_group(doc):
    group = doc.addObject("App::Part", "Here")
    for name in ("PartLink", "WallLink"):
        group.addObject(doc.getObject(name))


@change
def the_link_is_in_a_group_that_stands_elsewhere(doc):
    put_into(doc.addObject("App::Part", "Here"), doc.PartLink)


@change
def the_block_stands_elsewhere(doc):
    doc.BlockLink.Placement = shift(-9, -9, 12.5)


@change
def the_motion_goes_farther(doc):
    doc.Motion.Placements = [shift(), shift(33)]


@change
def the_motion_is_later(doc):
    doc.Motion.Times = [1, 2]


@rows
class AcrossDocuments(OtherDocumentTable):
    CHANGES = CHANGES

    def setUp(self):
        super().setUp()
        self.make_other()
        doc, other = self.doc, elsewhere()
        doc.saveAs(os.path.join(self.folder, "here.FCStd"))
        walls, (upper, lower) = shaft(doc), stack(doc)
        doc.removeObject(upper.Name)
        for name, target, place in (
            ("PartLink", other.Part, shift(0, 60)),
            ("WallLink", other.Wall, shift(34, 62, 2)),
            ("GroupLink", other.Group, shift(0, 160)),
            ("BlockLink", other.Block, shift(-9, -9, 11)),
        ):
            link = doc.addObject("App::Link", name)
            link.LinkedObject, link.Placement = target, place
        box = add_box(doc, "Box", shift(0, 0, 90))
        box.setExpression("Length", "Elsewhere#Values.length")
        doc.recompute()
        line, part, wall = self.line(30), (doc.PartLink, ""), (doc.WallLink, "")
        line.PoseType = "Relative"
        self.envelope([doc.PartLink, doc.GroupLink, box], line, Resolution=16, MadeBy="Document")
        mechanism.make_mechanism(
            doc,
            MovingParts=[part, (box, "")],
            Motions=[line, line],
            Neighbours=[wall, (doc.GroupLink, "")],
        )
        shared.make_shared(doc, [part], [wall], Motion=line, Time=0.9)
        clearance.make_clearance(
            doc,
            MovingParts=[(doc.GroupLink, "")],
            Motion=line,
            Neighbours=[wall],
            AllVisible=False,
        )
        study.make_study(
            doc, Sources=[doc.Clearance], Folder=os.path.join(self.folder, "study"), Jobs=1
        )
        sequence.find(plan_of(doc, [doc.BlockLink, lower], walls, Order="find"))
        doc.recompute()
        for obj in self.results():
            self.modules()[obj.Proxy.KIND].compute(obj)
        doc.recompute()
        doc.save()

    def make_other(self):
        """Creates the document Elsewhere."""
        other = App.newDocument("Elsewhere")
        other.UndoMode = 1
        for name in ("Part", "Wall"):
            add_box(other, name, shift())
        block = add_box(other, "Block", shift())
        block.Length, block.Width, block.Height = 18, 18, 9
        group = other.addObject("App::Part", "Group")
        for name, y in (("Inner", -20), ("Second", -40)):
            group.addObject(add_box(other, name, shift(0, y)))
        sheet = other.addObject("Spreadsheet::Sheet", "Values")
        sheet.set("A1", "6 mm")
        sheet.setAlias("A1", "length")
        other.recompute()
        other.saveAs(os.path.join(self.folder, "Elsewhere.FCStd"))

    def content(self, obj):
        """Adds the summary line of each check."""
        return super().content(obj) + [getattr(obj, "Summary", "")]

    def test_nothing_changes_nothing(self):
        self.assertEqual(self.behind(), {})
        self.assertEqual(len(self.results()), 6)
        self.assertGreater(self.doc.SharedVolume.Volume.Value, 1)
        self.check_states("nothing")

    def test_closed_and_opened_again(self):
        path = elsewhere().FileName
        App.closeDocument("Elsewhere")
        self.doc.recompute()
        self.assertEqual({obj.Status for obj in self.results()}, {FAILED})
        self.assertTrue(all(obj.Message for obj in self.results()))
        App.openDocument(path)
        self.recomputed()
        self.assertEqual(self.behind(), {})
        self.check_states("opened again")

    def test_both_closed_and_opened(self):
        self.doc.save()
        path, before = self.doc.FileName, self.record(self.doc.Envelope)
        for name in (self.doc.Name, "Elsewhere"):
            App.closeDocument(name)
        self.doc = App.openDocument(path)
        self.assertEqual(self.behind(), {})
        self.recomputed()
        self.assertEqual({obj.Status for obj in self.results()}, {UP_TO_DATE})
        self.assertEqual(self.record(self.doc.Envelope), before)
        self.check_states("opened")
