# SPDX-License-Identifier: LGPL-2.1-or-later
"""The motion editor: Undo applies to its keys, rows of a spreadsheet can be pasted, FreeCAD's Transform is
locked, hidden objects stay hidden, and lengths can be in inches.
"""
import os
import sys

sys.path.insert(0, os.path.dirname(os.path.realpath(__file__)))
from driver import (  # noqa: E402
    App,
    Cancel,
    Gui,
    Ok,
    QtCore,
    QtGui,
    QtWidgets,
    click,
    find,
    new_document,
    no_panel,
    open_workbench,
    panel_button,
    press,
    run,
    shot,
)

V = App.Vector
HELD = QtCore.Qt.ControlModifier


def undo_key(name):
    """Presses the keys of Undo or Redo. Checks first that they belong to one shortcut only."""
    from sweptvolume.panels import motion_panel

    panel = motion_panel.opened[-1]
    wanted = {"undo": "Ctrl+Z", "redo": "Ctrl+Shift+Z"}[name]
    ours = [k for k in panel.undo_keys.keys if k.key().toString() == wanted]
    assert len(ours) == 1, [k.key().toString() for k in panel.undo_keys.keys]
    theirs = [a for a, _ in panel.undo_keys.taken if a.shortcuts()]
    assert not theirs, "FreeCAD's own Undo still has its keys"
    ours[0].activated.emit()


def entries(kind):
    """A generator of (menu or toolbar, entry) for all entries."""
    for holder in Gui.getMainWindow().findChildren(kind):
        for action in holder.actions():
            yield holder, action


def toolbar_button(name):
    """Returns the toolbar button of the entry with this object name."""
    found = [(h, a) for h, a in entries(QtWidgets.QToolBar) if a.objectName() == name]
    assert found, [a.text() for _, a in entries(QtWidgets.QToolBar)]
    return found[0][0].widgetForAction(found[0][1])


def scenario():
    from sweptvolume.features import motion
    from sweptvolume.panels import motion_panel, widgets

    open_workbench()
    yield
    doc = new_document("Keys")
    doc.openTransaction("Part")
    box = doc.addObject("Part::Box", "Slide")
    doc.commitTransaction()
    doc.openTransaction("Motion")
    places = [App.Placement(), App.Placement(V(30, 0, 0), App.Rotation())]
    path = motion.motion_from_poses(doc, [0, 1], places)
    doc.recompute()
    doc.commitTransaction()
    path.ViewObject.Visibility = False
    undo = list(doc.UndoNames)
    # Shortcuts that a user has set in FreeCAD's preferences apply as well.
    own = QtGui.QKeySequence("Ctrl+Alt+R")
    for action in widgets.actions_of("Std_Redo"):
        action.setShortcuts(action.shortcuts() + [own])
    panel = motion_panel.show(doc, path, (box, ""))
    yield 0.5
    assert own in [k.key() for k in panel.undo_keys.keys]
    table = find(QtWidgets.QTableWidget, "SweptVolumeKeys")
    table.item(1, 1).setText("40")
    table.setCurrentCell(1, 1)
    press(table, QtCore.Qt.Key_Insert)
    yield
    assert table.rowCount() == 3 or len(panel.keys) == 3
    undo_key("undo")
    assert len(panel.keys) == 2 and table.item(1, 1).text() == "40"
    undo_key("undo")
    assert table.item(1, 1).text() == "30", table.item(1, 1).text()
    undo_key("undo")
    assert panel.message.text() and doc.getObject("Slide") is not None
    assert list(doc.UndoNames) == undo
    undo_key("redo")
    assert table.item(1, 1).text() == "40"
    # The buttons of the toolbar and the entries of the menu apply to the keys as well.
    undo_button, redo_button = (toolbar_button("SweptVolume" + n) for n in ("Undo", "Redo"))
    assert undo_button.isEnabled() and redo_button.isEnabled()
    click(undo_button)
    assert table.item(1, 1).text() == "30" and not undo_button.isEnabled()
    click(redo_button)
    assert table.item(1, 1).text() == "40" and list(doc.UndoNames) == undo
    edit = next(
        m
        for m in Gui.getMainWindow().findChildren(QtWidgets.QMenu)
        if [a for a in m.actions() if a.objectName() == "Std_Undo"]
    )
    seen = [a.objectName() for a in edit.actions() if a.isVisible()]
    assert "SweptVolumeUndo" in seen and "Std_Undo" not in seen, seen
    # Rows of a spreadsheet are pasted over the second key and those after it; invalid text changes
    # nothing.
    clipboard = QtWidgets.QApplication.clipboard()
    table.setCurrentCell(1, 1)
    clipboard.setText("t\tx\ty\tz\n2\t50\t0\t1 cm\n3,5\t60\t5\t0\n")
    press(table, QtCore.Qt.Key_V, HELD)
    yield
    assert panel.keys.times == [0, 2, 3.5], panel.keys.times
    assert abs(panel.keys.placements[1].Base.z - 10) < 1e-9
    for text in ("1\t2\t3", "0\t1\t2\t3", "x1\ty\tz\tw", ""):
        clipboard.setText(text)
        press(table, QtCore.Qt.Key_V, HELD)
        yield
        assert panel.message.text() and panel.keys.times == [0, 2, 3.5], text
    shot("63_pasted")
    yield 0.3
    table.clearSelection()
    table.setRangeSelected(QtWidgets.QTableWidgetSelectionRange(1, 0, 1, 6), True)
    press(table, QtCore.Qt.Key_C, HELD)
    assert clipboard.text() == "2\t50\t0\t10\t0\t0\t0", clipboard.text()
    # Transform is locked; the chosen key stays chosen.
    box_of_pivot = find(QtWidgets.QComboBox, "SweptVolumePivot")
    assert box_of_pivot.currentData() == "Origin"
    box_of_pivot.setCurrentIndex(box_of_pivot.findData("Middle"))
    Gui.getDocument(doc.Name).setEdit(box.Name, 1)
    yield lambda: motion_panel.opened[-1] is not panel
    yield 0.5
    panel = motion_panel.opened[-1]
    assert Gui.getDocument(doc.Name).getInEdit() is None and "Transform" in panel.message.text()
    assert find(QtWidgets.QComboBox, "SweptVolumePivot").currentData() == "Middle"
    assert panel.keys.times == [0, 2, 3.5] and panel.history.before, panel.keys.times
    shot("64_transform")
    yield 0.3
    click(panel_button(Cancel))
    yield no_panel
    assert not path.ViewObject.Visibility and list(path.Times) == [0, 1]
    action = widgets.actions_of("Std_Undo")
    assert action and action[0].shortcuts(), "FreeCAD's Undo has lost its keys"
    yield
    seen = [a.objectName() for a in edit.actions() if a.isVisible()]
    assert "SweptVolumeUndo" not in seen and "Std_Undo" in seen, seen
    texts = [a.text() for _, a in entries(QtWidgets.QToolBar) if a.isVisible()]
    assert texts.count(action[0].text()) == 1, texts
    # Inches: numbers typed and shown are inches.
    App.Units.setSchema(3)
    panel = motion_panel.show(doc, path, (box, ""))
    yield 0.5
    table = find(QtWidgets.QTableWidget, "SweptVolumeKeys")
    assert table.horizontalHeaderItem(1).text() == "x\nin"
    assert table.item(1, 1).text() == "1.181", table.item(1, 1).text()
    table.item(1, 1).setText("2")
    assert abs(panel.keys.placements[1].Base.x - 50.8) < 1e-9
    table.item(1, 1).setText("2 mm")
    assert abs(panel.keys.placements[1].Base.x - 2) < 1e-9
    shot("65_inches")
    yield 0.3
    click(panel_button(Ok))
    yield no_panel
    App.Units.setSchema(0)
    assert abs(path.Placements[1].Base.x - 2) < 1e-9
    App.closeDocument(doc.Name)
    yield


run(scenario)
