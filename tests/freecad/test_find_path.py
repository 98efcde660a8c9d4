# SPDX-License-Identifier: LGPL-2.1-or-later
"""Paths found and improved in documents: the motion keeps the clearance that the core guarantees, wherever
the parts and motions are in the tree. The workbench's own clearance check confirms each path.
"""
import unittest

import FreeCAD as App

from case import Case, V, shift, turn
from sweptvolume import core
from sweptvolume.features import clearance, improve_plan, motion, path_plan
from sweptvolume.features.neighbour_rules import Rule


class Paths(Case):
    NEEDS_CORE = True

    def channel(self, group=None, size=10.0):
        """Makes a cube between two walls, 1 mm above a floor, all in `group` if it is given.
        Returns (cube, walls)."""
        part = self.box("Cube", size)
        walls = []
        for name, sizes, at in (
            ("Left", (60, 5, 40), (-25, -6.5, -10)),
            ("Right", (60, 5, 40), (-25, 11.5, -10)),
            ("Floor", (60, 12, 5), (-25, -1, -6)),
        ):
            wall = self.doc.addObject("Part::Box", name)
            wall.Length, wall.Width, wall.Height = sizes
            wall.Placement.Base = V(*at)
            walls.append(wall)
        if group is not None:
            for obj in [part] + walls:
                group.addObject(obj)
        self.doc.recompute()
        return part, walls

    def checked(self, path, pairs, required):
        """Returns {name: row} of a clearance check along this path."""
        root, sub = pairs[0]
        obj = clearance.make_clearance(
            self.doc, Motion=path, AllVisible=True, RequiredDistance=required, MeshDeflection=0.05
        )
        obj.MovingParts = [(root, sub)]
        self.doc.recompute()
        return {row["name"]: row for row in clearance.compute(obj)["neighbours"]}

    def assert_clear(self, path, pairs, required):
        rows = self.checked(path, pairs, required)
        self.assertEqual({row["verdict"] for row in rows.values()}, {"clear"}, rows)

    def beside(self, pairs):
        return path_plan.beside(self.doc, pairs).leaves()

    def test_found_path_is_a_motion_of_the_part_in_one_step_of_undo(self):
        part, _ = self.channel()
        pairs, undo = [(part, "")], self.doc.UndoCount
        plan = path_plan.PathPlan(
            self.doc, pairs, self.beside(pairs), start=shift(0, 0, 80), RequiredDistance=0.5
        )
        report, path = path_plan.find(plan)
        self.assertEqual((report["verdict"], self.doc.UndoCount), ("found", undo + 1))
        self.assertEqual(motion.parts_of(path), pairs)
        self.assert_placement(path.Placements[0], shift(0, 0, 80))
        self.assert_placement(path.Placements[-1], part.Placement)
        self.assertEqual(tuple(path.Pivot), (5, 5, 5))
        self.doc.undo()
        self.assertFalse([o for o in self.doc.Objects if motion.is_motion(o)])
        self.doc.redo()
        path = next(o for o in self.doc.Objects if motion.is_motion(o))
        self.assert_clear(path, pairs, 0.5)

    def test_parts_in_moved_groups_and_links(self):
        outer = self.doc.addObject("App::Part", "Outer")
        inner = self.doc.addObject("App::Part", "Inner")
        outer.addObject(inner)
        outer.Placement = turn(35, V(1, 2, 3), V(100, -40, 7))
        inner.Placement = turn(-70, V(0, 1, 1), V(5, 5, 5))
        part, _ = self.channel(inner)
        link = self.doc.addObject("App::Link", "Twin")
        link.LinkedObject = part
        # In the coordinate system of the channel, beside the cube.
        link.Placement = turn(90, V(0, 0, 1), V(31, 0, 3))
        inner.addObject(link)
        self.doc.recompute()
        for pairs in ([(outer, "Inner.Cube.")], [(outer, "Inner.Twin.")]):
            plan = path_plan.PathPlan(
                self.doc,
                pairs,
                self.beside(pairs),
                extract=60.0,
                RequiredDistance=0.4,
                ReleaseDistance=5.0,
            )
            self.assertEqual(len(plan.neighbours), 4)
            report, path = path_plan.find(plan)
            self.assertEqual(report["verdict"], "found", report)
            root, sub = pairs[0]
            self.assert_placement(
                motion.world_poses_of(path).placements[-1], root.getSubObject(sub, retType=3)
            )
            self.assert_clear(path, pairs, 0.4)

    def test_clearances_of_their_own(self):
        part, walls = self.channel()
        pairs = [(part, "")]
        plan = path_plan.PathPlan(
            self.doc, pairs, self.beside(pairs), extract=V(0, 0, 1), RequiredDistance=0.5,
            rules={(walls[2], ""): Rule(length=0.85)}, ReleaseDistance=0.0,
        )  # fmt: skip
        _, path = path_plan.find(plan)
        self.assertGreaterEqual(self.checked(path, pairs, 0.5)["Floor"]["guaranteed"], 0.84)
        plan.rules = {(walls[2], ""): Rule(length=1.5)}  # the floor is 1 mm below
        with self.assertRaises(core.CoreError) as refused:
            path_plan.find(plan)
        self.assertEqual(refused.exception.code, "GoalBlocked")
        self.assertIn("Floor", str(refused.exception))

    def test_refusals_are_named_and_change_nothing(self):
        part, walls = self.channel()
        pairs = [(part, "")]
        beside, known = self.beside(pairs), len(self.doc.Objects)
        cases = [
            (dict(start=part.Placement), "SamePose"),
            (dict(start=shift(0, 4, 0)), "StartBlocked"),
            (dict(goal=shift(0, 0, -3), extract=50.0), "GoalBlocked"),
            (dict(extract=50.0, Budget=0.0), "BadOption"),
            (dict(extract=V(0, 0, 0)), "BadOption"),
        ]
        for given, code in cases:
            plan = path_plan.PathPlan(
                self.doc, pairs, beside, ReleaseDistance=0.0, RequiredDistance=0.3, **given
            )
            with self.assertRaises(core.CoreError, msg=given) as refused:
                path_plan.find(plan)
            self.assertEqual(refused.exception.code, code)
        for given in (dict(neighbours=[]), dict(pairs=[]), dict()):
            with self.assertRaises(path_plan.InputProblem):
                path_plan.find(
                    path_plan.PathPlan(
                        self.doc, **dict(dict(pairs=pairs, neighbours=beside), **given)
                    )
                )
        self.assertEqual(len(self.doc.Objects), known)

    def test_nothing_found_says_how_far_it_came(self):
        part, walls = self.channel()
        lid = self.doc.addObject("Part::Box", "Lid")
        lid.Length, lid.Width, lid.Height = 60, 23, 5
        lid.Placement.Base = V(-25, -6.5, 30)
        for name, x in (("Front", -30), ("Back", 35)):
            end = self.doc.addObject("Part::Box", name)
            end.Length, end.Width, end.Height = 5, 23, 45
            end.Placement.Base = V(x, -6.5, -10)
        self.doc.recompute()
        pairs, known = [(part, "")], len(self.doc.Objects)
        plan = path_plan.PathPlan(
            self.doc, pairs, self.beside(pairs), extract=100.0, RequiredDistance=0.5, Budget=5.0
        )
        report, path = path_plan.find(plan)
        self.assertEqual((report["verdict"], path), ("not_found", None))
        self.assertGreater(report["escape"]["distance"], 5)
        self.assertTrue(report["escape"]["blockers"])
        self.assertEqual(len(self.doc.Objects), known)

    def motion_through_a_post(self, **settings):
        """Makes a motion through a post that stands in the channel. An improved motion must go around the
        post. Returns (motion, pairs of its parts).
        """
        part, walls = self.channel()
        post = self.doc.addObject("Part::Box", "Post")
        post.Length = post.Width = post.Height = 4
        post.Placement.Base = V(4, 4, 40)
        places = [shift(0, 0, 80), shift(20, 0, 70), shift(0, 0, 60), shift(0, 0, 0)]
        path = motion.motion_from_poses(self.doc, [0, 1, 2, 4], places)
        for name, value in settings.items():
            setattr(path, name, value)
        motion.set_parts(path, [(part, "")])
        self.doc.recompute()
        return path, [(part, "")]

    def test_a_clash_is_led_round_whatever_the_motion_is(self):
        for settings in (
            {},
            {"Interpolation": "Screw"},
            {"Interpolation": "Spline"},
            {"PoseType": "Relative"},
            {"Pivot": V(5, 5, 5)},
        ):
            with self.subTest(settings=settings):
                for name in [o.Name for o in self.doc.Objects]:
                    self.doc.removeObject(name)
                path, pairs = self.motion_through_a_post(**settings)
                self.assertEqual(self.checked(path, pairs, 0.4)["Post"]["verdict"], "clash")
                plan = improve_plan.ImprovePlan(
                    path, pairs, self.beside(pairs), RequiredDistance=0.4, Budget=20.0
                )
                report, better = improve_plan.improve(plan)
                self.assertEqual(report["unmended_moves"], 0, report)
                self.assertEqual(report["before"]["clearance"], 0)
                self.assert_clear(better, pairs, 0.4)
                self.assertEqual(better.Times[0], 0)
                self.assertEqual(better.Times[-1], 4)
                self.assert_placement(better.Placements[0], shift(0, 0, 80), 1e-6)
                self.assert_placement(better.Placements[-1], shift(), 1e-6)

    def test_locked_keys_stay_and_a_group_does_not_matter(self):
        group = self.doc.addObject("App::Part", "Group")
        group.Placement = turn(25, V(3, 1, 0), V(7, 8, 9))
        path, pairs = self.motion_through_a_post()
        for obj in [
            o for o in self.doc.Objects if o.Name in ("Cube", "Left", "Right", "Floor", "Post")
        ]:
            group.addObject(obj)
        group.addObject(path)
        self.doc.recompute()
        pairs = [(group, "Cube.")]
        plan = improve_plan.ImprovePlan(
            path, pairs, self.beside(pairs), locked=[0, 1, 3], RequiredDistance=0.4, Budget=20.0
        )
        report, better = improve_plan.improve(plan)
        self.assertEqual(report["unmended_moves"], 0, report)
        k = list(better.Times).index(1.0)
        there = motion.world_poses_of(better).placements[k]
        self.assert_placement(there, group.Placement.multiply(shift(20, 0, 70)), 1e-6)
        self.assert_clear(better, pairs, 0.4)

    def test_copies_cannot_be_improved(self):
        path, pairs = self.motion_through_a_post(Interpolation="None")
        with self.assertRaises(improve_plan.InputProblem):
            improve_plan.improve(improve_plan.ImprovePlan(path, pairs, self.beside(pairs)))


class Demo(unittest.TestCase):
    def test_the_starter_motor_finds_its_way(self):
        """Finds a path out of the assembled position with at least the clearance of the path designed
        by hand: 1.37 mm, except for the last 20 mm."""
        if not core.available():
            self.skipTest("the compiled core _swept is not built")
        from sweptvolume import demo

        scene = demo.build()
        pairs = [(scene.starter, "")]
        try:
            plan = path_plan.PathPlan(
                scene.document, pairs, path_plan.beside(scene.document, pairs).leaves(),
                start=scene.motion.Placements[0], RequiredDistance=1.37, ReleaseDistance=20.0,
            )  # fmt: skip
            report, path = path_plan.find(plan)
            self.assertEqual(report["verdict"], "found", report["summary"])
            check = clearance.make_clearance(
                scene.document,
                MovingParts=[scene.starter],
                Motion=path,
                AllVisible=True,
                RequiredDistance=1.37,
            )
            scene.document.recompute()
            rows = {row["name"]: row for row in clearance.compute(check)["neighbours"]}
            verdicts = {
                name: row["verdict"] for name, row in rows.items() if name != "Bell housing"
            }
            self.assertEqual(set(verdicts.values()), {"clear"}, verdicts)
            touched = rows["Bell housing"]["below"]
            self.assertEqual(len(touched), 1, touched)
            there = motion.poses_of(path)
            from sweptvolume.trajectory.poses import at_time

            begins = at_time(there, "Linear", touched[0][0])
            self.assertLess((begins.Base - path.Placements[-1].Base).Length, 20.0)
        finally:
            App.closeDocument(scene.document.Name)
