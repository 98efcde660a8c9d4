# SPDX-License-Identifier: LGPL-2.1-or-later
"""Each kind of source on a real document, and the operations of the motion editor."""
import math

import FreeCAD as App
import Part

from case import Case, V, shift, turn
from sweptvolume.convert import InputProblem
from sweptvolume.features import motion
from sweptvolume.trajectory import assembly, driven
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
        sheet, box = self.sheet("angle", "15"), self.box()
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

    def test_second_curve_orients_without_flips(self):
        """A helix of two turns about its own axis: the z axis of the part always points to the axis of
        the helix."""
        helix = self.doc.addObject("Part::Helix", "Helix")
        helix.Pitch, helix.Height, helix.Radius = 20, 40, 15
        axis = self.doc.addObject("Part::Feature", "Axis")
        axis.Shape = Part.makeLine(V(0, 0, 40), V(0, 0, 0))  # drawn from the end
        self.doc.recompute()
        obj = motion.motion_from_source(
            self.doc, "Curve", [helix, axis], count=97, orientation="SecondCurve"
        )
        for place in obj.Placements:
            z = place.Rotation.multVec(V(0, 0, 1))
            inward = V(-place.Base.x, -place.Base.y, 0).normalize()
            self.assertGreater(z.dot(inward), 1 - 1e-3)
        turns = [p.Rotation for p in obj.Placements]
        steps = [math.degrees(a.inverted().multiply(b).Angle) for a, b in zip(turns, turns[1:])]
        steps = [min(s, 360 - s) for s in steps]
        self.assertLess(max(steps), 8, "one pose to the next turns 7.5 degrees, a flip 180")

    def test_second_curve_that_meets_the_path_carries_on(self):
        path, other = (self.doc.addObject("Part::Feature", n) for n in ("Path", "Other"))
        path.Shape = Part.makeLine(V(0, 0, 0), V(40, 0, 0))
        other.Shape = Part.makeLine(V(0, 0, 10), V(40, 0, -10))  # crosses in the middle
        sources = {"count": 5, "orientation": "SecondCurve"}
        obj = motion.motion_from_source(self.doc, "Curve", [path, other], **sources)
        self.assert_placement(obj.Placements[2], shift(20), 1e-9)
        other.Shape = Part.makeLine(V(-5, 0, 0), V(40, 0, 0))
        with self.assertRaisesRegex(InputProblem, "does not define the z axis"):
            motion.motion_from_source(self.doc, "Curve", [path, other], **sources)

    def test_cam_planes_radius_and_relative(self):
        try:
            import Path
        except ImportError as error:
            self.skipTest("this FreeCAD has no CAM ({})".format(error))
        feature = self.doc.addObject("Path::Feature", "Cut")
        lines = ["G1 X0 Y0 Z0 F5", "G18", "G2 X20 Z0 I10 K0", "G17", "G91", "G3 X0 Y10 R5", "G1 Z3"]
        feature.Path = Path.Path([Path.Command(line) for line in lines])
        obj = motion.motion_from_source(self.doc, "CAM", [feature])
        arc = [p.Base for p in obj.Placements if p.Base.x < 20 - 1e-9]
        self.assertGreater(len(arc), 15)
        for point in arc:
            self.assertAlmostEqual(math.hypot(point.x - 10, point.z), 10, 9)
        # Clockwise seen from +y turns x towards z, so -x (where it starts) towards -z.
        self.assertLess(min(p.z for p in arc), -9)
        second = [p.Base for p in obj.Placements if p.Base.y > 1e-9 and p.Base.z < 1e-9]
        for point in second:
            self.assertAlmostEqual(math.hypot(point.x - 20, point.y - 5), 5, 9)
            self.assertGreaterEqual(point.x, 20 - 1e-9)
        self.assert_placement(obj.Placements[-1], shift(20, 10, 3), 1e-9)

    def test_cam_turned_table(self):
        try:
            import Path
        except ImportError as error:
            self.skipTest("this FreeCAD has no CAM ({})".format(error))
        feature = self.doc.addObject("Path::Feature", "Cut")
        lines = ["G1 X10 Y0 Z0 F5", "G1 X10 C90"]
        feature.Path = Path.Path([Path.Command(line) for line in lines])
        head = motion.motion_from_source(self.doc, "CAM", [feature])
        table = motion.motion_from_source(self.doc, "CAM", [feature], convention="Table")
        self.assert_placement(head.Placements[-1], turn(90, base=V(10, 0, 0)), 1e-9)
        # The workpiece turned by 90 degrees below the tool. So relative to the workpiece, the tool turned
        # back.
        self.assert_placement(table.Placements[-1], turn(-90, base=V(0, -10, 0)), 1e-9)
        # Between two poses, the shorter rotation is taken, so a turn by 270 degrees has intermediate poses.
        feature.Path = Path.Path([Path.Command(line) for line in (lines[0], "G1 X10 C270")])
        far = motion.motion_from_source(self.doc, "CAM", [feature])
        self.assertEqual(len(far.Placements), 28)
        for i, place in enumerate(far.Placements):
            self.assert_placement(place, turn(10 * i, base=V(10, 0, 0)), 1e-9)

    def test_driven_sketch_constraint_and_offset(self):
        import Sketcher

        sketch = self.doc.addObject("Sketcher::SketchObject", "Crank")
        sketch.addGeometry(Part.LineSegment(V(), V(10, 0, 0)))
        sketch.addConstraint(Sketcher.Constraint("Distance", 0, 10.0))
        sketch.renameConstraint(0, "Arm")
        box = self.box()
        self.doc.recompute()
        box.setExpression("Placement.Base.x", "Crank.Constraints.Arm * 2")
        self.doc.recompute()
        values = {"start": 10, "end": 30, "count": 3, "duration": 2}
        obj = motion.motion_from_source(
            self.doc, "Driven", [sketch, box], property="Constraints.Arm", **values
        )
        self.assertEqual([round(p.Base.x, 6) for p in obj.Placements], [20, 40, 60])
        self.assertAlmostEqual(sketch.Shape.Length, 10)
        with self.assertRaisesRegex(InputProblem, "choose a value that this expression uses"):
            motion.motion_from_source(
                self.doc, "Driven", [box, box], property="Placement.Base.x", **values
            )
        with self.assertRaisesRegex(InputProblem, "has no value .*Constraints.Arm"):
            motion.motion_from_source(self.doc, "Driven", [sketch, box], property="Leg", **values)
        path = motion.motion_from_source(
            self.doc, "Driven", [box, box], property="Placement.Base.y", **values
        )
        self.assertEqual([round(p.Base.y, 6) for p in path.Placements], [10, 20, 30])
        self.assertAlmostEqual(box.Placement.Base.y, 0)
        for driver, name, unit in (
            (sketch, "Constraints.Arm", "mm"),
            (box, "Placement.Base.y", "mm"),
            (box, "Placement.Rotation.Angle", "deg"),
            (box, "Length", "mm"),
        ):
            self.assertEqual(driven.Handle(driver, name).unit(), unit)

    def test_simulation_asks_the_assembly(self):
        """Tests only the calls, with a stand-in. test_assembly.py uses FreeCAD's own simulation."""
        box, calls = self.box(), []

        class Assembly:
            Name, InList = "Assembly", []

            def generateSimulation(self, simulation):  # noqa: N802
                calls.append(simulation)

            def numberOfFrames(self):  # noqa: N802
                return 4

            def updateForFrame(self, frame):  # noqa: N802
                box.Placement = shift(10 * frame)

        class Group:
            Name, InList = "Simulations", [Assembly()]

        class Simulation:
            Name, Label, InList = "Simulation", "Simulation", [Group()]
            PropertiesList = ["aTimeStart", "bTimeEnd", "cTimeStepOutput"]
            aTimeStart, bTimeEnd, cTimeStepOutput = 1.0, 2.0, 0.5

        found = assembly.poses([Simulation(), box])
        self.assertEqual(found.times, [1.0, 1.5, 2.0])
        self.assert_placement(found.placements[2], shift(30))
        self.assert_placement(box.Placement, shift(), 1e-12)
        self.assertEqual(len(calls), 1)
        Group.InList = []
        with self.assertRaisesRegex(InputProblem, "need FreeCAD 1.1"):
            assembly.poses([Simulation(), box])

    def test_draft_wire_and_path_array(self):
        try:
            import Draft
        except ImportError as error:
            self.skipTest("this FreeCAD has no Draft ({})".format(error))
        wire = Draft.make_wire([V(), V(30, 0, 0), V(30, 10, 0)])
        self.doc.recompute()
        obj = motion.motion_from_source(self.doc, "Curve", [wire], count=5)
        self.assert_placement(obj.Placements[2], shift(20), 1e-9)
        array = Draft.make_path_array(self.box(), wire, 3)
        self.doc.recompute()
        along = motion.motion_from_source(self.doc, "Array", [array])
        self.assertEqual(along.Count or len(along.Placements), 3)
        wire.Points = [V(), V(50, 0, 0), V(50, 10, 0)]
        self.doc.recompute()
        self.assert_placement(obj.Placements[2], shift(30), 1e-9)


class RoundTrip(Case):
    """Every kind of source: the document is saved and opened, the source is changed and recomputed."""

    def changed(self, kind, objects, change, stale=False, **values):
        """Returns the poses before and after `change(document)`, which is made in the document after it
        was opened again."""
        obj = motion.motion_from_source(self.doc, kind, objects, **values)
        self.doc.recompute()
        name, before = obj.Name, list(obj.Placements)
        self.reopen()
        obj = self.doc.getObject(name)
        self.assertEqual((obj.SourceType, obj.Status), (kind, ""))
        for a, b in zip(obj.Placements, before):
            self.assert_placement(a, b, 1e-9)
        change(self.doc)
        self.doc.recompute()
        if stale:
            self.assertEqual(obj.Status, motion.STALE)
            self.assert_placement(obj.Placements[-1], before[-1], 1e-9)
            motion.reload_source(obj)
            self.doc.recompute()
        self.assertEqual(obj.Status, "")
        return before, list(obj.Placements)

    def test_placements(self):
        boxes = [self.box("B%d" % i) for i in range(2)]
        before, after = self.changed(
            "Placements", boxes, lambda doc: setattr(doc.getObject("B1"), "Placement", shift(4))
        )
        self.assert_placement(before[1], shift())
        self.assert_placement(after[1], shift(4))

    def test_curve(self):
        ring = self.doc.addObject("Part::Circle", "Ring")
        ring.Radius = 10
        self.doc.recompute()
        after = self.changed(
            "Curve",
            [ring],
            lambda doc: setattr(doc.getObject("Ring"), "Radius", 20),
            count=9,
            orientation="Tangent",
        )[1]
        self.assertLess((after[2].Base - V(0, 20, 0)).Length, 1e-9)

    def test_sketch(self):
        sketch = self.doc.addObject("Sketcher::SketchObject", "Sketch")
        sketch.addGeometry(Part.LineSegment(V(0, 0, 0), V(0, 30, 0)))
        self.doc.recompute()
        after = self.changed(
            "Curve", [sketch], lambda doc: setattr(doc.getObject("Sketch"), "Placement", shift(5))
        )[1]
        self.assert_placement(after[-1], shift(5, 30), 1e-9)

    def test_array(self):
        array = self.doc.addObject("App::Link", "Array")
        array.LinkedObject, array.ElementCount = self.box(), 3
        self.doc.recompute()

        def change(doc):
            doc.getObject("Array").ElementList[1].Placement = shift(0, 6)

        self.assert_placement(self.changed("Array", [array], change)[1][1], shift(0, 6))

    def test_robot(self):
        try:
            import Robot
        except ImportError as error:
            self.skipTest("this FreeCAD has no Robot workbench ({})".format(error))
        track = self.doc.addObject("Robot::TrajectoryObject", "Track")

        def lay(obj, ends):
            path = Robot.Trajectory()
            for x in ends:
                path.insertWaypoints(Robot.Waypoint(shift(x), type="LIN", name="P", vel=200.0))
            obj.Trajectory = path

        lay(track, (0, 100))
        after = self.changed(
            "Robot", [track], lambda doc: lay(doc.getObject("Track"), (0, 300)), count=5
        )[1]
        self.assert_placement(after[-1], shift(300), 1e-3)

    def test_cam(self):
        try:
            import Path
        except ImportError as error:
            self.skipTest("this FreeCAD has no CAM ({})".format(error))
        feature = self.doc.addObject("Path::Feature", "Cut")

        def lay(obj, x):
            lines = ["G1 X0 Y0 Z0 F5", "G1 X{}".format(x)]
            obj.Path = Path.Path([Path.Command(line) for line in lines])

        lay(feature, 5)
        after = self.changed("CAM", [feature], lambda doc: lay(doc.getObject("Cut"), 8))[1]
        self.assert_placement(after[-1], shift(8))

    def test_driven_turns_stale(self):
        sheet, box = self.sheet("way", "15"), self.box()
        self.doc.recompute()
        box.setExpression("Placement.Base.x", "Values.way * 2")
        self.doc.recompute()
        before, after = self.changed(
            "Driven",
            [sheet, box],
            lambda doc: doc.getObject("Box").setExpression("Placement.Base.x", "Values.way * 3"),
            stale=True,
            property="way",
            start=0,
            end=10,
            count=3,
            duration=1,
        )
        self.assertEqual([p.Base.x for p in before], [0, 10, 20])
        self.assertEqual([p.Base.x for p in after], [0, 15, 30])


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
        with self.assertRaisesRegex(InputProblem, "key 2 must be more than 0 s and less than 3 s"):
            keys.set_time(1, 3)
        with self.assertRaisesRegex(InputProblem, "key 1 must be less than 1 s, not 1.5 s"):
            keys.set_time(0, 1.5)
        with self.assertRaisesRegex(InputProblem, "key 3 must be more than 1 s, not 0.5 s"):
            keys.set_time(2, 0.5)
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
