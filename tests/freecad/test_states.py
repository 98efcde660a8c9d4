# SPDX-License-Identifier: LGPL-2.1-or-later
"""States of all kinds of results. Each function marked `change` changes one input. Afterwards a
result may be up to date only if a fresh computation gives the same result; the test computes it in
a copy of the document.
"""
import os

import FreeCAD as App
import Part

from case import Case, V, shift, turn
from sweptvolume.features import clearance, envelope, motion, solid
from sweptvolume.features.base import FAILED, STALE, UP_TO_DATE
from table_case import Table, add_box, changes, put_into, rows

#: name -> what a user does to the document of States.setUp().
CHANGES, change = changes()


# --- properties of parts


@change
def part_grows(doc):
    doc.Box.Length = 12


@change
def part_moves(doc):
    doc.Box.Placement = shift(0, 3)


@change
def hole_moves(doc):
    doc.Plate.Shape = Part.makeBox(30, 12, 2).cut(Part.makeCylinder(2, 2, V(20, 6, 0)))


@change
def part_turns_mesh(doc):
    import Mesh

    doc.Net.Mesh = Mesh.createBox(4, 4, 5)


@change
def mesh_placed(doc):
    doc.Net.Placement = shift(0, 0, 41)


@change
def wall_moves(doc):
    doc.Wall.Placement = shift(55)


@change
def wall_is_hidden(doc):
    doc.Wall.Visibility = False


@change
def hidden_part_is_shown(doc):
    doc.Hidden.Visibility = True


@change
def hidden_part_moves(doc):
    doc.Hidden.Placement = shift(0, -90)


@change
def new_part(doc):
    add_box(doc, "Fresh", shift(0, 0, 90))


@change
def part_gone(doc):
    doc.removeObject("Wall")


@change
def label_only(doc):
    doc.Box.Label, doc.Wall.Label = "Another name", "A wall"


# --- motion


@change
def pose_moves(doc):
    doc.Motion.Placements = [shift(), shift(22)]


@change
def times_change(doc):
    doc.Motion.Times = [0, 2]


@change
def interpolation_changes(doc):
    doc.Motion.Interpolation = "Screw"


@change
def frame_changes(doc):
    doc.Motion.PoseType = "RelativeToFirst"


@change
def motion_is_deleted(doc):
    doc.removeObject("Motion")


@change
def other_motion(doc):
    doc.Envelope.Motion = doc.Motion001


@change
def wire_of_the_other_motion(doc):
    doc.Wire.Shape = Part.makePolygon([V(), V(20, 0, 0), V(20, 9, 0)])


@change
def wire_is_deleted(doc):
    doc.removeObject("Wire")


@change
def turned_about_a_pivot(doc):
    doc.Motion.Placements, doc.Motion.Pivot = [shift(), turn(60)], V(5, 5, 5)


@change
def pivot_by_expression(doc):
    doc.Motion.Placements = [shift(), turn(60)]
    doc.Motion.setExpression("Pivot.x", "Values.length")


@change
def smooth_with_velocities(doc):
    doc.Motion.Interpolation = "Spline"
    doc.Motion.Tangents, doc.Motion.Velocities = ["Given", "Stop"], [V(0, 30, 0), V()]


@change
def source_turns(doc):
    doc.Motion001.SourceOrientation = "Tangent"


@change
def source_lasts(doc):
    doc.Motion001.SourceDuration = 3


@change
def source_counts(doc):
    doc.Motion001.SourceCount = 5


@change
def source_by_expression(doc):
    doc.Motion001.setExpression("SourceDuration", "Values.length / 1 mm")


@change
def source_is_cut(doc):
    motion.make_stored(doc.Motion001)


@change
def wire_moves(doc):
    doc.Wire.Placement = shift(0, 5)


@change
def wire_into_a_group(doc):
    put_into(doc.Group, doc.Wire, turn(10, base=V(0, 2, 0)))


@change
def part_of_the_motion_is_another(doc):
    doc.Motion.Parts = [(doc.Plate, "")]


@change
def a_motion_for_each_part(doc):
    doc.Envelope.Motions = [doc.Motion, doc.Motion001, doc.Motion]


@change
def seen_from_a_part_that_moves(doc):
    doc.Envelope.Reference, doc.Envelope.ReferenceMotion = (doc.Wall, [""]), doc.Motion001


# --- expressions


@change
def length_by_expression(doc):
    doc.Box.setExpression("Length", "Values.length + 1 mm")


@change
def value_of_an_expression(doc):
    doc.Values.set("A1", "7 mm")


@change
def cell_by_expression(doc):
    doc.Envelope.setExpression("CellSize", "Values.length / 5")


# --- results


@change
def resolution(doc):
    doc.Envelope.Resolution = 18


@change
def offset(doc):
    doc.Envelope.Offset = 1


@change
def backend_only(doc):
    doc.Envelope.Backend = "CPU"


@change
def envelope_is_moved(doc):
    doc.Envelope.Placement = shift(0, 0, 4)


@change
def envelope_is_hidden(doc):
    doc.Envelope.Visibility = False


@change
def solid_is_moved(doc):
    doc.EnvelopeSolid.Placement = shift(0, 0, 4)


@change
def solid_merges_nothing(doc):
    doc.EnvelopeSolid.MergeCoplanar = False


@change
def required_distance(doc):
    doc.Clearance.RequiredDistance = 7


@change
def chosen_instead_of_visible(doc):
    doc.Clearance.Neighbours, doc.Clearance.AllVisible = [(doc.Wall, "")], False


@change
def generators_chosen(doc):
    doc.Envelope.MovingParts = [(doc.Box, ""), (doc.Net, "")]


# --- containers and links


@change
def group_moves(doc):
    doc.Group.Placement = turn(20, base=V(0, 2, 0))


@change
def part_into_a_group(doc):
    put_into(doc.Group, doc.Box, shift(0, 2))


@change
def envelope_into_a_group(doc):
    put_into(doc.Group, doc.Envelope, shift(0, 2))


@change
def motion_into_a_group(doc):
    put_into(doc.Group, doc.Motion, shift(0, 2))


@change
def part_leaves_its_group(doc):
    doc.Group.removeObject(doc.Inner)


@change
def link_target(doc):
    doc.Link.LinkedObject = doc.Plate


@change
def link_is_scaled(doc):
    doc.Link.Scale = 2


@change
def solid_of_the_other_envelope(doc):
    doc.EnvelopeSolid.Source = doc.Envelope001


@change
def check_of_the_envelope(doc):
    doc.Clearance.Envelope = doc.Envelope


@change
def accuracy_of_the_check(doc):
    doc.Clearance.MeshDeflection = 0.5


@change
def link_moves(doc):
    doc.Link.Placement = shift(0, 33)


@change
def linked_part_grows(doc):
    doc.Inner.Height = 3


@rows
class States(Table):
    CHANGES = CHANGES

    def setUp(self):
        super().setUp()
        doc = self.doc
        box, plate = self.box(), doc.addObject("Part::Feature", "Plate")
        plate.Shape = Part.makeBox(30, 12, 2).cut(Part.makeCylinder(2, 2, V(10, 6, 0)))
        plate.Placement = shift(0, 30)
        import Mesh

        net = doc.addObject("Mesh::Feature", "Net")
        net.Mesh, net.Placement = Mesh.createBox(4, 4, 4), shift(0, 0, 40)
        group, inner = doc.addObject("App::Part", "Group"), self.box("Inner", 2)
        group.addObject(inner)
        inner.Placement = shift(0, -20)
        link = doc.addObject("App::Link", "Link")
        link.LinkedObject, link.Placement = inner, shift(0, -30)
        wall, hidden = self.box("Wall"), self.box("Hidden")
        wall.Placement, hidden.Placement = shift(60), shift(0, -80)
        hidden.Visibility = False
        self.sheet("length", "5 mm")
        doc.recompute()
        box.setExpression("Width", "Values.length * 2")
        wire = self.straight_wire()
        self.line()
        motion.motion_from_source(doc, "Curve", [wire])
        self.envelope([box, plate, link], doc.Motion, Resolution=20, MadeBy="Session")
        solid.make_solid(doc, doc.Envelope)
        clearance.make_clearance(doc, MovingParts=[(box, "")], Motion=doc.Motion)
        second = self.envelope([net], doc.Motion001, Resolution=16)
        doc.recompute()
        for obj in (doc.Envelope, second):
            envelope.compute(obj)
        solid.compute(doc.EnvelopeSolid)
        clearance.compute(doc.Clearance)
        doc.recompute()

    def test_nothing_changes_nothing(self):
        self.assertEqual({o.Status for o in self.results()}, {UP_TO_DATE})
        self.assertGreater(len(set(self.record(self.doc.Envelope))), 5)
        self.check_states("nothing")
        label_only(self.doc)
        backend_only(self.doc)
        self.doc.recompute()
        self.assertEqual({o.Status for o in self.results()}, {UP_TO_DATE})


class Groups(Case):
    NEEDS_CORE = True

    def test_what_a_moving_group_holds_and_shows(self):
        group, first, second = (
            self.doc.addObject("App::Part", "Group"),
            self.box("A"),
            self.box("B", 4),
        )
        second.Placement = shift(0, 20)
        for part in (first, second):
            group.addObject(part)
        self.doc.recompute()
        obj = self.envelope([group], self.line(), Resolution=20)
        envelope.compute(obj)

        def assert_status(status):
            self.doc.recompute()
            self.assertEqual(obj.Status, status)

        second.Visibility = False
        assert_status(STALE)
        second.Visibility = True
        assert_status(UP_TO_DATE)
        group.removeObject(second)
        assert_status(STALE)
        group.addObject(second)
        assert_status(UP_TO_DATE)
        second.Placement = shift(0, 21)
        assert_status(STALE)
        second.Placement = shift(0, 20)
        assert_status(UP_TO_DATE)
        inner = self.doc.addObject("App::Part", "Inner")
        group.addObject(inner)
        assert_status(UP_TO_DATE)
        inner.addObject(self.box("C", 2))
        assert_status(STALE)
        self.doc.removeObject("C")
        assert_status(UP_TO_DATE)
        self.doc.removeObject("Group")
        assert_status(FAILED)
        self.assertIn('"Group" was deleted', obj.Message)


class External(Case):
    NEEDS_CORE = True

    def test_a_part_of_another_document(self):
        other = App.newDocument("Elsewhere")
        part = other.addObject("Part::Box", "Part")
        other.recompute()
        other.saveAs(os.path.join(self.folder, "elsewhere.FCStd"))
        self.doc.saveAs(os.path.join(self.folder, "here.FCStd"))
        link = self.doc.addObject("App::Link", "Link")
        link.LinkedObject = part
        wall = self.doc.addObject("App::Link", "Wall")
        wall.LinkedObject, wall.Placement = part, shift(60)
        self.doc.recompute()
        path = self.line()
        obj = self.envelope([link], path, Resolution=20)
        check = clearance.make_clearance(self.doc, MovingParts=[(link, "")], Motion=path)
        self.doc.recompute()
        envelope.compute(obj)
        clearance.compute(check)
        self.doc.recompute()
        self.assertEqual((obj.Status, check.Status), (UP_TO_DATE, UP_TO_DATE))
        for length, status in ((12, STALE), (10, UP_TO_DATE)):
            part.Length = length
            other.recompute()
            self.doc.recompute()
            self.assertEqual((obj.Status, check.Status), (status, status))
        part.Placement = shift(0, 5)  # a link has its own placement
        other.recompute()
        self.doc.recompute()
        self.assertEqual((obj.Status, check.Status), (UP_TO_DATE, UP_TO_DATE))
