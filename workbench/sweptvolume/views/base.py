# SPDX-License-Identifier: LGPL-2.1-or-later
"""What our view providers share."""
import FreeCAD as App
import FreeCADGui as Gui

from .. import icon, runner
from ..features.envelope import CANCELLED, FAILED, NOT_COMPUTED, STALE

#: State -> ending of the icon's name.
_MARKS = {STALE: "_stale", CANCELLED: "_cancelled", FAILED: "_failed", NOT_COMPUTED: "_empty"}


def state_icon(name, obj):
    """Icon of an object with a result: running, stale, cancelled, failed, never computed are marked."""
    if runner.is_running(obj):
        return icon(name + "_running")
    return icon(name + _MARKS.get(getattr(obj, "Status", ""), ""))


def run_command(obj, command):
    """Runs one of our commands on one object, as if it were selected."""
    Gui.Selection.clearSelection()
    Gui.Selection.addSelection(obj)
    Gui.runCommand(command)


class View:
    """Base of the view provider proxies."""

    def __init__(self, view):
        view.Proxy = self

    def attach(self, view):
        self.Object = view.Object

    def updateData(self, obj, name):
        if name == "Status" and getattr(obj, "ViewObject", None) is not None:
            obj.ViewObject.signalChangeIcon()

    def add_menu(self, menu, text, icon_name, action):
        from PySide import QtGui

        entry = menu.addAction(QtGui.QIcon(icon(icon_name)), text)
        entry.triggered.connect(lambda *ignored: action())

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
