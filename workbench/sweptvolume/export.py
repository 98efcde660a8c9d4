# SPDX-License-Identifier: LGPL-2.1-or-later
"""Files from envelopes: STEP and BREP through the core, meshes through the core's writer.

Every writer writes beside the target, checks, then renames: an old file survives a failure.
"""
import errno
import os

from . import core
from .convert import InputProblem
from .features import solid
from .texts import translate

SOLID_SUFFIXES = (".step", ".stp", ".brep", ".brp")
MESH_SUFFIXES = (".stl", ".ply", ".obj", ".off", ".3mf")


def check_target(path):
    """Says before any work whether the file can be written; raises InputProblem."""
    folder = os.path.dirname(os.path.abspath(path))
    suffix = os.path.splitext(path)[1].lower()
    if suffix not in SOLID_SUFFIXES + MESH_SUFFIXES:
        raise InputProblem(
            translate("Messages", 'the file type "{0}" is unknown; use one of {1}.').format(
                suffix, " ".join(SOLID_SUFFIXES + MESH_SUFFIXES)
            )
        )
    if not os.path.isdir(folder):
        raise InputProblem(translate("Messages", 'the folder "{0}" does not exist.').format(folder))
    if os.path.isdir(path):
        raise InputProblem(translate("Messages", '"{0}" is a folder.').format(path))
    if not os.access(folder, os.W_OK) or (os.path.exists(path) and not os.access(path, os.W_OK)):
        raise InputProblem(translate("Messages", '"{0}" is write-protected.').format(path))


def is_solid_file(path):
    return os.path.splitext(path)[1].lower() in SOLID_SUFFIXES


def request(source, settings=None):
    """Reads the envelope in world coordinates. settings: of the solid (features.solid.DEFAULTS)."""
    return solid.request_for(source, world=True, **(settings or {}))


def write(req, path, control=None, no_clobber=False):
    """Any thread. Returns a dict: bytes, and for solids the core's report. no_clobber: a file that
    exists is refused, for scripts; the window's file dialog asks by itself."""
    check_target(path)
    if no_clobber and os.path.lexists(path):
        raise InputProblem('"{}": {}'.format(path, os.strerror(errno.EEXIST)))
    if is_solid_file(path):
        return req.write(path, control or core.Control())
    core.write_mesh(req.vertices, req.triangles, path)
    return {"file_bytes": os.path.getsize(path), "faces": len(req.triangles)}
