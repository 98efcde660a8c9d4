# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where the poses of a motion come from. Each kind is one function Settings -> Poses."""
import json

from ..convert import InputProblem
from ..texts import translate
from . import csv_file, objects
from .poses import Poses


class Settings:
    """A source as a plain value: kind, file, unit, objects and kind-specific values (as JSON)."""

    def __init__(self, kind="Stored", file="", unit="mm", objects=(), extra="", **values):
        self.kind = kind
        self.file = file
        self.unit = unit
        self.objects = list(objects)
        self.values = json.loads(extra) if extra else {}
        self.values.update(values)

    @property
    def extra(self):
        return json.dumps(self.values, sort_keys=True) if self.values else ""

    def get(self, name, default):
        return self.values.get(name, default)


def _stored(settings):
    raise InputProblem(
        translate("Messages", "this motion keeps its own poses and has no source to read again.")
    )


def _file(settings):
    return csv_file.read(settings.file, settings.unit)


def _placements(settings):
    return objects.placements(settings.objects, settings.get("step", 1.0))


#: kind -> (reader, live). Live sources are read at every recompute of the motion.
KINDS = {
    "Stored": (_stored, False),
    "File": (_file, False),
    "Placements": (_placements, True),
}


def is_live(kind):
    """Whether the motion follows its source by itself."""
    return KINDS[kind][1]


def read(settings):
    """Poses of a source; raises InputProblem."""
    poses = KINDS[settings.kind][0](settings)
    if not isinstance(poses, Poses):
        raise TypeError("a source returns Poses")
    return poses
