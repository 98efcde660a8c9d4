# SPDX-License-Identifier: LGPL-2.1-or-later
"""Creates the motions of all parts that one driver or simulation moves, and updates them. All parts
are recorded in one run of the source."""
from .. import convert
from ..convert import InputProblem
from ..texts import translate
from ..trajectory import sources
from . import motion as motion_feature
from . import missing, motion_source, moved_parts
from .base import objects_of_kind


def is_of_source(obj, settings):
    """Returns whether a motion has this source, whatever part it records."""
    if obj.SourceType != settings.kind or not obj.SourceObjects:
        return False
    own = motion_source.settings_of(obj)
    return own.objects[0] is settings.objects[0] and own.values == settings.values


def begin(document, settings, parts=()):
    """Returns a moved_parts.Run for a source whose kind is in sources.FROM_JOINTS. The first object
    of settings is the source. parts: objects that are always recorded and must recompute in every
    frame. Raises InputProblem.
    """
    objects = settings.objects[:1] + list(parts)
    return moved_parts.Run(
        document, sources.Settings(settings.kind, objects=objects, **settings.values)
    )


def take(document, settings, run):
    """Returns (motions, notes) for all parts that moved in a finished run. Existing motions of this
    source are updated, missing ones are created. Raises InputProblem if nothing moved."""
    moved = run.moved()
    objects = [root.getSubObject(sub, retType=1) for root, sub in moved]
    notes = [
        translate(
            "SweptVolume",
            '"{0}" is left out, because it is visible only through a link: add its parts '
            "directly to the assembly, not as a link.",
        ).format(convert.label_of(*pair))
        for pair, obj in zip(moved, objects)
        if convert.root_path(obj) != pair
    ]
    named = [(p, o) for p, o in zip(moved, objects) if convert.root_path(o) == p]
    if not named:
        text = translate(
            "SweptVolume", '"{0}" moves no visible part: show the parts, or choose another source.'
        )
        raise InputProblem(text.format(settings.objects[0].Label))
    known = {
        obj.SourceObjects[1]: obj
        for obj in objects_of_kind(document, motion_feature.Motion.KIND)
        if is_of_source(obj, settings) and len(obj.SourceObjects) == 2
    }
    motions = []
    for pair, part in named:
        poses = run.poses_of_part(pair)
        poses.moved = [other for _, other in named if other is not part]
        own = sources.Settings(
            settings.kind, objects=[settings.objects[0], part], **settings.values
        )
        if part in known:
            motion_feature.take(known[part], motion_source.inside(known[part], poses))
            motions.append(known[part])
        else:
            motions.append(motion_feature.motion_of_read(document, own, poses))
            motions[-1].Label = motion_feature.label_for([pair])
    return motions, notes


def of_source(document, settings):
    """Runs the source, and returns the result of take()."""
    return take(document, settings, begin(document, settings).run())


def alike(obj):
    """Returns all motions of the document with the same source as a motion, including itself.
    Returns an empty list if the source moves only one part."""
    if obj.SourceType not in sources.FROM_JOINTS or len(obj.SourceObjects) != 2:
        return []
    settings = motion_source.settings_of(obj)
    found = objects_of_kind(obj.Document, motion_feature.Motion.KIND)
    return [m for m in found if is_of_source(m, settings) and len(m.SourceObjects) == 2]


def reload(obj):
    """Reads the source of a motion again in one run, for all its motions. Raises InputProblem."""
    motions = alike(obj)
    for each in motions:
        missing.check(each)
    run = begin(obj.Document, motion_source.settings_of(obj), [m.SourceObjects[1] for m in motions])
    run.run()
    moved = convert.targets(run.moved())
    for each in motions:
        part = each.SourceObjects[1]
        poses = run.poses_of_part(convert.root_path(part))
        poses.moved = [other for other in moved if other is not part]
        motion_feature.take(each, motion_source.inside(each, poses))


def sources_in(document):
    """Returns the sources that move several parts, each once: the sources of the document's
    motions, and its simulations."""
    found = []
    for obj in objects_of_kind(document, motion_feature.Motion.KIND):
        if obj.SourceType in sources.FROM_JOINTS and obj.SourceObjects:
            settings = motion_source.settings_of(obj)
            if not any(is_of_source(obj, known) for known in found):
                found.append(settings)
    for obj in document.Objects:
        if sources.assembly.is_simulation(obj):
            if not any(known.objects[0] is obj for known in found):
                found.append(sources.Settings("Simulation", objects=[obj]))
    return found
