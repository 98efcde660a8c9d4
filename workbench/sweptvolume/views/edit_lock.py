# SPDX-License-Identifier: LGPL-2.1-or-later
"""Keeps FreeCAD's own editors out of the 3D view while a panel of this workbench draws and drags
there. FreeCAD's Transform would show a second dragger, and since FreeCAD 1.1 it would leave the
document in edit mode."""
import FreeCADGui as Gui
from PySide import QtCore


class EditLock:
    """Calls refuse() soon after FreeCAD starts to edit an object of a document, until stop()."""

    def __init__(self, document, refuse):
        self.name, self.refuse = document.Name, refuse
        Gui.addDocumentObserver(self)

    def slotInEdit(self, view):  # noqa: N802
        if self.name and view.Object.Document.Name == self.name:
            # Called later from the event loop, because FreeCAD has not finished opening the editor.
            QtCore.QTimer.singleShot(0, self._notify)

    def _notify(self):
        if self.name:
            self.refuse()

    def stop(self):
        if self.name:
            self.name = ""
            Gui.removeDocumentObserver(self)
