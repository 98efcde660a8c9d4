# SPDX-License-Identifier: LGPL-2.1-or-later
"""The tutorial "Is the whole assembly clear?", carried out by the commands and panels that it names. For the
pictures and for the tests of the window."""
import os
import shutil

from driver import (
    App,
    Close,
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
#: Keys of the exhaust pipe (s, mm), as on the page: it hangs below its final position, waits, and is mounted.
KEYS = (0.0, (0, 0, -140)), (8.0, (0, 0, -140)), (11.0, (0, 0, 0))


def row_of(table, *names):
    """Returns the row of a neighbour, or of a pair in any order."""
    texts = [table.item(row, 0).text() for row in range(table.rowCount())]
    (row,) = [row for row, text in enumerate(texts) if all(name in text for name in names)]
    return row


def bring_up(widget):
    """Scrolls the panel until the whole widget is visible."""
    area = widget.parentWidget()
    while not isinstance(area, QtWidgets.QScrollArea):
        area = area.parentWidget()
    area.ensureWidgetVisible(widget)


def check_with_rules(doc, look):
    """Steps 1 and 2: a clearance check without and with rules."""
    select(doc.getObject("Starter"), doc.getObject("Motion"))
    Gui.runCommand("SweptVolume_Clearance")
    yield 0.6
    click(find(QtWidgets.QPushButton, "SweptVolumeCheck"))
    yield lambda: doc.getObject("Clearance") is not None
    yield 0.5
    rule_table = find(QtWidgets.QTableWidget, "SweptVolumeRules")
    yield from choose_contact(rule_table, doc.getObject("BellHousing").Label)
    click(find(QtWidgets.QPushButton, "SweptVolumeCheck"))
    yield lambda: list(doc.getObject("Clearance").RuleKinds) == ["Contact"]
    yield 0.5
    Gui.Selection.clearSelection()
    bring_up(find(QtWidgets.QTableWidget, "SweptVolumeRules"))
    yield from look("assembly_rules")
    click(panel_button(Close))
    yield no_panel


def choose_contact(table, *names):
    """Double-clicks the rule of a row and chooses the second entry, "Contact allowed"; a generator."""
    cell = table.item(row_of(table, *names), 2)
    table.scrollToItem(cell)
    table.setCurrentItem(cell)
    table.editItem(cell)
    yield 0.2
    choice = table.findChild(QtWidgets.QComboBox)
    choice.setCurrentIndex(1)
    choice.activated.emit(1)
    yield 0.2


def move_the_exhaust(doc):
    """Step 3: a motion of three keys for the exhaust pipe."""
    exhaust = doc.getObject("Exhaust")
    select(exhaust)
    Gui.runCommand("SweptVolume_NewMotion")
    yield 0.5
    for _, place in KEYS:
        exhaust.Placement = App.Placement(App.Vector(*place), App.Rotation())
        doc.recompute()
        click(find(QtWidgets.QPushButton, "SweptVolumeCapture"))
        yield 0.2
    table = find(QtWidgets.QTableWidget, "SweptVolumeKeys")
    for row, (time, _) in reversed(list(enumerate(KEYS))):
        table.item(row, 0).setText("{:g}".format(time))
        yield
    click(panel_button(Ok))
    yield no_panel
    exhaust.Placement = App.Placement()
    doc.recompute()


def check_mechanism(doc, look):
    """Step 4: the check of the mechanism."""
    Gui.Selection.clearSelection()
    Gui.runCommand("SweptVolume_Mechanism")
    yield 0.6
    find(QtWidgets.QCheckBox, "SweptVolumeStanding").setChecked(True)
    yield 0.3
    rule_table = find(QtWidgets.QTableWidget, "SweptVolumePairRules")
    starter, housing = (doc.getObject(name).Label for name in ("Starter", "BellHousing"))
    yield from choose_contact(rule_table, starter, housing)
    click(find(QtWidgets.QPushButton, "SweptVolumeCheckMechanism"))
    yield lambda: doc.getObject("Mechanism") is not None
    yield 0.5
    table = find(QtWidgets.QTableWidget, "SweptVolumeClearanceTable")
    table.selectRow(row_of(table, starter, doc.getObject("Exhaust").Label))
    yield 1.5
    doc.getObject("FrameRail").ViewObject.Visibility = False  # it would hide the clash
    table.itemDoubleClicked.emit(table.currentItem())
    yield 1.0
    yield from look("assembly_mechanism")
    click(panel_button(Close))
    yield no_panel
    doc.getObject("FrameRail").ViewObject.Visibility = True
    Gui.SendMsgToActiveView("ViewFit")


def export(doc, folder):
    """Step 5: the report of the mechanism."""
    from sweptvolume.panels import file_dialogs

    select(doc.getObject("Mechanism"))
    path = os.path.join(folder, "assembly.html")
    with answered(file_dialogs, "ask_report", lambda label: path):
        Gui.runCommand("SweptVolume_ExportReport")
    yield no_panel


def run_study(doc, look, folder):
    """Steps 6 and 7: an envelope and two checks as a study; the worst one."""
    select(doc.getObject("Exhaust"), doc.getObject("Motion001"))
    Gui.runCommand("SweptVolume_Clearance")
    yield 0.6
    click(find(QtWidgets.QPushButton, "SweptVolumeCheck"))
    yield lambda: doc.getObject("Clearance001") is not None
    yield 0.4
    click(panel_button(Close))
    yield no_panel
    select(doc.getObject("Starter"), doc.getObject("Motion"))
    Gui.runCommand("SweptVolume_Envelope")
    yield 0.6
    click(panel_button(Ok))
    yield no_panel
    doc.saveAs(os.path.join(folder, "bay.FCStd"))
    Gui.Selection.clearSelection()
    Gui.runCommand("SweptVolume_Study")
    yield 0.5
    click(find(QtWidgets.QPushButton, "SweptVolumeRunStudy"))
    yield lambda: doc.getObject("Study") is not None
    yield 0.6
    yield from look("study")
    shutil.copy(os.path.join(doc.Study.Results, "study.html"), folder)
    click(find(QtWidgets.QPushButton, "SweptVolumeOpenRun"))
    yield lambda: bool(Gui.Control.activeDialog())
    yield 1.5
    yield from look("assembly_worst")
    click(panel_button(Close))
    yield no_panel


def work(look, folder):
    """Carries out the whole tutorial; a generator. look(name): a generator that takes a picture."""
    Gui.runCommand("SweptVolume_Demo")
    yield 1.0
    doc = App.ActiveDocument
    Gui.SendMsgToActiveView("ViewFit")
    yield from check_with_rules(doc, look)
    yield from move_the_exhaust(doc)
    yield from check_mechanism(doc, look)
    yield from export(doc, folder)
    yield from run_study(doc, look, folder)
