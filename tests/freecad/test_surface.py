# SPDX-License-Identifier: LGPL-2.1-or-later
"""The arrays that are drawn in the 3D view (by the library Coin)."""
import unittest

import numpy as np

from sweptvolume.views import surface

try:
    from pivy import coin
except ImportError as error:
    coin, REASON = None, str(error)
else:
    REASON = ""


@unittest.skipIf(coin is None, "pivy cannot be imported: " + REASON)
class Fill(unittest.TestCase):
    def test_points_numbers_and_matrices_arrive(self):
        points = np.arange(30, dtype=np.float32).reshape(10, 3) / 7
        where = coin.SoCoordinate3()
        surface.fill(where.point, points)
        found = np.array([p.getValue() for p in where.point.getValues()], np.float32)
        self.assertTrue(np.array_equal(found, points))
        numbers = np.array([3, -1, 70000, -(2**31)], np.int32)
        faces = coin.SoIndexedFaceSet()
        surface.fill(faces.coordIndex, numbers)
        self.assertEqual(list(faces.coordIndex.getValues()), numbers.tolist())
        matrices = np.arange(32, dtype=np.float32).reshape(2, 16)
        copies = coin.SoMultipleCopy()
        surface.fill(copies.matrix, matrices)
        found = np.array([copies.matrix[i].getValue() for i in range(2)], np.float32)
        self.assertTrue(np.array_equal(found.reshape(2, 16), matrices))

    def test_a_field_takes_the_new_length(self):
        where = coin.SoCoordinate3()
        for count in (5, 2, 0, 3):
            surface.fill(where.point, np.ones((count, 3), np.float32))
            self.assertEqual(where.point.getNum(), count)

    def test_rows_that_lie_apart_are_taken(self):
        wide = np.arange(24, dtype=np.float32).reshape(4, 6)
        where = coin.SoCoordinate3()
        surface.fill(where.point, wide[:, :3])
        self.assertEqual(where.point[3].getValue(), (18.0, 19.0, 20.0))

    def test_other_kinds_of_numbers_are_refused(self):
        where, faces = coin.SoCoordinate3(), coin.SoIndexedFaceSet()
        for field, values in (
            (where.point, np.ones((2, 3))),
            (where.point, np.ones((2, 4), np.float32)),
            (faces.coordIndex, np.ones(4, np.int64)),
        ):
            with self.assertRaises(TypeError):
                surface.fill(field, values)
