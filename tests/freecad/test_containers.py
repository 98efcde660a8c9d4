# SPDX-License-Identifier: LGPL-2.1-or-later
"""Objects of the workbench inside groups: they cause no circular dependency, and results become stale when
their group is moved.
"""
import itertools

import FreeCAD as App
import numpy as np

from case import Case, V, shift, turn
from sweptvolume import convert
from sweptvolume.features import clearance, clearance_plan, containers, envelope, motion
from sweptvolume.trajectory.poses import FRAMES, base_of


class Containers(Case):
    def setUp(self):
        super().setUp()
        self.outer, self.group = (self.doc.addObject("App::Part", n) for n in ("Outer", "Group"))
        self.part = self.box("Slide")
        self.outer.addObject(self.group)
        self.group.addObject(self.part)
        self.path = self.line()
        self.path.PoseType = "Relative"
        self.doc.recompute()

    def recompute(self):
        """Recomputes. No object may stay touched, and the graph of dependencies may have no cycle (FreeCAD
        only prints a message about one).
        """
        self.doc.recompute()
        for obj in self.doc.Objects:
            self.assertNotIn("Touched", obj.State, obj.Name)
            self.assertNotIn(obj, obj.OutListRecursive, obj.Name)

    def assert_seen(self, obj, root=None):
        """Checks that the only part of the envelope is given with the outermost group."""
        root = root or self.outer
        self.assertEqual(convert.pairs_of(obj.MovingParts), [(root, "Group.Slide.")])

    def test_envelope_dragged_to_its_part_and_out_again(self):
        obj = self.envelope([self.part], self.path)
        self.assert_seen(obj)
        for group in (self.group, self.outer):
            self.doc.openTransaction("Drag")
            group.addObject(obj)
            self.doc.commitTransaction()
            self.recompute()
            self.assert_seen(obj)
            self.doc.undo()
            self.assertEqual(containers.around(obj), [])
            self.recompute()
            self.assert_seen(obj)
            self.doc.redo()
            self.recompute()
            self.assert_seen(obj)
            group.removeObject(obj)
            self.recompute()
            self.assertEqual(obj.MovingParts, [(self.part, ("",))])

    def test_envelope_that_its_part_joins(self):
        self.outer.removeObject(self.group)
        obj = self.envelope([self.part], self.path)
        self.group.addObject(obj)
        self.recompute()
        self.outer.addObject(self.group)
        self.recompute()
        self.assert_seen(obj)

    def test_whole_group_as_generator(self):
        other = self.box("Other", 5)
        self.group.addObject(other)
        obj = self.envelope([(self.group, "")], self.path)
        self.group.addObject(obj)
        self.recompute()
        self.assertEqual([o.Name for o, _ in obj.MovingParts], ["Slide", "Other"])

    def test_links_of_checks_and_references(self):
        wall = self.box("Wall")
        self.group.addObject(wall)
        obj = self.envelope([self.part], self.path)
        obj.Reference, obj.ReferenceMotion = (self.outer, ["Group.Wall."]), self.path
        check = clearance.make_clearance(self.doc, Envelope=obj, AllVisible=False)
        check.Neighbours = [(self.outer, ["Group.Wall."])]
        self.recompute()
        self.group.addObject(obj)
        self.group.addObject(check)
        self.group.addObject(self.path)
        self.recompute()
        self.assertEqual(obj.Reference[0], wall)
        self.assertEqual(convert.pairs_of(obj.Reference), [(self.outer, "Group.Wall.")])
        self.assertEqual(convert.pairs_of(check.Neighbours), [(self.outer, "Group.Wall.")])

    def test_moved_wire_moves_the_motion(self):
        wire = self.straight_wire()
        self.group.addObject(wire)
        path = motion.motion_from_source(self.doc, "Curve", [wire], count=3)
        self.recompute()
        self.outer.Placement = turn(90)
        self.recompute()
        self.assert_placement(path.Placements[-1], shift(0, 20), 1e-9)

    def test_a_motion_keeps_its_place_in_the_world_where_its_source_does(self):
        """Wherever a motion with a source is placed in the tree, its drawn path lies on the source."""
        wire = self.straight_wire()
        path = motion.motion_from_source(self.doc, "Curve", [wire])
        self.outer.Placement = turn(90, base=V(1, 2, 3))
        self.group.Placement = turn(30, V(1, 1, 1), V(0, 7, 0))
        self.recompute()
        for group in (self.group, self.outer):
            group.addObject(path)
            self.recompute()
            for frame in FRAMES:
                path.PoseType = frame
                self.recompute()
                base = base_of(
                    motion.world_poses_of(path), frame, App.Placement(), motion.container_of(path)
                )
                found = [p.multiply(base.inverse()) for p in motion.world_poses_of(path).placements]
                self.assert_placement(found[-1], shift(20), 1e-9)
            group.removeObject(path)
            self.recompute()
        self.assert_placement(path.Placements[-1], shift(20), 1e-9)

    def test_a_restored_document_goes_on(self):
        obj = self.envelope([self.part], self.path)
        self.group.addObject(obj)
        self.recompute()
        self.reopen()
        self.assertEqual([o.Name for o in self.doc.Objects if "Touched" in o.State], [])
        obj = self.doc.getObject("Envelope")
        self.recompute()
        self.assert_seen(obj, self.doc.getObject("Outer"))
        # A document with a circular dependency, as an older version could leave it.
        obj.MovingParts = [(self.doc.getObject("Group"), "Slide.")]
        self.reopen()
        self.recompute()
        self.assert_seen(self.doc.getObject("Envelope"), self.doc.getObject("Outer"))


class Computed(Case):
    NEEDS_CORE = True

    def test_moved_with_its_part_it_is_stale_and_computed_again(self):
        group, obj = self.grouped_envelope()
        group.addObject(obj)
        self.doc.recompute()
        self.assertEqual(obj.Status, envelope.UP_TO_DATE)
        group.Placement = shift(0, 50)
        self.doc.recompute()
        self.assertEqual(obj.Status, envelope.STALE)
        envelope.compute(obj)
        self.assertEqual(obj.Status, envelope.UP_TO_DATE)
        self.assert_placement(obj.getGlobalPlacement(), App.Placement())
        # FreeCAD gives the box in the coordinates of the group.
        self.assertAlmostEqual(obj.Mesh.BoundBox.YMin + 50, 50, delta=obj.UsedCellSize.Value)


class Rule(Case):
    """The rule: poses are in the coordinate system of the group that contains the motion, the part is
    where it is drawn, and the envelope is in world coordinates, whichever group contains it."""

    NEEDS_CORE = True

    def setUp(self):
        super().setUp()
        self.part = self.box()
        self.part.Placement = shift(0, 20)
        self.path = motion.motion_from_poses(
            self.doc, [0, 1], [shift(0, 20), turn(60, base=V(30, 25, 0))]
        )
        self.groups = []
        for k in range(2):  # the second inside the first
            group = self.doc.addObject("App::Part", "Level{}".format(k))
            if k:
                self.groups[-1].addObject(group)
            self.groups.append(group)
        self.other = self.doc.addObject("App::Part", "Other")
        self.doc.recompute()

    def move_groups(self):
        self.groups[0].Placement = turn(90, base=V(100, 0, 0))
        self.groups[1].Placement = turn(90, V(1, 0, 0), V(0, 50, 0))
        self.other.Placement = turn(-90, V(0, 1, 0), V(0, 0, 300))
        self.doc.recompute()

    def expected_box(self, frame, pair):
        """Returns the corners of the part at both poses, computed only from the definition of a
        coordinate system."""
        group = motion.container_of(self.path)
        standing = convert.global_placement(*pair)
        placements = self.path.Placements
        corners = convert.box_corners([pair])
        low, high = corners.min(axis=0) + 1e9, corners.max(axis=0) - 1e9
        for pose in placements:
            if frame == "Absolute":
                moved = group * pose * standing.inverse()
            elif frame == "Relative":
                moved = group * pose * group.inverse()
            else:
                moved = group * pose * placements[0].inverse() * group.inverse()
            points = convert.transform(convert.matrix_of(moved), corners)
            low = np.minimum(low, points.min(axis=0))
            high = np.maximum(high, points.max(axis=0))
        return low, high

    def assert_computed(self, obj, frame, pair):
        envelope.compute(obj)
        self.assertEqual(obj.Status, envelope.UP_TO_DATE)
        vertices = clearance_plan.envelope_arrays(obj)[0]
        low, high = self.expected_box(frame, pair)
        cell = obj.UsedCellSize.Value
        self.assertLess(abs(vertices.min(axis=0) - low).max(), cell)
        self.assertLess(abs(vertices.max(axis=0) - high).max(), cell)

    def test_each_combination(self):
        """Part, motion and envelope are each in the document, in a moved group, in a group inside it,
        or in another group."""
        places = [None, self.groups[0], self.groups[1], self.other]
        self.path.Interpolation = "None"
        obj = self.envelope([self.part], self.path, CellSize=2)
        self.move_groups()
        for k, combination in enumerate(itertools.product(places, repeat=3)):
            for member, group in zip((self.part, self.path, obj), combination):
                for old in containers.around(member)[:1]:
                    old.removeObject(member)
                if group is not None:
                    group.addObject(member)
            frame = FRAMES[k % 3]
            self.path.PoseType = frame
            self.doc.recompute()
            with self.subTest(groups=[g and g.Name for g in combination], frame=frame):
                self.assertNotEqual(obj.Status, envelope.UP_TO_DATE)
                pair = convert.root_path(self.part)
                self.assertEqual(convert.pairs_of(obj.MovingParts), [pair])
                self.assert_computed(obj, frame, pair)

    def test_through_a_link(self):
        link = self.doc.addObject("App::Link", "Copy")
        link.LinkedObject, link.Placement = self.groups[0], turn(45, base=V(0, -200, 0))
        self.groups[1].addObject(self.part)
        self.other.addObject(self.path)
        pair = (link, "Level1.Box.")
        self.path.Interpolation = "None"
        obj = self.envelope([pair], self.path, CellSize=2)
        for frame in FRAMES:
            self.path.PoseType = frame
            self.move_groups()
            self.assert_computed(obj, frame, pair)
            link.Placement = turn(45, base=V(0, -210, 0))
            self.doc.recompute()
            self.assertEqual(obj.Status, envelope.STALE)
            link.Placement = turn(45, base=V(0, -200, 0))
            self.doc.recompute()
            self.assertEqual(obj.Status, envelope.UP_TO_DATE)

    def test_a_moved_group_of_all_moves_the_result(self):
        for member in (self.part, self.path):
            self.groups[1].addObject(member)
        obj = self.envelope([self.part], self.path, Resolution=30)
        self.groups[1].addObject(obj)
        self.doc.recompute()
        envelope.compute(obj)
        volume = obj.Volume.Value
        self.groups[0].Placement = turn(90, base=V(100, 0, 0))
        self.doc.recompute()
        self.assertEqual(obj.Status, envelope.STALE)
        envelope.compute(obj)
        self.assertAlmostEqual(obj.Volume.Value, volume, delta=0.02 * volume)
        # The group is turned by 90 degrees, and so is the motion, which was along x.
        vertices = clearance_plan.envelope_arrays(obj)[0]
        self.assertGreater(float(np.ptp(vertices[:, 1])), float(np.ptp(vertices[:, 0])))
