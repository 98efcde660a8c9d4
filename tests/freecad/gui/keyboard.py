# SPDX-License-Identifier: LGPL-2.1-or-later
"""A motion and its envelope, made with the keyboard only. The X server sends the keys."""
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
from x_keyboard import entry, focused, keyboard_or_leave, letters  # noqa: E402
from sweptvolume.panels import motion_panel  # noqa: E402


def column(table, number):
    return [table.item(row, number).text() for row in range(table.rowCount())]


def edit(keyboard, table):
    """Uses each action of the motion editor with the keyboard, then restores the motion."""
    press, letter = keyboard.press, keyboard.letter
    panel = motion_panel.opened[-1]
    yield from keyboard.type("3", "Return")
    assert column(table, 1) == ["0", "30", "3"], column(table, 1)
    yield from press("Control_L+Up")
    assert column(table, 1) == ["0", "3", "30"] and table.currentRow() == 1
    yield from press("Control_L+Down")
    assert column(table, 1) == ["0", "30", "3"] and table.currentRow() == 2
    yield from letter("r")
    assert column(table, 1) == ["3", "30", "0"], column(table, 1)
    yield from letter("r")
    yield from press("Control_L+d")
    assert column(table, 1) == ["0", "30", "3", "3"], column(table, 1)
    yield from press("Delete")
    assert table.rowCount() == 3
    yield from keyboard.type("", "Left")
    yield from keyboard.type("2.5", "Return")
    assert column(table, 0)[-1] == "2.5", column(table, 0)
    yield from letter("n")
    assert column(table, 0) == ["0", "1", "2"], column(table, 0)
    yield from press("Right", "Right")
    yield from keyboard.type("1.6 in", "Return")
    assert column(table, 3)[2] == "40.64", column(table, 3)
    yield from letter("o")  # rounds to whole millimetres
    assert column(table, 3)[2] == "41", column(table, 3)
    yield from letter("u")  # takes the placement of the part: the origin
    assert column(table, 3)[2] == "0" and column(table, 1)[2] == "0", column(table, 3)
    yield from keyboard.tab_to("SweptVolumeInterpolation")
    yield from press("End")
    box = find(QtWidgets.QComboBox, "SweptVolumeInterpolation")
    while box.currentData() != "Spline":
        assert box.currentIndex() > 0
        yield from press("Up")
    yield from keyboard.tab_to("SweptVolumeTangent")
    yield from press("End")
    tangent = find(QtWidgets.QComboBox, "SweptVolumeTangent")
    assert tangent.currentData() == "Given", tangent.currentData()
    yield from keyboard.tab_to("SweptVolumeSpeedx")
    yield from press("Control_L+a")
    yield from keyboard.type("15", "Tab")
    row = table.currentRow()
    assert panel.keys.tangents[row][0] == "Given" and panel.keys.tangents[row][1].x == 15
    yield from keyboard.tab_to("SweptVolumeTime")
    yield from press("Home", "Right")
    assert 0 < panel.player.now() < 0.1, panel.player.now()
    yield from letter("a")
    yield lambda: panel.player.play.isChecked()
    yield lambda: not panel.player.play.isChecked()
    yield from keyboard.tab_to("SweptVolumeDrag")
    yield from press("space")
    assert not panel.drag_box.isChecked()
    shot("79_keyboard_spline")
    yield 0.5
    yield from press("space")
    yield from keyboard.tab_to("SweptVolumeInterpolation", "Shift_L+Tab")
    yield from press("Home")
    yield from keyboard.tab_to("SweptVolumeKeys", "Shift_L+Tab")
    while table.currentColumn() > 1:
        yield from press("Left")
    yield from keyboard.type("30", "Return")
    assert column(table, 1) == ["0", "30", "30"], column(table, 1)


def scenario():
    from sweptvolume.features import envelope, motion

    open_workbench()
    yield
    keyboard = keyboard_or_leave()
    press = keyboard.press
    doc = new_document("Keyboard")
    box = doc.addObject("Part::Box", "Box")
    box.Placement.Base = App.Vector(-5, -5, -5)  # its middle, which the table shows, is at 0
    doc.recompute()
    Gui.activeDocument().activeView().viewIsometric()
    Gui.SendMsgToActiveView("ViewFit")
    yield 0.5

    # The part is selected; the first entry of the menu opens the motion editor.
    yield from press("Control_L+a")
    assert Gui.Selection.getSelection() == [box], Gui.Selection.getSelection()
    yield from press("Alt_L+s", "Return")
    yield lambda: not no_panel()
    yield 0.5

    # Two keys. Tab goes to the table, and the second key is typed there.
    table = find(QtWidgets.QTableWidget, "SweptVolumeKeys")
    for count in (1, 2):
        yield from press("Alt_L+c")
        yield lambda: table.rowCount() == count
    yield from keyboard.tab_to("SweptVolumeKeys")
    yield from press("3", "0", "Return")
    assert table.item(1, 1).text() == "30", table.item(1, 1).text()
    yield from press("Insert")
    assert table.rowCount() == 3
    found = letters()
    assert len(found) > 14 and len(set(found)) == len(found), found
    yield from edit(keyboard, table)
    yield from press("Tab")
    assert focused() == "SweptVolumeCapture", focused()
    shot("80_keyboard_editor")
    yield 0.6
    yield from press("Return")
    yield no_panel
    path = [o for o in doc.Objects if motion.is_motion(o)][0]
    assert [round(p.Base.x) for p in path.Placements] == [-5, 25, 25], path.Placements

    # The envelope: chosen in the menu, cancelled with Escape, then computed.
    for end in ("Escape", "Return"):
        yield from press("Control_L+a")
        yield from press(*entry("Envelope"))
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
