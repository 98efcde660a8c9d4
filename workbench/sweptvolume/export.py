# SPDX-License-Identifier: LGPL-2.1-or-later
"""Writes files from envelopes: STEP and BREP solids and meshes, both through the core.

Each function writes to a temporary file beside the target, checks it, and then renames it. After a
failure the old file is unchanged.
"""
import os

from . import core, targets
from .convert import InputProblem
from .features import solid, status
from .texts import translate

SOLID_SUFFIXES = (".step", ".stp", ".brep", ".brp")
MESH_SUFFIXES = (".stl", ".ply", ".obj", ".off", ".3mf")


def check_target(path):
    """Calls targets.check_target() with the file types of envelopes."""
    targets.check_target(path, SOLID_SUFFIXES + MESH_SUFFIXES)


def is_solid_file(path):
    return os.path.splitext(path)[1].lower() in SOLID_SUFFIXES


def outdated_note(source):
    """Returns a warning for the user if a source is not up to date, otherwise ""."""
    if not status.is_behind(source):
        return ""
    text = translate(
        "SweptVolume",
        '"{0}" is not up to date, so the file will contain the result of its last run. To export '
        'the current state, recompute "{0}" first.',
    )
    return text.format(source.Label)


def request(source, settings=None):
    """Reads the envelope in world coordinates. settings: settings of a solid
    (features.solid.DEFAULTS)."""
    return solid.request_for(source, world=True, **(settings or {}))


def write(req, path, control=None, no_clobber=False):
    """Writes the file, in any thread. Returns a dict: bytes, and for solids the core's report.
    no_clobber: raise InputProblem instead of replacing an existing file. This is for scripts; in
    the window, the file dialog asks whether to replace it."""
    check_target(path)
    if no_clobber and os.path.lexists(path):
        text = translate("SweptVolume", '"{0}" exists already: choose another name.')
        raise InputProblem(text.format(path))
    if is_solid_file(path):
        return req.write(path, control or core.Control())
    core.write_mesh(req.vertices, req.triangles, path)
    return {"file_bytes": os.path.getsize(path), "faces": len(req.triangles)}
