# SPDX-License-Identifier: LGPL-2.1-or-later
"""Tables of states in which inputs stand in another document, named Elsewhere."""
import FreeCAD as App

from sweptvolume.features.base import UP_TO_DATE
from table_case import Table


def elsewhere():
    """The other document."""
    return App.getDocument("Elsewhere")


class OtherDocumentTable(Table):
    """A change may be made in both documents. Subclasses make Elsewhere, with undo, in setUp()."""

    def results(self):
        return [obj for obj in super().results() if obj.Document is self.doc]

    def changed(self, name):
        """A change in one of both documents or in both, and its undo."""
        both = self.doc, elsewhere()
        before = [document.UndoCount for document in both]
        shown = [(o, o.Visibility) for document in both for o in document.Objects]
        for document in both:
            document.openTransaction(name)
        self.CHANGES[name](self.doc)
        for document in both:
            document.commitTransaction()
        self.recomputed()
        self.look(name)
        for document, count in reversed(
            list(zip(both, before))
        ):  # links come back to what is there
            while document.UndoCount > count:
                document.undo()
        for obj, visible in shown:
            obj.Visibility = visible
        self.recomputed()
        self.look(name + ", undone")
        if "expression" not in name:
            self.assertEqual(self.behind(), {})

    def recomputed(self):
        elsewhere().recompute()
        self.doc.recompute()

    def behind(self):
        return {o.Name: (o.Status, o.Message) for o in self.results() if o.Status != UP_TO_DATE}
