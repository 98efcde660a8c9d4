# SPDX-License-Identifier: LGPL-2.1-or-later
"""Formats numbers for users: in the units of FreeCAD's preferences, with the separators of the
user's language, and rounded to significant digits, so that 0.1 mm never becomes "0.00 in"."""
import math

import FreeCAD as App
from PySide import QtCore

#: A whole column uses the unit that FreeCAD chooses for this length (mm). This avoids very small
#: and very large units.
TYPICAL = 10.0
#: Significant digits of a text. Tables have one more, because their lengths are compared.
DIGITS, TABLE_DIGITS = 3, 4
#: Largest number of decimals. Smaller numbers are written with an exponent.
MOST_DECIMALS = 9


def _locale():
    locale = QtCore.QLocale()
    if locale.language() == QtCore.QLocale.C:  # the C locale has no group separator
        locale = QtCore.QLocale(QtCore.QLocale.English, QtCore.QLocale.UnitedStates)
    return locale


def number(value, digits=DIGITS):
    """Formats a number with this many significant digits. The whole part keeps all its digits."""
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
    """Formats a whole number with its separators."""
    return _locale().toString(int(value))


def quantity(value, digits=DIGITS):
    """Formats a length (mm) with the unit that FreeCAD would choose. Rounds it first, because the
    distance of parts in contact may differ from 0 by rounding errors."""
    value = round(float(value), MOST_DECIMALS)
    factor, name = _preferred(value)
    return "{} {}".format(number(value / factor, digits), name)


def _preferred(value):
    _, factor, name = App.Units.Quantity(float(value), App.Units.Length).getUserPreferred()
    return factor, {'"': "in", "'": "ft"}.get(name, name)


def volume(value, digits=TABLE_DIGITS):
    """Formats cubic millimetres in the cube of length_unit(). FreeCAD would choose litres, which
    are unusual for mechanisms."""
    one, name = length_unit()
    return "{} {}^3".format(number(value / one**3, digits), name)


def length_unit():
    """Returns (mm in one unit, name of the unit) in which a column shows lengths."""
    return _preferred(TYPICAL)


def megabytes(value):
    """Formats bytes as MB."""
    return "{} MB".format(number(value / 1e6))


def seconds(value):
    """Formats a duration: with tenths below ten seconds, in minutes above two minutes."""
    if value < 10:
        return "{} s".format(number(max(value, 0.1), 2))
    return (
        "{} s".format(count(round(value))) if value < 120 else "{} min".format(number(value / 60))
    )
