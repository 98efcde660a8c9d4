# SPDX-License-Identifier: LGPL-2.1-or-later
"""Picture of two envelopes that cross, with the volume that they share."""
import FreeCAD as App
from driver import (
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


def envelopes(picture):
    """picture(name): a generator that makes one."""
    from sweptvolume.features import envelope, motion

    doc, found = new_document("Spaces"), []
    for name, start, end in (
        ("Gripper", (0, 0, 0), (120, 0, 0)),
        ("Door", (55, -60, 8), (55, 70, 8)),
    ):
        part = doc.addObject("Part::Cylinder" if name == "Gripper" else "Part::Box", name + "Part")
        ends = [App.Placement(App.Vector(*place), App.Rotation()) for place in (start, end)]
        if name == "Gripper":
            part.Radius, part.Height = 10, 20
        else:
            part.Length, part.Width, part.Height = 16, 20, 24
        part.Placement = ends[0]
        path = motion.motion_from_poses(doc, [0, 1], ends)
        path.ViewObject.Visibility = False
        doc.recompute()
        swept = envelope.make_envelope(doc, [part], path, Resolution=96)
        swept.Label = name
        doc.recompute()
        envelope.compute(swept)
        found.append(swept)
    view = Gui.activeDocument().activeView()
    view.viewIsometric()
    Gui.SendMsgToActiveView("ViewFit")
    select(*found)
    Gui.runCommand("SweptVolume_Overlap")
    yield 0.5
    click(find(QtWidgets.QPushButton, "SweptVolumeCheckSpaces"))
    tables = Gui.getMainWindow().findChildren
    yield lambda: any(
        t.isVisible() for t in tables(QtWidgets.QTableWidget, "SweptVolumeSpacesTable")
    )
    yield 0.5
    find(QtWidgets.QTableWidget, "SweptVolumeSpacesTable").selectRow(0)
    yield 0.5
    yield from picture("reserved_spaces")
    click(panel_button(Close))
    yield no_panel
