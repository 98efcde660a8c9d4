# SPDX-License-Identifier: LGPL-2.1-or-later
"""The picture of a sequence: a case with a block and a shaft in it, and a lid. It shows the moment when the
lid comes.
"""
from driver import (
    App,
    Close,
    Gui,
    QtWidgets,
    click,
    find,
    new_document,
    no_panel,
    panel_button,
    select,
)

V = App.Vector


def parts(picture):
    """Finds and plays the sequence; a generator. picture(name): a generator that takes a picture."""
    import Part
    from sweptvolume.features import sequence
    from sweptvolume.panels import sequence_panel

    doc = new_document("Gearbox")
    case, lid, shaft, gear = (
        doc.addObject("Part::Feature", name) for name in ("Case", "Lid", "Shaft", "Gear")
    )
    outer, inner = Part.makeBox(80, 60, 40, V(-40, -30, 0)), Part.makeBox(
        72, 52, 36, V(-36, -26, 4)
    )
    case.Shape = outer.cut(inner)
    gear.Shape = Part.makeCylinder(22, 10, V(0, 0, 6)).cut(Part.makeCylinder(9, 10, V(0, 0, 6)))
    shaft.Shape = Part.makeCylinder(6, 30, V(0, 0, 6))
    lid.Shape = Part.makeBox(80, 60, 4, V(-40, -30, 42))
    case.ViewObject.Transparency = 60
    doc.recompute()
    select(lid, shaft, gear)
    Gui.runCommand("SweptVolume_Sequence")
    yield 0.6
    panel = sequence_panel.opened[-1]
    find(QtWidgets.QDoubleSpinBox, "SweptVolumeBudget").setValue(600)  # on a busy machine as well
    click(find(QtWidgets.QPushButton, "SweptVolumeFindOrder"))
    yield lambda: panel.run is None
    report = sequence.report_of(panel.obj)
    last = report["steps"][-1]
    panel.player.go_to(0.5 * (last["begin"] + last["end"]))
    yield lambda: panel.ghosts is not None
    Gui.Selection.clearSelection()
    lid.ViewObject.Visibility = False
    Gui.ActiveDocument.ActiveView.viewIsometric()
    Gui.SendMsgToActiveView("ViewFit")
    yield 1.0
    yield from picture("sequence")
    click(panel_button(Close))
    yield no_panel
    App.closeDocument(doc.Name)
