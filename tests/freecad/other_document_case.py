# SPDX-License-Identifier: LGPL-2.1-or-later
"""Shared by the tables of changes in which the inputs are in another document, named Elsewhere."""
import FreeCAD as App

from case import shift
from sweptvolume.features.base import UP_TO_DATE
from table_case import Table, add_box, changes


def elsewhere():
    """Returns the other document."""
    return App.getDocument("Elsewhere")


#: Changes that every table makes. Elsewhere has a Part, a Wall, Values, and a Group of Inner and Second;
#: this document has a PartLink to the part, and a Box.
COMMON_CHANGES, change = changes()


@change
def the_part_grows(doc):
    elsewhere().Part.Length = 12


@change
def the_part_is_hidden_there(doc):
    elsewhere().Part.Visibility = False


@change
def the_part_is_deleted_there(doc):
    elsewhere().removeObject("Part")


@change
def the_group_gets_a_part(doc):
    other = elsewhere()
    other.Group.addObject(add_box(other, "More", shift(0, -60)))


@change
def the_group_loses_a_part(doc):
    elsewhere().Group.removeObject(elsewhere().Second)


@change
def a_part_of_the_group_moves(doc):
    elsewhere().Inner.Placement = shift(0, -23)


@change
def a_part_of_the_group_is_hidden(doc):
    elsewhere().Second.Visibility = False


@change
def the_value_changes(doc):
    elsewhere().Values.set("A1", "8 mm")


@change
def the_link_moves(doc):
    doc.PartLink.Placement = shift(0, 3)


@change
def the_link_shows_another_part(doc):
    doc.PartLink.LinkedObject = elsewhere().Wall


@change
def the_link_shows_a_part_of_this_document(doc):
    doc.PartLink.LinkedObject = doc.Box


@change
def the_link_shows_nothing(doc):
    doc.PartLink.LinkedObject = None


@change
def the_link_is_deleted(doc):
    doc.removeObject("PartLink")


class OtherDocumentTable(Table):
    """A table whose changes may affect both documents. Subclasses create the document Elsewhere, with undo,
    in setUp().
    """

    def results(self):
        return [obj for obj in super().results() if obj.Document is self.doc]

    def changed(self, name):
        """Makes a change in one or both documents, and undoes it."""
        both = self.doc, elsewhere()
        before = [document.UndoCount for document in both]
        shown = [(o, o.Visibility) for document in both for o in document.Objects]
        for document in both:
            document.openTransaction(name)
        self.CHANGES[name](self.doc)
        for document in both:
            document.commitTransaction()
        self.recomputed()
        self.check_states(name)
        # First the other document, so that restored links find their objects.
        for document, count in reversed(list(zip(both, before))):
            while document.UndoCount > count:
                document.undo()
        for obj, visible in shown:
            obj.Visibility = visible
        self.recomputed()
        self.check_states(name + ", undone")
        if "expression" not in name:
            self.assertEqual(self.behind(), {})

    def recomputed(self):
        elsewhere().recompute()
        self.doc.recompute()

    def behind(self):
        return {o.Name: (o.Status, o.Message) for o in self.results() if o.Status != UP_TO_DATE}
