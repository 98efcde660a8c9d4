# SPDX-License-Identifier: LGPL-2.1-or-later
"""Finds a Python interpreter that can run a module. FreeCAD's own executable cannot."""
import contextlib
import functools
import os
import shutil
import subprocess
import sys

import FreeCAD as App

#: Version of FreeCAD's Python, for which compiled modules must be built.
VERSION = "{}.{}".format(*sys.version_info[:2])
#: Options of subprocess that keep a console window from appearing on Windows.
HIDDEN = {"creationflags": subprocess.CREATE_NO_WINDOW} if os.name == "nt" else {}


@functools.lru_cache(maxsize=1)
def find():
    """Returns the path of a Python interpreter of FreeCAD's version, or None. May take a second:
    asks each interpreter for its version."""
    version = "python" + VERSION
    folders = [os.path.dirname(sys.executable or ""), os.path.join(sys.exec_prefix, "bin")]
    folders += [sys.exec_prefix, os.path.join(App.getHomePath(), "bin")]
    found = [shutil.which(version, path=folder) for folder in folders if folder]
    found += [shutil.which(version)]
    found += [shutil.which(name, path=f) for f in folders if f for name in ("python3", "python")]
    for path in filter(None, found):
        words = [path, "-c", "import sys; print('{}.{}'.format(*sys.version_info))"]
        with contextlib.suppress(OSError, subprocess.SubprocessError):
            answer = subprocess.run(words, capture_output=True, text=True, timeout=30, **HIDDEN)
            if answer.stdout.strip() == VERSION:
                return path
    return None
