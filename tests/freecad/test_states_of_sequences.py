# SPDX-License-Identifier: LGPL-2.1-or-later
"""States of sequences after each change of a part, a neighbour, a motion or a rule. A sequence may
be up to date only if a fresh check of its motions gives the same result. The names in its messages,
the order, and the times at which its parts are played must be those of the document.
"""
import FreeCAD as App

from case import shift
from sequence_changes import CHANGES
from shaft import plan_of, shaft, stack
from sweptvolume import core
from sweptvolume.features import envelope, sequence
from sweptvolume.features.base import FAILED, STALE, UP_TO_DATE
from table_case import Table, add_box, hidden_link, rows


@rows
class States(Table):
    CHANGES = CHANGES

    def setUp(self):
        super().setUp()
        doc = self.doc
        walls, parts = shaft(doc), stack(doc)
        hidden_link(doc, "Link", doc.Upper)
        hidden_link(doc, "WallLink", doc.West)
        self.sheet("gap", "0.6 mm")
        other = add_box(doc, "Other", shift(40, 40))
        other.setExpression("Length", "Values.gap * 10")
        self.envelope([other], self.line(12), Resolution=12)
        doc.recompute()
        _, obj = sequence.find(plan_of(doc, parts, walls, Order="find"))
        envelope.compute(doc.Envelope)
        sequence.compute(obj)
        doc.recompute()

    def results(self):
        """Tests the sequence only; its neighbours have tables of their own."""
        return [obj for obj in super().results() if sequence.is_sequence(obj)]

    def content(self, obj):
        """Returns the messages, which contain names, and the position of each part during playback."""
        plan = sequence.Plan.of(obj)
        places = []
        if plan.steps:
            for time in (0.0, plan.steps[0]["end"], plan.steps[-1]["end"]):
                for _, course in plan.seen():
                    places.append([round(x, 4) + 0.0 for x in course(time).Base])
        text = sequence.description(sequence.report_of(obj))
        return super().content(obj) + [obj.Summary, text, places]

    def test_nothing_changes_nothing(self):
        self.assertEqual({o.Status for o in self.results()}, {UP_TO_DATE})
        self.check_states("nothing")

    def test_names_count_at_once(self):
        """FreeCAD does not recompute after this change. Messages must use the new name of a neighbour
        all the same."""
        obj = self.doc.Sequence
        self.doc.Upper.Label = "Lid"
        self.assertIn("Lower, Lid", obj.Summary)
        self.assertEqual([s["part"] for s in sequence.report_of(obj)["steps"]], ["Lower", "Lid"])
        begins = [step["begin"] for step in sequence.Plan.of(obj).steps]
        lid = sequence.Plan.of(obj).seen()[1][1]
        self.assertGreater(
            (lid(begins[1]).Base - lid(obj.Motions[1].Times[-1] + begins[1]).Base).Length, 50
        )
        obj.MovingParts = [(self.doc.Upper, ""), (self.doc.Lower, "")]
        obj.Motions = list(reversed(obj.Motions))
        self.doc.recompute()
        self.assertEqual((obj.Status, sequence.Plan.of(obj).steps), (STALE, []))
        sequence.compute(obj)
        self.doc.Upper.Label = "Cover"
        self.assertIn(
            'blocked by "Cover" after 5.5 mm', sequence.description(sequence.report_of(obj))
        )

    def test_saved_and_opened(self):
        before = self.content(self.doc.Sequence)
        self.reopen()
        self.doc.recompute(None, True)
        self.assertEqual(self.content(self.doc.Sequence), before)
        self.assertEqual(self.doc.Sequence.Status, UP_TO_DATE)

    def test_a_wall_of_another_document(self):
        there = App.newDocument("Elsewhere")
        wall = add_box(there, "Wall", shift())
        wall.Length, wall.Width, wall.Height = 3, 26, 40
        there.recompute()
        there.saveAs(self.folder + "/elsewhere.FCStd")
        self.doc.saveAs(self.folder + "/here.FCStd")
        link = self.doc.addObject("App::Link", "Link")
        link.LinkedObject, link.Placement = wall, self.doc.West.Placement
        obj = self.doc.Sequence
        kept = [pair for pair in obj.Neighbours if pair[0].Name != "West"]
        obj.Neighbours = kept + [(link, "")]
        self.doc.recompute()
        sequence.compute(obj)
        self.check_states("a wall of another document")
        wall.Length = 3.3
        there.recompute()
        self.doc.recompute()
        self.assertEqual(obj.Status, STALE)
        self.check_states("it has grown there")
        there.undo()
        wall.Length = 3
        there.recompute()
        self.doc.recompute()
        self.assertEqual(obj.Status, UP_TO_DATE)
        App.closeDocument("Elsewhere")
        self.doc.recompute()
        self.assertEqual(obj.Status, FAILED)
        self.assertTrue(obj.Message)

    def test_failures_are_kept(self):
        obj = self.doc.Sequence
        self.doc.Upper.Placement.Base.z -= 3
        for path in obj.Motions:
            path.Placements = [p for p in path.Placements]
        obj.Motions[1].Placements = obj.Motions[1].Placements[:-1] + [self.doc.Upper.Placement]
        self.doc.recompute()
        self.assertEqual(obj.Status, STALE)
        with self.assertRaises(core.CoreError):
            sequence.compute(obj)
        self.assertEqual(obj.Status, FAILED)
        self.assertIn("Upper", obj.Message)
