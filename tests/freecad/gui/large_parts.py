# SPDX-License-Identifier: LGPL-2.1-or-later
"""Parts with very many faces are read in the background: by a panel, by runs, and when a document is
recomputed after opening. The longest pause of the window is compared with the time that reading them at
once takes on this machine.
"""
import math
import os
import sys
import tempfile
import time

sys.path.insert(0, os.path.dirname(os.path.realpath(__file__)))
from driver import (  # noqa: E402
    App,
    Close,
    Gaps,
    Gui,
    Ok,
    QtGui,
    QtWidgets,
    click,
    find,
    new_document,
    no_panel,
    open_workbench,
    panel_button,
    run,
    say,
    select,
    tree,
)

V = App.Vector
SIDES, PARTS = 330, 8


def star():
    """Returns a prism with SIDES sides."""
    import Part

    points = []
    for k in range(SIDES):
        angle, radius = 2 * math.pi * k / SIDES, 50 + 4 * (k % 2) + 0.01 * k
        points.append(V(radius * math.cos(angle), radius * math.sin(angle), 0))
    return Part.Face(Part.makePolygon(points + points[:1])).extrude(V(0, 0, 10))


def scene(folder):
    from sweptvolume.features import motion

    doc = new_document("Large")
    shape = star()
    for k in range(PARTS):
        part = doc.addObject("Part::Feature", "Star{}".format(k))
        part.Shape = shape.copy()  # the parts share no shape
        part.Placement.Base.z = 30 * k
    places = [App.Placement(), App.Placement(V(0, 0, 8), App.Rotation())]
    motion.motion_from_poses(doc, [0, 1], places)
    doc.recompute()
    doc.saveAs(os.path.join(folder, "large.FCStd"))
    return doc


def measured(text, steps, limit):
    """Runs steps and checks how long the window's own thread worked between two events."""
    gaps = Gaps()
    yield from steps
    gap = gaps.stop()
    say("{}: longest gap {}; at once {:.0f} ms".format(text, gap, 1000 * limit))
    assert gaps.busy < limit / 2, (text, gaps.busy, limit)


def by_panel(show, button, over):
    """Opens a panel, starts its run and waits until it ends."""
    panel = show()
    yield 1.0
    click(button())
    yield lambda: over(panel)


def marked(*objects):
    """Marks objects for recompute with the entry of the tree's context menu, as a user does to have a
    result checked again."""
    select(*objects)
    yield 0.5
    actions = tree().findChildren(getattr(QtWidgets, "QAction", None) or QtGui.QAction)
    # FreeCAD 1.1 writes its menus with capitals.
    (action,) = [a for a in actions if a.text().lower() == "mark to recompute"]
    action.trigger()
    assert all("Touched" in obj.State for obj in objects), [obj.State for obj in objects]
    Gui.Selection.clearSelection()


def judged(doc, hull, wanted):
    """Checks that a change which cannot be noticed at once is noticed a little later."""
    from sweptvolume.features import envelope

    doc.recompute()
    assert hull.Status == envelope.STALE, hull.Status
    yield lambda: hull.Status == wanted


def scenario():
    from sweptvolume import apart
    from sweptvolume.features import clearance, envelope
    from sweptvolume.panels import clearance_panel, envelope_panel

    with tempfile.TemporaryDirectory() as folder:
        open_workbench()
        yield
        doc = scene(folder)
        yield 0.5
        began = time.thread_time()
        for k in range(PARTS):
            apart.of(doc.getObject("Star{}".format(k))).text()
        limit = time.thread_time() - began
        apart._known.clear()  # as in a document that was just opened
        first = doc.Star0, ""
        steps = by_panel(
            lambda: envelope_panel.show(doc, [first], doc.Motion),
            lambda: panel_button(Ok),
            lambda panel: no_panel(),
        )
        yield from measured("envelope", steps, limit)
        hull = doc.Envelope
        assert hull.Status == envelope.UP_TO_DATE, hull.Status
        apart._known.clear()
        steps = by_panel(
            lambda: clearance_panel.show(doc, pairs=[first], motion_obj=doc.Motion),
            lambda: find(QtWidgets.QPushButton, "SweptVolumeCheck"),
            lambda panel: panel.run is None and panel.obj is not None,
        )
        yield from measured("clearance", steps, limit)
        click(panel_button(Close))
        yield no_panel
        check = doc.Clearance
        assert check.Status == clearance.UP_TO_DATE, check.Status
        doc.save()
        App.closeDocument(doc.Name)
        yield 0.3
        doc = App.openDocument(os.path.join(folder, "large.FCStd"))
        yield 0.5
        hull, check = doc.Envelope, doc.Clearance
        # The results are checked again, and are still up to date.
        yield from marked(hull, check)
        yield from measured("same", judged(doc, check, clearance.UP_TO_DATE), limit)
        yield lambda: hull.Status == envelope.UP_TO_DATE
        assert not [o.Name for o in doc.Objects if "Touched" in o.State]
        # A part gets another geometry of the same size.
        doc.Star0.Shape = doc.Star0.Shape.mirror(V(), V(1, 0, 0))
        yield from measured("other", judged(doc, hull, envelope.STALE), limit)
        yield lambda: "read" not in hull.Message
        assert (hull.Status, check.Status) == (envelope.STALE, clearance.STALE)
        # The panel is closed while parts are read. A part that cannot be read gives one message.
        apart._known.clear()
        yield from marked(check)
        doc.recompute()
        App.closeDocument(doc.Name)
        yield 0.5
        doc = App.openDocument(os.path.join(folder, "large.FCStd"))
        yield 0.3
        read, calls = apart._read_shape, []

        def broken(shape):
            calls.append(shape)
            raise RuntimeError("no points")

        apart._read_shape = broken
        yield from marked(doc.Envelope)
        doc.recompute()
        yield lambda: "no points" in doc.Envelope.Message
        assert doc.Envelope.Status == envelope.FAILED and len(calls) < 5, len(calls)
        apart._read_shape = read
        App.closeDocument(doc.Name)
        yield 0.3


run(scenario)
