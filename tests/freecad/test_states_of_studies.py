# SPDX-License-Identifier: LGPL-2.1-or-later
"""States of studies. After each change of an input, in the document or in a file, a study may be up to date
only if a fresh computation gives the same result.
"""
import os
import shutil

import Mesh
import Part

from case import Case, V, shift, turn
from sweptvolume import core
from sweptvolume.convert import InputProblem
from sweptvolume.features import clearance, mechanism, motion, neighbour_rules, study
from sweptvolume.features.base import FAILED, STALE, UP_TO_DATE
from sweptvolume.features.neighbour_rules import CONTACT, Rule
from table_case import Table, changes, hidden_link, put_into, rows

CHANGES, change = changes()


@change
def part_grows(doc):
    doc.Box.Length = 12


@change
def wall_moves(doc):
    doc.Wall.Placement = shift(55)


@change
def wall_is_gone(doc):
    doc.removeObject("Wall")


@change
def motion_goes_farther(doc):
    doc.Motion.Placements = [shift(), shift(33)]


@change
def motion_between_poses(doc):
    doc.Motion.Placements = [shift(), turn(90, base=shift(20).Base)]
    doc.Motion.Interpolation = "Screw"


@change
def check_asks_for_more(doc):
    doc.Clearance.RequiredDistance = 25


@change
def check_has_another_rule(doc):
    neighbour_rules.write(doc.Clearance, {(doc.Wall, ""): Rule(CONTACT)})


@change
def check_sees_all(doc):
    doc.Clearance.AllVisible = True


@change
def envelope_is_finer(doc):
    doc.Envelope.Resolution = 20


@change
def envelope_is_grown(doc):
    doc.Envelope.Offset = 1.0


@change
def envelope_is_no_source(doc):
    doc.Study.Sources = [doc.Clearance]


@change
def the_other_way_round(doc):
    doc.Study.Sources = [doc.Envelope, doc.Clearance]


@change
def more_jobs(doc):
    doc.Study.Jobs = 2


@change
def a_source_is_gone(doc):
    doc.removeObject("Clearance")


@change
def no_source(doc):
    doc.Study.Sources = []


@change
def a_part_is_a_source(doc):
    doc.Study.Sources = [doc.Box]


# --- names, containers, links, expressions


@change
def the_wall_has_another_name(doc):
    doc.Wall.Label = "Gate"


@change
def wall_and_post_exchange_their_names(doc):
    doc.Wall.Label, doc.Post.Label = "Name", "Wall"
    doc.Wall.Label = "Post"


@change
def the_part_has_another_name(doc):
    doc.Box.Label = "Slider"


@change
def the_motion_has_another_name(doc):
    doc.Motion.Label = "There"


@change
def a_source_has_another_name(doc):
    doc.Clearance.Label = "First"


@change
def what_is_no_input_has_another_name(doc):
    doc.Values.Label = "Numbers"


@change
def the_wall_is_in_a_group_that_stands_elsewhere(doc):
    put_into(doc.addObject("App::Part", "Group"), doc.Wall)


@change
def the_part_is_in_a_group_with_all(doc):
    group = doc.addObject("App::Part", "Group")
    put_into(group, doc.Box, shift())
    group.addObject(doc.Motion)


@change
def the_wall_is_hidden(doc):
    doc.Wall.Visibility = False


@change
def the_post_is_hidden_and_all_that_is_visible_checked(doc):
    doc.Clearance.AllVisible, doc.Post.Visibility = True, False


@change
def the_wall_is_a_link(doc):
    doc.Link.Placement = shift(50)
    doc.Clearance.Neighbours = [(doc.Link, "")]


@change
def required_by_an_expression(doc):
    doc.Clearance.setExpression("RequiredDistance", "Values.length")


@change
def a_value_of_an_expression(doc):
    doc.Values.set("A1", "9 mm")


@change
def another_motion(doc):
    doc.Clearance.Motion = motion.motion_from_poses(doc, [0, 1], [shift(), shift(40)])


@change
def the_motion_is_gone(doc):
    doc.removeObject("Motion")


@change
def a_mechanism_is_a_source(doc):
    doc.Study.Sources = [mechanism.make_mechanism(doc)]


@change
def one_source_twice(doc):
    doc.Study.Sources = [doc.Clearance, doc.Clearance]


@change
def the_other_envelope(doc):
    doc.Study.Sources = [doc.Clearance, doc.Envelope001]


@rows
class OfADocument(Table):
    CHANGES = CHANGES

    def setUp(self):
        super().setUp()
        doc = self.doc
        box, wall, post = self.box(), self.box("Wall"), self.box("Post")
        wall.Placement, post.Placement = shift(60), shift(0, 25)
        hidden_link(doc, "Link", wall)
        self.sheet("length", "6 mm")
        self.line(30)
        self.envelope([box], doc.Motion, Resolution=16)
        clearance.make_clearance(
            doc,
            MovingParts=[(box, "")],
            Motion=doc.Motion,
            Neighbours=[(wall, ""), (post, "")],
            AllVisible=False,
            RequiredDistance=5.0,
        )
        self.envelope([wall], doc.Motion, Resolution=10)
        doc.Envelope001.setExpression("CellSize", "Values.length / 2")
        study.make_study(
            doc,
            Sources=[doc.Clearance, doc.Envelope],
            Folder=os.path.join(self.folder, "study"),
            Jobs=1,
        )
        doc.recompute()
        study.compute(doc.Study)
        doc.recompute()

    def results(self):
        """Tests the study only; its inputs have tables of their own."""
        return [obj for obj in super().results() if study.is_study(obj)]

    def check_states(self, name):
        """A page describes the present document, or there is none."""
        super().check_states(name)
        with self.subTest(change=name):
            if self.doc.Study.Status == UP_TO_DATE:
                self.assertEqual(study.written(self.doc.Study)[1], self.doc.Study.Results)
            else:
                with self.assertRaisesRegex(InputProblem, "up to date"):
                    study.written(self.doc.Study)

    def test_a_page_of_results_that_are_gone(self):
        shutil.rmtree(self.doc.Study.Results)
        with self.assertRaisesRegex(InputProblem, "cannot be found"):
            study.written(self.doc.Study)

    def test_nothing_changes_nothing(self):
        self.assertEqual({o.Status for o in self.results()}, {UP_TO_DATE})
        self.check_states("nothing")
        self.doc.Study.Label = "Another name"
        self.doc.recompute()
        self.check_states("label of the study")
        self.assertEqual(self.doc.Study.Status, UP_TO_DATE)


def box_file(path, size, place=V()):
    Mesh.Mesh(Part.makeBox(size, 10, 10, place).tessellate(1)).write(path)


def motion_text(travel):
    return "0,0,0,0,0,0,0,1\n1,{},0,0,0,0,0,1\n".format(travel)


class OfAFile(Case):
    """Changes of the files that a study file names."""

    NEEDS_CORE = True
    TEXT = """
[study]
name = "boxes"
[defaults]
part = "box.ply"
neighbours = ["wall.ply"]
compute = ["clearance"]
[[run]]
name = "near"
motion = "near.csv"
"""

    def setUp(self):
        super().setUp()
        box_file(self.at("box.ply"), 10)
        box_file(self.at("wall.ply"), 10, V(43, 0, 0))
        for name, travel in (("near", 30), ("other", 31)):
            self.file(name + ".csv", motion_text(travel))
        self.obj = study.make_study(self.doc, File=self.file("study.toml", self.TEXT))
        self.doc.recompute()
        study.compute(self.obj)
        self.doc.recompute()
        self.assertEqual(self.obj.Status, UP_TO_DATE, self.obj.Message)

    def at(self, name):
        return os.path.join(self.folder, name)

    def checked_status(self):
        """Returns the state after a check of the files. FreeCAD itself does not notice changed files."""
        study.update_status(self.obj)
        return self.obj.Status

    def fresh(self):
        """Returns the rows of a new object for the same file; None if it is refused."""
        other = study.make_study(self.doc, File=self.obj.File, Folder=self.at("fresh"))
        self.doc.recompute()
        try:
            study.compute(other)
        except (InputProblem, core.CoreError):
            return None
        return [(r["run"], r["state"], r.get("distance")) for r in study.report_of(other)["runs"]]

    def test_every_file(self):
        """After a change of a file the study is not up to date. After the change is reversed, it is
        again."""
        text = self.TEXT
        for name, change, refused in (
            ("near.csv", lambda path: self.file("near.csv", motion_text(33)), False),
            ("wall.ply", lambda path: box_file(path, 10, V(50, 0, 0)), False),
            ("box.ply", lambda path: box_file(path, 12), False),
            ("near.csv", os.remove, True),
            ("wall.ply", os.remove, True),
            ("study.toml", lambda path: self.file("study.toml", text + "extra = 1\n"), True),
            ("study.toml", os.remove, True),
            (
                "study.toml",
                lambda path: self.file("study.toml", text.replace("near.csv", "other.csv")),
                False,
            ),
            (
                "study.toml",
                lambda path: self.file(
                    "study.toml", text + "[defaults.clearance]\nrequired = 20\n"
                ),
                False,
            ),
        ):
            with self.subTest(name=name, refused=refused):
                kept = self.at("kept")
                shutil.copy2(self.at(name), kept)
                change(self.at(name))
                self.assertEqual(self.checked_status(), FAILED if refused else STALE)
                self.assertEqual(bool(self.obj.Message), refused)
                self.assertEqual(self.fresh() is None, refused)
                os.replace(kept, self.at(name))
                self.assertEqual(self.checked_status(), UP_TO_DATE)

    def test_files_that_no_run_names_and_names_of_objects(self):
        self.file("other.csv", motion_text(40))
        self.obj.Label = "Another name"
        self.assertEqual(self.checked_status(), UP_TO_DATE)
        self.obj.Jobs = 2
        self.assertEqual(self.checked_status(), UP_TO_DATE)

    def test_the_folder_moves_as_a_whole(self):
        moved = self.at("moved")
        os.mkdir(moved)
        for name in ("study.toml", "box.ply", "wall.ply", "near.csv"):
            shutil.move(self.at(name), moved)
        self.assertEqual(self.checked_status(), FAILED)
        self.obj.File = os.path.join(moved, "study.toml")
        self.assertEqual(self.checked_status(), UP_TO_DATE)
