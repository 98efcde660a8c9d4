# SPDX-License-Identifier: LGPL-2.1-or-later
"""Results in documents that were saved: by this version, and as version 1 left them."""
from case import Case, V, shift, turn
from scene_case import Scene, plate
from sweptvolume import core
from sweptvolume.features import clearance, envelope, motion, solid


class Saved(Scene):
    def test_numbers_of_many_digits_are_the_same_when_a_document_is_opened(self):
        third = 1.0 / 3.0 / 10  # a quantity of seventeen digits
        self.swept.Tolerance = self.swept.Offset = third
        self.body.Tolerance = 2 * third
        self.check.RequiredDistance, self.check.MeshDeflection = 100 * third, third
        self.doc.recompute()
        envelope.compute(self.swept)
        if core.has_solids():
            solid.compute(self.body)
        clearance.compute(self.check)
        self.doc.recompute()
        self.assert_states(*[envelope.UP_TO_DATE] * 3)
        names = [obj.Name for obj in (self.swept, self.check, self.body)]
        self.reopen()
        for obj in self.doc.Objects:
            obj.enforceRecompute()  # as "Mark to recompute" in the tree does
        self.doc.recompute(None, True)
        self.swept, self.check, self.body = map(self.doc.getObject, names)
        self.assert_states(*[envelope.UP_TO_DATE] * 3)


class OfBefore(Scene):
    def test_results_of_before_are_known_again(self):
        """A document as version 1 left it: hashes of sizes, none of the properties that came since."""
        plans = [
            (self.swept, envelope.Plan.of(self.swept)),
            (self.check, clearance.Plan.of(self.check)),
        ]
        before = [(obj, plan.hash_of_before()) for obj, plan in plans]
        before.append((self.body, solid.hash_of_before(self.body)))
        names = [obj.Name for obj, _ in before]
        for obj, text in before:
            for name in ("Placed", "Missing", "Seen"):
                if name in obj.PropertiesList:
                    obj.removeProperty(name)
            if obj is not self.body or core.has_solids():
                obj.InputHash = text
        self.body.removeProperty("TriedHash")
        for obj, _ in before:
            obj.purgeTouched()
        self.reopen()
        self.assertEqual([o.Name for o in self.doc.Objects if "Touched" in o.State], [])
        self.doc.recompute(None, True)
        self.swept, self.check, self.body = map(self.doc.getObject, names)
        self.assert_states(*[envelope.UP_TO_DATE] * 3)
        self.doc.getObject("Plate").Shape = plate(30)
        self.doc.recompute()
        self.assert_states(*[envelope.STALE] * 3)


class BeforePivots(Case):
    NEEDS_CORE = True

    def test_a_motion_of_a_document_of_before_turns_about_the_origin_of_its_poses(self):
        box = self.box()
        box.Placement = shift(40)
        places = [shift(40), turn(80, base=V(10, 50, 0))]
        path = motion.motion_from_poses(self.doc, [0, 1], places)
        path.Pivot = V()
        hull = self.envelope([box], path, Resolution=32)
        envelope.compute(hull)
        names, volume = (path.Name, hull.Name), hull.Volume.Value
        path.Pivot = V(5, 5, 5)
        envelope.compute(hull)
        self.assertNotAlmostEqual(hull.Volume.Value, volume, delta=1e-3 * volume)
        path.Pivot = V()
        envelope.compute(hull)
        path.removeProperty("Pivot")
        self.reopen()
        path, hull = map(self.doc.getObject, names)
        self.doc.recompute(None, True)
        self.assertEqual(tuple(path.Pivot), (0, 0, 0))
        self.assertEqual(hull.Status, envelope.UP_TO_DATE)
        envelope.compute(hull)
        self.assertAlmostEqual(hull.Volume.Value, volume, delta=1e-9 * volume)
