# SPDX-License-Identifier: LGPL-2.1-or-later
"""Check reserved spaces, as a user works: two envelopes and a part, the table, the shared volume shown and
kept, a stale result computed again, undo. With large parts the window responds, and the check can be
stopped.
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
    QtWidgets,
    check_table,
    click,
    find,
    new_document,
    no_panel,
    open_workbench,
    panel_button,
    read_verdicts,
    run,
    say,
    select,
    shot,
    titles_of,
    view_from,
)
from spaces import add_box, at, hidden_motion, swept_space  # noqa: E402


def envelopes(doc):
    """Returns two envelopes that cross: one of 10 x 10 mm along x, and one along y that lies 4 mm
    higher."""
    found = []
    for name, start, end in (
        ("First", (0, 0, 0), (60, 0, 0)),
        ("Second", (30, -30, 4), (30, 30, 4)),
    ):
        part = add_box(doc, name + "Part", (10, 10, 10), start)
        swept = swept_space(doc, part, hidden_motion(doc, at(*start), at(*end)), 64)
        swept.Label = name
        found.append(swept)
    return found


def names_of(table):
    return [table.item(r, 0).text() for r in range(table.rowCount())]


def scenario():
    from sweptvolume.features import shared

    open_workbench()
    yield
    doc = new_document("Spaces")
    first, second = envelopes(doc)
    post = add_box(doc, "Post", (4, 4, 30), (72, 3, -10))  # 2 mm from the first envelope
    doc.recompute()
    view = view_from("Isometric")
    yield
    graph = view.getSceneGraph()
    drawn, undo = graph.getNumChildren(), doc.UndoCount
    select(first, second, post)
    Gui.runCommand("SweptVolume_Overlap")
    yield 0.3
    assert find(QtWidgets.QLabel, "SweptVolumeSpaces").text().startswith("3 chosen")
    find(QtWidgets.QWidget, "SweptVolumeSpacesRequired").setProperty("rawValue", 5.0)
    click(find(QtWidgets.QPushButton, "SweptVolumeCheckSpaces"))
    yield lambda: any(
        t.isVisible() and t.rowCount() == 3
        for t in Gui.getMainWindow().findChildren(QtWidgets.QTableWidget, "SweptVolumeSpacesTable")
    )
    yield 0.3
    table = find(QtWidgets.QTableWidget, "SweptVolumeSpacesTable")
    heads = ["Pair", "Verdict", "Distance\nmm", "Volume\nmm^3"]
    assert titles_of(table) == heads, titles_of(table)
    check_table(table)
    assert names_of(table) == ["First - Second", "First - Post", "Second - Post"], names_of(table)
    assert abs(float(table.item(0, 3).text()) - 10 * 10 * 6) < 0.5, table.item(0, 3).text()
    assert [table.item(r, 1).text() for r in range(3)] == ["Clash", "Below required", "Clear"]
    read_verdicts(table)
    summary = find(QtWidgets.QLabel, "SweptVolumeSpacesSummary").text()
    assert "checked: 3" in summary and "shared" in summary, summary
    keep = find(QtWidgets.QPushButton, "SweptVolumeKeepShared")
    assert not keep.isEnabled()
    table.selectRow(1)
    yield 0.2
    assert not keep.isEnabled() and graph.getNumChildren() == drawn + 2
    table.selectRow(0)
    yield 0.3
    shot("91_reserved_spaces")
    yield 1.0
    assert doc.UndoCount == undo, doc.UndoNames  # nothing was written so far
    click(keep)
    yield lambda: doc.getObject("SharedVolume") is not None
    yield 0.5
    kept = doc.getObject("SharedVolume")
    assert kept.Status == shared.UP_TO_DATE and kept.Label == "First & Second", kept.Label
    assert abs(kept.Volume.Value - 600) < 0.5 and doc.UndoCount == undo + 1, kept.Volume
    click(panel_button(Close))
    yield no_panel
    assert graph.getNumChildren() <= drawn + 1  # only the new object is drawn
    first.ViewObject.Transparency = second.ViewObject.Transparency = 70
    yield 0.3
    shot("92_shared_volume")
    yield 1.0
    doc.getObject("SecondPart").Height = 8
    doc.recompute()
    assert kept.Status == shared.STALE, kept.Status
    doc.getObject("SecondPart").Height = 10
    doc.recompute()
    assert kept.Status == shared.UP_TO_DATE, kept.Status
    kept.MeshDeflection = 0.02
    doc.recompute()
    assert kept.Status == shared.STALE, kept.Status
    select(kept)
    Gui.runCommand("SweptVolume_Overlap")
    yield lambda: kept.Status == shared.UP_TO_DATE
    yield no_panel
    yield from large(doc)


def large(doc):
    """Rings of 500,000 triangles: the window responds, and Stop takes effect at once."""
    import Mesh

    rings = []
    for k in range(2):
        ring = doc.addObject("Mesh::Feature", "Ring{}".format(k))
        ring.Mesh = Mesh.createTorus(30.0, 10.0, 500)
        ring.Placement.Base = App.Vector(200, 25 * k, 0.1)
        rings.append(ring)
    yield 0.5
    select(*rings)
    Gui.runCommand("SweptVolume_Overlap")
    yield 0.5
    gaps = Gaps()
    click(find(QtWidgets.QPushButton, "SweptVolumeCheckSpaces"))
    yield lambda: any(
        b.isVisible()
        for b in Gui.getMainWindow().findChildren(QtWidgets.QPushButton, "SweptVolumeStop")
    )
    click(find(QtWidgets.QPushButton, "SweptVolumeStop"))
    yield lambda: find(QtWidgets.QPushButton, "SweptVolumeCheckSpaces").isEnabled()
    click(find(QtWidgets.QPushButton, "SweptVolumeCheckSpaces"))
    yield 0.3
    yield lambda: find(QtWidgets.QPushButton, "SweptVolumeCheckSpaces").isEnabled()
    yield 0.3
    table = find(QtWidgets.QTableWidget, "SweptVolumeSpacesTable")
    assert table.rowCount() == 1 and table.item(0, 1).text() == "Clash"
    table.selectRow(0)
    yield 0.3
    say("large: the window stood still for " + gaps.stop())
    click(panel_button(Close))
    yield no_panel


run(scenario)
