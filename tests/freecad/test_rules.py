# SPDX-License-Identifier: LGPL-2.1-or-later
"""Rules of neighbours in a document: how they change a check, and that each stays with its part."""
from case import shift
from neighbour_case import Neighbours
from sweptvolume import convert, core
from sweptvolume.convert import InputProblem
from sweptvolume.features import clearance, clearance_table, neighbour_rules, pair_rules
from sweptvolume.features.neighbour_rules import CONTACT, IGNORE, REQUIRED, Rule


class Rules(Neighbours):
    def setUp(self):
        super().setUp()
        self.table = self.box("Table")
        self.table.Length, self.table.Width, self.table.Height = 80, 40, 5
        self.table.Placement = shift(x=-20, y=-15, z=-5)
        self.doc.recompute()

    def made(self, rules=None, **settings):
        obj = super().made(**settings)
        neighbour_rules.write(obj, {(part, ""): rule for part, rule in (rules or {}).items()})
        self.doc.recompute()
        return obj

    def usual(self):
        return self.made(
            {self.table: Rule(CONTACT), self.wall: Rule(length=3.0), self.far: Rule(IGNORE)}
        )

    def verdicts(self, obj):
        rows = clearance.report_of(obj)["neighbours"]
        return {row["name"]: (row["verdict"], row["meets_rule"]) for row in rows}

    def kept(self, obj):
        found = neighbour_rules.read(obj).items()
        return {convert.label_of(*pair): rule.text() for pair, rule in found}

    USUAL = {"Table": "contact", "Wall": "3.0", "Far": "ignore"}

    def test_what_each_asks_for_decides(self):
        obj = self.made()
        clearance.compute(obj)
        self.assertEqual(obj.Verdict, "contact")
        self.assertEqual(
            self.verdicts(obj),
            {"Wall": ("below", False), "Table": ("contact", False), "Far": ("clear", True)},
        )
        obj = self.usual()
        clearance.compute(obj)
        self.assertEqual(obj.Verdict, "clear")
        self.assertEqual(self.verdicts(obj), {"Wall": ("clear", True), "Table": ("contact", True)})
        self.assertTrue(
            obj.Summary.startswith(
                "2 checked, 1 in allowed contact, 1 ignored, smallest distance 3.5 mm"
            ),
            obj.Summary,
        )
        rows = clearance_table.table(clearance.report_of(obj))
        self.assertEqual(
            {row[0]: row[-2:] for row in rows},
            {"Wall": ["3 mm", "yes"], "Table": ["contact", "yes"], "Far": ["ignored", ""]},
        )

    def test_a_change_of_a_rule_makes_the_result_stale(self):
        obj = self.usual()
        clearance.compute(obj)
        for name, value in (
            ("RuleLengths", [0.0, 3.25, 0.0]),
            ("RuleKinds", [CONTACT, REQUIRED, REQUIRED]),
        ):
            before = list(getattr(obj, name))
            setattr(obj, name, value)
            self.doc.recompute()
            self.assertEqual(obj.Status, clearance.STALE, name)
            setattr(obj, name, before)
            self.doc.recompute()
            self.assertEqual(obj.Status, clearance.UP_TO_DATE, name)

    def test_checks_without_rules_have_the_hash_of_before(self):
        obj = self.made()

        def hash_with(rules):
            plan = clearance.Plan.of(obj)  # reads its inputs once
            plan.rules = rules
            return plan.hash()

        now = hash_with({})
        self.assertEqual(clearance.Plan.of(obj).hash(), now)
        self.assertEqual(hash_with({(self.wall, ""): Rule()}), now)  # a default rule
        self.assertNotEqual(hash_with({(self.wall, ""): Rule(length=5.0)}), now)

    def test_results_of_before_there_were_rules_open_as_they_were(self):
        obj = self.made()
        clearance.compute(obj)
        hash_then, text = obj.InputHash, obj.Report
        for name in ("RuleParts", "RuleKinds", "RuleLengths", "Verdict"):
            obj.removeProperty(name)
        report = clearance.stored(text, {})
        for row in report["neighbours"]:
            del row["rule"], row["meets_rule"]
        obj.Report = clearance.json.dumps(report)
        self.reopen()
        again = self.doc.getObject("Clearance")
        self.assertEqual((again.Status, again.InputHash), (clearance.UP_TO_DATE, hash_then))
        self.assertEqual(neighbour_rules.read(again), {})
        report = clearance.report_of(again)
        self.assertEqual(clearance_table.summary(report), again.Summary)
        self.assertEqual(clearance_table.worst(report), "contact")
        self.assertEqual(clearance_table.table(report)[0][-2:], ["5 mm", "no"])

    def test_rules_survive_saving_copying_and_undo(self):
        obj = self.usual()
        clearance.compute(obj)
        copy = self.doc.copyObject(obj, False)
        self.assertEqual(self.kept(copy), self.USUAL)
        self.doc.UndoMode = 1
        self.doc.openTransaction("rules")
        neighbour_rules.write(obj, {(self.wall, ""): Rule(CONTACT, 0.5)})
        self.doc.commitTransaction()
        self.assertEqual(self.kept(obj), {"Wall": "contact:0.5"})
        self.doc.undo()
        self.assertEqual(self.kept(obj), self.USUAL)
        self.doc.redo()
        self.assertEqual(self.kept(obj), {"Wall": "contact:0.5"})
        self.doc.undo()
        self.doc.recompute()
        self.reopen()
        again = self.doc.getObject("Clearance")
        self.assertEqual(self.kept(again), self.USUAL)
        self.assertEqual((again.Status, again.Verdict), (clearance.UP_TO_DATE, "clear"))

    def test_rules_go_with_a_part_that_is_deleted_and_come_back_with_it(self):
        obj = self.usual()
        self.doc.UndoMode = 1
        self.doc.openTransaction("delete")
        self.doc.removeObject(self.wall.Name)
        self.doc.commitTransaction()
        left = {"Table": "contact", "Far": "ignore"}
        self.assertEqual(self.kept(obj), left)
        self.doc.recompute()
        clearance.compute(obj)
        self.assertEqual(self.verdicts(obj), {"Table": ("contact", True)})
        for _ in range(self.doc.UndoCount):
            self.doc.undo()
            if self.doc.getObject("Wall") is not None:
                break
        self.assertEqual(self.kept(obj), self.USUAL)

    def test_a_group_gives_its_rule_to_what_it_holds(self):
        group = self.doc.addObject("App::Part", "Fixture")
        group.addObject(self.table)
        group.addObject(self.wall)
        self.doc.recompute()
        obj = self.made()
        rules = {(group, ""): Rule(CONTACT, 0.2), (group, "Wall."): Rule(length=2.0)}
        neighbour_rules.write(obj, rules)
        self.doc.recompute()
        clearance.compute(obj)
        rows = {row["name"]: row["rule"] for row in clearance.report_of(obj)["neighbours"]}
        self.assertEqual(
            rows, {"Table": {"contact": 0.2}, "Wall": {"required": 2.0}, "Far": {"required": 5.0}}
        )

    def test_a_change_of_one_row_keeps_the_rule_of_a_group(self):
        group = self.doc.addObject("App::Part", "Fixture")
        for part in (self.table, self.wall):
            group.addObject(part)
        self.doc.recompute()
        all_of, table, wall = ((group, sub) for sub in ("", "Table.", "Wall."))
        far, shown = (self.far, ""), [(self.far, ""), table, wall]
        rules = {all_of: Rule(CONTACT, 0.2)}
        before = {table: Rule(CONTACT, 0.2), wall: Rule(CONTACT, 0.2)}
        for changed, now in (
            ({}, rules),
            ({far: Rule(IGNORE)}, {**rules, far: Rule(IGNORE)}),
            ({wall: Rule(length=3.0)}, {**rules, wall: Rule(length=3.0)}),
            # No rule can say that a part in the group has the default again.
            ({wall: Rule()}, {table: Rule(CONTACT, 0.2)}),
        ):
            given = {pair: r for pair, r in {**before, **changed}.items() if r.asks()}
            found = neighbour_rules.merged(rules, shown, given)
            self.assertEqual(found, now)
            self.assertEqual(neighbour_rules.merged(found, shown, given), now)
        # Rules of pairs: the rule of the group applies to the pairs of `far` with both parts in the group.
        pairs = [pair_rules.key(far, part) for part in (table, wall)]
        rules = {pair_rules.key(far, all_of): Rule(CONTACT, 0.2)}
        given = {pairs[0]: Rule(CONTACT, 0.2), pairs[1]: Rule(IGNORE)}
        found = pair_rules.merged(rules, pairs, given)
        self.assertEqual(found, {**rules, pairs[1]: Rule(IGNORE)})
        del given[pairs[1]]
        self.assertEqual(pair_rules.merged(found, pairs, given), given)

    def test_rules_stay_when_the_check_comes_into_a_group(self):
        obj = self.usual()
        group = self.doc.addObject("App::Part", "Group")
        for member in (self.table, obj):
            group.addObject(member)
        self.doc.recompute()
        self.assertEqual(self.kept(obj), self.USUAL)
        self.assertNotIn("Invalid", obj.State)

    def test_what_touches_at_first_is_offered(self):
        self.far.Placement = shift(x=-9.7)  # 0.3 mm inside at the first pose
        self.doc.recompute()
        plan = clearance.Plan.of(self.made())
        found = clearance.first_contacts(plan)
        self.assertEqual(
            {pair[0].Label: rule.text() for pair, rule in found.items()},
            {"Table": "contact", "Far": "contact:0.33"},
        )
        plan.rules = found
        obj = self.made()
        plan.write(obj)
        self.doc.recompute()
        clearance.compute(obj)
        self.assertEqual(self.verdicts(obj)["Far"], ("contact", True))

    def test_impossible_rules_are_named(self):
        obj = self.usual()
        for name, value, text in (
            ("RuleLengths", [0.0, -3.0, 0.0], 'the rule of "Wall" is -3 mm'),
            ("RuleLengths", [0.0], "there are 3 parts, 3 kinds and 1 lengths"),
            ("RuleKinds", [CONTACT, "Near", IGNORE], '"Wall" has the unknown rule "Near"'),
        ):
            before = list(getattr(obj, name))
            setattr(obj, name, value)
            with self.assertRaises(InputProblem) as refused:
                clearance.compute(obj)
            self.assertIn(text, str(refused.exception))
            self.assertEqual(obj.Status, clearance.FAILED)
            setattr(obj, name, before)
        obj.RuleParts = [(self.wall, ""), (self.wall, ""), (self.far, "")]
        with self.assertRaises(InputProblem) as refused:
            clearance.compute(obj)
        self.assertIn('There are two different rules for "Wall"', str(refused.exception))
        every = {part: Rule(IGNORE) for part in (self.wall, self.table, self.far)}
        with self.assertRaises(InputProblem) as refused:
            clearance.compute(self.made(every))
        self.assertIn("The rules ignore every neighbour", str(refused.exception))

    def test_the_map_leaves_out_what_is_meant_to_touch(self):
        from sweptvolume.features import envelope

        swept = self.envelope([self.part], self.path, Resolution=20)
        envelope.compute(swept)
        obj = clearance.make_clearance(self.doc, Envelope=swept)
        neighbour_rules.write(obj, {(self.table, ""): Rule(CONTACT), (self.far, ""): Rule(IGNORE)})
        self.doc.recompute()
        clearance.compute(obj)
        self.assertAlmostEqual(min(obj.MapDistances), 3.5, delta=0.2)
        neighbour_rules.write(obj, {(self.wall, ""): Rule(IGNORE)})
        self.doc.recompute()
        clearance.compute(obj)
        self.assertLess(min(obj.MapDistances), 0.2)

    def test_searches_refuse_contact_at_any_time(self):
        from sweptvolume.features import path_plan

        plan = path_plan.PathPlan(
            self.doc, [(self.part, "")], [(self.wall, "")], extract=50.0,
            rules={(self.wall, ""): Rule(CONTACT)},
        )  # fmt: skip
        with self.assertRaises(core.CoreError) as refused:
            path_plan.find(plan)
        self.assertEqual(refused.exception.code, "BadRule")
