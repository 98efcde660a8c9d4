# SPDX-License-Identifier: LGPL-2.1-or-later
"""Runs the demo in a FreeCAD with a GUI (on a real or a virtual display) and closes FreeCAD; see
run-demo.

Works as a user would: the commands' own tasks run in the background while the event loop continues.
Exit status 0 only if every file was written and checked.
"""
import os
import sys
import time
import traceback

import FreeCAD as App


def _say(text):
    """Prints to the terminal directly, because some versions of FreeCAD discard the output of
    scripts."""
    os.write(1, (text + "\n").encode())


def _fail(text):
    lines = "".join("demo: {}\n".format(line) for line in text.rstrip().splitlines())
    os.write(2, lines.encode())
    os._exit(1)


def _finish(run):
    """Waits for a run while the window responds. Returns the longest gap between two timer ticks
    (s)."""
    from PySide import QtCore

    loop, gaps, last = QtCore.QEventLoop(), [0.0], [time.perf_counter()]

    def tick():
        now = time.perf_counter()
        gaps.append(now - last[0])
        last[0] = now

    ticker = QtCore.QTimer()
    ticker.timeout.connect(tick)
    ticker.start(5)
    run.ended.connect(lambda ended: loop.quit())
    (loop.exec if hasattr(loop, "exec") else loop.exec_)()
    ticker.stop()
    if run.state != "ok":
        raise RuntimeError(run.message)
    return max(gaps)


def _steps():
    import FreeCADGui as Gui
    from sweptvolume import core, demo, runner
    from sweptvolume.panels import tasks

    core.module()
    folder = demo.output_folder()
    Gui.activateWorkbench("SweptVolumeWorkbench")
    _say("1. The parts and the installation path ...")
    scene = demo.build()
    yield
    obj = demo.add_envelope(scene)
    from sweptvolume.features import solid
    from sweptvolume.features.envelope import Plan

    e = Plan.of(obj).estimate()
    _say("2. The envelope: {} x {} x {} cells of {:.2f} mm ...".format(*e["grid"], e["cell"]))
    gap = _finish(runner.start(tasks.EnvelopeTask(scene.document, Plan.of(obj), obj)))
    text = "   {} triangles in {} shell(s), {:.1f} cm^3, {:.2f} s, self-intersections: {}"
    _say(
        text.format(
            obj.Triangles, obj.Shells, obj.Volume.Value / 1000, obj.Seconds, obj.SelfIntersections
        )
    )
    _say("   longest pause of the window: {:.0f} ms".format(gap * 1000))
    yield
    _say("3. The solid ...")
    task = tasks.SolidTask(scene.document, obj, settings=solid.first_settings(obj))
    _finish(runner.start(task))
    scene.solid = task.obj
    shape = scene.solid.Shape
    if not shape.isValid() or not shape.Solids:
        raise RuntimeError("the solid is not valid")
    _say("   {} faces, {:.1f} cm^3, valid".format(len(shape.Faces), shape.Volume / 1000))
    yield
    step = os.path.join(folder, "starter_envelope.step")
    _say("4. The STEP file ...")
    _finish(runner.start(tasks.ExportTask(obj, step, solid.first_settings(obj))))
    yield
    picture = os.path.join(folder, "starter_envelope.png")
    scene.solid.ViewObject.Visibility = False
    obj.ViewObject.Visibility = True
    demo.set_view(scene.document)
    yield
    Gui.getDocument(scene.document.Name).activeView().saveImage(picture, 1600, 1100, "White")
    document = os.path.join(folder, "starter_envelope.FCStd")
    scene.document.saveAs(document)
    _say("Done. The results:")
    for path in (document, step, picture):
        if not os.path.getsize(path):
            raise RuntimeError("{} is empty".format(path))
        _say("   {:>9.1f} kB  {}".format(os.path.getsize(path) / 1000, path))
    App.closeDocument(scene.document.Name)


def main():
    """Starts the steps on the event loop."""
    from PySide import QtCore

    steps = _steps()

    def tick():
        try:
            next(steps)
            QtCore.QTimer.singleShot(200, tick)
        except StopIteration:
            sys.stdout.flush()
            os._exit(0)
        except BaseException as error:
            if os.environ.get("SWEPT_TRACE"):
                traceback.print_exc()
            _fail(str(error) or repr(error))

    QtCore.QTimer.singleShot(300, tick)


try:
    if not App.GuiUp:
        _fail(
            "needs the FreeCAD with a window; use run-demo, which brings a display if there is none."
        )
    main()
except Exception as error:
    _fail(str(error))
