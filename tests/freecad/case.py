# SPDX-License-Identifier: LGPL-2.1-or-later
"""Shared by the FreeCAD tests without a window: a fresh document for each test, small bodies and motions."""
import os
import tempfile
import unittest

import FreeCAD as App
import Part

from sweptvolume import core
from sweptvolume.features import envelope, motion

V = App.Vector
SHARED = os.path.join(
    os.path.dirname(os.path.dirname(os.path.dirname(os.path.realpath(__file__)))),
    "..",
    "shared",
    "data",
)


def shift(x=0.0, y=0.0, z=0.0):
    return App.Placement(V(x, y, z), App.Rotation())


def turn(degrees, axis=V(0, 0, 1), base=V(0, 0, 0)):
    return App.Placement(base, App.Rotation(axis, degrees))


class Case(unittest.TestCase):
    """A new document with undo for each test; `folder` is removed afterwards."""

    NEEDS_CORE = False

    def setUp(self):
        if self.NEEDS_CORE and not core.available():
            self.skipTest("the compiled core _swept is not built")
        self.doc = App.newDocument("SweptTest")
        self.doc.UndoMode = 1
        self._folder = tempfile.TemporaryDirectory()
        self.folder = self._folder.name

    def tearDown(self):
        for name in list(App.listDocuments()):
            App.closeDocument(name)
        self._folder.cleanup()

    def box(self, name="Box", size=10.0):
        obj = self.doc.addObject("Part::Box", name)
        obj.Length = obj.Width = obj.Height = size
        return obj

    def straight_wire(self):
        """Returns a wire of 20 mm along x."""
        obj = self.doc.addObject("Part::Feature", "Wire")
        obj.Shape = Part.makeLine(V(), V(20, 0, 0))
        return obj

    def sheet(self, alias, value):
        """Returns a spreadsheet with one value, which expressions call Values.alias."""
        obj = self.doc.addObject("Spreadsheet::Sheet", "Values")
        obj.set("A1", value)
        obj.setAlias("A1", alias)
        return obj

    def line(self, length=30.0):
        """Returns a straight motion along x."""
        return motion.motion_from_poses(self.doc, [0, 1], [shift(), shift(length)])

    def envelope(self, parts, path, **settings):
        settings.setdefault("Resolution", 40)
        obj = envelope.make_envelope(self.doc, parts, path, **settings)
        self.doc.recompute()
        return obj

    def grouped_envelope(self):
        """Returns a group with a box and its motion, and the computed envelope of the box."""
        group, box = self.doc.addObject("App::Part", "G"), self.box()
        group.addObject(box)
        path = self.line()
        path.PoseType = "Relative"
        obj = self.envelope([box], path)
        envelope.compute(obj)
        return group, obj

    def reopen(self):
        """Saves, closes and opens the document again. References to its objects must be fetched again."""
        path = os.path.join(self.folder, "saved.FCStd")
        self.doc.saveAs(path)
        App.closeDocument(self.doc.Name)
        self.doc = App.openDocument(path)

    def file(self, name, text):
        path = os.path.join(self.folder, name)
        with open(path, "w", encoding="utf-8") as out:
            out.write(text)
        return path

    def assert_placement(self, a, b, tolerance=1e-9):
        difference = max(abs(x - y) for x, y in zip(a.toMatrix().A, b.toMatrix().A))
        self.assertLessEqual(difference, tolerance, "{} != {}".format(a, b))
