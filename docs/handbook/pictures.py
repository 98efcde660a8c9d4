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
    Gui,
    QtWidgets,
    click,
    no_panel,
    panel_button,
    run,
    shot,
    widen,
)  # noqa: E402
from PySide import QtCore  # noqa: E402

Ok, Cancel = QtWidgets.QDialogButtonBox.Ok, QtWidgets.QDialogButtonBox.Cancel
CSV = "# a lift and a quarter turn\nt,tx,ty,tz,qx,qy,qz,qw\n0,0,0,0,0,0,0,1\n1,0,0,5,0,0,0,1\n"
CSV += "2,0,20,5,0,0,0.7071068,0.7071068\n"


def select(*items):
    Gui.Selection.clearSelection()
    for item in items:
        Gui.Selection.addSelection(item)


def picture(name):
    shot(name)
    return 0.8


def scenario():
    import tempfile

    from sweptvolume.panels import file_panel

    Gui.activateWorkbench("SweptVolumeWorkbench")
    widen()
    yield
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
    yield lambda: panel.preview.run is None
    Gui.Selection.clearSelection()
    panel.slider.setValue(430)
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

    def close_preferences():
        window = QtWidgets.QApplication.activeModalWidget()
        if window is not None:
            shot("preferences")
            QtCore.QTimer.singleShot(900, window.reject)

    QtCore.QTimer.singleShot(1500, close_preferences)
    Gui.showPreferences("Swept Volume", 0)
    yield 1.0
    App.closeDocument(doc.Name)
    yield


run(scenario)
