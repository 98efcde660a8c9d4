# SPDX-License-Identifier: LGPL-2.1-or-later
"""The main workflow without a window: envelope, solid, export."""
import json
import math
import os
import zipfile
from unittest import mock

import FreeCAD as App
import numpy as np
import Part

from case import Case, V, shift, turn
from sweptvolume import core, export
from sweptvolume.convert import InputProblem
from sweptvolume.features import (
    envelope,
    envelope_plan,
    kept,
    motion,
    solid,
    solid_origin,
    step_reader,
)


class Computed(Case):
    NEEDS_CORE = True

    def computed(self, **settings):
        self.part = self.box()
        self.path = self.line()
        obj = self.envelope([self.part], self.path, **settings)
        envelope.compute(obj)
        return obj

    def assert_mesh_box(self, obj, low, high, reach):
        box = obj.Mesh.BoundBox
        found = (box.XMin, box.YMin, box.ZMin, box.XMax, box.YMax, box.ZMax)
        for a, b in zip(found, tuple(low) + tuple(high)):
            self.assertAlmostEqual(a, b, delta=reach, msg=str(found))


class Envelope(Computed):
    def test_moved_box(self):
        obj = self.computed()
        self.assertEqual(obj.Status, envelope.UP_TO_DATE)
        self.assertTrue(obj.Mesh.isSolid())
        self.assertAlmostEqual(obj.Volume.Value, 4000, delta=0.05 * 1800 * obj.UsedCellSize.Value)
        self.assert_mesh_box(obj, (0, 0, 0), (40, 10, 10), obj.UsedCellSize.Value)
        self.assertEqual(obj.Triangles, obj.Mesh.CountFacets)
        self.assertGreater(obj.Seconds, 0)

    def test_accuracy_takes_the_place_of_cells_and_tolerance(self):
        plain = self.computed(CellSize=0.5)
        obj = self.envelope([self.part], self.path, Accuracy=1, Resolution=999, Tolerance=5)
        plan = envelope_plan.Plan.of(obj)
        estimated = plan.estimate()["cell"]
        envelope.compute(obj)
        self.assertEqual(obj.Status, envelope.UP_TO_DATE)
        self.assertEqual((obj.UsedCellSize.Value, estimated), (0.5, 0.5))
        self.assertLessEqual(obj.AccuracyBound.Value, 1)
        self.assertGreater(obj.AccuracyBound.Value, 0.5)
        self.assertLess(obj.Triangles, plain.Triangles)
        arguments = core.arguments(plan.requests()[0])
        report = core.module().compute(*arguments, accuracy=1).report
        stored = json.loads(obj.Report)
        for name in ("cell", "triangles", "volume", "refined_placements", "accuracy_bound"):
            self.assertEqual(report[name], stored[name], name)
        obj.Accuracy = 0
        self.doc.recompute()
        self.assertEqual(obj.Status, envelope.STALE)

    def test_recompute_never_computes(self):
        self.part = self.box()
        obj = self.envelope([self.part], self.line())
        self.assertEqual((obj.Status, obj.Mesh.CountFacets), (envelope.NOT_COMPUTED, 0))

    def test_stale_and_current_again(self):
        obj = self.computed()
        facets = obj.Mesh.CountFacets
        self.part.Length = 12
        self.doc.recompute()
        self.assertEqual((obj.Status, obj.Mesh.CountFacets), (envelope.STALE, facets))
        self.part.Length = 10
        self.doc.recompute()
        self.assertEqual(obj.Status, envelope.UP_TO_DATE)
        self.path.Placements = [shift(), shift(35)]
        self.doc.recompute()
        self.assertEqual(obj.Status, envelope.STALE)
        envelope.compute(obj)
        self.assertEqual(obj.Status, envelope.UP_TO_DATE)
        self.assert_mesh_box(obj, (0, 0, 0), (45, 10, 10), obj.UsedCellSize.Value)
        obj.Resolution = 50
        self.doc.recompute()
        self.assertEqual(obj.Status, envelope.STALE)

    def test_moving_a_group_marks_stale(self):
        group, obj = self.grouped_envelope()
        group.Placement = shift(0, 50)
        self.doc.recompute()
        self.assertEqual(obj.Status, envelope.STALE)
        envelope.compute(obj)
        self.assert_mesh_box(obj, (0, 50, 0), (40, 60, 10), obj.UsedCellSize.Value)

    def test_frames_in_the_document(self):
        box, path = self.box(), self.line()
        box.Placement = shift(0, 20)
        obj = self.envelope([box], path)
        for frame, y in (("Absolute", 0), ("Relative", 20), ("RelativeToFirst", 20)):
            path.PoseType = frame
            envelope.compute(obj)
            self.assert_mesh_box(obj, (0, y, 0), (40, y + 10, 10), obj.UsedCellSize.Value)

    def test_through_link_with_global_placement(self):
        group, box = self.doc.addObject("App::Part", "G"), self.box()
        group.addObject(box)
        link = self.doc.addObject("App::Link", "L")
        link.LinkedObject, link.Placement = group, turn(90, V(0, 0, 1), V(0, 0, 100))
        path = self.line()
        path.PoseType = "Relative"
        self.doc.recompute()
        obj = self.envelope([(link, "Box.Face1")], path)
        self.assertEqual(obj.MovingParts, [(link, ("Box.",))])
        envelope.compute(obj)
        self.assert_mesh_box(obj, (-10, 0, 100), (30, 10, 110), obj.UsedCellSize.Value)

    def test_several_parts_and_a_mesh(self):
        box, ball = self.box(), self.doc.addObject("Part::Sphere", "Ball")
        ball.Placement, ball.Radius = shift(5, 30, 5), 5
        self.doc.recompute()
        net = self.doc.addObject("Mesh::Feature", "Net")
        import MeshPart

        net.Mesh = MeshPart.meshFromShape(Part.makeBox(4, 4, 4), 1.0)
        net.Placement = shift(0, -20)
        obj = self.envelope([box, ball, net], self.line(), Resolution=64)
        envelope.compute(obj)
        self.assertEqual(obj.Shells, 3)
        self.assert_mesh_box(obj, (0, -20, 0), (40, 35, 10), obj.UsedCellSize.Value)

    def test_inside_a_group_it_stays_in_the_world(self):
        obj = self.computed()
        group = self.doc.addObject("App::Part", "G")
        group.Placement = shift(0, 0, 500)
        group.addObject(obj)
        self.doc.recompute()
        envelope.compute(obj)
        self.assert_placement(obj.getGlobalPlacement(), App.Placement())

    def test_one_undo_step(self):
        obj = self.computed()
        facets, steps = obj.Mesh.CountFacets, self.doc.UndoCount
        self.part.Length = 20
        self.doc.recompute()
        envelope.compute(obj)
        self.assertEqual(self.doc.UndoCount, steps + 1)
        self.assertNotEqual(obj.Mesh.CountFacets, facets)
        self.doc.undo()
        self.assertEqual(obj.Mesh.CountFacets, facets)
        self.doc.redo()
        self.assertEqual(obj.Status, envelope.UP_TO_DATE)

    def test_save_and_open_without_computing(self):
        obj = self.computed()
        name, facets = obj.Name, obj.Mesh.CountFacets
        path = os.path.join(self.folder, "e.FCStd")
        self.doc.saveAs(path)
        App.closeDocument(self.doc.Name)
        real, core.compute = core.compute, None  # a call would fail
        try:
            self.doc = App.openDocument(path)
            self.doc.recompute(None, True)
        finally:
            core.compute = real
        obj = self.doc.getObject(name)
        self.assertEqual((obj.Status, obj.Mesh.CountFacets), (envelope.UP_TO_DATE, facets))
        self.doc.getObject("Box").Length = 11
        self.doc.recompute()
        self.assertEqual(obj.Status, envelope.STALE)

    def test_failure_keeps_the_last_result(self):
        obj = self.computed()
        facets = obj.Mesh.CountFacets
        obj.CellSize = 1000
        with self.assertRaises(core.CoreError):
            envelope.compute(obj)
        self.assertEqual((obj.Status, obj.Mesh.CountFacets), (envelope.FAILED, facets))
        self.assertTrue(obj.Message)
        obj.CellSize = 0
        envelope.compute(obj)
        self.assertEqual(obj.Status, envelope.UP_TO_DATE)

    def test_cancel(self):
        obj = self.computed()
        facets = obj.Mesh.CountFacets
        control = core.Control()
        control.cancel()
        with self.assertRaises(core.CoreError) as caught:
            envelope.compute(obj, control)
        self.assertEqual(caught.exception.status, "Cancelled")
        self.assertEqual((obj.Status, obj.Mesh.CountFacets), (envelope.CANCELLED, facets))

    def test_missing_inputs_are_explained(self):
        obj = self.envelope([], None)
        with self.assertRaisesRegex(InputProblem, "No motion"):
            envelope.compute(obj)
        obj.Motion = self.line()
        with self.assertRaisesRegex(InputProblem, "No moving part"):
            envelope.compute(obj)
        obj.Motion = motion.make_motion(self.doc)
        obj.MovingParts = [(self.box(), "")]
        self.doc.recompute()
        with self.assertRaisesRegex(InputProblem, "no poses"):
            envelope.compute(obj)

    def test_estimate(self):
        obj = self.envelope([self.box()], self.line(), CellSize=0.5)
        found = envelope.Plan.of(obj).estimate()
        self.assertAlmostEqual(found["cell"], 0.5)
        self.assertTrue(all(a <= n <= a + 16 for n, a in zip(found["grid"], (80, 20, 20))), found)

    def test_other_tolerance_cuts_the_kept_surface(self):
        obj = self.computed(Tolerance=0.0001)
        before = json.loads(obj.Report)
        obj.Tolerance = 0.5
        self.doc.recompute()
        self.assertEqual(obj.Status, envelope.STALE)
        envelope.compute(obj)
        self.assertEqual(obj.Status, envelope.UP_TO_DATE)
        after = json.loads(obj.Report)
        self.assertEqual(after["seconds"], before["seconds"], "sampled again")
        self.assertGreater(after["simplification_deviation"], before["simplification_deviation"])
        kept.drop()
        found = obj.Mesh.Topology
        envelope.compute(obj)
        self.assertEqual(obj.Mesh.Topology, found, "not what a run of its own gives")
        self.assertNotEqual(json.loads(obj.Report)["seconds"], before["seconds"])

    def test_kept_surface_goes_with_its_document(self):
        obj = self.computed(Tolerance=0.05)
        other = App.newDocument("Other")
        obj.Tolerance = 0.5
        self.assertTrue(envelope.can_recut(obj))
        App.closeDocument(other.Name)
        self.assertTrue(envelope.can_recut(obj))
        obj.Offset = 1
        self.assertFalse(envelope.can_recut(obj))
        self.assertIsNotNone(kept._last)
        App.closeDocument(self.doc.Name)
        self.assertIsNone(kept._last)

    def test_position_filter(self):
        # To and fro across the direction of motion, so that no steps are merged.
        places = [shift(0.01 * k, 0.1 * (k % 2)) for k in range(2001)]
        self.part = self.box()
        path = motion.motion_from_poses(self.doc, range(2001), places)
        every = self.envelope([self.part], path)
        few = self.envelope([self.part], path, PositionFilter=0.5)
        for obj in (every, few):
            envelope.compute(obj)
        used = [json.loads(obj.Report)["refined_placements"] for obj in (every, few)]
        self.assertEqual(every.Status, envelope.UP_TO_DATE)
        self.assertLess(used[1], 100)
        self.assertEqual(used[0], 2001)
        self.assertAlmostEqual(few.Mesh.BoundBox.XMax, 30, delta=0.01)
        few.PositionFilter = 0
        self.doc.recompute()
        self.assertEqual(few.Status, envelope.STALE)


class SolidAndFiles(Computed):
    def test_solid_of_envelope(self):
        obj = self.computed()
        body = solid.make_solid(self.doc, obj)
        self.doc.recompute()
        self.assertEqual(body.Status, envelope.NOT_COMPUTED)
        solid.compute(body)
        self.assertTrue(body.Shape.isValid())
        self.assertEqual(len(body.Shape.Solids), 1)
        self.assertAlmostEqual(body.Shape.Volume, obj.Mesh.Volume, delta=1e-3 * obj.Mesh.Volume)
        self.assertEqual(body.Status, envelope.UP_TO_DATE)
        self.part.Length = 15
        self.doc.recompute()
        self.assertEqual(body.Status, envelope.STALE)
        envelope.compute(obj)
        self.doc.recompute()
        self.assertEqual(body.Status, envelope.STALE)
        solid.compute(body)
        self.assertAlmostEqual(body.Shape.Volume, obj.Mesh.Volume, delta=1e-3 * obj.Mesh.Volume)

    def test_tolerance_and_limit(self):
        obj = self.computed()
        body = solid.make_solid(self.doc, obj, Tolerance=0.2, MaxFaces=500)
        solid.compute(body)
        self.assertEqual(body.Status, solid.UP_TO_DATE)
        self.assertLessEqual(body.Faces, 500)
        self.assertLessEqual(body.Deviation.Value, 0.2)
        body.Tolerance = 0.1
        self.doc.recompute()
        self.assertEqual(body.Status, solid.STALE)
        path = os.path.join(self.folder, "like.step")
        self.assertEqual(
            export.write(export.request(obj, solid.settings(body)), path)["tolerance"], 0.1
        )

    def test_conservative_solid_is_exact(self):
        obj = self.envelope([self.box()], self.line(), Conservative=True, CellSize=2)
        envelope.compute(obj)
        body = solid.make_solid(self.doc, obj, Tolerance=0.2)
        with self.assertRaisesRegex(InputProblem, "cut into the swept volume"):
            solid.compute(body)
        body.Tolerance = 0
        body.MaxFaces = 5
        with self.assertRaisesRegex(core.CoreError, "limit is 5 faces"):
            solid.compute(body)
        body.MaxFaces = 20000
        self.assertEqual(solid.compute(body)["tolerance"], 0)
        self.assertEqual(solid.first_settings(obj)["tolerance"], 0)

    def swept_pin(self):
        """Returns the envelope of a moved cylinder, and a solid of it with recognised surfaces."""
        part = self.doc.addObject("Part::Cylinder", "Pin")
        part.Radius = 6
        self.doc.recompute()
        obj = self.envelope([part], self.line(), CellSize=0.4)
        envelope.compute(obj)
        return obj, solid.make_solid(self.doc, obj, Tolerance=0.1)

    def test_proposed_settings(self):
        """The settings that the panel proposes suffice for the faces of the part."""
        if not core.has_solids():
            self.skipTest("the core has no OpenCASCADE")
        obj, body = self.swept_pin()
        solid.set_settings(body, solid.first_settings(obj))
        self.assertEqual(body.Tolerance.Value, 0.04)  # a tenth of a cell
        self.assertNotIn("facet", solid.compute(body)["faces_by_kind"])

    def test_tolerance_below_the_deviation_of_the_mesh(self):
        """A coarse mesh of the part does not keep the solid from the faces of the part."""
        if not core.has_solids():
            self.skipTest("the core has no OpenCASCADE")
        _, body = self.swept_pin()
        body.Tolerance = 0.004
        self.assertNotIn("facet", solid.compute(body)["faces_by_kind"])
        self.assertLess(body.Deviation.Value, 0.004)

    def test_faces_of_the_part(self):
        """The solid of a straight move has the exact volume, wherever part and envelope stand."""
        if not core.has_solids():
            self.skipTest("the core has no OpenCASCADE")
        obj, body = self.swept_pin()
        exact = math.pi * 6 * 6 * 10 + 2 * 6 * 10 * 30
        report = solid.compute(body)
        self.assertNotIn("facet", report["faces_by_kind"])
        self.assertAlmostEqual(body.Volume.Value, exact, delta=1e-6 * exact)
        self.assertLess(body.EdgeTolerance.Value, 1e-6)
        group = self.doc.addObject("App::Part", "Group")
        for member in (self.doc.Pin, obj, body):
            group.addObject(member)
        group.Placement = turn(30, V(1, 2, 3), V(7, 8, 9))
        self.doc.recompute()
        envelope.compute(obj)
        solid.compute(body)
        self.assertAlmostEqual(body.Volume.Value, exact, delta=1e-6 * exact)
        path = os.path.join(self.folder, "pin.step")
        report = export.write(export.request(obj, solid.settings(body)), path)
        self.assertNotIn("facet", report["faces_by_kind"])
        placed = Part.read(path)
        inside = body.Shape.copy()
        inside.Placement = group.Placement.multiply(inside.Placement)
        self.assertAlmostEqual(placed.common(inside).Volume, exact, delta=1e-6 * exact)

    def test_faces_of_a_part_that_turns_while_it_moves(self):
        """The solid has the surfaces that the edges of a box sweep, about a pivot and in a group."""
        if not core.has_solids():
            self.skipTest("the core has no OpenCASCADE")
        path = motion.motion_from_poses(
            self.doc, [0, 1], [shift(), turn(35, V(1, 2, 3), V(14, 3, 6))]
        )
        path.Pivot = V(5, 5, 5)
        part = self.box()
        obj = self.envelope([part], path, CellSize=0.4)
        group = self.doc.addObject("App::Part", "Group")
        for member in (part, path, obj):
            group.addObject(member)
        group.Placement = turn(30, V(1, 2, 3), V(7, 8, 9))
        self.doc.recompute()
        envelope.compute(obj)
        body = solid.make_solid(self.doc, obj, Tolerance=0.1)
        group.addObject(body)
        report = solid.compute(body)
        self.assertNotIn("facet", report["faces_by_kind"])
        self.assertIn("sheet", report["faces_by_kind"])
        self.assertLess(body.EdgeTolerance.Value, 1e-5)
        self.assertAlmostEqual(body.Volume.Value, obj.Mesh.Volume, delta=1e-3 * obj.Mesh.Volume)
        self.assertTrue(body.Shape.isValid())
        box = Part.makeBox(10, 10, 10)
        self.assertAlmostEqual(body.Shape.common(box).Volume, 1000, delta=1e-3)

    def test_faces_of_parts_that_only_the_mesh_knows(self):
        obj = self.envelope([self.box()], self.line(), CellSize=0.5)
        envelope.compute(obj)
        matrix = np.eye(4)
        self.assertEqual(solid_origin.of(obj, matrix) is not None, core.has_solids())
        for change in ({"Offset": 1.0}, {"MovingParts": [self.box("Other"), self.box("Third")]}):
            other = self.envelope([self.box()], self.line(), CellSize=0.5)
            for name, value in change.items():
                setattr(other, name, value)
            envelope.compute(other)
            self.assertIsNone(solid_origin.of(other, matrix))
        obj.CellSize = 0.6
        self.doc.recompute()
        self.assertEqual(obj.Status, envelope.STALE)
        self.assertIsNone(solid_origin.of(obj, matrix))

    def test_without_kernel_in_the_core(self):
        obj, body = self.swept_pin()
        request = export.request(obj, solid.settings(body))
        request.origin = None  # with a kernel, the core would take the faces from the part
        ours, path = (os.path.join(self.folder, name) for name in ("ours.step", "freecads.step"))
        if core.has_solids():
            export.write(request, ours)
        with mock.patch.object(core, "has_solids", return_value=False):
            self.assertEqual(solid.compute(body)["note"], "")
            self.assertLess(body.Faces, obj.Mesh.CountFacets / 10)
            self.assertTrue(body.Shape.isValid())
            self.assertAlmostEqual(body.Volume.Value, obj.Mesh.Volume, delta=1e-2 * obj.Mesh.Volume)
            report = export.write(request, path)
            self.assertIn("cylinder", report["faces_by_kind"])
            self.assertEqual(len(Part.read(path).Solids), 1)
        if core.has_solids():
            texts = []
            for name in (ours, path):
                with open(name, "rb") as file:
                    texts.append(file.read().partition(b"DATA;")[2])
            self.assertEqual(*texts)
            os.remove(ours)
        self.assertEqual(os.listdir(self.folder), ["freecads.step"])
        self.assertEqual(os.stat(path).st_mode, os.stat(self.file("any", "")).st_mode)

    def test_faces_that_freecad_refuses_lose_their_surface(self):
        obj, body = self.swept_pin()
        request = export.request(obj, solid.settings(body))
        path, judged = os.path.join(self.folder, "x.step"), step_reader.judged

        def refusing(shape):
            answer = judged(shape)  # a query that has only the curved faces has no solid
            return (
                answer if answer["solids"] else dict(answer, bad_faces=list(range(answer["faces"])))
            )

        with mock.patch.object(core, "has_solids", return_value=False):
            first = export.write(request, path)
            with mock.patch.object(step_reader, "judged", refusing):
                second = export.write(request, path)
        self.assertIn("cylinder", first["faces_by_kind"])
        self.assertFalse(set(second["faces_by_kind"]) - {"plane", "facet"}, second)
        self.assertTrue(second["valid"])
        self.assertGreater(second["faces"], first["faces"])

    def test_what_freecad_cannot_read_is_said(self):
        answer = step_reader.read(b"ISO-10303-21;\nnothing\n")
        self.assertFalse(answer["valid"])
        self.assertTrue(answer["complaint"])
        self.assertEqual(answer["faces"], 0)

    def test_step_is_read_back(self):
        obj = self.computed()
        obj.Placement = shift(0, 0, 7)
        path = os.path.join(self.folder, "Hülle 1.step")
        export.write(export.request(obj), path)
        shape = Part.read(path)
        self.assertEqual(len(shape.Solids), 1)
        self.assertAlmostEqual(shape.BoundBox.ZMin, 7, delta=obj.UsedCellSize.Value)
        self.assertAlmostEqual(shape.Volume, obj.Mesh.Volume, delta=1e-3 * obj.Mesh.Volume)

    def test_scripts_can_keep_files_that_exist(self):
        obj = self.computed()
        for name in ("a.stl", "a.step"):
            path = os.path.join(self.folder, name)
            export.write(export.request(obj), path, no_clobber=True)
            before = os.stat(path).st_mtime_ns
            with self.assertRaisesRegex(InputProblem, name):
                export.write(export.request(obj), path, no_clobber=True)
            self.assertEqual(os.stat(path).st_mtime_ns, before)

    def test_tessellated_step(self):
        if not core.has_solids():
            self.skipTest("the core was built without OpenCASCADE")
        obj = self.computed()
        path = os.path.join(self.folder, "as it is.stp")
        req = export.request(obj, {"tessellated": True})
        (estimate,) = req.estimates("step")
        self.assertEqual(estimate(core.Control())["faces"], obj.Mesh.CountFacets)
        report = export.write(req, path)
        self.assertEqual(report["faces"], obj.Mesh.CountFacets)
        self.assertAlmostEqual(report["volume"], obj.Mesh.Volume, delta=1e-5 * obj.Mesh.Volume)
        with open(path, encoding="ascii") as file:
            self.assertIn("=TESSELLATED_SOLID(", file.read())

    def test_mesh_files(self):
        import Mesh

        obj = self.computed()
        for suffix in export.MESH_SUFFIXES:
            path = os.path.join(self.folder, "m" + suffix)
            export.write(export.request(obj), path)
            if suffix == ".3mf":  # which old versions write, but do not read
                with zipfile.ZipFile(path) as file:
                    model = file.read("3D/3dmodel.model")
                self.assertEqual(model.count(b"<triangle "), obj.Mesh.CountFacets)
                continue
            self.assertEqual(Mesh.Mesh(path).CountFacets, obj.Mesh.CountFacets, suffix)

    def test_targets_are_checked_first(self):
        for name, text in (
            ("a.xyz", "not supported"),
            (os.path.join("no", "a.step"), "does not exist"),
        ):
            with self.assertRaisesRegex(InputProblem, text):
                export.check_target(os.path.join(self.folder, name))
        os.mkdir(os.path.join(self.folder, "d.step"))
        with self.assertRaisesRegex(InputProblem, "is a folder"):
            export.check_target(os.path.join(self.folder, "d.step"))

    def test_nothing_to_export(self):
        with self.assertRaisesRegex(InputProblem, "has no mesh yet: compute it first"):
            export.request(self.envelope([self.box()], self.line()))
