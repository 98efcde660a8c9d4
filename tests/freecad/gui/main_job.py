# SPDX-License-Identifier: LGPL-2.1-or-later
"""The main workflow: motion, envelope, cancel, stale result, display with fewer triangles, solid, export,
another tolerance, save and open.
"""
import os
import sys
import tempfile

sys.path.insert(0, os.path.dirname(os.path.realpath(__file__)))
from driver import (  # noqa: E402
    App,
    Cancel,
    Gaps,
    Gui,
    Ok,
    QtWidgets,
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


def drawn_faces(obj):
    """Returns the number of triangles with which a mesh object is drawn."""
    from pivy import coin

    search = coin.SoSearchAction()
    search.setType(coin.SoIndexedFaceSet.getClassTypeId())
    search.setInterest(coin.SoSearchAction.FIRST)
    search.setSearchingAll(True)
    search.apply(obj.ViewObject.RootNode)
    return search.getPath().getTail().coordIndex.getNum() // 4


CSV = "# t in s\nt,tx,ty,tz,qx,qy,qz,qw\n0,0,0,0,0,0,0,1\n1,4,0,0,0,0,0,1\n2,4,4,0,0,0,0.7071068,0.7071068\n"


def scenario():
    from sweptvolume import runner
    from sweptvolume.features import envelope
    from sweptvolume.panels import envelope_panel, file_dialogs, file_panel

    folder = tempfile.mkdtemp()
    open_workbench()
    yield
    doc = new_document("Job")
    part, box = doc.addObject("App::Part", "Assembly"), doc.addObject("Part::Box", "Box")
    part.addObject(box)
    box.Length, box.Width, box.Height = 20, 12, 8
    part.Placement.Base.z = 5
    doc.recompute()
    Gui.activeDocument().activeView().viewIsometric()
    yield

    # Motion from a file, with its unit, through the panel.
    csv = os.path.join(folder, "path.csv")
    with open(csv, "w") as out:
        out.write(CSV)
    file_panel.ask_file = lambda: csv
    Gui.runCommand("SweptVolume_MotionFromFile")
    yield
    unit = find(QtWidgets.QComboBox, "SweptVolumeUnit")
    unit.setCurrentIndex(unit.findData("cm"))
    yield
    shot("01_motion_from_file")
    yield 0.5
    click(panel_button(Ok))
    yield no_panel
    motion = doc.getObject("Motion")
    assert motion.Count == 3 and abs(motion.Placements[2].Base.y - 40) < 1e-9, motion.Placements
    motion.PoseType = "Relative"
    doc.recompute()
    Gui.SendMsgToActiveView("ViewFit")
    yield

    # The envelope of a face picked inside the assembly: one panel, one undo step.
    undo = doc.UndoCount
    select((part, "Box.Face6"), motion)
    Gui.runCommand("SweptVolume_Envelope")
    yield 0.6
    assert find(QtWidgets.QTableWidget, "SweptVolumeParts").rowCount() == 1
    expected = envelope_panel.opened[-1].estimate_label
    yield lambda: " MB of memory" in expected.text()  # from a few sampled steps
    shot("02_envelope_panel")
    yield 0.5
    gaps = Gaps()
    click(panel_button(Ok))
    yield no_panel
    say("longest gap while a small envelope is made: " + gaps.stop())
    made = doc.getObject("Envelope")
    assert made.Status == envelope.UP_TO_DATE and made.Mesh.isSolid(), made.Status
    assert abs(made.Mesh.BoundBox.ZMin - 5) < made.UsedCellSize.Value
    assert doc.UndoCount == undo + 1, (doc.UndoCount, undo)
    yield
    shot("03_envelope")
    yield 0.5
    doc.undo()
    assert doc.getObject("Envelope") is None
    doc.redo()
    made = doc.getObject("Envelope")
    assert made.Status == envelope.UP_TO_DATE
    yield

    # A changed input makes the envelope stale, and the command computes it again.
    box.Height = 14
    doc.recompute()
    assert made.Status == envelope.STALE
    yield
    shot("04_stale")
    yield 0.5
    undo = doc.UndoCount
    select(made)
    Gui.runCommand("SweptVolume_Recompute")
    yield no_panel
    assert made.Status == envelope.UP_TO_DATE and doc.UndoCount == undo + 1
    assert abs(made.Mesh.BoundBox.ZMax - 19) < made.UsedCellSize.Value

    # A long run: the window responds, Stop ends the run, nothing changes.
    facets, undo = made.Mesh.CountFacets, doc.UndoCount
    select(made)
    Gui.runCommand("SweptVolume_EditEnvelope")
    yield
    find(QtWidgets.QSpinBox, "SweptVolumeResolution").setValue(1200)
    yield 0.5
    gaps = Gaps()
    click(panel_button(Ok))
    yield lambda: runner.running() and runner.running()[0].control.progress() > 0.02
    assert runner.is_running(made)
    yield 0.4
    shot("05_running")
    yield 0.5
    click(find(QtWidgets.QPushButton, "SweptVolumeStop"))
    yield lambda: not runner.running()
    say("longest gap while a large envelope runs: " + gaps.stop())
    yield
    shot("06_stopped")
    yield 0.5
    assert (made.Mesh.CountFacets, doc.UndoCount, made.Resolution) == (facets, undo, 128)
    click(panel_button(Cancel))
    yield no_panel

    # A mesh with many triangles is drawn with fewer; the mesh itself stays complete.
    made.ViewObject.DrawnTriangles = 400
    yield lambda: drawn_faces(made) < 800 and not runner.running()
    made.ViewObject.DrawnTriangles = 0
    yield lambda: drawn_faces(made) == facets
    assert made.Mesh.CountFacets == facets

    # Solid and STEP.
    undo = doc.UndoCount
    select(made)
    Gui.runCommand("SweptVolume_Solid")
    yield
    expected = find(QtWidgets.QLabel, "SweptVolumeSolidEstimate")
    yield lambda: "MB" in expected.text()
    find(QtWidgets.QSpinBox, "SweptVolumeMaxFaces").setValue(9000)
    shot("06_solid_panel")
    yield 0.6
    click(panel_button(Ok))
    yield no_panel
    body = doc.getObject("EnvelopeSolid")
    assert body.Shape.isValid() and len(body.Shape.Solids) == made.Shells
    assert body.MaxFaces == 9000 and body.Status == envelope.UP_TO_DATE
    assert doc.UndoCount == undo + 1, (doc.UndoNames, undo)
    yield
    shot("07_solid")
    yield 0.5
    body.MaxFaces = 8000
    doc.recompute()
    assert body.Status == envelope.STALE
    body.MaxFaces = 9000
    doc.recompute()
    assert body.Status == envelope.UP_TO_DATE
    select(body)
    Gui.runCommand("SweptVolume_Solid")
    yield
    assert find(QtWidgets.QSpinBox, "SweptVolumeMaxFaces").value() == body.MaxFaces
    click(panel_button(Cancel))
    yield no_panel
    step = os.path.join(folder, "out.step")
    file_dialogs.ask_export = lambda name: step
    select(made)
    Gui.runCommand("SweptVolume_Export")
    yield 0.5
    shot("07_export_panel")
    yield 0.6
    tessellated = find(QtWidgets.QCheckBox, "SweptVolumeTessellated")
    click(tessellated)
    yield 0.6
    assert (
        tessellated.isChecked() and not find(QtWidgets.QSpinBox, "SweptVolumeMaxFaces").isEnabled()
    )
    shot("07_export_tessellated")
    click(tessellated)
    yield 0.6
    click(panel_button(Ok))
    yield no_panel
    import Part

    assert abs(Part.read(step).Volume - made.Mesh.Volume) < 1e-3 * made.Mesh.Volume

    # The first simplification needs the command Recompute. From then on, the envelope is simplified
    # again as soon as its tolerance changes, without a command.
    made.Tolerance = 0.5
    doc.recompute()
    assert made.Status == envelope.STALE and not runner.running(), "nothing to be cut is kept yet"
    select(made)
    Gui.runCommand("SweptVolume_Recompute")
    yield no_panel
    coarse, seconds = made.Mesh.CountFacets, made.Seconds
    doc.openTransaction("Tolerance")  # as the property editor does
    made.Tolerance = 0.05
    doc.commitTransaction()
    doc.recompute()
    yield lambda: made.Status == envelope.UP_TO_DATE and not runner.running()
    assert made.Mesh.CountFacets > coarse and made.Seconds == seconds, "sampled again"
    doc.undo()
    yield 0.3
    assert made.Mesh.CountFacets == coarse and not runner.running()
    doc.redo()
    made.Tolerance = 0
    yield lambda: made.Status == envelope.UP_TO_DATE and not runner.running()
    assert made.Mesh.CountFacets == facets, (made.Mesh.CountFacets, facets)

    # Save, close, open: the results are there, and no run starts.
    path = os.path.join(folder, "job.FCStd")
    made.ViewObject.DrawnTriangles = 400
    doc.saveAs(path)
    App.closeDocument(doc.Name)
    yield
    doc = App.openDocument(path)
    made = doc.getObject("Envelope")
    assert made.Status == envelope.UP_TO_DATE and made.Mesh.CountFacets == facets
    yield lambda: drawn_faces(made) < 800 and not runner.running()
    shot("08_reopened")
    yield 0.5

    # The document is closed, and an object is deleted, during a run.
    for end in ("delete", "close"):
        select(made)
        Gui.runCommand("SweptVolume_EditEnvelope")
        yield
        find(QtWidgets.QSpinBox, "SweptVolumeResolution").setValue(1000)
        click(panel_button(Ok))
        yield lambda: runner.running() and runner.running()[0].control.progress() > 0.01
        if end == "delete":
            doc.removeObject(made.Name)
            yield lambda: not runner.running()
            assert doc.getObject("Envelope") is None
            yield
            shot("09_deleted_meanwhile")
            yield 0.5
            click(panel_button(Cancel))
            yield no_panel
            doc.undo()
            made = doc.getObject("Envelope")
            if made is None:
                App.closeDocument(doc.Name)
                doc = App.openDocument(path)
                made = doc.getObject("Envelope")
        else:
            App.closeDocument(doc.Name)
            yield lambda: not runner.running()
    yield 0.5
    assert not App.listDocuments()
    assert no_panel()


run(scenario)
