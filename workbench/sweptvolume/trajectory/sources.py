# SPDX-License-Identifier: LGPL-2.1-or-later
"""The sources of motions. Each kind is a function Settings -> Poses."""
import hashlib
import json
import os

from ..convert import InputProblem
from ..texts import translate
from . import array, assembly, cam, csv_file, curve, driven, frames, objects, robot
from .poses import Poses

#: Limit for sources where each pose takes a step of Python or a recompute of the document.
MOST_POSES = 100_000


class Settings:
    """A source as a plain value: kind, file, unit, objects, and the values that its kind needs."""

    def __init__(self, kind="Stored", file="", unit="mm", objects=(), **values):
        self.kind = kind
        self.file = file
        self.unit = unit
        self.objects = list(objects)
        self.values = values

    def get(self, name, default):
        return self.values.get(name, default)

    def with_values(self, values):
        """Returns the same source with other values."""
        return Settings(
            self.kind, self.file, self.unit, self.objects, **dict(self.values, **values)
        )

    def count(self, default, least=2):
        """Returns the number of poses to read. Raises InputProblem."""
        value = int(self.get("count", default))
        if not least <= value <= MOST_POSES:
            raise InputProblem(
                translate(
                    "SweptVolume", "The number of poses is {0}: enter a number from {1} to {2}."
                ).format(value, least, MOST_POSES)
            )
        return value


def damaged():
    """Returns the InputProblem for settings that cannot be read."""
    return InputProblem(
        translate(
            "SweptVolume",
            "The settings of the motion's source are damaged: create the motion again, or edit its "
            "keys with Edit motion, which removes the link to the source and keeps the poses.",
        )
    )


def values_from(text):
    """Returns the values of a source in documents of earlier versions, which stored JSON. Raises
    InputProblem."""
    try:
        values = json.loads(text)
    except ValueError:
        raise damaged() from None
    if not isinstance(values, dict):
        raise damaged()
    return values


def _stored(settings):
    raise InputProblem(
        translate(
            "SweptVolume",
            "This motion has no source that could be read again: its poses are "
            "stored only in the document. To change them, choose Edit motion.",
        )
    )


def _file(settings):
    return csv_file.read(settings.file, settings.unit)


def _placements(settings):
    return objects.placements(settings.objects, settings.get("step", 1.0))


def _curve(settings):
    how = settings.get("orientation", "Fixed"), float(settings.get("duration", 10.0))
    if settings.get("count", 0):  # documents of earlier versions
        return curve.poses(settings.objects, settings.count(32), *how)
    accuracy = float(settings.get("accuracy", curve.ACCURACY))
    return curve.poses_within(settings.objects, accuracy, *how)


def _robot(settings):
    return robot.poses(settings.objects, settings.count(DEFAULTS["Robot"]["count"]))


def _array(settings):
    return array.poses(settings.objects, float(settings.get("step", 1.0)))


def _cam(settings):
    return cam.poses(
        settings.objects,
        float(settings.get("rapid", 100.0)),
        settings.get("convention", "Head"),
    )


def watched(settings):
    """Returns the part whose motion is read from a source of FROM_JOINTS. Raises InputProblem."""
    pair = assembly.pair if settings.kind == "Simulation" else driven.pair
    return pair(settings.objects)[1]


def _watched(settings):
    part = watched(settings)
    return frames.poses_of(run(settings, [part]), part)


def run(settings, watched=()):
    """Returns a run, as in frames.py, of a source of FROM_JOINTS, which moves several parts of the
    document. watched: objects that must recompute in every frame. Raises InputProblem."""
    if settings.kind == "Simulation":
        return assembly.frames(settings.objects[0])
    return driven.frames(
        settings.objects[0],
        settings.get("property", ""),
        float(settings.get("start", 0.0)),
        float(settings.get("end", 1.0)),
        settings.count(DEFAULTS["Driven"]["count"], least=1),
        float(settings.get("duration", 10.0)),
        list(watched),
    )


def kind_for(found):
    """Returns the kind of source of the selected objects, or ""."""
    if len(found) == 2 and all(curve.is_curve(obj) for obj in found):
        return "Curve"
    if len(found) == 2 and assembly.is_simulation(found[0]):
        return "Simulation"
    if len(found) == 1:
        obj = found[0]
        for kind, test in (
            ("Simulation", assembly.is_simulation),
            ("Robot", robot.is_trajectory),
            ("CAM", cam.is_path),
            ("Array", array.is_array),
            ("Curve", curve.is_curve),
        ):
            if test(obj):
                return kind
    return ""


#: Default values of sources.
DEFAULTS = {"Robot": {"count": 32}, "Driven": {"count": 16}}
#: kind -> (reader, live). Live sources are read at every recompute of the motion.
KINDS = {
    "Stored": (_stored, False),
    "File": (_file, False),
    "Placements": (_placements, True),
    "Curve": (_curve, True),
    "Robot": (_robot, True),
    "Array": (_array, True),
    "CAM": (_cam, True),
    # A driver recomputes the document, so it cannot run inside a recompute.
    "Driven": (_watched, False),
    "Simulation": (_watched, False),
}


#: Sources whose parts turn about joints, also between two frames.
FROM_JOINTS = ("Driven", "Simulation")


def interpolation_of(kind):
    """Returns the default interpolation for a kind of source."""
    return "Screw" if kind in FROM_JOINTS else "Linear"


def frame_of(kind):
    """Returns the default pose type for a kind of source. A part follows a wire from its present
    placement; other sources give placements of the part."""
    return "RelativeToFirst" if kind == "Curve" else "Absolute"


def in_order(found):
    """Returns two selected objects in the order that a source needs: the simulation or the object
    with the value, then the part to record. Does not change the order if both objects could be
    either."""
    if len(found) == 2:
        first, second = found
        if assembly.is_simulation(second) or _is_part(first) and not _is_part(second):
            return [second, first]
    return list(found)


def _is_part(obj):
    """Returns whether an object has a visible body, whose motion can be recorded."""
    shape = getattr(obj, "Shape", None)
    return hasattr(obj, "Mesh") or bool(shape is not None and shape.Faces) or hasattr(obj, "Group")


def is_live(kind):
    """Returns whether the motion follows its source automatically."""
    return KINDS[kind][1]


def signature(settings):
    """Returns a text that identifies the state of a source that is not live, so that a change is
    noticed, or "". A deleted or broken source counts as changed."""
    try:
        if settings.kind == "File":
            return _file_hash(settings.file)
        if settings.kind == "Driven":
            return driven.signature(settings.objects, settings.get("property", ""))
        if settings.kind == "Simulation":
            return assembly.signature(settings.objects)
    except (InputProblem, OSError, AttributeError) as problem:
        return "? {}".format(problem)
    return ""


def _file_hash(path):
    if not os.path.isfile(path):
        raise InputProblem(path)
    found = hashlib.sha256()
    with open(path, "rb") as file:
        for block in iter(lambda: file.read(1 << 20), b""):
            found.update(block)
    return found.hexdigest()[:32]


def read(settings):
    """Returns the poses of a source. Raises InputProblem."""
    poses = KINDS[settings.kind][0](settings)
    if not isinstance(poses, Poses):
        raise TypeError("a source returns Poses")
    return poses
