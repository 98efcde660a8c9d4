# SPDX-License-Identifier: LGPL-2.1-or-later
"""Undo and Redo in the motion editor. While the editor is open, both commands change the keys of
the motion, not the document."""
import FreeCADGui as Gui
from PySide import QtCore, QtGui

from ..texts import translate
from ..trajectory.edit import Keys
from .widgets import Action, QtWidgets, actions_of, shiboken

#: Number of steps that are kept: enough for any use, and some megabytes with a thousand keys.
MOST_STEPS = 200
#: In Qt 6, QShortcut is in QtGui.
_Shortcut = getattr(QtGui, "QShortcut", None) or QtWidgets.QShortcut


def copy_of(keys):
    rules = keys.step, keys.pivot, keys.displaces
    return Keys(keys.times, keys.placements, keys.tangents, *rules)


def content(keys):
    """Returns what can differ between two states of the keys: times, placements, tangents."""
    numbers = [tuple(p.toMatrix().A) for p in keys.placements]
    tangents = [(kind, tuple(v) if v is not None else ()) for kind, v in keys.tangents]
    return list(keys.times), numbers, tangents


class History:
    """Earlier states of the keys, and states that were undone."""

    def __init__(self, keys, row):
        self.now = copy_of(keys), row
        self.before, self.undone = [], []

    def note(self, keys, row):
        """Stores a change of the keys. If they have not changed, stores only the current row."""
        if content(keys) == content(self.now[0]):
            self.now = self.now[0], row
            return
        self.before = (self.before + [self.now])[-MOST_STEPS:]
        self.undone = []
        self.now = copy_of(keys), row

    def step(self, back):
        """Returns (keys, row) of the state before the last change (back), or of the state undone
        last, or None."""
        source, target = (self.before, self.undone) if back else (self.undone, self.before)
        if not source:
            return None
        target.append(self.now)
        self.now = source.pop()
        return copy_of(self.now[0]), self.now[1]


class UndoKeys(QtCore.QObject):
    """Makes Undo and Redo of keyboard, menu and toolbar call a function (argument back: True or
    False) until stop(). Until then, FreeCAD's own entries are hidden and have no shortcuts."""

    def __init__(self, step):
        window = Gui.getMainWindow()
        super().__init__(window)
        self.taken, self.keys, self.hidden, self.ours = [], [], [], {}
        for name, back in (("Std_Undo", True), ("Std_Redo", False)):
            standard = QtGui.QKeySequence.Undo if back else QtGui.QKeySequence.Redo
            sequences = QtGui.QKeySequence.keyBindings(standard)
            for action in actions_of(name):
                self.taken.append((action, action.shortcuts()))
                # Users may have chosen other shortcuts in FreeCAD's preferences.
                sequences += [s for s in action.shortcuts() if s not in sequences]
                action.setShortcuts([])
            self._replace(name, back, step)
            for sequence in sequences:
                key = _Shortcut(sequence, window)
                key.setContext(QtCore.Qt.ApplicationShortcut)
                key.activated.connect(lambda back=back: step(back))
                self.keys.append(key)

    def _replace(self, name, back, step):
        """Replaces FreeCAD's entry in menus and toolbars by an entry of this workbench. FreeCAD's
        entry in a toolbar has no object name, so entries are found by their text."""
        texts = {action.text() for action in actions_of(name)}
        window = self.parent()
        for holder in window.findChildren(QtWidgets.QToolBar) + window.findChildren(
            QtWidgets.QMenu
        ):
            for action in holder.actions():
                if action.text() in texts and action not in self.ours.values():
                    ours = self._entry(action, back, step)
                    holder.insertAction(action, ours)
                    action.setVisible(False)
                    self.hidden.append((holder, action, ours))

    def _entry(self, action, back, step):
        if back not in self.ours:
            ours = Action(action.icon(), action.text(), self)
            ours.setObjectName("SweptVolumeUndo" if back else "SweptVolumeRedo")
            tip = translate("SweptVolume", "The last change of the keys")
            ours.setToolTip("{} ({})".format(action.text().replace("&", ""), tip))
            ours.triggered.connect(lambda *ignored: step(back))
            self.ours[back] = ours
        return self.ours[back]

    def show(self, history):
        """Enables Undo and Redo depending on the history."""
        for back, steps in ((True, history.before), (False, history.undone)):
            if back in self.ours:
                self.ours[back].setEnabled(bool(steps))

    def stop(self):
        for key in self.keys:
            key.setEnabled(False)
            key.deleteLater()
        for action, shortcuts in self.taken:
            action.setShortcuts(shortcuts)
        for holder, action, ours in self.hidden:
            if shiboken.isValid(holder) and shiboken.isValid(
                action
            ):  # another workbench may be active
                holder.removeAction(ours)
                action.setVisible(True)
        for ours in self.ours.values():
            ours.deleteLater()
        self.taken, self.keys, self.hidden, self.ours = [], [], [], {}
