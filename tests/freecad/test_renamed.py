# SPDX-License-Identifier: LGPL-2.1-or-later
"""Documents in which properties still have the names of earlier versions. names_of_before.FCStd was saved by
the last version with these names (documents/make_of_before.py says how).
"""
import os
import re
import shutil

import FreeCAD as App

from case import Case
from sweptvolume.features import clearance, mechanism, motion, renamed
from sweptvolume.features.base import NOT_COMPUTED, UP_TO_DATE

BEFORE = os.path.join(os.path.dirname(os.path.realpath(__file__)), "documents")


class Renamed(Case):
    NEEDS_CORE = True

    def setUp(self):
        super().setUp()
        path = os.path.join(self.folder, "before.FCStd")
        shutil.copy(os.path.join(BEFORE, "names_of_before.FCStd"), path)
        self.doc = App.openDocument(path)

    def expressions(self, name):
        found = self.doc.getObject(name).ExpressionEngine
        return {path.lstrip("."): text for path, text in found}

    def check(self):
        doc = self.doc
        self.assertEqual((doc.Motion.PoseType, doc.Motion.SourceRotaryAxes), ("Relative", "Table"))
        for name, parts in (
            ("Envelope", ["Part"]),
            ("Clearance", ["Part"]),
            ("Mechanism", ["Part", "Other"]),
            ("Sequence", ["Part", "Other"]),
            ("SharedVolume", ["Envelope"]),
        ):
            linked = [part.Name for part, _ in doc.getObject(name).MovingParts]
            self.assertEqual((name, linked), (name, parts))
        self.assertEqual(doc.Envelope.Tolerance.Value, 0.25)
        self.assertEqual(
            (doc.EnvelopeSolid.Tolerance.Value, doc.EnvelopeSolid.MaxFaces), (0.5, 700)
        )
        self.assertEqual(doc.SharedVolume.MeshDeflection.Value, 0.07)
        names = ("RequiredDistance", "Accuracy", "MeshDeflection")
        for name, values in (("Clearance", (8, 0.02, 0.08)), ("Mechanism", (4, 0.03, 0.06))):
            found = [doc.getObject(name).getPropertyByName(key).Value for key in names]
            self.assertEqual((name, [round(v, 9) for v in found]), (name, list(values)))
        self.assertEqual(doc.Mechanism.Range.Value, 100)
        self.assertEqual((doc.Sequence.RequiredDistance, doc.Sequence.ReleaseDistance), (0.7, 11))
        for obj in doc.Objects:
            kind = getattr(getattr(obj, "Proxy", None), "KIND", "")
            for old in renamed.RENAMED.get(kind, {}):
                self.assertNotIn(old, obj.PropertiesList)

    def test_values_and_links_keep_and_results_stay_current(self):
        self.check()
        for name in ("Envelope", "EnvelopeSolid", "Clearance", "Mechanism", "SharedVolume"):
            self.assertEqual((name, self.doc.getObject(name).Status), (name, UP_TO_DATE))
        self.assertEqual(self.doc.Sequence.Status, NOT_COMPUTED)
        self.doc.recompute(None, True)  # all objects, as some versions do after opening
        self.check()
        for name in ("Envelope", "EnvelopeSolid", "Clearance", "Mechanism", "SharedVolume"):
            self.assertEqual((name, self.doc.getObject(name).Status), (name, UP_TO_DATE))
        smallest = self.doc.Clearance.Smallest.Value
        clearance.compute(self.doc.Clearance)
        self.assertAlmostEqual(self.doc.Clearance.Smallest.Value, smallest, 9)
        mechanism.compute(self.doc.Mechanism)

    def test_expressions_go_with_them(self):
        own = self.expressions("Clearance")
        self.assertEqual(set(own), {"RequiredDistance", "MeshDeflection"})
        self.assertRegex(own["RequiredDistance"], r"^Values.length \* 1 ?mm$")  # FreeCAD 1.0: 1 mm
        self.assertRegex(own["MeshDeflection"], r"^\.?RequiredDistance / 100$")
        others = self.expressions("Gauge")
        self.assertRegex(others["Length"], r"RequiredDistance \+ Sequence\.ReleaseDistance$")
        self.assertEqual(others["Width"], "Clearance.MeshDeflection * 10")
        self.assertEqual(self.doc.Values.getContents("B1"), "=Mechanism.RequiredDistance * 2")
        self.doc.Values.set("A1", "12")
        self.doc.Sequence.ReleaseDistance = 20
        self.doc.Mechanism.RequiredDistance = 5
        self.doc.recompute()
        self.assertEqual(self.doc.Clearance.RequiredDistance.Value, 12)
        self.assertEqual(self.doc.Clearance.MeshDeflection.Value, 0.12)
        self.assertEqual((self.doc.Gauge.Length.Value, self.doc.Values.B1.Value), (32, 10))
        self.assertAlmostEqual(self.doc.Gauge.Width.Value, 1.2)

    def test_what_is_missing_is_still_known(self):
        left = self.doc.Clearance001
        with self.assertRaisesRegex(Exception, '"Lost" was deleted.*MovingParts'):
            clearance.compute(left)
        left.MovingParts = [(self.doc.Other, "")]
        self.assertEqual(left.Missing, "")

    def test_saved_again_it_has_the_new_names_only(self):
        self.doc.recompute()
        self.reopen()
        self.doc = App.ActiveDocument
        self.check()
        self.test_expressions_go_with_them()

    def test_a_new_motion_has_no_old_names(self):
        path = motion.make_motion(self.doc)
        self.assertFalse({"Frame", "SourceConvention"} & set(path.PropertiesList))


class Rewriting(Case):
    """Tests which parts of an expression are names of properties."""

    def test_of_the_object_itself(self):
        names = {"Required": "RequiredDistance"}
        for text, wanted in (
            ("Required * 2", "RequiredDistance * 2"),
            (".Required + 1mm", ".RequiredDistance + 1mm"),
            ("Other.Required", "Other.Required"),
            ("<<Other>>.Required", "<<Other>>.Required"),
            ("RequiredToo + NotRequired", "RequiredToo + NotRequired"),
            ("max(Required; Other.Required)", "max(RequiredDistance; Other.Required)"),
        ):
            self.assertEqual(renamed._without_object(text, names), wanted)

    def test_hashes_know_the_old_names(self):
        text = renamed.hashed({"RequiredDistance": 5.0, "Accuracy": 0.01, "Range": 1})
        self.assertEqual(text, '{"Range": 1, "Required": 5.0, "Tolerance": 0.01}')
        self.assertIsNone(re.search("Distance|Accuracy", text))
