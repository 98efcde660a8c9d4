# SPDX-License-Identifier: LGPL-2.1-or-later
"""Functions of the core for parts that stand still."""
from . import core
from .core import CoreError, errors, module

#: Code of the core's finding for a shared volume that cannot be computed.
NOT_KNOWN = "NoSharedVolume"


def overlap(parts, options, control):
    """Compares all pairs of parts (name, vertices, triangles, chord error in mm) in world
    coordinates. Returns the report (dict), and for each pair the shared solid (vertices,
    triangles), with empty arrays if there is none. options: those of the module's overlap().
    Raises CoreError."""
    with errors():
        return module().overlap(parts, run=control.context, **options)


def shared(first, second, options, control):
    """Compares two parts only. Returns the row of the pair in the report (dict), vertices and
    triangles. Also raises CoreError if the shared volume cannot be computed."""
    report, meshes = overlap([first, second], options, control)
    for finding in report["warnings"]:
        if finding["code"] == NOT_KNOWN:
            text = core.said(NOT_KNOWN, finding["text"])
            raise CoreError("InvalidInput", NOT_KNOWN, text)
    return (report["pairs"][0], *meshes[0])
