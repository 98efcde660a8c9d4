# SPDX-License-Identifier: LGPL-2.1-or-later
"""Edits a list of key poses. Keys copies the lists that it is given, so discarding it discards all
edits."""
import math
import re

import FreeCAD as App

from .. import quantities
from ..convert import InputProblem
from ..texts import translate
from .poses import Poses, at_time, shift_to


#: Larger numbers are not valid in a key; the core accepts up to 1e9 mm.
LARGEST = 1e9
AUTO = ("Auto", None)


class Keys:
    """The times (s), placements and tangents (spline.py) of a motion that is edited. Indices count
    from 0; times always increase. pivot: as in Poses. displaces: the keys are displacements, whose
    numbers are zero if the part does not move."""

    def __init__(self, times=(), placements=(), tangents=(), step=1.0, pivot=None, displaces=False):
        self.pivot = App.Vector(pivot) if pivot is not None else App.Vector()
        self.displaces = displaces
        self.times = list(times)
        self.placements = [App.Placement(p) for p in placements]
        self.tangents = (list(tangents) + [AUTO] * len(self.times))[: len(self.times)]
        self.step = step

    def __len__(self):
        return len(self.times)

    def poses(self):
        return Poses(self.times, self.placements, self.tangents, pivot=self.pivot)

    def numbers(self, index):
        """Returns x, y, z (mm) of the pivot at a key, or its displacement; yaw, pitch, roll
        (degrees)."""
        shown = self.placements[index].multiply(shift_to(self.pivot))
        if self.displaces:
            shown = shift_to(-self.pivot).multiply(shown)
        return as_numbers(shown)

    def placed(self, numbers):
        """Returns the placement for numbers from numbers()."""
        placement = from_numbers(numbers).multiply(shift_to(-self.pivot))
        return shift_to(self.pivot).multiply(placement) if self.displaces else placement

    def _put(self, index, time, placement):
        self.times.insert(index, float(time))
        self.placements.insert(index, App.Placement(placement))
        self.tangents.insert(index, AUTO)
        return index

    def append(self, placement):
        time = self.times[-1] + self.step if self.times else 0.0
        return self._put(len(self), time, placement)

    def insert_after(self, index, interpolation="Linear", placement=None):
        """Adds a key at half the time to the next key, at the placement that the part has then.
        After the last key: one time step later."""
        if index + 1 >= len(self):
            return self.append(
                placement or (self.placements[-1] if self.placements else App.Placement())
            )
        time = 0.5 * (self.times[index] + self.times[index + 1])
        if placement is None:
            placement = at_time(self.poses(), interpolation, time)
        return self._put(index + 1, time, placement)

    def duplicate(self, index):
        return self.insert_after(index, placement=self.placements[index])

    def update(self, index, placement):
        self.placements[index] = App.Placement(placement)

    def set_tangent(self, index, kind, velocity=None):
        """Sets the tangent of a key. kind: one of spline.TANGENTS; velocity (mm/s): for Given."""
        self.tangents[index] = (kind, App.Vector(velocity) if kind == "Given" else None)

    def delete(self, index):
        del self.times[index]
        del self.placements[index]
        del self.tangents[index]

    def move(self, index, by):
        """Moves a key up or down. The times stay in their rows."""
        target = index + by
        if not 0 <= target < len(self):
            return index
        self.placements.insert(target, self.placements.pop(index))
        self.tangents.insert(target, self.tangents.pop(index))
        return target

    def reverse(self):
        """Reverses the motion: the last key comes first, with the same time intervals between keys."""
        if not self.times:
            return
        first, last = self.times[0], self.times[-1]
        self.times = [first + last - t for t in reversed(self.times)]
        self.placements.reverse()
        self.tangents = [(k, -v if v is not None else None) for k, v in reversed(self.tangents)]

    def paste(self, index, rows):
        """Replaces the keys from an index on by rows of numbers (s, mm, degrees), and adds further
        keys, as in a spreadsheet. Returns the index of the last one. Raises InputProblem, and
        then changes nothing.
        """
        begin = max(index, 0)
        times, placements = list(self.times), list(self.placements)
        times[begin : begin + len(rows)] = [row[0] for row in rows]
        placements[begin : begin + len(rows)] = [self.placed(row[1:]) for row in rows]
        Poses(times, placements)  # times must not decrease
        self.times, self.placements = times, placements
        self.tangents = (self.tangents + [AUTO] * len(times))[: len(times)]
        return begin + len(rows) - 1

    def set_time(self, index, time):
        """Changes one time. It must stay between its neighbours."""
        before = self.times[index - 1] if index else None
        after = self.times[index + 1] if index + 1 < len(self) else None
        if (before is not None and time <= before) or (after is not None and time >= after):
            if before is None:
                text = translate(
                    "SweptVolume", "The time of key {0} must be less than {2} s, not {3} s."
                )
            elif after is None:
                text = translate(
                    "SweptVolume", "The time of key {0} must be more than {1} s, not {3} s."
                )
            else:
                text = translate(
                    "SweptVolume",
                    "The time of key {0} must be more than {1} s and less than {2} s, not {3} s.",
                )
            raise InputProblem(text.format(index + 1, *map(_seconds, (before, after, time))))
        self.times[index] = float(time)

    def even(self, step):
        """Sets the times evenly, one key for each step (s)."""
        first = self.times[0] if self.times else 0.0
        self.times = [first + k * step for k in range(len(self))]
        self.step = step


def _seconds(time):
    """Returns the number of a time, with enough digits to tell keys apart."""
    return "" if time is None else quantities.number(time, 9)


def rounded(numbers, millimetres, degrees):
    """Rounds the numbers of a key to steps of position and of yaw, pitch, roll. A step of 0 does
    not round."""
    steps = (millimetres,) * 3 + (degrees,) * 3
    return [round(n / s) * s if s > 0 else n for n, s in zip(numbers, steps)]


def as_numbers(placement):
    """Returns x, y, z (mm), yaw, pitch, roll (degrees)."""
    base, angles = placement.Base, placement.Rotation.toEuler()
    return (base.x, base.y, base.z) + tuple(angles)


def from_numbers(numbers):
    """Returns the placement for numbers from as_numbers()."""
    x, y, z, yaw, pitch, roll = numbers
    return App.Placement(App.Vector(x, y, z), App.Rotation(yaw, pitch, roll))


def rows_from(text, units):
    """Converts text from a spreadsheet to rows of t, x, y, z, yaw, pitch, roll (s, mm, degrees).
    Angles may be missing, and the first line may contain titles. units: (name, size of the unit)
    of each column. Raises InputProblem, which names the row."""
    lines = [line for line in text.splitlines() if line.strip()]
    rows = []
    for number, line in enumerate(lines):
        cells = [
            c for c in re.split("\t|;" if "\t" in line or ";" in line else r"\s+", line.strip())
        ]
        if number == 0 and not any(sign.isdigit() for sign in line):
            continue
        if len(cells) not in (4, 7):
            raise InputProblem(
                translate(
                    "SweptVolume",
                    "Row {0} of the pasted text has {1} columns: use either the four "
                    "columns t, x, y, z, or the seven columns t, x, y, z, yaw, pitch, roll.",
                ).format(number + 1, len(cells))
            )
        numbers = [number_from(c, unit) * one for c, (unit, one) in zip(cells, units)]
        rows.append(numbers + [0.0] * (7 - len(numbers)))
    if not rows:
        raise InputProblem(
            translate(
                "SweptVolume",
                "The clipboard has no rows of numbers: copy cells from a spreadsheet first.",
            )
        )
    return rows


def _quantity_from(text, unit):
    """Parses a text with a unit. Returns the value in `unit`, or NaN if the text is not such a
    quantity."""
    try:
        quantity, one = App.Units.Quantity(text), App.Units.Quantity("1 " + unit)
        if quantity.Unit == one.Unit:
            return quantity.Value / one.Value
    except (ValueError, SyntaxError, ArithmeticError):
        pass
    return math.nan


def number_from(text, unit):
    """Parses a number with or without a unit: "12.5", "2 in", "1 rad". `unit`: "mm", "deg" or "s"."""
    text = text.strip()
    try:
        number = float(text.replace(",", "."))
    except ValueError:
        number = _quantity_from(text, unit)
    if math.isfinite(number) and abs(number) <= LARGEST:
        return number
    raise InputProblem(
        translate(
            "SweptVolume",
            '"{0}" is too large, or is neither a number nor a quantity that can be converted to '
            "{1}: correct the entry.",
        ).format(text, unit)
    )
