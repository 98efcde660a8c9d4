# SPDX-License-Identifier: LGPL-2.1-or-later
"""Drives FreeCAD's window step by step on its own event loop; no test framework inside.

A scenario is a generator: `yield` gives the loop a moment, `yield seconds` a longer one, `yield test`
(a callable) waits until test() is true. Ends the process: 0 passed, 7 failed.
"""
import contextlib
import os
import subprocess
import time
import traceback

import FreeCAD as App
import FreeCADGui as Gui
from PySide import QtCore, QtGui

try:
    from PySide import QtWidgets
except ImportError:
    QtWidgets = QtGui

SHOTS = os.environ.get("SWEPT_SHOTS", "")
STEP, LIMIT = 150, 240.0  # ms between two checks; longest wait (s) on a busy machine
END = object()


def contrast_of(widget, where=None):
    """Returns (contrast, colour of the background) of the text in a widget, or in a QRect of it, as its
    pixels show. The contrast is from 1 to 21, as in WCAG 2.1."""
    image = widget.grab(where or widget.rect()).toImage()
    seen = {}
    for x in range(image.width()):
        for y in range(image.height()):
            seen[image.pixel(x, y)] = seen.get(image.pixel(x, y), 0) + 1

    def luminance(pixel):
        parts = [(pixel >> shift & 255) / 255.0 for shift in (16, 8, 0)]
        linear = [p / 12.92 if p <= 0.04045 else ((p + 0.055) / 1.055) ** 2.4 for p in parts]
        return 0.2126 * linear[0] + 0.7152 * linear[1] + 0.0722 * linear[2] + 0.05

    behind = max(seen, key=seen.get)
    own = luminance(behind)
    ratio = max(max(luminance(p), own) / min(luminance(p), own) for p in seen)
    return ratio, "#{:06x}".format(behind & 0xFFFFFF)


def read_verdicts(table):
    """Returns {verdict: background colour}. Each verdict must be legible (contrast of 4.5, WCAG 2.1)."""
    found = {}
    for row in range(table.rowCount()):
        cell = table.item(row, 1)
        box = table.visualItemRect(cell).adjusted(1, 1, -1, -1)  # without the lines of the table
        ratio, behind = contrast_of(table.viewport(), box)
        say("{} on {}: contrast {:.1f}".format(cell.text(), behind, ratio))
        assert ratio >= 4.5, (cell.text(), behind, ratio)
        found[cell.text()] = behind
    return found


def titles_of(table):
    """Returns the titles of the columns of a table."""
    return [table.horizontalHeaderItem(column).text() for column in range(table.columnCount())]


def check_table(table):
    """Checks that no heading of a table is cut off, and no text in its first column."""
    header = table.horizontalHeader()
    metrics = header.fontMetrics()
    for column in range(table.columnCount()):
        if table.isColumnHidden(column):
            continue
        text = table.horizontalHeaderItem(column).text()
        wide = max(metrics.boundingRect(line).width() for line in text.split("\n"))
        assert wide <= header.sectionSize(column), (text, wide, header.sectionSize(column))
    wraps = int(getattr(QtCore.Qt.TextWordWrap, "value", QtCore.Qt.TextWordWrap))
    for row in range(table.rowCount()):
        cell = table.item(row, 0)
        box = table.visualItemRect(cell)
        need = table.fontMetrics().boundingRect(0, 0, box.width() - 6, 1000, wraps, cell.text())
        fits = need.width() <= box.width() and need.height() <= box.height()
        assert fits, (cell.text(), need, box)


class Gaps:
    """Measures how long the window does not respond: the longest time between two ticks of a 5 ms
    timer. `busy` is the longest CPU time of the window's own thread between two ticks; during the rest
    it waited for a processor core. `lost` is the sum of all delays of the ticks."""

    def __init__(self):
        self.longest, self.busy, self.lost = 0.0, 0.0, 0.0
        self._last, self._cpu = time.perf_counter(), time.thread_time()
        self._timer = QtCore.QTimer()
        self._timer.timeout.connect(self._tick)
        self._timer.start(5)

    def _tick(self):
        now, cpu = time.perf_counter(), time.thread_time()
        self.longest = max(self.longest, now - self._last)
        self.lost += max(0.0, now - self._last - 0.02)
        self.busy = max(self.busy, cpu - self._cpu)
        self._last, self._cpu = now, cpu

    def stop(self):
        self._timer.stop()
        return "{:.0f} ms (of it at most {:.0f} ms of work)".format(
            1000 * self.longest, 1000 * self.busy
        )


#: Longest time (s) until Stop has taken effect, without waiting times of the event loop.
ANSWER = 0.3
#: Longest CPU time (s) of the window's own thread between two events until Stop has taken effect.
WORK = 0.2


def stopped(done):
    """A step of a scenario: presses Stop, waits until done() is true, and checks how long this took.
    Returns the seconds."""
    gaps, began = Gaps(), time.perf_counter()
    click(find(QtWidgets.QPushButton, "SweptVolumeStop"))
    yield done
    took = time.perf_counter() - began
    gaps.stop()
    assert took < ANSWER + gaps.lost and gaps.busy < WORK, (took, gaps.lost, gaps.busy)
    return took


def say(text):
    os.write(1, (text + "\n").encode())


def shot(name):
    """Takes a screenshot of the whole screen if SWEPT_SHOTS names a folder. Returns a function that
    returns whether it is taken; the window keeps responding meanwhile."""
    if not SHOTS:
        return lambda: True
    Gui.updateGui()
    taking = subprocess.Popen(["import", "-window", "root", os.path.join(SHOTS, name + ".png")])
    return lambda: taking.poll() is not None


Ok, Cancel = QtWidgets.QDialogButtonBox.Ok, QtWidgets.QDialogButtonBox.Cancel
Apply, Close = QtWidgets.QDialogButtonBox.Apply, QtWidgets.QDialogButtonBox.Close


def open_workbench():
    """Opens the workbench in a larger window."""
    Gui.activateWorkbench("SweptVolumeWorkbench")
    widen()


def new_document(name):
    """Returns an empty document with undo."""
    document = App.newDocument(name)
    document.UndoMode = 1
    return document


def to_3d_view():
    """Returns to the 3D view. FreeCAD 1.1 hides task panels while another view, such as a spreadsheet,
    is active."""
    view = Gui.activeDocument().mdiViewsOfType("Gui::View3DInventor")[0]
    Gui.getMainWindow().setActiveWindow(view)


def view_from(side):
    """Shows all objects from a side by FreeCAD's name for it: "Top", "Isometric". Returns the view."""
    view = Gui.activeDocument().activeView()
    getattr(view, "view" + side)()
    Gui.SendMsgToActiveView("ViewFit")
    return view


def select(*items):
    """Selects objects, or (object, sub path) tuples, and nothing else."""
    Gui.Selection.clearSelection()
    for item in items:
        if isinstance(item, tuple):
            Gui.Selection.addSelection(item[0].Document.Name, item[0].Name, item[1])
        else:
            Gui.Selection.addSelection(item)


@contextlib.contextmanager
def answered(module, name, answer):
    """Replaces a function that would open a dialog, inside a `with` block."""
    asks = getattr(module, name)
    setattr(module, name, answer)
    try:
        yield
    finally:
        setattr(module, name, asks)


def press(widget, key, modifiers=QtCore.Qt.NoModifier, text=""):
    """Presses a key as the window system would: shortcuts get it first."""
    for kind in (QtCore.QEvent.ShortcutOverride, QtCore.QEvent.KeyPress, QtCore.QEvent.KeyRelease):
        event = QtGui.QKeyEvent(kind, key, modifiers, text)
        QtWidgets.QApplication.sendEvent(widget, event)


def type_over(field, text):
    """Replaces the text of a field by typing. Returns its line edit."""
    edit = field if isinstance(field, QtWidgets.QLineEdit) else field.findChild(QtWidgets.QLineEdit)
    edit.setFocus()
    edit.selectAll()
    press(edit, QtCore.Qt.Key_Delete)
    for sign in text:
        press(edit, 0, text=sign)
    return edit


def choose(name, data):
    """Chooses an entry of a visible combo box by its data."""
    box = find(QtWidgets.QComboBox, name)
    index = box.findData(data)
    assert index >= 0, "{} has no entry {}".format(name, data)
    box.setCurrentIndex(index)


def viewport():
    """Returns the widget of the 3D view that receives mouse events."""
    found = [
        w
        for w in Gui.getMainWindow().findChildren(QtWidgets.QWidget)
        if w.metaObject().className() in ("QOpenGLWidget", "QGLWidget") and w.isVisible()
    ]
    assert found, "no 3D view"
    return max(found, key=lambda w: w.width() * w.height())  # FreeCAD 1.1 has a small one as well


def drag(start, end, steps=8):
    """Drags the left button in the 3D view between two points of the world; a generator."""
    view, widget = Gui.activeDocument().activeView(), viewport()
    # Coin counts pixels from the bottom of the screen, Qt from the top of the widget. (getViewer() is
    # not used: FreeCAD 1.1 then crashes when the view is closed.)
    ratio = view.getSize()[0] / widget.width()
    places = []
    for point in (start, end):
        x, y = view.getPointOnScreen(point)
        places.append(QtCore.QPointF(x / ratio, widget.height() - 1 - y / ratio))

    def send(kind, where, button, buttons):
        spot = QtCore.QPointF(widget.mapToGlobal(where.toPoint()))
        event = QtGui.QMouseEvent(kind, where, spot, button, buttons, QtCore.Qt.NoModifier)
        QtWidgets.QApplication.sendEvent(widget, event)

    left, none = QtCore.Qt.LeftButton, QtCore.Qt.NoButton
    send(QtCore.QEvent.MouseMove, places[0], none, none)
    yield 0.2
    send(QtCore.QEvent.MouseButtonPress, places[0], left, left)
    yield 0.2
    for i in range(1, steps + 1):
        where = places[0] + (places[1] - places[0]) * (i / steps)
        send(QtCore.QEvent.MouseMove, where, none, left)
        yield 0.1
    send(QtCore.QEvent.MouseButtonRelease, places[1], left, none)
    yield 0.2


def line_of(graph):
    """Returns the two ends of the line with two points that is drawn last in a 3D view, or None."""
    from pivy import coin

    search = coin.SoSearchAction()
    search.setType(coin.SoLineSet.getClassTypeId())
    search.setInterest(coin.SoSearchAction.ALL)
    search.apply(graph)
    paths = search.getPaths()
    found = []
    for k in range(paths.getLength()):
        node = paths[k]
        parent = node.getNodeFromTail(1)
        for i in range(parent.getNumChildren()):
            child = parent.getChild(i)
            if child.isOfType(coin.SoCoordinate3.getClassTypeId()) and child.point.getNum() == 2:
                found.append([tuple(p.getValue()) for p in child.point.getValues()])
    return found[-1] if found else None


def widen():
    """Makes the window larger: no console, no report view, a wider combo view. FreeCAD 0.20 may hide
    that view until a panel opens in it."""
    window = Gui.getMainWindow()
    for dock in window.findChildren(QtWidgets.QDockWidget):
        if dock.objectName() in ("Report view", "Python console"):
            dock.hide()
        elif dock.objectName() == "Combo View":
            dock.show()
            window.resizeDocks([dock], [400], QtCore.Qt.Horizontal)


def tree():
    """Returns the tree widget of the documents."""
    for found in Gui.getMainWindow().findChildren(QtWidgets.QTreeWidget):
        if found.metaObject().className() == "Gui::TreeWidget" and found.isVisible():
            return found
    raise AssertionError("no tree is seen")


def find(kind, name):
    """Returns the visible widget with this object name."""
    found = [w for w in Gui.getMainWindow().findChildren(kind, name) if w.isVisible()]
    assert found, "no visible {} {}".format(kind.__name__, name)
    return found[0]


def visible_text(form=None):
    """Returns the text of all labels of a form; without a form, those of the whole window."""
    labels = (form or Gui.getMainWindow()).findChildren(QtWidgets.QLabel)
    return "\n".join(label.text() for label in labels if label.isVisible())


def panel_button(standard):
    """Returns a standard button of the open task panel."""
    for box in Gui.getMainWindow().findChildren(QtWidgets.QDialogButtonBox):
        try:
            button = box.button(standard) if box.isVisible() else None
        except RuntimeError:  # of a dialog that was closed a moment ago
            continue
        if button is not None:
            return button
    raise AssertionError("the panel has no such button")


def click(button):
    """Clicks a widget: presses and releases the mouse button at its middle. A check box is clicked on
    its box, because the middle of a wide one is behind its text and does not react."""
    assert button.isEnabled(), "the button is disabled"
    place = button.rect().center()
    if isinstance(button, QtWidgets.QCheckBox):
        place.setX(button.rect().left() + 8)
    middle = QtCore.QPointF(place)
    left, none = QtCore.Qt.LeftButton, QtCore.Qt.NoButton
    keys = QtCore.Qt.NoModifier
    where = QtCore.QPointF(button.mapToGlobal(place))
    for kind, buttons in (
        (QtCore.QEvent.MouseButtonPress, left),
        (QtCore.QEvent.MouseButtonRelease, none),
    ):
        event = QtGui.QMouseEvent(kind, middle, where, left, buttons, keys)
        QtWidgets.QApplication.sendEvent(button, event)


def check_wrappers():
    """Checks that no Python wrapper of a deleted widget is left. PySide could return such a wrapper
    for a new widget at the same address."""
    from sweptvolume.panels.widgets import shiboken

    known = [w for w in shiboken.getAllValidWrappers() if isinstance(w, QtWidgets.QWidget)]
    dead = [type(widget).__name__ for widget in known if not shiboken.isValid(widget)]
    assert known and not dead, "wrappers of deleted widgets: " + ", ".join(dead)


def no_panel():
    return not Gui.Control.activeDialog()


def line_in(steps):
    """Returns the number of the line at which a generator waits, or at which a generator inside it
    waits."""
    while steps.gi_yieldfrom is not None:
        steps = steps.gi_yieldfrom
    return steps.gi_frame.f_lineno if steps.gi_frame else 0


def run(scenario):
    """Runs a scenario on FreeCAD's event loop and then ends FreeCAD. Prints which file's scenario has
    passed."""
    steps = scenario()
    name = os.path.basename(scenario.__code__.co_filename)
    state = {"wait": None, "since": time.time(), "value": None}

    def fail():
        traceback.print_exc()
        if SHOTS:
            subprocess.call(["import", "-window", "root", os.path.join(SHOTS, "failed.png")])
        os._exit(7)

    def tick():
        try:
            if state["wait"] is not None:
                if not state["wait"]():
                    if time.time() - state["since"] > LIMIT:
                        raise AssertionError("line {}: waited {} s".format(line_in(steps), LIMIT))
                    return QtCore.QTimer.singleShot(20, tick)
                state["wait"] = None
            wanted = next(steps, END)
            if wanted is END:
                check_wrappers()
                say("{} passed".format(name))
                os._exit(0)
            pause = STEP
            if callable(wanted):
                state.update(wait=wanted, since=time.time())
                pause = 20
            elif wanted:
                pause = int(wanted * 1000)
            QtCore.QTimer.singleShot(pause, tick)
        except BaseException:
            fail()

    QtCore.QTimer.singleShot(300, tick)


__all__ = [
    "App",
    "Apply",
    "Cancel",
    "Close",
    "Gaps",
    "Gui",
    "Ok",
    "QtCore",
    "QtGui",
    "QtWidgets",
    "answered",
    "choose",
    "click",
    "drag",
    "find",
    "line_of",
    "new_document",
    "no_panel",
    "open_workbench",
    "panel_button",
    "press",
    "run",
    "say",
    "select",
    "shot",
    "view_from",
    "widen",
]
