# SPDX-License-Identifier: LGPL-2.1-or-later
"""Documents in which properties of the workbench are damaged, or linked to objects of the wrong kind."""
import os
import random
import sys
import unittest.mock
import zipfile

import FreeCAD as App

from case import Case, V, shift, turn
from sweptvolume import core
from sweptvolume.convert import InputProblem
from sweptvolume.features import clearance, clearance_table, envelope, motion
from sweptvolume.trajectory import poses, sources

sys.path.append(os.path.join(os.path.dirname(os.path.dirname(os.path.realpath(__file__))), "tools"))
import document_fuzz  # noqa: E402


class Damaged(Case):
    """The cases that tests/tools/document_fuzz.py has found, each by itself, and a small run of this
    tool."""

    NEEDS_CORE = True

    def checked(self):
        wall = self.box("Wall")
        wall.Placement = shift(0, 15)
        neighbours = {"AllVisible": False, "Neighbours": [(wall, "")]}
        settings = dict(MovingParts=[(self.box(), "")], Motion=self.line(), **neighbours)
        obj = clearance.make_clearance(self.doc, **settings)
        self.doc.recompute()
        clearance.compute(obj)
        return obj

    def test_a_damaged_report_is_none(self):
        obj = self.checked()
        self.assertEqual(len(clearance_table.table(clearance.report_of(obj))), 1)
        for text in (
            "",
            "{",
            "null",
            "-1",
            '{"neighbours": [{}]}',
            obj.Report.replace("below", "x"),
        ):
            obj.Report = text
            self.assertIsNone(clearance.report_of(obj), text)
        body = self.envelope([self.box()], self.line())
        envelope.compute(body)
        self.assertEqual(envelope.warnings_of(envelope.report_of(body)), [])
        for text in ("[]", '{"warnings": 3}', body.Report.replace('"cell":', '"cell": null, "c":')):
            body.Report = text
            self.assertIsNone(envelope.report_of(body), text)

    def test_damaged_settings_of_a_source_are_said(self):
        obj = motion.motion_from_source(self.doc, "Placements", [self.box(), self.box("B")])
        self.doc.recompute()
        for text in ("{", "[1]", "-1", "null"):
            obj.SourceSettings = text
            self.doc.recompute()
            self.assertIn("settings of the motion's source are damaged", obj.Status)
        obj.SourceSettings = ""
        self.doc.recompute()
        self.assertEqual((obj.Status, obj.Count), ("", 2))
        with self.assertRaisesRegex(InputProblem, "2 to 100000"):
            sources.Settings(kind="Curve", count=10**9).count(5)

    def test_times_and_velocities_beyond_all_measure(self):
        places = [shift(), turn(60), shift(9)]
        for times in ([0, 1, float("inf")], [float("nan"), 1, 2]):
            with self.assertRaisesRegex(InputProblem, "must be a finite number"):
                poses.Poses(times, places)
        for times, tangents in (
            ([0, 1, 1e300], []),
            ([0, 1, 2], [("Given", V(float("nan"), 0, 0))]),
        ):
            keys = poses.Poses(times, places, tangents)
            with self.assertRaisesRegex(InputProblem, "The spline from pose"):
                poses.at_time(keys, "Spline", 0.9 * times[-1])
                poses.at_time(keys, "Spline", 0.5)

    def test_a_choice_that_does_not_exist_becomes_the_usual_one(self):
        obj = self.envelope([self.box()], self.line())
        obj.Backend = "CPU"
        path, other = (os.path.join(self.folder, n) for n in ("a.FCStd", "b.FCStd"))
        self.doc.saveAs(path)
        App.closeDocument(self.doc.Name)
        with zipfile.ZipFile(path) as source, zipfile.ZipFile(other, "w") as target:
            for name in source.namelist():
                data = source.read(name)
                if name == "Document.xml":
                    at = data.index(b'<Integer value="1"', data.index(b'<Property name="Backend"'))
                    data = data[:at] + b'<Integer value="77"' + data[at + 18 :]
                target.writestr(name, data)
        self.doc = App.openDocument(other)
        obj = self.doc.Envelope
        self.assertEqual(obj.Backend, "Auto")
        envelope.compute(obj)

    def test_links_to_objects_of_another_kind_are_refused_by_name(self):
        body = self.envelope([self.box()], self.line())
        body.Reference, body.ReferenceMotion = (self.box("B"), [""]), self.box("C")
        with self.assertRaisesRegex(InputProblem, '"C" is not a motion'):
            envelope.compute(body)
        check = self.checked()
        check.Envelope = self.doc.Wall
        with self.assertRaisesRegex(InputProblem, '"Wall" is not an envelope'):
            clearance.compute(check)

    def test_a_resolution_beyond_every_limit_is_refused_before_the_triangles(self):
        ball = self.doc.addObject("Part::Sphere", "Ball")
        obj = self.envelope([ball], self.line(), Resolution=2**31 - 1)
        with unittest.mock.patch("sweptvolume.convert.body_from") as triangles:
            with self.assertRaisesRegex(core.CoreError, "allowed: 4 to 16384"):
                envelope.compute(obj)
        triangles.assert_not_called()
        self.assertEqual(obj.Status, envelope.FAILED)


class Fuzz(Case):
    NEEDS_CORE = True

    def setUp(self):
        super().setUp()
        self.base = document_fuzz.base_document(self.folder)
        with zipfile.ZipFile(self.base) as file:
            self.items = {name: file.read(name) for name in file.namelist()}
        self.broken, self.copy = (os.path.join(self.folder, n) for n in ("b.FCStd", "c.FCStd"))

    def outcome(self, seed):
        document_fuzz.damage(self.items, random.Random(seed), self.broken)
        return document_fuzz.judged(self.broken, self.copy)

    def test_forty_documents(self):
        for seed in range(40):
            outcome = self.outcome(seed)
            self.assertEqual(outcome["fault"], "", (seed, outcome))

    def test_planted_faults_are_found(self):
        """The tool notices an unexpected exception, an exception that FreeCAD hides, and a mesh that a
        failed run has changed."""

        def key_error(*_, **__):
            return {}["planted"]

        def changed(obj, control):
            obj.Mesh = type(obj.Mesh)()
            raise InputProblem("planted")

        plants = [
            ("sweptvolume.features.clearance.compute", key_error, "KeyError: 'planted'"),
            ("sweptvolume.features.envelope.Envelope.execute", key_error, "key_error, KeyError"),
            (
                "sweptvolume.features.envelope.compute",
                changed,
                "a run that failed changed the mesh",
            ),
        ]
        for name, plant, text in plants:
            with unittest.mock.patch(name, plant):
                self.assertIn(text, self.outcome(0)["fault"])
        self.assertEqual(self.outcome(0)["fault"], "")
