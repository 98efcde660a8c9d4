# SPDX-License-Identifier: LGPL-2.1-or-later
"""Poses of a part while a value of the document changes over a range: a spreadsheet cell, a
variable set, a sketch constraint, an Assembly4 variable, or any property that moves a mechanism.
The document is recomputed for each value; afterwards the value is restored."""
import math
import re

import FreeCAD as App

from ..convert import InputProblem, global_placement, matrix_of, root_path
from ..texts import translate
from .frames import check_valid
from .poses import even_times

#: Types of properties with one number.
_NUMBERS = ("App::PropertyFloat", "App::PropertyInteger", "App::PropertyPercent")
#: Properties of every object that move nothing.
_IDLE = {"MapPathParameter"}
CONSTRAINT = "Constraints."
#: Numbers of a placement (mm, degrees), such as an attachment offset.
_PLACEMENT = ("Base.x", "Base.y", "Base.z", "Rotation.Angle")


def _no_such_value(driver, name):
    """Returns an InputProblem that lists the values of an object that can be changed."""
    values = names_of(driver)
    if not values:
        text = translate(
            "SweptVolume", '"{0}" has no value that can be changed: choose another object.'
        )
        return InputProblem(text.format(driver.Label))
    text = translate(
        "SweptVolume", '"{0}" has no value "{1}" that can be changed: choose one of {2}.'
    )
    more = ", ..." if len(values) > 12 else ""
    return InputProblem(text.format(driver.Label, name, ", ".join(values[:12]) + more))


class Handle:
    """A value that can be read, set and restored: property, sketch constraint or cell."""

    def __init__(self, driver, name):
        self.driver, self.name = driver, name
        if name not in names_of(driver):
            raise _no_such_value(driver, name)
        for path, expression in getattr(driver, "ExpressionEngine", []):
            if path.lstrip(".") == name:
                raise InputProblem(
                    translate(
                        "SweptVolume",
                        'The value "{0}" of "{1}" cannot drive the motion, because the expression '
                        "{2} computes it: choose a value that this expression uses.",
                    ).format(name, driver.Label, expression)
                )
        self.before = self._raw()

    def _cell(self):
        if not self.driver.isDerivedFrom("Spreadsheet::Sheet"):
            return ""
        return self.driver.getCellFromAlias(self.name) or self.name

    def _raw(self):
        """Returns what restore() writes back."""
        return self.driver.getContents(self._cell()) if self._cell() else self.value()

    def value(self):
        """Returns the present number."""
        if self.name.startswith(CONSTRAINT):
            value = self.driver.getDatum(self.name[len(CONSTRAINT) :])
        elif "." in self.name:
            return self._placement_value()
        else:
            value = getattr(self.driver, self.name)
        return float(getattr(value, "Value", value))

    def unit(self):
        """Returns the unit of the number: "mm", "deg" or ""."""
        if self.name.startswith(CONSTRAINT):
            value = self.driver.getDatum(self.name[len(CONSTRAINT) :])
        elif "." in self.name:
            return "deg" if self.name.endswith("Angle") else "mm"
        else:
            value = getattr(self.driver, self.name)
        known = {str(App.Units.Length): "mm", str(App.Units.Angle): "deg"}
        return known.get(str(getattr(value, "Unit", "")), "")

    def set(self, value):
        if self._cell():
            self.driver.set(self._cell(), value if isinstance(value, str) else repr(float(value)))
        elif self.name.startswith(CONSTRAINT):
            self._set_constraint(value)
        elif "." in self.name:
            self._set_placement(value)
        else:
            now = getattr(self.driver, self.name)
            setattr(self.driver, self.name, int(round(value)) if isinstance(now, int) else value)

    def _placement_value(self):
        name, part = self.name.split(".", 1)
        placement = getattr(self.driver, name)
        if part == "Rotation.Angle":
            return math.degrees(placement.Rotation.Angle)
        return getattr(placement.Base, part[-1])

    def _set_placement(self, value):
        name, part = self.name.split(".", 1)
        placement = App.Placement(getattr(self.driver, name))
        if part == "Rotation.Angle":
            placement.Rotation = App.Rotation(placement.Rotation.Axis, value)
        else:
            base = App.Vector(placement.Base)
            setattr(base, part[-1], value)
            placement.Base = base
        setattr(self.driver, name, placement)

    def _set_constraint(self, value):
        short = self.name[len(CONSTRAINT) :]
        unit = "deg" if self.driver.getDatum(short).Unit == App.Units.Angle else "mm"
        self.driver.setDatum(short, App.Units.Quantity("{!r} {}".format(float(value), unit)))

    def restore(self):
        self.set(self.before)


def names_of(driver):
    """Returns the names, as used in expressions, of the values of an object that can be driven."""
    if driver.isDerivedFrom("Spreadsheet::Sheet"):
        cells = [c for c in driver.PropertiesList if re.fullmatch("[A-Z]{1,2}[0-9]+", c)]
        cells = [c for c in cells if not driver.getContents(c).startswith("=")]
        aliases = [driver.getAlias(c) or c for c in cells]
        return [a for a in aliases if _is_number(getattr(driver, a, None))]
    found = []
    for name in driver.PropertiesList:
        kind = driver.getTypeIdOfProperty(name)
        value = getattr(driver, name, None)
        if name in _IDLE or "ReadOnly" in driver.getEditorMode(name):
            continue
        if kind == "App::PropertyPlacement":
            found += ["{}.{}".format(name, part) for part in _PLACEMENT]
        elif kind in _NUMBERS or (_is_number(value) and hasattr(value, "Unit")):
            found.append(name)
    if driver.isDerivedFrom("Sketcher::SketchObject"):
        found += [CONSTRAINT + c.Name for c in driver.Constraints if c.Name and c.Driving]
    return sorted(found)


def _is_number(value):
    return isinstance(getattr(value, "Value", value), (int, float)) and not isinstance(value, bool)


def is_driver(obj):
    """Returns whether an object has a value that moves others: a spreadsheet, a variable set, a
    named constraint."""
    return bool(names_of(obj))


def frames(driver, name, start, end, count, duration, watched):
    """Runs the driver; a generator as in frames.py. watched: objects that must recompute in every
    frame."""
    handle, document = Handle(driver, name), driver.Document
    try:
        for i, time in enumerate(even_times(count, duration / max(count - 1, 1))):
            value = start + (end - start) * i / max(count - 1, 1)
            handle.set(value)
            document.recompute()
            text = translate(
                "SweptVolume",
                'The document could not be recomputed with "{0}" = {1:g}: choose '
                "another start or end value.",
            )
            check_valid([driver, *watched], text.format(name, value))
            yield time
    finally:
        handle.restore()
        document.recompute()


def pair(objects):
    """Returns (the object with the value, the part to record). Raises InputProblem."""
    if len(objects) != 2:
        raise InputProblem(
            translate(
                "SweptVolume",
                "Select the object with the value to change, then the part whose motion you want.",
            )
        )
    return objects


def signature(objects, name):
    """Returns a text that changes when the mechanism changes. It contains the value and the present
    placement of the part."""
    driver, part = pair(objects)
    matrix = matrix_of(global_placement(*root_path(part))).round(7) + 0.0
    return "{!r} {}".format(Handle(driver, name).value(), matrix.tolist())
