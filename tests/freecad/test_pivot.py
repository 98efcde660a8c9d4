# SPDX-License-Identifier: LGPL-2.1-or-later
"""The pivot of a motion, the point that moves straight between two keys. Envelope, clearance check,
displayed line and table use the same pivot, for every pose type and wherever the motion is in the tree.
"""
import math

import FreeCAD as App
import numpy as np
import Part
from case import Case, V, shift, turn

from sweptvolume import convert
from sweptvolume.features import clearance, envelope, motion
from sweptvolume.features.base import STALE, UP_TO_DATE
from sweptvolume.trajectory.edit import Keys
from sweptvolume.trajectory.poses import Poses, at_time

#: Middle of the part in its own coordinates, far from its origin.
MIDDLE = V(105, 5, 5)
#: Half of the diagonal of the part's square section: the largest distance from the pivot in a turn about z.
REACH = 5 * math.sqrt(2)


def about(point, degrees):
    """Returns a rotation about an axis parallel to z through a point."""
    return shift(*point).multiply(turn(degrees)).multiply(shift(*-point))


class Pivot(Case):
    NEEDS_CORE = True

    def part(self, place=None):
        obj = self.doc.addObject("Part::Feature", "Cube")
        obj.Shape = Part.makeBox(10, 10, 10, V(100, 0, 0))
        obj.Placement = place or App.Placement()
        return obj

    def swept(self, part, path):
        obj = self.envelope([part], path, CellSize=0.25)
        envelope.compute(obj)
        return obj

    def assert_in_place(self, obj, middle):
        """Checks the envelope of the part, which turns by 90 degrees about its middle."""
        box, slack = obj.Mesh.BoundBox, 2 * obj.UsedCellSize.Value
        for low, high, at in ((box.XMin, box.XMax, middle.x), (box.YMin, box.YMax, middle.y)):
            self.assertAlmostEqual(low, at - REACH, delta=slack)
            self.assertAlmostEqual(high, at + REACH, delta=slack)

    def test_a_key_turned_in_place_does_not_make_the_part_swing(self):
        part = self.part()
        path = motion.motion_from_poses(self.doc, [0, 1], [shift(), about(MIDDLE, 90)])
        swinging = self.swept(part, path).Mesh.BoundBox
        self.assertGreater(swinging.YLength, 2 * REACH + 14)
        path.Pivot = MIDDLE
        self.assert_in_place(self.swept(part, path), MIDDLE)

    def test_it_is_the_same_motion_whatever_a_pose_means(self):
        initial = App.Placement(V(20, -30, 4), App.Rotation(V(0, 0, 1), 25))
        world = initial.multVec(MIDDLE)
        first = App.Placement(V(3, 2, 1), App.Rotation(V(1, 1, 0), 40))
        moved = about(world, 90)
        for frame, keys, pivot in (
            ("Absolute", [initial, moved.multiply(initial)], MIDDLE),
            ("Relative", [shift(), moved], world),
            ("RelativeToFirst", [first, moved.multiply(first)], first.inverse().multVec(world)),
        ):
            with self.subTest(frame=frame):
                part = self.part(initial)
                path = motion.motion_from_poses(self.doc, [0, 1], keys, frame=frame)
                path.Pivot = pivot
                self.assert_in_place(self.swept(part, path), world)

    def test_in_a_group_that_was_moved(self):
        group = self.doc.addObject("App::Part", "G")
        group.Placement = App.Placement(V(7, 50, 0), App.Rotation(V(0, 0, 1), 30))
        part = self.part()
        path = motion.motion_from_poses(self.doc, [0, 1], [shift(), about(MIDDLE, 90)])
        path.Pivot = MIDDLE
        for obj in (part, path):
            group.addObject(obj)
        self.doc.recompute()
        self.assert_in_place(self.swept(part, path), group.Placement.multVec(MIDDLE))

    def test_seen_from_a_part_that_stands(self):
        part, table = self.part(), self.box("Table")
        path = motion.motion_from_poses(self.doc, [0, 1], [shift(), about(MIDDLE, 90)])
        path.Pivot = MIDDLE
        rest = motion.motion_from_poses(self.doc, [0, 1], [shift(), shift()])
        obj = self.envelope([part], path, CellSize=0.25)
        obj.Reference, obj.ReferenceMotion = (table, [""]), rest
        envelope.compute(obj)
        self.assert_in_place(obj, MIDDLE)

    def test_clearance_goes_the_same_way(self):
        part, wall = self.part(), self.box("Wall")
        wall.Placement.Base = MIDDLE + V(-5, REACH + 2, -5)
        path = motion.motion_from_poses(self.doc, [0, 1], [shift(), about(MIDDLE, 90)])
        obj = clearance.make_clearance(self.doc, AllVisible=False, RequiredDistance=1)
        obj.MovingParts, obj.Motion, obj.Neighbours = [(part, "")], path, [(wall, "")]
        self.doc.recompute()
        swinging = clearance.compute(obj)["neighbours"][0]
        self.assertEqual(swinging["verdict"], "clash")
        path.Pivot = MIDDLE
        self.doc.recompute()
        self.assertEqual(obj.Status, STALE)
        found = clearance.compute(obj)["neighbours"][0]
        self.assertEqual(found["verdict"], "clear")
        self.assertAlmostEqual(found["distance"], 2, delta=0.02)

    def test_it_counts_where_it_changes_the_way_and_only_there(self):
        part = self.part()
        path = motion.motion_from_poses(self.doc, [0, 1], [shift(), about(MIDDLE, 90)])
        obj = self.swept(part, path)
        for kind, before in (("Linear", UP_TO_DATE), ("Spline", STALE), ("Screw", STALE)):
            path.Interpolation, path.Pivot = kind, V()
            self.doc.recompute()
            self.assertEqual(obj.Status, before)
            envelope.compute(obj)
            path.Pivot = MIDDLE
            self.doc.recompute()
            self.assertEqual(obj.Status, UP_TO_DATE if kind == "Screw" else STALE, kind)

    def test_a_spline_goes_through_the_places_of_the_pivot(self):
        keys = [about(MIDDLE, 90.0 * k) for k in range(3)]
        poses = Poses([0, 1, 2], [shift(10.0 * k).multiply(p) for k, p in enumerate(keys)])
        poses.pivot = MIDDLE
        for k in range(21):
            here = at_time(poses, "Spline", 0.1 * k).multVec(MIDDLE)
            self.assertLess((here - MIDDLE - V(k, 0, 0)).Length, 1e-9)

    def test_an_envelope_tells_its_motion_which_part_moves(self):
        part, path = self.part(), self.line()
        self.assertEqual(motion.parts_of(path), [])
        self.envelope([part], path)
        self.assertEqual(motion.parts_of(path), [(part, "")])
        self.doc.recompute()
        state = list(path.State)
        part.Placement.Base.x = 3
        self.doc.recompute()
        self.assertEqual(list(path.State), state)  # its poses do not follow the part
        self.doc.removeObject(part.Name)
        self.doc.recompute()
        self.assertEqual((motion.parts_of(path), path.Status), ([], ""))


class Numbers(Case):
    """The numbers that the table of keys shows and accepts."""

    def test_a_typed_angle_turns_about_the_pivot(self):
        keys = Keys([0.0], [shift(1, 2, 3)], pivot=MIDDLE)
        self.assertEqual(keys.numbers(0), (106.0, 7.0, 8.0, 0.0, 0.0, 0.0))
        keys.update(0, keys.placed((106, 7, 8, 90, 0, 0)))
        self.assertLess((keys.placements[0].multVec(MIDDLE) - V(106, 7, 8)).Length, 1e-9)
        self.assertAlmostEqual(math.degrees(keys.placements[0].Rotation.Angle), 90)

    def test_displacements_are_zero_where_the_part_stays(self):
        keys = Keys([0.0, 1.0], [shift(), about(MIDDLE, 90)], pivot=MIDDLE, displaces=True)
        self.assertEqual(keys.numbers(0), (0.0,) * 6)
        np.testing.assert_allclose(keys.numbers(1), (0, 0, 0, 90, 0, 0), atol=1e-9)
        self.assert_placement(keys.placed(keys.numbers(1)), keys.placements[1])

    def test_a_key_between_two_lies_on_the_way_of_the_pivot(self):
        keys = Keys([0.0, 1.0], [shift(), about(MIDDLE, 90)], pivot=MIDDLE)
        keys.insert_after(0)
        self.assertLess((keys.placements[1].multVec(MIDDLE) - MIDDLE).Length, 1e-9)

    def test_without_a_pivot_nothing_is_calculated_anew(self):
        place = App.Placement(V(0.1, 0.2, 0.3), App.Rotation(0.3, 0.7, -1.1))
        keys = Keys([0.0], [place])
        there = convert.matrix_of(at_time(keys.poses(), "Linear", 0.0))
        self.assertTrue((there == convert.matrix_of(place)).all())
