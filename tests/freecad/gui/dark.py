# SPDX-License-Identifier: LGPL-2.1-or-later
"""The panels with a dark style, which test_gui.py sets in the profile: they are opened and filled, and
pictures are taken.
"""
import os
import sys

sys.path.insert(0, os.path.dirname(os.path.realpath(__file__)))
from driver import (  # noqa: E402
    App,
    Cancel,
    Close,
    Gui,
    QtGui,
    QtWidgets,
    check_table,
    click,
    contrast_of,
    find,
    new_document,
    no_panel,
    open_workbench,
    panel_button,
    read_verdicts,
    run,
    say,
    select,
    shot,
)

V = App.Vector


def scenario():
    from sweptvolume.features import clearance, envelope, motion

    open_workbench()
    yield
    window = Gui.getMainWindow()
    doc = new_document("Dark")
    box, wall = doc.addObject("Part::Box", "Slide"), doc.addObject("Part::Box", "Wall")
    wall.Placement.Base = V(0, 13, 0)
    for name, place in (("In", V(20, 5, 5)), ("On", V(0, -10, 0)), ("Off", V(0, 0, 60))):
        doc.addObject("Part::Box", name).Placement.Base = place
    places = [App.Placement(), App.Placement(V(30, 0, 0), App.Rotation())]
    path = motion.motion_from_poses(doc, [0, 1], places)
    doc.recompute()
    hull = envelope.make_envelope(doc, [box], path, Resolution=40)
    doc.recompute()
    envelope.compute(hull)
    Gui.activeDocument().activeView().viewIsometric()
    Gui.SendMsgToActiveView("ViewFit")
    yield
    for name, items in (
        ("EditMotion", (box, path)),
        ("EditEnvelope", (hull,)),
        ("Clearance", (hull,)),
        ("Solid", (hull,)),
        ("Mechanism", (box, path)),
        ("Overlap", (box, wall)),
        ("Study", ()),
    ):
        select(*items)
        Gui.runCommand("SweptVolume_" + name)
        yield 0.8
        Gui.Selection.clearSelection()
        if name == "Clearance":
            click(find(QtWidgets.QPushButton, "SweptVolumeCheck"))
            yield lambda: doc.getObject("Clearance") is not None
            yield 0.5
            found = doc.getObject("Clearance")
            assert found.Status == clearance.UP_TO_DATE, found.Status
            table = find(QtWidgets.QTableWidget, "SweptVolumeClearanceTable")
            check_table(table)
            table.clearSelection()
            behind = read_verdicts(table)
            assert len(set(behind.values())) == 4, behind
            ratio, behind = contrast_of(find(QtWidgets.QWidget, "SweptVolumeDistanceGraph"))
            say("graph on {}: contrast {:.1f}".format(behind, ratio))
            assert ratio >= 4.5, (behind, ratio)
        form = [w for w in window.findChildren(QtWidgets.QGroupBox) if w.isVisible()][0]
        text = form.palette().color(QtGui.QPalette.WindowText).lightness()
        say("{}: lightness of the text {}".format(name, text))
        assert text > 127, "the theme is not dark"
        shot("42_dark_" + name)
        yield 0.8
        if name == "Overlap":
            click(find(QtWidgets.QPushButton, "SweptVolumeCheckSpaces"))
            yield 0.3
            yield lambda: find(QtWidgets.QPushButton, "SweptVolumeCheckSpaces").isEnabled()
            read_verdicts(find(QtWidgets.QTableWidget, "SweptVolumeSpacesTable"))
            shot("42_dark_Overlap_checked")
            yield 0.8
        checks = ("Clearance", "Mechanism", "Overlap", "Study")
        click(panel_button(Close if name in checks else Cancel))
        yield no_panel
    path.Interpolation = "Screw"
    wall.Placement.Base.y = 14
    doc.recompute()
    shot("43_dark_tree")
    yield 0.8
    App.closeDocument(doc.Name)
    yield


run(scenario)
