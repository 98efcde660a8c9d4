# SPDX-License-Identifier: LGPL-2.1-or-later
"""Boxes and the space that a moving part takes, for scenarios and pictures in FreeCAD's window."""
import FreeCAD as App


def at(*base):
    """Returns the placement of a part at this position, without a turn."""
    return App.Placement(App.Vector(*base), App.Rotation())


def add_box(doc, name, size, base):
    obj = doc.addObject("Part::Box", name)
    obj.Length, obj.Width, obj.Height = size
    obj.Placement = at(*base)
    return obj


def hidden_motion(doc, start, end, seconds=1):
    """Returns a straight motion between two placements. The motion is not drawn."""
    from sweptvolume.features import motion

    path = motion.motion_from_poses(doc, [0, seconds], [start, end])
    path.ViewObject.Visibility = False
    return path


def swept_space(doc, part, path, resolution):
    """Returns the computed envelope of a part."""
    from sweptvolume.features import envelope

    doc.recompute()
    obj = envelope.make_envelope(doc, [part], path, Resolution=resolution)
    doc.recompute()
    envelope.compute(obj)
    return obj
