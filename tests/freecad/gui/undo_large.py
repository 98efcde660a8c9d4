# SPDX-License-Identifier: LGPL-2.1-or-later
"""Undo of a change whose envelope is too large to be kept for Undo: the inputs are restored, the result
becomes stale, and the window does not freeze. The limit is set so low that a small envelope exceeds it.
"""
import os
import sys
import time

sys.path.insert(0, os.path.dirname(os.path.realpath(__file__)))
from driver import (  # noqa: E402
    App,
    Ok,
    click,
    new_document,
    no_panel,
    open_workbench,
    panel_button,
    run,
)


def scenario():
    from sweptvolume.features import envelope, motion
    from sweptvolume.panels import envelope_panel
    from sweptvolume.views import surface

    surface.MOST_UNDONE = 1000
    open_workbench()
    yield
    doc = new_document("Undo")
    box = doc.addObject("Part::Box", "Slide")
    places = [App.Placement(), App.Placement(App.Vector(30, 0, 0), App.Rotation())]
    path = motion.motion_from_poses(doc, [0, 1], places)
    doc.recompute()
    hull, facets = None, []
    for cells in (40, 60):
        panel = envelope_panel.show(doc, [(box, "")], path, hull)
        panel.resolution.setValue(cells)
        yield 0.3
        click(panel_button(Ok))
        yield no_panel
        hull = doc.getObject("Envelope")
        assert hull.Status == envelope.UP_TO_DATE, hull.Status
        facets.append(hull.Mesh.CountFacets)
    assert min(facets) > surface.MOST_UNDONE and facets[0] != facets[1], facets
    for name, status, cells in (
        ("undo", envelope.STALE, 40),
        ("redo", envelope.UP_TO_DATE, 60),
        ("undo", envelope.STALE, 40),
    ):
        began = time.thread_time()
        getattr(doc, name)()
        yield 0.3
        assert time.thread_time() - began < 1.0
        assert (hull.Status, hull.Resolution) == (status, cells), (name, hull.Status)
        assert hull.Mesh.CountFacets == facets[1]
    doc.undo()
    assert doc.getObject("Envelope") is None
    doc.redo()
    assert doc.getObject("Envelope").Mesh.CountFacets == facets[1]
    App.closeDocument(doc.Name)
    yield


run(scenario)
