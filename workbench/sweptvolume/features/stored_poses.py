# SPDX-License-Identifier: LGPL-2.1-or-later
"""The poses that a motion object keeps, as arrays. Units: mm, s.

FreeCAD writes a list of placements as numbers into its files in a twentieth of the time that Python takes to
ask each placement for them: 0.15 ms for 1,000 poses. So they are read anew whenever they are asked for, and
what was made of them is kept only for the very same numbers: nothing has to tell that a motion has changed.
"""
import io
import zipfile

import numpy as np

from .. import contents, convert

#: Bytes of a pose in a file: three numbers for the place, four for the turn (a quaternion x, y, z, w).
_BYTES = 7 * 8
#: Where the check sum stands in the head of a file in an archive, behind the hour.
_CHECK_SUM = 14


class Stored:
    """times (n,); translations (n,3); rotations (n,4) as x, y, z, w: none of them to be changed.

    times: those of the object; packed: as _packed() gives its placements; part: the slice of it by which it
    is known again, None: there is none; numbers: place and turn of each placement (n,7)."""

    def __init__(self, times, packed, part, numbers):
        self._given, self._size, self._part = times, len(packed), part
        self._known = packed[part] if part else b""
        self.times = np.array(times, dtype=float)
        self.translations, self.rotations = numbers[:, :3], numbers[:, 3:]
        self._words = None

    def is_of(self, times, packed):
        """Whether an object with this has the same poses."""
        same = self._part and len(packed) == self._size and packed[self._part] == self._known
        return bool(same) and self._given == times

    def words(self):
        """Texts that change with the times and with the placements."""
        if self._words is None:
            matrices = convert.matrices_from(self.translations, self.rotations)
            self._words = [contents.digest(np.round(self.times, 9)), contents.matrices(matrices)]
        return list(self._words)


def of(obj):
    """The poses of a motion object as they are; kept in its proxy, which goes with it. Window's thread."""
    times, packed = obj.Times, _packed(obj)
    known = getattr(obj.Proxy, "_stored", None)
    if known is None or not known.is_of(times, packed):
        part, numbers = _unpacked(packed)
        if numbers is None:  # there are no poses, or this FreeCAD writes them otherwise
            part, numbers = None, np.hstack(convert.pose_arrays(obj.Placements))
        known = obj.Proxy._stored = Stored(times, packed, part, numbers)
    return known


def _packed(obj):
    """A small archive with what FreeCAD writes into a document's file for the placements; b"" where it has
    none."""
    try:
        return bytes(obj.dumpPropertyContent("Placements", Compression=0))
    except (AttributeError, TypeError):
        return b""


def _unpacked(packed):
    """(slice, numbers (n,7)) of an archive. The slice holds the numbers with their check sum, and not the
    hour at which the archive was made. (None, None) where it is not built so."""
    try:
        with zipfile.ZipFile(io.BytesIO(packed)) as file:
            data, begin = file.read("Placements"), file.getinfo("Placements").header_offset
            part = slice(begin + _CHECK_SUM, file.start_dir)
    except (KeyError, zipfile.BadZipFile):
        return None, None
    count = int(np.frombuffer(data, "<u4", 1)[0]) if len(data) >= 4 else 0
    if not count or len(data) != 4 + _BYTES * count:
        return None, None
    return part, np.frombuffer(data, "<f8", 7 * count, 4).reshape(-1, 7)
