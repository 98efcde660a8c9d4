# SPDX-License-Identifier: LGPL-2.1-or-later
"""Improve path, as a user works: the demo's path becomes shorter and has fewer keys; then once more with a
locked key. The improved motions appear beside the old one and are checked.
"""
import os
import sys

sys.path.insert(0, os.path.dirname(os.path.realpath(__file__)))
from driver import (  # noqa: E402
    Close,
    Gui,
    QtCore,
    QtWidgets,
    click,
    find,
    no_panel,
    open_workbench,
    panel_button,
    run,
    select,
    shot,
)


def scenario():
    from sweptvolume import demo
    from sweptvolume.features import clearance, motion

    open_workbench()
    yield
    scene = demo.build()
    doc = scene.document
    motion.set_parts(scene.motion, [(scene.starter, "")])
    yield 0.5

    def motions():
        return [o for o in doc.Objects if motion.is_motion(o)]

    undo = doc.UndoCount
    select(scene.motion)
    Gui.runCommand("SweptVolume_ImprovePath")
    yield 0.5
    assert find(QtWidgets.QTableWidget, "SweptVolumeNeighbours").rowCount() == 5
    click(find(QtWidgets.QPushButton, "SweptVolumeFind"))
    yield lambda: len(motions()) == 2
    yield 0.5
    shot("90_improve_path")
    yield 0.7
    paths = find(QtWidgets.QTableWidget, "SweptVolumePaths")
    assert paths.rowCount() == 2 and doc.UndoCount == undo + 1
    before, after = ([paths.item(r, c).text() for c in range(5)] for r in range(2))
    assert int(after[1]) < int(before[1]) and float(after[2]) < float(before[2]), (before, after)
    assert float(after[4]) >= 1 and not scene.motion.ViewObject.Visibility, after
    keys = find(QtWidgets.QListWidget, "SweptVolumeLockedKeys")
    keys.item(5).setCheckState(QtCore.Qt.Checked)
    click(find(QtWidgets.QPushButton, "SweptVolumeFind"))
    yield lambda: len(motions()) == 3
    yield 0.5
    first, locked = motions()[1:]
    k = list(locked.Times).index(scene.motion.Times[5])
    assert (locked.Placements[k].Base - scene.motion.Placements[5].Base).Length < 1e-6
    assert scene.motion.Times[5] not in list(first.Times)
    click(panel_button(Close))
    yield no_panel
    for path in (first, locked):
        check = clearance.make_clearance(
            doc, MovingParts=[scene.starter], Motion=path, AllVisible=True, RequiredDistance=1.0
        )
        doc.recompute()
        for row in clearance.compute(check)["neighbours"]:
            if row["name"] == "Bell housing":  # the starter is bolted to it
                last = path.Placements[-1].Base
                assert row["below"][0][0] > path.Times[-2] - 1e-6 and not last.Length, row
            else:
                assert row["verdict"] == "clear", row


run(scenario)
