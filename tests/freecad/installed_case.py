# SPDX-License-Identifier: LGPL-2.1-or-later
"""Runs in a FreeCAD that has nothing but an installed package of this workbench (.ci/try-deb), with or
without a window. The envelope of a box is computed and written as STEP. In a window, each button of the
workbench must have a drawn icon. The results are written into the file that the variable SWEPT_RESULT names.
"""
import json
import os
import tempfile
import traceback

import FreeCAD as App


def computed():
    from sweptvolume import core, export
    from sweptvolume.features import envelope, motion, solid

    doc = App.newDocument()
    box, path = doc.addObject("Part::Box", "Box"), motion.make_motion(doc)
    path.Placements = [App.Placement(), App.Placement(App.Vector(30, 0, 0), App.Rotation())]
    path.Times = [0.0, 1.0]
    doc.recompute()
    hull = envelope.make_envelope(doc, [box], path, Resolution=32)
    envelope.compute(hull)
    body = solid.make_solid(doc, hull)
    solid.compute(body)
    step = os.path.join(tempfile.mkdtemp(), "hull.step")
    export.write(export.request(hull), step)
    return {
        "version": ".".join(App.Version()[:3]),
        "core": core.module().__file__,
        "volume": round(hull.Mesh.Volume, 1),
        "solid": body.Shape.isValid(),
        "step": os.path.getsize(step),
        "user": App.getUserAppDataDir(),
    }


def icons():
    """Returns (buttons of the workbench, those without a drawn icon)."""
    import FreeCADGui as Gui

    Gui.activateWorkbench("SweptVolumeWorkbench")
    Gui.updateGui()
    names = Gui.activeWorkbench().listToolbars()
    window, empty, count = Gui.getMainWindow(), [], 0
    from sweptvolume.panels.widgets import QtWidgets

    for bar in window.findChildren(QtWidgets.QToolBar):
        if bar.objectName() not in names or not bar.objectName().startswith("Swept"):
            continue
        for action in bar.actions():
            if action.isSeparator():
                continue
            count += 1
            image = action.icon().pixmap(24, 24).toImage()
            drawn = any(
                image.pixelColor(x, y).alpha()
                for x in range(image.width())
                for y in range(image.height())
            )
            empty += [] if drawn else [action.text()]
    if os.environ.get("SWEPT_SHOT"):
        window.grab().save(os.environ["SWEPT_SHOT"])
    return count, empty


def write_report():
    try:
        found = computed()
        if App.GuiUp:
            found["buttons"], found["without_icon"] = icons()
        good = found["volume"] == 4000 and found["solid"] and not found.get("without_icon")
        found["good"] = bool(good and found.get("buttons", 1))
    except Exception:  # pylint: disable=broad-except
        found = {"good": False, "problem": traceback.format_exc()}
    with open(os.environ["SWEPT_RESULT"], "w") as file:
        json.dump(found, file)
    os._exit(0)


if App.GuiUp:
    from PySide import QtCore

    QtCore.QTimer.singleShot(3000, write_report)  # after the window has opened
else:
    write_report()
