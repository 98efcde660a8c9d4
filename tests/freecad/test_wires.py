# SPDX-License-Identifier: LGPL-2.1-or-later
"""Motions along wires."""
import itertools
import math

import numpy as np
import Part

from case import Case, V
from sweptvolume import core
from sweptvolume.convert import InputProblem
from sweptvolume.features import envelope, motion
from sweptvolume.trajectory.poses import course


def distance(point, line):
    """Returns the distance of a point (3,) from a line through points (n, 3)."""
    start, chord = line[:-1], np.diff(line, axis=0)
    part = np.einsum("ij,ij->i", point - start, chord) / np.maximum(
        (chord**2).sum(axis=1), 1e-300
    )
    near = start + np.clip(part, 0.0, 1.0)[:, None] * chord
    return float(np.sqrt(((point - near) ** 2).sum(axis=1).min()))


class Wires(Case):
    """A motion along a wire passes through its corners and deviates from it by no more than the
    accuracy."""

    def wire(self, *edges):
        obj = self.doc.addObject("Part::Feature", "Wire")
        obj.Shape = Part.Wire(list(edges))
        return obj

    def assert_within(self, path, wire, accuracy):
        """Checks both directions: the motion deviates from the wire by at most `accuracy`, and leaves out
        no part of the wire."""
        fine = [np.array([tuple(p) for p in e.discretize(Number=3000)]) for e in wire.Shape.Edges]
        own = np.array([tuple(place.Base) for place in path.Placements])
        # The fine pieces are chords themselves, each 1/3000 of an edge.
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
            # Points one turn apart have the same tangent and lie above each other.
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
            (1e-7, "enter a larger value"),
        ):
            with self.assertRaisesRegex(InputProblem, words):
                motion.motion_from_source(self.doc, "Curve", [ring], accuracy=accuracy)
