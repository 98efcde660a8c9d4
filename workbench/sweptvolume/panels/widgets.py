# SPDX-License-Identifier: LGPL-2.1-or-later
"""Small widgets and functions for all panels, built from FreeCAD's own widgets."""
import importlib
import time

import FreeCAD as App
import FreeCADGui as Gui
from PySide import QtCore, QtGui

try:
    from PySide import QtWidgets
except ImportError:  # in FreeCAD 0.20, the module PySide has the widgets in QtGui
    QtWidgets = QtGui

from .. import icon
from ..texts import QT_TRANSLATE_NOOP, translate

#: The module that manages the Python wrappers of PySide: shiboken2 or shiboken6.
shiboken = importlib.import_module("shiboken" + QtCore.qVersion()[0].replace("5", "2"))

#: In Qt 6, QAction is in QtGui.
Action = getattr(QtGui, "QAction", None) or QtWidgets.QAction
#: While a run reports nothing new, the progress bar moves by itself: in CREEP seconds by half of
#: its distance from MOST_CREPT.
CREEP, MOST_CREPT = 30.0, 0.98
#: Margins inside a box with a title: left, top, right, bottom. The title is on the upper border.
MARGINS = (6, 10, 6, 6)


def window(title, icon_name):
    """Returns the form of a task panel."""
    form = QtWidgets.QWidget()
    form.setWindowTitle(title)
    form.setWindowIcon(Gui.getIcon(icon(icon_name)))
    layout = QtWidgets.QVBoxLayout(form)
    layout.setContentsMargins(4, 4, 4, 4)
    return form, layout


def group(title, parent_layout):
    """Returns a box with a title and rows of label and field."""
    box = QtWidgets.QGroupBox(title)
    rows = QtWidgets.QFormLayout(box)
    rows.setFieldGrowthPolicy(QtWidgets.QFormLayout.AllNonFixedFieldsGrow)
    rows.setContentsMargins(*MARGINS)
    parent_layout.addWidget(box)
    return rows


def length(value, minimum=0.0, step=None):
    """Returns FreeCAD's field for lengths, with units and expressions."""
    return _quantity("mm", value, minimum, step)


def angle(value, minimum=0.0, step=None):
    """Returns FreeCAD's field for angles (degrees)."""
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
    """Makes PySide forget the wrapper of a widget. PySide finds wrappers by address. It forgets the
    wrapper of a deleted widget only if Python created the widget, not if FreeCAD did. While such a
    wrapper exists, a new widget of any type at that address would get it.
    """
    widget.destroyed.connect(lambda: shiboken.invalidate(widget))
    return widget


def _quantity_field():
    """Returns a field that Python can use. If another workbench still holds the wrapper of a deleted
    widget, and the new field has the same address, PySide returns that wrapper (forget_with()). Its
    calls raise RuntimeError, so another field is made."""
    for attempt in range(10):
        field = Gui.UiLoader().createWidget("Gui::QuantitySpinBox")
        try:
            field.objectName()
            return forget_with(field)
        except RuntimeError:  # this field stays alive, so the next one gets another address
            if attempt == 9:
                raise


#: Values of properties and names of the core's stages that panels show, marked for translation.
_NAMES = [
    QT_TRANSLATE_NOOP("SweptVolume", "None"),
    QT_TRANSLATE_NOOP("SweptVolume", "Linear"),
    QT_TRANSLATE_NOOP("SweptVolume", "Screw"),
    QT_TRANSLATE_NOOP("SweptVolume", "Spline"),
    QT_TRANSLATE_NOOP("SweptVolume", "Absolute"),
    QT_TRANSLATE_NOOP("SweptVolume", "Relative"),
    QT_TRANSLATE_NOOP("SweptVolume", "RelativeToFirst"),
    QT_TRANSLATE_NOOP("SweptVolume", "Consistent"),
    QT_TRANSLATE_NOOP("SweptVolume", "DualContouring"),
    QT_TRANSLATE_NOOP("SweptVolume", "DualMarchingCubes"),
    QT_TRANSLATE_NOOP("SweptVolume", "Equivalence"),
    QT_TRANSLATE_NOOP("SweptVolume", "Greedy"),
    QT_TRANSLATE_NOOP("SweptVolume", "Auto"),
    QT_TRANSLATE_NOOP("SweptVolume", "Off"),
    QT_TRANSLATE_NOOP("SweptVolume", "Session"),
    QT_TRANSLATE_NOOP("SweptVolume", "Document"),
    QT_TRANSLATE_NOOP("SweptVolume", "input"),
    QT_TRANSLATE_NOOP("SweptVolume", "motion"),
    QT_TRANSLATE_NOOP("SweptVolume", "sampling"),
    QT_TRANSLATE_NOOP("SweptVolume", "signs"),
    QT_TRANSLATE_NOOP("SweptVolume", "contour"),
    QT_TRANSLATE_NOOP("SweptVolume", "simplify"),
    QT_TRANSLATE_NOOP("SweptVolume", "check"),
    QT_TRANSLATE_NOOP("SweptVolume", "export"),
    QT_TRANSLATE_NOOP("SweptVolume", "straight moves"),
    QT_TRANSLATE_NOOP("SweptVolume", "moves without turns"),
    QT_TRANSLATE_NOOP("SweptVolume", "moves with turns"),
    QT_TRANSLATE_NOOP("SweptVolume", "polish"),
    QT_TRANSLATE_NOOP("SweptVolume", "done"),
]


def choice(names, now, texts=None):
    """Returns a combo box. The data of an entry is its untranslated name."""
    box = QtWidgets.QComboBox()
    # The task view is narrow: the closed box may cut off long entries, the open list shows them
    # fully.
    box.setSizeAdjustPolicy(QtWidgets.QComboBox.AdjustToMinimumContentsLengthWithIcon)
    box.setMinimumContentsLength(8)
    for i, name in enumerate(names):
        box.addItem(texts[i] if texts else translate("SweptVolume", name), name)
    if now in names:
        box.setCurrentIndex(list(names).index(now))
    return box


def hint(field, text):
    field.setToolTip(text)
    return field


def check_box(text, checked, tip):
    box = hint(QtWidgets.QCheckBox(text), tip)
    box.setChecked(checked)
    return box


def number_of(flag):
    """Returns the number of a Qt constant. In PySide2 the constant is the number; in PySide6 the
    number is its attribute `value`."""
    return int(getattr(flag, "value", flag))


def standard_buttons(*buttons):
    """Returns the buttons as PySide requires: an int in PySide2, flags in PySide6."""
    value = buttons[0]
    for button in buttons[1:]:
        value = value | button
    try:
        return int(value)
    except TypeError:
        return value


def actions_of(name):
    """Returns the entries in menus and toolbars for a command of FreeCAD."""
    return Gui.getMainWindow().findChildren(Action, name)


def alive(thing):
    """Returns whether a document or object still exists behind its Python wrapper."""
    try:
        return bool(thing.Name)
    except (ReferenceError, RuntimeError):
        return False


def to_first_field(form):
    """Moves the focus to the first field of a form that accepts it."""
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
    """Calls gone() soon after a document was closed. Calls changed() soon after objects were added
    or deleted, or their states, names or visibility may have changed. Ends with stop()."""

    def __init__(self, document, gone, changed=None):
        self.name, self.gone, self.changed, self._waits = document.Name, gone, changed, False
        App.addDocumentObserver(self)

    def slotDeletedDocument(self, document):  # noqa: N802
        if document.Name == self.name:
            QtCore.QTimer.singleShot(0, self._notify)

    def _notify(self):
        if self.name:
            self.stop()
            self.gone()

    def slotChangedObject(self, obj, name):  # noqa: N802
        if name in ("Status", "Message", "Label", "Visibility", "VisibilityList"):
            self.slotRecomputedDocument(obj.Document)

    def slotCreatedObject(self, obj):  # noqa: N802
        self.slotRecomputedDocument(obj.Document)

    slotDeletedObject = slotCreatedObject

    def slotRecomputedDocument(self, document):  # noqa: N802
        if self.changed is not None and not self._waits and document.Name == self.name:
            # Called later from the event loop, once for all that changes now.
            self._waits = True
            QtCore.QTimer.singleShot(0, self._notify_change)

    slotUndoDocument = slotRedoDocument = slotRecomputedDocument

    def _notify_change(self):
        self._waits = False
        if self.name:
            self.changed()

    def stop(self):
        if self.name:
            self.name = ""
            App.removeDocumentObserver(self)


def show_message(label, text):
    """Shows a message in a panel; hides the label if the text is empty."""
    label.setText(text)
    label.setVisible(bool(text))


def show_failure(label, run):
    """Shows the text about a run that ended without a result."""
    cancelled = translate("SweptVolume", "Cancelled. Nothing was changed.")
    show_message(label, cancelled if run.state == "cancelled" else run.message)


def message_label():
    label = QtWidgets.QLabel()
    label.setWordWrap(True)
    label.setTextInteractionFlags(QtCore.Qt.TextSelectableByMouse)
    label.hide()
    return label


class RunBox(QtWidgets.QGroupBox):
    """Progress of a run, with the button that stops it. Hidden while nothing runs."""

    def __init__(self):
        super().__init__(translate("SweptVolume", "Progress"))
        layout = QtWidgets.QVBoxLayout(self)
        row = QtWidgets.QHBoxLayout()
        self.bar = QtWidgets.QProgressBar()
        self.bar.setRange(0, 10000)
        self.stop = QtWidgets.QPushButton(translate("SweptVolume", "Stop"))
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
        # Otherwise the 3D view would get the focus from fields that are disabled now.
        self.stop.setFocus()

    def leave(self, field):
        """Called when no run is in progress: moves the focus, if it is in this box, to a field or
        to the first field of a form."""
        here = self.stop.hasFocus()
        self.hide()
        if here and number_of(field.focusPolicy()) & number_of(QtCore.Qt.TabFocus):
            field.setFocus()
        elif here:
            to_first_field(field)

    def _progress(self, part, phase):
        now = time.monotonic()
        # A stage without reports must still look active. The farther the bar is ahead of the
        # reported progress, the slower it moves.
        half = CREEP * (1.0 + 10.0 * max(0.0, self._shown - part))
        crept = max(0.0, MOST_CREPT - self._shown) * (1.0 - 0.5 ** ((now - self._looked) / half))
        self._shown, self._looked = max(part, self._shown + crept), now
        self.bar.setValue(int(self._shown * self.bar.maximum()))
        text = translate("SweptVolume", "{0}, {1} s")
        self.stage.setText(text.format(translate("SweptVolume", phase), int(now - self._began)))


def warn(title, text):
    """Shows a modal message if no panel is open to show it."""
    QtWidgets.QMessageBox.warning(Gui.getMainWindow(), title, text)
