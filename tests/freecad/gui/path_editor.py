# SPDX-License-Identifier: LGPL-2.1-or-later
"""The path editor by real clicks: capture, edit with units, insert, undo, cancel, play."""
import os
import sys
import time

sys.path.insert(0, os.path.dirname(os.path.realpath(__file__)))
from driver import (  # noqa: E402
    App,
    Gaps,
    Gui,
    QtWidgets,
    click,
    find,
    no_panel,
    panel_button,
    run,
    say,
    shot,
    widen,
)

Ok, Cancel = QtWidgets.QDialogButtonBox.Ok, QtWidgets.QDialogButtonBox.Cancel


def button(name):
    return find(QtWidgets.QPushButton, "SweptVolume" + name)


def type_into(table, row, column, text):
    table.item(row, column).setText(text)


def scenario():
    from sweptvolume import demo
    from sweptvolume.panels import motion_panel

    Gui.activateWorkbench("SweptVolumeWorkbench")
    widen()
    yield
    scene = demo.build()
    doc, starter = scene.document, scene.starter
    yield 0.5
    doc.removeObject(scene.motion.Name)

    # A new motion: capture here, move the part, capture again, insert one between.
    Gui.Selection.clearSelection()
    Gui.Selection.addSelection(starter)
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
    yield lambda: panel.preview.run is None
    assert panel.ghosts.envelope.getNumChildren() == 1
    gaps, began, done = Gaps(), time.perf_counter(), panel.preview.updates
    for i in range(20):
        type_into(table, 3, 3, str(-250 - i))
        yield lambda: panel.preview.run is None
    seconds = time.perf_counter() - began
    assert panel.preview.updates >= done + 20
    text = "preview: {:.1f} updates a second, longest gap {:.0f} ms"
    say(text.format(20 / seconds, gaps.stop() * 1000))
    type_into(table, 3, 3, "-254")
    yield lambda: panel.preview.run is None
    shot("14_preview")
    yield 0.5
    gaps = Gaps()
    click(button("Play"))
    yield 1.5
    shot("11_path_editor_play")
    yield lambda: not button("Play").isChecked()
    say("longest gap while a path is played: {:.0f} ms".format(gaps.stop() * 1000))
    assert not [o for o in doc.Objects if o.Name.startswith("Motion")]
    click(panel_button(Ok))
    yield no_panel
    motion = doc.getObject("Motion") or [o for o in doc.Objects if o.Name.startswith("Motion")][0]
    assert motion.Count == 4 and abs(motion.Placements[3].Base.z + 254) < 1e-6
    assert motion.SourceType == "Stored"
    assert doc.UndoNames[0] == "Edit motion", doc.UndoNames

    # Edit and cancel: nothing changes, the ghosts are gone.
    before, graph = list(motion.Times), Gui.getDocument(doc.Name).activeView().getSceneGraph()
    children = graph.getNumChildren()
    Gui.Selection.clearSelection()
    Gui.Selection.addSelection(starter)
    Gui.Selection.addSelection(motion)
    Gui.runCommand("SweptVolume_EditMotion")
    yield
    assert graph.getNumChildren() == children + 1
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

    # A wire becomes a motion through its panel.
    import Part

    wire = doc.addObject("Part::Feature", "Wire")
    wire.Shape = Part.makeLine(App.Vector(0, 200, 0), App.Vector(0, 300, 100))
    doc.recompute()
    Gui.Selection.clearSelection()
    Gui.Selection.addSelection(wire)
    Gui.runCommand("SweptVolume_MotionFromSource")
    yield
    shot("13_motion_from_source")
    yield 0.5
    click(panel_button(Ok))
    yield no_panel
    made = doc.Objects[-1]
    assert made.SourceType == "Curve" and made.Count == 32, made.Name
    App.closeDocument(doc.Name)
    yield


run(scenario)
