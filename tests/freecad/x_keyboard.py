# SPDX-License-Identifier: LGPL-2.1-or-later
"""A keyboard for the scenarios in gui/: the X server sends its keys."""
import ctypes
import os
import sys
import time

import FreeCADGui as Gui

from driver import QtWidgets, say
from PySide import QtCore

#: Characters whose keys have other names in X.
_NAMES = {
    "-": "minus",
    ".": "period",
    ",": "comma",
    " ": "space",
    "/": "slash",
    "_": "Shift_L+minus",
    ":": "Shift_L+semicolon",
}


def entry(name):
    """Returns the keys that choose a command in the menu as it is now: the arrow keys skip disabled
    entries."""
    from sweptvolume import commands

    names = [n for n in commands._names if n != "Separator"]
    before = names[: names.index("SweptVolume_" + name)]
    steps = [n for n in before if Gui.isCommandActive(n)]
    return ["Alt_L+s"] + ["Down"] * len(steps) + ["Return"]


#: Longest time (s) that a key may take to reach the window, also on a busy machine.
LATE = 2.0


class _Heard(QtCore.QObject):
    """Counts the keys that the window has received, pressed and released."""

    def __init__(self):
        super().__init__()
        self.count = 0
        QtWidgets.QApplication.instance().installEventFilter(self)

    def eventFilter(self, where, event):
        if event.type() == QtCore.QEvent.KeyRelease and where.isWindowType():
            self.count += 1
        return False


class Keyboard:
    """Presses keys by their X names; "Alt_L+s" holds the first one down. Raises OSError if the
    libraries are missing."""

    def __init__(self):
        self.x, self.test = ctypes.CDLL("libX11.so.6"), ctypes.CDLL("libXtst.so.6")
        self.x.XOpenDisplay.restype = ctypes.c_void_p
        self.x.XStringToKeysym.restype = ctypes.c_ulong
        self.display = ctypes.c_void_p(self.x.XOpenDisplay(None))
        self.heard = _Heard()
        self.give(Gui.getMainWindow())

    def give(self, window):
        """Gives the window the keyboard: there is no window manager to do this."""
        number = ctypes.c_ulong(int(window.winId()))
        self.x.XSetInputFocus(self.display, number, 1, 0)
        self.x.XFlush(self.display)

    def _send(self, name, down):
        symbol = ctypes.c_ulong(self.x.XStringToKeysym(name.encode()))
        code = self.x.XKeysymToKeycode(self.display, symbol)
        assert code, name
        self.test.XTestFakeKeyEvent(self.display, code, down, ctypes.c_ulong(0))
        self.x.XFlush(self.display)

    def _stroke(self, key):
        held = key.split("+")
        for name in held:
            self._send(name, 1)
        for name in reversed(held):
            self._send(name, 0)

    def _all_heard(self, keys):
        """A generator that sends keys, and waits until the window has received all of them."""
        wanted = self.heard.count + sum(key.count("+") + 1 for key in keys)
        until = time.monotonic() + LATE
        for key in keys:
            self._stroke(key)
        yield lambda: self.heard.count >= wanted or time.monotonic() > until

    def press(self, *keys):
        """A generator that presses keys one after the other."""
        for key in keys:
            yield from self._all_heard([key])
            yield 0.2  # a button that a letter presses stays down for 0.1 s

    def type(self, text, *then):
        """A generator that types a text, and then presses keys that end it."""
        keys = [_NAMES.get(c, "Shift_L+" + c if c.isupper() else c) for c in text] + list(then)
        yield from self._all_heard(keys)
        yield 0.1

    def letter(self, key):
        """A generator that presses Alt and a letter. A button stays pressed for a moment before it acts."""
        yield from self.press("Alt_L+" + key)
        yield 0.2

    def tab_to(self, name, key="Tab"):
        """A generator that presses Tab until the field with this name has the keyboard focus."""
        passed = []
        while focused() != name:
            passed.append(focused())
            assert passed[-3:] != passed[-1:] * 3, "{} is not on the way of {}: {}".format(
                name, key, passed
            )
            yield from self.press(key)


def letters():
    """Returns the letters that act together with Alt at this moment: those of menus and of visible
    buttons."""
    window = Gui.getMainWindow()
    texts = [action.text() for action in window.menuBar().actions() if action.isVisible()]
    texts += [b.text() for b in window.findChildren(QtWidgets.QPushButton) if b.isVisible()]
    return [text[text.index("&") + 1].upper() for text in texts if "&" in text]


def keyboard_or_leave():
    """Returns a Keyboard. If the libraries for it are missing, the scenario ends with a message."""
    try:
        return Keyboard()
    except OSError as problem:
        say("keyboard skipped: {}".format(problem))
        say("{} passed".format(os.path.basename(sys._getframe(1).f_code.co_filename)))
        os._exit(0)


def focused():
    """Returns the name of the widget that has the keyboard focus."""
    widget = QtWidgets.QApplication.focusWidget()
    return (widget.objectName() or widget.metaObject().className()) if widget else None


def chosen_in_tree(keyboard, *labels):
    """A generator that selects objects in the tree by their labels, in order."""
    yield from keyboard.press("Control_L+t")
    assert focused() == "Gui::TreeWidget", focused()
    tree = QtWidgets.QApplication.focusWidget()
    for number, label in enumerate(labels):
        held = "Control_L+" if number else ""  # keeps the others selected
        for key, ends in (("Up", ()), ("Down", (label,))):
            before = ""
            while tree.currentItem() is None or tree.currentItem().text(0) not in (before, *ends):
                before = tree.currentItem().text(0) if tree.currentItem() else ""
                yield from keyboard.press(held + key)
        assert tree.currentItem().text(0) == label, (label, tree.currentItem().text(0))
        if number:
            yield from keyboard.press("Control_L+space")
