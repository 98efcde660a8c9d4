# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where the keyboard is: FreeCAD's 3D view keeps Tab for itself, so a panel takes the keyboard when it
opens, and a command brings it to the tree and back."""
import FreeCADGui as Gui
from PySide import QtCore

from .widgets import QtWidgets, to_first_field

#: What show() opened last: the form of a task panel, and its filter.
_shown = []
#: ms after which a new panel takes the keyboard. With Qt 6 a menu that was opened by keys gives it back
#: to the 3D view after the command has run.
_WAITS = 0, 50, 200
#: The tree that to_tree_or_panel() went to last, and its filter.
_tree = []


class _Keys(QtCore.QObject):
    """Keys that a widget wants itself, before FreeCAD's shortcuts have them: pairs of modifiers and key.
    FreeCAD's shortcuts are of the whole window, so no other way leads a key to a panel. One call takes 1 us.
    """

    def __init__(self, *wanted):
        super().__init__()
        self.wanted = wanted

    def eventFilter(self, watched, event):  # noqa: N802
        # Fields that do not want a key hand it on to the form.
        if event.type() != QtCore.QEvent.ShortcutOverride:
            return False
        ours = (event.modifiers() & ~QtCore.Qt.KeypadModifier, event.key()) in self.wanted
        if ours:
            event.accept()
        return ours


def _form_keys():
    """Space presses the button or ticks the box, Home goes to the first entry; FreeCAD would hide what is
    selected, and turn the view (without this keyboard.py and keyboard_panels.py fail)."""
    plain = QtCore.Qt.NoModifier
    return _Keys((plain, QtCore.Qt.Key_Space), (plain, QtCore.Qt.Key_Home))


def _tree_keys():
    """Ctrl and an arrow goes on without choosing; FreeCAD 1.0 would show and hide docks (without this
    keyboard_panels.py fails there)."""
    held = QtCore.Qt.ControlModifier
    return _Keys((held, QtCore.Qt.Key_Up), (held, QtCore.Qt.Key_Down))


class SortKeys(QtCore.QObject):
    """Space sorts a table by the column of its current cell, as a click on the head does; no key of Qt's does
    (keyboard_panels.py)."""

    def __init__(self, table):
        super().__init__()
        self.table = table
        table.installEventFilter(self)

    def eventFilter(self, watched, event):  # noqa: N802
        if event.type() != QtCore.QEvent.KeyPress or event.key() != QtCore.Qt.Key_Space:
            return False
        head, column = self.table.horizontalHeader(), max(self.table.currentColumn(), 0)
        falling = head.sortIndicatorOrder() == QtCore.Qt.DescendingOrder
        again = head.sortIndicatorSection() == column and not falling
        self.table.sortItems(
            column, QtCore.Qt.DescendingOrder if again else QtCore.Qt.AscendingOrder
        )
        return True


def show(panel):
    """Opens a task panel with the keyboard in its first field."""
    Gui.Control.showDialog(panel)
    form, keys = panel.form, _form_keys()  # a panel that was closed has no form
    form.installEventFilter(keys)
    _shown[:] = [form, keys]
    for wait in _WAITS:
        QtCore.QTimer.singleShot(wait, lambda: _enter(form))


def _enter(form):
    try:
        holder = QtWidgets.QApplication.focusWidget()
        if holder is None or not form.isAncestorOf(holder):
            to_first_field(form)
    except RuntimeError:
        pass  # the panel was closed at once


def to_tree_or_panel():
    """From the tree to the open panel, from anywhere else to the tree."""
    trees = [
        tree
        for tree in Gui.getMainWindow().findChildren(QtWidgets.QTreeWidget)
        if tree.metaObject().className() == "Gui::TreeWidget"
    ]
    if not trees:
        return
    tree = next((t for t in trees if t.isVisible()), trees[0])
    if tree.hasFocus() and Gui.Control.activeDialog() and _shown:
        Gui.Control.showTaskView()
        _bring_up(_shown[0])
        to_first_field(_shown[0])
        return
    _bring_up(tree)
    if tree not in _tree:
        keys = _tree_keys()
        tree.installEventFilter(keys)
        _tree[:] = [tree, keys]
    tree.setFocus(QtCore.Qt.ShortcutFocusReason)


def _bring_up(widget):
    """Makes a widget visible that lies behind another tab or in a closed dock."""
    try:
        inner, outer = widget, widget.parentWidget()
        while outer is not None:
            if isinstance(outer, QtWidgets.QStackedWidget):
                outer.setCurrentWidget(inner)
                tabs = outer.parentWidget()
                if isinstance(tabs, QtWidgets.QTabWidget):
                    tabs.setCurrentWidget(inner)
            elif isinstance(outer, QtWidgets.QDockWidget):
                outer.show()
                outer.raise_()
            inner, outer = outer, outer.parentWidget()
    except RuntimeError:
        pass  # the panel was closed
