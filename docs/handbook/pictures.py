# SPDX-License-Identifier: LGPL-2.1-or-later
"""Makes the pictures of this handbook from the real program:

    docs/handbook/make-pictures [FOLDER]
"""
import os
import sys

HERE = os.path.dirname(os.path.realpath(__file__))
sys.path.insert(0, os.path.join(HERE, "..", "..", "tests", "freecad", "gui"))
from driver import (  # noqa: E402
    App,
    Apply,
    Cancel,
    Close,
    Gui,
    Ok,
    QtCore,
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

CSV = "# a lift and a quarter turn\nt,tx,ty,tz,qx,qy,qz,qw\n0,0,0,0,0,0,0,1\n1,0,0,5,0,0,0,1\n"
CSV += "2,0,20,5,0,0,0.7071068,0.7071068\n"


def picture(name):
    shot(name)
    return 0.8


def demo():
    import tempfile

    from sweptvolume.panels import file_panel

    Gui.runCommand("SweptVolume_Demo")
    yield 1.0
    doc = App.ActiveDocument
    starter, motion = doc.getObject("Starter"), doc.getObject("Motion")
    Gui.SendMsgToActiveView("ViewFit")
    yield 0.6
    yield picture("demo_opened")

    path = os.path.join(tempfile.mkdtemp(), "lift.csv")
    with open(path, "w") as out:
        out.write(CSV)
    file_panel.ask_file = lambda: path
    Gui.runCommand("SweptVolume_MotionFromFile")
    yield 0.6
    yield picture("motion_from_file")
    click(panel_button(Cancel))
    yield no_panel

    select(starter, motion)
    Gui.runCommand("SweptVolume_EditMotion")
    yield 2.5
    from sweptvolume.panels import motion_panel

    panel = motion_panel.opened[-1]
    yield lambda: panel.preview.settled()
    Gui.Selection.clearSelection()
    panel.player.slider.setValue(430)
    yield 1.0
    yield picture("path_editor")
    click(panel_button(Cancel))
    yield no_panel

    wire = doc.addObject("Part::Feature", "Wire")
    import Part

    arc = Part.Arc(App.Vector(-300, 250, 0), App.Vector(-100, 300, 80), App.Vector(100, 250, 0))
    wire.Shape = arc.toShape()
    doc.recompute()
    select(wire)
    Gui.runCommand("SweptVolume_MotionFromSource")
    yield 0.6
    yield picture("motion_from_path_object")
    click(panel_button(Cancel))
    yield no_panel
    doc.removeObject(wire.Name)

    select(starter, motion)
    Gui.runCommand("SweptVolume_Envelope")
    yield 0.8
    Gui.Selection.clearSelection()
    yield picture("create_envelope")
    click(panel_button(Ok))
    yield no_panel
    yield 0.8
    made = doc.getObject("Envelope")
    Gui.Selection.clearSelection()
    yield picture("envelope")
    starter.Placement.Base.x -= 0.5
    motion.Placements = motion.Placements[1:]
    motion.Times = motion.Times[1:]
    doc.recompute()
    yield picture("stale")
    yield from clearance(made)
    made.Resolution = 32
    select(made)
    Gui.runCommand("SweptVolume_Recompute")
    yield no_panel
    select(made)
    Gui.runCommand("SweptVolume_Solid")
    yield no_panel
    yield 0.5
    Gui.Selection.clearSelection()
    yield picture("solid")

    App.closeDocument(doc.Name)


def clearance(made):
    """The check of an envelope that exists."""
    select(made)
    Gui.runCommand("SweptVolume_Clearance")
    yield 0.5
    click(find(QtWidgets.QPushButton, "SweptVolumeCheck"))
    yield lambda: made.Document.getObject("Clearance") is not None
    yield 0.5
    find(QtWidgets.QTableWidget, "SweptVolumeClearanceTable").selectRow(0)
    yield 0.5
    yield picture("clearance")
    click(panel_button(Close))
    yield no_panel
    made.Document.removeObject("Clearance")


def block(doc, name, size, place):
    """A box that stands with its middle at its origin, moved to `place`."""
    import Part

    box = doc.addObject("Part::Feature", name)
    box.Shape = Part.makeBox(*size, App.Vector(*(-x / 2 for x in size)))
    box.Placement = place
    return box


def joint():
    """The second tutorial: a beam is put on two posts."""
    turn = App.Rotation(App.Vector(0, 0, 1), 90)
    doc = new_document("Joint")
    block(doc, "Base", (160, 20, 15), App.Placement(App.Vector(0, 0, 7.5), App.Rotation()))
    for name, x in (("PostLeft", -50), ("PostRight", 50)):
        block(doc, name, (15, 15, 60), App.Placement(App.Vector(x, 0, 45), App.Rotation()))
    start = App.Placement(App.Vector(0, 70, 7.5), turn)
    beam = block(doc, "Beam", (130, 20, 15), start)
    doc.recompute()
    Gui.activeDocument().activeView().viewIsometric()
    Gui.SendMsgToActiveView("ViewFit")
    yield 0.5
    yield picture("joint_parts")
    select(beam)
    Gui.runCommand("SweptVolume_NewMotion")
    yield 0.3
    for x, y, z, rotation in (
        (0, 70, 7.5, turn),
        (0, 70, 120, turn),
        (0, 0, 120, App.Rotation()),
        (0, 0, 82.5, App.Rotation()),
    ):
        beam.Placement = App.Placement(App.Vector(x, y, z), rotation)
        click(find(QtWidgets.QPushButton, "SweptVolumeCapture"))
        yield 0.1
    find(QtWidgets.QTableWidget, "SweptVolumeKeys").setCurrentCell(2, 1)
    choose("SweptVolumeInterpolation", "Spline")
    Gui.Selection.clearSelection()
    Gui.SendMsgToActiveView("ViewFit")
    yield 2.0
    yield picture("joint_path")
    click(panel_button(Ok))
    yield no_panel
    path = doc.Objects[-1]
    select(beam, path)
    Gui.runCommand("SweptVolume_Envelope")
    yield 0.6
    Gui.Selection.clearSelection()
    click(panel_button(Apply))
    yield lambda: doc.getObject("Envelope") is not None
    yield 1.0
    yield picture("read_outs")
    click(panel_button(Cancel))
    yield no_panel
    App.closeDocument(doc.Name)


def slider():
    """Own motions, a moving reference, a driven value."""
    from sweptvolume.features import motion

    doc = new_document("Slider")
    arm, jaw = doc.addObject("Part::Box", "Arm"), doc.addObject("Part::Cylinder", "Jaw")
    arm.Length, arm.Width, arm.Height = 30, 8, 8
    jaw.Radius, jaw.Height = 6, 14
    jaw.Placement.Base = App.Vector(32, 4, -3)
    still, up = App.Placement(), App.Placement(App.Vector(0, 0, 25), App.Rotation())
    turned = App.Placement(App.Vector(), App.Rotation(App.Vector(0, 0, 1), 60))
    swing = motion.motion_from_poses(doc, [0, 1], [still, turned], "Linear", "Relative")
    lift = motion.motion_from_poses(doc, [0, 1], [still, up], "Linear", "Relative")
    swing.Label, lift.Label = "Swing", "Lift"
    doc.recompute()
    Gui.activeDocument().activeView().viewIsometric()
    Gui.SendMsgToActiveView("ViewFit")
    select(arm, jaw, swing)
    Gui.runCommand("SweptVolume_Envelope")
    yield 0.5
    own = find(QtWidgets.QTableWidget, "SweptVolumeParts").cellWidget(1, 1)
    own.setCurrentIndex(own.findData(lift.Name))
    find(QtWidgets.QGroupBox, "SweptVolumeReference").setChecked(True)
    find(QtWidgets.QCheckBox, "SweptVolumePreview").setChecked(True)
    Gui.Selection.clearSelection()
    yield 2.0
    yield picture("own_motions")
    click(panel_button(Cancel))
    yield no_panel
    sheet = doc.addObject("Spreadsheet::Sheet", "Values")
    sheet.set("A1", "5")
    sheet.setAlias("A1", "lift")
    doc.recompute()
    jaw.setExpression("Placement.Base.z", "Values.lift * 2")
    doc.recompute()
    select(sheet, jaw)
    Gui.runCommand("SweptVolume_MotionDriven")
    yield 0.5
    yield picture("motion_driven")
    click(panel_button(Cancel))
    yield no_panel
    App.closeDocument(doc.Name)


def preferences():
    def close_preferences():
        window = QtWidgets.QApplication.activeModalWidget()
        if window is not None:
            shot("preferences")
            QtCore.QTimer.singleShot(900, window.reject)

    QtCore.QTimer.singleShot(1500, close_preferences)
    Gui.showPreferences("Swept Volume", 0)
    yield 1.0


def scenario():
    open_workbench()
    yield
    for part in (demo, joint, slider, preferences):
        yield from part()
    yield


run(scenario)
