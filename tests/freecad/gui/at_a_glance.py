# SPDX-License-Identifier: LGPL-2.1-or-later
"""Details of the window: colours of envelope and solid; a command without a selection takes the only
possible object; one motion for several envelopes; loop and slider of the player; the size of the dragger;
headings and names in the table.
"""
import os
import sys

sys.path.insert(0, os.path.dirname(os.path.realpath(__file__)))
from driver import (  # noqa: E402
    App,
    Cancel,
    Close,
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
)

V = App.Vector


def colour(obj):
    """Returns the colour (red, green, blue) that is drawn, however this FreeCAD stores it."""
    view = obj.ViewObject
    if hasattr(view, "ShapeColor"):
        return tuple(view.ShapeColor)[:3]
    return tuple(view.ShapeAppearance[0].DiffuseColor)[:3]


def tip(name):
    from sweptvolume.panels import widgets

    return widgets.actions_of("SweptVolume_" + name)[0].toolTip()


def scenario():
    from sweptvolume.features import clearance, envelope, motion, solid
    from sweptvolume.panels import motion_panel

    open_workbench()
    yield
    doc = new_document("Glance")
    slide, other = doc.addObject("Part::Box", "Slide"), doc.addObject("Part::Box", "Other")
    other.Placement.Base = V(0, 0, 40)
    places = [App.Placement(), App.Placement(V(30, 0, 0), App.Rotation())]
    path = motion.motion_from_poses(doc, [0, 1], places)
    path.PoseType = "RelativeToFirst"  # each part starts at its present placement
    doc.recompute()
    hulls = [envelope.make_envelope(doc, [part], path, Resolution=24) for part in (slide, other)]
    doc.recompute()
    for hull in hulls:
        envelope.compute(hull)
    doc.recompute()

    # One motion for two envelopes: after it changes, both are stale, and each is computed on its own.
    assert [hull.Status for hull in hulls] == [envelope.UP_TO_DATE] * 2
    assert abs(hulls[0].Mesh.BoundBox.ZMin) < 2 and hulls[1].Mesh.BoundBox.ZMin > 35
    path.Times = [0, 2]
    path.Placements = [places[0], App.Placement(V(20, 0, 0), App.Rotation())]
    doc.recompute()
    assert [hull.Status for hull in hulls] == [envelope.STALE] * 2, [h.Status for h in hulls]
    envelope.compute(hulls[0])
    doc.recompute()
    assert [hull.Status for hull in hulls] == [envelope.UP_TO_DATE, envelope.STALE]

    # The envelope is blue and the solid golden; neither has FreeCAD's grey.
    red, green, blue = colour(hulls[0])
    assert blue > red + 0.3, (red, green, blue)
    body = solid.make_solid(doc, hulls[0])
    solid.compute(body)
    red, green, blue = colour(body)
    assert red > blue + 0.3, (red, green, blue)
    shot("87_colours")
    yield 0.5

    # With two candidates, the command asks for a selection. A single candidate is used without a
    # selection.
    Gui.Selection.clearSelection()
    yield 0.3
    assert not Gui.isCommandActive("SweptVolume_Solid")
    assert "The document has 2 envelopes" in tip("Solid"), tip("Solid")
    doc.removeObject(hulls[1].Name)
    yield 0.3
    assert Gui.isCommandActive("SweptVolume_Solid")
    Gui.runCommand("SweptVolume_Solid")
    yield 0.3
    assert Gui.Control.activeDialog()
    click(panel_button(Cancel))
    yield no_panel
    Gui.Selection.clearSelection()
    Gui.runCommand("SweptVolume_EditMotion")
    yield 0.5
    assert motion_panel.opened and motion_panel.opened[0].obj is path

    # With *Loop*, the player starts again at the end. Its slider is large enough for the mouse.
    panel = motion_panel.opened[0]
    player = panel.player
    say("slider: {} of {} pixels".format(player.slider.width(), panel.form.width()))
    assert player.slider.width() > 80, player.slider.width()
    player.go_to(1.9)
    player.loop.setChecked(True)
    player.play.setChecked(True)
    yield lambda: player.now() < 1.0
    assert player.play.isChecked(), "it stopped at the end"
    player.loop.setChecked(False)
    player.go_to(1.9)
    yield lambda: not player.play.isChecked()
    assert player.now() == 2.0, player.now()

    # The dragger is as large as the part (pivot.py tests its position).
    find(QtWidgets.QTableWidget, "SweptVolumeKeys").setCurrentCell(1, 1)
    yield 0.5
    box = slide.Shape.BoundBox
    assert panel.dragger.arrow < box.DiagonalLength, (panel.dragger.arrow, box.DiagonalLength)
    shot("88_slider_and_dragger")
    yield 0.5
    click(panel_button(Cancel))
    yield no_panel

    # Headings and names of the table, also with a column of depths.
    for name, place in (("Bucket of the excavator", V(12, 5, 5)), ("Neighbour", V(0, 13, 0))):
        doc.addObject("Part::Box", "Part").Label = name
        doc.Objects[-1].Placement.Base = place
    doc.recompute()
    select(hulls[0])
    Gui.runCommand("SweptVolume_Clearance")
    yield 0.5
    click(find(QtWidgets.QPushButton, "SweptVolumeCheck"))
    yield lambda: doc.getObject("Clearance") is not None
    yield 0.5
    assert doc.Clearance.Status == clearance.UP_TO_DATE
    table = find(QtWidgets.QTableWidget, "SweptVolumeClearanceTable")
    assert not table.isColumnHidden(4), "no depths"
    check_table(table)
    table.clearSelection()
    read_verdicts(table)
    shot("89_table_with_depths")
    yield 0.5
    click(panel_button(Close))
    yield no_panel


run(scenario)
