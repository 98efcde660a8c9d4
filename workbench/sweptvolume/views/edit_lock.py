# SPDX-License-Identifier: LGPL-2.1-or-later
"""Keeps FreeCAD's own editors out of the 3D view while a panel of ours draws and drags there: its
Transform would show a second dragger, and since FreeCAD 1.1 leave the document in edit."""
import FreeCADGui as Gui
from PySide import QtCore


class EditLock:
    """Calls refuse() soon after anything begins to be edited in a document, until stop()."""

    def __init__(self, document, refuse):
        self.name, self.refuse = document.Name, refuse
        Gui.addDocumentObserver(self)

    def slotInEdit(self, view):  # noqa: N802
        if self.name and view.Object.Document.Name == self.name:
            # From the loop: FreeCAD is in the middle of opening it.
            QtCore.QTimer.singleShot(0, self._tell)

    def _tell(self):
        if self.name:
            self.refuse()

    def stop(self):
        if self.name:
            self.name = ""
            Gui.removeDocumentObserver(self)
