# SPDX-License-Identifier: LGPL-2.1-or-later
"""States (up to date, stale, failed) of results whose inputs are in another document.

The inputs are parts, neighbours, wires, envelopes and values. Each function marked `change` makes one
change: to an input, in either document, or to the other document itself, which is closed, changed while
it is closed, saved under another name or renamed. A result may be up to date afterwards only if a fresh
computation gives the same result.
"""
import os
import time

import FreeCAD as App
import Part

from case import V, shift, turn
from other_document_case import COMMON_CHANGES, OtherDocumentTable, elsewhere
from sweptvolume.features import clearance, envelope, motion
from sweptvolume.features.base import FAILED, UP_TO_DATE
from table_case import add_box, changes, put_into, rows

CHANGES, change = changes(COMMON_CHANGES)


# --- changes in the other document


@change
def the_part_moves_there(doc):
    elsewhere().Part.Placement = shift(0, 5)  # a link has its own placement


@change
def the_neighbour_grows(doc):
    elsewhere().Wall.Height = 14


@change
def the_neighbour_has_another_form(doc):
    elsewhere().Plate.Shape = Part.makeBox(20, 4, 2).cut(Part.makeCylinder(1, 2, V(15, 2, 0)))


@change
def the_wire_is_bent(doc):
    elsewhere().Wire.Shape = Part.makePolygon([V(), V(20, 0, 0), V(20, 9, 0)])


@change
def the_wire_moves_there(doc):
    elsewhere().Wire.Placement = shift(0, 4)


@change
def a_part_of_the_group_is_deleted(doc):
    elsewhere().removeObject("Second")


@change
def the_group_moves_there(doc):
    elsewhere().Group.Placement = turn(15)


@change
def the_group_is_in_another_group(doc):
    other = elsewhere()
    put_into(other.addObject("App::Part", "Outer"), other.Group)


@change
def the_part_is_in_a_group(doc):
    other = elsewhere()
    put_into(other.addObject("App::Part", "Outer"), other.Part)


@change
def the_neighbour_is_deleted_there(doc):
    elsewhere().removeObject("Wall")


@change
def the_envelope_moves_there(doc):
    elsewhere().Envelope.Placement = shift(0, 0, 3)


@change
def the_envelope_is_computed_anew(doc):
    elsewhere().Tool.Height = 7
    elsewhere().recompute()
    envelope.compute(elsewhere().Envelope)


@change
def other_names_there(doc):
    for name in ("Part", "Wall", "Wire", "Group", "Envelope"):
        getattr(elsewhere(), name).Label = "Another " + name


@change
def something_new_there(doc):
    add_box(elsewhere(), "Fresh", shift(0, 0, 90))


# --- changes in this document


@change
def the_link_is_scaled(doc):
    doc.GroupLink.Scale = 2


@change
def the_neighbour_is_moved_here(doc):
    doc.WallLink.Placement = shift(50)


@change
def the_neighbour_is_hidden(doc):
    doc.WallLink.Visibility = False


@change
def the_link_is_in_a_group(doc):
    put_into(doc.addObject("App::Part", "Here"), doc.PartLink)


@change
def the_wire_is_another(doc):
    doc.WireLink.LinkedObject = elsewhere().OtherWire


@change
def the_neighbour_is_the_envelope(doc):
    doc.Clearance001.Neighbours = [(doc.EnvelopeLink, "")]


@change
def the_envelope_stands_elsewhere_here(doc):
    doc.EnvelopeLink.Placement = shift(0, 70)


@change
def the_expression_is_another(doc):
    doc.Box.setExpression("Length", "Elsewhere#Values.length * 2")


@rows
class OtherDocuments(OtherDocumentTable):
    CHANGES = CHANGES

    def setUp(self):
        super().setUp()
        self.make_other()
        doc, other = self.doc, elsewhere()
        self.path = os.path.join(self.folder, "here.FCStd")
        doc.saveAs(self.path)
        for name, target, place in (
            ("PartLink", other.Part, shift()),
            ("GroupLink", other.Group, shift()),
            ("WallLink", other.Wall, shift(60)),
            ("PlateLink", other.Plate, shift(0, 40)),
            ("WireLink", other.Wire, shift()),
            ("EnvelopeLink", other.Envelope, shift(0, 60)),
        ):
            link = doc.addObject("App::Link", name)
            link.LinkedObject, link.Placement = target, place
        box = self.box()
        box.Placement = shift(0, 0, 30)
        box.setExpression("Length", "Elsewhere#Values.length")
        doc.recompute()
        path = motion.motion_from_source(doc, "Curve", [doc.WireLink])
        line = self.line(20.0)
        self.envelope([doc.PartLink, doc.GroupLink, box], path, Resolution=16)
        clearance.make_clearance(doc, MovingParts=[(doc.PartLink, "")], Motion=path)
        clearance.make_clearance(
            doc,
            MovingParts=[(box, "")],
            Motion=line,
            Neighbours=[(doc.WallLink, ""), (doc.EnvelopeLink, "")],
            AllVisible=False,
        )
        doc.recompute()
        envelope.compute(doc.Envelope)
        for check in (doc.Clearance, doc.Clearance001):
            clearance.compute(check)
        doc.recompute()
        doc.save()

    def make_other(self):
        """Creates the document Elsewhere."""
        other = App.newDocument("Elsewhere")
        other.UndoMode = 1
        self.file_there = os.path.join(self.folder, "Elsewhere.FCStd")
        for name, place in (("Part", shift()), ("Wall", shift()), ("Tool", shift())):
            add_box(other, name, place)
        plate = other.addObject("Part::Feature", "Plate")
        plate.Shape = Part.makeBox(20, 4, 2)
        for name, end in (("Wire", V(20, 0, 0)), ("OtherWire", V(0, 0, 20))):
            wire = other.addObject("Part::Feature", name)
            wire.Shape = Part.makeLine(V(), end)
        sheet = other.addObject("Spreadsheet::Sheet", "Values")
        sheet.set("A1", "6 mm")
        sheet.setAlias("A1", "length")
        group = other.addObject("App::Part", "Group")
        for name, y in (("Inner", -20), ("Second", -40)):
            group.addObject(add_box(other, name, shift(0, y)))
        line = motion.motion_from_poses(other, [0, 1], [shift(), shift(15)])
        obj = envelope.make_envelope(other, [(other.Tool, "")], line, Resolution=12)
        other.recompute()
        envelope.compute(obj)
        other.recompute()
        other.saveAs(self.file_there)

    def test_nothing_changes_nothing(self):
        self.assertEqual(self.behind(), {})
        self.check_states("nothing")

    # --- the other document is closed and opened

    def test_closed_and_opened_again(self):
        App.closeDocument("Elsewhere")
        self.doc.recompute()
        for obj in (self.doc.Envelope, self.doc.Clearance001):
            self.assertEqual(obj.Status, FAILED, obj.Label)
            self.assertTrue(obj.Message)
        App.openDocument(self.file_there)
        self.recomputed()
        self.assertEqual(self.behind(), {})
        self.check_states("opened again")

    def test_changed_while_this_document_is_closed(self):
        elsewhere().Wall.Height = 14
        elsewhere().recompute()
        time.sleep(1.1)  # FreeCAD knows a changed file by its time of saving, in whole seconds
        elsewhere().save()
        self.opened_again()
        self.recomputed()
        self.check_states("the neighbour has grown meanwhile")
        self.assertNotEqual(self.doc.Clearance001.Status, UP_TO_DATE)
        self.assertEqual(self.doc.Envelope.Status, UP_TO_DATE)

    def test_changes_that_are_thrown_away(self):
        elsewhere().Part.Length = 14
        self.recomputed()
        self.assertNotEqual(self.doc.Envelope.Status, UP_TO_DATE)
        App.closeDocument("Elsewhere")
        App.openDocument(self.file_there)
        self.recomputed()
        self.assertEqual(self.behind(), {})
        self.check_states("the part has its former length again")

    def test_both_closed_and_opened(self):
        self.opened_again()
        self.assertEqual(self.behind(), {})
        self.check_states("opened")
        self.recomputed()
        self.check_states("opened and recomputed")

    def opened_again(self):
        """Both documents are closed. This one is opened, and FreeCAD opens the other one with it."""
        for name in (self.doc.Name, "Elsewhere"):
            App.closeDocument(name)
        self.doc = App.openDocument(self.path)

    def test_saved_elsewhere(self):
        moved = os.path.join(self.folder, "moved.FCStd")
        elsewhere().saveAs(moved)
        elsewhere().Label = "Moved"
        self.recomputed()
        self.assertEqual(self.behind(), {})
        self.check_states("saved elsewhere")
        elsewhere().Part.Length = 12
        self.recomputed()
        self.assertNotEqual(self.doc.Envelope.Status, UP_TO_DATE)
        self.check_states("changed there")

    def test_the_file_is_gone(self):
        for name in (self.doc.Name, "Elsewhere"):
            App.closeDocument(name)
        os.rename(self.file_there, os.path.join(self.folder, "renamed.FCStd"))
        self.doc = App.openDocument(self.path)
        self.doc.recompute()
        for obj in (self.doc.Envelope, self.doc.Clearance001):
            self.assertEqual(obj.Status, FAILED, obj.Label)
            self.assertTrue(obj.Message)
        os.rename(os.path.join(self.folder, "renamed.FCStd"), self.file_there)
        self.doc.save()
        App.closeDocument(self.doc.Name)
        self.doc = App.openDocument(self.path)
        self.recomputed()
        self.assertEqual(self.behind(), {})
