# SPDX-License-Identifier: LGPL-2.1-or-later
"""Panels that are open while the document changes, a change is undone, or their object is deleted: at each
moment, they show the true state of a result.
"""
import os
import sys

HERE = os.path.dirname(os.path.realpath(__file__))
sys.path[:0] = [HERE, os.path.dirname(HERE)]
from driver import (  # noqa: E402
    App,
    Cancel,
    Close,
    Gui,
    QtWidgets,
    click,
    find,
    new_document,
    no_panel,
    open_workbench,
    panel_button,
    run,
    select,
)
from spaces import add_box, at  # noqa: E402

#: Name of the label that shows the result of a check.
SUMMARY = "SweptVolumeClearanceSummary"


def text_of(name):
    return find(QtWidgets.QLabel, name).text()


def is_stale(name):
    return "stale" in text_of(name)


def follows(doc, says_stale):
    """A step: the wall moves, and Undo moves it back. The panel shows the true state each time."""
    assert not says_stale()
    doc.openTransaction("Move")
    doc.Wall.Placement = at(45, 2, 0)
    doc.commitTransaction()
    doc.recompute()
    yield says_stale
    doc.undo()
    doc.recompute()
    yield lambda: not says_stale()


def close():
    click(panel_button(Close))
    return no_panel


def checks(doc):
    """Checks of clearance and mechanism: the state, the name, and a check that Undo removes."""
    from sweptvolume.features import clearance, mechanism

    part, wall = [(doc.Slide, "")], [(doc.Wall, "")]
    one = clearance.make_clearance(
        doc, MovingParts=part, Motion=doc.Motion, Neighbours=wall, AllVisible=False
    )
    two = mechanism.make_mechanism(
        doc, MovingParts=part, Motions=[doc.Motion], Neighbours=wall, Range=100
    )
    doc.recompute()
    for obj, module in ((one, clearance), (two, mechanism)):
        module.compute(obj)
        obj.ViewObject.Proxy.doubleClicked(obj.ViewObject)
        yield 0.3
        table = find(QtWidgets.QTableWidget, "SweptVolumeClearanceTable")
        yield from follows(doc, lambda: is_stale(SUMMARY))
        doc.Wall.Label = "Gate"
        yield lambda: "Gate" in table.item(0, 0).text()
        assert "Gate" in text_of(SUMMARY), text_of(SUMMARY)
        doc.Wall.Label = "Wall"
        yield lambda: "Gate" not in table.item(0, 0).text()
        table.selectRow(0)
        yield 0.5
        doc.removeObject(obj.Name)
        yield lambda: not table.isVisible()
        yield close()


def lists(doc):
    """Checks of clearance and mechanism list the present neighbours. A rule that is being typed is not
    lost."""
    from sweptvolume.panels import clearance_panel, mechanism_panel

    part = [(doc.Slide, "")]
    for panel, rules in (
        (clearance_panel.show(doc, pairs=part, motion_obj=doc.Motion), "SweptVolumeRules"),
        (mechanism_panel, "SweptVolumePairRules"),
    ):
        if panel is mechanism_panel:
            panel = mechanism_panel.show(doc, pairs=part, motions=[doc.Motion])
            panel.all.setChecked(True)
        yield 0.3
        table = find(QtWidgets.QTableWidget, rules)

        def lists_only(*names):
            rows = [table.item(row, 0).text() for row in range(table.rowCount())]
            return len(rows) == len(names) and all(
                name in panel.chosen.text() and any(name in row for row in rows) for name in names
            )

        assert lists_only("Wall"), panel.chosen.text()
        doc.Wall.ViewObject.Visibility = False
        yield lambda: lists_only()
        doc.Wall.ViewObject.Visibility = True
        yield lambda: lists_only("Wall")
        table.item(0, 1).setText("3")
        add_box(doc, "Post", (5, 5, 5), (90, 0, 0))
        doc.recompute()
        yield lambda: lists_only("Wall", "Post")
        assert sorted(table.item(row, 1).text() for row in range(2))[1].startswith("3")
        cell = table.item(0, 1)
        doc.Slide.Placement = doc.Slide.Placement
        doc.recompute()
        yield 0.2
        assert table.item(0, 1) is cell  # nothing new to list
        select(doc.Post)
        click(panel.take)
        yield lambda: lists_only("Post")
        doc.removeObject("Post")
        yield lambda: lists_only()
        yield close()


def closed_while_reading(doc):
    """Parts are read in the background. A panel that is closed meanwhile gets no result."""
    import Mesh
    from sweptvolume import runner
    from sweptvolume.panels import clearance_panel

    ball = doc.addObject("Mesh::Feature", "Ball")
    ball.Mesh, ball.Placement = Mesh.createSphere(20.0, 300), at(90, 0, 0)
    doc.recompute()
    panel = clearance_panel.show(doc, pairs=[(doc.Slide, "")], motion_obj=doc.Motion)
    yield 0.3
    panel.start()
    assert panel.run is None and "Reading" in panel.message.text(), panel.message.text()
    click(panel_button(Close))
    yield no_panel
    yield lambda: not runner.running()
    yield 0.3
    doc.removeObject("Ball")


def spaces(doc):
    """Check reserved spaces: the result is stale also if the objects or the required distance in the
    panel differ from those that were checked."""
    select(doc.Slide, doc.Wall)
    Gui.runCommand("SweptVolume_Overlap")
    yield 0.3
    click(find(QtWidgets.QPushButton, "SweptVolumeCheckSpaces"))
    summary = "SweptVolumeSpacesSummary"
    yield lambda: any(
        label.isVisible() for label in Gui.getMainWindow().findChildren(QtWidgets.QLabel, summary)
    )
    yield from follows(doc, lambda: is_stale(summary))
    doc.Slide.Length = 9
    doc.recompute()
    yield lambda: is_stale(summary)
    doc.Slide.Length = 10  # another shape with the same content
    doc.recompute()
    yield lambda: not is_stale(summary)
    required = find(QtWidgets.QWidget, "SweptVolumeSpacesRequired")
    required.setProperty("rawValue", 60.0)
    yield lambda: is_stale(summary)
    required.setProperty("rawValue", 0.0)
    yield lambda: not is_stale(summary)
    select(doc.Slide)
    click(find(QtWidgets.QPushButton, "SweptVolumeTakeSpaces"))
    yield lambda: is_stale(summary)
    select(doc.Slide, doc.Wall)
    click(find(QtWidgets.QPushButton, "SweptVolumeTakeSpaces"))
    yield lambda: not is_stale(summary)
    doc.Wall.Label = "Gate"
    yield lambda: is_stale(summary)  # the row has the former name
    find(QtWidgets.QTableWidget, "SweptVolumeSpacesTable").selectRow(0)
    yield 0.3
    doc.Wall.Label = "Wall"
    yield close()


def record(doc):
    """What made this?: the record describes the parts at the time of the run. If a part has moved
    since, no part is drawn at a wrong place."""
    from sweptvolume.features import envelope, made_by
    from sweptvolume.panels import made_panel

    obj = envelope.make_envelope(doc, [doc.Slide], doc.Motion, Resolution=24, MadeBy="Session")
    doc.recompute()
    envelope.compute(obj)
    select(obj)
    Gui.runCommand("SweptVolume_MadeBy")
    yield 0.3
    panel = made_panel.opened[-1]
    known = made_by.find(obj)
    panel.found(obj, next(filter(None, map(known.answer, range(len(known.kind))))))
    yield 0.3
    face, last = panel.text.text(), panel.moving.poses.placements[-1]
    assert "earlier" not in face and panel.choose.isEnabled() and panel.moving is not None
    doc.openTransaction("Edit")
    doc.Motion.Placements = [at(0, 0, 0), at(20, 9, 0)]
    doc.commitTransaction()
    doc.recompute()
    yield lambda: "earlier" in panel.text.text()
    assert panel.text.text().startswith(face)
    assert not panel.choose.isEnabled() and panel.moving is None and not panel.player.isEnabled()
    doc.undo()
    doc.recompute()
    yield lambda: "earlier" not in panel.text.text()
    doc.Motion.Placements = [at(0, 0, 0), at(20, 9, 0)]
    doc.recompute()
    envelope.compute(obj)
    yield lambda: panel.answer is None
    known = made_by.find(obj)
    panel.found(obj, next(filter(None, map(known.answer, range(len(known.kind))))))
    yield 0.3
    assert (panel.moving.poses.placements[-1].Base - last.Base).Length > 5
    doc.removeObject(obj.Name)
    yield no_panel


def numbers(doc):
    """Tests the results that the panel of an envelope shows."""
    from sweptvolume.features import envelope

    obj = envelope.make_envelope(doc, [doc.Wall], doc.Motion, Resolution=24)
    doc.recompute()
    envelope.compute(obj)
    obj.ViewObject.Proxy.doubleClicked(obj.ViewObject)
    yield 0.5
    yield from follows(doc, lambda: is_stale("SweptVolumeReadOuts"))
    click(panel_button(Cancel))
    yield no_panel


def installation(doc):
    """A sequence cannot be played after one of its parts was moved. Values that are being typed are not
    lost."""
    from shaft import plan_of, shaft, stack
    from sweptvolume.features import sequence

    walls, parts = shaft(doc), stack(doc)
    doc.recompute()
    _, obj = sequence.find(plan_of(doc, parts, walls, Order="find"))
    obj.ViewObject.Proxy.doubleClicked(obj.ViewObject)
    yield 0.5
    table = find(QtWidgets.QTableWidget, "SweptVolumeSequenceParts")
    texts = [table.item(row, 2).text() for row in range(2)]
    assert all(texts), texts
    release = find(QtWidgets.QWidget, "SweptVolumeRelease")
    release.setProperty("rawValue", 7.0)
    doc.openTransaction("Move")
    doc.Upper.Placement.Base.x = -8.9
    doc.Upper.Placement = at(-8.9, -9, 11)
    doc.commitTransaction()
    doc.recompute()
    yield lambda: not any(table.item(row, 2).text() for row in range(2))
    doc.undo()
    doc.recompute()
    yield lambda: [table.item(row, 2).text() for row in range(2)] == texts
    assert release.property("rawValue") == 7.0
    doc.removeObject(obj.Name)
    yield lambda: not any(table.item(row, 2).text() for row in range(2))
    yield close()


def scenario():
    from sweptvolume.features import motion

    open_workbench()
    yield
    doc = new_document("Open")
    add_box(doc, "Slide", (10, 10, 10), (0, 0, 0))
    add_box(doc, "Wall", (10, 10, 10), (50, 0, 0))
    motion.motion_from_poses(doc, [0, 1], [at(0, 0, 0), at(20, 0, 0)])
    doc.recompute()
    yield
    for part in (checks, lists, closed_while_reading, spaces, record, numbers, installation):
        yield from part(doc)
    App.closeDocument(doc.Name)


run(scenario)
