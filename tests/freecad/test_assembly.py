# SPDX-License-Identifier: LGPL-2.1-or-later
"""The motion of a part in a simulation of FreeCAD's Assembly is the one that its solver computes."""
from case import Case, shift
from simulations import SPEED, Absent, arm_after, hinge
from sweptvolume import core
from sweptvolume.convert import InputProblem
from sweptvolume.features import envelope, joint_motions, mechanism, motion
from sweptvolume.trajectory import assembly, sources


class Simulated(Case):
    def setUp(self):
        super().setUp()
        try:
            self.simulation, self.arm, self.drive = hinge(self.doc)
        except Absent as reason:
            self.skipTest(str(reason))

    def path(self):
        obj = motion.motion_from_source(self.doc, "Simulation", [self.simulation, self.arm])
        self.doc.recompute()
        return obj

    def test_poses_are_those_of_the_solver(self):
        obj = self.path()
        self.assertEqual(list(obj.Times), [0, 0.25, 0.5, 0.75, 1])
        for time, place in zip(obj.Times, obj.Placements):
            self.assert_placement(place, arm_after(time), 1e-6)
        self.assert_placement(self.arm.Placement, arm_after(0), 1e-9)
        self.assertEqual([o.Name for o in self.doc.Objects if "Invalid" in o.State], [])

    def test_simulation_and_part_are_chosen_in_any_order(self):
        for chosen in ([self.simulation, self.arm], [self.arm, self.simulation]):
            found = sources.in_order(chosen)
            self.assertEqual(sources.kind_for(found), "Simulation")
            self.assertEqual([o.Name for o in found], [self.simulation.Name, self.arm.Name])

    def test_step_that_does_not_meet_the_end(self):
        self.simulation.cTimeStepOutput = 0.3
        self.simulation.aTimeStart = 0.2
        found = assembly.poses([self.simulation, self.arm])
        self.assertEqual([round(t, 9) for t in found.times], [0.2, 0.5, 0.8])
        for time, place in zip(found.times, found.placements):
            self.assert_placement(place, arm_after(time), 1e-6)

    def test_moved_assembly(self):
        self.doc.getObject("Assembly").Placement = shift(0, 0, 50)
        self.doc.recompute()
        last = self.path().Placements[-1]
        self.assert_placement(last, shift(0, 0, 50) * arm_after(1), 1e-6)

    def test_broken_formula_is_said(self):
        self.drive.Formula = "nonsense*"
        with self.assertRaisesRegex(InputProblem, '"Simulation" gave no frames'):
            self.path()
        self.assert_placement(self.arm.Placement, arm_after(0), 1e-9)

    def test_saved_opened_changed_reloaded(self):
        name = self.path().Name
        self.reopen()
        obj = self.doc.getObject(name)
        self.assertEqual((obj.SourceType, obj.Status), ("Simulation", ""))
        self.assert_placement(obj.Placements[-1], arm_after(1), 1e-6)
        self.doc.getObject("Drive").Formula = "0.5*time"
        self.doc.recompute()
        self.assertEqual(obj.Status, motion.STALE)
        motion.reload_source(obj)
        self.doc.recompute()
        self.assertEqual(obj.Status, "")
        self.assert_placement(obj.Placements[-1], arm_after(1, 0.5), 1e-6)

    def test_all_parts_of_a_simulation(self):
        """One run gives the motions of all parts that move: the arm, not the base. Their distance stays
        0 mm, because a hinge joins them."""
        settings = sources.Settings("Simulation", objects=[self.simulation])
        self.assertEqual(sources.kind_for([self.simulation]), "Simulation")
        self.assertIn(self.simulation, [s.objects[0] for s in joint_motions.sources_in(self.doc)])
        found, notes = joint_motions.of_source(self.doc, settings)
        self.doc.recompute()
        self.assertEqual(([m.SourceObjects[1].Name for m in found], notes), (["Arm"], []))
        self.assert_placement(found[0].Placements[-1], arm_after(1), 1e-6)
        self.assert_placement(self.arm.Placement, arm_after(0), 1e-9)
        if not core.available():
            self.skipTest("the compiled core _swept is not built")
        post = self.box("Post", 4)
        post.Placement = shift(10, 50, 0)  # the arm's far corner passes it
        obj = mechanism.make_mechanism(
            self.doc,
            MovingParts=[(self.arm, "")],
            Motions=found,
            Neighbours=[(post, ""), (self.doc.getObject("Base"), "")],
            Range=100,
        )
        self.doc.recompute()
        mechanism.compute(obj)
        pairs = mechanism.report_of(obj)["pairs"]
        rows = {p["second"]: p["clearance"] for p in pairs}
        least = min(self._at(arm_after(t / 200)).distToShape(post.Shape)[0] for t in range(201))
        self.assertLessEqual(rows["Post"]["guaranteed"], least)
        self.assertAlmostEqual(rows["Post"]["distance"], least, delta=0.02)
        self.assertEqual(rows["Base"]["distance"], 0)

    def _at(self, placement):
        shape = self.arm.LinkedObject.Shape.copy()
        shape.Placement = placement
        return shape

    def test_envelope(self):
        if not core.available():
            self.skipTest("the compiled core _swept is not built")
        path = self.path()
        path.Interpolation = "Screw"
        obj = self.envelope([self.arm], path, Resolution=64)
        envelope.compute(obj)
        # Area: the rectangle of the arm, plus the sector that its diagonal sweeps.
        true = 10 * (20 * 10 + (20**2 + 10**2) * SPEED / 2)
        self.assertAlmostEqual(obj.Volume.Value, true, delta=0.01 * true)
