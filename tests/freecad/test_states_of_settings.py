# SPDX-License-Identifier: LGPL-2.1-or-later
"""States after each change of a setting of envelopes, solids and checks: by hand, by an expression and by
Undo, with parts shown and hidden. Once with one motion, and once with a motion for each part, whose
envelopes are joined.
"""
from case import Case, shift, turn
from sweptvolume import core
from sweptvolume.features import clearance, envelope, motion, solid
from table_case import Table, add_box, changes, put_into, rows

CHANGES, change = changes()
#: Property of both envelopes -> another value.
SETTINGS = {
    "Accuracy": 1.5,
    "CellSize": 0.9,
    "Resolution": 26,
    "MeshDeflection": 0.5,
    "Tolerance": 0.6,
    "Offset": 0.7,
    "Conservative": True,
    "KeepCavities": True,
    "PositionFilter": 40.0,
    "Components": "DualContouring",
    "MadeBy": "Off",
}


def _setting(name, value):
    def action(doc):
        for obj in (doc.Envelope, doc.Envelope001):
            setattr(obj, name, value)

    action.__name__ = "setting_" + name
    change(action)


for _name, _value in SETTINGS.items():
    _setting(_name, _value)


@change
def accuracy_by_expression(doc):
    doc.Envelope001.setExpression("Accuracy", "Values.length / 4")
    doc.Envelope.setExpression("Accuracy", "Values.length / 4")


@change
def accuracy_in_place_of_what_was_typed(doc):
    """Resolution and tolerance have no effect if there is an accuracy."""
    for obj in (doc.Envelope, doc.Envelope001):
        obj.Accuracy, obj.Resolution, obj.Tolerance, obj.CellSize = 1.5, 999, 5, 3


@change
def tolerance_by_expression(doc):
    doc.Envelope001.setExpression("Tolerance", "Values.length / 10")


@change
def value_of_nothing(doc):
    doc.Values.set("A1", "8 mm")


@change
def motions_swapped(doc):
    doc.Envelope001.Motions = [doc.Motion001, doc.Motion]


@change
def only_one_motion(doc):
    doc.Envelope001.Motions = []


@change
def same_motion_for_both(doc):
    doc.Envelope001.Motions = [doc.Motion, doc.Motion]


@change
def one_motion_too_few(doc):
    doc.Envelope001.Motions = [doc.Motion]


@change
def second_motion_is_deleted(doc):
    doc.removeObject("Motion001")


@change
def second_motion_has_one_pose(doc):
    doc.Motion001.Placements, doc.Motion001.Times = [shift()], [0]


@change
def second_motion_turns(doc):
    doc.Motion001.Placements = [shift(), turn(50, base=doc.Motion001.Placements[1].Base)]


@change
def second_part_into_a_group(doc):
    put_into(doc.Group, doc.Second, shift(0, 0, 2))


@change
def moving_part_is_hidden(doc):
    doc.Box.Visibility = False


@change
def group_is_hidden(doc):
    doc.Group.Visibility = False


@change
def link_is_hidden(doc):
    doc.Link.Visibility = False


@change
def motion_is_hidden(doc):
    doc.Motion.Visibility = False


@change
def placement_by_expression(doc):
    doc.Wall.setExpression("Placement.Base.x", "Values.length * 9")


@change
def link_placed_by_expression(doc):
    doc.Link.setExpression("Placement.Base.y", "Values.length * -7")


@change
def names_of_motions(doc):
    doc.Motion.Label, doc.Motion001.Label = "To and fro", "Lift"


@change
def solid_is_coarser(doc):
    doc.EnvelopeSolid.Tolerance = 0.9


@change
def solid_by_expression(doc):
    doc.EnvelopeSolid.setExpression("Tolerance", "Values.length / 9")


@change
def solid_has_few_faces(doc):
    doc.EnvelopeSolid.MaxFaces = 40


@change
def check_measures_less_exactly(doc):
    doc.Clearance.Accuracy = 0.4


@change
def check_by_expression(doc):
    doc.Clearance.setExpression("RequiredDistance", "Values.length * 2")


@change
def check_of_joined_envelope(doc):
    doc.Clearance.Envelope = doc.Envelope001


@rows
class Settings(Table):
    CHANGES = CHANGES

    def setUp(self):
        super().setUp()
        doc = self.doc
        box, second = self.box(size=6), self.box("Second", 5)
        second.Placement = shift(0, 3, 0)
        add_box(doc, "Wall", shift(60))
        group, inner = doc.addObject("App::Part", "Group"), self.box("Inner", 2)
        group.addObject(inner)
        inner.Placement = shift(0, -20)
        link = doc.addObject("App::Link", "Link")
        link.LinkedObject, link.Placement = inner, shift(0, -30)
        self.sheet("length", "6 mm")
        along, up = (
            motion.motion_from_poses(doc, [0, 1], [shift(), end])
            for end in (shift(18), shift(0, 4, 15))
        )
        doc.recompute()
        self.envelope([box], along, Resolution=20, MadeBy="Session")
        joined = self.envelope([box, second], along, Resolution=20, Tolerance=0.2, MadeBy="Session")
        joined.Motions = [along, up]
        solid.make_solid(doc, doc.Envelope)
        clearance.make_clearance(doc, MovingParts=[(box, "")], Motion=along)
        doc.recompute()
        for obj in self.results():
            self.modules()[obj.Proxy.KIND].compute(obj)
        doc.recompute()


class OneAndTwo(Case):
    """Cases that the table cannot contain, since it makes one change at a time."""

    NEEDS_CORE = True

    def test_what_counts_beside_an_accuracy(self):
        obj = self.envelope([self.box()], self.line(), Accuracy=2)
        envelope.compute(obj)
        for name, value in (("Resolution", 99), ("Tolerance", 3), ("CellSize", 0.7)):
            setattr(obj, name, value)
            self.doc.recompute()
            self.assertEqual(obj.Status, envelope.UP_TO_DATE, name)
        obj.Accuracy = 0
        self.doc.recompute()
        self.assertEqual(obj.Status, envelope.STALE)

    def test_an_accuracy_needs_no_core_to_be_compared(self):
        obj = self.envelope([self.box()], self.line(), Accuracy=2)
        envelope.compute(obj)
        module, core._module = core._module, None
        find, core.core_search.find = core.core_search.find, lambda: (None, [])
        try:
            self.doc.recompute(None, True)
            self.assertEqual(obj.Status, envelope.UP_TO_DATE, obj.Message)
        finally:
            core._module, core.core_search.find = module, find
