# SPDX-License-Identifier: LGPL-2.1-or-later
"""A clearance check by real commands: envelope, check, table, row, colours, graph, spreadsheet."""
import os
import sys

sys.path.insert(0, os.path.dirname(os.path.realpath(__file__)))
from driver import (  # noqa: E402
    App,
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
    shot,
)


def scenario():
    from sweptvolume.features import clearance, envelope, motion

    open_workbench()
    yield
    doc = new_document("Check")
    box = doc.addObject("Part::Box", "Slide")
    box.Length, box.Width, box.Height = 30, 16, 10

    def place(x, y, degrees):
        return App.Placement(App.Vector(x, y, 0), App.Rotation(App.Vector(0, 0, 1), degrees))

    path = motion.motion_from_poses(
        doc, [0, 1, 2], [place(0, 0, 0), place(60, 0, 0), place(90, 50, 90)]
    )
    for name, x, y, size in (
        ("Post", 48, 22, 6),
        ("Wall", 100, -20, 12),
        ("Stop", 58, 52, 14),
        ("Far", -40, 60, 10),
    ):
        part = doc.addObject("Part::Box", name)
        part.Length = part.Width = size
        part.Height = 20
        part.Placement.Base = App.Vector(x, y, -5)
    doc.recompute()
    swept = envelope.make_envelope(doc, [box], path, Resolution=90)
    doc.recompute()
    envelope.compute(swept)
    path.ViewObject.Visibility = False
    Gui.activeDocument().activeView().viewIsometric()
    Gui.SendMsgToActiveView("ViewFit")
    yield
    undo = doc.UndoCount
    select(swept)
    Gui.runCommand("SweptVolume_Clearance")
    yield 0.5
    click(find(QtWidgets.QPushButton, "SweptVolumeCheck"))
    yield lambda: doc.getObject("Clearance") is not None
    yield 0.5
    obj = doc.getObject("Clearance")
    assert obj.Status == clearance.UP_TO_DATE, obj.Status
    assert doc.UndoCount == undo + 1, (doc.UndoCount, undo)
    table = find(QtWidgets.QTableWidget, "SweptVolumeClearanceTable")
    assert table.rowCount() == 4, table.rowCount()
    distances = [float(table.item(r, 2).text()) for r in range(4)]
    assert distances == sorted(distances), distances
    summary = find(QtWidgets.QLabel, "SweptVolumeClearanceSummary").text()
    assert "4 checked" in summary, summary
    shot("11_clearance_table")
    yield 1.0
    table.selectRow(1)
    yield 0.5
    view = obj.ViewObject.Proxy
    assert view.row.getNumChildren() >= 1
    shot("12_clearance_row")
    yield 1.0
    Gui.SendMsgToActiveView("ViewFit")
    find(QtWidgets.QCheckBox, "SweptVolumeColours").setChecked(True)
    yield 0.5
    assert view.colours.getNumChildren() == 1 and not swept.ViewObject.Visibility
    shot("13_clearance_colours")
    yield 1.0
    click(panel_button(Close))
    yield no_panel
    assert swept.ViewObject.Visibility and view.colours.getNumChildren() == 0
    doc.getObject("Post").Placement.Base.y = 40
    doc.recompute()
    obj.touch()
    doc.recompute()
    assert obj.Status == clearance.STALE, obj.Status


run(scenario)
