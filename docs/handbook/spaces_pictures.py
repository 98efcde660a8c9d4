# SPDX-License-Identifier: LGPL-2.1-or-later
"""Picture of two envelopes that cross, with the volume that they share."""
import os
import sys

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
    view_from,
)

HERE = os.path.dirname(os.path.realpath(__file__))
sys.path.insert(0, os.path.join(HERE, "..", "..", "tests", "freecad"))
from spaces import at, hidden_motion, swept_space  # noqa: E402


def envelopes(picture):
    """Checks two envelopes that cross; a generator. picture(name): a generator that takes a picture."""
    doc, found = new_document("Spaces"), []
    for name, start, end in (
        ("Gripper", (0, 0, 0), (120, 0, 0)),
        ("Door", (55, -60, 8), (55, 70, 8)),
    ):
        part = doc.addObject("Part::Cylinder" if name == "Gripper" else "Part::Box", name + "Part")
        if name == "Gripper":
            part.Radius, part.Height = 10, 20
        else:
            part.Length, part.Width, part.Height = 16, 20, 24
        part.Placement = at(*start)
        swept = swept_space(doc, part, hidden_motion(doc, at(*start), at(*end)), 96)
        swept.Label = name
        found.append(swept)
    view_from("Isometric")
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
    App.closeDocument(doc.Name)
