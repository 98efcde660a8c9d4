# SPDX-License-Identifier: LGPL-2.1-or-later
"""Shared by the tests of bad input: checks that a refusal changes nothing, and meshes that FreeCAD would
repair.
"""
import json

import Mesh
import numpy as np
import Part

from case import Case
from sweptvolume import core
from sweptvolume.convert import InputProblem, mesh_from_arrays
from sweptvolume.features import envelope


class BadCase(Case):
    NEEDS_CORE = True

    def refused(self, obj, *words):
        """Checks that the run fails with a message that contains these words, that the old mesh stays,
        and that the next run works."""
        facets = obj.Mesh.CountFacets
        with self.assertRaises((core.CoreError, InputProblem)) as caught:
            envelope.compute(obj)
        for word in words:
            self.assertIn(word, str(caught.exception))
        self.assertEqual(obj.Status, envelope.FAILED)
        self.assertEqual(obj.Message, str(caught.exception))
        self.assertEqual(obj.Mesh.CountFacets, facets)

    def mesh_object(self, facets):
        obj = self.doc.addObject("Mesh::Feature", "Net")
        obj.Mesh = Mesh.Mesh(facets)
        return obj

    def box_facets(self):
        points, triangles = Part.makeBox(10, 10, 10).tessellate(1.0)
        return [[tuple(points[i]) for i in triangle] for triangle in triangles]

    def box_arrays(self, size=10.0):
        """Returns the vertices (8, 3) and triangles (12, 3) of a box, outward."""
        corners = [(x, y, z) for x in (0, size) for y in (0, size) for z in (0, size)]
        quads = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]
        triangles = [t for a, b, c, d in quads for t in ((a, b, c), (a, c, d))]
        return np.array(corners, float), np.array(triangles)

    def net(self, vertices, triangles):
        """Returns a mesh object with exactly these arrays: FreeCAD joins and repairs nothing."""
        obj = self.doc.addObject("Mesh::Feature", "Net")
        obj.Mesh = mesh_from_arrays(np.asarray(vertices, float), np.asarray(triangles))
        return obj

    def accepted(self, part, path, *codes, **settings):
        """Checks that the run ends with a closed mesh and with these findings in its report."""
        obj = self.envelope([part], path, **settings)
        envelope.compute(obj)
        self.assertEqual(obj.Status, envelope.UP_TO_DATE)
        self.assertTrue(obj.Mesh.isSolid())
        found = {warning["code"] for warning in json.loads(obj.Report)["warnings"]}
        self.assertLessEqual(set(codes), found)
        return obj
