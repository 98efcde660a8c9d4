# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is selected, sorted by what our commands can use. Sub paths through groups and links stay."""
import FreeCADGui as Gui

from ..convert import leaves, pairs_of, root_path, split_path
from ..features.clearance import is_clearance
from ..features.envelope import is_envelope
from ..features.motion import is_motion
from ..features.solid import can_be_source, is_solid


def paths():
    """Selected (root, sub path) without element names, each once, in order of selection."""
    found = []
    for item in Gui.Selection.getSelectionEx("", 0):
        for sub in item.SubElementNames or [""]:
            pair = (item.Object, split_path(item.Object, sub))
            if not pair[1]:
                pair = root_path(item.Object)
            if pair not in found:
                found.append(pair)
    return found


def _target(pair):
    return pair[0].getSubObject(pair[1], retType=1)


def _ours(obj):
    return is_envelope(obj) or is_motion(obj) or is_solid(obj) or is_clearance(obj)


def parts():
    """Selected solids and meshes that can move."""
    found = []
    for pair in paths():
        target = _target(pair)
        if target is None or _ours(target):
            continue
        try:
            if leaves(*pair):
                found.append(pair)
        except ValueError:
            continue
    return found


def moved_part(obj):
    """The part that a motion (None: a new one) moves: the selected one, else the first of an envelope
    that uses it."""
    chosen = parts()
    if chosen:
        return chosen[0]
    for user in obj.InList if obj else []:
        if is_envelope(user) and user.Generators:
            return pairs_of(user.Generators)[0]
    return None


def motion():
    """The selected motion, or None."""
    return _first(is_motion)


def envelope():
    return _first(is_envelope)


def solid():
    return _first(is_solid)


def clearance():
    """The selected clearance check, or None."""
    return _first(is_clearance)


def source():
    """The selected envelope or other mesh of which a solid can be made."""
    return _first(can_be_source)


def placed():
    """Selected objects that have a placement and are not ours."""
    found = []
    for pair in paths():
        target = _target(pair)
        if target is not None and hasattr(target, "Placement") and not _ours(target):
            found.append(target)
    return found


def _first(test):
    for pair in paths():
        target = _target(pair)
        if target is not None and test(target):
            return target
    return None


def plain():
    """Selected objects that are not ours, with or without a placement."""
    found = [_target(pair) for pair in paths()]
    return [target for target in found if target is not None and not _ours(target)]
