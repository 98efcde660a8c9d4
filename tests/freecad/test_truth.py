# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the document says of its results is what a fresh computation would justify."""
import itertools
import math
import os
import time

import FreeCAD as App
import Mesh
import numpy as np
import Part

from case import Case, V, shift, turn
from sweptvolume import contents, core
from sweptvolume.convert import InputProblem
from sweptvolume.features import clearance, envelope, motion, solid
from sweptvolume.trajectory import assembly
from sweptvolume.trajectory.poses import Poses, course


def plate(hole):
    """A plate with a round hole at x = hole: same counts, area, length, volume and box for any."""
    return Part.makeBox(40, 20, 4).cut(Part.makeCylinder(3, 4, V(hole, 10, 0)))


def distance(point, line):
    """Of a point (3,) from a line through points (n,3)."""
    start, way = line[:-1], np.diff(line, axis=0)
    part = np.einsum("ij,ij->i", point - start, way) / np.maximum((way**2).sum(axis=1), 1e-300)
    near = start + np.clip(part, 0.0, 1.0)[:, None] * way
    return float(np.sqrt(((point - near) ** 2).sum(axis=1).min()))


class Contents(Case):
    def test_a_hole_that_moves(self):
        obj = self.doc.addObject("Part::Feature", "Plate")
        obj.Shape = plate(10)
        first = contents.signature([(obj, "")])
        obj.Shape = plate(30)
        self.assertNotEqual(contents.signature([(obj, "")]), first)
        obj.Shape = plate(10)
        self.assertEqual(contents.signature([(obj, "")]), first)

    def test_a_pole_that_moves_between_the_points_looked_at(self):
        poles = [[V(i, j, 0) for j in range(40)] for i in range(40)]
        knots = [list(range(38)), [4] + [1] * 36 + [4]]
        obj = self.doc.addObject("Part::Feature", "Sheet")

        def sheet(height):
            poles[17][30].z = height
            surface = Part.BSplineSurface()
            surface.buildFromPolesMultsKnots(
                poles, knots[1], knots[1], knots[0], knots[0], False, False, 3, 3
            )
            obj.Shape = surface.toShape().extrude(V(0, 0, 20))
            return contents.signature([(obj, "")])

        self.assertNotEqual(sheet(0.0), sheet(0.01))

    def test_meshed_placed_saved_it_is_the_same(self):
        obj = self.doc.addObject("Part::Feature", "Plate")
        obj.Shape = plate(10).fuse(Part.makeSphere(3, V(30, 10, 4))).fuse(Part.makeTorus(9, 1))
        net = self.doc.addObject("Mesh::Feature", "Net")
        net.Mesh = Mesh.createSphere(5.1, 20)
        first = contents.text_of(obj), contents.text_of(net)
        obj.Shape.tessellate(0.1)
        obj.Placement = net.Placement = turn(31, V(1, 2, 3), V(1000.1, 7, 0.3))
        self.assertEqual((contents.text_of(obj), contents.text_of(net)), first)
        path = os.path.join(self.folder, "c.FCStd")
        self.doc.saveAs(path)
        App.closeDocument(self.doc.Name)
        self.doc = App.openDocument(path)
        obj, net = self.doc.getObject("Plate"), self.doc.getObject("Net")
        self.assertEqual((contents.text_of(obj), contents.text_of(net)), first)

    def test_a_mesh_that_changes_is_noticed_through_undo_too(self):
        net = self.doc.addObject("Mesh::Feature", "Net")
        net.Mesh = Mesh.createSphere(5, 20)
        first = contents.text_of(net)
        self.doc.openTransaction("Bend")
        points = net.Mesh.Topology[0]
        points[7] += V(0, 0, 0.001)
        net.Mesh = Mesh.Mesh((points, net.Mesh.Topology[1]))
        self.doc.commitTransaction()
        bent = contents.text_of(net)
        self.assertNotEqual(bent, first)
        self.doc.undo()
        self.assertEqual(contents.text_of(net), first)
        self.doc.redo()
        self.assertEqual(contents.text_of(net), bent)

    def test_a_shape_that_is_gone(self):
        obj = self.doc.addObject("Part::Feature", "Empty")
        text = contents.text_of(obj)
        self.assertIsNone(contents.apart.of(obj).corners())
        obj.Shape = plate(10)
        self.assertNotEqual(contents.text_of(obj), text)
        self.assertEqual(contents.apart.of(obj).corners().shape, (8, 3))
        obj.Shape = Part.Shape()
        self.assertEqual(contents.text_of(obj), text)

    def test_500_faces_are_cheap(self):
        holes = [
            Part.makeCylinder(1, 4, V(3 + 5 * (i % 25), 3 + 5 * (i // 25), 0)) for i in range(500)
        ]
        obj = self.doc.addObject("Part::Feature", "Sieve")
        obj.Shape = Part.makeBox(130, 110, 4).cut(Part.makeCompound(holes))
        self.assertGreater(len(obj.Shape.Faces), 500)
        contents.signature([(obj, "")])
        took = []
        for k in range(5):
            obj.Placement = shift(k)
            begin = time.perf_counter()
            contents.signature([(obj, "")])
            took.append(time.perf_counter() - begin)
        self.assertLess(min(took), 0.005)


class Scene(Case):
    """A box that moves, its envelope and solid, a check of all that is visible; all computed."""

    NEEDS_CORE = True

    def setUp(self):
        super().setUp()
        self.part = self.doc.addObject("Part::Feature", "Plate")
        self.part.Shape = plate(10)
        self.path = self.line()
        self.wall = self.box("Wall")
        self.wall.Placement = shift(80)
        self.swept = self.envelope([self.part], self.path, Resolution=24)
        envelope.compute(self.swept)
        self.body = solid.make_solid(self.doc, self.swept)
        self.check = clearance.make_clearance(
            self.doc, Generators=[(self.part, "")], Motion=self.path
        )
        self.doc.recompute()
        if core.has_solids():
            solid.compute(self.body)
        clearance.compute(self.check)
        self.doc.recompute()
        self.assert_states(envelope.UP_TO_DATE, envelope.UP_TO_DATE, envelope.UP_TO_DATE)

    def states(self):
        return self.swept.Status, self.body.Status, self.check.Status

    def assert_states(self, *wanted):
        found = self.states()
        if not core.has_solids():
            found, wanted = found[::2], wanted[::2]
        self.assertEqual(found, wanted)


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
        self.swept.Generators = [(self.part, ""), (second, "")]
        self.doc.recompute()
        envelope.compute(self.swept)
        self.doc.removeObject("Second")
        self.doc.recompute()
        self.assertEqual(self.swept.Status, envelope.FAILED)
        self.assertIn('"Second"', self.swept.Message)
        with self.assertRaisesRegex(InputProblem, "Second"):
            envelope.compute(self.swept)
        # Chosen anew, though what is left is the same.
        self.swept.Generators = [(self.part, "")]
        self.doc.recompute()
        self.assertEqual(self.swept.Status, envelope.STALE)
        envelope.compute(self.swept)
        self.assertEqual(self.swept.Status, envelope.UP_TO_DATE)

    def test_the_envelope_of_a_solid_and_the_wire_of_a_motion(self):
        wire = self.doc.addObject("Part::Feature", "Wire")
        wire.Shape = Part.makeLine(V(), V(20, 0, 0))
        self.swept.Motion = path = motion.motion_from_source(self.doc, "Curve", [wire])
        self.doc.recompute()
        envelope.compute(self.swept)
        self.doc.removeObject("Wire")
        self.doc.recompute()
        self.assertIn('"Wire" was deleted', path.Status)
        self.assertEqual(self.swept.Status, envelope.FAILED)
        self.assertIn('"Wire" was deleted', self.swept.Message)
        motion.make_stored(path)  # the poses it has are its own from now on
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
        if core.has_solids():
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
        self.body.MaxFaces = 1  # no solid has as few
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
        if not core.has_solids():
            self.skipTest("the core was built without OpenCASCADE")
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
        self.assertEqual("tolerance of an edge" in body.Message, largest > 0.3)
        body.EdgeTolerance = 1.25  # as one was seen
        self.doc.recompute()
        self.assertIn("1.25 mm", body.Message)


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
        self.wall.Placement = shift(75)  # hidden, and followed all the same
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
            Generators=[(self.part, "")],
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
        wire = self.doc.addObject("Part::Feature", "Wire")
        wire.Shape = Part.makeLine(V(), V(20, 0, 0))
        for chosen, words in ((wire, "no solid"), (self.part, "moving part itself")):
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


class Wires(Case):
    """A motion along a wire goes through its corners and leaves it by no more than was asked for."""

    def wire(self, *edges):
        obj = self.doc.addObject("Part::Feature", "Wire")
        obj.Shape = Part.Wire(list(edges))
        return obj

    def assert_within(self, path, wire, accuracy):
        """Both ways round: the path leaves the wire by no more, and no part of the wire is cut off."""
        fine = [np.array([tuple(p) for p in e.discretize(Number=3000)]) for e in wire.Shape.Edges]
        own = np.array([tuple(place.Base) for place in path.Placements])
        # The fine pieces are chords themselves, of 1/3000 of an edge.
        slack = 1e-4 + 1e-3 * accuracy
        at, end = course(motion.poses_of(path), path.Interpolation), path.Times[-1]
        for k in range(100):
            point = np.array(tuple(at(end * k / 99).Base))
            self.assertLessEqual(min(distance(point, line) for line in fine), accuracy + slack)
        for line in fine:
            for point in line[::30]:
                self.assertLessEqual(distance(point, own), accuracy + slack)

    def test_corners_are_poses(self):
        wire = self.wire(Part.makeLine(V(), V(50, 0, 0)), Part.makeLine(V(50, 0, 0), V(50, 37, 0)))
        path = motion.motion_from_source(self.doc, "Curve", [wire], duration=8.0)
        self.doc.recompute()
        self.assertEqual(
            [tuple(p.Base) for p in path.Placements], [(0, 0, 0), (50, 0, 0), (50, 37, 0)]
        )
        self.assertEqual(path.Times[-1], 8.0)
        self.assert_within(path, wire, 1e-9)
        if core.available():
            obj = self.envelope([self.box(size=10)], path, CellSize=1)
            envelope.compute(obj)
            exact = 60 * 10 * 10 + 37 * 10 * 10
            self.assertAlmostEqual(obj.Volume.Value, exact, delta=1e-6 * exact)

    def test_accuracy_holds_on_curves(self):
        poles = [V(0, 0, 0), V(40, 60, 0), V(80, -60, 30), V(120, 0, 0)]
        spline = Part.BSplineCurve(poles)
        arc = Part.Arc(V(120, 0, 0), V(150, 30, 0), V(120, 60, 0)).toShape()
        wire = self.wire(spline.toShape(), arc)
        counts = []
        for orientation in ("Fixed", "Tangent"):
            for accuracy in (1.0, 0.1, 0.01):
                path = motion.motion_from_source(
                    self.doc, "Curve", [wire], accuracy=accuracy, orientation=orientation
                )
                self.doc.recompute()
                self.assert_within(path, wire, accuracy)
                counts.append(path.Count)
        self.assertEqual(counts[:3], sorted(counts[:3]))
        self.assertLess(counts[2], 400)
        self.assertTrue(all(a <= b for a, b in zip(counts[:3], counts[3:])), counts)

    def test_a_part_that_follows_the_tangent_turns_at_a_corner(self):
        back = Part.makeLine(V(50, 0, 0), V(20, 0, 0))
        for last, angle in ((Part.makeLine(V(50, 0, 0), V(50, 37, 0)), 90), (back, 180)):
            wire = self.wire(Part.makeLine(V(), V(50, 0, 0)), last)
            path = motion.motion_from_source(self.doc, "Curve", [wire], orientation="Tangent")
            self.doc.recompute()
            turned = path.Placements[0].Rotation.inverted().multiply(path.Placements[-1].Rotation)
            self.assertAlmostEqual(math.degrees(turned.Angle), angle, 6)
            for a, b in zip(path.Placements, path.Placements[1:]):
                step = a.Rotation.inverted().multiply(b.Rotation).Angle
                self.assertLess(math.degrees(step), 91)
                self.assertTrue(step < 1e-9 or (a.Base - b.Base).Length < 1e-9, "turns in place")

    def test_directions_that_rounding_alone_tells_apart(self):
        helix = self.doc.addObject("Part::Helix", "Helix")
        for turns, orientation in itertools.product((1, 2, 4, 12), ("Fixed", "Tangent")):
            # The same direction and the same side after each turn.
            helix.Pitch, helix.Height, helix.Radius = 10, 10 * turns, 20
            self.doc.recompute()
            path = motion.motion_from_source(
                self.doc, "Curve", [helix], accuracy=0.2, orientation=orientation
            )
            self.doc.recompute()
            self.assert_within(path, helix, 0.2)

    def test_what_cannot_be_is_refused(self):
        ring = self.doc.addObject("Part::Circle", "Ring")
        ring.Radius = 1000
        self.doc.recompute()
        for accuracy, words in (
            (0.0, "greater than 0"),
            (-1.0, "greater than 0"),
            (1e-7, "allow more"),
        ):
            with self.assertRaisesRegex(InputProblem, words):
                motion.motion_from_source(self.doc, "Curve", [ring], accuracy=accuracy)


class Estimate(Case):
    NEEDS_CORE = True

    def test_the_cell_is_that_of_the_run(self):
        part = self.doc.addObject("Part::Feature", "Part")
        part.Shape = Part.makeCylinder(10, 60).fuse(Part.makeTorus(25, 4, V(0, 0, 20)))
        net = self.doc.addObject("Mesh::Feature", "Net")
        net.Mesh = Mesh.createSphere(15, 30)
        places = [turn(20 * k, V(1, 1, 0.3), V(10 * k, 3 * k, 0)) for k in range(7)]
        path = motion.motion_from_poses(self.doc, range(7), places)
        for parts in ([part], [net], [part, net]):
            obj = self.envelope(parts, path, Resolution=50)
            found = envelope.Plan.of(obj).estimate()
            envelope.compute(obj)
            cell = obj.UsedCellSize.Value
            self.assertAlmostEqual(found["cell"], cell, delta=2e-3 * cell)
            ran = envelope.json.loads(obj.Report)["grid"]
            for a, b in zip(found["grid"], ran):
                self.assertLessEqual(abs(a - b), 1)

    def test_a_closer_estimate_samples_the_parts_themselves(self):
        comb = self.doc.addObject("Part::Feature", "Comb")
        comb.Shape = Part.makeCompound([Part.makeBox(1, 40, 40, V(3 * k, 0, 0)) for k in range(30)])
        places = [turn(0.004 * k, V(0, 0, 1), V(0, 0, 2e-4 * k)) for k in range(3000)]
        path = motion.motion_from_poses(self.doc, [0.01 * k for k in range(3000)], places)
        obj = self.envelope([comb], path, Resolution=64)
        plan, kept = envelope.Plan.of(obj), contents.KeptBodies()
        find = plan.closer_estimate(kept.read)
        found = find(core.Control())
        envelope.compute(obj)
        report = envelope.json.loads(obj.Report)
        self.assertEqual(found["grid"], report["grid"])
        self.assertAlmostEqual(found["cell"], obj.UsedCellSize.Value, delta=1e-6)
        self.assertGreater(found["useful_filter"], 0)
        stop = core.Control()
        stop.cancel()
        with self.assertRaisesRegex(core.CoreError, "ancel"):
            find(stop)

        pairs = [(comb, "")]
        first = kept.read(pairs, 1.0)
        self.assertIs(kept.read(pairs, 1.0), first)
        comb.Placement.Base.x = 5
        moved = kept.read(pairs, 1.0)
        self.assertAlmostEqual(moved.vertices[:, 0].min(), first.vertices[:, 0].min() + 5)


class Frames(Case):
    """Motions of mechanisms come as frames: what lies between them is said or right."""

    NEEDS_CORE = True

    def hinge(self, count, **values):
        """A bar that turns by 90 degrees about z at the origin, driven by a cell of a sheet."""
        sheet = self.doc.addObject("Spreadsheet::Sheet", "Values")
        sheet.set("A1", "0")
        sheet.setAlias("A1", "angle")
        self.doc.recompute()
        self.bar = self.doc.addObject("Part::Box", "Bar")
        self.bar.Length, self.bar.Width, self.bar.Height = 60, 5, 5
        self.bar.setExpression("Placement.Rotation.Angle", "Values.angle")
        self.doc.recompute()
        path = motion.motion_from_source(
            self.doc,
            "Driven",
            [sheet, self.bar],
            property="angle",
            start=0,
            end=90,
            count=count,
            **values,
        )
        self.doc.recompute()
        return path

    def test_parts_that_turn_go_on_turning(self):
        path = self.hinge(3)
        self.assertEqual(path.Interpolation, "Screw")
        obj = self.envelope([self.bar], path, Resolution=100)
        envelope.compute(obj)
        # A quarter of a disc, and the bar's own width before and behind it.
        exact = 5 * (math.pi / 4 * (60**2 + 5**2) + 2 * 60 * 5 / 2)
        self.assertAlmostEqual(obj.Volume.Value, exact, delta=0.01 * exact)
        self.assertNotIn("far apart", obj.Message)

    def test_frames_that_lie_far_apart_are_said(self):
        path = self.hinge(4, interpolation="Linear")
        path.Placements = [
            App.Placement(V(9 * math.sin(k), 0, 0), p.Rotation)
            for k, p in enumerate(path.Placements)
        ]
        obj = self.envelope([self.bar], path, CellSize=0.5)
        envelope.compute(obj)
        self.assertIn("far apart", obj.Message)
        wall = self.box("Wall")
        wall.Placement = shift(0, 90)
        check = clearance.make_clearance(self.doc, Generators=[(self.bar, "")], Motion=path)
        self.doc.recompute()
        clearance.compute(check)
        self.assertIn("far apart", check.Message)
        path.SourceType = "Stored"  # keys are what they are
        self.doc.recompute()
        envelope.compute(obj)
        self.assertNotIn("far apart", obj.Message)

    def test_a_simulation_that_stops_early(self):
        self.assertEqual(assembly.shortfall("S", 0, 1, 0.01, 101), "")
        self.assertEqual(assembly.shortfall("S", 0.2, 1, 0.3, 3), "")
        text = assembly.shortfall("S", 0, 1, 0.01, 58)
        for word in ("58 of 101", "0.57 s of 1 s", "stopped early"):
            self.assertIn(word, text)
        path = self.line()
        motion.store(path, Poses([0, 1], [shift(), shift(30)], note=text))
        obj = self.envelope([self.box()], path)
        envelope.compute(obj)
        self.assertEqual(path.Message, text)
        self.assertIn(text, obj.Message)


class Saved(Scene):
    def test_numbers_of_many_digits_are_the_same_when_a_document_is_opened(self):
        third = 1.0 / 3.0 / 10  # a quantity of seventeen digits
        self.swept.Tolerance = self.swept.Offset = third
        self.body.Tolerance = 2 * third
        self.check.Required, self.check.Deflection = 100 * third, third
        self.doc.recompute()
        envelope.compute(self.swept)
        if core.has_solids():
            solid.compute(self.body)
        clearance.compute(self.check)
        self.doc.recompute()
        self.assert_states(*[envelope.UP_TO_DATE] * 3)
        names = [obj.Name for obj in (self.swept, self.check, self.body)]
        path = os.path.join(self.folder, "digits.FCStd")
        self.doc.saveAs(path)
        App.closeDocument(self.doc.Name)
        self.doc = App.openDocument(path)
        for obj in self.doc.Objects:
            obj.enforceRecompute()  # as "Mark to recompute" in the tree does
        self.doc.recompute(None, True)
        self.swept, self.check, self.body = map(self.doc.getObject, names)
        self.assert_states(*[envelope.UP_TO_DATE] * 3)


class OfBefore(Scene):
    def test_results_of_before_are_known_again(self):
        """A document as version 1 left it: hashes of sizes, none of the properties that came since."""
        plans = [
            (self.swept, envelope.Plan.of(self.swept)),
            (self.check, clearance.Plan.of(self.check)),
        ]
        before = [(obj, plan.hash_of_before()) for obj, plan in plans]
        before.append((self.body, solid.hash_of_before(self.body)))
        names = [obj.Name for obj, _ in before]
        for obj, text in before:
            for name in ("Placed", "Missing", "Seen"):
                if name in obj.PropertiesList:
                    obj.removeProperty(name)
            if obj is not self.body or core.has_solids():
                obj.InputHash = text
        self.body.removeProperty("TriedHash")
        for obj, _ in before:
            obj.purgeTouched()
        path = os.path.join(self.folder, "before.FCStd")
        self.doc.saveAs(path)
        App.closeDocument(self.doc.Name)
        self.doc = App.openDocument(path)
        self.assertEqual([o.Name for o in self.doc.Objects if "Touched" in o.State], [])
        self.doc.recompute(None, True)
        self.swept, self.check, self.body = map(self.doc.getObject, names)
        self.assert_states(*[envelope.UP_TO_DATE] * 3)
        self.doc.getObject("Plate").Shape = plate(30)
        self.doc.recompute()
        self.assert_states(*[envelope.STALE] * 3)
