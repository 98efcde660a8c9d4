# SPDX-License-Identifier: LGPL-2.1-or-later
"""The first tutorial of the handbook, an engine bay from its files, and a recorded path whose keys are
edited (skipped, with a message, if the recording is missing).
"""
import json
import os
import sys
import tempfile

sys.path.insert(0, os.path.dirname(os.path.realpath(__file__)))
from driver import (  # noqa: E402
    App,
    Gui,
    Ok,
    QtWidgets,
    answered,
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
)

HERE = os.path.dirname(os.path.realpath(__file__))
sys.path.insert(0, os.path.join(HERE, "..", "..", "..", "docs", "handbook"))
import engine_bay  # noqa: E402

DATA = os.path.join(HERE, "..", "..", "..", "..", "shared", "data")
ARM = os.path.join(DATA, "motions", "installation_34_from_baxter_left.csv")
GRIPPER = os.path.join(DATA, "meshes", "gripper_robotiq_2f140_30k.ply")


def look(name):
    yield 0.5
    shot("5_" + name)
    yield 0.7


def bay():
    """Follows the first tutorial, with the files that come with the workbench."""
    import Part

    folder = tempfile.mkdtemp()
    yield from engine_bay.work(look, folder)
    doc = App.ActiveDocument
    made, body = doc.getObject("Envelope"), doc.getObject("EnvelopeSolid")
    motion = made.Motion
    assert motion.Count == 12 and list(motion.Times) == list(range(12))
    assert made.MovingParts[0][0].Label == "Starter" and made.Mesh.isSolid()
    verdicts = {
        row["name"]: row["verdict"] for row in json.loads(doc.Clearance.Report)["neighbours"]
    }
    say("engine bay: {}, {} faces within {}".format(verdicts, body.Faces, body.Deviation))
    assert set(verdicts) == {"BellHousing", "Flywheel", "Engine", "Exhaust", "FrameRail"}
    assert verdicts.pop("BellHousing") == "contact" and "clash" not in verdicts.values()
    step = Part.read(os.path.join(folder, os.listdir(folder)[0]))
    assert abs(step.Volume - made.Volume.Value) < 0.01 * made.Volume.Value
    assert body.Shape.isValid() and body.Status == "Up to date" and body.Faces < 20000
    App.closeDocument(doc.Name)


def robot_arm():
    """Tests that a recorded motion becomes one with keys that can be edited, and that it follows
    the recording smoothly."""
    import Mesh

    from sweptvolume.features import envelope
    from sweptvolume.panels import file_panel, motion_panel

    doc = new_document("RobotArm")
    gripper = doc.addObject("Mesh::Feature", "Gripper")
    gripper.Mesh = Mesh.Mesh(GRIPPER)
    with answered(file_panel, "ask_file", lambda: ARM):
        Gui.runCommand("SweptVolume_MotionFromFile")
    yield 0.3
    choose("SweptVolumeUnit", "m")
    yield 0.2
    click(panel_button(Ok))
    yield no_panel
    motion = [o for o in doc.Objects if "SourceFile" in o.PropertiesList][0]
    assert motion.Count == 34 and motion.SourceType == "File"
    Gui.activeDocument().activeView().viewIsometric()
    Gui.SendMsgToActiveView("ViewFit")
    select(gripper, motion)
    Gui.runCommand("SweptVolume_EditMotion")
    yield 0.5
    panel = motion_panel.opened[-1]
    table = find(QtWidgets.QTableWidget, "SweptVolumeKeys")
    assert table.rowCount() == 34
    widest = max(len(table.item(r, c).text()) for r in range(34) for c in range(7))
    assert widest <= 6, widest
    Gui.SendMsgToActiveView("ViewFit")
    choose("SweptVolumeInterpolation", "Spline")
    table.setCurrentCell(17, 1)
    Gui.Selection.clearSelection()
    yield lambda: panel.preview.settled()
    assert not panel.preview_text.text(), panel.preview_text.text()
    yield 0.5
    shot("50_robot_arm")
    yield 0.8
    click(panel_button(Ok))
    yield no_panel
    assert motion.SourceType == "File" and motion.Interpolation == "Spline"
    select(gripper, motion)
    Gui.runCommand("SweptVolume_Envelope")
    yield 0.5
    click(panel_button(Ok))
    yield no_panel
    made = doc.getObject("Envelope")
    assert made.Status == envelope.UP_TO_DATE and made.Mesh.isSolid(), made.Status
    say("robot arm: {} triangles, {:.1f} s".format(made.Triangles, made.Seconds))
    gripper.ViewObject.Visibility = True
    Gui.Selection.clearSelection()
    yield
    shot("51_robot_arm_envelope")
    yield 0.8
    App.closeDocument(doc.Name)


def scenario():
    open_workbench()
    yield
    yield from bay()
    if all(os.path.isfile(path) for path in (ARM, GRIPPER)):
        yield from robot_arm()
    else:
        say("robot arm skipped: the shared recordings are not here")


run(scenario)
