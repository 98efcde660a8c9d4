# SPDX-License-Identifier: LGPL-2.1-or-later
"""Stop takes effect at once in every stage of a long run. If FreeCAD is closed during a run, it ends within
two seconds; otherwise an outside process ends it with an error.
"""
import os
import subprocess
import sys

sys.path.insert(0, os.path.dirname(os.path.realpath(__file__)))
from driver import (  # noqa: E402
    App,
    Gui,
    Ok,
    QtCore,
    QtWidgets,
    click,
    new_document,
    no_panel,
    open_workbench,
    panel_button,
    run,
    say,
    shot,
    stopped,
)

V = App.Vector
#: Longest time (s) from closing the window to the end of the process, without the time that its threads
#: waited for a processor core.
END = 2.0
#: Code of a separate process that kills a process that ends too late. Arguments: the number of this
#: process, and the time limit (s).
WATCH = """
import glob, os, sys, time
pid, end, began, known = int(sys.argv[1]), float(sys.argv[2]), time.monotonic(), {}
first = {}
while time.monotonic() - began - sum(known.values()) < end:
    for name in glob.glob("/proc/{}/task/*/schedstat".format(pid)):
        try:
            waited = 1e-9 * int(open(name).read().split()[1])
        except (OSError, IndexError):
            continue
        known[name] = waited - first.setdefault(name, waited)
    if not os.path.exists("/proc/{}".format(pid)):
        sys.exit()
    time.sleep(0.05)
os.kill(pid, 9)
"""
#: Number of holes along a side of the plate.
HOLES = 16
#: Progress, as a fraction of the bar, at which the run is stopped.
PARTS = (0.05, 0.2, 0.4, 0.6, 0.7, 0.8, 0.86)


def scene():
    import Part

    from sweptvolume.features import motion

    doc = new_document("Stop")
    body = doc.addObject("Part::Feature", "Body")
    body.Shape = Part.makeTorus(20, 6).fuse(Part.makeBox(30, 10, 10))
    turned = App.Rotation(V(0, 0, 1), 90)
    places = [
        App.Placement(),
        App.Placement(V(30, 0, 0), turned),
        App.Placement(V(30, 30, 0), turned),
    ]
    path = motion.motion_from_poses(doc, [0, 1, 2], places)
    doc.recompute()
    return doc, body, path


def heavy(doc, body, path):
    """Opens the panel, sets cells of 0.12 mm and a simplification, and starts the run."""
    from sweptvolume import runner
    from sweptvolume.panels import envelope_panel

    panel = envelope_panel.show(doc, [(body, "")], path)
    panel.by.setCurrentIndex(panel.by.findData("CellSize"))
    panel.cell.setProperty("rawValue", 0.12)
    panel.tolerance.setProperty("rawValue", 0.02)
    yield 0.3
    click(panel_button(Ok))
    yield lambda: bool(runner.running())
    return panel


def stopped_while_meshing(doc, path):
    """A step: a run is stopped while a plate is meshed that has so many holes that this takes seconds."""
    import Part

    from sweptvolume.panels import envelope_panel

    holes = [
        Part.makeCylinder(1, 4, V(3 + 5 * (k % HOLES), 3 + 5 * (k // HOLES), 0))
        for k in range(HOLES**2)
    ]
    side = 5 * HOLES + 1
    plate = doc.addObject("Part::Feature", "Plate")
    plate.Shape = Part.makeBox(side, side, 4).cut(Part.makeCompound(holes))
    panel = envelope_panel.show(doc, [(plate, "")], path)
    panel.by.setCurrentIndex(panel.by.findData("CellSize"))
    panel.cell.setProperty("rawValue", 0.2)
    yield 0.3
    click(panel_button(Ok))
    yield lambda: panel.run is not None
    yield 0.3
    assert panel.run.control.progress() == 0, "the plate was meshed before it could be stopped"
    yield from stopped_at(panel, 0)
    panel.reject()
    yield no_panel
    doc.removeObject(plate.Name)


def reached(panel, part):
    """Returns whether the progress bar has come this far, or the run has ended."""
    bar = panel.box.bar
    return lambda: panel.run is None or bar.value() >= part * bar.maximum()


def stopped_at(panel, part):
    """Stops the run of a panel when the progress bar has come this far. Returns the stage."""
    from sweptvolume import runner

    yield reached(panel, part)
    assert panel.run is not None, "the run was over before it could be stopped"
    stage, bar = panel.run.control.phase(), panel.box.bar.value()
    took = yield from stopped(lambda: panel.run is None)
    say("stopped in {}, bar at {}: {:.2f} s".format(stage, bar, took))
    assert not runner.running() and not panel.box.isVisible() and panel.message.text()
    return stage


def discard():
    """Answers FreeCAD's question about unsaved changes. From then on, FreeCAD must end in time."""
    question = QtWidgets.QApplication.activeModalWidget()
    if question is None:
        return QtCore.QTimer.singleShot(50, discard)
    say("stop_and_close.py passed")
    watch = ["python3", "-c", WATCH, str(os.getpid()), str(END)]
    subprocess.Popen(watch, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    question.button(QtWidgets.QMessageBox.Discard).click()


def scenario():
    open_workbench()
    yield
    doc, body, path = scene()
    panel = yield from heavy(doc, body, path)
    stages, values = set(), []
    for part in PARTS:
        if panel.run is None:
            click(panel_button(Ok))
            yield 0.1
        stages.add((yield from stopped_at(panel, part)))
    shot("61_stopped")
    yield 0.3
    assert len(stages) > 1, stages
    # The bar also moves in a stage that reports no progress.
    click(panel_button(Ok))
    for _ in range(8):
        yield 0.3
        if panel.run is None:
            break
        values.append(panel.box.bar.value())
    say("bar: {}".format(values))
    rising = [b > a for a, b in zip(values, values[1:])]
    assert len(values) > 3 and all(rising), values
    shot("62_bar")
    yield 0.3
    panel.reject()
    yield no_panel
    yield from stopped_while_meshing(doc, path)
    # Closed in the middle of a run.
    panel = yield from heavy(doc, body, path)
    yield reached(panel, 0.5)
    assert panel.run is not None, "the run is over before FreeCAD is closed"
    QtCore.QTimer.singleShot(300, discard)
    Gui.getMainWindow().close()
    yield 60


run(scenario)
