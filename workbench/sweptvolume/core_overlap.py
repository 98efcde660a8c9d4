# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the core knows of parts that stand still against each other."""
from . import core
from .core import CoreError, errors, module

#: Finding of the core where a shared volume cannot be told.
NOT_KNOWN = "NoSharedVolume"


def overlap(parts, options, control):
    """Each two of parts (name, vertices, triangles, chord error in mm), all in one world: (report (dict),
    [(vertices, triangles) that a pair shares, both empty where it shares nothing]). options: as the
    module's overlap(). Raises CoreError."""
    with errors():
        return module().overlap(parts, run=control.context, **options)


def shared(first, second, options, control):
    """The same of two parts alone: (row of the report's pair (dict), vertices, triangles). Raises CoreError
    where what they share cannot be told as well."""
    report, meshes = overlap([first, second], options, control)
    for finding in report["warnings"]:
        if finding["code"] == NOT_KNOWN:
            text = core.said(NOT_KNOWN, finding["text"])
            raise CoreError("InvalidInput", NOT_KNOWN, text)
    return (report["pairs"][0], *meshes[0])
