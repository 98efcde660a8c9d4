# SPDX-License-Identifier: LGPL-2.1-or-later
"""Motions that are recorded frame by frame, from driving values and simulations."""
import math

import FreeCAD as App

from case import Case, V, shift
from sweptvolume.features import clearance, envelope, motion
from sweptvolume.trajectory import assembly, frames
from sweptvolume.trajectory.poses import Poses


class Frames(Case):
    """Motions of mechanisms are recorded as frames. Between frames the interpolated motion must be
    right, or a message must say that it is not."""

    NEEDS_CORE = True

    def hinge(self, count, **values):
        """Returns a bar that turns by 90 degrees about z at the origin, driven by a cell of a
        spreadsheet."""
        sheet = self.sheet("angle", "0")
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
        # Area: a quarter of a disc whose radius is the diagonal of the bar, and half of the bar
        # (a triangle beyond its diagonal) at the start and at the end of the turn.
        exact = 5 * (math.pi / 4 * (60**2 + 5**2) + 2 * 60 * 5 / 2)
        self.assertAlmostEqual(obj.Volume.Value, exact, delta=0.01 * exact)
        self.assertNotIn("are large: near", obj.Message)

    def test_frames_that_lie_far_apart_are_said(self):
        path = self.hinge(4, interpolation="Linear")
        path.Placements = [
            App.Placement(V(9 * math.sin(k), 0, 0), p.Rotation)
            for k, p in enumerate(path.Placements)
        ]
        obj = self.envelope([self.bar], path, CellSize=0.5)
        envelope.compute(obj)
        self.assertIn("are large: near", obj.Message)
        wall = self.box("Wall")
        wall.Placement = shift(0, 90)
        check = clearance.make_clearance(self.doc, MovingParts=[(self.bar, "")], Motion=path)
        self.doc.recompute()
        clearance.compute(check)
        self.assertIn("are large: near", check.Message)
        path.SourceType = "Stored"  # stored poses are not judged
        self.doc.recompute()
        envelope.compute(obj)
        self.assertNotIn("are large: near", obj.Message)

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

    def test_a_part_that_no_frame_moves_is_said(self):
        still, moving = self.box("Still"), self.box("Moving")

        def run():
            for k in range(3):
                moving.Placement = shift(10 * k)
                yield k
            return "stopped early"

        recording = frames.Recording(run(), [(still, ""), (moving, "")]).run()
        first_note = recording.poses(0).note
        for word in ("stopped early", '"Still" stands still in all 3 frames'):
            self.assertIn(word, first_note)
        self.assertEqual(recording.poses(1).note, "stopped early")
