# SPDX-License-Identifier: LGPL-2.1-or-later
"""Records of what made each triangle of an envelope: for parts in groups and links, and for several motions;
records that are kept in memory and records that are stored in the document.
"""
import json
import os

import FreeCAD as App
import numpy as np
import Part

from case import Case, V, shift, turn
from sweptvolume import convert
from sweptvolume.features import envelope, kept, made_by, motion
from sweptvolume.features.made_by import CAP, EDGE, GRAZE
from sweptvolume.trajectory.poses import at_time


class MadeBy(Case):
    NEEDS_CORE = True

    def computed(self, parts, path, **settings):
        settings.setdefault("MadeBy", "Session")
        obj = self.envelope(parts, path, **settings)
        envelope.compute(obj)
        return obj

    def check(self, obj, path, fraction=0.99):
        """Moves the corners of each triangle back to the position of the part at the named time. They
        must lie on the named face, or on both faces of an edge, within what a cell and the triangles of
        the part permit."""
        record = made_by.find(obj)
        self.assertEqual(len(record.kind), obj.Mesh.CountFacets)
        points, triangles = convert.arrays_from_mesh(obj.Mesh)
        points = convert.transform(convert.global_matrix(*convert.root_path(obj)), points)
        middles = points[triangles].mean(axis=1)
        known = np.nonzero(record.kind >= 0)[0]
        self.assertGreater(len(known), fraction * len(record.kind))
        cell, near, checked = obj.UsedCellSize.Value, 0, 0
        for t in known[:: max(1, len(known) // 300)]:
            answer = record.answer(t)
            moving = motion.world_poses_of(self.doc.getObject(answer.motion))
            pose = at_time(moving, path.Interpolation, answer.time)
            back = pose.inverse().multVec(V(*map(float, middles[t])))
            for part, number in answer.faces:
                shape = Part.getShape(
                    self.doc.getObject(part["root"]),
                    part["sub"] + "Face{}".format(number),
                    needSubElement=True,
                )
                checked += 1
                near += shape.distToShape(Part.Vertex(back))[0] < cell
        self.assertGreater(near, 0.98 * checked)
        return record

    def test_faces_of_a_solid(self):
        box = self.box()
        path = motion.motion_from_poses(
            self.doc, [0, 1, 3], [shift(), turn(40, V(1, 2, 3), V(15, 4, 2)), shift(30, 10, 0)]
        )
        path.PoseType = "Absolute"
        obj = self.computed([box], path)
        record = self.check(obj, path)
        self.assertEqual(set(record.kind) - {-1}, {CAP, EDGE, GRAZE})
        self.assertEqual(len(record.parts), 1)
        self.assertEqual((record.parts[0]["label"], record.parts[0]["count"]), ("Box", 6))

    def test_wrong_records_are_seen(self):
        """The check above fails for wrong faces and times."""
        path = motion.motion_from_poses(
            self.doc, [0, 1], [shift(), turn(40, V(1, 2, 3), V(15, 4, 2))]
        )
        path.PoseType = "Absolute"
        obj = self.computed([self.box()], path)
        record = made_by.find(obj)
        faces = record.faces.copy()
        record.faces = np.where(faces >= 0, (faces + 1) % 6, -1)
        with self.assertRaises(AssertionError):
            self.check(obj, path)
        record.faces, times = faces, record.time
        record.time = times + 0.3
        with self.assertRaises(AssertionError):
            self.check(obj, path)
        record.time = times
        self.check(obj, path)

    def test_several_parts_in_groups_and_links(self):
        group, box = self.doc.addObject("App::Part", "G"), self.box()
        cylinder = self.doc.addObject("Part::Cylinder", "Pin")
        cylinder.Placement, cylinder.Radius = shift(0, 20, 0), 3
        for part in (box, cylinder):
            group.addObject(part)
        link = self.doc.addObject("App::Link", "L")
        link.LinkedObject, link.Placement = group, shift(0, 0, 40)
        self.doc.recompute()
        path = motion.motion_from_poses(
            self.doc, [0, 2], [shift(), turn(50, V(0, 1, 0), V(20, 0, 0))]
        )
        path.PoseType = "Absolute"
        obj = self.computed([link], path)
        self.assertEqual(obj.Status, envelope.UP_TO_DATE)
        record = made_by.find(obj)
        owners = {record.owner(f)[0]["sub"] for f in np.unique(record.faces[record.faces >= 0])}
        self.assertEqual(owners, {"Box.", "Pin."})
        self.assertEqual({part["root"] for part in record.parts}, {"L"})
        self.assertEqual([part["count"] for part in record.parts], [6, 3])
        answer = next(record.answer(t) for t in range(len(record.kind)) if record.kind[t] == CAP)
        self.assertRegex(made_by.text_of(answer), r"^Face\d of .*, at \d+\.\d\d\d s\n")

    def test_two_motions(self):
        """The outer surface of two envelopes has the records of both."""
        one, two = self.box("One"), self.box("Two")
        two.Placement = shift(0, 5, 0)
        first = self.line(30)
        second = motion.motion_from_poses(self.doc, [5, 7], [shift(), shift(0, 0, 30)])
        for path in (first, second):
            path.PoseType = "Relative"
        obj = self.envelope([one, two], first, MadeBy="Session")
        obj.Motions = [first, second]
        envelope.compute(obj)
        record = made_by.find(obj)
        self.assertEqual(len(record.kind), obj.Mesh.CountFacets)
        self.assertEqual([p["motion"] for p in record.parts], [first.Name, second.Name])
        points, triangles = convert.arrays_from_mesh(obj.Mesh)
        middles = points[triangles].mean(axis=1)
        for t in range(0, len(triangles), 37):
            if record.kind[t] < 0:
                continue
            answer = record.answer(t)
            if middles[t][2] > 11:
                self.assertEqual(answer.motion, second.Name)
                self.assertTrue(5 <= answer.time <= 7)
            elif middles[t][0] > 11:
                self.assertEqual(answer.motion, first.Name)
                self.assertTrue(0 <= answer.time <= 1)

    def test_two_motions_simplified_again(self):
        """If only the tolerance changes, the record and the report describe both motions as before."""
        one, two = self.box("One"), self.box("Two")
        two.Placement = shift(0, 5, 0)
        paths = [self.line(30), motion.motion_from_poses(self.doc, [5, 7], [shift(), shift(z=30)])]
        obj = self.envelope([one, two], paths[0], MadeBy="Session", Tolerance=0.3)
        obj.Motions = paths
        envelope.compute(obj)
        obj.Tolerance = 0.05
        self.assertTrue(envelope.can_recut(obj))
        envelope.compute(obj)
        again, report = made_by.find(obj), json.loads(obj.Report)
        kept.drop()
        envelope.compute(obj)
        fresh, anew = made_by.find(obj), json.loads(obj.Report)
        self.assertEqual([p["motion"] for p in again.parts], [m.Name for m in paths])
        np.testing.assert_array_equal(again.kind, fresh.kind)
        np.testing.assert_array_equal(again.faces, fresh.faces)
        for name in ("placements", "warnings", "joined"):
            self.assertEqual(report[name], anew[name], name)

    def test_a_mesh_has_triangles_for_faces(self):
        import Mesh

        part = self.doc.addObject("Mesh::Feature", "Bracket")
        part.Mesh = Mesh.createBox(10, 10, 10)
        path = motion.motion_from_poses(self.doc, [0, 1], [shift(), shift(20, 20, 20)])
        obj = self.computed([part], path)
        record = made_by.find(obj)
        self.assertTrue(record.parts[0]["facets"])
        self.assertEqual(record.parts[0]["count"], part.Mesh.CountFacets)
        answer = next(record.answer(t) for t in range(len(record.kind)) if record.kind[t] == CAP)
        self.assertTrue(made_by.text_of(answer).startswith("triangle "), made_by.text_of(answer))

    def test_off_remembers_nothing_and_the_mesh_is_the_same(self):
        path, box = self.line(), self.box()
        off = self.computed([box], path, MadeBy="Off")
        self.assertIsNone(made_by.find(off))
        on = self.computed([box], path)
        self.assertIsNotNone(made_by.find(on))
        self.assertEqual(off.InputHash, on.InputHash)
        for one, other in zip(off.Mesh.Topology[0], on.Mesh.Topology[0]):
            self.assertEqual(tuple(one), tuple(other))
        self.assertEqual(off.Mesh.Topology[1], on.Mesh.Topology[1])

    def test_grown_envelopes_are_computed_without(self):
        obj = self.computed([self.box()], self.line(), Offset=1.0)
        self.assertEqual(obj.Status, envelope.UP_TO_DATE)
        self.assertIsNone(made_by.find(obj))

    def test_recompute_recut_and_undo(self):
        box, path = self.box(), self.line()
        obj = self.computed([box], path, Tolerance=0.3)
        first = made_by.find(obj)
        self.assertEqual(len(first.kind), obj.Mesh.CountFacets)
        obj.Tolerance = 0.05
        self.assertTrue(envelope.can_recut(obj))
        envelope.compute(obj)
        second = made_by.find(obj)
        self.assertEqual(len(second.kind), obj.Mesh.CountFacets)
        self.assertIsNot(second, first)
        box.Length = 14
        self.doc.recompute()
        self.assertIs(made_by.find(obj), second)  # stale, but still that of the stored mesh
        envelope.compute(obj)
        self.assertIsNot(made_by.find(obj), second)
        self.doc.undo()
        self.assertIs(made_by.find(obj), second)

    def test_another_object_with_the_name_of_a_deleted_part(self):
        """The record of a deleted part keeps its label when a new object gets its name. The label of
        a part that is still there is its present one, and Undo brings the part back."""
        one, two = self.box("One"), self.box("Two")
        two.Placement = shift(0, 20, 0)
        obj = self.computed([one, two], self.line())

        def labels():
            return [part["label"] for part in made_by.find(obj).parts]

        self.assertEqual(labels(), ["One", "Two"])
        self.doc.openTransaction("Delete")
        self.doc.removeObject("One")
        self.doc.commitTransaction()
        two.Label = "Second"
        new = self.doc.addObject("Part::Box", "One")
        self.assertEqual(new.Name, "One")
        new.Label = "Other"
        self.doc.recompute()
        self.assertNotEqual(obj.Status, envelope.UP_TO_DATE)
        self.assertEqual(labels(), ["One", "Second"])
        self.doc.removeObject(new.Name)
        self.doc.undo()
        self.doc.getObject("One").Label = "First"
        self.doc.recompute()
        self.assertEqual(labels(), ["First", "Second"])

    def test_stored_only_where_asked_for(self):
        path, box = self.line(), self.box()
        obj = self.computed([box], path)
        self.assertEqual(obj.MadeByData, "")
        name, sizes = os.path.join(self.folder, "a.FCStd"), []
        for choice in ("Session", "Document"):
            obj.MadeBy = choice
            self.doc.saveAs(name)
            sizes.append(os.path.getsize(name))
        self.assertLess(sizes[0], sizes[1])
        before, label = made_by.find(obj), obj.Name
        App.closeDocument(self.doc.Name)
        self.doc = App.openDocument(name)
        again = made_by.find(self.doc.getObject(label))
        for one, other in zip(
            (before.kind, before.faces, before.time), (again.kind, again.faces, again.time)
        ):
            np.testing.assert_array_equal(one, other)
        self.assertEqual(again.parts, before.parts)

    def test_damaged_records_are_none(self):
        obj = self.computed([self.box()], self.line(), MadeBy="Document")
        text = obj.MadeByData
        self.assertIsNotNone(made_by.unpacked(text))
        for spoiled in ("", "nonsense", text[: len(text) // 2], "A" + text[1:], text[::-1]):
            self.assertIsNone(made_by.unpacked(spoiled), spoiled[:20])
        record = made_by.unpacked(text)
        record.faces = record.faces + 100
        self.assertIsNone(made_by.unpacked(record.packed()))
        record = made_by.unpacked(text)
        record.parts = [dict(record.parts[0], first="x")]
        self.assertIsNone(made_by.unpacked(record.packed()))
