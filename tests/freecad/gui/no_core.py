# SPDX-License-Identifier: LGPL-2.1-or-later
"""FreeCAD without a compiled core: the workbench loads and motions can be edited. What needs the core shows
a message that says how to build it.
"""
import os
import sys

sys.path.insert(0, os.path.dirname(os.path.realpath(__file__)))
from driver import (  # noqa: E402
    App,
    Cancel,
    Gui,
    Ok,
    QtWidgets,
    click,
    find,
    new_document,
    no_panel,
    open_workbench,
    panel_button,
    run,
    select,
    shot,
)


def scenario():
    from sweptvolume import core, core_search, runner
    from sweptvolume.features import envelope, motion
    from sweptvolume.panels import envelope_panel, widgets

    found = core_search.folders
    core_search.folders = lambda: ["/nowhere"]
    assert not core.available()
    open_workbench()
    yield
    doc = new_document("NoCore")
    box = doc.addObject("Part::Box", "Box")
    doc.recompute()
    Gui.activeDocument().activeView().viewIsometric()
    Gui.SendMsgToActiveView("ViewFit")

    # A motion is made in the motion editor; the preview says what is missing.
    select(box)
    Gui.runCommand("SweptVolume_NewMotion")
    yield 0.3
    click(find(QtWidgets.QPushButton, "SweptVolumeCapture"))
    box.Placement.Base.x = 30
    click(find(QtWidgets.QPushButton, "SweptVolumeCapture"))
    yield 0.3
    shot("40_no_core_editor")
    yield 0.6
    click(panel_button(Ok))
    yield no_panel
    path = [o for o in doc.Objects if motion.is_motion(o)][0]
    assert path.Count == 2

    # The panel of an envelope opens, explains what is missing, and creates nothing.
    select(box, path)
    Gui.runCommand("SweptVolume_Envelope")
    yield 0.6
    text = envelope_panel.opened[-1].estimate_label.text()
    assert "cmake" in text and ".ci/packages.txt" in text, text
    click(panel_button(Ok))
    yield 0.3
    shot("41_no_core_envelope")
    yield 0.6
    assert not runner.running() and doc.getObject("Envelope") is None
    click(panel_button(Cancel))
    yield no_panel
    messages = []
    widgets.warn = lambda title, text: messages.append(text)
    hull = envelope.make_envelope(doc, [box], path)
    select(hull)
    Gui.runCommand("SweptVolume_Solid")
    assert messages, "nothing was said"

    core_search.folders = found
    App.closeDocument(doc.Name)
    yield


run(scenario)
