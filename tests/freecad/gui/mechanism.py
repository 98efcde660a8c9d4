# SPDX-License-Identifier: LGPL-2.1-or-later
"""Check mechanism on a slider-crank, as a user works: motions of all parts from one run of the driven
value, the check, rules, a row with its line, the player, stop, undo.
"""
import os
import sys
import tempfile

HERE = os.path.dirname(os.path.realpath(__file__))
sys.path[:0] = [HERE, os.path.dirname(HERE)]
import slider_crank  # noqa: E402
from driver import (  # noqa: E402
    Close,
    Gaps,
    Gui,
    Ok,
    QtWidgets,
    choose,
    click,
    find,
    new_document,
    no_panel,
    open_workbench,
    panel_button,
    run,
    say,
    select,
    shot,
    stopped,
    to_3d_view,
)


def rows_of(table):
    return {table.item(r, 0).text(): r for r in range(table.rowCount())}


def motions_of_all_parts(doc, sheet):
    """Only the object with the driving value is selected: every part that moves gets a motion, in one
    undo step."""
    undo = doc.UndoCount
    select(sheet)
    Gui.runCommand("SweptVolume_MotionDriven")
    yield 0.3
    choose("SweptVolumeValue", "angle")
    find(QtWidgets.QDoubleSpinBox, "SweptVolumeStart").setValue(0)
    find(QtWidgets.QDoubleSpinBox, "SweptVolumeEnd").setValue(360)
    find(QtWidgets.QSpinBox, "SweptVolumeCount").setValue(121)
    click(panel_button(Ok))
    yield no_panel
    names = [m.SourceObjects[1].Name for m in doc.Objects if m.Name.startswith("Motion")]
    assert names == ["Crank", "Rod", "Slider"], names
    assert doc.UndoCount == undo + 1, doc.UndoNames
    assert sheet.getContents("A1") == "0", sheet.getContents("A1")


def scenario():
    from sweptvolume.features import mechanism
    from sweptvolume.panels import file_dialogs

    open_workbench()
    yield
    doc = new_document("Crank")
    sheet, crank, rod, slider, wall = slider_crank.make(doc)
    rod.Shape = rod.Shape.translated(slider_crank.V(0, 0, -1.2))  # 0.2 mm into crank and slider
    doc.recompute()
    to_3d_view()  # the spreadsheet covers it
    view = Gui.activeDocument().activeView()
    view.viewIsometric()
    from pivy import coin  # noqa: F401 (before it FreeCAD 1.1 gives no scene graph)

    graph = view.getSceneGraph()
    Gui.SendMsgToActiveView("ViewFit")
    yield
    yield from motions_of_all_parts(doc, sheet)
    for name in ("Motion", "Motion001", "Motion002"):
        doc.getObject(name).ViewObject.Visibility = False
    to_3d_view()
    view.viewIsometric()
    Gui.SendMsgToActiveView("ViewFit")
    Gui.Selection.clearSelection()
    Gui.runCommand("SweptVolume_Mechanism")
    yield 0.3
    moving = find(QtWidgets.QTableWidget, "SweptVolumeMovingParts")
    assert sorted(rows_of(moving)) == ["Crank", "Rod", "Slider"], rows_of(moving)
    before = len(doc.Objects)
    click(find(QtWidgets.QPushButton, "SweptVolumeTakeAll"))  # reads the motions again
    yield 0.3
    assert moving.rowCount() == 3 and len(doc.Objects) == before, len(doc.Objects)
    find(QtWidgets.QCheckBox, "SweptVolumeStanding").setChecked(True)
    yield 0.2
    rule_table = find(QtWidgets.QTableWidget, "SweptVolumePairRules")
    assert rule_table.rowCount() == 6, rows_of(rule_table)
    click(find(QtWidgets.QPushButton, "SweptVolumeTouchingPairs"))
    yield lambda: rule_table.item(rows_of(rule_table)["Crank - Rod"], 2).text() == "Contact allowed"
    texts = [rule_table.item(r, 2).text() for r in range(6)]
    assert texts.count("Contact allowed") == 2, texts
    undo, gaps = doc.UndoCount, Gaps()
    click(find(QtWidgets.QPushButton, "SweptVolumeCheckMechanism"))
    yield lambda: doc.getObject("Mechanism") is not None
    yield 0.5
    say("the window stood still for " + gaps.stop())
    obj = doc.getObject("Mechanism")
    assert obj.Status == mechanism.UP_TO_DATE, (obj.Status, obj.Message)
    assert doc.UndoCount == undo + 1, doc.UndoNames
    assert list(obj.RuleKinds) == ["Contact", "Contact"], obj.RuleKinds
    table = find(QtWidgets.QTableWidget, "SweptVolumeClearanceTable")
    rows = rows_of(table)
    assert table.item(rows["Crank - Rod"], 1).text() == "Allowed contact"
    wall_row = rows["Slider - Wall"]
    assert abs(float(table.item(wall_row, 2).text()) - 5) < 0.01, table.item(wall_row, 2).text()
    shot("81_mechanism")
    # A selected row: both parts at its time, and the line between them.
    drawn = graph.getNumChildren()
    table.selectRow(wall_row)
    yield lambda: graph.getNumChildren() == drawn + 2  # two parts and a line
    table.itemDoubleClicked.emit(table.item(wall_row, 0))
    yield 0.5
    shot("82_mechanism_row")
    yield 1.0
    # The player continues from there, with every part at its own place.
    player = find(QtWidgets.QSlider, "SweptVolumeTime")
    player.setValue(300)
    yield 0.3
    Gui.SendMsgToActiveView("ViewFit")
    shot("83_mechanism_player")
    yield 1.0
    path = os.path.join(tempfile.mkdtemp(), "table.csv")
    file_dialogs.ask_table = lambda name: path
    click(find(QtWidgets.QPushButton, "SweptVolumeCsv"))
    yield 0.3
    with open(path, encoding="utf-8") as file:
        lines = file.read().splitlines()
    assert lines[0].startswith("First,Second,Verdict") and len(lines) == 1 + len(rows), lines
    click(panel_button(Close))
    yield no_panel
    assert graph.getNumChildren() == drawn, graph.getNumChildren()
    # The panel is opened again from the tree: the rules are there. A very fine accuracy makes the check
    # long; it is stopped at once, and the old result stays.
    select(obj)
    Gui.runCommand("SweptVolume_Mechanism")
    yield 0.3
    rule_table = find(QtWidgets.QTableWidget, "SweptVolumePairRules")
    assert rule_table.item(rows_of(rule_table)["Rod - Slider"], 2).text() == "Contact allowed"
    find(QtWidgets.QWidget, "SweptVolumeMechanismAccuracy").setProperty("rawValue", 1e-5)
    summary = obj.Summary
    click(find(QtWidgets.QPushButton, "SweptVolumeCheckMechanism"))
    took = yield from stopped(find(QtWidgets.QPushButton, "SweptVolumeCheckMechanism").isEnabled)
    say("stopped after {:.2f} s".format(took))
    assert obj.Summary == summary
    click(panel_button(Close))
    yield no_panel
    doc.undo()
    yield 0.2
    assert doc.getObject("Mechanism") is None, doc.UndoNames


run(scenario)
