# SPDX-License-Identifier: LGPL-2.1-or-later
"""Picture of a checked mechanism: the slider-crank of the tests when its slider comes nearest to the wall."""
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
    to_3d_view,
)

HERE = os.path.dirname(os.path.realpath(__file__))
sys.path.insert(0, os.path.join(HERE, "..", "..", "tests", "freecad"))
import slider_crank  # noqa: E402


def crank(picture):
    """Checks the slider-crank; a generator. picture(name): a generator that takes a picture."""
    from sweptvolume.features import joint_motions
    from sweptvolume.trajectory import sources

    doc = new_document("Crank")
    sheet, *parts = slider_crank.make(doc)
    sheet.set("A1", "70")
    doc.recompute()
    colours = ((0.72, 0.77, 0.85), (0.85, 0.72, 0.55), (0.60, 0.78, 0.62), (0.75, 0.75, 0.75))
    for part, colour in zip(parts, colours):
        part.ViewObject.ShapeColor = colour
    values = {"start": 0.0, "end": 360.0, "count": 721, "duration": 2.0}
    drive = sources.Settings("Driven", objects=[sheet], property="angle", **values)
    for motion in joint_motions.of_source(doc, drive)[0]:
        motion.ViewObject.Visibility = False
    to_3d_view()
    Gui.activeDocument().activeView().viewTop()
    Gui.SendMsgToActiveView("ViewFit")
    Gui.Selection.clearSelection()
    Gui.runCommand("SweptVolume_Mechanism")
    yield 0.6
    find(QtWidgets.QCheckBox, "SweptVolumeStanding").setChecked(True)
    find(QtWidgets.QWidget, "SweptVolumeMechanismRequiredDistance").setProperty("rawValue", 6.0)
    click(find(QtWidgets.QPushButton, "SweptVolumeCheckMechanism"))
    yield lambda: doc.getObject("Mechanism") is not None
    yield 0.5
    table = find(QtWidgets.QTableWidget, "SweptVolumeClearanceTable")
    names = [table.item(row, 0).text() for row in range(table.rowCount())]
    table.selectRow(names.index("Slider - Wall"))
    yield 1.5
    Gui.activeDocument().activeView().viewAxonometric()
    Gui.SendMsgToActiveView("ViewFit")
    yield 0.5
    yield from picture("mechanism")
    click(panel_button(Close))
    yield no_panel
    App.closeDocument(doc.Name)
