# SPDX-License-Identifier: LGPL-2.1-or-later
"""Motion objects: where their poses come from, what a pose means, and which input is refused."""
import os

import FreeCAD as App

from case import SHARED, Case, V, shift, turn
from sweptvolume.convert import InputProblem
from sweptvolume.features import envelope, motion
from sweptvolume.trajectory.poses import Poses, at_time, base_of, course, straightened

CSV = (
    "# unit: cm\nt,tx,ty,tz,qx,qy,qz,qw\n"
    "0,0,0,0,0,0,0,1\n2,1,2,3,0,0,0.7071067811865476,0.7071067811865476\n"
)


class Motion(Case):
    def test_stored_poses_and_read_outs(self):
        obj = motion.motion_from_poses(self.doc, [1, 3.5], [shift(), turn(90)], "Screw", "Relative")
        self.doc.recompute()
        self.assertEqual((obj.Count, obj.Duration, obj.Interpolation), (2, 2.5, "Screw"))
        self.assertEqual((obj.PoseType, obj.SourceType, obj.Status), ("Relative", "Stored", ""))

    def test_times_may_not_go_back(self):
        with self.assertRaisesRegex(InputProblem, "Pose 3: .*0.5 s is earlier than the time 1 s"):
            Poses([0, 1, 0.5], [shift()] * 3)

    def test_bad_edit_is_told_and_marks_the_object(self):
        obj = self.line()
        obj.Times = [0, 1, 2]
        self.doc.recompute()
        self.assertIn("3 times but 2 placements", obj.Status)
        self.assertIn("Invalid", obj.State)

    def test_linked_placements_follow(self):
        boxes = [self.box("B%d" % i) for i in range(3)]
        for i, box in enumerate(boxes):
            box.Placement = shift(10 * i)
        obj = motion.motion_from_objects(self.doc, boxes, step=0.5)
        self.doc.recompute()
        self.assertEqual(obj.Times, [0, 0.5, 1])
        boxes[2].Placement = turn(45, base=V(9, 9, 9))
        self.doc.recompute()
        self.assert_placement(obj.Placements[2], boxes[2].Placement)

    def test_placements_are_global(self):
        group, box = self.doc.addObject("App::Part", "G"), self.box()
        group.Placement, box.Placement = shift(0, 100), shift(1)
        group.addObject(box)
        self.doc.recompute()
        obj = motion.motion_from_objects(self.doc, [box])
        self.assert_placement(obj.Placements[0], shift(1, 100))

    def test_capture(self):
        obj = self.line()
        motion.capture(obj, shift(5, 5))
        self.assertEqual(obj.Times, [0, 1, 2])
        with self.assertRaises(InputProblem):
            motion.capture(obj, shift(), time=1.5)
        self.assertEqual(len(obj.Placements), 3)

    def test_save_and_open(self):
        obj = motion.motion_from_poses(self.doc, [0, 2], [shift(3), turn(33)], "Screw")
        self.doc.recompute()
        name, path = obj.Name, os.path.join(self.folder, "Bewegung ä.FCStd")
        self.doc.saveAs(path)
        App.closeDocument(self.doc.Name)
        obj = App.openDocument(path).getObject(name)
        self.assertEqual((obj.Times, obj.Interpolation), ([0, 2], "Screw"))
        self.assert_placement(obj.Placements[1], turn(33))
        self.assertTrue(motion.is_motion(obj))

    def test_frames(self):
        poses = Poses([0, 1], [shift(10), shift(20)])
        standing = shift(3, 4)
        cases = {
            "Absolute": ([10, 20], 0),
            "Relative": ([13, 23], 4),
            "RelativeToFirst": ([3, 13], 4),
        }
        for frame, (xs, y) in cases.items():
            base = base_of(poses, frame, standing)
            for place, x in zip(poses.placements, xs):
                world = place.multiply(base.inverse()).multiply(standing)
                self.assert_placement(world, shift(x, y))

    def test_between_poses(self):
        poses = Poses([0, 2], [shift(), turn(90, base=V(10, 0, 0))])
        self.assert_placement(at_time(poses, "Linear", 1), turn(45, base=V(5, 0, 0)), 1e-7)
        self.assert_placement(at_time(poses, "None", 1.9), shift())
        screw = at_time(poses, "Screw", 1)
        self.assert_placement(screw.multiply(screw), turn(90, base=V(10, 0, 0)), 1e-7)


class Spline(Case):
    """A smooth motion passes through its keys without a jump of the velocity, with the given tangents."""

    def keys(self, tangents=()):
        places = [shift(), turn(40, V(1, 1, 0), V(10, 5)), turn(100, V(0, 1, 1), V(12, 20, 5))]
        places.append(turn(170, V(0, 0, 1), V(0, 30, 5)))
        return Poses([0, 1, 3, 4], places, tangents)

    def velocity(self, at, time, step):
        """Returns the velocities (mm/s) of the origin and of a point of the part away from it."""
        a, b = at(time), at(time + step)
        off = V(7, -3, 11)
        return (b.Base - a.Base) / step, (b.multVec(off) - a.multVec(off)) / step

    def test_through_the_keys(self):
        poses = self.keys()
        at = course(poses, "Spline")
        for time, place in zip(poses.times, poses.placements):
            self.assert_placement(at(time), place, 1e-9)

    def test_velocity_does_not_jump(self):
        at, step = course(self.keys(), "Spline"), 1e-5
        for time in (1, 3):
            before, after = self.velocity(at, time, -step), self.velocity(at, time, step)
            for a, b in zip(before, after):
                self.assertLess((a - b).Length, 2e-3 * a.Length)
        linear = course(self.keys(), "Linear")
        a, b = self.velocity(linear, 1, -step)[0], self.velocity(linear, 1, step)[0]
        self.assertGreater((a - b).Length, 1, "the test would not see a jump")

    def test_tangents_at_keys(self):
        given = [("Stop", None), ("Given", V(0, 9, 1)), ("Corner", None)]
        at, step = course(self.keys(given), "Spline"), 1e-6
        for v in self.velocity(at, 0, step):
            self.assertLess(v.Length, 1e-2)
        for side in (-step, step):
            self.assertLess((self.velocity(at, 1, side)[0] - V(0, 9, 1)).Length, 1e-2)
        keys = self.keys().placements
        into = (keys[2].Base - keys[1].Base) / 2
        out = keys[3].Base - keys[2].Base
        self.assertLess((self.velocity(at, 3, -step)[0] - into).Length, 1e-2)
        self.assertLess((self.velocity(at, 3, step)[0] - out).Length, 1e-2)

    def test_straight_pieces_are_near_enough(self):
        at, reach, tolerance = course(self.keys(), "Spline"), 25.0, 0.05
        pieces = straightened(at, [0, 1, 3, 4], reach, tolerance)
        self.assertTrue({0, 1, 3, 4}.issubset(pieces.times))
        off, worst = V(15, 0, 20), 0.0
        for k in range(801):
            straight = at_time(pieces, "Linear", k / 200)
            worst = max(worst, (straight.multVec(off) - at(k / 200).multVec(off)).Length)
        self.assertLess(worst, tolerance)
        self.assertGreater(worst, tolerance / 100)

    def test_saved_with_its_tangents(self):
        poses = self.keys()
        obj = motion.motion_from_poses(self.doc, poses.times, poses.placements, "Spline")
        obj.Tangents = ["Stop", "Given"]
        obj.Velocities = [V(), V(0, 9, 1)]
        self.doc.recompute()
        before, name = motion.words(obj), obj.Name
        self.reopen()
        obj = self.doc.getObject(name)
        self.assertEqual(motion.words(obj), before)
        at = course(motion.poses_of(obj), obj.Interpolation)
        self.assertLess((self.velocity(at, 1, 1e-6)[0] - V(0, 9, 1)).Length, 1e-2)


class MotionFile(Case):
    NEEDS_CORE = True

    def test_poses_with_one_time_keep_their_order_as_in_the_core(self):
        """Two poses have the same time. The part moves between them; its placement at this time is
        the last."""
        places = [shift(), shift(10), shift(10, 20), shift(30, 20)]
        obj = motion.motion_from_poses(self.doc, [0, 1, 1, 2], places)
        hull = self.envelope([self.box()], obj, CellSize=0.5)
        found = envelope.compute(hull)
        box = hull.Mesh.BoundBox
        self.assertAlmostEqual(box.XLength, 40, delta=0.5)
        self.assertAlmostEqual(box.YLength, 30, delta=0.5)
        self.assertIn("EqualTimes", [w["code"] for w in found.report["warnings"]])
        self.assertIn("the same time as the pose before", hull.Message)
        here = at_time(motion.poses_of(obj), "Linear", 1.0)
        self.assertEqual((here.Base.x, here.Base.y), (10, 20))
        obj.Interpolation = "Spline"
        self.doc.recompute()
        with self.assertRaisesRegex(InputProblem, "Poses 2 and 3 have the same time"):
            envelope.compute(hull)
        obj.Interpolation = "Linear"
        rest = motion.motion_from_poses(self.doc, [0, 2], [shift(), shift()])
        hull.Reference, hull.ReferenceMotion = (self.box("Table"), [""]), rest
        with self.assertRaisesRegex(InputProblem, "has a reference part"):
            envelope.compute(hull)

    def test_csv_with_unit(self):
        obj = motion.motion_from_file(self.doc, self.file("m.csv", CSV), "cm")
        self.assertEqual(obj.Times, [0, 2])
        self.assert_placement(obj.Placements[1], turn(90, base=V(10, 20, 30)), 1e-9)

    def test_reload(self):
        path = self.file("m.csv", CSV)
        obj = motion.motion_from_file(self.doc, path, "mm")
        self.file("m.csv", CSV + "3,0,0,0,0,0,0,1\n")
        self.doc.recompute()
        self.assertEqual(len(obj.Times), 2)
        motion.reload_source(obj)
        self.assertEqual(len(obj.Times), 3)

    def test_changed_file_makes_the_motion_stale(self):
        path = self.file("m.csv", CSV)
        obj, saved = motion.motion_from_file(self.doc, path), os.path.join(self.folder, "f.FCStd")
        self.doc.recompute()
        self.assertEqual(obj.Status, "")
        name = obj.Name
        self.doc.saveAs(saved)
        App.closeDocument(self.doc.Name)
        self.file("m.csv", CSV + "3,0,0,0,0,0,0,1\n")
        obj = App.openDocument(saved).getObject(name)
        self.assertEqual((obj.Status, len(obj.Times)), (motion.STALE, 2))
        motion.reload_source(obj)
        obj.Document.recompute()
        self.assertEqual((obj.Status, len(obj.Times)), ("", 3))

    def test_packed_files(self):
        import gzip
        import lzma

        for suffix, opener in ((".gz", gzip.open), (".xz", lzma.open)):
            path = os.path.join(self.folder, "m.csv" + suffix)
            with opener(path, "wt", encoding="utf-8") as out:
                out.write(CSV)
            obj = motion.motion_from_file(self.doc, path, "cm")
            self.assert_placement(obj.Placements[1], turn(90, base=V(10, 20, 30)), 1e-9)
            motion.reload_source(obj)
            self.assertEqual(len(obj.Times), 2)

    def test_matrices(self):
        rows = "1,0,0,4,0,1,0,5,0,0,1,6,0,0,0,1\n0,-1,0,0,1,0,0,0,0,0,1,0,0,0,0,1\n"
        obj = motion.motion_from_file(self.doc, self.file("m.csv", rows))
        self.assert_placement(obj.Placements[0], shift(4, 5, 6))
        self.assert_placement(obj.Placements[1], turn(90))

    def test_bad_file_names_line_and_leaves_the_document(self):
        before = len(self.doc.Objects)
        path = self.file("kaputt.csv", CSV + "3,0,0,zero,0,0,0,1\n")
        with self.assertRaisesRegex(InputProblem, "kaputt.csv: .*line 5"):
            motion.motion_from_file(self.doc, path)
        with self.assertRaisesRegex(InputProblem, "does not exist"):
            motion.motion_from_file(self.doc, path + "x")
        self.assertEqual(len(self.doc.Objects), before)

    def test_recorded_arm(self):
        path = os.path.join(SHARED, "motions", "installation_34_from_baxter_left.csv")
        if not os.path.isfile(path):
            self.skipTest("the shared recordings are not here")
        obj = motion.motion_from_file(self.doc, path, "m")
        self.assertEqual(len(obj.Times), 34)
        self.assertAlmostEqual(obj.Placements[0].Base.x, 768.446, 6)
