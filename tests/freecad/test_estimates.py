# SPDX-License-Identifier: LGPL-2.1-or-later
"""The memory and time that the panel of an envelope estimates, compared with those of the run."""
import Mesh
import Part

from case import Case, V, turn
from sweptvolume import contents, core
from sweptvolume.features import envelope, motion


class Estimate(Case):
    NEEDS_CORE = True

    def test_the_cell_is_that_of_the_run(self):
        part = self.doc.addObject("Part::Feature", "Part")
        part.Shape = Part.makeCylinder(10, 60).fuse(Part.makeTorus(25, 4, V(0, 0, 20)))
        net = self.doc.addObject("Mesh::Feature", "Net")
        net.Mesh = Mesh.createSphere(15, 30)
        places = [turn(20 * k, V(1, 1, 0.3), V(10 * k, 3 * k, 0)) for k in range(7)]
        path = motion.motion_from_poses(self.doc, range(7), places)
        for parts in ([part], [net], [part, net]):
            obj = self.envelope(parts, path, Resolution=50)
            found = envelope.Plan.of(obj).estimate()
            envelope.compute(obj)
            cell = obj.UsedCellSize.Value
            self.assertAlmostEqual(found["cell"], cell, delta=2e-3 * cell)
            ran = envelope.json.loads(obj.Report)["grid"]
            for a, b in zip(found["grid"], ran):
                self.assertLessEqual(abs(a - b), 1)

    def test_a_closer_estimate_samples_the_parts_themselves(self):
        comb = self.doc.addObject("Part::Feature", "Comb")
        comb.Shape = Part.makeCompound([Part.makeBox(1, 40, 40, V(3 * k, 0, 0)) for k in range(30)])
        places = [turn(0.004 * k, V(0, 0, 1), V(0, 0, 2e-4 * k)) for k in range(3000)]
        path = motion.motion_from_poses(self.doc, [0.01 * k for k in range(3000)], places)
        path.Interpolation = "None"  # with interpolation, steps are merged and no filter is named
        obj = self.envelope([comb], path, Resolution=64)
        plan, kept = envelope.Plan.of(obj), contents.KeptBodies()
        find = plan.closer_estimate(kept.read)
        found = find(core.Control())
        envelope.compute(obj)
        report = envelope.json.loads(obj.Report)
        self.assertEqual(found["grid"], report["grid"])
        self.assertAlmostEqual(found["cell"], obj.UsedCellSize.Value, delta=1e-6)
        self.assertGreater(found["useful_filter"], 0)
        stop = core.Control()
        stop.cancel()
        with self.assertRaisesRegex(core.CoreError, "ancel"):
            find(stop)

        pairs = [(comb, "")]
        first = kept.read(pairs, 1.0)
        self.assertIs(kept.read(pairs, 1.0), first)
        comb.Placement.Base.x = 5
        moved = kept.read(pairs, 1.0)
        self.assertAlmostEqual(moved.vertices[:, 0].min(), first.vertices[:, 0].min() + 5)
