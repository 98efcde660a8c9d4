# SPDX-License-Identifier: LGPL-2.1-or-later
"""Finds and imports the compiled module `_swept`; no other module does so.

Searches the folder in the environment variable SWEPT_CORE, then build/python of the repository,
then the folders of the Addon Manager for Python packages, then the ordinary Python path.
"""
import importlib
import os
import sys

import FreeCAD as App

from . import ROOT, __version__
from .texts import translate


def package_folders():
    """Returns the folders in which the Addon Manager of this FreeCAD keeps Python packages. The
    folder into which it installs comes first. Since FreeCAD 0.21, that is a folder for each version
    of Python."""
    common = os.path.join(App.getUserAppDataDir(), "AdditionalPythonPackages")
    own = os.path.join(common, "py{}{}".format(*sys.version_info[:2]))
    first = tuple(int(number) for number in App.Version()[:2]) >= (0, 21)
    return [own, common] if first else [common, own]


def searched_first():
    """Returns the folders that are searched before those of installed packages."""
    given = os.environ.get("SWEPT_CORE")
    return ([given] if given else []) + [os.path.join(ROOT, "build", "python")]


def folders():
    return searched_first() + package_folders()


def holds_core(folder):
    """Returns whether a folder contains the compiled module, for any version of Python."""
    names = os.listdir(folder) if os.path.isdir(folder) else []
    return any(n.startswith("_swept") and n.endswith((".so", ".pyd")) for n in names)


def _load_from(folder):
    """Imports _swept from one folder and then removes that folder from the path."""
    sys.path.insert(0, folder)
    try:
        return importlib.import_module("_swept")
    finally:
        sys.path.remove(folder)


def find():
    tried = []
    for folder in folders():
        if not holds_core(folder):
            tried.append("{}: not there".format(folder))
            continue
        try:
            return _load_from(folder), None
        except ImportError as error:
            tried.append("{}: {}".format(folder, error))
    try:
        return importlib.import_module("_swept"), None
    except ImportError as error:
        tried.append("Python path: {}".format(error))
    return None, tried


def missing_text(tried):
    python = "{}.{}".format(*sys.version_info[:2])
    return translate(
        "SweptVolume",
        "The compiled core of Swept Volume (_swept, for Python {0}) cannot be loaded.\n"
        "Choose Swept Volume > Install the core, or build the core in the folder {1}:\n"
        "    cmake --preset release && cmake --build build\n"
        ".ci/packages.txt lists the packages that the build needs. If the core is elsewhere, set "
        "the environment variable SWEPT_CORE to its folder.\n"
        "FreeCAD looked for the core in:\n"
        "  {2}",
    ).format(python, ROOT, "\n  ".join(tried))


def other_version_text(found):
    return translate(
        "SweptVolume",
        "The compiled core of Swept Volume in {0} has version {1}, but the workbench "
        "has version {2}. Choose Swept Volume > Install the core, or build the core again "
        "in the folder {3}:\n"
        "    cmake --preset release && cmake --build build",
    ).format(found.__file__, found.__version__, __version__, ROOT)
