# SPDX-License-Identifier: LGPL-2.1-or-later
"""The panel of an envelope: motions of single parts, a moving reference, quality, preview, computed values,
and the states in the tree.
"""
import os
import sys

sys.path.insert(0, os.path.dirname(os.path.realpath(__file__)))
from driver import (  # noqa: E402
    App,
    Apply,
    Cancel,
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
    select,
    shot,
)

V = App.Vector


def scenario():
    from sweptvolume import runner
    from sweptvolume.features import envelope, motion
    from sweptvolume.panels import envelope_panel
    from sweptvolume.views.base import state_icon

    open_workbench()
    yield
    doc = new_document("Moving")
    arm, jaw = doc.addObject("Part::Box", "Arm"), doc.addObject("Part::Cylinder", "Jaw")
    arm.Length, arm.Width, arm.Height = 30, 8, 8
    jaw.Radius, jaw.Height = 6, 14
    jaw.Placement.Base = V(32, 4, -3)
    table = doc.addObject("Part::Box", "Table")
    table.Length, table.Width, table.Height = 60, 30, 4
    table.Placement.Base = V(0, 30, -10)
    still = App.Placement()
    turn = App.Placement(V(), App.Rotation(V(0, 0, 1), 60))
    swing = motion.motion_from_poses(doc, [0, 1], [still, turn], "Linear", "Relative")
    lift = motion.motion_from_poses(
        doc, [0, 1], [still, App.Placement(V(0, 0, 25), App.Rotation())], "Linear", "Relative"
    )
    swing.Label, lift.Label = "Swing", "Lift"
    doc.recompute()
    Gui.activeDocument().activeView().viewIsometric()
    Gui.SendMsgToActiveView("ViewFit")
    yield

    # Two parts, each with its own motion; a coarse envelope before the first run.
    select(arm, jaw, swing)
    Gui.runCommand("SweptVolume_Envelope")
    yield 0.5
    panel = envelope_panel.opened[-1]
    parts = find(QtWidgets.QTableWidget, "SweptVolumeParts")
    assert parts.rowCount() == 2
    own = parts.cellWidget(1, 1)
    own.setCurrentIndex(own.findData(lift.Name))
    Gui.Selection.clearSelection()
    find(QtWidgets.QSlider, "SweptVolumeQuality").setValue(1)
    assert find(QtWidgets.QSpinBox, "SweptVolumeResolution").value() == 48
    find(QtWidgets.QCheckBox, "SweptVolumePreview").setChecked(True)
    yield lambda: panel.coarse is not None
    yield 0.5
    shot("30_own_motions")
    yield 0.6
    assert doc.getObject("Envelope") is None
    click(panel_button(Apply))
    yield lambda: doc.getObject("Envelope") is not None and not runner.running()
    made = doc.getObject("Envelope")
    assert made.Motions == [swing, lift] and made.Shells == 1 and made.Mesh.isSolid()
    text = find(QtWidgets.QLabel, "SweptVolumeReadOuts").text()
    assert "{:,}".format(made.Triangles) in text and "mm" in text, text
    assert panel.coarse is None
    yield
    shot("31_read_outs")
    yield 0.6
    click(panel_button(Cancel))
    yield no_panel

    # Relative to the table, which turns with the arm.
    select(made)
    Gui.runCommand("SweptVolume_EditEnvelope")
    yield 0.3
    find(QtWidgets.QGroupBox, "SweptVolumeReference").setChecked(True)
    select(table)
    click(find(QtWidgets.QPushButton, "SweptVolumeTakeReference"))
    choose("SweptVolumeReferenceMotion", swing.Name)
    Gui.Selection.clearSelection()
    yield 0.5
    shot("32_reference")
    yield 0.6
    click(panel_button(Ok))
    yield no_panel
    assert made.Reference[0] is table and made.ReferenceMotion is swing
    # Relative to the table, the arm stands still and the jaw swings the other way.
    box = made.Mesh.BoundBox
    assert box.YMin < -20 and made.Status == envelope.UP_TO_DATE, box
    yield

    # Every state has its own icon, and the tree shows it.
    icons = {state_icon("SweptVolume_Envelope", made)}
    for status in (envelope.STALE, envelope.CANCELLED, envelope.FAILED, envelope.NOT_COMPUTED):
        copy = doc.addObject("App::FeaturePython", "State")
        copy.addProperty("App::PropertyString", "Status")
        copy.Status = status
        icons.add(state_icon("SweptVolume_Envelope", copy))
        doc.removeObject(copy.Name)
    assert len(icons) == 5 and all(os.path.isfile(path) for path in icons), icons

    # A run that is stopped leaves the state Cancelled; one that fails leaves the state Failed. The mesh
    # stays.
    facets = made.Mesh.CountFacets
    swing.Placements = [still, App.Placement(V(), App.Rotation(V(0, 0, 1), 80))]
    made.Resolution = 1400
    doc.recompute()
    assert made.Status == envelope.STALE
    select(made)
    Gui.runCommand("SweptVolume_Recompute")
    yield lambda: runner.running() and runner.running()[0].control.progress() > 0.005
    click(find(QtWidgets.QPushButton, "SweptVolumeStop"))
    yield lambda: not runner.running()
    click(panel_button(Cancel))
    yield no_panel
    assert (made.Status, made.Mesh.CountFacets) == (envelope.CANCELLED, facets), made.Status
    Gui.Selection.clearSelection()
    yield
    shot("33_cancelled")
    yield 0.6
    made.CellSize = 5000
    doc.recompute()
    select(made)
    Gui.runCommand("SweptVolume_Recompute")
    yield lambda: not runner.running()
    assert (made.Status, made.Mesh.CountFacets) == (envelope.FAILED, facets), made.Status
    yield
    text = find(QtWidgets.QLabel, "SweptVolumeReadOuts").text()
    assert "cancelled" not in text and "{:,}".format(made.Triangles) in text, text
    shot("34_failed")
    yield 0.6
    click(panel_button(Cancel))
    yield no_panel
    assert made.Message
    App.closeDocument(doc.Name)
    yield


run(scenario)
