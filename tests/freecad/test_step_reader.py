# SPDX-License-Identifier: LGPL-2.1-or-later
"""Parts in STEP and BREP files: FreeCAD reads them for a core without OpenCASCADE."""
import os
import unittest
from unittest import mock

import FreeCAD as App
import numpy as np
import Part

from case import Case
from sweptvolume import core, studies
from sweptvolume.body import InputProblem
from sweptvolume.features import step_reader
from sweptvolume.features.study_import import Taken

STUDY = """
[[run]]
name = "one"
part = "part.step"
motion = "motion.csv"
neighbours = ["two.brep"]
compute = ["clearance"]
"""


def volume(vertices, triangles):
    a, b, c = (np.asarray(vertices)[np.asarray(triangles)[:, k]] for k in range(3))
    return np.einsum("ij,ij->", a, np.cross(b, c)) / 6


class StepReader(Case):
    NEEDS_CORE = True

    def setUp(self):
        super().setUp()
        box = Part.makeBox(10, 20, 30)
        self.shape = box.cut(Part.makeCylinder(3, 30, App.Vector(5, 10, 0)))
        self.path = os.path.join(self.folder, "part.step")
        self.shape.exportStep(self.path)
        other = box.copy()
        other.translate(App.Vector(50, 0, 0))
        self.two = os.path.join(self.folder, "two.brep")
        Part.makeCompound([box, other]).exportBrep(self.two)

    def test_a_solid_is_read_with_its_faces(self):
        ((name, vertices, triangles, faces),) = step_reader.solids(self.path, 0.01, 0.2)
        self.assertEqual(name, "part")
        self.assertAlmostEqual(volume(vertices, triangles), self.shape.Volume, delta=3)
        self.assertEqual(sorted(set(faces)), list(range(len(self.shape.Faces))))

    def test_solids_of_one_file_are_numbered_and_so_are_their_faces(self):
        found = step_reader.solids(self.two, 0.1, 0.2)
        self.assertEqual([name for name, *_ in found], ["two 1", "two 2"])
        self.assertEqual([sorted(set(f)) for *_, f in found], [list(range(6)), list(range(6, 12))])
        self.assertAlmostEqual(found[1][1][:, 0].min(), 50)

    def test_as_the_core_reads_it(self):
        if not core.has_solids():
            self.skipTest("the core was built without OpenCASCADE")
        read = core.module().read_body
        ours = read(self.path, tolerance=0.01)
        freecads = read(self.path, tolerance=0.01, reader=step_reader.solids)
        self.assertEqual(len(freecads.triangles), len(ours.triangles))
        self.assertAlmostEqual(
            volume(freecads.vertices, freecads.triangles),
            volume(ours.vertices, ours.triangles),
            delta=1e-4 * self.shape.Volume,
        )
        counts = [np.bincount(mesh.faces).tolist() for mesh in (ours, freecads)]
        self.assertEqual(*counts)

    def test_a_run_of_a_study_comes_into_the_document(self):
        self.file("motion.csv", "0,0,0,0,0,0,0,1\n1,3,0,0,0,0,0,1\n")
        (run,) = studies.read(self.file("study.toml", STUDY)).runs
        with mock.patch.object(core, "has_solids", return_value=False):
            taken = Taken(run)
        self.assertAlmostEqual(taken.mesh.Volume, self.shape.Volume, delta=30)
        self.assertEqual([name for name, _, _ in taken.parts], ["two 1", "two 2"])

    def test_a_file_that_is_no_solid_is_refused_by_name(self):
        path = self.file("broken.step", "ISO-10303-21;\nnothing\n")
        with self.assertRaisesRegex(InputProblem, "broken.step"):
            step_reader.solids(path, 0.1, 0.2)

    def test_only_a_core_without_opencascade_needs_it(self):
        for has, reader in ((True, None), (False, step_reader.solids)):
            with mock.patch.object(core, "has_solids", return_value=has):
                self.assertIs(step_reader.parts_reader(), reader)


if __name__ == "__main__":
    unittest.main()
