# SPDX-License-Identifier: LGPL-2.1-or-later
"""Studies without a window: of a study file, and of the document's envelopes and checks."""
import json
import os
from unittest import mock

import FreeCAD as App

from case import shift
from scene_case import Slide
from sweptvolume import core, studies
from sweptvolume.convert import InputProblem
from sweptvolume.features import (
    clearance,
    envelope,
    mechanism,
    study,
    study_export,
    study_plan,
)
from sweptvolume.features.base import CANCELLED, FAILED, NOT_COMPUTED, STALE, UP_TO_DATE

FILE = """
[study]
name = "boxes"
[defaults]
part = "box.ply"
neighbours = ["wall.ply"]
compute = ["clearance"]
[[run]]
name = "{motion}"
motion = ["near.csv", "into.csv"]
"""


class Studies(Slide):
    WALL = "Wänd *1/2"

    def of_document(self, *sources, **settings):
        settings.setdefault("Folder", os.path.join(self.folder, "study"))
        obj = study.make_study(self.doc, Sources=list(sources), **settings)
        self.doc.recompute()
        return obj

    def of_file(self, text=FILE):
        import Mesh

        Mesh.Mesh(self.part.Shape.tessellate(1)).write(os.path.join(self.folder, "box.ply"))
        wall = self.part.Shape.copy()
        wall.translate(App.Vector(43, 0, 0))
        Mesh.Mesh(wall.tessellate(1)).write(os.path.join(self.folder, "wall.ply"))
        for name, travel in (("near", 30), ("into", 35), ("far", 10)):
            self.file(name + ".csv", "0,0,0,0,0,0,0,1\n1,{},0,0,0,0,0,1\n".format(travel))
        obj = study.make_study(self.doc, File=self.file("study.toml", text))
        self.doc.recompute()
        return obj

    # --- of the document

    def test_parts_with_motions_of_their_own_are_no_run(self):
        check, one, other = self.check(), self.path, self.line()
        parts = [self.part, self.wall]
        together = envelope.make_envelope(self.doc, parts, one)
        apart = envelope.make_envelope(self.doc, parts, one, Motions=[one, other])
        same = envelope.make_envelope(self.doc, parts, one, Motions=[other, other])
        found = [study_plan.has_one_motion(obj) for obj in (check, together, apart, same)]
        self.assertEqual(found, [True, True, False, True])

    def test_a_run_finds_what_the_check_finds(self):
        check = self.check()
        obj = self.of_document(check)
        self.assertEqual(obj.Status, NOT_COMPUTED)
        study.compute(obj)
        self.assertEqual((obj.Status, obj.Message), (UP_TO_DATE, ""))
        clearance.compute(check)
        own = clearance.report_of(check)["neighbours"][0]
        (row,) = study.report_of(obj)["runs"]
        self.assertEqual((row["run"], row["state"]), ("Check", "not clear"))
        for key in ("verdict", "distance", "guaranteed", "time_seconds"):
            self.assertEqual(row[key], own[key], key)
        self.assertEqual(row["neighbour"], "Wänd _1_2")
        self.assertEqual((obj.Verdict, obj.Checked), ("below", 1))
        with open(os.path.join(obj.Results, "Check", "report.json"), encoding="utf-8") as file:
            found = json.load(file)["clearance"]["neighbours"]
        self.assertEqual(
            [r["curve"] for r in found],
            [r["curve"] for r in clearance.report_of(check)["neighbours"]],
        )
        self.assertTrue(found[1]["meets_rule"] and "contact" in found[1]["rule"])
        self.assertTrue(os.path.isfile(os.path.join(obj.Results, "study.html")))

    def test_envelopes_are_the_envelopes_of_the_document(self):
        made = self.envelope([self.part], self.path, Resolution=32, Tolerance=0.1)
        obj = self.of_document(made)
        study.compute(obj)
        envelope.compute(made)
        (row,) = study.report_of(obj)["runs"]
        self.assertEqual(row["state"], "done")
        self.assertEqual(row["triangles"], made.Mesh.CountFacets)
        self.assertAlmostEqual(row["volume"], made.Mesh.Volume, delta=1e-6 * made.Mesh.Volume)

    def test_what_changes_makes_it_stale_and_only_that_is_computed_again(self):
        one, other = self.check(3.0, "One"), self.check(2.0, "Two")
        obj = self.of_document(one, other)
        study.compute(obj)
        marks = self.times(obj)
        one.RequiredDistance = 4.0
        self.doc.recompute()
        self.assertEqual(obj.Status, STALE)
        self.assertEqual(self.times(obj), marks)
        study.compute(obj)
        self.assertEqual(obj.Status, UP_TO_DATE)
        after = self.times(obj)
        self.assertEqual([after[k] == marks[k] for k in ("One", "Two")], [False, True])
        self.wall.Placement = shift(x=45)
        self.doc.recompute()
        self.assertEqual(obj.Status, STALE)
        self.wall.Placement = shift(x=43.5)
        self.doc.recompute()
        self.assertEqual(obj.Status, UP_TO_DATE, "as it was when it was computed")
        other.Label = "Zwei"
        self.doc.recompute()
        self.assertEqual(obj.Status, STALE, "runs have the names of their sources")

    def times(self, obj):
        found = {}
        for name in os.listdir(obj.Results):
            path = os.path.join(obj.Results, name, "report.json")
            if os.path.exists(path):
                found[name] = os.stat(path).st_mtime_ns
        return found

    def test_labels_that_are_there_twice_or_are_no_file_names(self):
        found = [self.check(label=label) for label in ("a/b", "a:b", "study.csv", "..", "A_B")]
        obj = self.of_document(*found)
        names = study.Plan.of(obj).runs()
        self.assertEqual(names, ["a_b", "a_b (2)", "study.csv_", "_", "A_B (3)"])
        study.compute(obj)
        self.assertEqual([row["run"] for row in study.report_of(obj)["runs"]], names)
        for name, source in zip(names, found):
            self.assertIs(study.Plan.of(obj).source_of(name), source)

    def test_what_runs_share_is_written_once_and_what_is_left_goes(self):
        one, other = self.check(label="One"), self.check(2.0, "Two")
        obj = self.of_document(one, other)
        study.compute(obj)
        folder = os.path.join(self.folder, "study", study_export.INPUTS)
        self.assertEqual(len(os.listdir(folder)), 4, "part, motion, two neighbours")
        self.wall.Placement = shift(x=50)
        self.doc.recompute()
        before = set(os.listdir(folder))
        study.compute(obj)
        self.assertEqual(len(set(os.listdir(folder)) & before), 3)
        self.assertEqual(len(os.listdir(folder)), 4)

    # --- of a file

    def test_a_study_file(self):
        obj = self.of_file()
        self.assertEqual((obj.Status, obj.Message), (NOT_COMPUTED, ""))
        report = study.compute(obj)
        rows = {row["run"]: row for row in report["runs"]}
        self.assertEqual(rows["near"]["state"], "done")
        self.assertAlmostEqual(rows["near"]["distance"], 3, delta=0.01)
        self.assertEqual(rows["into"]["verdict"], "clash")
        self.assertEqual((obj.Status, obj.Verdict), (UP_TO_DATE, "clash"))
        self.assertIn("1 not clear", obj.Summary)
        self.file("near.csv", "0,0,0,0,0,0,0,1\n1,31.5,0,0,0,0,0,1\n")
        self.doc.recompute()
        study.update_status(obj)
        self.assertEqual(obj.Status, STALE)
        study.compute(obj)
        self.assertEqual(obj.Status, UP_TO_DATE)
        obj.File = self.file("study.toml", FILE.replace('"into.csv"', '"far.csv"'))
        study.update_status(obj)  # as its panel does
        self.assertEqual(obj.Status, STALE)

    def test_runs_that_fail_are_told(self):
        obj = self.of_file()
        self.file("into.csv", "0,0,0,0,0,0,0,1\n1,nan,0,0,0,0,0,1\n")
        study.compute(obj)
        self.assertEqual((obj.Status, obj.Verdict), (UP_TO_DATE, "failed"))
        self.assertIn("1 of 2 runs failed; 'into'", obj.Message)
        self.assertEqual(study.report_of(obj)["worst"], "into")

    def test_bad_input_is_named(self):
        obj = self.of_file(FILE.replace('["clearance"]', '["drawing"]'))
        self.assertEqual(obj.Status, NOT_COMPUTED)
        self.assertIn("it must be a list of envelope, solid, clearance", obj.Message)
        with self.assertRaisesRegex(core.CoreError, "study.toml.*must be a list"):
            study.compute(obj)
        obj.File = os.path.join(self.folder, "gone.toml")
        with self.assertRaisesRegex(InputProblem, "gone.toml.*cannot be read"):
            study.compute(obj)
        obj.File = ""
        with self.assertRaisesRegex(InputProblem, "choose a study file, or envelopes"):
            study.compute(obj)
        obj.Sources = [self.check()]
        with self.assertRaisesRegex(InputProblem, "save the document first"):
            study.compute(obj)
        obj.Folder = self.folder
        obj.Sources = [self.part]
        with self.assertRaisesRegex(InputProblem, '"Schieber" cannot be a run'):
            study.compute(obj)
        obj.Sources = [mechanism.make_mechanism(self.doc)]
        with self.assertRaisesRegex(InputProblem, '"Mechanism" cannot be a run'):
            study.compute(obj)

    def test_two_at_once_are_refused(self):
        import fcntl

        obj = self.of_file()
        os.makedirs(os.path.join(self.folder, "results"))
        with open(os.path.join(self.folder, "results", ".study.lock"), "w") as file:
            fcntl.flock(file, fcntl.LOCK_EX)
            with self.assertRaisesRegex(InputProblem, "another study is writing to"):
                study.compute(obj)
        self.assertEqual(obj.Status, FAILED)
        self.assertIn("another study is writing to", obj.Message)
        study.compute(obj)
        self.assertEqual(obj.Status, UP_TO_DATE)

    # --- stop, go on, documents

    def test_what_was_stopped_goes_on(self):
        text = (
            FILE
            + '[[run]]\nname = "long"\nmotion = "far.csv"\ncompute = ["envelope"]\n'
            + ("envelope = { resolution = 1500 }\n")
        )
        obj = self.of_file(text)
        obj.Jobs = 1
        control = core.Control()
        enter = control.enter

        def entered(part, parts):
            enter(part, parts)
            if part == 2:
                control.cancel()

        with mock.patch.object(control, "enter", entered):
            with self.assertRaises(core.CoreError):
                study.compute(obj, control)
        self.assertEqual(obj.Status, CANCELLED)
        self.assertIn("1 of 3 runs are not done", obj.Message)
        states = {row["run"]: row["state"] for row in study.report_of(obj)["runs"]}
        self.assertEqual(states, {"near": "done", "into": "not clear", "long": "not run"})
        self.doc.recompute()
        self.assertEqual(obj.Status, CANCELLED)
        self.file("study.toml", text.replace("1500", "24"))
        marks = self.times(obj)
        study.compute(obj)
        self.assertEqual(obj.Status, UP_TO_DATE)
        after = self.times(obj)
        self.assertEqual([after[k] == marks[k] for k in ("near", "into")], [True, True])

    def test_documents_keep_it(self):
        check = self.check()
        obj = self.of_document(check, Folder="", Jobs=2)
        path = os.path.join(self.folder, "doc ü.FCStd")
        self.doc.saveAs(path)
        study.compute(obj)
        self.assertTrue(obj.Results.startswith(os.path.join(self.folder, "doc ü-study")))
        self.doc.save()
        App.closeDocument(self.doc.Name)
        self.doc = App.openDocument(path)
        again = self.doc.getObject("Study")
        self.assertEqual((again.Status, again.Jobs), (UP_TO_DATE, 2))
        self.assertEqual(study.report_of(again)["runs"][0]["state"], "not clear")
        self.doc.recompute()
        self.assertEqual(again.Status, UP_TO_DATE)
        again.Report = "{"
        self.assertIsNone(study.report_of(again))

    def test_copy_and_undo(self):
        check = self.check()
        obj = self.of_document(check)
        if hasattr(self.doc, "clearUndos"):
            self.doc.clearUndos()
        study.compute(obj)
        self.assertEqual(obj.Status, UP_TO_DATE)
        copy = self.doc.copyObject(obj)
        self.doc.recompute()
        self.assertEqual((copy.Status, copy.Sources), (UP_TO_DATE, [check]))
        self.doc.undo()
        self.assertEqual(obj.Report, "")
        self.assertEqual(obj.Status, NOT_COMPUTED)
        self.doc.redo()
        self.assertEqual(obj.Status, UP_TO_DATE)

    def test_a_source_that_is_deleted_is_missed(self):
        one, other = self.check(label="One"), self.check(label="Two")
        obj = self.of_document(one, other)
        study.compute(obj)
        self.doc.removeObject(one.Name)
        self.doc.recompute()
        self.assertEqual(obj.Status, FAILED)
        self.assertIn('"One" was deleted', obj.Message)
        with self.assertRaisesRegex(InputProblem, '"One" was deleted'):
            study.compute(obj)

    def test_without_the_core_the_rows_stay(self):
        obj = self.of_file()
        study.compute(obj)
        with mock.patch.object(core, "available", lambda: False):
            study.update_status(obj)  # as its panel does
            self.doc.recompute()
        self.assertEqual(obj.Status, UP_TO_DATE)
        self.assertEqual(len(study.report_of(obj)["runs"]), 2)

    def test_no_interpreter_is_said(self):
        obj = self.of_file()
        with mock.patch.object(studies.interpreter, "find", lambda: None):
            with self.assertRaisesRegex(InputProblem, "Studies need the program python3"):
                study.compute(obj)
