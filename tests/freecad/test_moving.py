# SPDX-License-Identifier: LGPL-2.1-or-later
"""Envelopes of parts with motions of their own, relative to a moving reference, and with smooth motions."""
import math

import numpy as np

from case import Case, V, shift, turn
from sweptvolume import convert, core
from sweptvolume.convert import InputProblem
from sweptvolume.features import clearance, envelope, envelope_plan, motion


class Moving(Case):
    NEEDS_CORE = True

    def lines(self, *travels):
        return [motion.motion_from_poses(self.doc, [0, 1], [shift(), shift(*w)]) for w in travels]

    def assert_box(self, obj, low, high):
        box, cell = obj.Mesh.BoundBox, obj.UsedCellSize.Value
        found = (box.XMin, box.YMin, box.ZMin, box.XMax, box.YMax, box.ZMax)
        for a, b in zip(found, tuple(low) + tuple(high)):
            self.assertAlmostEqual(a, b, delta=cell, msg=str(found))

    def test_parts_with_motions_of_their_own(self):
        """Two boxes at right angles form an L of known volume, with one closed surface."""
        boxes = [self.box("A"), self.box("B")]
        along, up = self.lines((30, 0, 0), (0, 20, 0))
        obj = self.envelope(boxes, along, Motions=[along, up], Resolution=80)
        envelope.compute(obj)
        cell = obj.UsedCellSize.Value
        self.assertTrue(obj.Mesh.isSolid())
        self.assertEqual(obj.Shells, 1)
        self.assert_box(obj, (0, 0, 0), (40, 30, 10))
        area = 2 * 600 + 10 * (40 + 30 + 30 + 20 + 10 + 10)
        self.assertAlmostEqual(obj.Volume.Value, 6000, delta=0.1 * area * cell)
        self.assertEqual(obj.Status, envelope.UP_TO_DATE)
        up.Placements = [shift(), shift(0, 25)]
        self.doc.recompute()
        self.assertEqual(obj.Status, envelope.STALE)

    def test_an_accuracy_is_shared_by_both_runs(self):
        """The envelopes are sampled, and sampled again when they are joined. No bound of the error is
        known, so none is shown."""
        one, two = self.box("One"), self.box("Two")
        travels = self.lines((30, 0, 0), (0, 0, 30))
        obj = self.envelope([one, two], travels[0], Accuracy=1)
        self.doc.recompute()
        plan = envelope_plan.Plan.of(obj)
        self.assertEqual([r.options["cell"] for r in plan.requests()], [0.5])
        obj.Motions = travels
        self.doc.recompute()
        plan = envelope_plan.Plan.of(obj)
        cells = [r.options["cell"] for r in plan.requests()]
        self.assertEqual(cells + [plan.estimate()["cell"]], [0.25] * 3)
        envelope.compute(obj)
        self.assertEqual(obj.Status, envelope.UP_TO_DATE)
        self.assertEqual((obj.UsedCellSize.Value, obj.AccuracyBound.Value), (0.25, 0))
        points = np.array(obj.Mesh.Topology[0])
        outside = np.maximum(-points.min(axis=0), points.max(axis=0) - (40, 10, 40)).max()
        self.assertLess(outside, 1)

    def test_every_part_needs_its_motion(self):
        along, up = self.lines((30, 0, 0), (0, 20, 0))
        obj = self.envelope([self.box("A"), self.box("B")], along, Motions=[up])
        words = "The number of moving parts is 2, but the number of own motions is 1"
        with self.assertRaisesRegex(InputProblem, words):
            envelope.compute(obj)

    def test_cancel_in_the_second_part(self):
        along, up = self.lines((30, 0, 0), (0, 20, 0))
        obj = self.envelope([self.box("A"), self.box("B")], along, Motions=[along, up])
        control = core.Control()
        control.enter(1, 3)
        control.cancel()
        control.enter(2, 3)  # the next part is cancelled as well
        with self.assertRaises(core.CoreError) as caught:
            envelope.compute(obj, control)
        self.assertEqual(caught.exception.status, "Cancelled")
        self.assertEqual((obj.Status, obj.Mesh.CountFacets), (envelope.CANCELLED, 0))

    def test_seen_from_a_part_that_goes_along(self):
        """Part and reference have the same motion: relative to the reference, the part stands still."""
        part, table = self.box("Part"), self.box("Table")
        table.Placement = shift(0, 50)
        path = motion.motion_from_poses(self.doc, [0, 1], [shift(), turn(80, base=V(90, 5, 1))])
        path.PoseType = "Relative"
        obj = self.envelope([part], path, Reference=(table, [""]), ReferenceMotion=path)
        envelope.compute(obj)
        self.assert_box(obj, (0, 0, 0), (10, 10, 10))

    def test_seen_from_a_turning_table(self):
        """A part stands still beside the axis of a table that turns once: its space relative to the
        table is a ring."""
        part, table = self.box("Part"), self.box("Table")
        part.Placement = shift(20, -5)
        turns = [turn(90 * k) for k in range(5)]
        still = motion.motion_from_poses(self.doc, [0, 4], [shift(), shift()], "Linear", "Relative")
        spin = motion.motion_from_poses(self.doc, range(5), turns, "Linear", "Relative")
        obj = self.envelope(
            [part], still, Reference=(table, [""]), ReferenceMotion=spin, Resolution=100
        )
        envelope.compute(obj)
        points = convert.arrays_from_mesh(obj.Mesh)[0]
        radius, cell = np.hypot(points[:, 0], points[:, 1]), obj.UsedCellSize.Value
        self.assertAlmostEqual(radius.min(), 20, delta=cell)
        self.assertAlmostEqual(radius.max(), math.hypot(30, 5), delta=cell)
        ring = math.pi * (math.hypot(30, 5) ** 2 - 20**2) * 10
        self.assertAlmostEqual(obj.Volume.Value, ring, delta=0.02 * ring)

    def test_reference_motion_needs_the_part(self):
        path = self.line()
        obj = self.envelope([self.box()], path, ReferenceMotion=path)
        with self.assertRaisesRegex(InputProblem, "no reference part"):
            envelope.compute(obj)

    def test_smooth_motion(self):
        """Three keys on a quarter of a circle, with the velocities of a motion along it."""
        box = self.box(size=2.0)
        speed = 20 * math.pi / 2
        places = [shift(20), shift(20 * math.sqrt(0.5), 20 * math.sqrt(0.5)), shift(0, 20)]
        path = motion.motion_from_poses(self.doc, [0, 0.5, 1], places, "Spline")
        path.Tangents = ["Given"] * 3
        path.Velocities = [
            V(0, speed),
            V(-speed * math.sqrt(0.5), speed * math.sqrt(0.5)),
            V(-speed, 0),
        ]
        obj = self.envelope([box], path, Resolution=100)
        envelope.compute(obj)
        # The box does not turn, so each of its points moves along a circle of radius 20. The circle of the
        # corner with the local coordinates (2, 2) has its centre at (2, 2) and bounds the envelope.
        box = obj.Mesh.BoundBox
        self.assertAlmostEqual(box.XMax, 22, delta=obj.UsedCellSize.Value)
        points = convert.arrays_from_mesh(obj.Mesh)[0]
        outer = np.hypot(points[:, 0] - 2, points[:, 1] - 2)
        self.assertLess(abs(outer[(points[:, 0] > 3) & (points[:, 1] > 3)].max() - 20), 0.1)
        path.Interpolation = "Linear"
        self.doc.recompute()
        self.assertEqual(obj.Status, envelope.STALE)

    def test_clearance_of_a_smooth_motion(self):
        places = [shift(0), shift(20, 20), shift(40)]
        path = motion.motion_from_poses(self.doc, [0, 1, 2], places, "Spline")
        part, wall = self.box("Part", 2.0), self.box("Wall", 2.0)
        wall.Placement = shift(20, 30)
        check = clearance.make_clearance(self.doc, MovingParts=[(part, [""])], Motion=path)
        check.Neighbours, check.AllVisible = [(wall, [""])], False
        self.doc.recompute()
        row = clearance.compute(check)["neighbours"][0]
        self.assertAlmostEqual(row["distance"], 8, delta=0.02)
        # Subtracted are the mesh deflections, the accuracy, and half of the accuracy for the curve.
        off = 2 * check.MeshDeflection.Value + 1.5 * check.Accuracy.Value
        self.assertAlmostEqual(row["guaranteed"], row["distance"] - off, places=9)
        check.RequiredDistance = row["distance"] - off + check.Accuracy.Value + 0.002
        self.doc.recompute()
        self.assertEqual(clearance.compute(check)["neighbours"][0]["verdict"], "below")
        check.RequiredDistance = check.RequiredDistance.Value - 0.004
        self.doc.recompute()
        self.assertEqual(clearance.compute(check)["neighbours"][0]["verdict"], "clear")

    def test_stale_motion_makes_a_stale_envelope(self):
        text = "t,tx,ty,tz,qx,qy,qz,qw\n0,0,0,0,0,0,0,1\n1,9,0,0,0,0,0,1\n"
        path = self.file("m.csv", text)
        recorded = motion.motion_from_file(self.doc, path)
        obj = self.envelope([self.box()], recorded)
        envelope.compute(obj)
        names = recorded.Name, obj.Name
        self.file("m.csv", text + "2,9,9,0,0,0,0,1\n")
        self.reopen()
        recorded, obj = map(self.doc.getObject, names)
        self.assertEqual((recorded.Status, obj.Status), (motion.STALE, envelope.STALE))
        motion.reload_source(recorded)
        self.doc.recompute()
        self.assertEqual((recorded.Status, obj.Status), ("", envelope.STALE))
        envelope.compute(obj)
        self.assertEqual(obj.Status, envelope.UP_TO_DATE)

    def test_a_failure_stays_until_the_inputs_change(self):
        box = self.box()
        obj = self.envelope([box], self.line(), CellSize=1000)
        with self.assertRaises(core.CoreError):
            envelope.compute(obj)
        obj.Label = "Another name"
        self.doc.recompute()
        self.assertEqual(obj.Status, envelope.FAILED)
        obj.CellSize = 1
        self.doc.recompute()
        self.assertEqual(obj.Status, envelope.NOT_COMPUTED)
