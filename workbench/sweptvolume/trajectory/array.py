# SPDX-License-Identifier: LGPL-2.1-or-later
"""Poses from a list of placements on one object: App::Link arrays, Draft arrays."""
from ..convert import InputProblem, global_placement, root_path
from ..texts import translate
from .poses import Poses, even_times


def is_array(obj):
    return bool(getattr(obj, "ElementList", None)) or bool(getattr(obj, "PlacementList", None))


def poses(objects, step):
    """Returns one pose for each element. `step`: time (s) between two poses."""
    if len(objects) != 1 or not is_array(objects[0]):
        raise InputProblem(translate("SweptVolume", "Select one link array or Draft array."))
    obj = objects[0]
    outer = global_placement(*root_path(obj))
    # Elements shown in the tree have their own placements; PlacementList is then out of date.
    elements = getattr(obj, "ElementList", None)
    inner = [e.Placement for e in elements] if elements else list(obj.PlacementList)
    return Poses(even_times(len(inner), step), [outer.multiply(p) for p in inner])
