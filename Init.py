# SPDX-License-Identifier: LGPL-2.1-or-later
"""Headless side of the workbench: puts workbench/ on the path and registers the tests."""
import os
import sys

import FreeCAD


def _module_directory():
    """FreeCAD runs this file by exec, where __file__ is not defined; the code object knows its file."""
    here = os.path.dirname(os.path.abspath(sys._getframe().f_code.co_filename))
    for folder in [here] + sys.path:
        if os.path.isfile(os.path.join(folder, "workbench", "sweptvolume", "__init__.py")):
            return folder
    return None


_folder = _module_directory()
if _folder is None:
    FreeCAD.Console.PrintError("Swept Volume: the folder workbench/sweptvolume was not found.\n")
else:
    _path = os.path.join(_folder, "workbench")
    if _path not in sys.path:
        sys.path.append(_path)
    FreeCAD.__unit_test__ += ["TestSweptVolumeApp"]
