# SPDX-License-Identifier: LGPL-2.1-or-later
"""States of paths, of checks and envelopes along them, and of the records of what made each triangle. After
each change of the table, a result may be up to date only if a fresh computation gives the same result.
"""
from case import V, shift, turn
from sweptvolume.features import clearance, envelope, made_by, path_plan
from sweptvolume.features.base import UP_TO_DATE, kind_of
from sweptvolume.trajectory.poses import Poses
from table_case import Table, add_box, changes, put_into, rows

#: name -> what a user does to the document of Paths.setUp().
CHANGES, change = changes()


@change
def nothing_is_remembered(doc):
    doc.Envelope.MadeBy = "Off"


@change
def remembered_for_the_session(doc):
    doc.Envelope.MadeBy = "Session"


@change
def a_stop_of_the_path_moves(doc):
    doc.Motion.Placements = [shift(), shift(15, 1), turn(30, base=V(20, 0, 0))]


@change
def the_path_turns_about_another_point(doc):
    doc.Motion.Pivot = V(0, 0, 5)


@change
def the_path_is_smooth(doc):
    doc.Motion.Interpolation = "Spline"


@change
def the_path_goes(doc):
    doc.removeObject("Motion")


@change
def the_part_stands_elsewhere(doc):
    doc.Box.Placement = shift(0, 3)


@change
def the_wall_comes_nearer(doc):
    doc.Wall.Placement = shift(50)


@change
def the_wall_is_hidden(doc):
    doc.Wall.Visibility = False


@change
def another_wall_is_chosen(doc):
    doc.Clearance.Neighbours = [(add_box(doc, "Other", shift(0, 40)), "")]


@change
def the_part_has_another_name(doc):
    doc.Box.Label = "Slider"


@change
def the_part_is_in_a_group(doc):
    put_into(doc.addObject("App::Part", "Group"), doc.Box, shift())


@change
def the_part_leaves_its_group(doc):
    doc.Frame.removeObject(doc.Inner)


@change
def the_path_is_a_copy_of_it(doc):
    doc.Envelope.Motion = doc.copyObject(doc.Motion)


@change
def a_copy_takes_the_place_of_the_path(doc):
    doc.Envelope.Motion = doc.Clearance.Motion = doc.copyObject(doc.Motion)
    doc.removeObject("Motion")


@change
def the_wall_goes(doc):
    doc.removeObject("Wall")


@rows
class Paths(Table):
    CHANGES = CHANGES

    def setUp(self):
        super().setUp()
        doc = self.doc
        box, wall = self.box(), self.box("Wall")
        wall.Placement = shift(60)
        # As a search writes it: poses of the middle of the part, relative to the document.
        poses = Poses([0, 1, 2], [shift(), shift(15), turn(30, base=V(20, 0, 0))], pivot=V(5, 5, 5))
        path_plan.make(doc, [(box, "")], poses)
        frame, inner = doc.addObject("App::Part", "Frame"), self.box("Inner", 4)
        frame.addObject(inner)
        inner.Placement = shift(0, 14)
        self.envelope([box, inner], doc.Motion, Resolution=16, MadeBy="Document")
        clearance.make_clearance(
            doc,
            MovingParts=[(box, "")],
            Motion=doc.Motion,
            AllVisible=False,
            Neighbours=[(wall, "")],
        )
        doc.recompute()
        envelope.compute(doc.Envelope)
        clearance.compute(doc.Clearance)
        doc.recompute()

    def content(self, obj):
        found = super().content(obj)
        if kind_of(obj) == envelope.Envelope.KIND and obj.MadeBy != "Off":
            record = made_by.find(obj)
            found += [record.kind.tolist(), record.faces.tolist(), record.time.round(6).tolist()]
            found += [sorted(part.items()) for part in record.parts]
            found.append(made_by.text_of(record.answer(int(record.kind.argmax()))))
        return found

    def test_records_follow_results_through_undo(self):
        self.doc.openTransaction("Grow")
        self.doc.Box.Length = 11
        self.doc.commitTransaction()
        self.doc.recompute()
        envelope.compute(self.doc.Envelope)
        self.check_states("grown")
        for k in range(2):
            self.doc.undo()
            self.doc.recompute()
            self.check_states("undone {}".format(k))
        self.assertEqual({o.Status for o in self.results()}, {UP_TO_DATE})
