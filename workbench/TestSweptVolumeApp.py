# SPDX-License-Identifier: LGPL-2.1-or-later
"""Entry for FreeCAD's own test framework: freecadcmd -c -M DIR -t TestSweptVolumeApp."""
import os
import sys
import unittest

import sweptvolume

_FOLDER = os.path.join(sweptvolume.ROOT, "tests", "freecad")


def load_tests(loader, standard_tests, pattern):
    """Returns the tests of tests/freecad, or none if the module was installed without them."""
    suite = unittest.TestSuite()
    if not os.path.isdir(_FOLDER):
        print("SweptVolume: {} is not installed, no tests to run".format(_FOLDER))
        return suite
    if _FOLDER not in sys.path:
        sys.path.insert(0, _FOLDER)
    for name in sorted(os.listdir(_FOLDER)):
        if name.startswith("test_") and name.endswith(".py") and name != "test_gui.py":
            suite.addTests(loader.loadTestsFromName(name[:-3]))
    return suite
