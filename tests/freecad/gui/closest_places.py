# SPDX-License-Identifier: LGPL-2.1-or-later
"""The player of a clearance check: the moving part, the line of the shortest distance, the section through
it, and clashes as solids. When the panel is closed, nothing of this remains in the view.
"""
import os
import sys

HERE = os.path.dirname(os.path.realpath(__file__))
sys.path[:0] = [HERE, os.path.dirname(HERE)]
from driver import (  # noqa: E402
    Close,
    Gaps,
    Gui,
    QtWidgets,
    click,
    find,
    line_of,
    new_document,
    no_panel,
    open_workbench,
    panel_button,
    run,
    say,
    select,
    shot,
    view_from,
)
from spaces import add_box, at, hidden_motion, swept_space  # noqa: E402


def scene(doc):
    """Returns the envelope of a slide that moves 100 mm along x: 3 mm into a bolt (clash), and past a
    wall at a distance of 2 mm."""
    slide = add_box(doc, "Slide", (10, 10, 10), (0, 0, 0))
    path = hidden_motion(doc, at(0), at(100), 2)
    bolt = doc.addObject("Part::Cylinder", "Bolt")
    bolt.Radius, bolt.Height = 6, 30
    bolt.Placement = at(50, 13, -10)
    add_box(doc, "Wall", (20, 5, 20), (70, -7, -5))
    return swept_space(doc, slide, path, 64)


def planes_of(graph):
    from pivy import coin

    return [
        graph.getChild(k)
        for k in range(graph.getNumChildren())
        if graph.getChild(k).isOfType(coin.SoClipPlane.getClassTypeId())
    ]


def scenario():
    from sweptvolume.features import shared

    open_workbench()
    yield
    doc = new_document("Closest")
    swept = scene(doc)
    view = view_from("Top")
    yield 0.3
    graph = view.getSceneGraph()
    drawn = graph.getNumChildren()
    select(swept)
    Gui.runCommand("SweptVolume_Clearance")
    yield 0.5
    click(find(QtWidgets.QPushButton, "SweptVolumeCheck"))
    yield lambda: doc.getObject("Clearance") is not None
    yield 0.5
    swept.ViewObject.Visibility = False
    table = find(QtWidgets.QTableWidget, "SweptVolumeClearanceTable")
    rows = {table.item(r, 0).text(): r for r in range(table.rowCount())}
    keep = find(QtWidgets.QPushButton, "SweptVolumeKeepClash")
    cut = find(QtWidgets.QPushButton, "SweptVolumeKeepCut")
    assert not keep.isEnabled() and not cut.isEnabled()
    # The player with a selected row: at every time, the line ends at the part of this row.
    table.selectRow(rows["Wall"])
    yield 0.3
    assert not keep.isEnabled()
    slider = find(QtWidgets.QSlider, "SweptVolumeTime")
    gaps = Gaps()
    for value, x in ((100, 10.0), (500, 50.0)):
        slider.setValue(value)
        # The line runs from the corner of the slide at x + 10 to the corner of the wall at x = 70.
        yield lambda x=x: (
            line_of(graph) is not None and abs(line_of(graph)[0][0] - (x + 10)) < 0.2
        )
        ends = line_of(graph)
        assert abs(ends[1][0] - 70) < 1e-3 and abs(ends[1][1] + 2) < 1e-3, ends
    say("played: the window stood still for " + gaps.stop())
    yield 0.3
    shot("93_closest_line")
    yield 1.0
    section = find(QtWidgets.QCheckBox, "SweptVolumeSection")
    view_from("Isometric")
    click(section)
    yield 0.3
    assert len(planes_of(graph)) == 1
    before = planes_of(graph)[0].plane.getValue().getDistanceFromOrigin()
    slider.setValue(600)
    yield lambda: planes_of(graph)[0].plane.getValue().getDistanceFromOrigin() != before
    # The worst place is a clash: its solid, and the volume to be cut away over the whole motion.
    table.selectRow(rows["Bolt"])
    yield 0.5
    Gui.SendMsgToActiveView("ViewFit")
    shot("94_section")
    yield 1.0
    click(section)
    yield 0.2
    assert not planes_of(graph)
    undo = doc.UndoCount
    for button, name, least in ((keep, "SharedVolume", 50), (cut, "SharedVolume001", 60)):
        assert button.isEnabled()
        click(button)
        yield lambda name=name: doc.getObject(name) is not None
        yield 0.3
        body = doc.getObject(name)
        assert body.Status == shared.UP_TO_DATE, (body.Status, body.Message)
        assert body.Volume.Value > least, body.Volume
    assert doc.UndoCount == undo + 2, doc.UndoNames
    # The volume is a segment of a circle of radius 6 mm, 3 mm deep, times its height of 10 mm.
    import math

    angle = 2 * math.acos(3 / 6)
    segment = 0.5 * 36 * (angle - math.sin(angle)) * 10
    whole = doc.getObject("SharedVolume001").Volume.Value
    assert abs(whole / segment - 1) < 0.03, (whole, segment)
    at_once = doc.getObject("SharedVolume").Volume.Value
    assert at_once <= whole * 1.001, (at_once, whole)
    click(panel_button(Close))
    yield no_panel
    yield 0.2
    shot("95_clash_bodies")
    yield 1.0
    doc.undo()
    doc.undo()
    assert doc.getObject("SharedVolume") is None
    assert graph.getNumChildren() <= drawn + 1, (graph.getNumChildren(), drawn)
    yield from two_that_move()


def two_that_move():
    """Tests two cubes that pass through each other, 3 mm deep: the player shows the line between
    them and the solid of the clash at each time."""
    from sweptvolume.features import mechanism, shared

    doc = new_document("Passing")
    cubes, paths = [], []
    for name, y, ends in (("One", 0, (0, 30)), ("Other", 7, (30, 0))):
        cubes.append(add_box(doc, name, (10, 10, 10), (ends[0], y, 0)))
        paths.append(hidden_motion(doc, *[at(x, y) for x in ends]))
    doc.recompute()
    obj = mechanism.make_mechanism(doc, MovingParts=[(c, "") for c in cubes], Motions=paths)
    doc.recompute()
    mechanism.compute(obj)
    graph = view_from("Top").getSceneGraph()
    select(obj)
    Gui.runCommand("SweptVolume_Mechanism")
    yield 0.5
    table = find(QtWidgets.QTableWidget, "SweptVolumeClearanceTable")
    assert table.item(0, 1).text() == "Clash", table.item(0, 1).text()
    click(find(QtWidgets.QPushButton, "SweptVolumeNextWorst"))
    yield 0.5
    # At 0.1 s the one ends at x = 13, and the other begins at x = 27.
    find(QtWidgets.QSlider, "SweptVolumeTime").setValue(100)
    yield lambda: line_of(graph) is not None and abs(line_of(graph)[0][0] - 13) < 0.1
    assert abs(line_of(graph)[1][0] - 27) < 0.1, line_of(graph)
    click(find(QtWidgets.QPushButton, "SweptVolumeKeepClash"))
    yield lambda: doc.getObject("SharedVolume") is not None
    yield 0.3
    body = doc.getObject("SharedVolume")
    assert body.Status == shared.UP_TO_DATE, body.Message
    assert (body.Motion, body.NeighbourMotion) == tuple(paths)
    along = 10 - abs(30 * body.Time - (30 - 30 * body.Time))
    assert along > 3 and abs(body.Volume.Value - along * 3 * 10) < 0.01, (body.Time, body.Volume)
    click(panel_button(Close))
    yield no_panel


run(scenario)
