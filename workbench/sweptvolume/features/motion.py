# SPDX-License-Identifier: LGPL-2.1-or-later
"""Motion: times and placements kept in the document, linked to their source."""
import FreeCAD as App
import numpy as np

from .. import contents, convert, core
from ..convert import InputProblem, matrix_of
from ..texts import translate
from ..trajectory import sources
from ..trajectory.poses import Poses, even_times
from . import containers, missing, motion_source, moved_parts, status, stored_poses
from .base import STALE, Feature, add_object, kind_of, quietly, set_changed
from .motion_frame import container_of, from_world, seen_from_document
from .motion_properties import PROPERTIES, SETTINGS, UNITS
from .motion_source import make_stored, settings_of

TYPE = "App::FeaturePython"
#: Interpolations for which the choice of the pivot matters.
PIVOTED = ("Linear", "Spline")

containers.watch()
missing.watch()


class Motion(Feature):
    """Proxy of the motion object."""

    KIND = "SweptVolume::Motion"

    def properties(self):
        return PROPERTIES + SETTINGS

    def __init__(self, obj):
        super().__init__(obj)
        obj.Interpolation = "Linear"

    def execute(self, obj):
        """Reads live sources again. Motions of other sources become stale and wait for Reload
        motion."""
        try:
            missing.check(obj)
            if sources.is_live(obj.SourceType):
                store(obj, motion_source.read(obj), touch=False)
            poses = poses_of(obj)
            refresh_status(obj)
        except (InputProblem, core.CoreMissing) as problem:
            set_changed(obj, "Status", str(problem))
            status.update_users(obj)  # FreeCAD does not recompute the users of a failed object
            raise
        set_changed(obj, "Count", len(poses))
        span = poses.times[-1] - poses.times[0] if len(poses) else 0.0
        set_changed(obj, "Duration", span)

    def onChanged(self, obj, name):
        missing.changed(obj, name)

    def onDocumentRestored(self, obj):
        from_old_version = "SourceCount" not in obj.PropertiesList
        super().onDocumentRestored(obj)
        if from_old_version:
            motion_source.convert_old_settings(obj)
        motion_source.show_settings(obj)
        if obj.SourceType == "File":  # the file may have changed while the document was closed
            refresh_status(obj)
            if obj.Status:
                status.update_users(obj)


def refresh_status(obj):
    """Compares the source with its state when it was read, and updates Status."""
    text = "" if len(obj.Placements) else translate("SweptVolume", "no poses yet")
    if obj.SourceHash and obj.SourceHash != motion_source.signature(obj):
        text = STALE
    set_changed(obj, "Status", text)


def is_stale(obj):
    """Returns whether the source of a motion has changed since it was read."""
    return is_motion(obj) and obj.Status == STALE


def check_usable(obj):
    """Raises InputProblem if the source of a motion could not be read, so that its poses are out of
    date."""
    if obj.Status not in ("", STALE) and len(obj.Placements):
        raise InputProblem('"{}": {}'.format(obj.Label, obj.Status))


def is_motion(obj):
    return kind_of(obj) == Motion.KIND


def poses_of(obj):
    """Returns the poses of a motion object. Raises InputProblem with its label."""
    try:
        poses = Poses(obj.Times, obj.Placements, tangents_of(obj), pivot=obj.Pivot)
    except InputProblem as problem:
        raise InputProblem('"{}": {}'.format(obj.Label, problem)) from None
    stored = stored_poses.of(obj)
    poses.know_arrays(stored.translations, stored.rotations)
    return poses


def parts_of(obj):
    """Returns (root, sub) of the parts that a motion moves. The list may be empty."""
    return convert.pairs_of(obj.Parts)


def set_parts(obj, pairs, anew=False):
    """Sets the parts that a motion moves, if it has none yet or if `anew` is true. Causes no
    recompute, because poses do not depend on the part."""
    if pairs and (anew or not obj.Parts):
        with quietly(obj):
            containers.set_pairs(obj, "Parts", pairs)


def world_poses_of(obj):
    """Returns the poses in world coordinates. Raises InputProblem with the label of the motion."""
    return seen_from_document(poses_of(obj), container_of(obj))


def tangents_of(obj):
    """Returns (kind, velocity) for each key that has a tangent (trajectory/spline.py)."""
    known = list(obj.Velocities)
    return [(kind, known[k] if k < len(known) else None) for k, kind in enumerate(obj.Tangents)]


def set_tangents(obj, tangents):
    """Stores (kind, velocity) pairs. Stores nothing while every key is Auto."""
    plain = all(kind == "Auto" for kind, _ in tangents)
    set_changed(obj, "Tangents", [] if plain else [kind for kind, _ in tangents])
    obj.Velocities = [] if plain else [v or App.Vector() for _, v in tangents]


def words(obj):
    """Returns texts that identify the poses and the interpolation of a motion, for hashes."""
    found = [obj.Interpolation, obj.PoseType] + stored_poses.of(obj).words()
    if obj.Interpolation == "Spline":
        found.append(repr([obj.Tangents, [tuple(v) for v in obj.Velocities]]))
    if obj.Pivot.Length and obj.Interpolation in PIVOTED:
        found.append("pivot {!r}".format(tuple(obj.Pivot)))
    if not container_of(obj).isIdentity():
        found.append(contents.matrices(matrix_of(container_of(obj))))
    return found


def words_of_before(obj):
    """Returns the texts of version 1, to recognise its results. Raises InputProblem if poses had
    another meaning then."""
    if obj.Pivot.Length:
        raise InputProblem("there was no pivot")
    if not container_of(obj).isIdentity():
        raise InputProblem(
            "poses of a motion in a group that stands elsewhere were those of the world"
        )
    found = [obj.Interpolation, obj.PoseType, repr([round(t, 9) for t in obj.Times])]
    for placement in obj.Placements:
        found.append(np.array2string(matrix_of(placement), precision=9))
    if obj.Interpolation == "Spline":
        found.append(repr([obj.Tangents, [tuple(v) for v in obj.Velocities]]))
    return found


def store(obj, poses, touch=True):
    """Writes poses into a motion object."""
    times, placements = list(poses.times), list(poses.placements)
    same = list(obj.Times) == times and len(obj.Placements) == len(placements)
    same = same and all(_same(a, b) for a, b in zip(obj.Placements, placements))
    if touch or not same:
        obj.Times = times
        obj.Placements = placements
    set_changed(obj, "Message", poses.note)
    set_changed(obj, "MovedToo", poses.moved)


def _same(a, b):
    """Returns whether two placements are equal up to rounding. (== of placements fails after saving
    and loading.)"""
    return abs(matrix_of(a) - matrix_of(b)).max() <= 1e-12


def change_source(obj, values):
    """Changes the settings of a motion that has a source, with the values of motion_from_source().
    Does not read the source."""
    motion_source.keep(obj, settings_of(obj).with_values(values))


def reload_source(obj):
    """Reads the source of a motion again (any kind except stored poses)."""
    missing.check(obj)
    take(obj, motion_source.read(obj))


def take(obj, poses):
    """Stores poses that were read from the source of a motion. poses: in the coordinates of the
    motion."""
    store(obj, poses)
    obj.SourceHash = motion_source.signature(obj)


def make_motion(document, label=None):
    """Creates an empty motion object."""
    label = label or translate("SweptVolume", "Motion")
    view = "sweptvolume.views.motion_view:MotionView"
    return add_object(document, TYPE, "Motion", Motion, label, {}, view)


def motion_from_poses(document, times, placements, interpolation="Linear", frame="Absolute"):
    """Creates a motion object with the given poses. The property Pivot stays at the origin."""
    poses = Poses(times, placements)
    obj = make_motion(document)
    store(obj, poses)
    obj.Interpolation = interpolation
    obj.PoseType = frame
    return obj


def motion_from_file(document, path, unit="mm", interpolation="Linear", frame="Absolute"):
    """Creates a motion object from a CSV file (`t,tx,ty,tz,qx,qy,qz,qw` or 16 matrix numbers)."""
    settings = sources.Settings(kind="File", file=path, unit=unit)
    return _motion_of(document, settings, interpolation, frame)


def motion_from_source(document, kind, objects, interpolation="", frame="Absolute", **values):
    """Creates a motion object linked to a source other than a file. interpolation: "" means the
    default of the kind. `values`: see trajectory/sources.py."""
    values = dict(sources.DEFAULTS.get(kind, {}), **values)
    settings = sources.Settings(kind=kind, objects=objects, **values)
    kept = interpolation or sources.interpolation_of(kind)
    return _motion_of(document, settings, kept, frame)


def _motion_of(document, settings, interpolation, frame):
    obj = motion_of_read(document, settings, moved_parts.read(document, settings))
    obj.Interpolation = interpolation
    obj.PoseType = frame
    return obj


def motion_of_read(document, settings, poses):
    """Creates a motion of a source that was just read. poses: in world coordinates."""
    obj = make_motion(document)
    motion_source.keep(obj, settings)
    obj.SourceHash = motion_source.signature(obj)
    store(obj, poses)
    obj.Interpolation = sources.interpolation_of(settings.kind)
    if settings.kind in sources.FROM_JOINTS:  # the part that was recorded
        set_parts(obj, [convert.root_path(settings.objects[1])])
    return obj


def label_for(pairs):
    """Returns a label for a new motion of these parts, or None for the default label."""
    if not pairs:
        return None
    return translate("SweptVolume", "Motion of {0}").format(convert.label_of(*pairs[0]))


def motion_from_objects(document, objects, interpolation="Linear", step=1.0):
    """Creates a motion object linked to the placements of objects: one pose for each object, in
    order."""
    return motion_from_source(document, "Placements", objects, interpolation, step=step)


def capture(obj, placement, time=None):
    """Adds a placement (in world coordinates) as the last pose. If the motion has a source, it
    loses the source."""
    times = list(obj.Times)
    if time is None:
        time = times[-1] + 1.0 if times else 0.0
    here = from_world(obj, placement)
    poses = Poses(times + [time], list(obj.Placements) + [here])
    make_stored(obj)
    store(obj, poses)


__all__ = [
    "capture",
    "change_source",
    "check_usable",
    "container_of",
    "even_times",
    "from_world",
    "is_motion",
    "is_stale",
    "label_for",
    "make_motion",
    "make_stored",
    "Motion",
    "motion_from_file",
    "motion_from_objects",
    "motion_from_poses",
    "motion_from_source",
    "motion_of_read",
    "parts_of",
    "poses_of",
    "refresh_status",
    "reload_source",
    "seen_from_document",
    "set_parts",
    "set_tangents",
    "settings_of",
    "STALE",
    "store",
    "take",
    "tangents_of",
    "UNITS",
    "words",
    "words_of_before",
    "world_poses_of",
]
