# SPDX-License-Identifier: LGPL-2.1-or-later
"""Sequence, as a user works: parts in the wrong order give a message and change nothing. An order is found,
played and edited; the sequence becomes stale, is checked again and opened again. A search is stopped.
"""
import os
import sys

sys.path.insert(0, os.path.dirname(os.path.realpath(__file__)))
from driver import (  # noqa: E402
    App,
    Close,
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
)

V = App.Vector


def scene(doc):
    """Makes a box, a part that goes into it, and a lid: the part must be installed first."""
    import Part

    outer, inner = Part.makeBox(60, 40, 30, V(-30, -20, 0)), Part.makeBox(
        54, 34, 27, V(-27, -17, 3)
    )
    box = doc.addObject("Part::Feature", "Case")
    box.Shape = outer.cut(inner)
    block = doc.addObject("Part::Feature", "Block")
    block.Shape = Part.makeBox(40, 24, 20, V(-20, -12, 5))
    lid = doc.addObject("Part::Feature", "Lid")
    lid.Shape = Part.makeBox(60, 40, 4, V(-30, -20, 32))
    doc.recompute()
    return box, block, lid


def ours(doc, start):
    return [o for o in doc.Objects if o.Name.startswith(start)]


def states():
    table = find(QtWidgets.QTableWidget, "SweptVolumeSequenceParts")
    return [table.item(row, 2).text() for row in range(table.rowCount())]


def names():
    table = find(QtWidgets.QTableWidget, "SweptVolumeSequenceParts")
    return [table.item(row, 0).text() for row in range(table.rowCount())]


def scenario():
    from sweptvolume.features import sequence
    from sweptvolume.features.base import STALE, UP_TO_DATE
    from sweptvolume.panels import sequence_panel

    open_workbench()
    doc = new_document("Sequences")
    box, block, lid = scene(doc)
    yield 0.5
    select(lid, block)
    Gui.runCommand("SweptVolume_Sequence")
    yield 0.6
    assert names() == ["Lid", "Block"], names()
    find(QtWidgets.QCheckBox, "SweptVolumeTranslationOnly").setChecked(True)
    find(QtWidgets.QDoubleSpinBox, "SweptVolumeBudget").setValue(600)
    begin = find(QtWidgets.QPushButton, "SweptVolumeFind")
    order = find(QtWidgets.QPushButton, "SweptVolumeFindOrder")
    panel = sequence_panel.opened[-1]
    panel.release.setProperty("rawValue", 0.0)
    panel.budget.setValue(2)  # the block cannot get out below the lid
    click(begin)
    yield lambda: panel.run is None
    assert not ours(doc, "Sequence") and not ours(doc, "Motion"), states()
    assert "Lid" in states()[1], states()
    shot("sequence_not_found")

    panel.budget.setValue(600)
    click(order)
    yield lambda: panel.run is None
    made = ours(doc, "Sequence")
    assert len(made) == 1 and len(ours(doc, "Motion")) == 2, (states(), panel.message.text())
    assert names() == ["Block", "Lid"] and made[0].Status == UP_TO_DATE
    say("found: " + made[0].Summary)

    report = sequence.report_of(made[0])
    panel.player.go_to(report["steps"][1]["begin"])
    yield lambda: panel.ghosts is not None
    places = [course(panel.player.now()).Base for course in panel.courses]
    assert (places[1] - panel.courses[1](report["duration"]).Base).Length > 50, places
    assert (places[0] - panel.courses[0](report["duration"]).Base).Length < 1e-9, places
    find(QtWidgets.QComboBox, "SweptVolumeSpeed")
    click(panel.player.play)
    yield lambda: panel.player.now() > report["steps"][1]["begin"] + 0.2
    shot("sequence_played")
    click(panel_button(Close))
    yield no_panel

    path = made[0].Motions[1]
    doc.openTransaction("edit")
    path.Placements = [p.multiply(App.Placement(V(9, 0, 0), App.Rotation())) for p in
                       path.Placements[:1]] + path.Placements[1:]  # fmt: skip
    doc.commitTransaction()
    # A setting that scripts can set, but no field shows.
    made[0].AllVisible, made[0].Neighbours, made[0].Accuracy = True, [], 0.02
    made[0].RuleParts, made[0].RuleKinds = [(block, ""), (lid, "")], ["Required"]
    made[0].RuleLengths = [0.5]
    doc.recompute()
    assert made[0].Status == STALE
    select(made[0])
    Gui.runCommand("SweptVolume_Sequence")
    yield 0.6
    assert names() == ["Block", "Lid"]
    panel = sequence_panel.opened[-1]
    # The result from before the edit is neither shown as valid nor played.
    assert "stale" in panel.message.text() and states() == ["", ""], panel.message.text()
    assert panel.player.isHidden()
    click(find(QtWidgets.QPushButton, "SweptVolumeFind"))
    yield lambda: panel.run is None
    assert made[0].Status == UP_TO_DATE and len(ours(doc, "Motion")) == 2, panel.message.text()
    assert [o.Name for o, _ in made[0].Neighbours] == ["Case"], made[0].Neighbours
    assert made[0].Accuracy.Value == 0.02 and list(made[0].RuleLengths) == [0.5]

    choose("SweptVolumeSequenceMotion0", "")
    table = find(QtWidgets.QTableWidget, "SweptVolumeSequenceParts")
    table.selectRow(0)
    click(find(QtWidgets.QPushButton, "SweptVolumePartDown"))
    assert names() == ["Lid", "Block"]
    click(find(QtWidgets.QPushButton, "SweptVolumeFind"))
    yield lambda: panel.run is not None and panel.looked == 1
    yield from stopped(lambda: panel.run is None)
    assert len(ours(doc, "Motion")) == 2
    click(panel_button(Close))
    yield no_panel
    doc.undo()
    App.closeDocument(doc.Name)


run(scenario)
