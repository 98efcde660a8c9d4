# SPDX-License-Identifier: LGPL-2.1-or-later
"""The first tutorial, carried out with the files that it names, by the commands and panels that it names. For
the pictures and for the tests of the window."""
import os
import shutil
import tempfile

from driver import (
    App,
    Cancel,
    Gui,
    Ok,
    QtWidgets,
    answered,
    click,
    find,
    no_panel,
    panel_button,
    select,
)

HERE = os.path.dirname(os.path.realpath(__file__))
FILES = os.path.join(HERE, "..", "..", "resources", "tutorials")


def opened():
    """Opens the document of the tutorial from a copy. Returns the document, and its parts by label."""
    path = os.path.join(tempfile.mkdtemp(), "engine_bay.FCStd")
    shutil.copy(os.path.join(FILES, "engine_bay.FCStd"), path)
    doc = App.openDocument(path)
    doc.UndoMode = 1
    return doc, {obj.Label: obj for obj in doc.Objects if obj.Visibility}


def path_from_file():
    """Makes a motion from the file that comes with the workbench; a generator."""
    from sweptvolume.panels import file_panel

    with answered(file_panel, "ask_file", lambda: os.path.join(FILES, "starter.csv")):
        Gui.runCommand("SweptVolume_MotionFromFile")
    yield 0.4
    click(panel_button(Ok))
    yield no_panel


def estimated():
    """Returns whether the panel of a solid shows the figures of a trial."""
    text = find(QtWidgets.QLabel, "SweptVolumeSolidEstimate").text()
    return text and "Estimating" not in text


def work(look, folder):
    """Carries out the whole tutorial; a generator. look(name): a generator that takes a picture."""
    from sweptvolume.panels import file_dialogs, motion_panel

    doc, made = opened()
    yield 0.3
    view = Gui.activeDocument().activeView()
    view.viewIsometric()
    from sweptvolume import demo, page

    view.setCameraOrientation(demo.view_rotation().Q)
    Gui.SendMsgToActiveView("ViewFit")
    yield from look("bay_parts")
    starter = made["Starter"]
    yield from path_from_file()
    motion = [o for o in doc.Objects if "SourceType" in o.PropertiesList][0]
    select(starter, motion)
    Gui.runCommand("SweptVolume_EditMotion")
    yield 0.5
    find(QtWidgets.QTableWidget, "SweptVolumeKeys").setCurrentCell(4, 1)
    Gui.Selection.clearSelection()
    yield motion_panel.opened[-1].preview.settled
    Gui.SendMsgToActiveView("ViewFit")
    yield from look("bay_path")
    click(panel_button(Cancel))
    yield no_panel
    Gui.SendMsgToActiveView("ViewFit")
    select(starter, motion)
    Gui.runCommand("SweptVolume_Envelope")
    yield 0.6
    click(panel_button(Ok))
    yield no_panel
    envelope = doc.getObject("Envelope")
    Gui.Selection.clearSelection()
    yield from look("bay_envelope")
    select(envelope)
    Gui.runCommand("SweptVolume_Clearance")
    yield 0.5
    click(find(QtWidgets.QPushButton, "SweptVolumeCheck"))
    yield lambda: doc.getObject("Clearance") is not None
    yield 0.5
    Gui.Selection.clearSelection()
    yield from look("bay_clearance")
    page.write(doc.getObject("Clearance"), os.path.join(folder, "report.html"))
    click(panel_button(QtWidgets.QDialogButtonBox.Close))
    yield no_panel
    select(envelope)
    Gui.runCommand("SweptVolume_Solid")
    yield 0.6
    find(QtWidgets.QWidget, "SweptVolumeSolidTolerance").setProperty("rawValue", 0.5)
    yield 0.5
    yield estimated
    yield from look("bay_solid_panel")
    click(panel_button(Ok))
    yield no_panel
    Gui.Selection.clearSelection()
    yield from look("bay_solid")
    select(doc.getObject("EnvelopeSolid"))
    with answered(file_dialogs, "ask_export", lambda name: os.path.join(folder, name + ".step")):
        Gui.runCommand("SweptVolume_Export")
    yield 0.5
    click(panel_button(Ok))
    yield no_panel
