# SPDX-License-Identifier: LGPL-2.1-or-later
"""Makes the pictures of this handbook from the real program; make-pictures runs it."""
import os
import shutil
import sys
import tempfile

import pivy.coin  # noqa: F401  getCameraNode() needs it

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
    QtGui,
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
    select,
    shot,
)

import assembly_pictures  # noqa: E402
import core_pictures  # noqa: E402
import engine_bay  # noqa: E402
import mechanism_pictures  # noqa: E402
import path_pictures  # noqa: E402
import sequence_pictures  # noqa: E402
import spaces_pictures  # noqa: E402

#: Pictures that show one place, not all parts.
ZOOMED = {"assembly_mechanism", "assembly_worst", "clearance_row"}
CSV = "# a lift and a quarter turn\nt,tx,ty,tz,qx,qy,qz,qw\n0,0,0,0,0,0,0,1\n1,0,0,5,0,0,0,1\n"
CSV += "2,0,20,5,0,0,0.7071068,0.7071068\n"


def fill_view():
    """Zooms and moves the camera so that the visible objects fill most of the view. "ViewFit" leaves
    room for a ball around them, which is much in a narrow view."""
    view = Gui.activeDocument().activeView()
    if not hasattr(view, "saveImage") or view.getCameraType() != "Orthographic":
        return
    wide, high = (size // 2 for size in view.getSize())
    with tempfile.NamedTemporaryFile(suffix=".png") as file:
        view.saveImage(file.name, wide, high, "White")
        image = QtGui.QImage(file.name).convertToFormat(QtGui.QImage.Format_Grayscale8)
    lines = [bytes(image.constScanLine(y))[:wide] for y in range(high)]
    drawn = [(x, y) for y, line in enumerate(lines) for x, grey in enumerate(line) if grey < 250]
    if not drawn:
        return
    left, right = min(x for x, _ in drawn), max(x for x, _ in drawn)
    top, bottom = min(y for _, y in drawn), max(y for _, y in drawn)
    camera = view.getCameraNode()
    # The camera's height is the length (mm) that the shorter side of the view shows.
    pixel = camera.height.getValue() / min(wide, high)
    shift = App.Vector((left + right - wide) / 2, (high - top - bottom) / 2, 0) * pixel
    position = App.Vector(*camera.position.getValue())
    camera.position.setValue(*(position + view.getCameraOrientation().multVec(shift)))
    fill = max((right - left) / wide, (bottom - top) / high)
    camera.height.setValue(camera.height.getValue() * max(fill, 0.2) / 0.8)


def picture(name):
    """Takes a picture of the window, as large as the screen, after a pause; a generator. FreeCAD 1.1 has its
    task panel in a separate dock.
    """
    window = Gui.getMainWindow()
    window.setGeometry(0, 0, 1280, 1010)
    tasks = window.findChild(QtWidgets.QDockWidget, "Tasks")
    if tasks is not None:
        tasks.setVisible(bool(Gui.Control.activeDialog()))
        window.resizeDocks([tasks], [410], QtCore.Qt.Horizontal)
    yield 0.3
    if name not in ZOOMED and Gui.activeDocument():
        Gui.SendMsgToActiveView("ViewFit")
        yield 0.6
        fill_view()
    yield 0.6
    yield shot(name)


def place(name):
    """Returns the path of a folder of a user."""
    folder = os.path.join(os.environ["SWEPT_PLACE"], name)
    os.makedirs(folder, exist_ok=True)
    return folder


def show_parts():
    """Shows the 3D view of the only document, in front of its spreadsheet."""
    area = Gui.getMainWindow().findChild(QtWidgets.QMdiArea)
    for window in area.subWindowList():
        if "View3DInventor" in window.widget().metaObject().className():
            area.setActiveSubWindow(window)


def demo():
    from sweptvolume import runner
    from sweptvolume.panels import envelope_panel, file_dialogs, file_panel

    Gui.runCommand("SweptVolume_Demo")
    yield 1.0
    doc = App.ActiveDocument
    starter, motion = doc.getObject("Starter"), doc.getObject("Motion")
    Gui.SendMsgToActiveView("ViewFit")
    yield 0.6
    yield from picture("demo_opened")

    folder = place("engine bay")
    # The file dialog opens in this folder.
    App.ParamGet(file_dialogs.LAST).SetString("FileOpenSavePath", folder)
    path = os.path.join(folder, "lift.csv")
    with open(path, "w") as out:
        out.write(CSV)
    with answered(file_panel, "ask_file", lambda: path):
        Gui.runCommand("SweptVolume_MotionFromFile")
    yield 0.6
    yield from picture("motion_from_file")
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
    yield from picture("path_editor")
    Gui.runCommand("SweptVolume_ToTree")
    select(doc.getObject("Exhaust"))
    yield from picture("keyboard")
    Gui.runCommand("SweptVolume_ToTree")
    yield 0.3
    click(panel_button(Cancel))
    yield no_panel

    wire = doc.addObject("Part::Feature", "Wire")
    import Part

    ends = App.Vector(-300, 250, -250), App.Vector(100, 250, -250)
    wire.Shape = Part.Arc(ends[0], App.Vector(-100, 300, -170), ends[1]).toShape()
    wire.ViewObject.LineWidth = 4
    doc.recompute()
    select(wire)
    Gui.runCommand("SweptVolume_MotionFromSource")
    yield 0.6
    yield from picture("motion_from_path_object")
    click(panel_button(Cancel))
    yield no_panel
    doc.removeObject(wire.Name)

    select(starter, motion)
    Gui.runCommand("SweptVolume_Envelope")
    yield lambda: "memory" in envelope_panel.opened[-1].estimate_label.text()
    Gui.Selection.clearSelection()
    yield from picture("create_envelope")
    click(panel_button(Ok))
    yield no_panel
    yield 0.8
    made = doc.getObject("Envelope")
    Gui.Selection.clearSelection()
    keys = motion.Placements, motion.Times
    motion.Placements, motion.Times = (values[1:] for values in keys)
    doc.recompute()
    yield from picture("stale")
    motion.Placements, motion.Times = keys
    doc.recompute()
    yield from clearance(made)
    made.Resolution = 900
    doc.recompute()
    select(made)
    Gui.runCommand("SweptVolume_Recompute")
    yield lambda: runner.running() and runner.running()[0].control.progress() > 0.02
    Gui.Selection.clearSelection()
    yield 0.3
    yield from picture("running")
    click(find(QtWidgets.QPushButton, "SweptVolumeStop"))
    yield lambda: not runner.running()
    click(panel_button(Cancel))
    yield no_panel
    made.Resolution = 128
    doc.recompute()
    select(made)
    Gui.runCommand("SweptVolume_Recompute")
    yield no_panel
    select(made)
    Gui.runCommand("SweptVolume_Solid")
    yield engine_bay.estimated
    Gui.Selection.clearSelection()
    yield from picture("make_solid")
    click(panel_button(Ok))
    yield no_panel
    yield 0.5
    Gui.Selection.clearSelection()
    yield from picture("solid")
    select(made)
    yield from in_dialog("export", lambda: Gui.runCommand("SweptVolume_Export"))
    select(made)
    with answered(file_dialogs, "ask_export", lambda name: os.path.join(folder, name + ".step")):
        Gui.runCommand("SweptVolume_Export")
    yield 0.8
    yield engine_bay.estimated
    Gui.Selection.clearSelection()
    yield from picture("export_panel")
    click(panel_button(Cancel))
    yield no_panel
    App.closeDocument(doc.Name)


def in_dialog(name, action):
    """Starts an action that opens a modal dialog, takes the picture of the dialog and cancels it."""

    seen = []

    def wait_for_dialog():
        window = QtWidgets.QApplication.activeModalWidget()
        if window is None:
            QtCore.QTimer.singleShot(1500, wait_for_dialog)  # it opens slowly on a busy machine
            return
        seen.append(window)
        QtCore.QTimer.singleShot(1000, take)

    def take():
        close_after(shot(name))

    def close_after(taken):
        if taken():
            seen[0].reject()
        else:
            QtCore.QTimer.singleShot(100, lambda: close_after(taken))

    QtCore.QTimer.singleShot(1500, wait_for_dialog)
    action()
    yield 1.0
    assert seen, "no dialog for " + name


def clearance(made):
    """Checks the clearance of an envelope that exists."""
    select(made)
    Gui.runCommand("SweptVolume_Clearance")
    yield 0.5
    click(find(QtWidgets.QPushButton, "SweptVolumeCheck"))
    yield lambda: made.Document.getObject("Clearance") is not None
    yield 0.5
    Gui.Selection.clearSelection()
    yield from picture("clearance_table")
    table = find(QtWidgets.QTableWidget, "SweptVolumeClearanceTable")
    table.selectRow(2)
    yield 0.5
    yield from picture("clearance_row")
    table.clearSelection()
    find(QtWidgets.QCheckBox, "SweptVolumePaint").setChecked(False)
    find(QtWidgets.QCheckBox, "SweptVolumeColours").setChecked(True)
    for name, border in (("SweptVolumeContactBand", 5), ("SweptVolumeRequiredBand", 40)):
        find(QtWidgets.QWidget, name).setProperty("rawValue", float(border))
    yield 0.8
    yield from picture("clearance_colours")
    click(panel_button(Close))
    yield no_panel
    made.Document.removeObject("Clearance")


def bay():
    """Carries out the first tutorial."""
    yield from engine_bay.work(picture, os.environ["SWEPT_SHOTS"])
    App.closeDocument(App.ActiveDocument.Name)


def assembly():
    """Carries out the third tutorial."""
    folder = place("bay")
    yield from assembly_pictures.work(picture, folder)
    for name in ("assembly.html", "study.html"):
        shutil.copy(os.path.join(folder, name), os.environ["SWEPT_SHOTS"])
    App.closeDocument(App.ActiveDocument.Name)


def opened(name):
    """Opens a document of the tutorials from a copy."""
    path = os.path.join(place("tutorials"), name)
    shutil.copy(os.path.join(engine_bay.FILES, name), path)
    return App.openDocument(path)


def joint():
    """Carries out the second tutorial: a beam is put on two posts."""
    turn = App.Rotation(App.Vector(0, 0, 1), 90)
    doc = opened("beam_and_posts.FCStd")
    beam = doc.getObject("Beam")
    Gui.activeDocument().activeView().viewIsometric()
    Gui.SendMsgToActiveView("ViewFit")
    yield 0.5
    yield from picture("joint_parts")
    select(beam)
    Gui.runCommand("SweptVolume_NewMotion")
    yield 0.3
    for x, y, z, rotation in (
        (0, 90, 7.5, turn),
        (0, 90, 120, turn),
        (0, 0, 120, App.Rotation()),
        (0, 0, 82.5, App.Rotation()),
    ):
        beam.Placement = App.Placement(App.Vector(x, y, z), rotation)
        click(find(QtWidgets.QPushButton, "SweptVolumeCapture"))
        yield 0.1
        if rotation is turn and z > 100:
            Gui.Selection.clearSelection()
            yield 1.5
            yield from picture("new_motion")
    find(QtWidgets.QTableWidget, "SweptVolumeKeys").setCurrentCell(2, 1)
    choose("SweptVolumeInterpolation", "Spline")
    Gui.Selection.clearSelection()
    Gui.SendMsgToActiveView("ViewFit")
    yield 2.0
    yield from picture("joint_path")
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
    yield from picture("read_outs")
    click(panel_button(Cancel))
    yield no_panel
    App.closeDocument(doc.Name)


def slider():
    """Motions of single parts, a moving reference, and a driving value."""
    from sweptvolume.features import motion

    doc = new_document("Slider")
    arm, jaw = doc.addObject("Part::Box", "Arm"), doc.addObject("Part::Cylinder", "Jaw")
    arm.Length, arm.Width, arm.Height = 30, 8, 8
    jaw.Radius, jaw.Height = 6, 14
    jaw.Placement.Base = App.Vector(32, 4, -3)
    table = doc.addObject("Part::Box", "Table")
    table.Length, table.Width, table.Height = 60, 30, 4
    table.Placement.Base = App.Vector(0, 30, -10)
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
    find(QtWidgets.QCheckBox, "SweptVolumePreview").setChecked(True)
    Gui.Selection.clearSelection()
    yield 2.0
    yield from picture("own_motions")
    find(QtWidgets.QGroupBox, "SweptVolumeReference").setChecked(True)
    select(table)
    click(find(QtWidgets.QPushButton, "SweptVolumeTakeReference"))
    choose("SweptVolumeReferenceMotion", swing.Name)
    Gui.Selection.clearSelection()
    yield 2.0
    Gui.SendMsgToActiveView("ViewFit")
    yield from picture("reference")
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
    show_parts()
    find(QtWidgets.QDoubleSpinBox, "SweptVolumeEnd").setValue(30)
    yield 0.3
    yield from picture("motion_driven")
    click(panel_button(Ok))
    yield no_panel
    jaw.setExpression("Placement.Base.z", "Values.lift * 3")
    doc.recompute()
    show_parts()
    Gui.Selection.clearSelection()
    yield 0.5
    yield from picture("stale_motion")
    select(next(o for o in doc.Objects if motion.is_motion(o) and o.SourceType == "Driven"))
    Gui.runCommand("SweptVolume_EditSource")
    yield 0.5
    show_parts()
    yield from picture("edit_source")
    click(panel_button(Cancel))
    yield no_panel
    App.closeDocument(doc.Name)


def selected():
    """A motion that is made from placements of copies."""
    doc = new_document("Copies")
    key = doc.addObject("Part::Box", "Key")
    key.Length, key.Width, key.Height = 20, 8, 8
    copies = [key]
    for x, z, angle in ((30, 10, 20), (60, 30, 45), (80, 60, 80)):
        copy = doc.addObject("App::Link", "Copy")
        copy.LinkedObject = key
        turn = App.Rotation(App.Vector(0, -1, 0), angle)
        copy.Placement = App.Placement(App.Vector(x, 0, z), turn)
        copies.append(copy)
    doc.recompute()
    Gui.activeDocument().activeView().viewIsometric()
    Gui.SendMsgToActiveView("ViewFit")
    select(*copies)
    Gui.runCommand("SweptVolume_MotionFromSelection")
    yield 0.5
    Gui.Selection.clearSelection()
    yield 0.3
    yield from picture("motion_from_selection")
    App.closeDocument(doc.Name)


def made_by():
    """The colours of the faces that made an envelope, and a click on it."""
    import Part

    from sweptvolume.features import envelope, motion
    from sweptvolume.panels import made_panel

    doc = new_document("Crank")
    crank = doc.addObject("Part::Feature", "Crank")
    arm = Part.makeBox(60, 16, 8, App.Vector(0, -8, 0)).fuse(
        [Part.makeCylinder(14, 8), Part.makeCylinder(8, 24, App.Vector(60, 0, 0))]
    )
    crank.Shape = arm.cut(Part.makeCylinder(7, 8)).removeSplitter()
    turn = App.Rotation(App.Vector(0, 0, 1), 80)
    path = motion.motion_from_poses(
        doc,
        [0, 1, 2],
        [
            App.Placement(),
            App.Placement(App.Vector(), turn),
            App.Placement(App.Vector(0, 0, 45), turn),
        ],
    )
    hull = envelope.make_envelope(doc, [crank], path, Resolution=160, MadeBy="Session")
    doc.recompute()
    envelope.compute(hull)
    crank.ViewObject.Visibility = path.ViewObject.Visibility = False
    Gui.activeDocument().activeView().viewIsometric()
    Gui.SendMsgToActiveView("ViewFit")
    select(hull)
    Gui.runCommand("SweptVolume_MadeBy")
    yield 0.3
    choose("SweptVolumeColourBy", "Face")
    yield 1.0
    point = next(p.Vector for p in hull.Mesh.Points if p.Vector.y > 66 and 40 < p.Vector.z < 55)
    made_panel.opened[-1].picker.addSelection(doc.Name, hull.Name, "", tuple(point))
    yield 0.8
    yield from picture("made_by")
    click(panel_button(Close))
    yield no_panel
    App.closeDocument(doc.Name)


def preferences():
    yield from in_dialog("preferences", lambda: Gui.showPreferences("Swept Volume", 0))


def scenario():
    open_workbench()
    Gui.getMainWindow().showNormal()
    Gui.getMainWindow().setGeometry(0, 0, 1280, 1010)
    yield
    for part in (bay, assembly, demo, joint, slider, selected, made_by, preferences):
        yield from part()
    yield from path_pictures.paths(picture)
    yield from sequence_pictures.parts(picture)
    yield from mechanism_pictures.crank(picture)
    yield from spaces_pictures.envelopes(picture)
    yield from core_pictures.offer(picture)
    yield


run(scenario)
