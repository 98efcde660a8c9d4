# SPDX-License-Identifier: LGPL-2.1-or-later
"""Motion: times and placements kept in the document, linked to where they came from."""
import FreeCAD as App
import numpy as np

from .. import contents, convert, core
from ..convert import InputProblem, global_placement, matrix_of, root_path
from ..texts import mark, translate
from ..trajectory import sources
from ..trajectory.poses import FRAME_HELP, FRAMES, INTERPOLATIONS, Poses, even_times
from . import containers, missing, status
from .base import HIDDEN, READ_ONLY, STALE, Feature, attach_view, kind_of, quietly, set_changed

TYPE = "App::FeaturePython"
UNITS = ["mm", "cm", "m", "in"]
#: Interpolations for which it matters which point of the part goes the way.
PIVOTED = ("Linear", "Spline")

containers.watch()
missing.watch()


class Motion(Feature):
    """Proxy of the motion object."""

    KIND = "SweptVolume::Motion"

    def properties(self):
        return [
            (
                "App::PropertyFloatList",
                "Times",
                "Motion",
                mark("Properties", "Time of each pose (s), growing"),
                None,
                0,
            ),
            (
                "App::PropertyPlacementList",
                "Placements",
                "Motion",
                mark("Properties", "Pose of the moving part at each time"),
                None,
                0,
            ),
            (
                "App::PropertyEnumeration",
                "Interpolation",
                "Motion",
                mark(
                    "Properties",
                    "What the part does between two poses. Linear: straight line and even turn. Screw: "
                    "one screw movement. Spline: smooth through all poses. None: it only stands at them",
                ),
                list(INTERPOLATIONS),
                0,
            ),
            ("App::PropertyEnumeration", "Frame", "Motion", FRAME_HELP, list(FRAMES), 0),
            (
                "App::PropertyVectorDistance",
                "Pivot",
                "Motion",
                mark(
                    "Properties",
                    "Point that goes straight (Linear) or along the spline between two poses, in the "
                    "coordinates that a pose places: of the part where Frame is Absolute",
                ),
                None,
                0,
            ),
            (
                "App::PropertyLinkSubListHidden",
                "Parts",
                "Motion",
                mark(
                    "Properties",
                    "Parts that this motion moves; the path editor shows the first of them",
                ),
                None,
                0,
            ),
            (
                "App::PropertyStringList",
                "Tangents",
                "Motion",
                mark(
                    "Properties",
                    "Spline: what happens at each pose: Auto, Stop, Corner or Given (then by "
                    "Velocities); missing ones are Auto",
                ),
                None,
                0,
            ),
            (
                "App::PropertyVectorList",
                "Velocities",
                "Motion",
                mark("Properties", "Spline: velocity at each pose with the tangent Given (mm/s)"),
                None,
                0,
            ),
            (
                "App::PropertyEnumeration",
                "SourceType",
                "Source",
                mark("Properties", "Where the poses come from"),
                list(sources.KINDS),
                READ_ONLY,
            ),
            (
                "App::PropertyFile",
                "SourceFile",
                "Source",
                mark("Properties", "File of the poses; Reload motion reads it again"),
                None,
                0,
            ),
            (
                "App::PropertyEnumeration",
                "SourceUnit",
                "Source",
                mark("Properties", "Unit of the lengths in the file"),
                list(UNITS),
                0,
            ),
            (
                "App::PropertyLinkListGlobal",
                "SourceObjects",
                "Source",
                mark("Properties", "Objects whose placements or shape give the poses"),
                None,
                0,
            ),
            (
                "App::PropertyString",
                "SourceSettings",
                "Source",
                mark("Properties", "Settings of the source"),
                None,
                HIDDEN,
            ),
            (
                "App::PropertyInteger",
                "Count",
                "Result",
                mark("Properties", "Number of poses"),
                None,
                READ_ONLY,
            ),
            (
                "App::PropertyFloat",
                "Duration",
                "Result",
                mark("Properties", "Last time minus first time (s)"),
                None,
                READ_ONLY,
            ),
            (
                "App::PropertyString",
                "Status",
                "Result",
                mark("Properties", "Whether the motion can be used"),
                None,
                READ_ONLY,
            ),
            (
                "App::PropertyString",
                "Message",
                "Result",
                mark("Properties", "What is to be known of the poses as they were read"),
                None,
                READ_ONLY,
            ),
            (
                "App::PropertyString",
                "SourceHash",
                "Source",
                mark("Properties", "State of the source when it was read"),
                None,
                HIDDEN,
            ),
            (
                "App::PropertyString",
                missing.PROPERTY,
                "Source",
                mark("Properties", "Inputs that were deleted (JSON)"),
                None,
                HIDDEN,
            ),
        ]

    def __init__(self, obj):
        super().__init__(obj)
        obj.Interpolation = "Linear"

    def execute(self, obj):
        """Reads live sources again; others turn stale and wait for Reload motion."""
        try:
            missing.check(obj)
            if sources.is_live(obj.SourceType):
                store(obj, _read(obj), touch=False)
            poses = poses_of(obj)
            look(obj)
        except (InputProblem, core.CoreMissing) as problem:
            set_changed(obj, "Status", str(problem))
            status.tell_users(obj)  # whom FreeCAD passes over now
            raise
        set_changed(obj, "Count", len(poses))
        span = poses.times[-1] - poses.times[0] if len(poses) else 0.0
        set_changed(obj, "Duration", span)

    def onChanged(self, obj, name):
        missing.changed(obj, name)

    def onDocumentRestored(self, obj):
        super().onDocumentRestored(obj)
        if obj.SourceType == "File":  # the file may have changed while the document was closed
            look(obj)
            if obj.Status:
                status.tell_users(obj)


def look(obj):
    """Compares the source with what was read from it and says so in Status."""
    text = "" if len(obj.Placements) else translate("Messages", "no poses yet")
    if obj.SourceHash and obj.SourceHash != _signature(obj):
        text = STALE
    set_changed(obj, "Status", text)


def is_stale(obj):
    """Whether the source of a motion changed since it was read."""
    return is_motion(obj) and obj.Status == STALE


def check_usable(obj):
    """Raises InputProblem where a motion cannot follow its source: its poses are those of before."""
    if len(obj.Placements) and obj.Status not in ("", STALE):
        raise InputProblem('"{}": {}'.format(obj.Label, obj.Status))


def settings_of(obj):
    """The source of a motion object as a plain value."""
    return sources.Settings(
        kind=obj.SourceType,
        file=obj.SourceFile,
        unit=obj.SourceUnit,
        objects=list(obj.SourceObjects),
        extra=obj.SourceSettings,
    )


def is_motion(obj):
    return kind_of(obj) == Motion.KIND


def poses_of(obj):
    """Poses of a motion object; raises InputProblem naming it."""
    try:
        return Poses(obj.Times, obj.Placements, tangents_of(obj), pivot=obj.Pivot)
    except InputProblem as problem:
        raise InputProblem('"{}": {}'.format(obj.Label, problem)) from None


def container_of(obj):
    """Placement of the group that holds a motion, through all groups around it: its poses count there, as the
    line that is drawn does."""
    return global_placement(*root_path(obj))


def parts_of(obj):
    """(root, sub) of the parts that a motion moves, as far as it knows."""
    return convert.pairs_of(obj.Parts)


def set_parts(obj, pairs):
    """The parts that a motion moves, where it knows none yet. No reason to recompute: poses do not follow
    the part."""
    if pairs and not obj.Parts:
        with quietly(obj):
            containers.set_pairs(obj, "Parts", pairs)


def world_poses_of(obj):
    """Poses seen from the document; raises InputProblem naming the motion."""
    return seen_from_document(poses_of(obj), container_of(obj))


def seen_from_document(poses, container):
    """Poses of a group with that placement, as the document sees them."""
    if container.isIdentity():
        return poses
    tangents = [
        (kind, None if v is None else container.Rotation.multVec(v)) for kind, v in poses.tangents
    ]
    placements = [container.multiply(p) for p in poses.placements]
    return Poses(poses.times, placements, tangents, pivot=poses.pivot)


def from_world(obj, placement):
    """A pose of a motion (by its Frame) that is given as seen from the document."""
    container = container_of(obj)
    inside = container.inverse().multiply(placement)
    return inside.multiply(container) if obj.Frame == "Relative" else inside


def _read(obj):
    """Poses of the source as this motion keeps them. A file is read as it is."""
    poses = sources.read(settings_of(obj))
    if obj.SourceType != "File" and not container_of(obj).isIdentity():
        inside = [from_world(obj, p) for p in poses.placements]
        return Poses(poses.times, inside, note=poses.note)
    return poses


def _signature(obj):
    """State of a source that is not live, and of the group in which its poses were put down."""
    found = sources.signature(settings_of(obj))
    container = container_of(obj)
    if found and obj.SourceType != "File" and not container.isIdentity():
        relative = " relative" if obj.Frame == "Relative" else ""
        found += " in " + contents.matrices(matrix_of(container)) + relative
    return found


def tangents_of(obj):
    """(kind, velocity) for each key that has one (trajectory/spline.py)."""
    known = list(obj.Velocities)
    return [(kind, known[k] if k < len(known) else None) for k, kind in enumerate(obj.Tangents)]


def set_tangents(obj, tangents):
    """Stores (kind, velocity) pairs; nothing at all while every key is Auto."""
    plain = all(kind == "Auto" for kind, _ in tangents)
    set_changed(obj, "Tangents", [] if plain else [kind for kind, _ in tangents])
    obj.Velocities = [] if plain else [v or App.Vector() for _, v in tangents]


def words(obj):
    """Texts that change with the way that the motion takes, for hashes."""
    found = [obj.Interpolation, obj.Frame, contents.digest(np.round(obj.Times, 9))]
    found.append(contents.matrices([placement.toMatrix().A for placement in obj.Placements]))
    if obj.Interpolation == "Spline":
        found.append(repr([obj.Tangents, [tuple(v) for v in obj.Velocities]]))
    if obj.Pivot.Length and obj.Interpolation in PIVOTED:
        found.append("pivot {!r}".format(tuple(obj.Pivot)))
    if not container_of(obj).isIdentity():
        found.append(contents.matrices(matrix_of(container_of(obj))))
    return found


def words_of_before(obj):
    """The same as version 1 had them, to know its results again; raises InputProblem where poses meant
    something else."""
    if obj.Pivot.Length:
        raise InputProblem("there was no pivot")
    if not container_of(obj).isIdentity():
        raise InputProblem(
            "poses of a motion in a group that stands elsewhere were those of the world"
        )
    found = [obj.Interpolation, obj.Frame, repr([round(t, 9) for t in obj.Times])]
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


def _same(a, b):
    """Equal up to rounding (== of placements fails after a round trip)."""
    return abs(matrix_of(a) - matrix_of(b)).max() <= 1e-12


def reload_source(obj):
    """Reads the source again, whatever its kind (not for stored poses)."""
    missing.check(obj)
    store(obj, _read(obj))
    obj.SourceHash = _signature(obj)


def make_motion(document, label=None):
    """An empty motion object."""
    obj = document.addObject(TYPE, "Motion")
    Motion(obj)
    obj.Label = label or translate("Messages", "Motion")
    attach_view(obj, "sweptvolume.views.motion_view:MotionView")
    return obj


def motion_from_poses(document, times, placements, interpolation="Linear", frame="Absolute"):
    """A motion object holding the given poses."""
    poses = Poses(times, placements)
    obj = make_motion(document)
    store(obj, poses)
    obj.Interpolation = interpolation
    obj.Frame = frame
    return obj


def motion_from_file(document, path, unit="mm", interpolation="Linear", frame="Absolute"):
    """A motion object filled from a CSV file (`t,tx,ty,tz,qx,qy,qz,qw` or 16 matrix numbers)."""
    poses = sources.read(sources.Settings(kind="File", file=path, unit=unit))
    obj = make_motion(document)
    obj.SourceType = "File"
    obj.SourceFile = path
    obj.SourceUnit = unit
    obj.SourceHash = sources.signature(settings_of(obj))
    store(obj, poses)
    obj.Interpolation = interpolation
    obj.Frame = frame
    return obj


def motion_from_source(document, kind, objects, interpolation="", frame="Absolute", **values):
    """A motion object linked to a source other than a file. interpolation: "" for that of the kind; `values`:
    see trajectory/sources.py."""
    settings = sources.Settings(kind=kind, objects=list(objects), **values)
    poses = sources.read(settings)
    obj = make_motion(document)
    obj.SourceType = kind
    obj.SourceObjects = list(objects)
    obj.SourceSettings = settings.extra
    obj.SourceHash = sources.signature(settings)
    store(obj, poses)
    obj.Interpolation = interpolation or sources.interpolation_of(kind)
    obj.Frame = frame
    return obj


def motion_from_objects(document, objects, interpolation="Linear", step=1.0):
    """A motion object linked to the placements of objects, one pose an object, in order."""
    return motion_from_source(document, "Placements", objects, interpolation, step=step)


def capture(obj, placement, time=None):
    """Adds a placement (seen from the document) as the last pose; the motion becomes one of stored
    poses."""
    times = list(obj.Times)
    if time is None:
        time = times[-1] + 1.0 if times else 0.0
    here = from_world(obj, placement)
    poses = Poses(times + [time], list(obj.Placements) + [here])
    make_stored(obj)
    store(obj, poses)


def make_stored(obj):
    """Cuts a motion off its source: the poses it has are its own."""
    obj.SourceType = "Stored"
    obj.SourceObjects = []
    obj.SourceHash = ""


__all__ = [
    "Motion",
    "capture",
    "container_of",
    "from_world",
    "even_times",
    "is_motion",
    "is_stale",
    "look",
    "make_motion",
    "make_stored",
    "motion_from_file",
    "motion_from_objects",
    "motion_from_source",
    "motion_from_poses",
    "poses_of",
    "reload_source",
    "seen_from_document",
    "set_tangents",
    "settings_of",
    "store",
    "tangents_of",
    "words",
    "words_of_before",
    "world_poses_of",
]
