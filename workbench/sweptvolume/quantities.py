# SPDX-License-Identifier: LGPL-2.1-or-later
"""Numbers as people read them: in the units of FreeCAD's preferences, with the separators of the user's
language, and with digits that count: 0.1 mm is never "0.00 in"."""
import math

import FreeCAD as App
from PySide import QtCore

#: Length (mm) whose unit stands for a whole column: neither thousandths nor yards.
TYPICAL = 10.0
#: Digits that count in a text; lengths in a table have one more, since they are compared.
DIGITS, TABLE_DIGITS = 3, 4
#: Decimals at most: beyond them the number has an exponent.
MOST_DECIMALS = 9


def _locale():
    locale = QtCore.QLocale()
    if locale.language() == QtCore.QLocale.C:  # it separates nothing
        locale = QtCore.QLocale(QtCore.QLocale.English, QtCore.QLocale.UnitedStates)
    return locale


def number(value, digits=DIGITS):
    """A number rounded to so many digits that count; whole ones keep all of theirs."""
    value = float(value)
    if not math.isfinite(value):
        return str(value)
    size = math.floor(math.log10(abs(value))) if value else 0
    decimals = max(0, digits - 1 - size)
    if decimals > MOST_DECIMALS + digits:
        return "{:.{}g}".format(value, digits)
    locale = _locale()
    text = locale.toString(round(value, decimals), "f", decimals)
    point = str(locale.decimalPoint())
    return text.rstrip("0").rstrip(point) if decimals and point in text else text


def count(value):
    """A whole number with its separators."""
    return _locale().toString(int(value))


def quantity(value, digits=DIGITS):
    """A length (mm) with the unit that FreeCAD would choose."""
    factor, name = _preferred(value)
    return "{} {}".format(number(value / factor, digits), name)


def _preferred(value):
    _, factor, name = App.Units.Quantity(float(value), App.Units.Length).getUserPreferred()
    return factor, {'"': "in", "'": "ft"}.get(name, name)


def volume(value, digits=TABLE_DIGITS):
    """Cubic millimetres in the cube of length_unit(): litres of a mechanism are no measure."""
    one, name = length_unit()
    return "{} {}^3".format(number(value / one**3, digits), name)


def length_unit():
    """(mm in one, name) of the unit in which a column shows lengths."""
    return _preferred(TYPICAL)


def megabytes(value):
    """Bytes as MB."""
    return "{} MB".format(number(value / 1e6))


def seconds(value):
    """A duration: tenths below ten seconds, minutes above two."""
    if value < 10:
        return "{} s".format(number(max(value, 0.1), 2))
    return (
        "{} s".format(count(round(value))) if value < 120 else "{} min".format(number(value / 60))
    )
