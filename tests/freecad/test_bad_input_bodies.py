# SPDX-License-Identifier: LGPL-2.1-or-later
"""The rows of docs/bad_input.md about meshes and solids that a user of FreeCAD can reach."""
import json

import numpy as np
import Part

from bad_case import BadCase
from case import V, shift
from sweptvolume.features import envelope, motion


class BadBodies(BadCase):
    def still(self):
        return motion.motion_from_poses(self.doc, [0], [shift()])

    def test_bad_input_03_not_a_number(self):
        vertices, triangles = self.box_arrays()
        vertices[[2, 5], 1] = np.nan
        part = self.net(vertices, triangles)
        self.refused(self.envelope([part], self.line()), "2 vertices", "2, 5")

    def test_bad_input_04_degenerate_triangles(self):
        vertices, triangles = self.box_arrays()
        vertices = np.vstack([vertices, [[0, 0, 5]]])  # in the middle of an edge
        part = self.net(vertices, np.vstack([triangles, [[0, 8, 1]]]))
        self.accepted(part, self.line(), "DegenerateTriangles")
        line = self.net([[0, 0, 0], [1, 0, 0], [2, 0, 0]], [[0, 1, 2]])
        self.refused(self.envelope([line], self.line()), "without area", "choose a solid")

    def test_bad_input_05_soup(self):
        vertices, triangles = self.box_arrays()
        soup = self.net(vertices[triangles].reshape(-1, 3), np.arange(36).reshape(-1, 3))
        self.assertEqual(soup.Mesh.CountPoints, 36)
        self.accepted(soup, self.line(), "Welded")

    def test_bad_input_07_inward(self):
        vertices, triangles = self.box_arrays()
        obj = self.accepted(self.net(vertices, triangles[:, ::-1]), self.line(), "Flipped")
        self.assertGreater(obj.Mesh.Volume, 3900)

    def test_bad_input_08_mixed_orientation(self):
        vertices, triangles = self.box_arrays()
        triangles[[1, 6, 7]] = triangles[[1, 6, 7]][:, ::-1]
        self.accepted(self.net(vertices, triangles), self.line(), "MixedOrientation")

    def test_bad_input_09_non_manifold(self):
        vertices, triangles = self.box_arrays()
        two = np.vstack([vertices, vertices + [10, 10, 0]])  # the boxes share an edge
        part = self.net(two, np.vstack([triangles, triangles + 8]))
        up = motion.motion_from_poses(self.doc, [0, 1], [shift(), shift(0, 0, 20)])
        self.accepted(part, up, "NonManifoldEdges")

    def test_bad_input_10_overlap(self):
        vertices, triangles = self.box_arrays()
        two = np.vstack([vertices, vertices + 5]), np.vstack([triangles, triangles + 8])
        obj = self.accepted(self.net(*two), self.still())
        self.assertAlmostEqual(obj.Volume.Value, 2 * 1000 - 125, delta=40)

    def test_bad_input_12_cavity(self):
        part = self.doc.addObject("Part::Feature", "Hollow")
        part.Shape = Part.makeBox(10, 10, 10).cut(Part.makeSphere(3, V(5, 5, 5)))
        obj = self.accepted(part, self.still(), "Cavities")
        self.assertEqual(obj.Shells, 1)
        self.assertAlmostEqual(obj.Volume.Value, 1000, delta=20)
        obj.KeepCavities = True
        envelope.compute(obj)
        self.assertEqual(obj.Shells, 2)

    def test_bad_input_13_thin_wall(self):
        sheet = self.doc.addObject("Part::Box", "Sheet")
        sheet.Length, sheet.Width, sheet.Height = 20, 20, 0.02
        self.doc.recompute()
        obj = self.accepted(sheet, self.line())
        self.assertLess(obj.Volume.Value, 3 * 50 * 20 * obj.UsedCellSize.Value)

    def test_bad_input_14_far_away(self):
        def from_place(*place):
            ends = [shift(*place), shift(place[0] + 30, *place[1:])]
            return motion.motion_from_poses(self.doc, [0, 1], ends)

        obj = self.accepted(self.box(), from_place(1e6, -2e6, 3e6))
        self.assertAlmostEqual(obj.Volume.Value, 4000, delta=40)
        # In single precision, coordinates this far out are a quarter of a millimetre apart. So the mesh
        # has local coordinates.
        self.assertAlmostEqual(obj.Mesh.Volume, 4000, delta=40)
        self.assertAlmostEqual(obj.Mesh.BoundBox.YMin, -2e6, delta=1)
        obj.Motion = from_place(4e9, 0, 0)
        self.refused(obj, "1e9 mm", "check the unit")

    def test_bad_input_45_thinner_than_the_cell(self):
        wire = self.doc.addObject("Part::Box", "Wire")
        wire.Length, wire.Width, wire.Height = 1e-4, 1e-4, 40
        self.doc.recompute()
        obj = self.envelope([wire], self.still(), Resolution=16)
        try:
            envelope.compute(obj)
        except Exception as error:
            self.assertIn("smaller cell", str(error))
            self.assertEqual(obj.Status, envelope.FAILED)
        else:
            self.assertEqual(json.loads(obj.Report)["status"], "Ok")
            self.assertTrue(obj.Mesh.isSolid())
