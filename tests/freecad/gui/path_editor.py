# SPDX-License-Identifier: LGPL-2.1-or-later
"""The motion editor with real mouse clicks: capture, edit with units, insert, undo, cancel, play."""
import os
import sys
import time

sys.path.insert(0, os.path.dirname(os.path.realpath(__file__)))
from driver import (  # noqa: E402
    App,
    Cancel,
    Gaps,
    Gui,
    Ok,
    QtCore,
    QtWidgets,
    choose,
    click,
    drag,
    find,
    no_panel,
    open_workbench,
    panel_button,
    press,
    run,
    say,
    select,
    shot,
)


def button(name):
    return find(QtWidgets.QPushButton, "SweptVolume" + name)


def type_into(table, row, column, text):
    table.item(row, column).setText(text)


def scenario():
    from sweptvolume import demo
    from sweptvolume.panels import motion_panel

    open_workbench()
    yield
    scene = demo.build()
    doc, starter = scene.document, scene.starter
    yield 0.5
    doc.removeObject(scene.motion.Name)

    # A new motion: capture a key, move the part, capture again, insert a key between.
    select(starter)
    Gui.runCommand("SweptVolume_NewMotion")
    yield
    for place in ((0, 0, 0), (-60, 0, 0), (-66, 30, -60)):
        starter.Placement.Base = App.Vector(*place)
        click(button("Capture"))
        yield
    table = find(QtWidgets.QTableWidget, "SweptVolumeKeys")
    assert table.rowCount() == 3
    table.setCurrentCell(1, 1)
    click(button("Insert"))
    yield
    assert table.rowCount() == 4 and table.item(2, 0).text() == "1.5", table.item(2, 0).text()
    type_into(table, 3, 3, "-10 in")
    assert table.item(3, 3).text() == "-254"
    type_into(table, 3, 6, "90")
    type_into(table, 0, 0, "soon")
    yield
    shot("10_path_editor_message")
    yield 0.5
    assert table.item(0, 0).text() == "0"

    # The coarse envelope follows: twenty edits one after the other.
    panel = motion_panel.opened[-1]
    yield panel.preview.settled
    assert panel.coarse.surface.getNumChildren() == 1 and panel.preview.fine_updates >= 1
    gaps, began, done = Gaps(), time.perf_counter(), panel.preview.updates
    for i in range(20):
        type_into(table, 3, 3, str(-250 - i))
        yield lambda: panel.preview.run is None
    seconds = time.perf_counter() - began
    assert panel.preview.updates >= done + 20
    text = "preview: {:.1f} updates a second, longest gap {}"
    say(text.format(20 / seconds, gaps.stop()))
    type_into(table, 3, 3, "-254")
    yield panel.preview.settled
    shot("14_preview")
    yield 0.5
    gaps = Gaps()
    click(button("Play"))
    yield 1.5
    shot("11_path_editor_play")
    yield lambda: not button("Play").isChecked()
    say("longest gap while a path is played: " + gaps.stop())
    assert not [o for o in doc.Objects if o.Name.startswith("Motion")]
    click(panel_button(Ok))
    yield no_panel
    motion = doc.getObject("Motion") or [o for o in doc.Objects if o.Name.startswith("Motion")][0]
    assert motion.Count == 4 and abs(motion.Placements[3].Base.z + 254) < 1e-6
    assert motion.SourceType == "Stored"
    assert doc.UndoNames[0] == "Edit motion", doc.UndoNames

    # Edit and cancel: nothing changes, and the ghosts disappear.
    before, graph = list(motion.Times), Gui.getDocument(doc.Name).activeView().getSceneGraph()
    children = graph.getNumChildren()
    select(starter, motion)
    Gui.runCommand("SweptVolume_EditMotion")
    yield
    assert graph.getNumChildren() == children + 3  # ghosts, coarse envelope, dragger
    table = find(QtWidgets.QTableWidget, "SweptVolumeKeys")
    table.setCurrentCell(0, 0)
    for name in ("Delete", "Reverse", "Duplicate", "Down", "Up", "Even"):
        click(button(name))
        yield
    shot("12_path_editor")
    yield 0.5
    place = App.Placement(starter.Placement)
    starter.Placement.Base.x -= 11
    click(panel_button(Cancel))
    yield no_panel
    assert graph.getNumChildren() == children and list(motion.Times) == before
    assert abs(starter.Placement.Base.x - place.Base.x) < 1e-9, "the part was not put back"

    # The key is dragged by the arrow that points upwards, in steps of 10 mm, with real mouse events.
    select(starter, motion)
    Gui.runCommand("SweptVolume_EditMotion")
    yield
    panel = motion_panel.opened[-1]
    panel.preview_box.setChecked(False)
    panel.snap.setProperty("rawValue", 10.0)
    table = find(QtWidgets.QTableWidget, "SweptVolumeKeys")
    table.setCurrentCell(0, 1)
    yield 0.5
    there = panel.dragger.placement()
    axes = [there.Rotation.multVec(App.Vector(*v)) for v in ((1, 0, 0), (0, 1, 0), (0, 0, 1))]
    up = max(axes, key=lambda axis: axis.z)
    tip = there.Base + up * panel.dragger.arrow
    before = App.Placement(panel.keys.placements[0])
    yield from drag(tip, tip + up * 60)
    moved = panel.keys.placements[0].Base - before.Base
    say("dragged by {:.3f} {:.3f} {:.3f} mm".format(*moved))
    height = moved.dot(up)
    assert (moved - up * height).Length < 1e-3, moved
    assert height >= 30 and abs(height / 10 - round(height / 10)) < 1e-4, height
    shown = float(table.item(0, 3).toolTip().split()[0])  # all digits
    assert abs(shown - panel.keys.numbers(0)[2]) < 1e-3, shown
    shot("15_dragged")
    yield 0.5

    # Spline, with a given tangent; shortcuts; steps of the player.
    choose("SweptVolumeInterpolation", "Spline")
    yield
    table.setCurrentCell(1, 1)
    choose("SweptVolumeTangent", "Given")
    find(QtWidgets.QDoubleSpinBox, "SweptVolumeSpeedx").setValue(120)
    yield
    shot("16_spline")
    yield 0.5
    press(table, QtCore.Qt.Key_Insert)
    yield
    assert table.rowCount() == 5 and table.currentRow() == 2, table.rowCount()
    press(table, QtCore.Qt.Key_Up, QtCore.Qt.ControlModifier)
    assert table.currentRow() == 1
    press(table, QtCore.Qt.Key_Down, QtCore.Qt.ControlModifier)
    press(table, QtCore.Qt.Key_Delete)
    yield
    assert table.rowCount() == 4 and doc.getObject(starter.Name) is not None
    panel.player.slider.setValue(0)
    click(button("Forth"))
    assert abs(panel.player.now() - panel.keys.times[1]) < 0.01, panel.player.now()
    click(button("Back"))
    assert abs(panel.player.now() - panel.keys.times[0]) < 0.01
    click(panel_button(Ok))
    yield no_panel
    assert motion.Interpolation == "Spline" and list(motion.Tangents)[1] == "Given"
    assert abs(motion.Velocities[1].x - 120) < 1e-9
    assert doc.UndoNames[0] == "Edit motion"
    shot("17_smooth_path")
    yield 0.5
    App.closeDocument(doc.Name)
    yield


run(scenario)
