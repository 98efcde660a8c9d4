# SPDX-License-Identifier: LGPL-2.1-or-later
"""Shows all errors of a panel in the panel, which stays open and keeps the typed values. FreeCAD
itself closes a panel whose accept() raises."""
import functools
import math
import traceback

import FreeCAD as App

from .. import core
from ..convert import InputProblem
from ..texts import translate
from . import core_dialog, widgets
from .widgets import QtCore, QtWidgets

#: Exceptions caused by the input or the machine. All others are faults of the workbench.
EXPECTED = (InputProblem, core.CoreError, core.CoreMissing, OSError)
#: Largest relative difference between a typed length and the value of its field, due to rounding.
AGREES = 1e-6


def show_problem(label, problem):
    """Shows a problem in a panel. The report view gets the full text of a fault of the workbench."""
    if isinstance(problem, core.CoreMissing):
        core_dialog.offer()
    if isinstance(problem, EXPECTED):
        widgets.show_message(label, str(problem))
        return
    text = "".join(traceback.format_exception(type(problem), problem, problem.__traceback__))
    App.Console.PrintError(text)
    said = translate(
        "SweptVolume",
        "This is an error in the workbench ({0}: {1}). Please report it with the details from "
        'the report view. See "Report a fault" in docs/handbook/troubleshooting.md.',
    )
    widgets.show_message(label, said.format(type(problem).__name__, problem))


def shows_problems(method):
    """Decorator for a method of a panel with a `message` label: shows problems there and then
    returns False."""

    @functools.wraps(method)
    def run(self, *given, **named):
        try:
            return method(self, *given, **named)
        except Exception as problem:
            show_problem(self.message, problem)
            return False

    return run


def check_fields(form):
    """Raises InputProblem for a field whose text does not match its value, because the typed text
    was not understood."""
    for field in form.findChildren(QtWidgets.QAbstractSpinBox):
        if not field.isVisible() or not field.isEnabled():
            continue
        edit = field.findChild(QtWidgets.QLineEdit)
        if edit is not None and edit.isModified() and not _understood(field, edit.text()):
            field.setFocus(QtCore.Qt.OtherFocusReason)
            raise InputProblem(
                translate(
                    "SweptVolume",
                    '{0}: "{1}" is not a valid value (it would be read as {2}). Correct it.',
                ).format(name_of(field, form), edit.text(), _counts_as(field))
            )


def name_of(field, form):
    """Returns the label beside a field. Does not look at widgets around the form: they belong to
    FreeCAD (widgets.forget_with())."""
    widget = field
    while widget is not form:
        layout = widget.parentWidget().layout()
        if isinstance(layout, QtWidgets.QFormLayout):
            label = layout.labelForField(widget) or _label_of_line(layout, widget)
            if label is not None:
                return label.text().replace("&", "")
        widget = widget.parentWidget()
    return field.toolTip() or field.objectName()


def _label_of_line(layout, widget):
    """Returns the label of a row with several fields side by side."""
    for row in range(layout.rowCount()):
        item = layout.itemAt(row, QtWidgets.QFormLayout.FieldRole)
        line = item.layout() if item is not None else None
        label = layout.itemAt(row, QtWidgets.QFormLayout.LabelRole)
        if line is not None and label is not None and line.indexOf(widget) >= 0:
            return label.widget()
    return None


def _is_quantity(field):
    return field.metaObject().className() == "Gui::QuantitySpinBox"


def _counts_as(field):
    if not _is_quantity(field):
        return field.value()
    return App.Units.Quantity(field.property("rawValue"), _unit_of(field)).UserString


def _unit_of(field):
    return App.Units.Quantity("1 " + (field.property("unit") or "mm")).Unit


def _understood(field, text):
    if not _is_quantity(field):
        return field.hasAcceptableInput()
    locale = QtCore.QLocale()
    group, point = (str(sign) for sign in (locale.groupSeparator(), locale.decimalPoint()))
    plain = text.replace(group, "").replace(point, ".").strip()
    try:
        number = float(plain)
        return math.isfinite(number) and (number >= 0 or field.property("minimum") < 0)
    except ValueError:
        pass
    try:
        quantity = App.Units.Quantity(plain)
    except (ValueError, ArithmeticError, SyntaxError):
        return False
    if quantity.Unit not in (_unit_of(field), App.Units.Unit()):
        return False  # FreeCAD 1.0 takes "5 kg" for 5 mm
    typed, raw = quantity.Value, float(field.property("rawValue"))
    return abs(typed - raw) <= AGREES * max(abs(typed), abs(raw), 1e-9)
