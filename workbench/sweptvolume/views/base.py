# SPDX-License-Identifier: LGPL-2.1-or-later
"""What our view providers share."""
import FreeCAD as App
import FreeCADGui as Gui
from PySide import QtCore

from .. import icon, reading, runner
from ..features.base import kind_of
from ..features.envelope import CANCELLED, FAILED, NOT_COMPUTED, STALE

#: State -> ending of the icon's name.
_MARKS = {STALE: "_stale", CANCELLED: "_cancelled", FAILED: "_failed", NOT_COMPUTED: "_empty"}


reading.watch()


def shown_icon(name):
    """The path of an icon, which FreeCAD has drawn by itself before: Qt 6 alone draws no SVG where its
    plug-in for them is missing, and the tree would show what any object has."""
    path = icon(name)
    Gui.getIcon(path)
    return path


def state_icon(name, obj):
    """Icon of an object with a result: running, stale, cancelled, failed, never computed are marked."""
    if runner.is_running(obj):
        return shown_icon(name + "_running")
    return shown_icon(name + _MARKS.get(getattr(obj, "Status", ""), ""))


def verdict_icon(name, obj, verdict=None):
    """Icon of a check: its state; where that is current, what is worst. verdict: in place of the object's."""
    found = state_icon(name, obj)
    if found != icon(name) or not obj.Checked:
        return found
    verdict = verdict or obj.Verdict
    if verdict in ("contact", "clash"):
        return shown_icon(name + "_clash")
    return shown_icon(name + "_near") if verdict == "below" else found


def run_command(obj, command):
    """Runs one of our commands on one object, as if it were selected."""
    Gui.Selection.clearSelection()
    Gui.Selection.addSelection(obj)
    Gui.runCommand(command)


def _is_ours(obj):
    try:
        return bool(kind_of(obj))
    except ReferenceError:
        return False  # deleted meanwhile


def _show_children(holder):
    """The tree asks an object for its children when one of its own properties was set: a number does
    so that stays what it is (texts do not)."""
    try:
        name, touched = holder.ViewObject.Proxy.COUNTER, "Touched" in holder.State
        setattr(holder, name, getattr(holder, name))
        if not touched:
            holder.purgeTouched()
        Gui.getDocument(holder.Document.Name).toggleTreeItem(holder, 2)  # opened
    except (AttributeError, ReferenceError, RuntimeError):
        pass  # the object or its document went meanwhile


class View:
    """Base of the view provider proxies."""

    def __init__(self, view):
        view.Proxy = self

    def attach(self, view):
        self.Object = view.Object
        for name in self.PARENTS:  # set before there was a view
            self._tell_parents(view.Object, name)

    #: Links of the object, by name, to those that hold it in the tree.
    PARENTS = ()
    #: A whole number of an object that holds others.
    COUNTER = ""
    #: The command that edits one of them.
    EDITOR = ""

    def updateData(self, obj, name):
        if name == "Status" and getattr(obj, "ViewObject", None) is not None:
            obj.ViewObject.signalChangeIcon()
        if name in self.PARENTS:
            self._tell_parents(obj, name)

    def _tell_parents(self, obj, name):
        links = getattr(obj, name, None)
        now = [h for h in (links if isinstance(links, list) else [links]) if h is not None]
        above = self.__dict__.setdefault("_above", {})
        before, above[name] = above.get(name, []), now
        if getattr(obj.Document, "Restoring", False):
            return  # the tree asks everybody then
        for holder in now + [h for h in before if h not in now]:
            if _is_ours(holder):
                # From the loop: not while an object is being made, or the document undone.
                QtCore.QTimer.singleShot(0, lambda holder=holder: _show_children(holder))

    def claimChildren(self):
        """What is made of this object stands below it in the tree: motion, envelope, solid and check."""
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
        """FreeCAD's Edit of the tree: opens the panel, and FreeCAD is not in edit: its end would close
        whatever panel is open. Other modes (Transform, colours) are FreeCAD's own."""
        if mode != 0:
            return None
        # From the loop: the panel opens when FreeCAD has done with the menu.
        QtCore.QTimer.singleShot(0, lambda: run_command(view.Object, self.EDITOR))
        return False

    def unsetEdit(self, view, mode=0):
        return None

    def add_menu(self, menu, text, icon_name, action):
        entry = menu.addAction(Gui.getIcon(icon(icon_name)), text)
        entry.triggered.connect(lambda *ignored: action())

    def add_commands(self, menu, obj, commands):
        """Entries of the menu: (text, name of the command that runs on the object) of each."""
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
    """View properties differ between versions of FreeCAD: sets those that exist. A ShapeColor is asked
    for by its attribute: FreeCAD 1.1 has it no more among the properties, but in the ShapeAppearance.
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
    """The diffuse colour of the first material, where the view has materials."""
    materials = getattr(view, "ShapeAppearance", None)
    if not materials:
        return
    first = materials[0]
    first.DiffuseColor = colour
    view.ShapeAppearance = (first,) + tuple(materials[1:])
