# SPDX-License-Identifier: LGPL-2.1-or-later
"""The poses that a motion object stores, as arrays. Units: mm, s.

FreeCAD can write a list of placements as numbers, as in its document files. This takes a twentieth
of the time that Python needs to read each placement: 0.15 ms for 1,000 poses. So the numbers are
read at each call, and derived values are kept as long as the numbers are the same. Thus no
notification about changes is needed.
"""
import io
import zipfile

import numpy as np

from .. import contents, convert

#: Bytes of a pose in a file: three numbers for the position, four for the rotation (a quaternion x,
#: y, z, w).
_BYTES = 7 * 8
#: Position of the checksum in the header of a file in an archive, after the time.
_CHECK_SUM = 14


class Stored:
    """times (n,); translations (n,3); rotations (n,4) as x, y, z, w. Callers must not change them.

    Arguments: times: the property Times of the object; packed: result of _packed() for its
    placements. part: the slice of packed that identifies them, or None. numbers: position and
    rotation of each placement (n,7)."""

    def __init__(self, times, packed, part, numbers):
        self._given, self._size, self._part = times, len(packed), part
        self._known = packed[part] if part else b""
        self.times = np.array(times, dtype=float)
        self.translations, self.rotations = numbers[:, :3], numbers[:, 3:]
        self._words = None

    def is_of(self, times, packed):
        """Returns whether an object with these values has the same poses."""
        same = self._part and len(packed) == self._size and packed[self._part] == self._known
        return bool(same) and self._given == times

    def words(self):
        """Returns texts that identify the times and the placements."""
        if self._words is None:
            matrices = convert.matrices_from(self.translations, self.rotations)
            self._words = [contents.digest(np.round(self.times, 9)), contents.matrices(matrices)]
        return list(self._words)


def of(obj):
    """Returns the present poses of a motion object. Its proxy keeps them. Call it in the window's
    thread."""
    times, packed = obj.Times, _packed(obj)
    known = getattr(obj.Proxy, "_stored", None)
    if known is None or not known.is_of(times, packed):
        part, numbers = _unpacked(packed)
        # There are no poses, or this version of FreeCAD writes them in another form.
        if numbers is None:
            part, numbers = None, np.hstack(convert.pose_arrays(obj.Placements))
        known = obj.Proxy._stored = Stored(times, packed, part, numbers)
    return known


def _packed(obj):
    """Returns a small archive with the placements, as FreeCAD stores them in documents, or b"" if
    there are none."""
    try:
        return bytes(obj.dumpPropertyContent("Placements", Compression=0))
    except (AttributeError, TypeError):
        return b""


def _unpacked(packed):
    """Returns (slice, numbers (n,7)) of an archive. The slice covers the numbers and their
    checksum, but not the time at which the archive was made. Returns (None, None) if the archive
    has another form."""
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
