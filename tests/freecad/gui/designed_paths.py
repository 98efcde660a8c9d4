# SPDX-License-Identifier: LGPL-2.1-or-later
"""Paths designed in the motion editor, on real data. First, recorded placements of a robot's gripper (6, or
all 34 with SWEPT_LONG_TESTS): for two thirds of them, the part is moved there and a key is made of its
placement; the others are typed into the table. Then a joint of beams with a known start and goal: keys are
added between them until the path is clear. Without the shared data, a test is skipped, with a message.
"""
import csv
import os
import sys
import tempfile

HERE = os.path.dirname(os.path.realpath(__file__))
sys.path[:0] = [HERE, os.path.dirname(HERE)]
from driver import (  # noqa: E402
    App,
    Close,
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
from x_keyboard import focused, keyboard_or_leave  # noqa: E402

DATA = os.path.join(HERE, "..", "..", "..", "..", "shared", "data")
ARM = os.path.join(DATA, "motions", "installation_34_from_baxter_left.csv")
GRIPPER = os.path.join(DATA, "meshes", "gripper_robotiq_2f140_30k.ply")
POSES = os.path.join(DATA, "motions", "beam_joint_start_goal_poses.csv")
CM, METRE = 10.0, 1000.0
STRIDE = 1 if os.environ.get("SWEPT_LONG_TESTS") else 6
V = App.Vector


def mesh_object(doc, name, path, scale=1.0):
    import Mesh

    mesh, matrix = Mesh.Mesh(path), App.Matrix()
    matrix.scale(scale, scale, scale)
    mesh.transform(matrix)
    obj = doc.addObject("Mesh::Feature", name)
    obj.Mesh = mesh
    return obj


def rows_of(path, unit):
    """A generator of the rows of a table of poses, each with its Placement."""
    with open(path, encoding="utf-8") as file:
        for row in csv.DictReader(line for line in file if not line.startswith("#")):
            base = V(*(unit * float(row[k]) for k in ("tx", "ty", "tz")))
            turn = App.Rotation(*(float(row[k]) for k in ("qx", "qy", "qz", "qw")))
            yield row, App.Placement(base, turn)


def see_all():
    Gui.activeDocument().activeView().viewIsometric()
    Gui.SendMsgToActiveView("ViewFit")


def type_row(keyboard, table, numbers):
    """A generator that types numbers into the current row. None skips a cell."""
    row = table.currentRow()
    yield from keyboard.type("", *["Left"] * table.currentColumn())
    for column, number in enumerate(numbers):
        yield lambda: (table.currentRow(), table.currentColumn()) == (row, column)
        if number is not None:
            yield from keyboard.type("{:.9f}".format(number), "Return")
            yield lambda: table.state() != QtWidgets.QTableWidget.EditingState
        if column + 1 < len(numbers):
            yield from keyboard.type("", "Right")


def envelope_of(doc, part, motion):
    """A generator that makes an envelope with its panel, and returns it."""
    from sweptvolume.features import envelope

    select(part, motion)
    Gui.runCommand("SweptVolume_Envelope")
    yield 0.5
    click(panel_button(Ok))
    yield no_panel
    made = doc.Objects[-1]
    assert made.Status == envelope.UP_TO_DATE and made.Mesh.isSolid(), made.Status
    Gui.Selection.clearSelection()
    return made


def robot_arm(keyboard):
    """Designs a motion from nothing: keys at the placements where a robot arm was recorded."""
    from sweptvolume.features import envelope, motion
    from sweptvolume.trajectory.edit import as_numbers

    doc = new_document("RobotArm")
    gripper = mesh_object(doc, "Gripper", GRIPPER)
    initial = App.Placement(gripper.Placement)
    rows = list(rows_of(ARM, METRE))[::STRIDE]
    recorded = [(float(row["t_s"]), place) for row, place in rows]
    captured = len(recorded) * 2 // 3
    assert len(recorded) == (34 if STRIDE == 1 else 6)
    doc.recompute()
    select(gripper)
    Gui.runCommand("SweptVolume_NewMotion")
    yield 0.5
    Gui.Selection.clearSelection()
    table = find(QtWidgets.QTableWidget, "SweptVolumeKeys")
    yield lambda: focused() == "SweptVolumeKeys"
    assert table.rowCount() == 0
    choose("SweptVolumePivot", "Origin")  # the file contains placements, whose pivot is the origin
    for count, (time, place) in enumerate(recorded[:captured], 1):
        gripper.Placement = place
        yield from keyboard.press("Control_L+Return")
        yield lambda: table.rowCount() == count
        yield from type_row(keyboard, table, [time])
    see_all()
    for count, (time, place) in enumerate(recorded[captured:], captured + 1):
        yield from keyboard.press("Control_L+d")
        yield lambda: table.rowCount() == count
        yield from type_row(keyboard, table, [time, *as_numbers(place)])
    see_all()
    yield 2.0
    shot("50_robot_arm")
    yield 0.8
    click(panel_button(Ok))
    yield no_panel
    path = doc.Objects[-1]
    assert path.Count == len(recorded) and path.SourceType == "Stored"
    assert max(abs(a - b) for a, (b, _) in zip(path.Times, recorded)) < 1e-9
    off = max((p.Base - q.Base).Length for p, (_, q) in zip(path.Placements, recorded))
    turned = max(
        p.Rotation.multiply(q.Rotation.inverted()).Angle
        for p, (_, q) in zip(path.Placements, recorded)
    )
    say("{} keys: at most {:.1e} mm and {:.1e} rad off".format(len(recorded), off, turned))
    assert off < 1e-6 and turned < 1e-6
    gripper.Placement = initial
    made = yield from envelope_of(doc, gripper, path)
    shot("51_robot_arm_envelope")
    yield 0.8
    with tempfile.TemporaryDirectory() as folder:
        name = os.path.join(folder, "keys.csv")
        with open(name, "w", newline="", encoding="utf-8") as file:
            writer = csv.DictWriter(file, rows[0][0])
            writer.writeheader()
            writer.writerows(row for row, _ in rows)
        read = motion.motion_from_file(doc, name, "m")
        doc.recompute()
    twin = envelope.make_envelope(doc, [gripper], read)
    envelope.compute(twin)
    assert abs(twin.Volume.Value / made.Volume.Value - 1) < 1e-4, (twin.Volume, made.Volume)
    App.closeDocument(doc.Name)


def verdicts(doc, beam, path):
    """A generator that checks the clearance along the path, and returns the verdict for each neighbour."""
    select(beam, path)
    Gui.runCommand("SweptVolume_Clearance")
    yield 0.4
    click(find(QtWidgets.QPushButton, "SweptVolumeCheck"))
    yield lambda: doc.getObject("Clearance") is not None
    yield 0.3
    table = find(QtWidgets.QTableWidget, "SweptVolumeClearanceTable")
    assert table.rowCount() == 4, table.rowCount()
    found = {table.item(r, 0).text(): table.item(r, 1).text() for r in range(4)}
    table.selectRow(0)
    yield 0.5
    shot("52_beams_" + found["Beam2"].lower())
    yield 0.7
    click(panel_button(Close))
    yield no_panel
    doc.removeObject("Clearance")
    return found


def beams(keyboard):
    """Designs a path from start and goal: adds keys between them and lifts these until nothing is in
    the way."""
    places = {(row["part"], row["state"]): place for row, place in rows_of(POSES, CM)}
    doc = new_document("Beams")
    parts = {}
    for number, size in (("0", "7k"), ("1", "7k"), ("2", "5k"), ("3", "5k"), ("6", "25k")):
        path = os.path.join(DATA, "meshes", "beam_joint_part{}_{}.ply".format(number, size))
        parts[number] = mesh_object(doc, "Beam" + number, path, CM)
        parts[number].Placement = places[number, "start" if number == "0" else "goal"]
    beam, start, goal = parts["0"], places["0", "start"], places["0", "goal"]
    doc.recompute()
    see_all()
    select(beam)
    Gui.runCommand("SweptVolume_NewMotion")
    yield 0.4
    table = find(QtWidgets.QTableWidget, "SweptVolumeKeys")
    for count, place in enumerate((start, goal), 1):
        beam.Placement = place
        yield from keyboard.press("Control_L+Return")
        yield lambda: table.rowCount() == count
    click(panel_button(Ok))
    yield no_panel
    motion = doc.Objects[-1]
    beam.Placement = start
    found = yield from verdicts(doc, beam, motion)
    assert found["Beam2"] == "Clash", found
    say("beams, straight: {}".format(found))

    # Two keys between start and goal: 15 mm above the start and the goal, then 30 mm, which makes the path
    # clear.
    for lift in (15, 30):
        select(beam, motion)
        Gui.runCommand("SweptVolume_EditMotion")
        yield 0.4
        table = find(QtWidgets.QTableWidget, "SweptVolumeKeys")
        if table.rowCount() == 2:
            table.setCurrentCell(0, 1)
            yield from keyboard.press("Insert", "Insert")
            assert table.rowCount() == 4
        for row, place in ((1, start), (2, goal)):
            table.setCurrentCell(row, 1)
            x, y, z = place.Base
            yaw = place.Rotation.toEuler()[0]
            yield from type_row(keyboard, table, [None, x, y, z + lift, yaw, 0, 0])
        Gui.Selection.clearSelection()
        yield 1.0
        shot("53_beams_path_{}".format(lift))
        yield 0.7
        click(panel_button(Ok))
        yield no_panel
        found = yield from verdicts(doc, beam, motion)
        say("beams, lifted by {} mm: {}".format(lift, found))
        assert (found["Beam2"] == "Clash") == (lift == 15), found
    assert found == {"Beam1": "Clear", "Beam2": "Contact", "Beam3": "Clear", "Beam6": "Clear"}
    ends = motion.Placements[0], motion.Placements[-1]
    assert motion.Count == 4, motion.Count
    for place, wanted in zip(ends, (start, goal)):
        assert (place.Base - wanted.Base).Length < 1e-6, (place, wanted)
        assert place.Rotation.multiply(wanted.Rotation.inverted()).Angle < 1e-6, (place, wanted)
    made = yield from envelope_of(doc, beam, motion)
    box = made.Mesh.BoundBox
    assert box.ZMax > goal.Base.z + 30 and box.ZMin < 1, box
    yield
    shot("54_beams_envelope")
    yield 0.8
    App.closeDocument(doc.Name)


def scenario():
    open_workbench()
    yield
    keyboard = keyboard_or_leave()
    for name, needs, steps in (
        ("robot arm", (ARM, GRIPPER), robot_arm),
        ("beams", (POSES,), beams),
    ):
        if all(os.path.isfile(path) for path in needs):
            yield from steps(keyboard)
        else:
            say("{} skipped: the shared recordings are not here".format(name))


run(scenario)
