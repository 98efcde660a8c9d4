# SPDX-License-Identifier: LGPL-2.1-or-later
"""Motion files, read by the core, with the same messages as the command line."""
import os

from .. import core
from ..convert import InputProblem, placements_from
from ..texts import translate
from .poses import Poses


def read(path, unit):
    """Reads a CSV file with `t,tx,ty,tz,qx,qy,qz,qw` or 16 matrix numbers in each row, also .gz and
    .xz. Unit: mm|cm|m|in."""
    if not path or not os.path.isfile(path):
        raise InputProblem(
            translate(
                "SweptVolume", 'The motion file "{0}" does not exist: choose another file.'
            ).format(path)
        )
    try:
        times, translations, rotations = core.read_motion(path, unit)
    except core.CoreError as error:
        raise InputProblem("{}: {}".format(os.path.basename(path), error)) from None
    return Poses(times, placements_from(translations, rotations))
