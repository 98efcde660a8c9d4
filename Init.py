# SPDX-License-Identifier: LGPL-2.1-or-later
"""Headless side of the workbench: puts workbench/ on the path and registers the tests."""
import os
import sys

import FreeCAD


def _module_directory(known):
    """Returns the folder of this file, or None. known: the path of this file, or "".

    FreeCAD runs this file with exec(), so __file__ is not defined. Most versions of FreeCAD store its
    path in InstallFile. Otherwise, the folder is the one in sys.path that contains the package.
    """
    folders = [os.path.dirname(known)] if known else []
    for folder in folders + [f for f in sys.path if f]:
        if os.path.isfile(os.path.join(folder, "workbench", "sweptvolume", "__init__.py")):
            return folder
    return None


_folder = _module_directory(locals().get("InstallFile", ""))
if _folder is None:
    FreeCAD.Console.PrintError("Swept Volume: the folder workbench/sweptvolume was not found.\n")
else:
    _path = os.path.join(_folder, "workbench")
    if _path not in sys.path:
        sys.path.append(_path)
    FreeCAD.__unit_test__ += ["TestSweptVolumeApp"]
