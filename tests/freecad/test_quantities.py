# SPDX-License-Identifier: LGPL-2.1-or-later
"""Numbers as users read them, in every unit system of FreeCAD."""
import unittest

import FreeCAD as App

from sweptvolume import quantities

SYSTEMS = {0: "mm", 3: "in", 4: "cm", 6: "mm", 8: "mm"}


class Quantities(unittest.TestCase):
    def setUp(self):
        self.schema = App.ParamGet("User parameter:BaseApp/Preferences/Units").GetInt(
            "UserSchema", 0
        )

    def tearDown(self):
        App.Units.setSchema(self.schema)

    def test_digits_that_count_and_separators(self):
        for value, text in (
            (0, "0"),
            (0.0039370, "0.00394"),
            (1234567.8, "1,234,568"),
            (-12.3456, "-12.3"),
            (100, "100"),
            (1e-14, "1e-14"),
        ):
            self.assertEqual(quantities.number(value).replace("\u00a0", ","), text)

    def test_small_lengths_are_never_zero_in_any_system(self):
        for schema, name in SYSTEMS.items():
            App.Units.setSchema(schema)
            one, unit = quantities.length_unit()
            self.assertEqual(unit, name)
            text = quantities.quantity(0.1)
            back = App.Units.Quantity(text).Value
            self.assertAlmostEqual(back, 0.1, delta=0.0005, msg=text)
            self.assertAlmostEqual(App.Units.Quantity("1 " + unit).Value, one)

    def test_rounding_is_no_distance(self):
        App.Units.setSchema(0)
        self.assertEqual(quantities.quantity(6.6e-16), "0 mm")
        self.assertEqual(quantities.quantity(-6.6e-16), "0 mm")
        self.assertNotEqual(quantities.quantity(1e-6), "0 mm")

    def test_volume_is_the_cube_of_the_length(self):
        App.Units.setSchema(3)
        self.assertEqual(quantities.volume(25.4**3), "1 in^3")

    def test_durations(self):
        self.assertEqual(quantities.seconds(0.001), "0.1 s")
        self.assertEqual(quantities.seconds(87.3), "87 s")
        self.assertEqual(quantities.seconds(600), "10 min")


class Background(unittest.TestCase):
    """Text in the 3D view is legible on the background of every theme."""

    def test_light_and_dark(self):
        from sweptvolume.views.live_distance import on_light

        view = App.ParamGet("User parameter:BaseApp/Preferences/View")
        try:
            self.assertFalse(on_light())  # FreeCAD's own gradient of blue
            for colour, light in ((0xF7F7F7FF, True), (0x212529FF, False), (0x000000FF, False)):
                view.SetBool("Simple", True)
                view.SetUnsigned("BackgroundColor", colour)
                self.assertEqual(on_light(), light, hex(colour))
        finally:
            view.RemBool("Simple")
            view.RemUnsigned("BackgroundColor")
