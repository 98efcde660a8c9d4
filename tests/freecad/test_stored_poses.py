# SPDX-License-Identifier: LGPL-2.1-or-later
"""The poses of motions as arrays, which are kept as long as the numbers are the same. After each way to
change a motion, they equal the poses that FreeCAD gives one by one. Also: checks of mechanisms that read
them in pieces.
"""
import random
import struct

import FreeCAD as App
import numpy as np

from case import Case, V, shift, turn
from sweptvolume import contents, convert
from sweptvolume.convert import InputProblem
from sweptvolume.features import motion, stored_poses
from sweptvolume.features.base import whole
from sweptvolume.features.mechanism_plan import Plan
from table_case import changes, rows

CHANGES, change = changes()

VALUES = {"RequiredDistance": 5.0, "Accuracy": 0.01, "MeshDeflection": 0.05, "Range": 0.0}


def one_by_one(obj):
    """Returns the numbers of a motion as FreeCAD's own objects give them, without the stored arrays."""
    texts = [contents.digest(np.round(np.array(obj.Times, dtype=float), 9))]
    return texts + [contents.matrices([p.toMatrix().A for p in obj.Placements])]


@change
def nothing(doc):
    doc.recompute()


@change
def one_placement_in_its_last_digit(doc):
    places = doc.Motion.Placements
    place = places[2]
    place.Base = V(float(np.nextafter(place.Base.x, 1e9)), 0, 0)
    doc.Motion.Placements = places[:2] + [place]


@change
def one_turn(doc):
    doc.Motion.Placements = doc.Motion.Placements[:-1] + [turn(31, V(1, 2, 3))]


@change
def two_placements_change_places(doc):
    a, b, c = doc.Motion.Placements
    doc.Motion.Placements = [b, a, c]


@change
def one_pose_more(doc):
    motion.capture(doc.Motion, shift(7))


@change
def no_poses(doc):
    doc.Motion.Times, doc.Motion.Placements = [], []


@change
def other_times(doc):
    doc.Motion.Times = [0, 1, 5]


@change
def by_an_expression(doc):
    """Expressions set whole lists in FreeCAD, not single numbers of them."""
    place = "create(<<placement>>; create(<<vector>>; {}; 2; 3); create(<<rotation>>; 0; 0; 1; 0))"
    three = "; ".join(place.format(x) for x in (1, 5, 7))
    doc.Motion.setExpression("Placements", "list({})".format(three))
    doc.recompute()


@change
def its_pivot_by_an_expression(doc):
    doc.Motion.setExpression("Pivot.x", "3 mm + 4 mm")
    doc.recompute()


@change
def its_source_moves(doc):
    doc.Box.Placement = shift(0, 5)
    doc.recompute()


@change
def its_source_is_another(doc):
    doc.Linked.SourceObjects = [doc.Box, doc.Other, doc.Box]
    doc.recompute()


@change
def read_again(doc):
    doc.Box.Placement = shift(1, 2, 3)
    motion.reload_source(doc.Linked)


@change
def into_a_group_elsewhere(doc):
    group = doc.addObject("App::Part", "Group")
    group.Placement = shift(0, 0, 9)
    group.addObject(doc.Motion)
    doc.recompute()


@change
def deleted_and_made_again(doc):
    doc.removeObject("Motion")
    motion.motion_from_poses(doc, [0, 1, 2], [shift(5), shift(6), shift(8)])


@rows
class KeptPoses(Case):
    """The stored arrays after each change, its undo and its redo."""

    CHANGES = CHANGES

    def changed(self, name):
        motion.motion_from_poses(self.doc, [0, 1, 2], [shift(), turn(30, V(1, 2, 3)), shift(4)])
        boxes = [self.box("Box"), self.box("Other")]
        boxes[1].Placement = shift(9)
        linked = motion.motion_from_objects(self.doc, boxes)
        linked.Label = "Linked"
        self.doc.recompute()
        before = self.assert_stored()
        self.doc.openTransaction("a change")
        CHANGES[name](_ByLabel(self.doc, linked))
        same = name in ("nothing", "one_placement_in_its_last_digit")  # words() rounds the numbers
        self.assertEqual(self.assert_stored() == before, same)
        self.doc.commitTransaction()
        for step in (self.doc.undo, self.doc.redo, self.doc.undo):
            step()
            self.assert_stored()
        self.doc.recompute()
        self.assert_stored()

    def assert_stored(self):
        """Checks that the stored poses of all motions equal those that FreeCAD gives. Returns words() of each
        motion.
        """
        found = [obj for obj in self.doc.Objects if motion.is_motion(obj)]
        self.assertTrue(found)
        for obj in found:
            stored = stored_poses.of(obj)
            self.assertEqual(stored.words(), one_by_one(obj))
            translations, rotations = convert.pose_arrays(obj.Placements)
            self.assertTrue(np.array_equal(stored.translations, translations))
            self.assertTrue(np.array_equal(stored.rotations, rotations))
            self.assertEqual(stored.times.tolist(), list(obj.Times))
            if obj.Times:
                world = motion.world_poses_of(obj)
                for known, slow in zip(world.arrays(), convert.pose_arrays(world.placements)):
                    self.assertTrue(np.array_equal(known, slow))
        return [motion.words(obj) for obj in found]


class _ByLabel:
    """A document in which the attribute Linked is the given motion."""

    def __init__(self, doc, linked):
        self._doc, self.Linked = doc, linked

    def __getattr__(self, name):
        return getattr(self._doc, name)


class Reading(Case):
    def long_motion(self, count=3000):
        """Returns a motion whose archive has more than one block."""
        rng = random.Random(7)
        places = [
            App.Placement(
                V(*(rng.uniform(-900, 900) for _ in range(3))),
                App.Rotation(*(rng.gauss(0, 1) for _ in range(4))),
            )
            for _ in range(count)
        ]
        return motion.motion_from_poses(self.doc, range(count), places)

    def test_matrices_to_the_last_bit(self):
        places = self.long_motion().Placements
        slow = np.array([convert.matrix_of(p) for p in places])
        self.assertTrue(np.array_equal(convert.matrices_from(*convert.pose_arrays(places)), slow))

    def test_a_long_motion_is_known_again(self):
        obj = self.long_motion()
        stored = stored_poses.of(obj)
        self.assertIs(stored_poses.of(obj), stored)
        self.assertEqual(stored.words(), one_by_one(obj))

    def test_known_at_another_hour_and_not_with_other_bytes(self):
        """The archive contains the time at which it was made. This is ignored, and nothing else is."""
        obj = self.long_motion(50)
        stored = stored_poses.of(obj)
        packed = stored_poses._packed(obj)
        part = stored_poses._unpacked(packed)[0]
        head = packed[: part.start].rindex(b"PK\x03\x04")
        hour = struct.unpack_from("<HH", packed, head + 10)
        later = packed[: head + 10] + struct.pack("<HH", *(n ^ 33 for n in hour))
        later += packed[head + 14 :]
        self.assertNotEqual(later, packed)
        self.assertTrue(stored.is_of(obj.Times, later))
        for at in range(part.start, part.stop):
            other = packed[:at] + bytes([packed[at] ^ 1]) + packed[at + 1 :]
            self.assertFalse(stored.is_of(obj.Times, other), at)

    def test_a_freecad_that_writes_them_otherwise(self):
        obj = self.long_motion(20)
        usual = stored_poses.of(obj).words()
        packs = stored_poses._packed
        for text in (b"", b"no archive", b"PK\x05\x06" + bytes(18)):
            stored_poses._packed = lambda obj, text=text: text
            try:
                self.assertEqual(stored_poses.of(obj).words(), usual)
                obj.Times = [t + 1 for t in obj.Times]
                self.assertEqual(stored_poses.of(obj).words(), one_by_one(obj))
                obj.Times = [t - 1 for t in obj.Times]
            finally:
                stored_poses._packed = packs


class InPieces(Case):
    """Reads the request of a mechanism in pieces, as the window does between events."""

    def plan(self):
        pairs, motions = [], []
        for k in range(3):
            box = self.box("Box{}".format(k))
            box.Placement = shift(30 * k)
            pairs.append((box, ""))
            placements = [shift(30 * k), shift(30 * k, 5)]
            motions.append(motion.motion_from_poses(self.doc, [0, 1], placements))
        self.doc.recompute()
        plan = Plan(self.doc, pairs, motions, [], False, VALUES)
        plan.words()
        return plan

    def test_the_same_as_at_once(self):
        plan = self.plan()
        once, pieces = plan.request(), whole(plan.reading())
        for a, b in zip(once.rows(), pieces.rows()):
            self.assertEqual((a[0], a[4], a[5]), (b[0], b[4], b[5]))
            for x, y in zip((*a[1:3], *a[3]), (*b[1:3], *b[3])):
                self.assertTrue(np.array_equal(x, y))
        plan.check_unchanged()

    def test_a_change_between_two_pieces_is_told(self):
        def grow(doc):
            doc.Box1.Length = 11

        def go_elsewhere(doc):
            doc.Motion001.Placements = [shift(), shift(1)]

        def stand_elsewhere(doc):
            doc.Box2.Placement = shift(0, 0, 40)

        def jump(doc):
            doc.Motion.Interpolation = "Screw"

        for action in (grow, go_elsewhere, stand_elsewhere, jump):
            with self.subTest(action.__name__):
                plan = self.plan()
                reading = plan.reading()
                next(reading)
                next(reading)
                action(self.doc)
                self.doc.recompute()
                whole(reading)
                with self.assertRaisesRegex(InputProblem, "changed while its parts were read"):
                    plan.check_unchanged()
                for obj in list(self.doc.Objects):
                    self.doc.removeObject(obj.Name)
