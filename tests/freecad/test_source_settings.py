# SPDX-License-Identifier: LGPL-2.1-or-later
"""Settings of a motion's source: properties with types, which expressions can drive; settings of older
documents.
"""
import json

import Part

from case import Case, V
from sweptvolume.features import motion
from sweptvolume.features.base import STALE
from sweptvolume.features.motion_properties import NAMES
from sweptvolume.trajectory import driven


class Made(Case):
    def wire(self):
        obj = self.doc.addObject("Part::Feature", "Wire")
        obj.Shape = Part.makePolygon([V(), V(20, 0, 0), V(20, 9, 0)])
        return obj

    def shown(self, obj):
        return {n for n in NAMES.values() if "Hidden" not in obj.getEditorMode(n)}

    def driven(self, **more):
        part, driver = self.box(), self.box("Driver")
        part.setExpression("Placement.Base.x", "Driver.Length")
        self.doc.recompute()
        values = dict(property="Length", start=1.0, end=5.0, count=3, duration=2.0, **more)
        return motion.motion_from_source(self.doc, "Driven", [driver, part], **values), values


class Settings(Made):
    def test_the_settings_of_the_kind_are_shown_and_no_others(self):
        obj = motion.motion_from_source(self.doc, "Curve", [self.wire()])
        kept = {"SourceAccuracy", "SourceCount", "SourceOrientation", "SourceDuration"}
        self.assertEqual(self.shown(obj), kept)
        motion.make_stored(obj)
        self.assertEqual(self.shown(obj), set())
        self.assertEqual(obj.getEditorMode("SourceObjects"), ["Hidden"])

    def test_a_live_source_follows_its_settings(self):
        obj = motion.motion_from_source(self.doc, "Curve", [self.wire()])
        self.assertEqual(obj.Count, 0)
        self.doc.recompute()
        self.assertEqual((obj.Count, obj.Duration), (3, 10.0))
        obj.SourceDuration, obj.SourceOrientation = 4.0, "Tangent"
        self.doc.recompute()
        self.assertEqual((obj.Count, obj.Duration), (4, 4.0))  # the motion turns at the corner
        obj.SourceCount = 5
        self.doc.recompute()
        self.assertEqual(obj.Count, 5)

    def test_expressions_drive_them(self):
        sheet = self.doc.addObject("Spreadsheet::Sheet", "Values")
        for cell, value, name in (("A1", "6 s", "lasts"), ("A2", "0.5 mm", "fine")):
            sheet.set(cell, value)
            sheet.setAlias(cell, name)
        self.doc.recompute()
        obj = motion.motion_from_source(self.doc, "Curve", [self.wire()])
        obj.setExpression("SourceDuration", "Values.lasts / 2")
        obj.setExpression("SourceAccuracy", "Values.fine")
        self.doc.recompute()
        self.assertEqual((obj.Duration, obj.SourceAccuracy.Value), (3.0, 0.5))
        sheet.set("A1", "8 s")
        self.doc.recompute()
        self.assertEqual(obj.Duration, 4.0)

    def test_settings_out_of_range_are_said(self):
        obj = motion.motion_from_source(self.doc, "Curve", [self.wire()])
        obj.SourceAccuracy = 0
        self.doc.recompute()
        self.assertIn("greater than 0", obj.Status)
        obj.SourceAccuracy, obj.SourceCount = 1, 10**6
        self.doc.recompute()
        self.assertIn("2 to 100000", obj.Status)
        obj.SourceCount = 0
        self.doc.recompute()
        self.assertEqual(obj.Status, "")

    def test_a_driven_motion_knows_the_part_that_was_watched(self):
        obj, _ = self.driven()
        self.assertEqual(motion.parts_of(obj), [(self.doc.Box, "")])
        self.assertEqual(motion.label_for(motion.parts_of(obj)), "Motion of Box")

    def test_another_range_makes_a_driven_motion_stale(self):
        obj, _ = self.driven()
        self.doc.recompute()
        for name, value in (("SourceEnd", 6.0), ("SourceCount", 9), ("SourceDuration", 3.0)):
            self.assertEqual(obj.Status, "")
            setattr(obj, name, value)
            self.doc.recompute()
            self.assertEqual(obj.Status, STALE, name)
            motion.reload_source(obj)
            self.doc.recompute()
        self.assertEqual((obj.Count, obj.Duration, obj.Placements[-1].Base.x), (9, 3.0, 6.0))


class Files(Case):
    NEEDS_CORE = True  # the core reads them

    def test_another_unit_of_the_file_makes_the_poses_stale(self):
        path = self.file("a.csv", "t,tx,ty,tz,qx,qy,qz,qw\n0,0,0,0,0,0,0,1\n1,1,0,0,0,0,0,1\n")
        obj = motion.motion_from_file(self.doc, path)
        self.doc.recompute()
        self.assertEqual(obj.Status, "")
        obj.SourceUnit = "m"
        self.doc.recompute()
        self.assertEqual(obj.Status, STALE)
        motion.reload_source(obj)
        self.doc.recompute()
        self.assertEqual((obj.Status, obj.Placements[1].Base.x), ("", 1000.0))


class Older(Made):
    """Documents of version 1, which stored the settings as text."""

    def reopened(self, obj, settings, hashed=""):
        """Makes a motion as version 1 stored it, with the settings as JSON and without properties for
        them; saves and opens it."""
        for name in NAMES.values():
            obj.removeProperty(name)
        obj.SourceSettings, obj.SourceHash = settings, hashed
        self.reopen()
        return self.doc.getObject("Motion")

    def test_settings_of_older_documents_become_properties(self):
        obj = motion.motion_from_source(self.doc, "Curve", [self.wire()])
        settings = '{"accuracy": 0.5, "duration": 4.0, "orientation": "Tangent"}'
        obj = self.reopened(obj, settings)
        self.assertEqual(obj.SourceSettings, "")
        self.assertEqual(obj.SourceAccuracy.Value, 0.5)
        self.assertEqual((obj.SourceOrientation, obj.SourceDuration), ("Tangent", 4.0))
        self.doc.recompute(None, True)
        self.assertEqual((obj.Status, obj.Duration), ("", 4.0))

    def test_a_number_of_poses_of_an_older_document_counts(self):
        obj = self.reopened(motion.motion_from_source(self.doc, "Curve", [self.wire()]), "{}")
        self.assertEqual(obj.SourceCount, 0)
        obj = self.reopened(obj, '{"count": 7}')
        self.doc.recompute(None, True)
        self.assertEqual((obj.Count, obj.SourceCount), (7, 7))

    def test_damaged_settings_of_an_older_document_are_said(self):
        for text in ("{", "[1]", '{"count": null}', '{"orientation": "Sideways"}'):
            obj = motion.motion_from_source(self.doc, "Curve", [self.wire()])
            obj = self.reopened(obj, text)
            self.doc.recompute(None, True)
            self.assertIn("settings of the motion's source are damaged", obj.Status, text)
            self.tearDown()
            self.setUp()

    def test_a_driven_motion_of_an_older_document_is_not_stale(self):
        obj, values = self.driven()
        before = driven.signature(obj.SourceObjects, "Length")
        obj = self.reopened(obj, json.dumps(values), before)
        self.doc.recompute(None, True)
        self.assertEqual((obj.Status, obj.SourceEnd, obj.SourceCount), ("", 5.0, 3))
        obj.SourceEnd = 6
        self.doc.recompute()
        self.assertEqual(obj.Status, STALE)
