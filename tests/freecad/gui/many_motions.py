# SPDX-License-Identifier: LGPL-2.1-or-later
"""A mechanism of fifty parts with motions of 1,000 poses: the panel opens, the check starts and ends, and a
motion is changed. No pause of the window may be half as long as the time that FreeCAD takes on this machine
to read all poses one by one.
"""
import math
import os
import sys
import time

sys.path.insert(0, os.path.dirname(os.path.realpath(__file__)))
from driver import (  # noqa: E402
    App,
    Gaps,
    Gui,
    QtWidgets,
    click,
    find,
    new_document,
    open_workbench,
    run,
    say,
)

PARTS, POSES, APART = 50, 1000, 50.0
V = App.Vector


def scene():
    import Mesh

    from sweptvolume.features import motion

    doc = new_document("Fifty")
    pairs, motions = [], []
    for k in range(PARTS):
        part = doc.addObject("Mesh::Feature", "Ball{}".format(k))
        part.Mesh = Mesh.createSphere(10.0, 12)
        middle = V(APART * (k % 10), APART * (k // 10), 0)
        places = []
        for i in range(POSES):
            angle = 0.02 * i + 2 * math.pi * k / PARTS
            away = V(6 * math.cos(angle), 6 * math.sin(angle), 0)
            places.append(App.Placement(middle + away, App.Rotation(V(0, 0, 1), 0.1 * i)))
        motions.append(motion.motion_from_poses(doc, [0.01 * i for i in range(POSES)], places))
        motions[-1].ViewObject.Visibility = False
        pairs.append((part, ""))
    doc.recompute()
    return doc, pairs, motions


def one_by_one(motions):
    """Returns the seconds that FreeCAD needs to read all poses one by one."""
    began = time.thread_time()
    for path in motions:
        [(tuple(p.Base), p.Rotation.Q, p.toMatrix().A) for p in path.Placements]
    return time.thread_time() - began


class Judge:
    def __init__(self, motions):
        self.limit = min(one_by_one(motions) for _ in range(3)) / 2
        say("limit: {:.0f} ms".format(1000 * self.limit))

    def watch(self):
        self.gaps = Gaps()

    def stop(self, text):
        gap = self.gaps.stop()
        say("{}: {}".format(text, gap))
        assert self.gaps.busy < self.limit, (text, self.gaps.busy, self.limit)


def scenario():
    from sweptvolume.features.base import STALE, UP_TO_DATE
    from sweptvolume.panels import mechanism_panel

    open_workbench()
    yield
    doc, pairs, motions = scene()
    yield 1.0
    judge = Judge(motions)
    judge.watch()
    mechanism_panel.show(doc, pairs=pairs, motions=motions)
    yield
    table = find(QtWidgets.QTableWidget, "SweptVolumeMovingParts")
    yield lambda: table.cellWidget(PARTS - 1, 1) is not None  # created one after another
    judge.stop("the panel opens")
    boxes = [table.cellWidget(row, 1) for row in range(PARTS)]
    assert [box.currentData() for box in boxes] == [m.Name for m in motions]
    judge.watch()
    click(find(QtWidgets.QPushButton, "SweptVolumeCheckMechanism"))
    yield lambda: doc.getObject("Mechanism") is not None
    yield 0.5
    judge.stop("a check, from its beginning to its end")
    obj = doc.getObject("Mechanism")
    assert obj.Status == UP_TO_DATE, (obj.Status, obj.Message)
    assert obj.Checked == PARTS * (PARTS - 1) // 2, obj.Checked
    judge.watch()
    motions[7].Placements = motions[8].Placements
    doc.recompute()
    yield 0.5
    judge.stop("a motion is another one")
    assert obj.Status == STALE, obj.Status
    Gui.Control.closeDialog()


run(scenario)
