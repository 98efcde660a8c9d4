# SPDX-License-Identifier: LGPL-2.1-or-later
"""A result says that it is up to date only if a fresh computation would give the same."""
import FreeCAD as App

from case import Case, V, shift, turn
from scene_case import Scene
from sweptvolume import core
from sweptvolume.convert import InputProblem
from sweptvolume.features import clearance, envelope, motion, solid


class Lost(Scene):
    def test_a_deleted_motion_is_named(self):
        other = self.line(12)
        other.Label = "Another"
        self.path.Label = "Slide in"
        self.doc.openTransaction("Delete")
        self.doc.removeObject(self.path.Name)
        self.doc.commitTransaction()
        self.doc.recompute()
        self.assert_states(envelope.FAILED, envelope.STALE, envelope.FAILED)
        for obj in (self.swept, self.check):
            self.assertIn('"Slide in" was deleted', obj.Message)
        facets = self.swept.Mesh.CountFacets
        with self.assertRaisesRegex(InputProblem, "Slide in"):
            envelope.compute(self.swept)
        with self.assertRaisesRegex(InputProblem, "Slide in"):
            clearance.compute(self.check)
        self.assertEqual(self.swept.Mesh.CountFacets, facets)
        self.doc.undo()
        self.doc.recompute()
        self.assert_states(*[envelope.UP_TO_DATE] * 3)
        self.assertNotIn("deleted", self.swept.Message)

    def test_another_motion_that_is_chosen_is_taken(self):
        other = self.line(12)
        self.doc.removeObject(self.path.Name)
        self.doc.recompute()
        self.swept.Motion = self.check.Motion = other
        self.doc.recompute()
        self.assert_states(*[envelope.STALE] * 3)
        envelope.compute(self.swept)
        self.assertEqual(self.swept.Status, envelope.UP_TO_DATE)

    def test_one_of_several_parts(self):
        second = self.box("Second")
        self.swept.MovingParts = [(self.part, ""), (second, "")]
        self.doc.recompute()
        envelope.compute(self.swept)
        self.doc.removeObject("Second")
        self.doc.recompute()
        self.assertEqual(self.swept.Status, envelope.FAILED)
        self.assertIn('"Second"', self.swept.Message)
        with self.assertRaisesRegex(InputProblem, "Second"):
            envelope.compute(self.swept)
        # The parts are chosen again, although the same one remains.
        self.swept.MovingParts = [(self.part, "")]
        self.doc.recompute()
        self.assertEqual(self.swept.Status, envelope.STALE)
        envelope.compute(self.swept)
        self.assertEqual(self.swept.Status, envelope.UP_TO_DATE)

    def test_the_envelope_of_a_solid_and_the_wire_of_a_motion(self):
        wire = self.straight_wire()
        self.swept.Motion = path = motion.motion_from_source(self.doc, "Curve", [wire])
        self.doc.recompute()
        envelope.compute(self.swept)
        self.doc.removeObject("Wire")
        self.doc.recompute()
        self.assertIn('"Wire" was deleted', path.Status)
        self.assertEqual(self.swept.Status, envelope.FAILED)
        self.assertIn('"Wire" was deleted', self.swept.Message)
        motion.make_stored(path)  # the motion keeps its poses, without a source
        self.doc.recompute()
        self.assertEqual(self.swept.Status, envelope.UP_TO_DATE)
        self.doc.removeObject(self.swept.Name)
        self.doc.recompute()
        self.assertIn("was deleted", self.body.Message)


class Placed(Scene):
    def test_an_envelope_that_was_moved_is_stale_until_it_is_put_back(self):
        self.swept.Placement = shift(0, 0, 5)
        self.doc.recompute()
        self.assert_states(envelope.STALE, envelope.STALE, envelope.UP_TO_DATE)
        envelope.compute(self.swept)
        self.assert_placement(self.swept.getGlobalPlacement(), App.Placement())
        self.assert_states(*[envelope.UP_TO_DATE] * 3)

    def test_a_solid_follows_its_envelope_through_containers(self):
        group = self.doc.addObject("App::Part", "G")
        group.Placement = turn(30, base=V(0, 100))
        group.addObject(self.body)
        self.doc.recompute()
        self.assertEqual(self.body.Status, envelope.STALE)
        solid.compute(self.body)
        self.assertEqual(self.body.Status, envelope.UP_TO_DATE)
        self.assert_placement(self.body.getGlobalPlacement(), App.Placement(), 1e-9)

    def test_a_solid_of_an_envelope_with_another_resolution(self):
        self.swept.Resolution = 20
        self.doc.recompute()
        self.assert_states(envelope.STALE, envelope.STALE, envelope.UP_TO_DATE)
        envelope.compute(self.swept)
        self.assert_states(envelope.UP_TO_DATE, envelope.STALE, envelope.UP_TO_DATE)
        self.doc.recompute()
        self.assert_states(envelope.UP_TO_DATE, envelope.STALE, envelope.UP_TO_DATE)

    def test_a_solid_that_failed_says_so_until_its_inputs_change(self):
        self.body.MaxFaces = 1  # every solid has more
        self.doc.recompute()
        with self.assertRaises((core.CoreError, InputProblem)):
            solid.compute(self.body)
        self.assertEqual(self.body.Status, envelope.FAILED)
        text = self.body.Message
        self.doc.recompute(None, True)
        self.assertEqual((self.body.Status, self.body.Message), (envelope.FAILED, text))
        self.body.MaxFaces = solid.MAX_FACES
        self.doc.recompute()
        self.assert_states(*[envelope.UP_TO_DATE] * 3)
        self.assertEqual(self.body.Message, "")


class Edges(Case):
    NEEDS_CORE = True

    def test_the_largest_edge_tolerance_is_reported(self):
        ball = self.doc.addObject("Part::Sphere", "Ball")
        path = motion.motion_from_poses(
            self.doc, [0, 1], [shift(), turn(70, V(1, 2, 3), V(30, 5, 0))]
        )
        obj = self.envelope([ball], path, Resolution=24)
        envelope.compute(obj)
        body = solid.make_solid(self.doc, obj, Tolerance=0.3)
        self.doc.recompute()
        solid.compute(body)
        largest = max(edge.Tolerance for edge in body.Shape.Edges)
        self.assertAlmostEqual(body.EdgeTolerance.Value, largest, 12)
        self.assertEqual("the gap between two faces" in body.Message, largest > 0.3)
        body.EdgeTolerance = 1.25  # a value that occurred in practice
        self.doc.recompute()
        self.assertIn("1.25 mm", body.Message)
        self.assertNotIn("deviates", body.Message)
        body.Deviation = 0.5
        self.doc.recompute()
        self.assertIn(
            "deviates from the envelope by 0.5 mm, which is more than its Tolerance of 0.3 mm",
            body.Message,
        )

    def test_a_solid_that_was_simplified_by_itself_says_so(self):
        ball = self.doc.addObject("Part::Sphere", "Ball")
        path = motion.motion_from_poses(self.doc, [0, 1], [shift(), shift(10)])
        # With an offset, the solid is made from the mesh, not from the faces of the ball.
        obj = self.envelope([ball], path, Resolution=24, Offset=1)
        envelope.compute(obj)
        body = solid.make_solid(self.doc, obj, MaxFaces=200)
        self.doc.recompute()
        solid.compute(body)
        self.assertGreater(body.Deviation.Value, solid.LEAST_GAP)
        self.assertIn("To stay within Max faces, the solid was simplified", body.Message)


class Neighbours(Scene):
    def test_whatever_happens_to_what_is_visible(self):
        self.wall.Placement = shift(70)
        self.doc.recompute()
        self.assertEqual(self.check.Status, clearance.STALE)
        self.wall.Placement = shift(80)
        self.doc.recompute()
        self.assertEqual(self.check.Status, clearance.UP_TO_DATE)
        self.wall.Visibility = False
        self.doc.recompute()
        self.assertEqual(self.check.Status, clearance.FAILED)  # nothing is left to be checked
        self.wall.Placement = shift(75)  # the check also follows hidden parts
        self.wall.Visibility = True
        self.doc.recompute()
        self.assertEqual(self.check.Status, clearance.STALE)
        self.wall.Placement = shift(80)
        self.doc.recompute()
        self.assertEqual(self.check.Status, clearance.UP_TO_DATE)
        new = self.box("New", 3)
        self.doc.recompute()
        self.assertEqual(self.check.Status, clearance.STALE)
        clearance.compute(self.check)
        new.Length = 4
        self.doc.recompute()
        self.assertEqual(self.check.Status, clearance.STALE)

    def test_a_part_inside_a_group_and_one_that_the_check_drives(self):
        group, inner = self.doc.addObject("App::Part", "Group"), self.box("Inner", 2)
        group.addObject(inner)
        group.Placement = shift(0, 60)
        driven = self.box("Driven", 2)
        driven.Placement = shift(0, -40)
        driven.setExpression("Height", "{}.Smallest".format(self.check.Name))
        self.doc.recompute()
        clearance.compute(self.check)
        self.doc.recompute()
        for obj in self.doc.Objects:
            self.assertNotIn(obj, obj.OutListRecursive, obj.Name)
        inner.Placement = shift(1)
        self.doc.recompute()
        self.assertEqual(self.check.Status, clearance.STALE)
        clearance.compute(self.check)
        group.Placement = shift(0, 61)
        self.doc.recompute()
        self.assertEqual(self.check.Status, clearance.STALE)

    def test_chosen_means_checked(self):
        other = self.envelope([self.wall], self.path, Resolution=20)
        envelope.compute(other)
        check = clearance.make_clearance(
            self.doc,
            MovingParts=[(self.part, "")],
            Motion=self.path,
            AllVisible=False,
            Neighbours=[(other, "")],
        )
        self.doc.recompute()
        report = clearance.compute(check)
        self.assertEqual([row["name"] for row in report["neighbours"]], [other.Label])
        other.Resolution = 18
        self.doc.recompute()
        self.assertEqual(check.Status, clearance.STALE)
        envelope.compute(other)
        self.assertEqual(check.Status, clearance.STALE)
        wire = self.straight_wire()
        for chosen, words in (
            (wire, "no solid"),
            (self.part, "both a neighbour and a moving part"),
        ):
            check.Neighbours = [(self.wall, ""), (chosen, "")]
            self.doc.recompute()
            with self.assertRaisesRegex(InputProblem, chosen.Label + ".*" + words):
                clearance.compute(check)

    def test_results_that_are_left_out_are_named(self):
        other = self.envelope([self.wall], self.line(5), Resolution=20)
        other.Label = "Way of the wall"
        envelope.compute(other)
        clearance.compute(self.check)
        self.assertIn("Way of the wall", self.check.Message)
        self.assertNotIn('"{}"'.format(self.swept.Label), self.check.Message)
