# SPDX-License-Identifier: LGPL-2.1-or-later
"""Study, as a user works: checks and an envelope of the document as runs, rows that appear as runs end, the
worst run opened where the parts are closest, stop and continue, a study file, one of its runs as objects,
undo.
"""
import os
import sys
import tempfile

HERE = os.path.dirname(os.path.realpath(__file__))
sys.path[:0] = [HERE, os.path.dirname(HERE)]
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
    visible_text,
)

FOLDER = tempfile.mkdtemp()
FILE = """
[study]
name = "boxes"
[defaults]
part = "box.stl"
neighbours = ["wall.stl", "bolt.stl"]
rules = { "b*" = "contact" }
compute = ["clearance"]
clearance = { required = 4 }
[[run]]
name = "{motion}"
motion = ["near.csv", "into.csv"]
[[run]]
name = "space"
motion = "near.csv"
compute = ["envelope"]
envelope = { resolution = 40 }
"""
LONG = """[[run]]
name = "long"
motion = "near.csv"
compute = ["envelope"]
envelope = { resolution = 1500 }
"""


def box(doc, label, x=0.0, y=0.0, size=10.0):
    obj = doc.addObject("Part::Box", "Box")
    obj.Label = label
    obj.Length = obj.Width = obj.Height = size
    obj.Placement.Base = App.Vector(x, y, 0)
    return obj


def make(doc):
    """Makes a slide between walls, with three checks, one of them with a clash, and an envelope."""
    from sweptvolume.features import clearance, envelope, motion

    part = box(doc, "Slide")
    wall, post = box(doc, "Wall", x=43), box(doc, "Post", y=12)
    found = []
    for travel, label in ((30, "To the stop"), (36, "Too far"), (10, "Short")):
        poses = [App.Placement(), App.Placement(App.Vector(travel, 0, 0), App.Rotation())]
        path = motion.motion_from_poses(doc, [0, 1], poses)
        path.Label = "Way of " + label
        found.append(
            clearance.make_clearance(
                doc,
                label,
                MovingParts=[(part, "")],
                Motion=path,
                Neighbours=[(wall, ""), (post, "")],
                AllVisible=False,
                RequiredDistance=2.5,
            )
        )
    found.append(envelope.make_envelope(doc, [part], path, "Space", Resolution=40))
    doc.recompute()
    return found


def rows(table):
    model = table.model()
    shown = [[model.data(model.index(r, c)) for c in (0, 1)] for r in range(model.rowCount())]
    return dict(shown)


def write_files():
    import Mesh

    shapes = (("box", 0, 0), ("wall", 43, 0), ("bolt", -10, 0))
    for name, x, y in shapes:
        mesh = Mesh.createBox(10, 10, 10)
        mesh.translate(x, y, 0)
        mesh.write(os.path.join(FOLDER, name + ".stl"))
    for name, travel in (("near", 30), ("into", 36)):
        with open(os.path.join(FOLDER, name + ".csv"), "w") as file:
            file.write("0,0,0,0,0,0,0,1\n1,{},0,0,0,0,0,1\n".format(travel))
    path = os.path.join(FOLDER, "study.toml")
    with open(path, "w") as file:
        file.write(FILE)
    return path


def run_button():
    return find(QtWidgets.QPushButton, "SweptVolumeRunStudy")


def of_the_document(doc):
    from sweptvolume.features import study

    checks = make(doc)
    Gui.SendMsgToActiveView("ViewFit")
    Gui.Selection.clearSelection()
    Gui.runCommand("SweptVolume_Study")
    yield 0.3
    listed = find(QtWidgets.QListWidget, "SweptVolumeStudySources")
    assert listed.count() == 4, listed.count()
    folder = find(QtWidgets.QLineEdit, "SweptVolumeStudyFolder")
    click(run_button())  # no folder is given yet
    yield 0.3
    assert "save the document first" in visible_text(), visible_text()
    folder.setText(os.path.join(FOLDER, "of the document"))
    undo, gaps = doc.UndoCount, Gaps()
    click(run_button())
    table = find(QtWidgets.QTableView, "SweptVolumeStudyTable")
    yield lambda: len(rows(table)) == 4
    assert list(rows(table)) == ["To the stop", "Too far", "Short", "Space"], rows(table)
    yield lambda: doc.getObject("Study") is not None
    yield 0.5
    say("the window stood still for " + gaps.stop())
    obj = doc.getObject("Study")
    assert (obj.Status, obj.Verdict) == (study.UP_TO_DATE, "clash"), (obj.Status, obj.Message)
    assert doc.UndoCount == undo + 1, doc.UndoNames
    states = rows(table)
    assert states["Too far"] == "Not clear" and states["Space"] == "Done", states
    shot("91_study")
    # The worst run: its check is computed, and shows the closest place.
    click(find(QtWidgets.QPushButton, "SweptVolumeOpenRun"))
    yield lambda: Gui.Control.activeDialog() and checks[1].Status == study.UP_TO_DATE
    yield 0.7
    shown = find(QtWidgets.QTableWidget, "SweptVolumeClearanceTable")
    chosen = shown.selectedItems()
    assert chosen and chosen[0].text() == "Wall", [c.text() for c in chosen]
    assert checks[1].ViewObject.Proxy.row.getNumChildren() > 0, "the part at its worst place"
    shot("92_study_worst")
    click(panel_button(Close))
    yield no_panel
    assert obj.Status == study.UP_TO_DATE, "the results of the checks are not what it depends on"


def of_a_file(doc):
    from sweptvolume.features import study

    path = write_files()
    with open(path, "a") as file:
        file.write(LONG)
    Gui.Selection.clearSelection()
    Gui.runCommand("SweptVolume_Study")
    yield 0.3
    choose("SweptVolumeStudyKind", "file")
    find(QtWidgets.QLineEdit, "SweptVolumeStudyFile").setText(path)
    find(QtWidgets.QSpinBox, "SweptVolumeStudyJobs").setValue(1)
    click(run_button())
    table = find(QtWidgets.QTableView, "SweptVolumeStudyTable")
    yield lambda: list(rows(table).values()).count("Not run") == 1
    shot("93_study_runs")
    took = yield from stopped(run_button().isEnabled)
    say("stopped after {:.2f} s".format(took))
    obj = doc.getObject("Study001")
    assert obj.Status == study.CANCELLED and run_button().text() == "Continue", obj.Status
    assert rows(table) == dict(zip(rows(table), ("Not clear", "Not clear", "Done", "Not run")))
    with open(path, "w") as file:
        file.write(FILE)
    marks = [os.stat(os.path.join(FOLDER, "results", n)).st_mtime_ns for n in ("near", "into")]
    yield 1.0
    click(run_button())
    yield lambda: run_button().isEnabled() and obj.Status == study.UP_TO_DATE
    again = [os.stat(os.path.join(FOLDER, "results", n)).st_mtime_ns for n in ("near", "into")]
    assert again == marks, "what was there is kept"
    shot("94_study_done")
    # A run becomes objects of the document; their check has the result of the run.
    undo = doc.UndoCount
    click(find(QtWidgets.QPushButton, "SweptVolumeOpenRun"))
    yield lambda: any(o.Label == "into" and hasattr(o, "RequiredDistance") for o in doc.Objects)
    check = next(o for o in doc.Objects if o.Label == "into" and hasattr(o, "RequiredDistance"))
    yield lambda: check.Status == study.UP_TO_DATE
    yield 0.5
    own = next(row for row in study.report_of(obj)["runs"] if row["run"] == "into")
    found = {row["name"]: row for row in study.json.loads(check.Report)["neighbours"]}
    assert found["wall"]["verdict"] == own["verdict"] == "clash"
    depth = found["wall"]["penetration"]["depth"]
    assert abs(depth - own["depth"]) < 1e-6, (depth, own["depth"])
    assert found["bolt"]["meets_rule"] and found["bolt"]["verdict"] == "contact", found["bolt"]
    shot("95_study_run_opened")
    click(panel_button(Close))
    yield no_panel
    while doc.UndoCount > undo:
        doc.undo()
    yield 0.2
    assert not [o for o in doc.Objects if o.Label == "into"], [o.Label for o in doc.Objects]


def scenario():
    from sweptvolume.features import study

    open_workbench()
    yield
    doc = new_document("Studies")
    yield from of_the_document(doc)
    yield from of_a_file(doc)
    # A study that is opened again from the tree shows its rows.
    select(doc.getObject("Study"))
    Gui.runCommand("SweptVolume_Study")
    yield 0.3
    assert len(rows(find(QtWidgets.QTableView, "SweptVolumeStudyTable"))) == 4
    click(panel_button(Close))
    yield no_panel
    # A changed file makes the result stale; FreeCAD itself does not notice this.
    obj = doc.getObject("Study001")
    assert obj.Status == study.UP_TO_DATE
    with open(obj.File, "a") as file:
        file.write("# another version\n")
    select(obj)
    Gui.runCommand("SweptVolume_Study")
    yield 0.3
    summary = find(QtWidgets.QLabel, "SweptVolumeStudySummary").text()
    assert obj.Status == study.STALE and "stale" in summary, (obj.Status, summary)
    click(panel_button(Close))
    yield no_panel


run(scenario)
