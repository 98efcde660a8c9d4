# SPDX-License-Identifier: LGPL-2.1-or-later
"""Motion objects: where poses come from, what they mean, what is refused."""
import os

import FreeCAD as App

from case import SHARED, Case, V, shift, turn
from sweptvolume.convert import InputProblem
from sweptvolume.features import motion
from sweptvolume.trajectory.poses import Poses, at_time, in_frame

CSV = (
    "# unit: cm\nt,tx,ty,tz,qx,qy,qz,qw\n"
    "0,0,0,0,0,0,0,1\n2,1,2,3,0,0,0.7071067811865476,0.7071067811865476\n"
)


class Motion(Case):
    def test_stored_poses_and_read_outs(self):
        obj = motion.motion_from_poses(self.doc, [1, 3.5], [shift(), turn(90)], "Screw", "Relative")
        self.doc.recompute()
        self.assertEqual((obj.Count, obj.Duration, obj.Interpolation), (2, 2.5, "Screw"))
        self.assertEqual((obj.Frame, obj.SourceType, obj.Status), ("Relative", "Stored", ""))

    def test_times_must_grow(self):
        with self.assertRaisesRegex(InputProblem, "pose 3: .*1 s is not after the 1 s"):
            Poses([0, 1, 1], [shift()] * 3)

    def test_bad_edit_is_told_and_marks_the_object(self):
        obj = self.line()
        obj.Times = [0, 1, 2]
        self.doc.recompute()
        self.assertIn("3 times and 2 placements", obj.Status)
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
            places, base = in_frame(poses, frame, standing)
            for place, x in zip(places, xs):
                world = place.multiply(base.inverse()).multiply(standing)
                self.assert_placement(world, shift(x, y))

    def test_between_poses(self):
        poses = Poses([0, 2], [shift(), turn(90, base=V(10, 0, 0))])
        self.assert_placement(at_time(poses, "Linear", 1), turn(45, base=V(5, 0, 0)), 1e-7)
        self.assert_placement(at_time(poses, "None", 1.9), shift())
        screw = at_time(poses, "Screw", 1)
        self.assert_placement(screw.multiply(screw), turn(90, base=V(10, 0, 0)), 1e-7)


class MotionFile(Case):
    NEEDS_CORE = True

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
