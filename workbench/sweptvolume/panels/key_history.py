# SPDX-License-Identifier: LGPL-2.1-or-later
"""Undo and Redo inside the path editor: while it is open, their keys mean its keys, not the document's."""
import FreeCADGui as Gui
from PySide import QtCore, QtGui

from ..trajectory.edit import Keys
from .widgets import QtWidgets, actions_of

#: Steps that are kept: more than anybody goes back, and some megabytes with a thousand keys.
MOST_STEPS = 200
#: Qt 6 has it among what belongs to no widget.
_Shortcut = getattr(QtGui, "QShortcut", None) or QtWidgets.QShortcut


def copy_of(keys):
    rules = keys.step, keys.pivot, keys.displaces
    return Keys(keys.times, keys.placements, keys.tangents, *rules)


def content(keys):
    """What can be told apart: times, placements, tangents."""
    numbers = [tuple(p.toMatrix().A) for p in keys.placements]
    tangents = [(kind, tuple(v) if v is not None else ()) for kind, v in keys.tangents]
    return list(keys.times), numbers, tangents


class History:
    """States of the keys: what was before, what was undone."""

    def __init__(self, keys, row):
        self.now = copy_of(keys), row
        self.before, self.undone = [], []

    def note(self, keys, row):
        """A change is done; nothing happens if there is none."""
        if content(keys) == content(self.now[0]):
            self.now = self.now[0], row
            return
        self.before = (self.before + [self.now])[-MOST_STEPS:]
        self.undone = []
        self.now = copy_of(keys), row

    def step(self, back):
        """(keys, row) before the last change, or after the one undone last; None where there is none."""
        source, target = (self.before, self.undone) if back else (self.undone, self.before)
        if not source:
            return None
        target.append(self.now)
        self.now = source.pop()
        return copy_of(self.now[0]), self.now[1]


class UndoKeys(QtCore.QObject):
    """The keys of Undo and Redo call a function (back: True, False) until stop(): FreeCAD's own commands
    are without them meanwhile."""

    def __init__(self, step):
        window = Gui.getMainWindow()
        super().__init__(window)
        self.taken, self.keys = [], []
        for name, back in (("Std_Undo", True), ("Std_Redo", False)):
            for action in actions_of(name):
                self.taken.append((action, action.shortcuts()))
                action.setShortcuts([])
            standard = QtGui.QKeySequence.Undo if back else QtGui.QKeySequence.Redo
            for sequence in QtGui.QKeySequence.keyBindings(standard):
                key = _Shortcut(sequence, window)
                key.setContext(QtCore.Qt.ApplicationShortcut)
                key.activated.connect(lambda back=back: step(back))
                self.keys.append(key)

    def stop(self):
        for key in self.keys:
            key.setEnabled(False)
            key.deleteLater()
        for action, shortcuts in self.taken:
            action.setShortcuts(shortcuts)
        self.taken, self.keys = [], []
