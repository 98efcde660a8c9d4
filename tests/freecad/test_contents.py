# SPDX-License-Identifier: LGPL-2.1-or-later
"""The text that identifies the geometry of a part: it changes when the geometry changes, and only then."""
import time

import Mesh
import Part

from case import Case, V, shift, turn
from scene_case import plate
from sweptvolume import contents


class Contents(Case):
    def test_a_hole_that_moves(self):
        obj = self.doc.addObject("Part::Feature", "Plate")
        obj.Shape = plate(10)
        first = contents.signature([(obj, "")])
        obj.Shape = plate(30)
        self.assertNotEqual(contents.signature([(obj, "")]), first)
        obj.Shape = plate(10)
        self.assertEqual(contents.signature([(obj, "")]), first)

    def test_a_pole_that_moves_between_the_points_looked_at(self):
        poles = [[V(i, j, 0) for j in range(40)] for i in range(40)]
        knots = [list(range(38)), [4] + [1] * 36 + [4]]
        obj = self.doc.addObject("Part::Feature", "Sheet")

        def sheet(height):
            poles[17][30].z = height
            surface = Part.BSplineSurface()
            surface.buildFromPolesMultsKnots(
                poles, knots[1], knots[1], knots[0], knots[0], False, False, 3, 3
            )
            obj.Shape = surface.toShape().extrude(V(0, 0, 20))
            return contents.signature([(obj, "")])

        self.assertNotEqual(sheet(0.0), sheet(0.01))

    def test_meshed_placed_saved_it_is_the_same(self):
        obj = self.doc.addObject("Part::Feature", "Plate")
        obj.Shape = plate(10).fuse(Part.makeSphere(3, V(30, 10, 4))).fuse(Part.makeTorus(9, 1))
        net = self.doc.addObject("Mesh::Feature", "Net")
        net.Mesh = Mesh.createSphere(5.1, 20)
        first = contents.text_of(obj), contents.text_of(net)
        obj.Shape.tessellate(0.1)
        obj.Placement = net.Placement = turn(31, V(1, 2, 3), V(1000.1, 7, 0.3))
        self.assertEqual((contents.text_of(obj), contents.text_of(net)), first)
        self.reopen()
        obj, net = self.doc.getObject("Plate"), self.doc.getObject("Net")
        self.assertEqual((contents.text_of(obj), contents.text_of(net)), first)

    def test_a_mesh_that_changes_is_noticed_through_undo_too(self):
        net = self.doc.addObject("Mesh::Feature", "Net")
        net.Mesh = Mesh.createSphere(5, 20)
        first = contents.text_of(net)
        self.doc.openTransaction("Bend")
        points = net.Mesh.Topology[0]
        points[7] += V(0, 0, 0.001)
        net.Mesh = Mesh.Mesh((points, net.Mesh.Topology[1]))
        self.doc.commitTransaction()
        bent = contents.text_of(net)
        self.assertNotEqual(bent, first)
        self.doc.undo()
        self.assertEqual(contents.text_of(net), first)
        self.doc.redo()
        self.assertEqual(contents.text_of(net), bent)

    def test_a_shape_that_is_gone(self):
        obj = self.doc.addObject("Part::Feature", "Empty")
        text = contents.text_of(obj)
        self.assertIsNone(contents.apart.of(obj).corners())
        obj.Shape = plate(10)
        self.assertNotEqual(contents.text_of(obj), text)
        self.assertEqual(contents.apart.of(obj).corners().shape, (8, 3))
        obj.Shape = Part.Shape()
        self.assertEqual(contents.text_of(obj), text)

    def test_500_faces_are_cheap(self):
        holes = [
            Part.makeCylinder(1, 4, V(3 + 5 * (i % 25), 3 + 5 * (i // 25), 0)) for i in range(500)
        ]
        obj = self.doc.addObject("Part::Feature", "Sieve")
        obj.Shape = Part.makeBox(130, 110, 4).cut(Part.makeCompound(holes))
        self.assertGreater(len(obj.Shape.Faces), 500)
        contents.signature([(obj, "")])
        took = []
        for k in range(5):
            obj.Placement = shift(k)
            begin = time.perf_counter()
            contents.signature([(obj, "")])
            took.append(time.perf_counter() - begin)
        self.assertLess(min(took), 0.005)
