# SPDX-License-Identifier: LGPL-2.1-or-later
"""A motion and its envelope with the keyboard alone: keys that the X server itself sends."""
import ctypes
import os
import sys

sys.path.insert(0, os.path.dirname(os.path.realpath(__file__)))
from driver import (  # noqa: E402
    App,
    Gui,
    QtWidgets,
    find,
    new_document,
    no_panel,
    open_workbench,
    run,
    say,
    shot,
)


class Keyboard:
    """Presses keys by their X names; "Alt_L+s" holds the first one. Raises OSError without the
    libraries for it."""

    def __init__(self):
        self.x, self.test = ctypes.CDLL("libX11.so.6"), ctypes.CDLL("libXtst.so.6")
        self.x.XOpenDisplay.restype = ctypes.c_void_p
        self.x.XStringToKeysym.restype = ctypes.c_ulong
        self.display = ctypes.c_void_p(self.x.XOpenDisplay(None))
        # No window manager here: nobody else gives the window the keys.
        window = ctypes.c_ulong(int(Gui.getMainWindow().winId()))
        self.x.XSetInputFocus(self.display, window, 1, 0)
        self.x.XFlush(self.display)

    def _send(self, name, down):
        symbol = ctypes.c_ulong(self.x.XStringToKeysym(name.encode()))
        code = self.x.XKeysymToKeycode(self.display, symbol)
        assert code, name
        self.test.XTestFakeKeyEvent(self.display, code, down, ctypes.c_ulong(0))
        self.x.XFlush(self.display)

    def press(self, *keys):
        """One after the other; a generator."""
        for key in keys:
            held = key.split("+")
            for name in held:
                self._send(name, 1)
            for name in reversed(held):
                self._send(name, 0)
            yield 0.25


def focused():
    widget = QtWidgets.QApplication.focusWidget()
    return (widget.objectName() or widget.metaObject().className()) if widget else None


def scenario():
    from sweptvolume import commands
    from sweptvolume.features import envelope, motion

    open_workbench()
    yield
    try:
        keyboard = Keyboard()
    except OSError as problem:
        say("keyboard skipped: {}\npassed".format(problem))
        os._exit(0)
    press = keyboard.press
    doc = new_document("Keyboard")
    box = doc.addObject("Part::Box", "Box")
    doc.recompute()
    Gui.activeDocument().activeView().viewIsometric()
    Gui.SendMsgToActiveView("ViewFit")
    yield 0.5

    # The part is selected, the first entry of our menu opens the path editor.
    yield from press("Control_L+a")
    assert Gui.Selection.getSelection() == [box], Gui.Selection.getSelection()
    yield from press("Alt_L+s", "Return")
    yield lambda: not no_panel()
    yield 0.5

    # Two keys; Tab goes to the table, the second key is typed into it.
    yield from press("Alt_L+c", "Alt_L+c")
    table = find(QtWidgets.QTableWidget, "SweptVolumeKeys")
    assert table.rowCount() == 2, table.rowCount()
    passed = []
    while focused() != "SweptVolumeKeys":
        passed.append(focused())
        assert len(passed) < 40, passed
        yield from press("Tab")
    yield from press("3", "0", "Return")
    assert table.item(1, 1).text() == "30", (table.item(1, 1).text(), passed)
    yield from press("Insert")
    assert table.rowCount() == 3
    yield from press("Tab")
    assert focused() == "SweptVolumeCapture", focused()
    shot("80_keyboard_editor")
    yield 0.6
    yield from press("Return")
    yield no_panel
    path = [o for o in doc.Objects if motion.is_motion(o)][0]
    assert [round(p.Base.x) for p in path.Placements] == [0, 30, 30], path.Placements

    # The envelope by its entry in the menu, cancelled by Escape, then made.
    entry = [n for n in commands._names if n != "Separator"].index("SweptVolume_Envelope")
    for end in ("Escape", "Return"):
        yield from press("Control_L+a", "Alt_L+s", *["Down"] * entry, "Return")
        yield lambda: not no_panel()
        yield 0.6
        yield from press(end)
        yield no_panel
        assert (doc.getObject("Envelope") is None) == (end == "Escape")
    assert doc.getObject("Envelope").Status == envelope.UP_TO_DATE
    shot("81_keyboard_envelope")
    yield 0.6
    App.closeDocument(doc.Name)
    yield


run(scenario)
