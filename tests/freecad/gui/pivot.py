# SPDX-License-Identifier: LGPL-2.1-or-later
"""The pivot in the motion editor: with the pivot in the middle of the part, a key that only turns does not
make the part swing out. The middle of the part, the origin of the poses and a selected point are tested.
"""
import os
import sys

sys.path.insert(0, os.path.dirname(os.path.realpath(__file__)))
from driver import (  # noqa: E402
    App,
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
    select,
    shot,
)

MIDDLE = App.Vector(105, 5, 5)


def button(name):
    return find(QtWidgets.QPushButton, "SweptVolume" + name)


def kind():
    return find(QtWidgets.QComboBox, "SweptVolumePivot").currentData()


def scenario():
    import Part

    from sweptvolume.panels import motion_panel
    from sweptvolume.trajectory.poses import at_time

    def swing(panel):
        """Returns how far (mm) the middle of the part has moved away half-way between two keys."""
        back = panel.base().inverse()
        poses = panel.world_poses()
        there = at_time(poses, panel.interpolation.currentData(), 0.5 * poses.times[-1])
        return (there.multiply(back).multVec(MIDDLE) - MIDDLE).Length

    open_workbench()
    doc = new_document("Pivot")
    part = doc.addObject("Part::Feature", "Cube")
    part.Shape = Part.makeBox(10, 10, 10, App.Vector(100, 0, 0)).cut(
        Part.makeCylinder(2, 10, App.Vector(102, 3, 0))
    )
    doc.recompute()
    Gui.activeDocument().activeView().viewTop()
    Gui.SendMsgToActiveView("ViewFit")
    select(part)
    Gui.runCommand("SweptVolume_NewMotion")
    yield
    panel = motion_panel.opened[-1]
    assert kind() == "Middle"
    for name in ("Capture", "Duplicate"):
        click(button(name))
        yield
    table = find(QtWidgets.QTableWidget, "SweptVolumeKeys")
    assert table.item(0, 1).text() == "105", table.item(0, 1).text()
    table.item(1, 4).setText("90")
    yield panel.preview.settled
    assert swing(panel) < 1e-9, swing(panel)
    assert (panel.dragger.placement().Base - MIDDLE).Length < 1e-3
    shot("60_pivot_middle")
    yield 0.5

    # With the pivot at the origin of the poses, the same keys make the part swing out, and the table
    # shows the placements.
    choose("SweptVolumePivot", "Origin")
    yield panel.preview.settled
    assert swing(panel) > 14, swing(panel)
    assert table.item(0, 1).text() == "0"
    table.setCurrentCell(0, 1)
    yield
    assert panel.dragger.placement().Base.Length < 1e-3

    # The centre of the hole is taken as the pivot, after a message that asks for a selection.
    click(button("TakePivot"))
    assert "Select a vertex" in panel.message.text(), panel.message.text()
    edges = enumerate(part.Shape.Edges, 1)
    hole = next(k for k, edge in edges if hasattr(edge.Curve, "Radius"))
    select((part, "Edge{}".format(hole)))
    click(button("TakePivot"))
    yield panel.preview.settled
    assert kind() == "Point" and panel.message.text() == ""
    there = panel.dragger.placement().Base
    shot("62_pivot_point")
    yield 0.5
    assert (there - App.Vector(102, 3, there.z)).Length < 1e-3, there
    choose("SweptVolumePivot", "Middle")
    yield
    Gui.Selection.clearSelection()
    click(panel_button(Ok))
    yield no_panel
    path = doc.getObject("Motion")
    assert (path.Pivot - MIDDLE).Length < 1e-6 and path.Label == "Motion of Cube", path.Label
    assert path.Parts == [(part, ("",))], path.Parts

    # The editor opens again with the same pivot, without a selection. With relative poses the pivot is
    # the same.
    select(path)
    Gui.runCommand("SweptVolume_EditMotion")
    yield
    panel = motion_panel.opened[-1]
    assert kind() == "Middle" and panel.pair[0] is part
    panel.frame.setCurrentIndex(panel.frame.findData("Relative"))
    yield panel.preview.settled
    table = find(QtWidgets.QTableWidget, "SweptVolumeKeys")
    assert [table.item(0, c).text() for c in range(1, 7)] == ["0"] * 6
    assert swing(panel) < 1e-9, swing(panel)
    shot("61_pivot_relative")
    yield 0.5
    click(panel_button(Ok))
    yield no_panel

    # Another part is selected in the tree while the editor is open: the keys stay.
    other = doc.addObject("Part::Box", "Other")
    doc.recompute()
    select(path)
    Gui.runCommand("SweptVolume_EditMotion")
    yield
    Gui.Selection.clearSelection()
    click(button("ChoosePart"))
    panel = motion_panel.opened[-1]
    assert "Select the moving part" in panel.message.text() and panel.pair[0] is part
    table = find(QtWidgets.QTableWidget, "SweptVolumeKeys")
    table.item(1, 0).setText("3")
    select(other)
    click(button("ChoosePart"))
    yield
    panel = motion_panel.opened[-1]
    assert panel.pair[0] is other and panel.keys.times == [0.0, 3.0] and panel.history.before
    shot("63_other_part")
    yield 0.5
    click(panel_button(Ok))
    yield no_panel
    assert path.Parts == [(other, ("",))] and list(path.Times) == [0, 3], path.Parts
    App.closeDocument(doc.Name)
    yield


run(scenario)
