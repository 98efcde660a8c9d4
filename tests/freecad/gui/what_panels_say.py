# SPDX-License-Identifier: LGPL-2.1-or-later
"""Notes in panels about consequences that users may not expect: Find path, for a motion that does not set
start and goal; the export of a solid, which uses the mesh; a study, for envelopes that cannot be runs.
"""
import os
import sys
import tempfile

sys.path.insert(0, os.path.dirname(os.path.realpath(__file__)))
from driver import (  # noqa: E402
    App,
    Cancel,
    Close,
    Gui,
    Ok,
    QtCore,
    QtWidgets,
    answered,
    click,
    find,
    new_document,
    no_panel,
    open_workbench,
    panel_button,
    run,
    select,
    visible_text,
)

V = App.Vector


def ends(doc, part, path):
    """Tests Find path with a selected motion, of both kinds of poses."""
    select(path)
    Gui.runCommand("SweptVolume_FindPath")
    yield 0.5
    assert "does not set start and goal" in visible_text(), visible_text()
    click(panel_button(Close))
    yield no_panel
    path.PoseType = "Absolute"
    doc.recompute()
    select(path)
    Gui.runCommand("SweptVolume_FindPath")
    yield 0.5
    assert "does not set start and goal" not in visible_text(), visible_text()
    click(panel_button(Close))
    yield no_panel


def export(hull, made, stale):
    from sweptvolume.panels import file_dialogs

    path = os.path.join(tempfile.mkdtemp(), "a.step")
    for chosen, noted in ((hull, False), (made, True)):
        select(chosen)
        with answered(file_dialogs, "ask_export", lambda *ignored: path):
            Gui.runCommand("SweptVolume_Export")
        yield 0.5
        assert ("stored solid is not used" in visible_text()) == noted, visible_text()
        assert ('"Together" is not up to date' in visible_text()) == stale, visible_text()
        click(panel_button(Cancel))
        yield no_panel
    yield from export_mesh(hull, stale)


def export_mesh(hull, stale):
    """A mesh file is written at once, or after OK if the envelope is not up to date."""
    from sweptvolume.panels import file_dialogs

    path = os.path.join(tempfile.mkdtemp(), "a.stl")
    select(hull)
    with answered(file_dialogs, "ask_export", lambda *ignored: path):
        Gui.runCommand("SweptVolume_Export")
    if stale:
        yield 0.5
        assert '"Together" is not up to date' in visible_text(), visible_text()
        assert not os.path.exists(path)
        click(panel_button(Ok))
    yield lambda: os.path.exists(path) and no_panel()


def study():
    Gui.Selection.clearSelection()
    Gui.runCommand("SweptVolume_Study")
    yield 0.5
    listed = find(QtWidgets.QListWidget, "SweptVolumeStudySources")
    ticks = {
        listed.item(i).text(): listed.item(i).checkState() == QtCore.Qt.Checked
        for i in range(listed.count())
    }
    assert ticks == {"Together": True, "Apart": False}, ticks
    click(panel_button(Close))
    yield no_panel


def scenario():
    from sweptvolume.features import envelope, motion, solid

    open_workbench()
    yield
    doc = new_document("Said")
    parts = [doc.addObject("Part::Box", name) for name in ("Arm", "Jaw")]
    parts[1].Placement.Base = V(0, 30, 0)
    there = [App.Placement(), App.Placement(V(40, 0, 0), App.Rotation())]
    path = motion.motion_from_poses(doc, [0, 1], there, frame="Relative")
    up = motion.motion_from_poses(
        doc, [0, 1], [App.Placement(), App.Placement(V(0, 0, 9), App.Rotation())]
    )
    hull = envelope.make_envelope(doc, parts[:1], path, "Together", Resolution=24)
    envelope.make_envelope(doc, parts, path, "Apart", Resolution=24, Motions=[path, up])
    doc.recompute()
    envelope.compute(hull)
    made = solid.make_solid(doc, hull)
    solid.compute(made)
    yield from study()
    yield from export(hull, made, stale=False)
    hull.Resolution = 30
    doc.recompute()
    yield from export(hull, made, stale=True)
    yield from ends(doc, parts[0], path)


run(scenario)
