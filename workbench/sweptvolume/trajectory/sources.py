# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where the poses of a motion come from. Each kind is one function Settings -> Poses."""
import hashlib
import json
import os

from ..convert import InputProblem
from ..texts import translate
from . import array, assembly, cam, csv_file, curve, driven, frames, objects, robot
from .poses import Poses

#: Each takes a step of Python or a recompute of the document.
MOST_POSES = 100_000


class Settings:
    """A source as a plain value: kind, file, unit, objects and the values that its kind asks for."""

    def __init__(self, kind="Stored", file="", unit="mm", objects=(), **values):
        self.kind = kind
        self.file = file
        self.unit = unit
        self.objects = list(objects)
        self.values = values

    def get(self, name, default):
        return self.values.get(name, default)

    def with_values(self, values):
        """The same source with other values."""
        return Settings(
            self.kind, self.file, self.unit, self.objects, **dict(self.values, **values)
        )

    def count(self, default, least=2):
        """How many poses to read. Raises InputProblem."""
        value = int(self.get("count", default))
        if not least <= value <= MOST_POSES:
            raise InputProblem(
                translate(
                    "Messages", "The number of poses is {0}: enter a number from {1} to {2}."
                ).format(value, least, MOST_POSES)
            )
        return value


def damaged():
    """What is to be said where settings cannot be understood."""
    return InputProblem(
        translate(
            "Messages",
            "The settings of the motion's source are damaged: create the motion "
            "again, or use its poses as they are.",
        )
    )


def values_from(text):
    """Values of a source from older documents, which kept them as JSON. Raises InputProblem."""
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
            "Messages",
            "This motion has no source that could be read again: its poses are "
            "stored only in the document.",
        )
    )


def _file(settings):
    return csv_file.read(settings.file, settings.unit)


def _placements(settings):
    return objects.placements(settings.objects, settings.get("step", 1.0))


def _curve(settings):
    how = settings.get("orientation", "Fixed"), float(settings.get("duration", 10.0))
    if settings.get("count", 0):  # older documents
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
    """The part that a source of FROM_JOINTS is read for. Raises InputProblem."""
    pair = assembly.pair if settings.kind == "Simulation" else driven.pair
    return pair(settings.objects)[1]


def _watched(settings):
    part = watched(settings)
    return frames.poses_of(run(settings, [part]), part)


def run(settings, watched=()):
    """A run of a source of FROM_JOINTS, which moves parts of the document together: as frames.py has it.
    watched: objects that have to recompute in every frame. Raises InputProblem."""
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
    """The kind of source that selected objects are, "" for none."""
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


#: What a source is asked for where nothing else is said.
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
    # Driving recomputes the document and so cannot happen inside a recompute.
    "Driven": (_watched, False),
    "Simulation": (_watched, False),
}


#: Frames of parts that turn about joints: between two of them they go on turning.
FROM_JOINTS = ("Driven", "Simulation")


def interpolation_of(kind):
    """What a part does between two poses of such a source, where nothing else is asked for."""
    return "Screw" if kind in FROM_JOINTS else "Linear"


def frame_of(kind):
    """What a pose of such a source means where a user asks for nothing else: a part follows a wire from where
    it stands."""
    return "RelativeToFirst" if kind == "Curve" else "Absolute"


def in_order(found):
    """Two selected objects as a source wants them: a simulation, or a value, before the part to watch. As
    they are where both may be either."""
    if len(found) == 2:
        first, second = found
        if assembly.is_simulation(second) or _is_part(first) and not _is_part(second):
            return [second, first]
    return list(found)


def _is_part(obj):
    """Whether an object has a body that can be seen to move."""
    shape = getattr(obj, "Shape", None)
    return hasattr(obj, "Mesh") or bool(shape is not None and shape.Faces) or hasattr(obj, "Group")


def is_live(kind):
    """Whether the motion follows its source by itself."""
    return KINDS[kind][1]


def signature(settings):
    """Text that stands for the state of a source that is not live, so that a change is noticed; ""
    where there is none. A source that is gone or broken is a changed one."""
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
    """Poses of a source; raises InputProblem."""
    poses = KINDS[settings.kind][0](settings)
    if not isinstance(poses, Poses):
        raise TypeError("a source returns Poses")
    return poses
