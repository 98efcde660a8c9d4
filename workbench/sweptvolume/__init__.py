# SPDX-License-Identifier: LGPL-2.1-or-later
"""Swept volumes in FreeCAD: motions, envelopes, solids.

Order of imports (a module never imports one to its right):
core_texts, core_search, quantities <- core <- core_paths, core_previews <- convert <- trajectory <- features
<- export, runner <- views <- panels <- commands.
Everything up to `export` works without a GUI.
"""
import os
import re

#: Root of the repository, or of the installed FreeCAD module.
ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.realpath(__file__))))


def _version():
    """Returns the version in package.xml, the only file that states it."""
    with open(os.path.join(ROOT, "package.xml"), encoding="utf-8") as file:
        return re.search("<version>(.*)</version>", file.read())[1]


__version__ = _version()


def resource(*names):
    """Returns the absolute path of a file below resources/."""
    return os.path.join(ROOT, "resources", *names)


def icon(name):
    """Returns the path of an icon. It is absolute, because every FreeCAD version accepts that."""
    return resource("icons", name + ".svg")
