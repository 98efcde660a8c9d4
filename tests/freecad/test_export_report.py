# SPDX-License-Identifier: LGPL-2.1-or-later
"""Reports of clearance checks as pages, from a document without a window."""
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
from sweptvolume import core, page, settings, texts  # noqa: E402
from sweptvolume.convert import InputProblem  # noqa: E402
from sweptvolume.features import clearance, neighbour_rules  # noqa: E402
from sweptvolume.features.neighbour_rules import CONTACT, Rule  # noqa: E402


class Pages(Case):
    NEEDS_CORE = True

    def setUp(self):
        super().setUp()
        self.part = self.box("Schieber")
        self.path = self.line()  # 30 mm along x: the box ends at x = 40
        self.wall = self.box("Wall")
        self.wall.Label = "Wänd <b>&"
        self.wall.Placement = shift(x=43.5)
        self.table = self.box("Table")
        self.table.Length, self.table.Width, self.table.Height = 80, 40, 5
        self.table.Placement = shift(x=-20, y=-15, z=-5)
        self.doc.recompute()
        self.obj = clearance.make_clearance(
            self.doc, Generators=[(self.part, "")], Motion=self.path, Required=5.0
        )
        neighbour_rules.write(self.obj, {(self.table, ""): Rule(CONTACT)})
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
        for told, row in zip(kept["neighbours"], report["neighbours"]):
            self.assertEqual(told["distance"], row["distance"])
            self.assertEqual(told["curve"], [list(p) for p in row["curve"]])
        self.assertIn("2023-11-14 22:13 UTC", text)
        rows = cells(text, "verdicts")[1:]
        self.assertEqual(
            [row[:2] for row in rows],
            [["Wänd <b>&", "below required"], ["Table", "contact, allowed"]],
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
        with self.assertRaisesRegex(InputProblem, "no result that is up to date"):
            self.written()
        clearance.compute(self.obj)
        self.wall.Placement = shift(x=60)
        self.doc.recompute()
        with self.assertRaisesRegex(InputProblem, "check again first"):
            self.written()
        self.obj.Motion = None
        self.doc.recompute()
        with self.assertRaisesRegex(InputProblem, "(?s)check again first.*motion"):
            self.written()
        self.assertEqual(os.listdir(self.folder), [])

    def test_targets_that_cannot_be_are_named(self):
        clearance.compute(self.obj)
        for name, text in (
            ("a.txt", "unknown"),
            (os.path.join("no", "a.html"), "does not exist"),
            ("a.pdf", "by the window alone"),
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
        with self.assertRaisesRegex(core.CoreError, "{{logo}} is no placeholder"):
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
        self.assertIn("zu nah", text)
        self.assertIn("Eine Notiz &lt;x&gt;", text)
        self.assertNotIn("sind englisch", text)
        self.assertEqual(texts.language(), "en")
