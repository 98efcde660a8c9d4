# SPDX-License-Identifier: LGPL-2.1-or-later
"""Base of the view providers."""
import FreeCAD as App
import FreeCADGui as Gui
from PySide import QtCore

from .. import icon, reading, runner
from ..features.base import kind_of
from ..features.envelope import CANCELLED, FAILED, NOT_COMPUTED, STALE

#: State -> suffix of the icon's name.
_MARKS = {STALE: "_stale", CANCELLED: "_cancelled", FAILED: "_failed", NOT_COMPUTED: "_empty"}


reading.watch()


def shown_icon(name):
    """Returns the path of an icon that FreeCAD has loaded itself. Otherwise the tree would show a
    default icon if Qt 6 lacks its plug-in for SVG files."""
    path = icon(name)
    Gui.getIcon(path)
    return path


def state_icon(name, obj):
    """Returns the icon of an object with a result. It marks the states running, stale, cancelled,
    failed and never computed."""
    if runner.is_running(obj):
        return shown_icon(name + "_running")
    return shown_icon(name + _MARKS.get(getattr(obj, "Status", ""), ""))


def verdict_icon(name, obj, verdict=None):
    """Returns the icon of a check: its state or, if the result is current, its worst verdict.
    verdict: used instead of the object's verdict."""
    found = state_icon(name, obj)
    if found != icon(name) or not obj.Checked:
        return found
    verdict = verdict or obj.Verdict
    if verdict in ("contact", "clash"):
        return shown_icon(name + "_clash")
    return shown_icon(name + "_near") if verdict == "below" else found


def run_command(obj, command):
    """Selects an object and runs a command of this workbench."""
    Gui.Selection.clearSelection()
    Gui.Selection.addSelection(obj)
    Gui.runCommand(command)


def _is_ours(obj):
    try:
        return bool(kind_of(obj))
    except ReferenceError:
        return False  # the object was deleted meanwhile


def _show_children(holder):
    """Makes the tree ask an object for its children. The tree does so when a property of the object
    is set; a number that keeps its value is enough (a text is not)."""
    try:
        name, touched = holder.ViewObject.Proxy.COUNTER, "Touched" in holder.State
        setattr(holder, name, getattr(holder, name))
        if not touched:
            holder.purgeTouched()
        Gui.getDocument(holder.Document.Name).toggleTreeItem(holder, 2)  # 2: expand
    except (AttributeError, ReferenceError, RuntimeError):
        pass  # the object or its document was deleted meanwhile


class View:
    """Base of the proxies of view providers."""

    def __init__(self, view):
        view.Proxy = self

    def attach(self, view):
        self.Object = view.Object
        for name in self.PARENTS:  # the links may have been set before there was a view
            self._update_parents(view.Object, name)

    #: Names of the object's links to objects that show it as a child in the tree.
    PARENTS = ()
    #: Name of a whole-number property of an object with children in the tree.
    COUNTER = ""
    #: Name of the command that edits such an object.
    EDITOR = ""

    def updateData(self, obj, name):
        if name == "Status" and getattr(obj, "ViewObject", None) is not None:
            obj.ViewObject.signalChangeIcon()
        if name in self.PARENTS:
            self._update_parents(obj, name)

    def _update_parents(self, obj, name):
        links = getattr(obj, name, None)
        now = [h for h in (links if isinstance(links, list) else [links]) if h is not None]
        above = self.__dict__.setdefault("_above", {})
        before, above[name] = above.get(name, []), now
        if getattr(obj.Document, "Restoring", False):
            return  # during restore the tree asks all objects anyway
        for holder in now + [h for h in before if h not in now]:
            if _is_ours(holder):
                # Called later from the event loop, not while an object is created or Undo runs.
                QtCore.QTimer.singleShot(0, lambda holder=holder: _show_children(holder))

    def claimChildren(self):
        """Returns the objects that use this one and that the tree shows below it: motions,
        envelopes, solids and checks."""
        try:
            users = self.Object.InList
        except (AttributeError, ReferenceError):
            return []
        return [user for user in dict.fromkeys(users) if self._holds(user)]

    def _holds(self, user):
        view = getattr(getattr(user, "ViewObject", None), "Proxy", None)
        for name in getattr(view, "PARENTS", ()):
            links = getattr(user, name, None)
            if self.Object in (links if isinstance(links, list) else [links]):
                return True
        return False

    def doubleClicked(self, view):
        run_command(view.Object, self.EDITOR)
        return True

    def setEdit(self, view, mode=0):
        """Handles FreeCAD's Edit in the tree: opens the panel, but does not enter FreeCAD's edit
        mode, whose end would close any open panel. Other modes (Transform, colours) are left to
        FreeCAD."""
        if mode != 0:
            return None
        # Called later from the event loop, when FreeCAD has finished with the menu.
        QtCore.QTimer.singleShot(0, lambda: run_command(view.Object, self.EDITOR))
        return False

    def unsetEdit(self, view, mode=0):
        return None

    def add_menu(self, menu, text, icon_name, action):
        entry = menu.addAction(Gui.getIcon(icon(icon_name)), text)
        entry.triggered.connect(lambda *ignored: action())

    def add_commands(self, menu, obj, commands):
        """Adds entries to the menu. commands: (text, name of the command that runs on the object)."""
        for text, name in commands:
            self.add_menu(menu, text, name, lambda name=name: run_command(obj, name))

    def dumps(self):
        return None

    def loads(self, state):
        return None

    __getstate__ = dumps

    def __setstate__(self, state):
        return None


def set_if_there(view, **values):
    """Sets those view properties that exist in this version of FreeCAD. ShapeColor is checked as an
    attribute: in FreeCAD 1.1 it is not in the list of properties, but part of ShapeAppearance.
    """
    for name, value in values.items():
        if name not in view.PropertiesList and not (name == "ShapeColor" and hasattr(view, name)):
            if name == "ShapeColor":
                _set_appearance(view, value)
            continue
        try:
            setattr(view, name, value)
        except (TypeError, ValueError, AttributeError) as error:
            App.Console.PrintLog("Swept Volume: {} not set: {}\n".format(name, error))


def _set_appearance(view, colour):
    """Sets the diffuse colour of the first material, if the view has materials."""
    materials = getattr(view, "ShapeAppearance", None)
    if not materials:
        return
    first = materials[0]
    first.DiffuseColor = colour
    view.ShapeAppearance = (first,) + tuple(materials[1:])
