# SPDX-License-Identifier: LGPL-2.1-or-later
"""Swept volumes in FreeCAD: motions, envelopes, solids.

Order of imports (a module never imports one to its right):
core_texts, quantities <- core <- core_paths, core_previews <- convert <- trajectory <- features
<- export, runner <- views <- panels <- commands.
Everything up to `export` works without a GUI.
"""
import os

__version__ = "0.1.0"

#: Root of the repository, or of the installed FreeCAD module.
ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.realpath(__file__))))


def resource(*names):
    """Returns the absolute path of a file below resources/."""
    return os.path.join(ROOT, "resources", *names)


def icon(name):
    """Returns the absolute path of an icon, a form that every FreeCAD version accepts."""
    return resource("icons", name + ".svg")
