# SPDX-License-Identifier: LGPL-2.1-or-later
"""Reports of clearance checks as pages, without a window."""
import hashlib
import json
import os
import sys
from unittest import mock

import FreeCAD as App
import numpy as np

sys.path.insert(0, os.path.join(os.path.dirname(os.path.realpath(__file__)), "..", "python"))
from page_check import cells, check_alone, data  # noqa: E402

from case import Case, shift  # noqa: E402
from scene_case import Slide  # noqa: E402
from sweptvolume import core, page, settings, texts  # noqa: E402
from sweptvolume.convert import InputProblem  # noqa: E402
from sweptvolume.features import clearance, mechanism, neighbour_rules, pair_rules  # noqa: E402
from sweptvolume.features.neighbour_rules import Rule  # noqa: E402


class Pages(Slide):
    WALL = "Wänd <b>&"

    def setUp(self):
        super().setUp()
        self.obj = self.check(label=None)
        self.doc.recompute()
        self.target = os.path.join(self.folder, "ü report.html")

    def written(self):
        page.write(self.obj, self.target)
        with open(self.target, encoding="utf-8") as file:
            return file.read()

    def test_a_page_tells_what_the_check_found(self):
        clearance.compute(self.obj)
        with mock.patch.dict(os.environ, SOURCE_DATE_EPOCH="1700000000"):
            text = self.written()
            self.assertEqual(self.written(), text)
        check_alone(text)
        report = clearance.report_of(self.obj)
        kept = data(text, "report")
        for shown, row in zip(kept["neighbours"], report["neighbours"]):
            self.assertEqual(shown["distance"], row["distance"])
            self.assertEqual(shown["curve"], [list(p) for p in row["curve"]])
        self.assertIn("2023-11-14 22:13 UTC", text)
        rows = cells(text, "verdicts")[1:]
        self.assertEqual(
            [row[:2] for row in rows],
            [["Wänd <b>&", "below required"], ["Table", "allowed contact"]],
        )
        self.assertEqual(os.listdir(self.folder), ["ü report.html"])

    def test_inputs_are_told_with_hashes_of_what_was_checked(self):
        clearance.compute(self.obj)
        self.doc.saveAs(os.path.join(self.folder, "doc.FCStd"))
        rows = cells(self.written(), "inputs")[1:]
        self.assertEqual([row[1] for row in rows][:2], ["Schieber", self.path.Label])
        self.assertEqual({row[1] for row in rows[2:4]}, {"Wänd <b>&", "Table"})
        found = clearance.Plan.of(self.obj).request().rows()[0]
        shape = hashlib.sha256(np.asarray(found[1], "<f8").tobytes())
        shape.update(np.asarray(found[2], "<i4").tobytes())
        row = next(row for row in rows if row[1] == found[0])
        self.assertEqual(row[2:], ["{} triangles".format(len(found[2])), shape.hexdigest()])
        with open(self.doc.FileName, "rb") as file:
            self.assertEqual(rows[-1][3], hashlib.sha256(file.read()).hexdigest())
        before = [row[3] for row in rows]
        self.obj.Motion = self.line(31.0)
        self.doc.recompute()
        clearance.compute(self.obj)
        after = [row[3] for row in cells(self.written(), "inputs")[1:]]
        self.assertEqual([a == b for a, b in zip(before, after)], [True, False, True, True, True])

    def test_the_view_shows_the_parts_where_they_were(self):
        if not core.has_page_view():
            self.skipTest("built without three.js")
        clearance.compute(self.obj)
        scene = data(self.written(), "scene")
        kinds = [(part["name"], part["kind"], part["verdict"]) for part in scene["parts"]]
        self.assertEqual(kinds[0], ("Schieber", "moves", "none"))
        self.assertIn(("Wänd <b>&", "stands", "below"), kinds)
        self.assertIn(("Table", "stands", "allowed"), kinds)

    def test_results_that_are_not_there_or_stale_are_refused(self):
        with self.assertRaisesRegex(InputProblem, "is not up to date"):
            self.written()
        clearance.compute(self.obj)
        self.wall.Placement = shift(x=60)
        self.doc.recompute()
        with self.assertRaisesRegex(InputProblem, "run the check again"):
            self.written()
        self.obj.Motion = None
        self.doc.recompute()
        with self.assertRaisesRegex(InputProblem, "(?s)run the check again.*motion"):
            self.written()
        self.assertEqual(os.listdir(self.folder), [])

    def test_targets_that_cannot_be_are_named(self):
        clearance.compute(self.obj)
        for name, text in (
            ("a.txt", "not supported"),
            (os.path.join("no", "a.html"), "does not exist"),
            ("a.pdf", "only while the FreeCAD window"),
        ):
            with self.assertRaisesRegex(InputProblem, text):
                page.write(self.obj, os.path.join(self.folder, name))
        with mock.patch.dict(os.environ, SOURCE_DATE_EPOCH="now"):
            with self.assertRaisesRegex(InputProblem, 'SOURCE_DATE_EPOCH is "now"'):
                self.written()

    def test_the_template_of_the_preferences_is_used(self):
        clearance.compute(self.obj)
        group = App.ParamGet(settings.PATH)
        self.addCleanup(group.RemString, "PageTemplate")
        path = self.file("t.html", "<p>ACME {{title}}</p>{{verdict}}")
        group.SetString("PageTemplate", path)
        self.assertTrue(self.written().startswith("<p>ACME Clearance</p>"))
        self.file("t.html", "{{logo}}")
        with self.assertRaisesRegex(core.CoreError, "{{logo}} is not a placeholder"):
            self.written()
        self.file("t.html", " ")
        with self.assertRaisesRegex(InputProblem, "is empty"):
            self.written()
        os.remove(path)
        with self.assertRaisesRegex(InputProblem, "cannot be read"):
            self.written()

    def test_findings_and_notes_are_told_in_the_users_language(self):
        clearance.compute(self.obj)
        report = json.loads(self.obj.Report)
        report["notes"] = ["Eine Notiz <x>"]
        self.obj.Report = json.dumps(report)
        with mock.patch.object(page, "language", lambda: "de"):
            text = self.written()
        self.assertIn("unter Sollabstand", text)
        self.assertIn("Eine Notiz &lt;x&gt;", text)
        self.assertNotIn("nur auf Englisch", text)
        self.assertEqual(texts.language(), "en")

    def test_the_template_for_pdf_is_another_one_and_is_checked_as_well(self):
        clearance.compute(self.obj)
        self.assertIn("<h1>{{title}}</h1>", page.request(self.obj, pdf=True).layout)
        group = App.ParamGet(settings.PATH)
        self.addCleanup(group.RemString, "PrintTemplate")
        path = self.file("t.html", "<p>ACME paper {{title}}</p>{{rules}}")
        group.SetString("PrintTemplate", path)
        self.assertEqual(page.request(self.obj).layout, "")
        req = page.request(self.obj, pdf=True)
        text = page.text(req, core.Control(), view=False)
        self.assertTrue(text.startswith("<p>ACME paper Clearance</p>"))
        os.remove(path)
        with self.assertRaisesRegex(InputProblem, "cannot be read"):
            page.request(self.obj, pdf=True)


class PagesOfMechanisms(Case):
    NEEDS_CORE = True

    def setUp(self):
        super().setUp()
        self.left, self.right = self.box("Left"), self.box("Right")
        self.right.Placement = shift(x=60)
        self.wall = self.box("Wall")
        self.wall.Placement = shift(y=12)
        self.there = self.line(20.0)
        self.back = self.line(-25.0)
        self.back.PoseType = "RelativeToFirst"
        self.there.Label, self.back.Label = "There", "Back"
        self.doc.recompute()
        self.obj = mechanism.make_mechanism(
            self.doc,
            MovingParts=[(self.left, ""), (self.right, "")],
            Motions=[self.there, self.back],
            AllVisible=True,
            RequiredDistance=8.0,
        )
        rule = {
            pair_rules.key((self.left, ""), (self.wall, "")): Rule(neighbour_rules.REQUIRED, 1.0)
        }
        pair_rules.write(self.obj, rule)
        self.doc.recompute()
        self.target = os.path.join(self.folder, "report.html")

    def written(self):
        page.write(self.obj, self.target)
        with open(self.target, encoding="utf-8") as file:
            return file.read()

    def test_a_page_tells_of_every_pair(self):
        with self.assertRaisesRegex(InputProblem, "is not up to date"):
            self.written()
        mechanism.compute(self.obj)
        text = self.written()
        check_alone(text)
        report = mechanism.report_of(self.obj)
        rows = {row[0]: row for row in cells(text, "verdicts")[1:]}
        self.assertEqual(rows["Left - Right"][1:3], ["below required", "5 mm"])
        self.assertEqual(rows["Left - Wall"][1:3], ["clear", "2 mm"])
        rules = {row[0]: row[1:] for row in cells(text, "rules")[1:]}
        self.assertEqual(rules["Left - Wall"], ["at least 1 mm", "yes"])
        self.assertEqual(rules["Left - Right"], ["at least 8 mm", "no"])
        kept = data(text, "report")
        for shown, pair in zip(kept["pairs"], report["pairs"]):
            self.assertEqual(shown["clearance"]["curve"], pair["clearance"]["curve"])
        self.assertIn("<svg", text)

    def test_inputs_and_view_are_those_that_were_checked(self):
        mechanism.compute(self.obj)
        text = self.written()
        rows = cells(text, "inputs")[1:]
        shown = [row[:2] for row in rows]
        self.assertEqual(
            shown,
            [
                ["moving part", "Left"],
                ["motion", "There"],
                ["moving part", "Right"],
                ["motion", "Back"],
                ["part that stands still", "Wall"],
            ],
        )
        found = mechanism.Plan.of(self.obj).request().rows()
        for name, vertices, triangles, _, _, _ in found:
            shape = hashlib.sha256(np.asarray(vertices, "<f8").tobytes())
            shape.update(np.asarray(triangles, "<i4").tobytes())
            self.assertEqual(next(r for r in rows if r[1] == name)[3], shape.hexdigest(), name)
        if core.has_page_view():
            kinds = [(p["name"], p["kind"]) for p in data(text, "scene")["parts"]]
            self.assertEqual(kinds, [("Left", "moves"), ("Right", "moves"), ("Wall", "stands")])

    def test_parts_of_one_motion_name_it_once(self):
        self.obj.Motions = [self.there, self.there]
        self.doc.recompute()
        mechanism.compute(self.obj)
        rows = cells(self.written(), "inputs")[1:]
        self.assertEqual([row[1] for row in rows if row[0] == "motion"], ["There"])

    def test_what_changed_is_refused(self):
        mechanism.compute(self.obj)
        self.right.Placement = shift(x=70)
        self.doc.recompute()
        with self.assertRaisesRegex(InputProblem, "run the check again"):
            self.written()
