# SPDX-License-Identifier: LGPL-2.1-or-later
"""Mechanisms: the motions of all parts from one run of a driving value, and the results of the check
compared with formulas.
"""
import csv
import math
import os

import FreeCAD as App
import numpy as np

import slider_crank
from case import Case, V, shift, turn
from slider_crank import CRANK, HALF, ROD, STOP
from sweptvolume import core
from sweptvolume.convert import InputProblem, pairs_of
from sweptvolume.features import (
    clearance,
    joint_motions,
    mechanism,
    mechanism_table,
    motion,
    pair_rules,
)
from sweptvolume.features.base import FAILED, STALE, UP_TO_DATE
from sweptvolume.features.neighbour_rules import CONTACT, IGNORE, Rule
from sweptvolume.trajectory import sources

SECONDS = 2.0


class SliderCrank(Case):
    NEEDS_CORE = True
    POSES = 73

    def setUp(self):
        super().setUp()
        self.sheet, self.crank, self.rod, self.slider, self.wall = slider_crank.make(self.doc)

    def source(self, count=0, end=360):
        values = {"start": 0, "end": end, "count": count or self.POSES, "duration": SECONDS}
        return sources.Settings("Driven", objects=[self.sheet], property="angle", **values)

    def motions(self, count=0):
        found = joint_motions.of_source(self.doc, self.source(count))[0]
        self.doc.recompute()
        return found

    def check(self, motions, **settings):
        settings.setdefault("Neighbours", [(self.wall, "")])
        parts = [(m.SourceObjects[1], "") for m in motions]
        obj = mechanism.make_mechanism(self.doc, MovingParts=parts, Motions=motions, **settings)
        self.doc.recompute()
        return obj

    def rows(self, obj):
        """Returns {(name, name): row} of the stored result."""
        pairs = mechanism.report_of(obj)["pairs"]
        return {(p["first"], p["second"]): p["clearance"] for p in pairs}


class Motions(SliderCrank):
    def test_one_run_gives_all_parts(self):
        runs = []
        keep = motion.sources.driven.Handle.set
        motion.sources.driven.Handle.set = lambda handle, value: (
            runs.append(value),
            keep(handle, value),
        )
        try:
            found, notes = joint_motions.of_source(self.doc, self.source(5))
        finally:
            motion.sources.driven.Handle.set = keep
        self.assertEqual(runs, [0.0, 90.0, 180.0, 270.0, 360.0, "0"])  # "0" restores the cell
        self.assertEqual(notes, [])
        self.assertEqual([m.SourceObjects[1].Name for m in found], ["Crank", "Rod", "Slider"])
        self.assertEqual([m.Label for m in found][0], "Motion of Crank")
        for m in found:
            for time, place in zip(m.Times, m.Placements):
                x, y, slide = slider_crank.at(360 * time / SECONDS)
                here = {"Crank": V(), "Rod": V(x, y, 0), "Slider": V(slide, 0, 0)}
                self.assertLess((place.Base - here[m.SourceObjects[1].Name]).Length, 1e-6)
            others = {o.Name for o in m.MovedToo}
            self.assertEqual(others, {"Crank", "Rod", "Slider"} - {m.SourceObjects[1].Name})

    def test_again_reads_those_that_are_there(self):
        found = self.motions(5)
        self.doc.removeObject(found[1].Name)
        again = self.motions(5)
        self.assertEqual([m.Name for m in again][::2], [found[0].Name, found[2].Name])

    def test_reload_reads_all_in_one_run(self):
        found = self.motions(5)
        self.rod.setExpression("Placement.Base.z", "3 mm")
        self.doc.recompute()
        self.assertEqual({m.Name: m.Status for m in found}[found[1].Name], STALE)
        self.assertEqual([m.Name for m in joint_motions.alike(found[0])], [m.Name for m in found])
        joint_motions.reload(found[0])
        self.doc.recompute()
        self.assertEqual([m.Status for m in found], ["", "", ""])
        self.assertEqual({round(p.Base.z, 9) for p in found[1].Placements}, {3.0})
        other = self.source(7)
        self.assertFalse(joint_motions.is_of_source(found[0], other))

    def test_the_outermost_rigid_group_is_the_part(self):
        doc = self.doc
        group = doc.addObject("App::Part", "Arm")
        inner, loose = self.box("Inner", 4), self.box("Loose", 4)
        for part in (inner, loose):
            group.addObject(part)
        group.Placement.Rotation = App.Rotation(V(0, 0, 1), 1)
        group.setExpression("Placement.Rotation.Angle", "Drive.angle * 1 deg")
        doc.recompute()
        names = [m.SourceObjects[1].Name for m in self.motions(5)]
        self.assertEqual(names, ["Crank", "Rod", "Slider", "Arm"])
        loose.setExpression("Placement.Base.z", "Drive.angle * 1 mm")  # not rigid any more
        doc.recompute()
        names = [m.SourceObjects[1].Name for m in self.motions(5)]
        self.assertEqual(names, ["Crank", "Rod", "Slider", "Inner", "Loose"])

    def test_nothing_moves(self):
        sheet = self.doc.addObject("Spreadsheet::Sheet", "Idle")
        sheet.set("A1", "1")
        sheet.setAlias("A1", "idle")
        self.doc.recompute()
        idle = sources.Settings("Driven", objects=[sheet], property="idle", start=0, end=1, count=3)
        with self.assertRaisesRegex(InputProblem, '"Idle" moves no visible part'):
            joint_motions.of_source(self.doc, idle)

    def test_a_failing_frame_puts_the_document_back(self):
        self.sheet.set("A1", "12")
        self.doc.recompute()
        place = App.Placement(self.rod.Placement)
        run = joint_motions.begin(self.doc, self.source(9))
        run.advance()
        run.advance()
        self.assertNotEqual(self.sheet.angle, 12)
        run.close()
        self.assertEqual(self.sheet.angle, 12)
        self.assert_placement(self.rod.Placement, place)


class Distances(SliderCrank):
    POSES = 361

    def test_distances_are_those_of_the_formula(self):
        obj = self.check(self.motions(), RequiredDistance=6)
        mechanism.compute(obj)
        self.doc.recompute()
        self.assertEqual(obj.Status, UP_TO_DATE)
        self.assertEqual((obj.Checked, obj.Verdict), (6, "below"))
        rows = self.rows(obj)
        # The wall is nearest when the crank points along x. The rod lies 1 mm above crank and slider.
        gap = STOP - (CRANK + ROD + HALF)
        row = rows["Slider", "Wall"]
        self.assertAlmostEqual(row["distance"], gap, delta=1e-3)
        self.assertLessEqual(row["guaranteed"], gap)
        self.assertAlmostEqual(
            min(row["time_seconds"], SECONDS - row["time_seconds"]), 0, delta=0.02
        )
        for pair in (("Crank", "Rod"), ("Rod", "Slider")):
            self.assertAlmostEqual(rows[pair]["distance"], 1, delta=1e-3)
        # The wall is nearer than 6 mm while the slider is beyond 109 mm.
        angles = np.linspace(0, 360, 100001)
        x = CRANK * np.cos(np.radians(angles))
        x += np.sqrt(ROD**2 - (CRANK * np.sin(np.radians(angles))) ** 2)
        reported = sum(b - a for a, b in row["below"])
        for slack, compare in ((0.0, self.assertGreaterEqual), (0.35, self.assertLessEqual)):
            near = np.mean(STOP - HALF - x < 6 + slack) * SECONDS
            compare(reported, near - 1e-3)

    def test_crank_and_slider_that_meet(self):
        import Part

        long_ = Part.makeBox(60, 4, 4, V(-60, -2, 0))  # a tail towards the crank
        self.slider.Shape = self.slider.Shape.fuse(long_).removeSplitter()
        self.doc.recompute()
        obj = self.check(self.motions(), Neighbours=[])
        mechanism.compute(obj)
        row = self.rows(obj)["Crank", "Slider"]
        self.assertEqual(row["verdict"], "clash")
        self.assertGreater(row["penetration"]["depth"], 1)
        obj.RuleParts, obj.RuleKinds, obj.RuleLengths = (
            [(self.crank, ""), (self.slider, "")],
            [IGNORE],
            [0.0],
        )
        self.doc.recompute()
        self.assertEqual(obj.Status, STALE)
        mechanism.compute(obj)
        self.assertNotIn(("Crank", "Slider"), self.rows(obj))
        self.assertEqual(mechanism.report_of(obj)["ignored"], [["Crank", "Slider"]])

    def test_stamped_by_shapes_of_the_document(self):
        """Compares with OpenCASCADE's distances at 24 angles of the crank: none is smaller than
        guaranteed."""
        motions = self.motions()
        obj = self.check(motions)
        mechanism.compute(obj)
        rows = self.rows(obj)
        parts = {o.Name: o for o in (self.crank, self.rod, self.slider, self.wall)}
        least = {pair: math.inf for pair in rows}
        for k in range(24):
            self.sheet.set("A1", repr(15.0 * k))
            self.doc.recompute()
            for pair in rows:
                one, other = (parts[name].Shape for name in pair)
                least[pair] = min(least[pair], one.distToShape(other)[0])
        for pair, row in rows.items():
            self.assertGreaterEqual(least[pair], row["guaranteed"], pair)
            self.assertLessEqual(row["distance"], least[pair] + 0.02, pair)


class Kept(SliderCrank):
    def test_table_and_file(self):
        obj = self.check(self.motions(), RequiredDistance=6)
        mechanism.compute(obj)
        path = os.path.join(self.folder, "table.csv")
        mechanism_table.write_csv(mechanism.report_of(obj), path)
        with open(path, encoding="utf-8") as file:
            rows = list(csv.DictReader(file))
        self.assertEqual(len(rows), 3)
        row = next(r for r in rows if (r["First"], r["Second"]) == ("Slider", "Wall"))
        self.assertEqual((row["Verdict"], row["Meets rule"]), ("below required", "no"))
        self.assertAlmostEqual(float(row["Distance (mm)"]), 5, delta=0.01)
        self.assertAlmostEqual(float(row["First X (mm)"]), CRANK + ROD + HALF, delta=0.02)
        sheet = mechanism_table.make_spreadsheet(obj, mechanism.report_of(obj))
        self.assertEqual(sheet.getContents("A1").strip("'"), "First")

    def test_copy_undo_save_and_open(self):
        obj = self.check(self.motions())
        rule = Rule(CONTACT, 0.2)
        pair = pair_rules.key(pairs_of([(self.crank, "")])[0], pairs_of([(self.rod, "")])[0])
        pair_rules.write(obj, {pair: rule})
        self.doc.recompute()
        mechanism.compute(obj)
        smallest, name = obj.Smallest.Value, obj.Name
        self.doc.openTransaction("rules")
        pair_rules.write(obj, {})
        self.doc.commitTransaction()
        self.doc.recompute()
        self.assertEqual(obj.Status, STALE)
        self.doc.undo()
        self.doc.recompute()
        self.assertEqual((obj.Status, pair_rules.read(obj)), (UP_TO_DATE, {pair: rule}))
        self.reopen()
        obj = self.doc.getObject(name)
        self.doc.recompute()
        self.assertEqual((obj.Status, obj.Smallest.Value), (UP_TO_DATE, smallest))
        self.assertEqual([r.text() for r in pair_rules.read(obj).values()], ["contact:0.2"])
        copy = self.doc.copyObject(obj, True)
        copy = next(
            o
            for o in (copy if isinstance(copy, (list, tuple)) else [copy])
            if mechanism.is_mechanism(o)
        )
        self.doc.recompute()
        self.assertEqual(len(copy.Motions), 3)
        self.assertEqual(len(pair_rules.read(copy)), 1)
        self.assertNotIn(copy.Motions[0], obj.Motions)

    def test_deleted_parts_are_named_and_take_their_rules(self):
        obj = self.check(self.motions())
        pairs = [pairs_of([(o, "")])[0] for o in (self.crank, self.rod, self.slider)]
        rules = {
            pair_rules.key(pairs[0], pairs[1]): Rule(IGNORE),
            pair_rules.key(pairs[1], pairs[2]): Rule(CONTACT, 1.0),
        }
        pair_rules.write(obj, rules)
        mechanism.compute(obj)
        self.doc.openTransaction("delete")
        self.doc.removeObject("Crank")
        self.doc.commitTransaction()
        self.doc.recompute()
        self.assertEqual(obj.Status, FAILED)
        self.assertIn('"Crank" was deleted', obj.Message)
        self.assertEqual(list(pair_rules.read(obj).values()), [Rule(CONTACT, 1.0)])
        self.doc.undo()
        self.doc.recompute()
        self.assertEqual((obj.Status, pair_rules.read(obj)), (UP_TO_DATE, rules))

    def test_what_touches_at_first_is_offered(self):
        self.rod.Shape = self.rod.Shape.translated(V(0, 0, -1.5))
        self.doc.recompute()
        plan = mechanism.Plan.of(self.check(self.motions()))
        found = mechanism.offered(plan.request(), core.Control())
        texts = {pair_rules.label_of(pair): rule.text() for pair, rule in found.items()}
        self.assertEqual(sorted(texts), ["Crank - Rod", "Rod - Slider"])
        for text in texts.values():
            self.assertAlmostEqual(float(text.split(":")[1]), 0.55, delta=0.02)  # 0.5 mm + 10 %
        plan.pair_rules = found
        report = mechanism.work(plan.request(), core.Control()).report
        verdicts = {p["first"] + " - " + p["second"]: p["clearance"] for p in report["pairs"]}
        for name in texts:
            self.assertTrue(verdicts[name]["meets_rule"], verdicts[name])

    def test_a_cancelled_run_leaves_the_result(self):
        obj = self.check(self.motions())
        mechanism.compute(obj)
        before, control = obj.Report, core.Control()
        control.cancel()
        with self.assertRaises(core.CoreError):
            mechanism.compute(obj, control)
        self.assertEqual(obj.Report, before)


class BadInput(SliderCrank):
    def refused(self, words, *pairs, **settings):
        """Checks that a check of these pairs (part, motion) is refused with a message that contains the
        words.
        """
        obj = mechanism.make_mechanism(
            self.doc,
            MovingParts=[(part, "") for part, _ in pairs],
            Motions=[m for _, m in pairs],
            **settings,
        )
        self.doc.recompute()
        with self.assertRaisesRegex((InputProblem, core.CoreError), words):
            mechanism.compute(obj)
        self.assertTrue(obj.Message)
        self.doc.removeObject(obj.Name)

    def test_refused_by_name(self):
        crank, rod, slider = self.motions(9)
        late = motion.motion_from_poses(self.doc, [5, 6], [shift(), shift(9)])
        late.Label = "Late"
        jumps = motion.motion_from_poses(self.doc, [0, 1], [shift(), shift(9)], "None")
        jumps.Label = "Jumps"
        self.refused("No moving part is chosen")
        self.refused('"Crank" is in the list twice', (self.crank, crank), (self.crank, rod))
        self.refused(
            '"Crank" is both a neighbour and a moving part',
            (self.crank, crank),
            (self.rod, rod),
            Neighbours=[(self.crank, "")],
        )
        self.refused('"Late" begins at 5 s', (self.crank, crank), (self.rod, late))
        self.refused('"Jumps" has the interpolation None', (self.crank, crank), (self.rod, jumps))
        self.refused("Only one part is given", (self.crank, crank))
        self.refused('"Rod" has no motion', (self.crank, crank), (self.rod, self.wall))
        self.refused(
            "rules of .* are incomplete",
            (self.crank, crank),
            (self.slider, slider),
            RuleParts=[(self.crank, "")],
            RuleKinds=[IGNORE],
            RuleLengths=[0.0],
        )
        self.refused(
            'There are two different rules for "Crank - Rod"',
            (self.crank, crank),
            (self.rod, rod),
            RuleParts=[(self.crank, ""), (self.rod, ""), (self.rod, ""), (self.crank, "")],
            RuleKinds=[IGNORE, CONTACT],
            RuleLengths=[0.0, 1.0],
        )

    def test_missing_motion(self):
        crank = self.motions(9)[0]
        obj = mechanism.make_mechanism(
            self.doc, MovingParts=[(self.crank, ""), (self.rod, "")], Motions=[crank]
        )
        self.doc.recompute()
        self.assertIn("There are 2 moving parts but 1 motions", obj.Message)

    def test_a_part_inside_another(self):
        group = self.doc.addObject("App::Part", "Group")
        box = self.box("Inside")
        group.addObject(box)
        self.doc.recompute()
        path = self.line()
        obj = mechanism.make_mechanism(
            self.doc, MovingParts=[(group, ""), (box, "")], Motions=[path, path]
        )
        self.doc.recompute()
        self.assertRegex(obj.Message, '"Group" and "Inside": one of them contains the other')

    def grouped(self):
        """Makes two groups with one part each, which pass each other, and a check of both."""
        left, right = self.doc.addObject("App::Part", "Left"), self.doc.addObject(
            "App::Part", "Right"
        )
        one, other = self.box("One"), self.box("Other")
        left.addObject(one)
        right.addObject(other)
        right.Placement = shift(y=12)
        self.doc.recompute()
        back = motion.motion_from_poses(self.doc, [0, 1], [shift(30, 12), shift(0, 12)])
        return (
            left,
            right,
            mechanism.make_mechanism(
                self.doc,
                MovingParts=[(left, "One."), (right, "Other.")],
                Motions=[self.line(), back],
                RequiredDistance=3.0,
            ),
        )

    def test_rules_of_groups_that_cross_are_named(self):
        """Two rules, each more specific on one side: neither takes precedence, so both are named."""
        left, right, obj = self.grouped()
        crossing = {
            pair_rules.key((left, ""), (right, "Other.")): Rule(CONTACT),
            pair_rules.key((left, "One."), (right, "")): Rule(IGNORE),
        }
        pair_rules.write(obj, crossing)
        self.doc.recompute()
        with self.assertRaisesRegex(
            InputProblem, "contradict each other for .*neither takes precedence"
        ):
            mechanism.compute(obj)
        self.assertEqual(obj.Status, FAILED)
        own = {pair_rules.key((left, "One."), (right, "Other.")): Rule(length=1.0)}
        pair_rules.write(obj, {**crossing, **own})
        self.doc.recompute()
        (pair,) = mechanism.compute(obj)["pairs"]
        self.assertEqual(pair["required"], 1.0)
        same = {pair: Rule(length=2.0) for pair in crossing}
        pair_rules.write(obj, same)
        self.doc.recompute()
        (pair,) = mechanism.compute(obj)["pairs"]
        self.assertEqual(pair["required"], 2.0, "they agree")

    def test_groups_that_contain_each_other_cannot_be(self):
        """Rules of groups stay as they are after FreeCAD has refused a circular group."""
        left, right, obj = self.grouped()
        pair_rules.write(obj, {pair_rules.key((left, ""), (right, "")): Rule(length=1.5)})
        self.doc.recompute()
        left.addObject(right)
        with self.assertRaises(Exception):
            right.addObject(left)
        self.assertNotIn(left, right.Group)
        self.doc.recompute()
        plan = mechanism.Plan.of(obj)
        rule = pair_rules.of(plan.pair_rules, *plan.pairs)
        self.assertEqual(rule, Rule(length=1.5), "one group inside the other")


class Warned(SliderCrank):
    def test_clearance_names_what_moves_too(self):
        crank = self.motions(9)[0]
        obj = clearance.make_clearance(self.doc, MovingParts=[(self.crank, "")], Motion=crank)
        self.doc.recompute()
        clearance.compute(obj)
        self.assertRegex(obj.Message, 'also moved .*"Rod", "Slider"')
        self.assertIn("Check mechanism", obj.Message)
        self.assertNotIn('"Wall"', obj.Message)
        other = clearance.make_clearance(
            self.doc, MovingParts=[(self.crank, "")], Motion=self.line()
        )
        other.Motion.Placements = [turn(0), turn(90)]
        self.doc.recompute()
        clearance.compute(other)
        self.assertNotIn("also moved", other.Message)

    def test_a_motion_of_one_part_knows_it_too(self):
        values = {"start": 0, "end": 90, "count": 4}
        path = motion.motion_from_source(
            self.doc, "Driven", [self.sheet, self.slider], property="angle", **values
        )
        self.assertEqual({o.Name for o in path.MovedToo}, {"Crank", "Rod"})
