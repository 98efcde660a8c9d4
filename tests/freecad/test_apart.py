# SPDX-License-Identifier: LGPL-2.1-or-later
"""Copies of shapes for other threads: they equal the originals, and drawing in FreeCAD does not change them.
"""
import threading
import time
from unittest import mock

import FreeCAD as App
import numpy as np
import Part

from case import Case, V, turn
from sweptvolume import apart, convert
from sweptvolume.convert import InputProblem


def plate(holes):
    """Returns a solid with holes x holes + 6 faces."""
    side = 10.0 * holes
    outer = Part.makePolygon([V(), V(side), V(side, side), V(0, side), V()])
    places = [V(10 * i + 5, 10 * j + 5) for i in range(holes) for j in range(holes)]
    wires = [Part.Wire(outer)] + [Part.Wire(Part.makeCircle(3, place)) for place in places]
    return Part.Face(wires, "Part::FaceMakerBullseye").extrude(V(0, 0, 5))


def spline_solid():
    bent = Part.BSplineCurve()
    bent.interpolate([V(0, 0), V(12.7 / 128, 3), V(5, 7.3), V(9, 1)])
    wire = Part.Wire([bent.toShape(), Part.makeLine(V(9, 1), V())])
    return Part.Face(wire).revolve(V(0, -2), V(1, 0.2), 200)


class Apart(Case):
    def known(self, shape):
        obj = self.doc.addObject("Part::Feature", "P")
        obj.Shape, obj.Placement = shape, turn(33, V(1, 2, 3), V(4, 5, 6))
        return obj, apart.Apart(obj)

    def test_a_shape_that_is_handed_over_reads_the_same(self):
        cut = Part.makeBox(25.4, 25.4 / 128, 9).cut(Part.makeSphere(7))
        shapes = {
            "holes": plate(5),
            "torus": Part.makeTorus(10, 3, V(), V(1, 1, 0)),
            "spline": spline_solid(),
            "cut": cut,
            "two": Part.makeCompound([cut, Part.makeCone(4, 0, 9)]),
        }
        for name, shape in shapes.items():
            with self.subTest(name):
                obj, plain = self.known(shape)
                obj.Shape.tessellate(0.5)  # as FreeCAD draws it
                given = apart.Apart(obj).detached()
                self.assertEqual(given.text(), plain.text())
                self.assertTrue(np.array_equal(given.corners(), plain.corners()))
                self.assertEqual(len(given.copy().Faces), len(shape.Faces))
                self.assertAlmostEqual(given.copy().Volume, shape.Volume, delta=1e-9 * shape.Volume)
                self.assertTrue(given.copy().Placement.isIdentity())

    def test_what_is_handed_over_shares_nothing_that_is_drawn_into(self):
        obj, _ = self.known(Part.makeTorus(10, 3, V(), V(1, 1, 0)))
        obj.Placement = App.Placement()
        given = apart.Apart(obj).detached()
        obj.Shape.tessellate(2)
        own = given.copy()
        rough = abs(obj.Shape.BoundBox.DiagonalLength - own.BoundBox.DiagonalLength)
        self.assertGreater(
            rough, 0.01, "the box of what was drawn is no longer that of its triangles"
        )
        self.assertFalse(own.isPartner(obj.Shape))
        self.assertFalse(any(a.isPartner(b) for a, b in zip(own.Edges, obj.Shape.Edges)))

    def test_the_windows_thread_is_held_up_far_less_than_by_a_copy(self):
        obj, _ = self.known(plate(30))

        def took(act):
            return min(self.spent(act) for _ in range(3))

        copied = took(lambda: obj.Shape.copy(False, False))
        self.assertLess(took(lambda: apart.Apart(obj).detached()), 0.6 * copied)

    @staticmethod
    def spent(act):
        began = time.thread_time()
        act()
        return time.thread_time() - began

    def test_a_full_temporary_folder_is_named(self):
        obj, _ = self.known(Part.makeBox(1, 2, 3))
        whole = apart.Apart(obj).detached()._taken
        for kept in (0, len(whole) // 3, len(whole) - 1):
            with mock.patch.object(apart, "_bytes_of", lambda shape: whole[:kept]):
                given = apart.Apart(obj).detached()
            with self.assertRaisesRegex(InputProblem, "The temporary folder .* is full"):
                given.text()

    def test_many_threads_get_one_shape(self):
        obj, _ = self.known(plate(4))
        given, found = apart.Apart(obj).detached(), []
        threads = [threading.Thread(target=lambda: found.append(given.copy())) for _ in range(8)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        self.assertEqual(len(found), 8)
        self.assertTrue(all(shape.isSame(found[0]) for shape in found))

    def test_an_empty_shape_is_told(self):
        obj = self.doc.addObject("Part::Feature", "Empty")
        given = apart.Apart(obj).detached()
        self.assertTrue(given.copy().isNull())
        self.assertIsNone(given.corners())
        with self.assertRaises(InputProblem):
            convert.reader(obj, 0.1)
