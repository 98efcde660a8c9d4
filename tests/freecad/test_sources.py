# SPDX-License-Identifier: LGPL-2.1-or-later
"""Each source of a motion on a real document of its kind; the path editor's operations."""
import math
import os

import FreeCAD as App
import Part

from case import Case, V, shift, turn
from sweptvolume.convert import InputProblem
from sweptvolume.features import motion
from sweptvolume.trajectory.edit import Keys, as_numbers, from_numbers, number_from


class Sources(Case):
    def test_wire_by_arc_length_with_tangent(self):
        wire = self.doc.addObject("Part::Feature", "Wire")
        arc = Part.Arc(
            V(10, 0, 0), V(10 + 5 * math.sqrt(0.5), 5 - 5 * math.sqrt(0.5), 0), V(15, 5, 0)
        )
        wire.Shape = Part.Wire([Part.makeLine(V(0, 0, 0), V(10, 0, 0)), arc.toShape()])
        obj = motion.motion_from_source(self.doc, "Curve", [wire], count=21, orientation="Tangent")
        places = obj.Placements
        length = 10 + 2.5 * math.pi
        self.assert_placement(places[5], shift(length / 4), 1e-9)
        self.assert_placement(places[-1], turn(90, base=V(15, 5, 0)), 1e-9)
        steps = [(a.Base - b.Base).Length for a, b in zip(places, places[1:])]
        self.assertLess(max(steps) - min(steps), 0.01)
        wire.Placement = shift(0, 0, 50)
        self.doc.recompute()
        self.assertAlmostEqual(obj.Placements[3].Base.z, 50)

    def test_wire_against_its_edges_direction(self):
        wire = self.doc.addObject("Part::Feature", "Wire")
        first = Part.makeLine(V(0, 0, 0), V(10, 0, 0))
        second = Part.makeLine(V(20, 0, 0), V(10, 0, 0))
        wire.Shape = Part.Wire([first, second])
        obj = motion.motion_from_source(self.doc, "Curve", [wire], count=5, orientation="Tangent")
        for i, place in enumerate(obj.Placements):
            self.assert_placement(place, shift(5 * i), 1e-9)

    def test_closed_circle_has_no_flips(self):
        ring = self.doc.addObject("Part::Circle", "Ring")
        ring.Radius = 10
        self.doc.recompute()
        obj = motion.motion_from_source(self.doc, "Curve", [ring], count=73, orientation="Tangent")
        for a, b in zip(obj.Placements, obj.Placements[1:]):
            self.assertAlmostEqual(
                math.degrees(a.Rotation.inverted().multiply(b.Rotation).Angle), 5, 6
            )

    def test_pieces_are_refused(self):
        wire = self.doc.addObject("Part::Feature", "Two")
        wire.Shape = Part.Compound(
            [Part.makeLine(V(), V(1, 0, 0)), Part.makeLine(V(5, 0, 0), V(6, 0, 0))]
        )
        with self.assertRaisesRegex(InputProblem, "2 separate pieces"):
            motion.motion_from_source(self.doc, "Curve", [wire])

    def test_sketch(self):
        sketch = self.doc.addObject("Sketcher::SketchObject", "Sketch")
        sketch.addGeometry(Part.LineSegment(V(0, 0, 0), V(0, 30, 0)))
        sketch.Placement = App.Placement(V(), App.Rotation(V(1, 0, 0), 90))
        self.doc.recompute()
        obj = motion.motion_from_source(self.doc, "Curve", [sketch], count=4)
        self.assert_placement(obj.Placements[-1], shift(0, 0, 30), 1e-9)

    def test_link_array(self):
        array = self.doc.addObject("App::Link", "Array")
        array.LinkedObject, array.ElementCount = self.box(), 3
        array.Placement = shift(0, 100)
        self.doc.recompute()
        array.ElementList[2].Placement = shift(7)
        obj = motion.motion_from_source(self.doc, "Array", [array], step=0.5)
        self.assertEqual(obj.Times, [0, 0.5, 1])
        self.assert_placement(obj.Placements[2], shift(7, 100))

    def test_robot_trajectory(self):
        try:
            import Robot
        except ImportError as error:
            self.skipTest("this FreeCAD has no Robot workbench ({})".format(error))
        track = self.doc.addObject("Robot::TrajectoryObject", "Track")
        path = track.Trajectory
        for x in (0, 100, 200):
            path.insertWaypoints(Robot.Waypoint(shift(x), type="LIN", name="P", vel=200.0))
        track.Trajectory = path
        obj = motion.motion_from_source(self.doc, "Robot", [track], count=9)
        self.assert_placement(obj.Placements[0], shift(), 1e-6)
        self.assert_placement(obj.Placements[-1], shift(200), 1e-3)
        xs = [p.Base.x for p in obj.Placements]
        self.assertEqual(xs, sorted(xs))

    def test_cam_arcs(self):
        try:
            import Path
        except ImportError as error:
            self.skipTest("this FreeCAD has no CAM ({})".format(error))
        feature = self.doc.addObject("Path::Feature", "Cut")
        lines = ["G0 X10 Y0 Z5", "G1 Z0 F5", "G3 X-10 Y0 I-10 J0", "G1 X-20 A90"]
        feature.Path = Path.Path([Path.Command(line) for line in lines])
        obj = motion.motion_from_source(self.doc, "CAM", [feature])
        arc = [p.Base for p in obj.Placements if abs(p.Base.z) < 1e-9 and p.Base.x >= -10 + 1e-6]
        self.assertGreater(len(arc), 15)
        for point in arc:
            self.assertAlmostEqual(math.hypot(point.x, point.y), 10, 9)
            self.assertGreaterEqual(point.y, -1e-9)
        last = App.Placement(V(-20, 0, 0), App.Rotation(V(1, 0, 0), 90))
        self.assert_placement(obj.Placements[-1], last, 1e-9)

    def test_driven_property_is_put_back(self):
        sheet, box = self.doc.addObject("Spreadsheet::Sheet", "Values"), self.box()
        sheet.set("A1", "15")
        sheet.setAlias("A1", "angle")
        self.doc.recompute()
        box.setExpression("Placement.Rotation.Angle", "Values.angle")
        self.doc.recompute()
        obj = motion.motion_from_source(
            self.doc, "Driven", [sheet, box], property="angle", start=0, end=90, count=4, duration=3
        )
        self.assertEqual(obj.Times, [0, 1, 2, 3])
        self.assertAlmostEqual(math.degrees(obj.Placements[2].Rotation.Angle), 60, 6)
        self.assertEqual(sheet.getContents("A1"), "15")
        self.assertAlmostEqual(math.degrees(box.Placement.Rotation.Angle), 15, 6)

    def test_sources_survive_save_and_open(self):
        ring = self.doc.addObject("Part::Circle", "Ring")
        ring.Radius = 10
        self.doc.recompute()
        name = motion.motion_from_source(
            self.doc, "Curve", [ring], count=9, orientation="Tangent"
        ).Name
        self.doc.recompute()
        path = os.path.join(self.folder, "c.FCStd")
        self.doc.saveAs(path)
        App.closeDocument(self.doc.Name)
        self.doc = App.openDocument(path)
        self.doc.getObject("Ring").Radius = 20
        self.doc.recompute()
        obj = self.doc.getObject(name)
        self.assertEqual(obj.SourceType, "Curve")
        self.assert_placement(
            obj.Placements[2], App.Placement(V(0, 20, 0), obj.Placements[2].Rotation)
        )


class Editing(Case):
    def keys(self):
        return Keys([0, 1, 3], [shift(), shift(10), shift(10, 10)])

    def test_operations(self):
        keys = self.keys()
        self.assertEqual(keys.insert_after(0), 1)
        self.assertEqual(keys.times, [0, 0.5, 1, 3])
        self.assert_placement(keys.placements[1], shift(5))
        keys.move(1, 1)
        self.assert_placement(keys.placements[2], shift(5))
        self.assertEqual(keys.times, [0, 0.5, 1, 3])
        keys.delete(2)
        keys.reverse()
        self.assertEqual(keys.times, [0, 2.5, 3])
        self.assert_placement(keys.placements[0], shift(10, 10))
        keys.even(2.0)
        self.assertEqual(keys.times, [0, 2, 4])
        self.assertEqual(keys.append(shift(1)), 3)
        self.assertEqual(keys.times[-1], 6)
        keys.poses()

    def test_times_stay_in_order(self):
        keys = self.keys()
        with self.assertRaisesRegex(InputProblem, "key 2"):
            keys.set_time(1, 3)
        keys.set_time(1, 2.9)
        self.assertEqual(keys.times, [0, 2.9, 3])

    def test_numbers_and_units(self):
        place = turn(30, V(1, 2, 3), V(1, 2, 3))
        self.assert_placement(from_numbers(as_numbers(place)), place, 1e-9)
        self.assertAlmostEqual(number_from("2 in", "mm"), 50.8)
        self.assertAlmostEqual(number_from("1,5", "mm"), 1.5)
        self.assertAlmostEqual(number_from("90", "deg"), 90)
        for text in ("2 kg", "abc"):
            with self.assertRaises(InputProblem):
                number_from(text, "mm")
