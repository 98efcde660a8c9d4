# SPDX-License-Identifier: LGPL-2.1-or-later
"""Measures how quickly the window responds: the updates of the live preview at 128 cells while a key is
dragged (with the CPU time of each), and the longest pause of the window then, during a run and at its end.
The figures are printed and not tested, because they depend on the machine. Skipped, with a message, if the
data are missing.
"""
import os
import sys
import time

sys.path.insert(0, os.path.dirname(os.path.realpath(__file__)))
from driver import (  # noqa: E402
    App,
    Cancel,
    Gaps,
    Gui,
    QtWidgets,
    click,
    find,
    QtCore,
    new_document,
    no_panel,
    open_workbench,
    panel_button,
    run,
    say,
    select,
    shot,
    viewport,
)

HERE = os.path.dirname(os.path.realpath(__file__))
DATA = os.path.join(HERE, "..", "..", "..", "..", "shared", "data")
CASES = (("fandisk", "fandisk_13k"), ("bunny", "bunny_stanford_70k"))
#: A drag takes SECONDS, or longer until there are LEAST previews.
CELLS, SECONDS, LEAST, LIMIT = 128, 4.0, 3, 100.0


class Spent(QtCore.QObject):
    """Measures the CPU seconds of the window's thread, of the software renderer's threads (if it draws)
    and of all others, and the number of pictures drawn."""

    def __init__(self):
        super().__init__()
        self.pictures, self.view, self.before = 0, viewport(), self._now()
        self.view.installEventFilter(self)

    def eventFilter(self, watched, event):  # noqa: N802
        self.pictures += event.type() == QtCore.QEvent.Paint
        return False

    def _now(self):
        found = [0.0, 0.0]
        for thread in os.listdir("/proc/self/task"):
            try:
                folder = "/proc/self/task/" + thread
                with open(folder + "/comm") as name, open(folder + "/schedstat") as times:
                    mine = int(thread) == os.getpid()
                    if mine or name.read().startswith("llvmpipe"):
                        found[0 if mine else 1] += int(times.read().split()[0]) / 1e9
            except OSError:
                pass  # the thread has ended
        return found + [time.process_time() - sum(found)]

    def stop(self, updates):
        """Returns these times as a text, divided by the number of updates."""
        self.view.removeEventFilter(self)
        spent = [1000 * (b - a) / max(updates, 1) for a, b in zip(self.before, self._now())]
        text = "{:.0f} ms of CPU a preview: window {:.0f}, drawing {:.0f}, core {:.0f}; {:.1f} pictures"
        return text.format(sum(spent), *spent, self.pictures / max(updates, 1))


def dragging(panel, row):
    """A generator that moves a key as the mouse would, as often as the dragger's timer reads its
    position."""
    from sweptvolume.views import dragger

    began, n, home = time.perf_counter(), 0, App.Placement(panel.keys.placements[row])
    due = began
    amplitude = 0.05 * max(b.Base.distanceToPoint(home.Base) for b in panel.keys.placements)
    base, back = panel.base(), panel.handle
    wanted = panel.preview.updates + LEAST
    while time.perf_counter() - began < SECONDS or panel.preview.updates < wanted:
        assert time.perf_counter() - began < LIMIT, "the preview stood still"
        n += 1
        place = App.Placement(home)
        place.Base.z += amplitude * (1 - abs(n % 40 - 20) / 20.0)
        panel.dragged(place.multiply(base.inverse()).multiply(panel.body.placement).multiply(back))
        while due <= time.perf_counter():  # ticks that are missed are left out, as Qt does
            due += dragger.POLL / 1000
        yield due - time.perf_counter()


def one(name, mesh_name):
    import Mesh

    from sweptvolume import runner
    from sweptvolume.features import motion
    from sweptvolume.panels import motion_panel

    doc = new_document(name)
    part = doc.addObject("Mesh::Feature", "Part")
    part.Mesh = Mesh.Mesh(os.path.join(DATA, "meshes", mesh_name + ".ply"))
    path = motion.motion_from_file(
        doc, os.path.join(DATA, "motions", "keyposes_16_arc_for_{}.csv".format(name)), "mm"
    )
    path.PoseType = "Relative"
    doc.recompute()
    Gui.activeDocument().activeView().viewIsometric()
    Gui.SendMsgToActiveView("ViewFit")
    select(part, path)
    Gui.runCommand("SweptVolume_EditMotion")
    yield 0.5
    Gui.Selection.clearSelection()
    panel = motion_panel.opened[-1]
    panel.preview.cells = CELLS
    for adapts in (False, True):
        panel.preview.adapts = adapts
        yield panel.preview.settled
        find(QtWidgets.QTableWidget, "SweptVolumeKeys").setCurrentCell(8, 1)
        yield 0.5
        gaps, done, began = Gaps(), panel.preview.updates, time.perf_counter()
        spent = Spent()
        yield from dragging(panel, 8)
        made, cells = panel.preview.updates - done, panel.preview.cells
        rate = made / (time.perf_counter() - began)
        text = "{}, {} cells{}: {:.1f} previews a second, longest gap {}"
        say(text.format(name, cells, " (adapted)" * adapts, rate, gaps.stop()))
        say("    " + spent.stop(made))
    gaps = Gaps()
    yield panel.preview.settled
    yield 0.5
    say("{}: longest gap while the fine envelope follows: {}".format(name, gaps.stop()))
    shot("60_latency_" + name)
    yield 0.8
    click(panel_button(Cancel))
    yield no_panel

    select(part, path)
    Gui.runCommand("SweptVolume_Envelope")
    yield 0.3
    find(QtWidgets.QSpinBox, "SweptVolumeResolution").setValue(512)
    yield 0.5
    gaps = Gaps()
    click(panel_button(QtWidgets.QDialogButtonBox.Ok))
    yield lambda: runner.running() and runner.running()[0].control.progress() > 0.9
    say("{}: longest gap during a compute: {}".format(name, gaps.stop()))
    gaps = Gaps()
    yield no_panel
    yield 0.5
    made = doc.getObject("Envelope")
    text = "{}: longest gap at its end, with {} triangles: {}"
    say(text.format(name, made.Triangles, gaps.stop()))
    shot("61_latency_" + name)
    yield 0.8
    App.closeDocument(doc.Name)
    yield


def scenario():
    open_workbench()
    yield
    for name, mesh_name in CASES:
        if os.path.isfile(os.path.join(DATA, "meshes", mesh_name + ".ply")):
            yield from one(name, mesh_name)
        else:
            say("{} skipped: the shared meshes are not here".format(name))


run(scenario)
