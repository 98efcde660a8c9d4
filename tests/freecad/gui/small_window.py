# SPDX-License-Identifier: LGPL-2.1-or-later
"""Every panel in a window of 1024 x 700 pixels, opened in a narrow dock: the dock becomes as wide as the
panel needs, and nothing is cut off at the sides. Also: messages about unusual input, the speed of the player
in real time, and what remains after an editor is closed.
"""
import os
import sys
import tempfile
import time

sys.path.insert(0, os.path.dirname(os.path.realpath(__file__)))
from driver import (  # noqa: E402
    App,
    Gui,
    QtCore,
    QtWidgets,
    find,
    new_document,
    no_panel,
    run,
    say,
    shot,
)

V = App.Vector


def area_of(form):
    """Returns the scroll area of a panel."""
    widget = form
    while widget is not None and not isinstance(widget, QtWidgets.QScrollArea):
        widget = widget.parentWidget()
    assert widget is not None, "the panel does not scroll"
    return widget


def cut_off(form):
    """Returns the names of the widgets that are cut off, wherever the panel is scrolled to."""
    area, found = area_of(form), []
    if area.horizontalScrollBar().isVisible():
        found.append("the panel is wider than its dock")
    width = area.viewport().width()
    for widget in form.findChildren(QtWidgets.QWidget):
        buttons = (QtWidgets.QPushButton, QtWidgets.QToolButton, QtWidgets.QCheckBox)
        if not isinstance(widget, buttons) or not widget.isVisible() or not widget.text():
            continue
        left = widget.mapTo(area.viewport(), widget.rect().topLeft()).x()
        needs = widget.fontMetrics().size(QtCore.Qt.TextShowMnemonic, widget.text()).width() + 4
        if isinstance(widget, QtWidgets.QCheckBox):
            needs = widget.sizeHint().width()
        narrow = widget.width() < needs
        if narrow or left < 0 or left + widget.width() > width:
            found.append("{} {}".format(widget.objectName(), widget.text()))
    return found


def narrow_dock():
    """Makes the dock with the tree and the panels narrower than most panels."""
    window = Gui.getMainWindow()
    for dock in window.findChildren(QtWidgets.QDockWidget, "Combo View"):
        dock.show()  # FreeCAD 0.20 may hide it until a panel opens in it
        window.resizeDocks([dock], [240], QtCore.Qt.Horizontal)


def panels_fit(doc, folder):
    import Part

    from sweptvolume.panels import (
        clearance_panel,
        envelope_panel,
        file_panel,
        find_path_panel,
        improve_panel,
        made_panel,
        mechanism_panel,
        motion_panel,
        overlap_panel,
        sequence_panel,
        solid_panel,
        source_panel,
        study_panel,
    )

    wire = doc.addObject("Part::Feature", "Wire")
    wire.Shape = Part.makePolygon([V(), V(20, 0, 0), V(20, 20, 0)])
    csv = os.path.join(folder, "way.csv")
    with open(csv, "w") as out:
        out.write("0,0,0,0,0,0,0,1\n1,9,0,0,0,0,0,1\n")
    part, path, hull = [(doc.Slide, "")], doc.Motion, doc.Envelope
    bad = []
    for name, opened in (
        ("envelope", lambda: envelope_panel.show(doc, obj=hull)),
        ("clearance", lambda: clearance_panel.show(doc, envelope=hull)),
        ("solid", lambda: solid_panel.show(hull)),
        ("file", lambda: file_panel.show(doc, csv)),
        ("wire", lambda: source_panel.show(doc, "Curve", [wire])),
        ("motion", lambda: motion_panel.show(doc, path, part[0])),
        ("path", lambda: find_path_panel.show(doc, pairs=part)),
        ("improve", lambda: improve_panel.show(doc, motion=path, pairs=part)),
        ("sequence", lambda: sequence_panel.show(doc, pairs=part)),
        ("made", lambda: made_panel.show(doc, hull)),
        ("mechanism", lambda: mechanism_panel.show(doc, pairs=part, motions=[path])),
        ("overlap", lambda: overlap_panel.show(doc, part)),
        ("study", lambda: study_panel.show(doc)),
    ):
        narrow_dock()
        yield 0.2
        panel = opened()
        yield 0.8
        shot("70_small_" + name)
        yield 0.4
        bad += ["{}: {}".format(name, text) for text in cut_off(panel.form)]
        panel.reject()
        yield no_panel
    assert not bad, bad
    doc.removeObject(wire.Name)


def unusual_input(doc):
    from sweptvolume.features import motion
    from sweptvolume.panels import envelope_panel

    panel = envelope_panel.show(doc, obj=doc.Envelope)
    yield 0.3
    edit = panel.resolution.lineEdit()
    edit.setText("100000")
    panel.resolution.interpretText()
    assert panel.resolution.value() == 100000, panel.resolution.value()
    assert edit.text() != "100000" and edit.text().replace(edit.text()[3], "") == "100000"
    yield lambda: any(mark in panel.estimate_label.text() for mark in ("cells", "memory"))
    panel.reject()
    yield no_panel
    still = motion.motion_from_poses(doc, [0], [App.Placement()])
    doc.recompute()
    panel = envelope_panel.show(doc, [(doc.Slide, "")], still)
    yield lambda: "one pose" in panel.estimate_label.text()
    panel.reject()
    yield no_panel
    doc.removeObject(still.Name)


def player_and_dragger(doc):
    from sweptvolume.panels import motion_panel

    doc.Motion.Times = [0, 60]
    doc.recompute()
    shown = {o.Name: o.Visibility for o in doc.Objects}
    nodes = Gui.activeDocument().activeView().getSceneGraph().getNumChildren()
    for _ in range(2):
        panel = motion_panel.show(doc, doc.Motion, (doc.Slide, ""))
        yield 0.4
        find(QtWidgets.QTableWidget, "SweptVolumeKeys").setCurrentCell(0, 1)
        yield 0.3
        panel.player.go_to(0.0)
        for speed in (1.0, 2.0):
            panel.player.speed.setCurrentIndex(panel.player.speed.findData(speed))
            start, began = panel.player.now(), time.perf_counter()
            panel.player.play.setChecked(True)
            yield 1.0
            panel.player.play.setChecked(False)
            part = (panel.player.now() - start) / (speed * (time.perf_counter() - began))
            say("60 s at speed {}: {:.2f} of real time".format(speed, part))
            assert 0.5 < part < 1.05, part
        panel.reject()
        yield no_panel
        yield 0.2
    assert {o.Name: o.Visibility for o in doc.Objects} == shown
    assert Gui.activeDocument().activeView().getSceneGraph().getNumChildren() == nodes


def scenario():
    from sweptvolume.features import envelope, motion

    Gui.activateWorkbench("SweptVolumeWorkbench")
    window = Gui.getMainWindow()
    window.showNormal()
    window.resize(1024, 700)
    yield 0.5
    assert (window.width(), window.height()) == (1024, 700), window.size()
    doc = new_document("Small")
    doc.addObject("Part::Box", "Slide")
    doc.addObject("Part::Box", "Wall").Placement.Base = V(0, 13, 0)
    places = [App.Placement(), App.Placement(V(30, 0, 0), App.Rotation())]
    path = motion.motion_from_poses(doc, [0, 1], places)
    doc.recompute()
    hull = envelope.make_envelope(doc, [doc.Slide], path, Resolution=24, MadeBy="Session")
    doc.recompute()
    envelope.compute(hull)
    yield 0.3
    with tempfile.TemporaryDirectory() as folder:
        yield from panels_fit(doc, folder)
    yield from unusual_input(doc)
    yield from player_and_dragger(doc)
    App.closeDocument(doc.Name)
    yield


run(scenario)
