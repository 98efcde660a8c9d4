# SPDX-License-Identifier: LGPL-2.1-or-later
"""Each message appears in one place only: in the panel; in a message box, if there is no panel; or as a
line of the report view, which stays closed. File dialogs open in the folder of the document.
"""
import os
import sys
import tempfile

sys.path.insert(0, os.path.dirname(os.path.realpath(__file__)))
from driver import (  # noqa: E402
    App,
    Cancel,
    Close,
    Gui,
    Ok,
    QtCore,
    QtWidgets,
    answered,
    click,
    find,
    new_document,
    no_panel,
    open_workbench,
    panel_button,
    run,
    say,
    select,
    shot,
)

V = App.Vector


class Messages:
    """Records messages outside the panels: message boxes, which are closed at once, and lines of the
    report view."""

    def __init__(self):
        self.boxes, self.files, self._lines = [], [], 0
        docks = Gui.getMainWindow().findChildren(QtWidgets.QDockWidget)
        self.dock = next(d for d in docks if d.objectName() == "Report view")
        self.report = next(
            e
            for e in self.dock.findChildren(QtWidgets.QTextEdit)
            if e.metaObject().className() == "Gui::DockWnd::ReportOutput"
        )
        self._timer = QtCore.QTimer()
        self._timer.timeout.connect(self._collect)
        self._timer.start(50)
        self.new()

    def _collect(self):
        for widget in QtWidgets.QApplication.topLevelWidgets():
            if isinstance(widget, QtWidgets.QMessageBox) and widget.isVisible():
                self.boxes.append(widget.text())
                widget.accept()
            elif isinstance(widget, QtWidgets.QFileDialog) and widget.isVisible():
                chosen = widget.selectedFiles()
                self.files.append((widget.directory().absolutePath(), chosen[0] if chosen else ""))
                shot("84_file_dialog")
                widget.reject()

    def new(self):
        """Returns (message boxes, plain lines, coloured lines, whether the report view is open) since
        the last call, and closes the report view."""
        document = self.report.document()
        plain, coloured = [], []
        for number in range(self._lines, document.blockCount()):
            block = document.findBlockByNumber(number)
            colours = [f.format.foreground().color().getHsv()[1] for f in block.layout().formats()]
            if block.text().strip():
                (coloured if any(c > 100 for c in colours) else plain).append(block.text())
        self._lines = document.blockCount() - 1
        boxes, self.boxes = self.boxes, []
        seen = self.dock.isVisible()
        self.dock.hide()
        return boxes, plain, coloured, seen


def check(messages, text, boxes=0, lines=0, panel=""):
    """Checks that a text appeared in just these message boxes and lines, or in the panel. Nothing may
    be coloured, and the report view must stay closed."""
    found, plain, coloured, seen = messages.new()
    say("{!r}: boxes {}, lines {}, coloured {}, open {}".format(text, found, plain, coloured, seen))
    assert [text in box for box in found] == [True] * boxes, (text, found)
    assert sum(text in line for line in plain) == lines, (text, plain)
    assert not coloured, coloured
    assert not seen, "the report view opened itself"
    assert (text in panel) == (boxes + lines == 0), (text, panel)


def scenario():
    from sweptvolume.features import clearance, envelope, motion
    from sweptvolume.panels import file_dialogs

    open_workbench()
    yield 0.5
    for name in ("checkShowReportViewOnError", "checkShowReportViewOnWarning"):
        App.ParamGet("User parameter:BaseApp/Preferences/OutputWindow").SetBool(name, True)
    messages = Messages()
    # A planted error message is noticed.
    App.Console.PrintError("planted\n")
    yield 0.5
    _, _, coloured, seen = messages.new()
    assert len(coloured) == 1 and coloured[0].endswith("planted") and seen, (coloured, seen)
    yield

    doc = new_document("Hints")
    box, wall = doc.addObject("Part::Box", "Slide"), doc.addObject("Part::Box", "Wall")
    wall.Placement.Base = V(0, 13, 0)
    places = [App.Placement(), App.Placement(V(30, 9, 4), App.Rotation(V(1, 2, 3), 30))]
    path = motion.motion_from_poses(doc, [0, 1], places)
    doc.recompute()
    hull = envelope.make_envelope(doc, [box], path, Resolution=40)
    envelope.compute(hull)
    yield 0.3
    messages.new()

    # A command that cannot do what was requested: one message box.
    with answered(file_dialogs, "ask_export", lambda name: "/nowhere/to/be/found/x.step"):
        select(hull)
        Gui.runCommand("SweptVolume_Export")
        yield 0.5
    check(messages, "/nowhere/to/be/found", boxes=1)

    # A run that the core refuses: a message in its panel.
    select(hull)
    Gui.runCommand("SweptVolume_Solid")
    yield
    find(QtWidgets.QSpinBox, "SweptVolumeMaxFaces").setValue(4)
    click(panel_button(Ok))
    message = [None]

    def refused():
        labels = Gui.getMainWindow().findChildren(QtWidgets.QLabel)
        texts = [w.text() for w in labels if w.isVisible() and "the limit is 4 faces" in w.text()]
        message[0] = "\n".join(texts)
        return bool(texts)

    yield refused
    yield 0.5
    check(messages, "the limit is 4 faces", panel=message[0])
    click(panel_button(Cancel))
    yield no_panel

    # A finding of a run: a plain line.
    hull.CellSize = 0
    hull.Tolerance = 0.5
    hull.Resolution = 24
    doc.recompute()
    select(hull)
    Gui.runCommand("SweptVolume_Recompute")
    yield no_panel
    yield 0.3
    check(messages, hull.Label + ": ", lines=1)

    # A deleted input: the object has the message, and FreeCAD prints none.
    doc.openTransaction("Delete")
    doc.removeObject(path.Name)
    doc.commitTransaction()
    doc.recompute()
    yield 0.3
    assert hull.Status == envelope.FAILED, hull.Status
    check(messages, hull.Message, panel=hull.Message)
    doc.undo()
    doc.recompute()

    # File dialogs open in the folder of the document; for an unsaved document in the folder of the last
    # file, otherwise in the home folder.
    select(hull)
    Gui.runCommand("SweptVolume_Clearance")
    yield 0.5
    click(find(QtWidgets.QPushButton, "SweptVolumeCheck"))
    yield lambda: doc.getObject("Clearance") is not None
    yield 0.5
    check_of = doc.getObject("Clearance")
    assert check_of.Status == clearance.UP_TO_DATE
    messages.new()

    os.chdir("/")
    App.ParamGet(file_dialogs.LAST).SetString("FileOpenSavePath", "")
    home = os.path.realpath(os.path.expanduser("~"))
    click(find(QtWidgets.QPushButton, "SweptVolumeCsv"))
    yield 0.3
    folder = os.path.realpath(tempfile.mkdtemp())
    doc.saveAs(os.path.join(folder, "hints.FCStd"))
    App.ParamGet(file_dialogs.LAST).SetString("FileOpenSavePath", tempfile.gettempdir())
    click(find(QtWidgets.QPushButton, "SweptVolumeCsv"))
    yield 0.3
    click(panel_button(Close))
    yield no_panel
    select(hull)
    Gui.runCommand("SweptVolume_Export")
    yield 0.5
    assert no_panel(), "a dialog that is left asks nothing more"
    say(str(messages.files))
    folders = [os.path.realpath(f) for f, _ in messages.files]
    assert folders == [home, folder, folder], (messages.files, home, folder)
    names = [os.path.basename(chosen) for _, chosen in messages.files]
    assert names[1] == check_of.Label + ".csv" and names[2] == hull.Label + ".step", names


run(scenario)
