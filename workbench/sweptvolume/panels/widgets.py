# SPDX-License-Identifier: LGPL-2.1-or-later
"""Small pieces that every panel uses, built from FreeCAD's own widgets."""
import importlib
import time

import FreeCAD as App
import FreeCADGui as Gui
from PySide import QtCore, QtGui

try:
    from PySide import QtWidgets
except ImportError:  # FreeCAD 0.20: its shim keeps the widgets in QtGui
    QtWidgets = QtGui

from .. import icon
from ..texts import mark, translate

#: The half of PySide that keeps its wrappers: shiboken2 or shiboken6.
shiboken = importlib.import_module("shiboken" + QtCore.qVersion()[0].replace("5", "2"))

#: Qt 6 has it among what belongs to no widget.
Action = getattr(QtGui, "QAction", None) or QtWidgets.QAction
#: s in which the bar goes half of what is left up to MOST_CREPT while a run tells nothing new.
CREEP, MOST_CREPT = 30.0, 0.98
#: Left, top, right, bottom inside a titled box: the title stands on the upper border.
MARGINS = (6, 10, 6, 6)


def window(title, icon_name):
    """The form of a task panel."""
    form = QtWidgets.QWidget()
    form.setWindowTitle(title)
    form.setWindowIcon(Gui.getIcon(icon(icon_name)))
    layout = QtWidgets.QVBoxLayout(form)
    layout.setContentsMargins(4, 4, 4, 4)
    return form, layout


def group(title, parent_layout):
    """A titled box with label-field rows."""
    box = QtWidgets.QGroupBox(title)
    rows = QtWidgets.QFormLayout(box)
    rows.setFieldGrowthPolicy(QtWidgets.QFormLayout.AllNonFixedFieldsGrow)
    rows.setContentsMargins(*MARGINS)
    parent_layout.addWidget(box)
    return rows


def length(value, minimum=0.0, step=None):
    """FreeCAD's own field for lengths: units, expressions."""
    return _quantity("mm", value, minimum, step)


def angle(value, minimum=0.0, step=None):
    """FreeCAD's own field for angles (degrees)."""
    return _quantity("deg", value, minimum, step)


def _quantity(unit, value, minimum, step):
    field = _quantity_field()
    field.setProperty("unit", unit)
    field.setProperty("minimum", float(minimum))
    if step is not None:
        field.setProperty("singleStep", float(step))
    field.setProperty("rawValue", float(value))
    return field


def forget_with(widget):
    """PySide finds wrappers by address and forgets those of deleted widgets, but not those that FreeCAD
    makes: while anybody holds one, whatever comes to stand at that address gets it, of whatever kind.
    """
    widget.destroyed.connect(lambda: shiboken.invalidate(widget))
    return widget


def _quantity_field():
    """A field that Python can use: not one with the dead wrapper of another that stood at its address,
    which another workbench may still hold (forget_with)."""
    for attempt in range(10):
        field = Gui.UiLoader().createWidget("Gui::QuantitySpinBox")
        try:
            field.objectName()
            return forget_with(field)
        except RuntimeError:  # it stays, unused, so that the next one gets another address
            if attempt == 9:
                raise


#: Values of properties, and stages of a run as the core names them, that panels show.
_NAMES = [
    mark("Panels", "None"),
    mark("Panels", "Linear"),
    mark("Panels", "Screw"),
    mark("Panels", "Spline"),
    mark("Panels", "Absolute"),
    mark("Panels", "Relative"),
    mark("Panels", "RelativeToFirst"),
    mark("Panels", "Consistent"),
    mark("Panels", "DualContouring"),
    mark("Panels", "DualMarchingCubes"),
    mark("Panels", "Equivalence"),
    mark("Panels", "Greedy"),
    mark("Panels", "Auto"),
    mark("Panels", "Off"),
    mark("Panels", "Session"),
    mark("Panels", "Document"),
    mark("Panels", "input"),
    mark("Panels", "motion"),
    mark("Panels", "sampling"),
    mark("Panels", "signs"),
    mark("Panels", "contour"),
    mark("Panels", "simplify"),
    mark("Panels", "check"),
    mark("Panels", "export"),
    mark("Panels", "straight moves"),
    mark("Panels", "moves without turns"),
    mark("Panels", "moves with turns"),
    mark("Panels", "polish"),
    mark("Panels", "done"),
]


def choice(names, now, texts=None):
    """Combo box; the data of an entry is its untranslated name."""
    box = QtWidgets.QComboBox()
    # The task view is narrow: long entries may be cut in the closed box, not in the open list.
    box.setSizeAdjustPolicy(QtWidgets.QComboBox.AdjustToMinimumContentsLengthWithIcon)
    box.setMinimumContentsLength(8)
    for i, name in enumerate(names):
        box.addItem(texts[i] if texts else translate("Panels", name), name)
    if now in names:
        box.setCurrentIndex(list(names).index(now))
    return box


def hint(field, text):
    field.setToolTip(text)
    return field


def number_of(flag):
    """The number behind a constant of Qt: PySide2's is one, PySide6's has one."""
    return int(getattr(flag, "value", flag))


def standard_buttons(*buttons):
    """PySide2 wants an int, PySide6 the flags themselves."""
    value = buttons[0]
    for button in buttons[1:]:
        value = value | button
    try:
        return int(value)
    except TypeError:
        return value


def actions_of(name):
    """What stands in menu and toolbar for a command of FreeCAD."""
    return Gui.getMainWindow().findChildren(Action, name)


def alive(thing):
    """Whether a document or object still exists behind its Python face."""
    try:
        return bool(thing.Name)
    except (ReferenceError, RuntimeError):
        return False


def to_first_field(form):
    """The keyboard goes to the first field of a form that takes it."""
    try:
        field = form.nextInFocusChain()
        while form.isAncestorOf(field):
            wanted = number_of(field.focusPolicy()) & number_of(QtCore.Qt.TabFocus)
            if wanted and field.isVisible() and field.isEnabled():
                field.setFocus(QtCore.Qt.TabFocusReason)
                return
            field = field.nextInFocusChain()
    except RuntimeError:
        pass  # the panel was closed at once


class DocumentWatch:
    """Calls gone() soon after a document was closed, unless stop() came first."""

    def __init__(self, document, gone):
        self.name, self.gone = document.Name, gone
        App.addDocumentObserver(self)

    def slotDeletedDocument(self, document):  # noqa: N802
        if document.Name == self.name:
            QtCore.QTimer.singleShot(0, self._tell)

    def _tell(self):
        if self.name:
            self.stop()
            self.gone()

    def stop(self):
        if self.name:
            self.name = ""
            App.removeDocumentObserver(self)


def show_message(label, text):
    """Text for people below a panel; hidden when empty."""
    label.setText(text)
    label.setVisible(bool(text))


def show_failure(label, run):
    """What is told of a run that ended without a result."""
    cancelled = translate("Messages", "Cancelled. Nothing was changed.")
    show_message(label, cancelled if run.state == "cancelled" else run.message)


def message_label():
    label = QtWidgets.QLabel()
    label.setWordWrap(True)
    label.setTextInteractionFlags(QtCore.Qt.TextSelectableByMouse)
    label.hide()
    return label


class RunBox(QtWidgets.QGroupBox):
    """Progress of a run with the button that stops it; hidden while nothing runs."""

    def __init__(self):
        super().__init__(translate("Panels", "Progress"))
        layout = QtWidgets.QVBoxLayout(self)
        row = QtWidgets.QHBoxLayout()
        self.bar = QtWidgets.QProgressBar()
        self.bar.setRange(0, 10000)
        self.stop = QtWidgets.QPushButton(translate("Panels", "Stop"))
        self.stop.setObjectName("SweptVolumeStop")
        self.stage = QtWidgets.QLabel()
        row.addWidget(self.bar, 1)
        row.addWidget(self.stop)
        layout.addLayout(row)
        layout.addWidget(self.stage)
        self.hide()

    def follow(self, run):
        self.bar.setValue(0)
        self.stage.setText("")
        self._shown, self._began = 0.0, time.monotonic()
        self._looked = self._began
        run.progress.connect(self._progress)
        self.stop.clicked.connect(run.cancel)
        self.show()
        self.stop.setFocus()  # fields that are switched off now would lose the keyboard to the 3D view

    def leave(self, field):
        """Nothing runs any more: the keyboard, if it was here, goes to a field or to the first of a form."""
        here = self.stop.hasFocus()
        self.hide()
        if here and number_of(field.focusPolicy()) & number_of(QtCore.Qt.TabFocus):
            field.setFocus()
        elif here:
            to_first_field(field)

    def _progress(self, part, phase):
        now = time.monotonic()
        # A stage that tells nothing has to be seen to be at work all the same; the farther the bar is
        # ahead of what is known, the slower it goes.
        half = CREEP * (1.0 + 10.0 * max(0.0, self._shown - part))
        crept = max(0.0, MOST_CREPT - self._shown) * (1.0 - 0.5 ** ((now - self._looked) / half))
        self._shown, self._looked = max(part, self._shown + crept), now
        self.bar.setValue(int(self._shown * self.bar.maximum()))
        text = translate("Panels", "{0}, {1} s")
        self.stage.setText(text.format(translate("Panels", phase), int(now - self._began)))


def warn(title, text):
    """A modal message, where no panel is open to show it."""
    QtWidgets.QMessageBox.warning(Gui.getMainWindow(), title, text)
