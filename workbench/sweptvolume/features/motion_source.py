# SPDX-License-Identifier: LGPL-2.1-or-later
"""The source of a motion, as stored in its properties: what is read, and whether it has changed
since."""
from .. import contents
from ..convert import InputProblem, matrix_of
from ..trajectory import sources
from ..trajectory.poses import Poses
from . import moved_parts
from .base import HIDDEN, READ_ONLY, quietly, set_changed
from .motion_frame import container_of, from_world
from .motion_properties import NAMES, USED


def settings_of(obj):
    """Returns the source of a motion object as a plain value. Raises InputProblem."""
    # Settings that are still stored as text are damaged. Otherwise convert_old_settings() would have
    # converted and removed them.
    if obj.SourceSettings:
        raise sources.damaged()
    values = {key: getattr(obj, NAMES[key]) for key in USED.get(obj.SourceType, ())}
    return sources.Settings(
        kind=obj.SourceType,
        file=obj.SourceFile,
        unit=obj.SourceUnit,
        objects=list(obj.SourceObjects),
        **{key: getattr(value, "Value", value) for key, value in values.items()},
    )


def has_settings(obj):
    """Returns whether the source of a motion has settings that the user can change."""
    return obj.SourceType == "File" or bool(USED.get(obj.SourceType))


def keep(obj, settings):
    """Writes a source into a motion object. Values that the settings leave open do not change."""
    set_changed(obj, "SourceType", settings.kind)
    set_changed(obj, "SourceFile", settings.file)
    set_changed(obj, "SourceUnit", settings.unit)
    set_changed(obj, "SourceObjects", list(settings.objects))
    for key, value in settings.values.items():
        now = getattr(obj, NAMES[key])
        if getattr(now, "Value", now) != value:
            setattr(obj, NAMES[key], value)
    show_settings(obj)


def show_settings(obj):
    """Shows in the property editor only the settings that the kind of source uses."""
    used = {NAMES[key] for key in USED.get(obj.SourceType, ())}
    for name in NAMES.values():
        obj.setEditorMode(name, 0 if name in used else HIDDEN)
    for name in ("SourceFile", "SourceUnit"):
        obj.setEditorMode(name, 0 if obj.SourceType == "File" else HIDDEN)
    linked = obj.SourceType not in ("File", "Stored")
    obj.setEditorMode("SourceObjects", 0 if linked else HIDDEN)
    obj.setEditorMode("SourceType", READ_ONLY)


def convert_old_settings(obj):
    """Converts settings of documents of an earlier version, stored as hidden text, to properties.
    Damaged settings stay, and are reported when the source is read."""
    if obj.SourceType in USED:
        try:
            values = dict(sources.DEFAULTS.get(obj.SourceType, {}))
            if obj.SourceSettings:
                values.update(sources.values_from(obj.SourceSettings))
            with quietly(obj):
                for key in USED.get(obj.SourceType, ()):
                    if key in values:
                        setattr(obj, NAMES[key], values[key])
                obj.SourceSettings = ""
        except (InputProblem, TypeError, ValueError):
            return
    if obj.SourceHash and obj.SourceHash == _signature_of_before(obj):
        with quietly(obj):
            obj.SourceHash = signature(obj)


def read(obj):
    """Returns the poses of the source in the coordinates of this motion. Poses from a file are not
    converted."""
    poses = moved_parts.read(obj.Document, settings_of(obj))
    return inside(obj, poses)


def inside(obj, poses):
    """Converts poses of a source from world coordinates to the coordinates of this motion."""
    if obj.SourceType != "File" and not container_of(obj).isIdentity():
        kept = Poses(poses.times, [from_world(obj, p) for p in poses.placements], note=poses.note)
        kept.moved = poses.moved
        return kept
    return poses


#: Prefix of present signatures. Signatures of earlier versions leave out the settings.
VERSION = "2:"


def signature(obj):
    """Returns a text that identifies the state of a source that is not live, of its settings, and
    of the group in which the poses were stored. Returns "" if there is no source."""
    found = _signature_of_before(obj)
    if not found:
        return ""
    try:
        settings = settings_of(obj)
    except InputProblem as problem:
        return "? {}".format(problem)
    unit = settings.unit if settings.kind == "File" else ""
    return "{}{} {} {}".format(VERSION, found, unit, sorted(settings.values.items()))


def _signature_of_before(obj):
    """Returns the signature of version 1."""
    try:
        found = sources.signature(settings_of(obj))
    except InputProblem as problem:
        return "? {}".format(problem)
    container = container_of(obj)
    if found and obj.SourceType != "File" and not container.isIdentity():
        relative = " relative" if obj.PoseType == "Relative" else ""
        found += " in " + contents.matrices(matrix_of(container)) + relative
    return found


def make_stored(obj):
    """Removes the source of a motion. The motion keeps its present poses."""
    obj.SourceType = "Stored"
    obj.SourceObjects = []
    obj.SourceHash = ""
    show_settings(obj)
