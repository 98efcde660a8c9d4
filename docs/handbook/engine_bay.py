# SPDX-License-Identifier: LGPL-2.1-or-later
"""The first tutorial, carried out: parts and keys are read from the tables of tutorial.md, everything else
is done by the commands and panels that it names. For the pictures and for the tests of the window."""
import os

from driver import (
    App,
    Gui,
    Ok,
    QtWidgets,
    answered,
    choose,
    click,
    find,
    new_document,
    no_panel,
    panel_button,
    select,
)

HERE = os.path.dirname(os.path.realpath(__file__))
#: Turns a cylinder's axis from z to x, as the tutorial says.
ALONG_X = App.Rotation(App.Vector(0, 1, 0), 90)


def tables():
    """The tables of the tutorial: lists of rows, which are lists of words; heads are left out."""
    found, before = [], ""
    with open(os.path.join(HERE, "tutorial.md"), encoding="utf-8") as file:
        for line in file:
            if line.startswith("|"):
                if not before.startswith("|"):
                    found.append([])
                found[-1].append([word.strip() for word in line.strip().strip("|").split("|")])
            before = line
    return [rows[2:] for rows in found]


def numbers(text, between):
    return [float(word) for word in text.split(between)]


def primitive(doc, form, size, place):
    """A cylinder along x (radius x length) or a box, as Part > Create primitives makes it."""
    sizes = numbers(size, "x")
    if form == "cylinder":
        obj = doc.addObject("Part::Cylinder", "Cylinder")
        obj.Radius, obj.Height = sizes
    else:
        obj = doc.addObject("Part::Box", "Box")
        obj.Length, obj.Width, obj.Height = sizes
    turn = ALONG_X if form == "cylinder" else App.Rotation()
    obj.Placement = App.Placement(App.Vector(*numbers(place, ",")), turn)
    return obj


def parts(doc):
    """The parts of the first table, by name: unions, and cuts where a row is taken away."""
    rows, name = {}, ""
    for part, form, size, place in tables()[0]:
        name = part or name
        away = form.startswith("minus ")
        obj = primitive(doc, form.replace("minus ", ""), size, place)
        rows.setdefault(name, ([], []))[away].append(obj)
    made = {}
    for name, (kept, away) in rows.items():
        obj = kept[0]
        if len(kept) > 1:
            obj = doc.addObject("Part::MultiFuse", "Union")
            obj.Shapes, obj.Refine = kept, True
        if away:
            cut = doc.addObject("Part::Cut", name)
            cut.Base, cut.Tool = obj, away[0]
            obj.Visibility = False
            obj = cut
        obj.Label = name
        for inner in kept * (len(kept) > 1) + away:
            inner.Visibility = False
        made[name] = obj
    doc.recompute()
    return made


def design_path(starter):
    """A new motion, its keys typed; a generator."""
    keys = [numbers("|".join(row), "|") for row in tables()[1]]
    select(starter)
    Gui.runCommand("SweptVolume_NewMotion")
    yield 0.5
    choose("SweptVolumePivot", "Origin")  # the table of the page has the starter's placements
    click(find(QtWidgets.QPushButton, "SweptVolumeCapture"))
    for _ in keys[1:]:
        click(find(QtWidgets.QPushButton, "SweptVolumeDuplicate"))
    yield 0.3
    table = find(QtWidgets.QTableWidget, "SweptVolumeKeys")
    assert table.rowCount() == len(keys)
    for row in reversed(range(len(keys))):  # from the last: times stay in order
        for column, number in enumerate(keys[row]):
            table.item(row, column).setText("{:g}".format(number))
        yield
    table.setCurrentCell(4, 1)


def work(look, folder):
    """The whole tutorial; a generator. look(name): a generator that takes a picture."""
    from sweptvolume.panels import file_dialogs, motion_panel

    doc = new_document("EngineBay")
    made = parts(doc)
    view = Gui.activeDocument().activeView()
    view.viewIsometric()
    from sweptvolume import demo, page

    view.setCameraOrientation(demo.view_rotation().Q)
    Gui.SendMsgToActiveView("ViewFit")
    yield from look("bay_parts")
    starter = made["Starter"]
    yield from design_path(starter)
    Gui.Selection.clearSelection()
    yield motion_panel.opened[-1].preview.settled
    Gui.SendMsgToActiveView("ViewFit")
    yield from look("bay_path")
    click(panel_button(Ok))
    yield no_panel
    Gui.SendMsgToActiveView("ViewFit")
    motion = [o for o in doc.Objects if "SourceType" in o.PropertiesList][0]
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
