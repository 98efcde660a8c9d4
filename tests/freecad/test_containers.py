# SPDX-License-Identifier: LGPL-2.1-or-later
"""Our objects inside groups: no circle in the document, and what is moved with a group is noticed."""
import os

import FreeCAD as App

from case import Case, V, shift, turn
from sweptvolume import convert
from sweptvolume.features import clearance, containers, envelope, motion


class Containers(Case):
    def setUp(self):
        super().setUp()
        self.outer, self.group = (self.doc.addObject("App::Part", n) for n in ("Outer", "Group"))
        self.part = self.box("Slide")
        self.outer.addObject(self.group)
        self.group.addObject(self.part)
        self.path = self.line()
        self.path.Frame = "Relative"
        self.doc.recompute()

    def recompute(self):
        """Recomputes; nothing stays touched, no circle in the graph (which FreeCAD only prints)."""
        self.doc.recompute()
        for obj in self.doc.Objects:
            self.assertNotIn("Touched", obj.State, obj.Name)
            self.assertNotIn(obj, obj.OutListRecursive, obj.Name)

    def assert_seen(self, obj, root=None):
        """The envelope's only part is seen from the outermost group."""
        root = root or self.outer
        self.assertEqual(convert.pairs_of(obj.Generators), [(root, "Group.Slide.")])

    def test_envelope_dragged_to_its_part_and_out_again(self):
        obj = self.envelope([self.part], self.path)
        self.assert_seen(obj)
        for group in (self.group, self.outer):
            self.doc.openTransaction("Drag")
            group.addObject(obj)
            self.doc.commitTransaction()
            self.recompute()
            self.assert_seen(obj)
            self.doc.undo()
            self.assertEqual(containers.around(obj), [])
            self.recompute()
            self.assert_seen(obj)
            self.doc.redo()
            self.recompute()
            self.assert_seen(obj)
            group.removeObject(obj)
            self.recompute()
            self.assertEqual(obj.Generators, [(self.outer, ("Group.Slide.",))])

    def test_envelope_that_its_part_joins(self):
        self.outer.removeObject(self.group)
        obj = self.envelope([self.part], self.path)
        self.group.addObject(obj)
        self.recompute()
        self.outer.addObject(self.group)
        self.recompute()
        self.assert_seen(obj)

    def test_whole_group_as_generator(self):
        other = self.box("Other", 5)
        self.group.addObject(other)
        obj = self.envelope([(self.group, "")], self.path)
        self.group.addObject(obj)
        self.recompute()
        self.assertEqual([o.Name for o, _ in obj.Generators], ["Slide", "Other"])

    def test_links_of_checks_and_references(self):
        wall = self.box("Wall")
        self.group.addObject(wall)
        obj = self.envelope([self.part], self.path)
        obj.Reference, obj.ReferenceMotion = (self.outer, ["Group.Wall."]), self.path
        check = clearance.make_clearance(self.doc, Envelope=obj, AllVisible=False)
        check.Neighbours = [(self.outer, ["Group.Wall."])]
        self.recompute()
        self.group.addObject(obj)
        self.group.addObject(check)
        self.group.addObject(self.path)
        self.recompute()
        self.assertEqual(obj.Reference[0], wall)
        self.assertEqual(convert.pairs_of(obj.Reference), [(self.outer, "Group.Wall.")])
        self.assertEqual(convert.pairs_of(check.Neighbours), [(self.outer, "Group.Wall.")])

    def test_moved_wire_moves_the_motion(self):
        import Part

        wire = self.doc.addObject("Part::Feature", "Wire")
        wire.Shape = Part.makeLine(V(), V(20, 0, 0))
        self.group.addObject(wire)
        path = motion.motion_from_source(self.doc, "Curve", [wire], count=3)
        self.recompute()
        self.outer.Placement = turn(90)
        self.recompute()
        self.assert_placement(path.Placements[-1], shift(0, 20), 1e-9)

    def test_a_restored_document_goes_on(self):
        obj = self.envelope([self.part], self.path)
        self.group.addObject(obj)
        self.recompute()
        path = os.path.join(self.folder, "r.FCStd")
        self.doc.saveAs(path)
        App.closeDocument(self.doc.Name)
        self.doc = App.openDocument(path)
        self.assertEqual([o.Name for o in self.doc.Objects if "Touched" in o.State], [])
        obj = self.doc.getObject("Envelope")
        self.recompute()
        self.assert_seen(obj, self.doc.getObject("Outer"))
        # A circle that an older version has left is opened.
        obj.Generators = [(self.doc.getObject("Group"), "Slide.")]
        self.doc.save()
        App.closeDocument(self.doc.Name)
        self.doc = App.openDocument(path)
        self.recompute()
        self.assert_seen(self.doc.getObject("Envelope"), self.doc.getObject("Outer"))


class Computed(Case):
    NEEDS_CORE = True

    def test_moved_with_its_part_it_is_stale_and_computed_again(self):
        group, obj = self.grouped_envelope()
        group.addObject(obj)
        self.doc.recompute()
        self.assertEqual(obj.Status, envelope.UP_TO_DATE)
        group.Placement = shift(0, 50)
        self.doc.recompute()
        self.assertEqual(obj.Status, envelope.STALE)
        envelope.compute(obj)
        self.assertEqual(obj.Status, envelope.UP_TO_DATE)
        self.assert_placement(obj.getGlobalPlacement(), App.Placement())
        # FreeCAD gives the box as the group sees it.
        self.assertAlmostEqual(obj.Mesh.BoundBox.YMin + 50, 50, delta=obj.UsedCellSize.Value)
