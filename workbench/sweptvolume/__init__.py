# SPDX-License-Identifier: LGPL-2.1-or-later
"""Swept volumes in FreeCAD: motions, envelopes, solids.

Order of imports, left never imports right:
core_texts, quantities <- core <- core_paths, core_previews <- convert <- trajectory <- features
<- export, runner <- views <- panels <- commands.
Everything up to `export` works without a GUI.
"""
import os

__version__ = "0.1.0"

#: The repository or the folder into which it was installed as a FreeCAD module.
ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.realpath(__file__))))


def resource(*names):
    """Absolute path of something below resources/."""
    return os.path.join(ROOT, "resources", *names)


def icon(name):
    """Absolute path of an icon, the form that works in every FreeCAD version."""
    return resource("icons", name + ".svg")
