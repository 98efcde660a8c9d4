# SPDX-License-Identifier: LGPL-2.1-or-later
"""The tutorials of the handbook: an engine bay built from nothing, and on real data 34 keys of a
recorded robot arm and a joint of beams that is put together by a path designed from scratch. What needs
data that are absent is left out, with a line."""
import csv
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
POSES = os.path.join(DATA, "motions", "beam_joint_start_goal_poses.csv")
CM = 10.0
V = App.Vector


def mesh_object(doc, name, path, scale=1.0):
    import Mesh

    mesh, matrix = Mesh.Mesh(path), App.Matrix()
    matrix.scale(scale, scale, scale)
    mesh.transform(matrix)
    obj = doc.addObject("Mesh::Feature", name)
    obj.Mesh = mesh
    return obj


def look(name):
    yield 0.5
    shot("5_" + name)
    yield 0.7


def bay():
    """The first tutorial, with the numbers of its tables."""
    import Part

    folder = tempfile.mkdtemp()
    yield from engine_bay.work(look, folder)
    doc = App.ActiveDocument
    made, body = doc.getObject("Envelope"), doc.getObject("EnvelopeSolid")
    motion = made.Motion
    assert motion.Count == 12 and list(motion.Times) == list(range(12))
    assert made.Generators[0][0].Label == "Starter" and made.Mesh.isSolid()
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
    """A recorded path becomes a motion whose keys are edited: it stays what was recorded, but smooth."""
    from sweptvolume.features import envelope
    from sweptvolume.panels import file_panel, motion_panel

    doc = new_document("RobotArm")
    gripper = mesh_object(doc, "Gripper", GRIPPER)
    file_panel.ask_file = lambda: ARM
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


def beams():
    """Five beams laid out for pick-up; the last one is lifted, turned and put on the others."""
    from sweptvolume.features import envelope

    places = {}
    with open(POSES, encoding="utf-8") as file:
        for row in csv.DictReader(line for line in file if not line.startswith("#")):
            base = V(*(CM * float(row[k]) for k in ("tx", "ty", "tz")))
            turn = App.Rotation(*(float(row[k]) for k in ("qx", "qy", "qz", "qw")))
            places[row["part"], row["state"]] = App.Placement(base, turn)
    doc = new_document("Beams")
    parts = {}
    for number, size in (("0", "7k"), ("1", "7k"), ("2", "5k"), ("3", "5k"), ("6", "25k")):
        path = os.path.join(DATA, "meshes", "beam_joint_part{}_{}.ply".format(number, size))
        parts[number] = mesh_object(doc, "Beam" + number, path, CM)
        state = "start" if number == "0" else "goal"
        parts[number].Placement = places[number, state]
    beam = parts["0"]
    doc.recompute()
    Gui.activeDocument().activeView().viewIsometric()
    Gui.SendMsgToActiveView("ViewFit")
    start, goal = places["0", "start"], places["0", "goal"]
    high = App.Placement(V(0, 0, 70), App.Rotation())
    select(beam)
    Gui.runCommand("SweptVolume_NewMotion")
    yield 0.3
    for place in (start, high.multiply(start), high.multiply(goal), goal):
        beam.Placement = place
        click(find(QtWidgets.QPushButton, "SweptVolumeCapture"))
        yield 0.1
    Gui.SendMsgToActiveView("ViewFit")
    Gui.Selection.clearSelection()
    yield 1.5
    shot("52_beams_path")
    yield 0.8
    click(panel_button(Ok))
    yield no_panel
    motion = doc.Objects[-1]
    assert motion.Count == 4
    select(beam, motion)
    Gui.runCommand("SweptVolume_Envelope")
    yield 0.4
    find(QtWidgets.QSlider, "SweptVolumeQuality").setValue(4)
    click(panel_button(Ok))
    yield no_panel
    made = doc.getObject("Envelope")
    assert made.Status == envelope.UP_TO_DATE and made.Mesh.isSolid(), made.Status
    box = made.Mesh.BoundBox
    assert box.ZMax > 70 and box.ZMin < 1, box
    Gui.Selection.clearSelection()
    yield
    shot("53_beams_envelope")
    yield 0.8
    App.closeDocument(doc.Name)


def scenario():
    open_workbench()
    yield
    for name, needs, steps in (
        ("engine bay", (), bay),
        ("robot arm", (ARM, GRIPPER), robot_arm),
        ("beams", (POSES,), beams),
    ):
        if all(os.path.isfile(path) for path in needs):
            yield from steps()
        else:
            say("{} skipped: the shared recordings are not here".format(name))


run(scenario)
