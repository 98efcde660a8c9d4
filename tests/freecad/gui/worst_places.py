# SPDX-License-Identifier: LGPL-2.1-or-later
"""Panels of checks, besides their tables: the graph shows the required distance also beside far neighbours,
and names the neighbour under the mouse; buttons go through the closest places, the worst first; parts have
the colours of their verdicts.
"""
import os
import sys

HERE = os.path.dirname(os.path.realpath(__file__))
sys.path[:0] = [HERE, os.path.dirname(HERE)]
from driver import (  # noqa: E402
    App,
    Close,
    Gaps,
    Gui,
    QtCore,
    QtGui,
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
    view_from,
)
from spaces import add_box, at, hidden_motion  # noqa: E402


def scene(doc):
    """Makes a slide that passes a post (clash), a wall (2 mm) and a stop (4 mm), and stays far from
    a frame. The stop is a link, and the wall has faces of several colours."""
    slide = add_box(doc, "Slide", (10, 10, 10), (0, 0, 0))
    path = hidden_motion(doc, at(0), at(100), 2)
    add_box(doc, "Post", (6, 20, 6), (50, 7, 2))
    wall = add_box(doc, "Wall", (20, 5, 20), (20, -7, 0))
    wall.ViewObject.DiffuseColor = [(0.1, 0.1 * k, 1.0) for k in range(6)]
    stop = add_box(doc, "Model", (5, 30, 30), (0, 0, 0))
    stop.ViewObject.Visibility = False
    link = doc.addObject("App::Link", "Stop")
    link.LinkedObject = stop
    link.Placement = at(114)
    add_box(doc, "Frame", (100, 5, 5), (0, 365, 0))
    doc.recompute()
    return slide, path, wall


def colour_at(view, point):
    """Returns (r, g, b) of the pixel of the 3D view that shows a point."""
    name = os.path.join(App.getUserCachePath(), "seen.png")
    width, height = view.getSize()
    view.saveImage(name, width, height, "White")
    x, y = view.getPointOnScreen(App.Vector(*point))
    colour = QtGui.QImage(name).pixelColor(int(x), int(height - 1 - y))
    os.remove(name)
    return colour.red(), colour.green(), colour.blue()


def point_at(graph, place):
    """Moves the mouse to a position in the graph (pixels)."""
    none = QtCore.Qt.NoButton
    event = QtGui.QMouseEvent(
        QtCore.QEvent.MouseMove,
        QtCore.QPointF(*place),
        QtCore.QPointF(graph.mapToGlobal(QtCore.QPoint(*map(int, place)))),
        none,
        none,
        QtCore.Qt.NoModifier,
    )
    QtWidgets.QApplication.sendEvent(graph, event)


def check_graph(graph):
    """On an axis of 365 mm, 5 mm can still be seen. A curve under the mouse shows its name."""
    names = [curve[0] for curve in graph.curves]
    place = names.index("Frame")
    height = graph.height()
    required, far = float(graph.y_of(5.0)), float(graph.y_of(graph.curves[place][2].min()))
    bottom = float(graph.y_of(0.0))
    assert bottom - required > 0.1 * height, (bottom, required, height)
    assert required - far > 0.3 * height, (required, far)
    x = float(graph.x_of(1.0))
    point_at(graph, (x, far))
    assert graph.pointed == place, (graph.pointed, names)
    text = graph.text_at(place, x)
    assert text.startswith("Frame: 35") and "at 1 s" in text, text
    point_at(graph, (x, 0.5 * (required + far)))
    assert graph.pointed == -1 or graph.pointed != place


def check_many_curves(graph):
    """The window responds while hundreds of neighbours have curves."""
    import numpy as np

    times = np.linspace(0, 2, 200)
    rows = [
        {"name": "Part {}".format(k), "curve": np.column_stack([times, 5 + k + np.sin(times)])}
        for k in range(600)
    ]
    report = {"required": 5.0, "neighbours": [dict(r, curve=r["curve"].tolist()) for r in rows]}
    graph.show_report(report)
    gaps = Gaps()
    yield 0.5
    for k in range(20):
        point_at(graph, (60 + 8 * k, 60))
        yield 0.05
    say("600 curves: the window stood still for " + gaps.stop())
    assert gaps.busy < 0.5, gaps.busy


def scenario():
    open_workbench()
    yield
    doc = new_document("Places")
    slide, path, wall = scene(doc)
    Gui.activeDocument().activeView().setCameraType("Orthographic")
    view = view_from("Top")
    yield 0.5
    seen = {"Post": (53, 25, 8), "Wall": (30, -4, 20), "Stop": (116, 28, 30)}
    camera = view.getCamera()

    def colours():
        view.setCamera(camera)  # choosing a row moves it
        return {name: colour_at(view, point) for name, point in seen.items()}

    before = colours()
    assert len(set(before.values())) == 2, before  # post and stop are of FreeCAD's own grey
    select(slide, path)
    Gui.runCommand("SweptVolume_Clearance")
    yield 0.5
    click(find(QtWidgets.QPushButton, "SweptVolumeCheck"))
    yield lambda: doc.getObject("Clearance") is not None
    yield 0.5
    undo, saved = doc.UndoCount, wall.ViewObject.DiffuseColor
    table = find(QtWidgets.QTableWidget, "SweptVolumeClearanceTable")
    now = colours()
    say("colours {}".format(now))
    assert now["Post"][0] > 2 * max(now["Post"][1:]), now  # a clash is red
    for name in ("Wall", "Stop"):  # below required is yellow
        r, g, b = now[name]
        assert min(r, g) > 2 * b, now
    shot("17_clearance_parts")
    yield 1.0
    check_graph(find(QtWidgets.QWidget, "SweptVolumeDistanceGraph"))
    # The button begins with the worst place, whatever column sorts the table.
    table.sortItems(0)
    worse = find(QtWidgets.QPushButton, "SweptVolumeNextWorst")
    back = find(QtWidgets.QPushButton, "SweptVolumePlaceBefore")
    names = []
    assert not back.isEnabled()
    while worse.isEnabled():
        click(worse)
        yield 0.2
        names.append(table.item(table.currentRow(), 0).text())
    assert names == ["Post", "Wall", "Stop", "Frame"], names
    click(back)
    yield 0.2
    assert table.item(table.currentRow(), 0).text() == "Stop"
    # A part is deleted and restored while parts are coloured; the other parts get their own colours
    # back.
    doc.openTransaction("Delete")
    doc.removeObject("Frame")
    doc.commitTransaction()
    doc.undo()
    assert doc.UndoCount == undo, doc.UndoNames
    paint = find(QtWidgets.QCheckBox, "SweptVolumePaint")
    click(paint)
    yield 0.3
    after = colours()
    assert after == before, (after, before)
    click(paint)
    yield 0.3
    yield from check_many_curves(find(QtWidgets.QWidget, "SweptVolumeDistanceGraph"))
    shot("18_graph_of_many")
    yield 1.0
    click(panel_button(Close))
    yield no_panel
    yield 0.3
    after = colours()
    assert after == before, (after, before)
    assert wall.ViewObject.DiffuseColor == saved
    assert doc.UndoCount == undo, doc.UndoNames


run(scenario)
