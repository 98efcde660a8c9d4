# SPDX-License-Identifier: LGPL-2.1-or-later
"""Geometry from and to FreeCAD: meshes, solids, and placements through groups and links."""
import threading
import time

import FreeCAD as App
import numpy as np
import Part

from case import Case, V, shift, turn
from sweptvolume import contents, convert, core
from sweptvolume.convert import InputProblem

TETRA = (
    np.array([(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1.5)], dtype=float),
    np.array([(0, 2, 1), (0, 1, 3), (1, 2, 3), (0, 3, 2)]),
)


class Convert(Case):
    def world_box(self, root, sub):
        body = convert.body_from([(root, sub)], 0.1)
        return np.vstack([body.vertices.min(axis=0), body.vertices.max(axis=0)])

    def assert_box(self, root, sub, low, high):
        found = self.world_box(root, sub)
        self.assertTrue(np.allclose(found, [low, high], atol=1e-5), "{} {}".format(sub, found))

    def test_mesh_round_trip_keeps_order(self):
        mesh = convert.mesh_from_arrays(*TETRA)
        mesh.Placement = turn(30)
        points, facets = convert.arrays_from_mesh(mesh)
        self.assertTrue(np.array_equal(points, TETRA[0]))
        self.assertTrue(np.array_equal(facets, TETRA[1]))
        self.assert_placement(mesh.Placement, turn(30))

    def test_mesh_made_beside_the_window_is_the_same(self):
        if not core.available():
            self.skipTest("the compiled core _swept is not built")
        plain, beside = (convert.mesh_from_arrays(*TETRA, beside=b) for b in (False, True))
        self.assertEqual(plain.Topology, beside.Topology)
        self.assertTrue(beside.isSolid())
        for a, b in zip(plain.Facets, beside.Facets):
            self.assertEqual(a.NeighbourIndices, b.NeighbourIndices)

    def test_poses_round_trip(self):
        places = [turn(77, V(1, 2, 3), V(4, 5, 6)), App.Placement()]
        back = convert.placements_from(*convert.pose_arrays(places))
        for a, b in zip(places, back):
            self.assert_placement(a, b)

    def test_part_in_group_and_links(self):
        box, group = self.box(), self.doc.addObject("App::Part", "Group")
        box.Placement, group.Placement = shift(5), shift(0, 7)
        group.addObject(box)
        link = self.doc.addObject("App::Link", "Link")
        link.LinkedObject, link.Placement = group, turn(90, V(0, 0, 1), V(0, 0, 100))
        inner = self.doc.addObject("App::Link", "Scaled")
        inner.LinkedObject, inner.Placement = box, shift(0, 0, 50)
        inner.ScaleVector = V(2, 2, 2)
        self.doc.recompute()
        self.assert_box(group, "Box.", (5, 7, 0), (15, 17, 10))
        self.assert_box(link, "Box.", (-10, 5, 100), (0, 15, 110))
        self.assert_box(inner, "", (0, 0, 50), (20, 20, 70))
        self.assert_box(*convert.root_path(box), (5, 7, 0), (15, 17, 10))
        for root, sub in ((group, "Box."), (link, "Box."), (inner, "")):
            box_ = Part.getShape(root, sub, needSubElement=False).BoundBox
            found = self.world_box(root, sub)
            self.assertAlmostEqual(box_.XMin, found[0][0], 5)
            self.assertAlmostEqual(box_.ZMax, found[1][2], 5)

    def test_link_array_element(self):
        array = self.doc.addObject("App::Link", "Array")
        array.LinkedObject, array.ElementCount = self.box(), 3
        self.doc.recompute()
        array.ElementList[1].Placement = shift(77)
        self.doc.recompute()
        self.assert_box(array, "1.", (77, 0, 0), (87, 10, 10))

    def test_mesh_inside_group(self):
        feature, group = self.doc.addObject("Mesh::Feature", "M"), self.doc.addObject(
            "App::Part", "G"
        )
        feature.Mesh = convert.mesh_from_arrays(*TETRA)
        feature.Placement, group.Placement = shift(2), shift(0, 0, 10)
        group.addObject(feature)
        self.doc.recompute()
        self.assert_box(group, "M.", (2, 0, 10), (3, 1, 11.5))

    def test_whole_group_without_hidden_inputs(self):
        group, seen, hidden = self.doc.addObject("App::Part", "G"), self.box("A"), self.box("B", 50)
        group.addObjects([seen, hidden])
        hidden.Visibility = False
        self.doc.recompute()
        self.assert_box(group, "", (0, 0, 0), (10, 10, 10))

    def test_python_goes_on_while_a_part_is_meshed(self):
        if not (core.available() and core.has_solids()):
            self.skipTest("the core was built without OpenCASCADE")
        holes = [
            Part.makeCylinder(1, 4, App.Vector(3 + 5 * (k % 10), 3 + 5 * (k // 10), 0))
            for k in range(100)
        ]
        plate = self.doc.addObject("Part::Feature", "Plate")
        plate.Shape = Part.makeBox(55, 55, 4).cut(Part.makeCompound(holes))
        read, begin, found = convert.reader(plate, 0.01), threading.Event(), []

        def work():
            begin.wait()
            found.append(read())

        thread = threading.Thread(target=work)
        thread.start()
        longest, began = 0.0, time.perf_counter()
        last = began
        begin.set()
        while not found:
            time.sleep(0.002)
            now = time.perf_counter()
            longest, last = max(longest, now - last), now
        thread.join()
        self.assertLess(longest, 0.5 * (last - began))
        self.assertEqual(found[0][2].max() + 1, len(plate.Shape.Faces))

    def test_faces_beside_a_solid_are_meshed_as_well(self):
        box, loose = Part.makeBox(2, 2, 2), Part.makePlane(1, 1, App.Vector(5, 0, 0))
        part = self.doc.addObject("Part::Feature", "Part")
        part.Shape = Part.makeCompound([box, loose])
        self.assertEqual(len(convert.reader(part, 0.1)()[1]), 12 + 2)

    def test_deflection_is_kept(self):
        ball = self.doc.addObject("Part::Sphere", "Ball")
        ball.Radius = 20
        self.doc.recompute()
        fine = convert.reader(ball, 0.02)()
        coarse = convert.reader(ball, 1.0)()
        self.assertGreater(len(fine[1]), 5 * len(coarse[1]))
        for points, facets, faces in (fine, coarse):
            self.assertEqual(set(faces), {0})
            self.assertEqual(len(faces), len(facets))
            middle = points[facets].mean(axis=1)
            gap = 20.0 - np.linalg.norm(middle, axis=1).min()
            # The mesher keeps the deflection on edges; in the middle of a face, the deviation may be
            # twice as large.
            self.assertLess(gap, 2 * (0.02 if points is fine[0] else 1.0))

    def test_triangles_are_those_of_when_the_part_was_read(self):
        body = convert.body_from([(self.box("A"), "")], 0.1)
        self.doc.A.Length = 99
        self.doc.A.Placement.Base.x = 50
        self.doc.recompute()
        made = []
        beside = threading.Thread(target=lambda: made.append(body.vertices.max(axis=0)))
        beside.start()
        beside.join()
        self.assertEqual(made[0].tolist(), [10, 10, 10])

    def test_open_shape_is_refused_with_advice(self):
        plane = self.doc.addObject("Part::Plane", "Sheet")
        self.doc.recompute()
        with self.assertRaisesRegex(InputProblem, '"Sheet": .*no solid'):
            convert.body_from([(plane, "")], 0.1)

    def test_lost_path_is_named(self):
        group, box = self.doc.addObject("App::Part", "Group"), self.box()
        group.addObject(box)
        self.doc.recompute()
        self.doc.removeObject("Box")
        with self.assertRaisesRegex(InputProblem, "Group.Box"):
            convert.leaves(group, "Box.")

    def test_signature_sees_place_and_shape(self):
        box = self.box()
        self.doc.recompute()
        first = contents.signature([(box, "")])
        box.Placement = shift(1e-3)
        moved = contents.signature([(box, "")])
        box.Placement = shift(0)
        self.assertEqual(first, contents.signature([(box, "")]))
        box.Length = 11
        self.doc.recompute()
        grown = contents.signature([(box, "")])
        self.assertEqual(len({first, moved, grown}), 3)
