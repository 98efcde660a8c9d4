# SPDX-License-Identifier: LGPL-2.1-or-later
"""Clearance checks in a document without a window."""
import csv
import os

import FreeCAD as App
import Mesh

from case import shift
from neighbour_case import Neighbours
from sweptvolume.convert import InputProblem
from sweptvolume.features import clearance, clearance_table, envelope


class Clearance(Neighbours):
    def rows(self, obj):
        return {row["name"]: row for row in clearance.report_of(obj)["neighbours"]}

    def test_all_visible_others(self):
        obj = self.made(RequiredDistance=4.0)
        self.assertEqual(obj.Status, clearance.NOT_COMPUTED)
        clearance.compute(obj)
        self.assertEqual(obj.Status, clearance.UP_TO_DATE)
        rows = self.rows(obj)
        self.assertEqual(sorted(rows), ["Far", "Wall"])
        self.assertAlmostEqual(rows["Wall"]["distance"], 3.5, places=6)
        self.assertAlmostEqual(rows["Wall"]["time_seconds"], 1.0, places=4)
        self.assertEqual(rows["Wall"]["verdict"], "below")
        self.assertAlmostEqual(rows["Far"]["distance"], 15.0, places=6)
        self.assertEqual(rows["Far"]["verdict"], "clear")
        # Both solids are meshed with a deflection of 0.05 mm. This, and the accuracy, are subtracted.
        self.assertAlmostEqual(rows["Wall"]["guaranteed"], 3.5 - 0.1 - 0.01, places=6)
        self.assertTrue(
            obj.Summary.startswith(
                "2 checked, 1 below required, smallest distance 3.5 mm "
                "(guaranteed: 3.39 mm) at t = 1 s (Wall)"
            ),
            obj.Summary,
        )

    def test_parts_that_others_use_are_neighbours_too(self):
        # An expression, an envelope and a link refer to `far`. It is still a neighbour.
        self.far.setExpression("Placement.Base.z", "Wall.Height - 10 mm")
        envelope.make_envelope(self.doc, [self.far], self.path)
        link = self.doc.addObject("App::Link", "Copy")
        link.LinkedObject = self.wall
        link.Placement = shift(x=80)
        array = self.doc.addObject("App::Link", "Row")
        array.LinkedObject, array.ElementCount = self.far, 2
        for k, element in enumerate(array.ElementList):
            element.Placement = shift(y=60 + 20 * k)
        group = self.doc.addObject("App::Part", "Group")
        group.addObject(self.box("Inner"))
        group.Placement = shift(z=-60)
        obj = self.made()
        clearance.compute(obj)
        names = [row["name"] for row in clearance.report_of(obj)["neighbours"]]
        self.assertTrue({"Copy", "Far", "Inner", "Wall"}.issubset(names), names)
        self.assertEqual(len(names), 6, names)  # also the two elements of the row, each once

    def test_hidden_parts_are_left_out_and_chosen_ones_taken(self):
        self.far.Visibility = False
        obj = self.made()
        clearance.compute(obj)
        self.assertEqual(list(self.rows(obj)), ["Wall"])
        chosen = self.made(AllVisible=False, Neighbours=[(self.far, "")])
        clearance.compute(chosen)
        self.assertEqual(list(self.rows(chosen)), ["Far"])

    def test_clash_is_measured(self):
        self.wall.Placement = shift(x=36)
        obj = self.made()
        clearance.compute(obj)
        row = self.rows(obj)["Wall"]
        self.assertEqual(row["verdict"], "clash")
        self.assertAlmostEqual(row["penetration"]["depth"], 4.0, delta=0.05)
        self.assertAlmostEqual(row["contact"][0][0], 26 / 30.0, delta=0.01)

    def test_stale_and_current_again(self):
        obj = self.made()
        clearance.compute(obj)
        self.wall.Placement = shift(x=50)
        self.doc.recompute()
        self.assertEqual(obj.Status, clearance.STALE)
        self.wall.Placement = shift(x=43.5)
        self.doc.recompute()
        self.assertEqual(obj.Status, clearance.UP_TO_DATE)

    def test_of_an_envelope_with_its_colours(self):
        swept = self.envelope([self.part], self.path, Resolution=20)
        envelope.compute(swept)
        obj = clearance.make_clearance(self.doc, Envelope=swept)
        self.doc.recompute()
        clearance.compute(obj)
        self.assertEqual(sorted(self.rows(obj)), ["Far", "Wall"])  # the envelope is no neighbour
        self.assertEqual(len(obj.MapDistances), swept.Mesh.CountPoints)
        self.assertAlmostEqual(min(obj.MapDistances), 3.5, delta=0.2)

    def test_kept_in_the_file(self):
        obj = self.made()
        clearance.compute(obj)
        summary = obj.Summary
        self.reopen()
        again = self.doc.getObject("Clearance")
        self.assertEqual((again.Summary, again.Status), (summary, clearance.UP_TO_DATE))
        self.assertEqual(len(self.rows(again)), 2)

    def test_a_table_never_replaces_what_a_document_reads(self):
        obj = self.made()
        clearance.compute(obj)
        path, link = (os.path.join(self.folder, name) for name in ("way.csv", "link.csv"))
        with open(path, "w", encoding="utf-8") as file:
            file.write("0,0,0,0,0,0,0,1\n")
        os.symlink(path, link)
        obj.Motion.SourceFile = path
        with open(path, "rb") as file:
            before = file.read()
        for target in (path, link):
            with self.assertRaises(InputProblem) as caught:
                clearance_table.write_csv(clearance.report_of(obj), target)
            self.assertIn(obj.Motion.Label, str(caught.exception))
        with open(path, "rb") as file:
            self.assertEqual(file.read(), before)
        self.doc.saveAs(os.path.join(self.folder, "kept.FCStd"))
        with self.assertRaises(InputProblem):
            clearance_table.write_csv(clearance.report_of(obj), self.doc.FileName)
        obj.Motion.SourceFile = ""
        clearance_table.write_csv(clearance.report_of(obj), path)
        with open(path, "rb") as file:
            self.assertNotEqual(file.read(), before)

    def test_table_and_spreadsheet(self):
        obj = self.made()
        clearance.compute(obj)
        path = os.path.join(self.folder, "table.csv")
        clearance_table.write_csv(clearance.report_of(obj), path)
        with open(path, encoding="utf-8") as file:
            rows = list(csv.reader(file))
        self.assertEqual(rows[0], clearance_table.columns())
        self.assertEqual(rows[0][2], "Distance (mm)")
        self.assertEqual(len(rows), 3)
        sheet = clearance_table.make_spreadsheet(obj, clearance.report_of(obj))
        self.doc.recompute()
        self.assertEqual(sheet.get("A1"), "Neighbour")
        self.assertAlmostEqual(float(sheet.get("C2")), float(rows[1][2]), places=6)
        App.Units.setSchema(3)  # inches
        try:
            inches = clearance_table.table(clearance.report_of(obj))
            self.assertEqual(clearance_table.columns()[2], "Distance (in)")
            text = clearance_table.summary(clearance.report_of(obj))
            self.assertIn("smallest distance 0.1378 in (guaranteed: 0.1335 in) at t = 1 s", text)
        finally:
            App.Units.setSchema(0)
        self.assertAlmostEqual(inches[0][2] * 25.4, float(rows[1][2]))
        self.assertEqual(inches[0][4], float(rows[1][4]))  # seconds stay what they are

    def test_a_neighbour_that_is_open_is_named(self):
        bowl = self.doc.addObject("Mesh::Feature", "Bowl")
        bowl.Mesh = Mesh.createBox(10, 10, 10)
        bowl.Mesh = Mesh.Mesh((bowl.Mesh.Topology[0], bowl.Mesh.Topology[1][:-2]))
        bowl.Label, bowl.Placement = "Open bowl", shift(y=-60)
        obj = self.made()
        clearance.compute(obj)
        self.assertIn(
            "1 neighbour is open or has wrongly oriented triangles (Open bowl)", obj.Message
        )
        bowl.Label = "Bowl of tin"
        net = self.doc.addObject("Mesh::Feature", "Net")
        net.Mesh, net.Placement = bowl.Mesh, shift(y=60)
        clearance.compute(obj)
        self.assertIn(
            "2 neighbours are open or have wrongly oriented triangles (Bowl of tin, Net)",
            obj.Message,
        )

    def test_no_neighbour_is_named(self):
        self.wall.Visibility = self.far.Visibility = False
        obj = self.made()
        with self.assertRaises(InputProblem):
            clearance.compute(obj)
        self.assertEqual(obj.Status, clearance.FAILED)
        self.assertIn("neighbour", obj.Message)
