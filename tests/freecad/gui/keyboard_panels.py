# SPDX-License-Identifier: LGPL-2.1-or-later
"""Every panel with the keyboard only: objects are selected in the tree, commands in the menu, fields with
Tab, files in their dialogs. The X server sends the keys.
"""
import os
import sys
import tempfile

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
from x_keyboard import chosen_in_tree, entry, focused, keyboard_or_leave  # noqa: E402

CSV = "t,tx,ty,tz,qx,qy,qz,qw\n0,0,0,0,0,0,0,1\n1,4,0,0,0,0,0,1\n2,4,4,0,0,0,0.7071068,0.7071068\n"


def opened():
    return not no_panel()


def in_file_dialog(keyboard, path):
    """Types a path into the open file dialog; a generator."""
    yield lambda: QtWidgets.QApplication.activeModalWidget() is not None
    yield 0.3
    keyboard.give(QtWidgets.QApplication.activeModalWidget())
    yield from keyboard.press("Control_L+a")
    yield from keyboard.type(path, "Return")
    yield lambda: QtWidgets.QApplication.activeModalWidget() is None
    keyboard.give(Gui.getMainWindow())
    yield 0.3


def motions(doc):
    from sweptvolume.features.motion import is_motion

    return [o for o in doc.Objects if is_motion(o)]


def from_file(keyboard, doc, folder):
    """Makes a motion with Motion from file: the file, its unit, OK. Returns the motion."""
    with open(os.path.join(folder, "path.csv"), "w") as out:
        out.write(CSV)
    # The dialog has its own event loop, so a second scenario sends its keys.
    beside(in_file_dialog(keyboard, os.path.join(folder, "path.csv")))
    yield from keyboard.press(*entry("MotionFromFile"))
    yield opened
    yield 0.4
    yield from keyboard.tab_to("SweptVolumeUnit")
    yield from keyboard.press("Down")  # from mm to cm
    assert find(QtWidgets.QComboBox, "SweptVolumeUnit").currentData() == "cm"
    shot("90_keyboard_file")
    yield 0.5
    yield from keyboard.press("Return")
    yield no_panel
    motion = motions(doc)[-1]
    assert abs(motion.Placements[2].Base.y - 40) < 1e-9, motion.Placements
    motion.PoseType = "Relative"
    doc.recompute()
    return motion


def beside(steps):
    """Runs a generator while a dialog has its own event loop."""
    from PySide import QtCore

    def on(wait=None):
        if wait is not None and not wait():
            QtCore.QTimer.singleShot(30, lambda: on(wait))
            return
        try:
            wanted = next(steps)
        except StopIteration:
            return
        if callable(wanted):
            on(wanted)
        else:
            QtCore.QTimer.singleShot(int(1000 * (wanted or 0.15)), on)

    QtCore.QTimer.singleShot(300, on)


def from_wire(keyboard, doc):
    """Makes a motion with Motion from object: a curve, number of poses, orientation."""
    yield from chosen_in_tree(keyboard, "Helix")
    yield from keyboard.press(*entry("MotionFromSource"))
    yield opened
    yield 0.4
    assert focused() in ("SweptVolumeAccuracy", "qt_spinbox_lineedit"), focused()
    yield from keyboard.type("0.2", "Tab")
    yield from keyboard.tab_to("SweptVolumeOrientation")
    yield from keyboard.press("Down")
    assert find(QtWidgets.QComboBox, "SweptVolumeOrientation").currentData() == "Tangent"
    shot("91_keyboard_wire")
    yield 0.5
    yield from keyboard.press("Return")
    yield no_panel
    made = motions(doc)[-1]
    assert made.Count > 20 and made.SourceType == "Curve", (made.Count, made.SourceType)
    assert made.SourceAccuracy.Value == 0.2 and made.SourceOrientation == "Tangent"


def from_value(keyboard, doc):
    """Makes a motion with Motion from driving value: two objects selected in order, and a range."""
    yield from chosen_in_tree(keyboard, "Drive", "Block")
    assert [o.Label for o in Gui.Selection.getSelection()] == ["Drive", "Block"]
    yield from keyboard.press(*entry("MotionDriven"))
    yield opened
    yield 0.4
    box = find(QtWidgets.QComboBox, "SweptVolumeValue")
    yield from keyboard.tab_to("SweptVolumeValue")
    for _ in range(box.count()):
        if box.currentData() == "Radius":
            break
        yield from keyboard.press("Down")
    assert box.currentData() == "Radius", [box.itemData(k) for k in range(box.count())]
    for name, text in (("Start", "2"), ("End", "12")):
        yield from keyboard.tab_to("SweptVolume" + name)
        yield from keyboard.press("Control_L+a")
        yield from keyboard.type(text, "Tab")
    shot("92_keyboard_value")
    yield 0.5
    yield from keyboard.press("Return")
    yield no_panel
    made = motions(doc)[-1]
    assert made.SourceType == "Driven" and abs(made.Placements[-1].Base.x - 12) < 1e-6, made.Count


def from_selection(keyboard, doc):
    yield from chosen_in_tree(keyboard, "Block", "Wall", "Helix")
    chosen = [o.Label for o in Gui.Selection.getSelection()]
    assert chosen == ["Block", "Wall", "Helix"], chosen
    before = len(motions(doc))
    yield from keyboard.press(*entry("MotionFromSelection"))
    yield 0.5
    assert len(motions(doc)) == before + 1, len(motions(doc))
    assert motions(doc)[-1].Count == 3, motions(doc)[-1].Count


def envelope(keyboard, doc, motion):
    """Uses Create envelope: the envelope is computed, stopped, computed again. Parts are added from
    the tree while the panel is open."""
    from sweptvolume import runner

    yield from chosen_in_tree(keyboard, "Block", motion.Label)
    yield from keyboard.press(*entry("Envelope"))
    yield opened
    yield 0.5
    parts = find(QtWidgets.QTableWidget, "SweptVolumeParts")
    yield from chosen_in_tree(keyboard, "Wall")
    yield from keyboard.press("Control_L+t")
    yield 0.3
    assert focused() == "SweptVolumeParts", focused()
    yield from keyboard.press("Alt_L+a")
    yield lambda: parts.rowCount() == 2
    yield from keyboard.tab_to("SweptVolumeOwnMotion2")  # the box of the second row
    yield from keyboard.press("Down")
    assert parts.cellWidget(1, 1).currentIndex() == 1
    yield from keyboard.tab_to("SweptVolumeParts", "Shift_L+Tab")
    yield from keyboard.press("Down", "Alt_L+r")
    yield lambda: parts.rowCount() == 1
    assert parts.item(0, 0).text().startswith("Block")
    yield from keyboard.tab_to("SweptVolumeResolution")
    yield from keyboard.press("Control_L+a")
    yield from keyboard.type("1500", "Return")
    yield lambda: runner.running() and runner.running()[0].control.progress() > 0.01
    yield 0.3
    assert focused() == "SweptVolumeStop", focused()
    yield from keyboard.press("space")
    yield lambda: not runner.running()
    yield 0.3
    assert doc.getObject("Envelope") is None and opened()
    yield from keyboard.tab_to("SweptVolumeResolution")
    yield from keyboard.press("Control_L+a")
    yield from keyboard.type("96", "Return")
    yield no_panel
    assert doc.getObject("Envelope").Resolution == 96


def clearance(keyboard, doc):
    """Uses Check clearance: runs the check, selects a row, sorts, colours, writes a file,
    closes."""
    yield from chosen_in_tree(keyboard, "Envelope")
    yield from keyboard.press(*entry("Clearance"))
    yield opened
    yield 0.5
    yield from keyboard.press("Return")
    yield lambda: doc.getObject("Clearance") is not None
    yield 0.5
    check = doc.getObject("Clearance")
    table = find(QtWidgets.QTableWidget, "SweptVolumeClearanceTable")
    assert focused() == "SweptVolumeClearanceTable", focused()
    yield from keyboard.press("Down", "Down")
    assert table.selectedItems()[0].row() == table.currentRow() == 2, table.currentRow()
    assert check.ViewObject.Proxy.row.getNumChildren() >= 1
    yield from keyboard.press(*["Left"] * 4, "space")
    names = [table.item(r, 0).text() for r in range(table.rowCount())]
    assert len(names) > 2 and names == sorted(names), names
    yield from keyboard.press("space")
    names = [table.item(r, 0).text() for r in range(table.rowCount())]
    assert names == sorted(names, reverse=True), names
    yield from keyboard.tab_to("SweptVolumeColours")
    yield from keyboard.press("space")
    assert check.ViewObject.Proxy.colours.getNumChildren() == 1
    yield from keyboard.tab_to("SweptVolumeRequiredBand")
    yield from keyboard.press("Control_L+a")
    yield from keyboard.type("2 cm", "Tab")
    band = find(QtWidgets.QWidget, "SweptVolumeRequiredBand")
    yield lambda: abs(band.property("rawValue") - 20) < 1e-9
    shot("93_keyboard_clearance")
    yield 0.6
    yield from keyboard.tab_to("SweptVolumeSheet")
    yield from keyboard.press("space")
    yield 0.4
    assert [o for o in doc.Objects if o.isDerivedFrom("Spreadsheet::Sheet")]
    # Other neighbours, chosen in the tree; checked again.
    yield from chosen_in_tree(keyboard, "Wall")
    yield from keyboard.press("Control_L+t")
    yield from keyboard.tab_to("SweptVolumeTakeNeighbours")
    yield from keyboard.press("space", "Return")
    yield lambda: check.Neighbours and table.rowCount() == 1
    yield 0.4
    yield from keyboard.press("Escape")
    yield no_panel


def solid_and_file(keyboard, doc, folder):
    """Uses Make solid with a limit of faces, and exports to a file that is chosen in its dialog."""
    yield from chosen_in_tree(keyboard, "Envelope")
    yield from keyboard.press(*entry("Solid"))
    yield opened
    yield 0.5
    yield from keyboard.tab_to("SweptVolumeSolidTolerance")
    yield from keyboard.press("Control_L+a")
    yield from keyboard.type("0.2 mm", "Tab")
    yield from keyboard.tab_to("SweptVolumeMaxFaces")
    yield from keyboard.press("Control_L+a")
    yield from keyboard.type("7000")
    shot("94_keyboard_solid")
    yield 0.5
    yield from keyboard.press("Return")
    yield no_panel
    body = doc.getObject("EnvelopeSolid")
    assert body.MaxFaces == 7000 and body.Shape.isValid() and body.Tolerance.Value == 0.2
    path = os.path.join(folder, "out.step")
    yield from chosen_in_tree(keyboard, "Envelope")
    beside(in_file_dialog(keyboard, path))
    yield from keyboard.press(*entry("Export"))
    yield opened
    yield 0.5
    yield from keyboard.tab_to("SweptVolumeTessellated")
    yield from keyboard.press("space")
    assert find(QtWidgets.QCheckBox, "SweptVolumeTessellated").isChecked()
    yield from keyboard.press("space")
    yield from keyboard.tab_to("SweptVolumeMaxMegabytes")
    yield from keyboard.type("40")
    shot("95_keyboard_export")
    yield 0.5
    yield from keyboard.press("Return")
    yield no_panel
    assert os.path.getsize(path) > 1000


def scenario():
    import Part

    open_workbench()
    yield
    keyboard = keyboard_or_leave()
    folder = tempfile.mkdtemp()
    doc = new_document("Keyboard")
    block = doc.addObject("Part::Box", "Block")
    for name, place in (("Wall", (30, 60, 0)), ("Post", (70, 10, 0)), ("Roof", (0, 0, 40))):
        doc.addObject("Part::Box", name).Placement.Base = App.Vector(*place)
    drive = doc.addObject("Part::Cylinder", "Drive")
    drive.Placement.Base = App.Vector(-60, 0, 0)
    helix = doc.addObject("Part::Feature", "Helix")
    helix.Shape = Part.makeHelix(10, 40, 20)
    helix.Placement.Base = App.Vector(0, -80, 0)
    block.setExpression("Placement.Base.x", "Drive.Radius")
    doc.recompute()
    Gui.activeDocument().activeView().viewIsometric()
    Gui.SendMsgToActiveView("ViewFit")
    yield 0.5
    motion = yield from from_file(keyboard, doc, folder)
    yield from from_wire(keyboard, doc)
    yield from from_value(keyboard, doc)
    yield from from_selection(keyboard, doc)
    yield from envelope(keyboard, doc, motion)
    yield from clearance(keyboard, doc)
    yield from solid_and_file(keyboard, doc, folder)
    App.closeDocument(doc.Name)
    yield


run(scenario)
