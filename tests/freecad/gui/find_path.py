# SPDX-License-Identifier: LGPL-2.1-or-later
"""Find path, as a user works: select the part, press the button, watch the search, check the motion.
Refused input and searches without success show a message and leave the document as it was.
"""
import os
import sys

sys.path.insert(0, os.path.dirname(os.path.realpath(__file__)))
from driver import (  # noqa: E402
    App,
    Close,
    Gaps,
    Gui,
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
    stopped,
    titles_of,
    type_over,
    visible_text,
)

V = App.Vector
#: Time limit (s) for searches that find a path, also on a busy machine.
BUDGET = 600


def motions(doc):
    return [o for o in doc.Objects if o.Name.startswith("Motion")]


def check(doc, part, path, required):
    """Returns the rows of a clearance check of the path, by the names of the neighbours."""
    from sweptvolume.features import clearance

    obj = clearance.make_clearance(
        doc, MovingParts=[part], Motion=path, AllVisible=True, RequiredDistance=required
    )
    doc.recompute()
    return {row["name"]: row for row in clearance.compute(obj)["neighbours"]}


def slot_scene(doc):
    """Returns a case with a slot, and a plate in it. The plate fits through the slot only if it is
    turned."""
    import Part

    case = doc.addObject("Part::Feature", "Case")
    inner = Part.makeBox(62, 52, 52, V(-36, -26, -26))
    slot = Part.makeBox(10, 16, 50, V(23, -8, -25))
    case.Shape = Part.makeBox(70, 60, 60, V(-40, -30, -30)).cut(inner).cut(slot)
    part = doc.addObject("Part::Box", "Plate")
    part.Length, part.Width, part.Height = 20, 44, 6
    part.Placement = App.Placement(V(-25, -22, -3), App.Rotation())
    doc.recompute()
    return case, part


def slot(doc):
    """Finds a path from a typed start. Also tests neighbours, a required distance for one of them,
    undo, and a second search."""
    _, part = slot_scene(doc)
    Gui.activeDocument().activeView().viewIsometric()
    Gui.SendMsgToActiveView("ViewFit")
    yield
    begin = undo = doc.UndoCount
    select(part)
    Gui.runCommand("SweptVolume_FindPath")
    yield 0.5
    table = find(QtWidgets.QTableWidget, "SweptVolumeNeighbours")
    assert [table.item(r, 0).text() for r in range(table.rowCount())] == ["Case"]
    choose("SweptVolumeStartKind", "Place")
    find(QtWidgets.QDoubleSpinBox, "SweptVolumeBudget").setValue(BUDGET)
    click(find(QtWidgets.QPushButton, "SweptVolumeFind"))  # the placement is missing
    yield 0.2
    assert "6 numbers" in visible_text(), visible_text()
    type_over(find(QtWidgets.QLineEdit, "SweptVolumeStartNumbers"), "80 -22 -3 0 0 0")
    find(QtWidgets.QWidget, "SweptVolumePathClearance").setProperty("rawValue", 0.5)
    click(find(QtWidgets.QPushButton, "SweptVolumeFind"))
    yield 0.1
    shot("70_find_path_running")
    yield lambda: motions(doc)
    yield 0.5
    shot("71_find_path_found")
    yield 1.0
    found = motions(doc)[0]
    assert doc.UndoCount == undo + 1, doc.UndoNames
    paths = find(QtWidgets.QTableWidget, "SweptVolumePaths")
    assert titles_of(paths)[2] == "Length\nmm", titles_of(paths)
    assert paths.rowCount() == 1 and found.Label == "Path of Plate", found.Label
    assert found.Parts[0][0] is part and "Found" in visible_text(), visible_text()
    rows = check(doc, part, found, 0.5)
    assert rows["Case"]["verdict"] == "clear" and rows["Case"]["guaranteed"] >= 0.489, rows
    assert (found.Placements[0].Base - V(80, -22, -3)).Length < 1e-9
    assert (found.Placements[-1].Base - part.Placement.Base).Length < 1e-9
    # A required distance only for the neighbour Case, and another seed: the new path is listed too.
    table.item(0, 1).setText("1 mm")
    find(QtWidgets.QSpinBox, "SweptVolumeSeed").setValue(2)
    click(find(QtWidgets.QPushButton, "SweptVolumeFind"))
    yield lambda: len(motions(doc)) == 2
    yield 0.3
    other = motions(doc)[1]
    assert check(doc, part, other, 1.0)["Case"]["verdict"] == "clear"
    assert paths.rowCount() == 2 and other.ViewObject.Visibility and not found.ViewObject.Visibility
    paths.selectRow(0)
    yield 0.2
    assert found.ViewObject.Visibility and not other.ViewObject.Visibility
    # Refused: the document does not change, and no typed value is lost.
    count, undo = len(doc.Objects), doc.UndoCount
    table.item(0, 1).setText("80 mm")
    find(QtWidgets.QWidget, "SweptVolumeRelease").setProperty("rawValue", 0.0)
    click(find(QtWidgets.QPushButton, "SweptVolumeFind"))
    yield lambda: "goal" in visible_text()
    assert "Case" in visible_text() and "80 mm" in visible_text(), visible_text()
    shot("72_find_path_refused")
    yield 0.5
    assert (len(doc.Objects), doc.UndoCount) == (count, undo)
    assert table.item(0, 1).text() == "80 mm"
    assert find(QtWidgets.QLineEdit, "SweptVolumeStartNumbers").text() == "80 -22 -3 0 0 0"
    table.item(0, 1).setText("")
    click(panel_button(Close))
    yield no_panel
    while doc.UndoCount > begin:  # the checks are separate undo steps
        doc.undo()
    assert not motions(doc), doc.Objects


def too_narrow(doc):
    """Tests a plate that does not fit through: one search is stopped, another reaches its time
    limit. The panel and the view show how far the plate came."""
    part = doc.getObject("Plate")
    part.Height = 18
    part.Placement.Base.z = -9
    doc.recompute()
    select(part)
    Gui.runCommand("SweptVolume_FindPath")
    yield 0.5
    choose("SweptVolumeStartKind", "Place")
    type_over(find(QtWidgets.QLineEdit, "SweptVolumeStartNumbers"), "80 -22 -9 0 0 0")
    find(QtWidgets.QDoubleSpinBox, "SweptVolumeBudget").setValue(60)
    count, gaps = len(doc.Objects), Gaps()
    click(find(QtWidgets.QPushButton, "SweptVolumeFind"))
    yield 3.0
    shot("73_find_path_escape")
    yield 0.5
    button = find(QtWidgets.QPushButton, "SweptVolumeFind")
    still = gaps.stop()
    took = yield from stopped(button.isEnabled)
    say("window stood still for {}, cancelled in {:.2f} s".format(still, took))
    assert "Cancelled" in visible_text(), visible_text()
    find(QtWidgets.QDoubleSpinBox, "SweptVolumeBudget").setValue(2)
    click(button)
    yield lambda: button.isEnabled() and "No path" in visible_text()
    shot("74_find_path_none")
    yield 0.5
    assert "Case" in visible_text() and len(doc.Objects) == count, visible_text()
    find(QtWidgets.QDoubleSpinBox, "SweptVolumeBudget").setValue(0)
    click(button)
    yield lambda: "budget" in visible_text()
    click(panel_button(Close))
    yield no_panel


def just_out(doc):
    """Tests a part in a moved group, without a given start: the motion still ends at the installed
    position."""
    from sweptvolume.features import motion

    group = doc.addObject("App::Part", "Bay")
    group.Placement = App.Placement(V(100, 20, 5), App.Rotation(V(0, 1, 2), 40))
    for name, size, at in (
        ("Left", (60, 4, 30), (-30, -9, -15)),
        ("Right", (60, 4, 30), (-30, 5, -15)),
        ("Floor", (60, 18, 4), (-30, -9, -19)),
    ):
        box = doc.addObject("Part::Box", name)
        box.Length, box.Width, box.Height = size
        box.Placement.Base = V(*at)
        group.addObject(box)
    part = doc.addObject("Part::Cylinder", "Pin")
    part.Radius, part.Height = 4, 20
    part.Placement.Base = V(0, 0, -15)
    group.addObject(part)
    doc.recompute()
    Gui.SendMsgToActiveView("ViewFit")
    select((group, "Pin."))
    Gui.runCommand("SweptVolume_FindPath")
    yield 0.5
    table = find(QtWidgets.QTableWidget, "SweptVolumeNeighbours")
    assert table.rowCount() == 3, table.rowCount()
    find(QtWidgets.QDoubleSpinBox, "SweptVolumeBudget").setValue(BUDGET)
    find(QtWidgets.QWidget, "SweptVolumePathClearance").setProperty("rawValue", 0.5)
    click(find(QtWidgets.QPushButton, "SweptVolumeFind"))
    yield lambda: motions(doc)
    yield 0.5
    shot("75_find_path_out")
    yield 0.5
    found = motions(doc)[0]
    here = part.getGlobalPlacement()
    poses = motion.world_poses_of(found).placements
    assert (poses[-1].Base - here.Base).Length < 1e-9, (poses[-1], here)
    assert (poses[0].Base - here.Base).Length > 20, poses
    rows = check(doc, part, found, 0.5)
    assert {rows[n]["verdict"] for n in ("Left", "Right")} == {"clear"}, rows
    assert rows["Floor"]["verdict"] == "contact", rows  # it stands on the floor
    click(panel_button(Close))
    yield no_panel


def scenario():
    open_workbench()
    yield
    doc = new_document("Ways")
    yield from slot(doc)
    yield from too_narrow(doc)
    yield from just_out(new_document("Out"))


run(scenario)
