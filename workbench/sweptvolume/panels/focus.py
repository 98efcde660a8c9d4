# SPDX-License-Identifier: LGPL-2.1-or-later
"""Opening a panel: it fits into its dock and has the keyboard focus. FreeCAD's 3D view uses Tab
itself, so a panel takes the focus when it opens, and a command moves the focus to the tree and
back."""
import FreeCADGui as Gui
from PySide import QtCore

from .widgets import QtWidgets, to_first_field

#: The last result of show(): the form of a task panel, and its event filter.
_shown = []
#: Times (ms) at which a new panel is fitted and takes the focus. In Qt 6, a menu opened by keys
#: returns the focus to the 3D view after the command has run, and a dock that was hidden gets its
#: width late, so one attempt is not enough.
_WAITS = 0, 50, 200
#: The border (pixels) at the right of a form.
_BORDER = 14
#: The tree to which to_tree_or_panel() moved last, and its event filter.
_tree = []


class _Keys(QtCore.QObject):
    """Event filter for keys that a widget needs before FreeCAD's shortcuts get them: pairs of
    modifiers and key. FreeCAD's shortcuts belong to the whole window, so keys reach a panel only
    this way. One call takes 1 us.
    """

    def __init__(self, *wanted):
        super().__init__()
        self.wanted = wanted

    def eventFilter(self, watched, event):  # noqa: N802
        # A field that does not use a key passes it on to the form.
        if event.type() != QtCore.QEvent.ShortcutOverride:
            return False
        ours = (event.modifiers() & ~QtCore.Qt.KeypadModifier, event.key()) in self.wanted
        if ours:
            event.accept()
        return ours


def _form_keys():
    """Returns the filter of a form. Space presses a button or ticks a box, and Home goes to the
    first entry. Without the filter, FreeCAD hides the selection or turns the view (keyboard.py
    and keyboard_panels.py test this)."""
    plain = QtCore.Qt.NoModifier
    return _Keys((plain, QtCore.Qt.Key_Space), (plain, QtCore.Qt.Key_Home))


def _tree_keys():
    """Returns the filter of the tree. Ctrl with an arrow key moves without selecting. Without the
    filter, FreeCAD 1.0 shows and hides docks (keyboard_panels.py tests this)."""
    control = QtCore.Qt.ControlModifier
    return _Keys((control, QtCore.Qt.Key_Up), (control, QtCore.Qt.Key_Down))


class SortKeys(QtCore.QObject):
    """Lets Space sort a table by the column of its current cell, like a click on the head. Qt has
    no key for this (keyboard_panels.py tests it)."""

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
    """Opens a task panel with the focus in its first field. A dock that is too narrow for the panel
    is widened, because FreeCAD's task view cannot be scrolled sideways."""
    Gui.Control.showDialog(panel)
    form, keys = panel.form, _form_keys()  # a closed panel has no form
    form.installEventFilter(keys)
    _shown[:] = [form, keys]
    for wait in _WAITS:
        QtCore.QTimer.singleShot(wait, lambda: _enter(form))


def _enter(form):
    try:
        _fit(form)
        holder = QtWidgets.QApplication.focusWidget()
        if holder is None or not form.isAncestorOf(holder):
            to_first_field(form)
    except RuntimeError:
        pass  # the panel was closed at once


def _fit(form):
    """Widens the dock of a form by the width of the form that is outside the visible area."""
    window = Gui.getMainWindow()
    docks = _ancestors(form, window, QtWidgets.QDockWidget)
    areas = _ancestors(form, window, QtWidgets.QScrollArea)
    if not docks or not areas or docks[-1].isFloating():
        return
    dock, area = docks[-1], areas[-1]
    right = form.mapTo(area, QtCore.QPoint(form.minimumSizeHint().width(), 0)).x()
    missing = right + _BORDER - area.viewport().width()
    if missing > 0:
        window.resizeDocks([dock], [dock.width() + missing], QtCore.Qt.Horizontal)


def _ancestors(widget, window, kind):
    """Returns the ancestors of a widget that are of a class. (In PySide 2, asking a widget for its
    parent can delete the wrappers of other widgets.)"""
    return [found for found in window.findChildren(kind) if found.isAncestorOf(widget)]


def to_tree_or_panel():
    """Moves the focus from the tree to the open panel, and from anywhere else to the tree."""
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
    """Makes a widget visible that is behind another tab or in a closed dock."""
    window = Gui.getMainWindow()
    try:
        for kind in (QtWidgets.QStackedWidget, QtWidgets.QTabWidget):
            for holder in _ancestors(widget, window, kind):
                pages = [holder.widget(i) for i in range(holder.count())]
                shown = [i for i, p in enumerate(pages) if p == widget or p.isAncestorOf(widget)]
                holder.setCurrentIndex(shown[0])
        for dock in _ancestors(widget, window, QtWidgets.QDockWidget):
            dock.show()
            dock.raise_()
    except RuntimeError:
        pass  # the panel was closed
