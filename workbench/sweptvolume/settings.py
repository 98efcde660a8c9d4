# SPDX-License-Identifier: LGPL-2.1-or-later
"""Preferences of the user (Edit > Preferences > Swept Volume). The default values are the same as
on the preferences page."""
import FreeCAD as App

PATH = "User parameter:BaseApp/Preferences/Mod/SweptVolume"


def _group():
    return App.ParamGet(PATH)


def resolution():
    """Returns the number of cells along the longest side of a new envelope."""
    return max(8, _group().GetInt("Resolution", 128))


def tolerance():
    """Returns the tolerance for the simplification of a new envelope (mm)."""
    return max(0.0, _group().GetFloat("Tolerance", 0.0))


def backend():
    """Returns the backend of a new envelope, by its name in the property."""
    names = ["Auto", "CPU", "GPU"]
    return names[min(max(_group().GetInt("Backend", 0), 0), 2)]


def threads():
    """Returns the number of threads of a run; 0: all cores."""
    return min(max(_group().GetInt("Threads", 0), 0), 4096)


def memory_limit():
    """Returns the memory that a run may use (MiB); 0: three quarters of the free memory."""
    return max(0, _group().GetInt("MemoryLimit", 0))


def page_template(pdf=False):
    """Returns the template file of HTML or PDF reports, or "" for the built-in template."""
    return _group().GetString("PrintTemplate" if pdf else "PageTemplate", "")


def preview_resolution():
    """Returns the number of cells along the longest side of the coarse envelope in the motion
    editor."""
    return max(8, _group().GetInt("PreviewResolution", 128))


def preview():
    """Returns whether the motion editor shows the coarse envelope."""
    return _group().GetBool("Preview", True)
