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
    """Keys that choose a command in our menu, as it is now: the arrows pass over grey ones."""
    from sweptvolume import commands

    names = [n for n in commands._names if n != "Separator"]
    before = names[: names.index("SweptVolume_" + name)]
    steps = [n for n in before if Gui.isCommandActive(n)]
    return ["Alt_L+s"] + ["Down"] * len(steps) + ["Return"]


#: s that a key may take to the window, on a machine that is busy.
LATE = 2.0


class _Heard(QtCore.QObject):
    """Counts the keys that the window got and that were let go there."""

    def __init__(self):
        super().__init__()
        self.count = 0
        QtWidgets.QApplication.instance().installEventFilter(self)

    def eventFilter(self, where, event):
        if event.type() == QtCore.QEvent.KeyRelease and where.isWindowType():
            self.count += 1
        return False


class Keyboard:
    """Presses keys by their X names; "Alt_L+s" holds the first one. Raises OSError without the
    libraries for it."""

    def __init__(self):
        self.x, self.test = ctypes.CDLL("libX11.so.6"), ctypes.CDLL("libXtst.so.6")
        self.x.XOpenDisplay.restype = ctypes.c_void_p
        self.x.XStringToKeysym.restype = ctypes.c_ulong
        self.display = ctypes.c_void_p(self.x.XOpenDisplay(None))
        self.heard = _Heard()
        self.give(Gui.getMainWindow())

    def give(self, window):
        """No window manager here: nobody else gives a window the keys."""
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

    def press(self, *keys):
        """One after the other; a generator."""
        for key in keys:
            wanted, until = self.heard.count + key.count("+") + 1, time.monotonic() + LATE
            self._stroke(key)
            yield lambda: self.heard.count >= wanted or time.monotonic() > until
            yield 0.2  # a button that a letter presses stays down for 0.1 s

    def type(self, text, *then):
        """A text at once, and keys that end it; a generator."""
        for character in text:
            key = _NAMES.get(character, character)
            self._stroke("Shift_L+" + key if character.isupper() else key)
        for key in then:
            self._stroke(key)
        yield 0.1

    def letter(self, key):
        """Alt and a letter: a button stays down for a moment before it acts; a generator."""
        yield from self.press("Alt_L+" + key)
        yield 0.2

    def tab_to(self, name, key="Tab"):
        """Goes from field to field until one has the name; a generator."""
        passed = []
        while focused() != name:
            passed.append(focused())
            assert passed[-3:] != passed[-1:] * 3, "{} is not on the way of {}: {}".format(
                name, key, passed
            )
            yield from self.press(key)


def letters():
    """Letters that press something together with Alt now: of the menus and of the buttons in view."""
    window = Gui.getMainWindow()
    texts = [action.text() for action in window.menuBar().actions() if action.isVisible()]
    texts += [b.text() for b in window.findChildren(QtWidgets.QPushButton) if b.isVisible()]
    return [text[text.index("&") + 1].upper() for text in texts if "&" in text]


def keyboard_or_leave():
    """A Keyboard; without the libraries for it the scenario ends, with a line."""
    try:
        return Keyboard()
    except OSError as problem:
        say("keyboard skipped: {}".format(problem))
        say("{} passed".format(os.path.basename(sys._getframe(1).f_code.co_filename)))
        os._exit(0)


def focused():
    """Name of the field that has the keyboard."""
    widget = QtWidgets.QApplication.focusWidget()
    return (widget.objectName() or widget.metaObject().className()) if widget else None


def chosen_in_tree(keyboard, *labels):
    """Chooses objects in the tree by their labels, in order; a generator."""
    yield from keyboard.press("Control_L+t")
    assert focused() == "Gui::TreeWidget", focused()
    tree = QtWidgets.QApplication.focusWidget()
    for number, label in enumerate(labels):
        held = "Control_L+" if number else ""  # with it the others stay chosen
        for key, ends in (("Up", ()), ("Down", (label,))):
            before = ""
            while tree.currentItem() is None or tree.currentItem().text(0) not in (before, *ends):
                before = tree.currentItem().text(0) if tree.currentItem() else ""
                yield from keyboard.press(held + key)
        assert tree.currentItem().text(0) == label, (label, tree.currentItem().text(0))
        if number:
            yield from keyboard.press("Control_L+space")
