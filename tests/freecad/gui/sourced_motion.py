# SPDX-License-Identifier: LGPL-2.1-or-later
"""A motion with a source: when a key is changed, a question asks whether to remove the link to the source.
The settings can be edited later. No entry of the menus in the tree occurs twice.
"""
import os
import sys

sys.path.insert(0, os.path.dirname(os.path.realpath(__file__)))
from driver import (  # noqa: E402
    App,
    Gui,
    Ok,
    QtCore,
    QtGui,
    QtWidgets,
    choose,
    click,
    find,
    new_document,
    no_panel,
    open_workbench,
    panel_button,
    run,
    select,
    shot,
    tree,
)

V = App.Vector


def answering(button, picture=""):
    """Presses a button of the next question from the event loop. Returns the text of the question."""
    questions = []

    def answer():
        box = QtWidgets.QApplication.activeModalWidget()
        if not isinstance(box, QtWidgets.QMessageBox):
            QtCore.QTimer.singleShot(50, answer)
            return
        questions.append(box.text())
        if picture:
            shot(picture)
        click(box.button(button))

    QtCore.QTimer.singleShot(50, answer)
    return questions


def menu_of(name):
    """Returns the texts of the context menu of an object in the tree."""
    view = tree()
    item = next(
        i for i in view.findItems(name, QtCore.Qt.MatchExactly | QtCore.Qt.MatchRecursive, 0)
    )
    view.setCurrentItem(item)
    texts = []

    def read_menu():
        menu = QtWidgets.QApplication.activePopupWidget()
        if menu is None:
            QtCore.QTimer.singleShot(50, read_menu)
            return
        texts.extend(a.text().replace("&", "") for a in menu.actions() if not a.isSeparator())
        shot("72_menu_" + name)
        menu.close()

    QtCore.QTimer.singleShot(100, read_menu)
    place = view.visualItemRect(item).center()
    event = QtGui.QContextMenuEvent(
        QtGui.QContextMenuEvent.Mouse, place, view.viewport().mapToGlobal(place)
    )
    QtWidgets.QApplication.sendEvent(view.viewport(), event)
    return texts


def scenario():
    import Part

    from sweptvolume.features import envelope, motion
    from sweptvolume.panels import motion_panel

    open_workbench()
    doc = new_document("Sourced")
    part, wire = doc.addObject("Part::Box", "Slide"), doc.addObject("Part::Feature", "Wire")
    wire.Shape = Part.makePolygon([V(), V(60, 0, 0), V(60, 40, 0)])
    path = motion.motion_from_source(doc, "Curve", [wire])
    hull = envelope.make_envelope(doc, [part], path, Resolution=24)
    doc.recompute()
    yield 0.3

    # "No" leaves key and link as they are.
    select(path)
    Gui.runCommand("SweptVolume_EditMotion")
    yield
    panel = motion_panel.opened[-1]
    table = find(QtWidgets.QTableWidget, "SweptVolumeKeys")
    questions = answering(QtWidgets.QMessageBox.No, "70_cut")
    table.item(1, 1).setText("77")
    yield
    assert questions and "Wire" in questions[0], questions
    assert table.item(1, 1).text() == "60" and not panel.history.before
    shot("71_sourced_editor")
    yield 0.3
    click(panel_button(Ok))
    yield no_panel
    assert path.SourceType == "Curve" and path.Placements[1].Base.x == 60

    # "Yes" removes the link, once for all keys; Undo restores it.
    Gui.runCommand("SweptVolume_EditMotion")
    yield
    table = find(QtWidgets.QTableWidget, "SweptVolumeKeys")
    questions = answering(QtWidgets.QMessageBox.Yes)
    table.item(1, 1).setText("77")
    table.item(2, 1).setText("78")
    yield
    assert len(questions) == 1
    click(panel_button(Ok))
    yield no_panel
    assert path.SourceType == "Stored" and path.Placements[1].Base.x == 77
    doc.undo()
    doc.recompute()
    assert path.SourceType == "Curve" and path.Placements[1].Base.x == 60

    # The settings are shown and changed, and the source is read again, in one undo step.
    select(path)
    Gui.runCommand("SweptVolume_EditSource")
    yield
    choose("SweptVolumeOrientation", "Tangent")
    yield
    shot("73_settings")
    yield 0.3
    click(panel_button(Ok))
    yield no_panel
    assert path.SourceOrientation == "Tangent" and path.Count == 4, path.Count
    assert len([o for o in doc.Objects if motion.is_motion(o)]) == 1
    Gui.runCommand("SweptVolume_EditSource")
    yield
    assert find(QtWidgets.QComboBox, "SweptVolumeOrientation").currentData() == "Tangent"
    click(panel_button(Ok))
    yield no_panel
    doc.undo()
    doc.undo()
    doc.recompute()
    assert (path.SourceOrientation, path.Count) == ("Fixed", 3)

    # Menus of the tree.
    for name, wanted in ((path.Label, "Edit motion"), (hull.Label, "Edit envelope")):
        texts = menu_of(name)
        yield
        plain = [text.rstrip(".") for text in texts]
        assert wanted in plain, texts
        assert len(plain) == len(set(plain)), texts
    App.closeDocument(doc.Name)
    yield


run(scenario)
