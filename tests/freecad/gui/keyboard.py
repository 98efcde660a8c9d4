# SPDX-License-Identifier: LGPL-2.1-or-later
"""A motion and its envelope with the keyboard alone: keys that the X server itself sends."""
import os
import sys

HERE = os.path.dirname(os.path.realpath(__file__))
sys.path[:0] = [HERE, os.path.dirname(HERE)]
from driver import (  # noqa: E402
    App,
    Gui,
    QtWidgets,
    find,
    new_document,
    no_panel,
    open_workbench,
    run,
    shot,
)
from x_keyboard import focused, keyboard_or_leave  # noqa: E402


def scenario():
    from sweptvolume import commands
    from sweptvolume.features import envelope, motion

    open_workbench()
    yield
    keyboard = keyboard_or_leave()
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
    table = find(QtWidgets.QTableWidget, "SweptVolumeKeys")
    for count in (1, 2):
        yield from press("Alt_L+c")
        yield lambda: table.rowCount() == count
    yield from keyboard.tab_to("SweptVolumeKeys")
    yield from press("3", "0", "Return")
    assert table.item(1, 1).text() == "30", table.item(1, 1).text()
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
