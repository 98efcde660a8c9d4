# SPDX-License-Identifier: LGPL-2.1-or-later
"""Poses from the placements of objects: copies of the part, links, local coordinate systems."""
from ..convert import InputProblem, global_placement, root_path
from ..texts import translate
from .poses import Poses, even_times


def placements(objects, step):
    """Returns one pose for each object, in the order given. `step`: time (s) between two poses."""
    found = []
    for obj in objects:
        if not hasattr(obj, "Placement"):
            raise InputProblem(
                translate(
                    "SweptVolume",
                    '"{0}" has no placement, so it cannot be a pose: choose another object.',
                ).format(obj.Label)
            )
        found.append(global_placement(*root_path(obj)))
    if not found:
        raise InputProblem(translate("SweptVolume", "Choose at least one object with a placement."))
    return Poses(even_times(len(found), step), found)
