# SPDX-License-Identifier: LGPL-2.1-or-later
"""Shared volumes in documents: compared with formulas and with OpenCASCADE's Boolean operations; states,
placements and bad input.
"""
import Mesh

from case import Case, V, shift, turn
from sweptvolume import convert, core
from sweptvolume.features import envelope, shared, solid
from sweptvolume.features.base import FAILED, NOT_COMPUTED, STALE, UP_TO_DATE


class Shared(Case):
    NEEDS_CORE = True

    def sides(self, by=8.0):
        left, right = self.box("Left"), self.box("Right")
        right.Placement = shift(by, 1, 1)
        self.doc.recompute()
        return left, right

    def make(self, first, second, **settings):
        pairs = [[convert.root_path(obj) for obj in side] for side in (first, second)]
        obj = shared.make_shared(self.doc, *pairs, **settings)
        self.doc.recompute()
        return obj

    def test_two_boxes(self):
        obj = self.make(*([side] for side in self.sides()))
        self.assertEqual(obj.Status, NOT_COMPUTED)
        undo = self.doc.UndoCount
        shared.compute(obj)
        self.assertEqual((obj.Status, self.doc.UndoCount), (UP_TO_DATE, undo + 1))
        self.assertAlmostEqual(obj.Volume.Value, 2 * 9 * 9, 6)
        self.assertAlmostEqual(obj.Mesh.Volume, 162, 3)
        self.assertAlmostEqual(obj.Depth.Value, 2, 1)
        box = obj.Mesh.BoundBox
        self.assertAlmostEqual(box.XMin, 8, 5)
        self.assertAlmostEqual(box.XMax, 10, 5)
        self.doc.recompute()
        self.assertEqual(obj.Status, UP_TO_DATE)

    def test_a_solid_of_what_is_shared(self):
        """Make solid accepts a shared volume. The solid is stale if the volume has changed."""
        left, right = self.sides(5)
        obj = self.make([left], [right])
        shared.compute(obj)
        self.assertTrue(solid.can_be_source(obj))
        made = solid.make_solid(self.doc, obj)
        solid.compute(made)
        self.assertEqual((made.Status, len(made.Shape.Faces)), (UP_TO_DATE, 6))
        self.assertTrue(made.Shape.isValid())
        self.assertAlmostEqual(made.Shape.Volume, 5 * 9 * 9, 4)
        right.Placement = shift(6, 1, 1)
        self.doc.recompute()
        self.assertEqual(made.Status, STALE)
        shared.compute(obj)
        solid.compute(made)
        self.assertAlmostEqual(made.Shape.Volume, 4 * 9 * 9, 4)

    def test_flush_solids_share_a_clean_solid(self):
        """If faces lie on each other, the mesh has triangles without area. The solid has none of them."""
        leaning = turn(30, V(1, 2, 3))
        for k, (by, faces, volume) in enumerate((((5, 0, 0), 6, 500), ((5, 4, 0), 6, 300))):
            left, right = self.box("Flush{}".format(k)), self.box("Beside{}".format(k))
            left.Placement, right.Placement = leaning, leaning.multiply(shift(*by))
            self.doc.recompute()
            obj = self.make([left], [right])
            shared.compute(obj)
            made = solid.make_solid(self.doc, obj)
            solid.compute(made)
            self.assertEqual((made.Status, len(made.Shape.Faces)), (UP_TO_DATE, faces))
            self.assertTrue(made.Shape.isValid())
            self.assertAlmostEqual(made.Shape.Volume, volume, 3)

    def test_solids_against_the_booleans_of_opencascade(self):
        for k, degrees in enumerate((10, 33, 71)):
            one = self.doc.addObject("Part::Torus", "Ring{}".format(k))
            one.Radius1, one.Radius2 = 20, 6
            other = self.doc.addObject("Part::Cylinder", "Bar{}".format(k))
            other.Radius, other.Height = 5, 60
            leaning = turn(degrees, V(1, 0.3, 0.2), V(19, 3, 1))
            other.Placement = leaning.multiply(shift(0, 0, -30))
            self.doc.recompute()
            exact = one.Shape.common(other.Shape).Volume
            self.assertGreater(exact, 100)
            obj = self.make([one], [other], MeshDeflection=0.01)
            shared.compute(obj)
            # A polygon in a circle of radius r, with chords of height d: its area is smaller by the
            # fraction 4/3 d/r.
            lacks = 1 - obj.Volume.Value / exact
            self.assertGreater(lacks, 0)
            self.assertLess(lacks, 4 / 3 * 0.01 * (1 / 5 + 1 / 6))

    def test_envelopes_and_their_solids_are_sides(self):
        left, post = self.box("Left"), self.box("Post", 4.0)
        post.Placement = shift(15, 8, 3)
        swept = self.envelope([left], self.line(30))
        envelope.compute(swept)
        obj = self.make([swept], [post])
        shared.compute(obj)
        self.assertAlmostEqual(obj.Volume.Value, 4 * 4 * 2, 4)
        made = solid.make_solid(self.doc, swept)
        self.doc.recompute()
        solid.compute(made)
        of_solid = self.make([made], [post])
        shared.compute(of_solid)
        self.assertAlmostEqual(of_solid.Volume.Value, 32, 4)
        # Objects made from a stale envelope are stale.
        left.Length = 12
        self.doc.recompute()
        self.assertEqual((swept.Status, obj.Status), (STALE, STALE))

    def test_a_moving_part_at_a_time(self):
        part, wall = self.box("Part"), self.box("Wall")
        wall.Placement = shift(25)
        obj = self.make([part], [wall], Motion=self.line(30), Time=0.6)
        shared.compute(obj)
        self.assertAlmostEqual(obj.Volume.Value, 3 * 100, 6)  # it ends at x = 28
        obj.Time = 0.7
        self.doc.recompute()
        self.assertEqual(obj.Status, STALE)
        shared.compute(obj)
        self.assertAlmostEqual(obj.Volume.Value, 6 * 100, 6)

    def test_states(self):
        left, right = self.sides()
        obj = self.make([left], [right])
        shared.compute(obj)
        right.Placement = shift(9, 1, 1)
        self.doc.recompute()
        self.assertEqual(obj.Status, STALE)
        right.Placement = shift(8, 1, 1)
        self.doc.recompute()
        self.assertEqual(obj.Status, UP_TO_DATE)
        obj.Placement = shift(0, 0, 5)
        self.doc.recompute()
        self.assertEqual(obj.Status, STALE)  # the result was moved away from its sides
        shared.compute(obj)
        self.assertAlmostEqual(obj.Mesh.BoundBox.ZMin, 1, 5)
        self.doc.undo()
        self.doc.recompute()
        self.assertEqual(obj.Status, STALE)
        self.doc.openTransaction("Delete")
        self.doc.removeObject("Right")
        self.doc.commitTransaction()
        self.doc.recompute()
        self.assertEqual(obj.Status, FAILED)
        self.assertIn('"Right" was deleted', obj.Message)
        self.doc.undo()
        self.doc.recompute()
        self.assertEqual(obj.Status, STALE)

    def test_a_copy_and_a_saved_document(self):
        obj = self.make(*([side] for side in self.sides()))
        shared.compute(obj)
        copied = self.doc.copyObject(obj, False)
        self.doc.recompute()
        self.assertEqual((copied.Status, copied.Volume), (UP_TO_DATE, obj.Volume))
        self.reopen()
        again = self.doc.getObject("SharedVolume")
        self.doc.recompute()
        self.assertEqual((again.Status, again.Mesh.CountFacets > 0), (UP_TO_DATE, True))
        self.doc.getObject("Left").Length = 9
        self.doc.recompute()
        self.assertEqual(again.Status, STALE)

    def test_nothing_shared_is_told_with_the_distance(self):
        obj = self.make(*([side] for side in self.sides(13)))
        shared.compute(obj)
        self.assertEqual((obj.Status, obj.Mesh.CountFacets), (UP_TO_DATE, 0))
        self.assertAlmostEqual(obj.Distance.Value, 3, 9)
        self.assertIn("3 mm", obj.Message)

    def test_bad_input_is_named(self):
        left, right = self.sides()
        with self.assertRaisesRegex(convert.InputProblem, '"Left" is on both sides'):
            shared.compute(self.make([left], [left, right]))
        with self.assertRaisesRegex(convert.InputProblem, "needs two sides"):
            shared.compute(self.make([left], []))
        mesh = self.doc.addObject("Mesh::Feature", "Open")
        facets = Mesh.createBox(10, 10, 10)
        facets.removeFacets([0, 1])
        mesh.Mesh = facets
        obj = self.make([left], [mesh])
        with self.assertRaisesRegex(core.CoreError, "'Open' is not closed"):
            shared.compute(obj)
        self.assertEqual(obj.Status, FAILED)
        self.assertIn("Open", obj.Message)
