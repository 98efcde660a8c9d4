# SPDX-License-Identifier: LGPL-2.1-or-later
"""Sequences in documents: the motions appear in the order of the sequence, and each is clear of all parts
that are already in place. After a change they are checked again.
"""
import FreeCAD as App

from case import Case, V, shift, turn
from sweptvolume import core
from sweptvolume.convert import InputProblem
from sweptvolume.features import clearance, motion, sequence
from sweptvolume.features.base import STALE, UP_TO_DATE
from sweptvolume.features.neighbour_rules import Rule
from sweptvolume.features.pair_rules import key
from shaft import plan_of, shaft, stack


class Sequences(Case):
    NEEDS_CORE = True

    def setUp(self):
        super().setUp()
        self.walls, self.parts = shaft(self.doc), stack(self.doc)
        self.doc.recompute()

    def assert_clear(self, obj):
        """Checks each motion with the workbench's clearance check against the parts already in place."""
        there = [(wall, "") for wall in self.walls]
        for (part, subs), path in zip(obj.MovingParts, obj.Motions):
            check = clearance.make_clearance(
                self.doc, Motion=path, AllVisible=False, RequiredDistance=0.4, MeshDeflection=0.05
            )
            check.MovingParts, check.Neighbours = [(part, "")], there
            self.doc.recompute()
            found = clearance.compute(check)["neighbours"]
            self.assertEqual({row["verdict"] for row in found}, {"clear"}, (part.Label, found))
            there = there + [(part, "")]
            self.doc.removeObject(check.Name)

    def test_an_order_is_found_and_kept_in_one_step_of_undo(self):
        undo, known = self.doc.UndoCount, len(self.doc.Objects)
        report, obj = sequence.find(plan_of(self.doc, self.parts, self.walls, Order="find"))
        self.assertEqual((report["verdict"], self.doc.UndoCount), ("found", undo + 1))
        self.assertEqual([part.Name for part, _ in obj.MovingParts], ["Lower", "Upper"])
        self.assertEqual(
            [motion.parts_of(path)[0][0].Name for path in obj.Motions], ["Lower", "Upper"]
        )
        self.assertEqual((obj.Status, obj.Verdict, obj.Checked), (UP_TO_DATE, "clear", 2))
        self.assertIn("Lower, Upper", obj.Summary)
        self.doc.undo()
        self.assertEqual(len(self.doc.Objects), known)
        self.doc.redo()
        again = self.doc.getObject(obj.Name)
        self.assertEqual((again.Status, len(again.Motions)), (UP_TO_DATE, 2))
        self.assert_clear(again)

    def test_what_was_found_is_checked_again_as_given(self):
        _, obj = sequence.find(plan_of(self.doc, self.parts, self.walls, Order="find"))
        report = sequence.compute(obj)
        self.assertEqual([step["method"] for step in report["steps"]], ["given", "given"])
        self.assertEqual((obj.Status, report["verdict"]), (UP_TO_DATE, "found"))
        # The other order: the lower block has to pass the upper one.
        obj.MovingParts = list(reversed([(part, "") for part, _ in obj.MovingParts]))
        obj.Motions = list(reversed(obj.Motions))
        self.doc.recompute()
        self.assertEqual(obj.Status, STALE)
        report = sequence.compute(obj)
        self.assertEqual((report["verdict"], obj.Verdict), ("not_found", "clash"))
        self.assertEqual(report["steps"][1]["escape"]["blockers"], ["Upper"])

    def test_an_order_that_cannot_be_writes_nothing(self):
        known, undo = len(self.doc.Objects), self.doc.UndoCount
        plan = plan_of(self.doc, self.parts, self.walls, MostMoves=1)
        report, obj = sequence.find(plan)
        self.assertIsNone(obj)
        self.assertEqual([s["verdict"] for s in report["steps"]][0], "found")
        self.assertNotEqual(report["steps"][1]["verdict"], "found")
        self.assertEqual((len(self.doc.Objects), self.doc.UndoCount), (known, undo))
        self.assertIn("1 of 2", sequence.summary(report))
        self.assertIn('"Lower"', sequence.description(report))

    def test_a_motion_of_ones_own_is_kept(self):
        path = motion.motion_from_poses(
            self.doc, [0, 5], [shift(0, 0, 80).multiply(self.parts[0].Placement),
                               self.parts[0].Placement]
        )  # fmt: skip
        path.PoseType = "Absolute"
        motion.set_parts(path, [(self.parts[0], "")])
        self.doc.recompute()
        parts = self.parts[::-1]
        report, obj = sequence.find(plan_of(self.doc, parts, self.walls, [None, path]))
        self.assertEqual(report["verdict"], "found", report)
        self.assertIs(obj.Motions[1], path)
        self.assertEqual([s["method"] == "given" for s in report["steps"]], [False, True])
        step = report["steps"][1]
        self.assertAlmostEqual(step["end"] - step["begin"], 5.0)
        seen = sequence.Plan.of(obj).seen()
        at = seen[1][1]  # the part waits, moves, and then stays
        self.assert_placement(at(0.0), at(step["begin"]))
        self.assert_placement(at(step["end"] + 1), at(step["end"]))
        self.assertGreater((at(step["begin"]).Base - at(step["end"]).Base).Length, 79)

    def test_rules_of_pairs(self):
        plan = plan_of(self.doc, self.parts[::-1], self.walls)
        plan.values["RequiredDistance"] = 1.2  # they are 1 mm from the walls and from each other
        with self.assertRaises(core.CoreError) as refused:
            sequence.find(plan)
        self.assertEqual(refused.exception.code, "PartsTooNear")
        everything = self.parts + self.walls
        plan.pair_rules = {
            key((a, ""), (b, "")): Rule(length=0.5)
            for a in self.parts
            for b in everything
            if a is not b
        }
        report, obj = sequence.find(plan)
        self.assertEqual(report["verdict"], "found", report)
        self.assertEqual(sequence.Plan.of(obj).pair_rules, plan.pair_rules)

    def test_wrong_input_is_named(self):
        with self.assertRaisesRegex(InputProblem, "The list of parts is empty"):
            plan_of(self.doc, [], self.walls).request()
        twice = plan_of(self.doc, [self.parts[0], self.parts[0]], self.walls)
        with self.assertRaisesRegex(InputProblem, "is in the list twice"):
            twice.request()
        self.parts[0].Placement.Base.z -= 3
        self.doc.recompute()
        with self.assertRaises(core.CoreError) as refused:
            sequence.find(plan_of(self.doc, self.parts, self.walls))
        self.assertEqual(refused.exception.code, "PartsIntersect")
        for name in ("Upper", "Lower", "2 mm"):
            self.assertIn(name, str(refused.exception))

    def test_parts_in_moved_groups(self):
        group = self.doc.addObject("App::Part", "Group")
        for obj in self.parts + self.walls:
            group.addObject(obj)
        group.Placement = turn(35, V(1, 2, 3), V(100, -40, 7))
        self.doc.recompute()
        plan = plan_of(self.doc, [], [], Order="find")
        plan.pairs = [(group, "Upper."), (group, "Lower.")]
        plan.motions = [None, None]
        plan.neighbours = [(group, wall.Name + ".") for wall in self.walls]
        report, obj = sequence.find(plan)
        self.assertEqual(report["verdict"], "found", report)
        self.assertEqual([sub for _, sub in sequence.Plan.of(obj).pairs], ["Lower.", "Upper."])
        self.assertEqual(sequence.compute(obj)["verdict"], "found")

    def test_saved_and_copied(self):
        _, obj = sequence.find(plan_of(self.doc, self.parts, self.walls, Order="find"))
        path, name = self.folder + "/sequence.FCStd", obj.Name
        copy = self.doc.copyObject(obj, False)
        self.doc.recompute()
        self.assertEqual((copy.Status, copy.Motions), (UP_TO_DATE, obj.Motions))
        self.doc.saveAs(path)
        App.closeDocument(self.doc.Name)
        self.doc = App.openDocument(path)
        obj = self.doc.getObject(name)
        self.doc.recompute()
        self.assertEqual((obj.Status, obj.Verdict), (UP_TO_DATE, "clear"))
        obj.Report = '{"verdict": "found", "steps": [1]}'
        self.assertIsNone(sequence.report_of(obj))
        self.assertEqual(sequence.Plan.of(obj).steps, [])
