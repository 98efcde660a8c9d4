# SPDX-License-Identifier: LGPL-2.1-or-later
"""Preferences of the user (Edit > Preferences > Swept Volume), with the defaults of the page."""
import FreeCAD as App

PATH = "User parameter:BaseApp/Preferences/Mod/SweptVolume"


def _group():
    return App.ParamGet(PATH)


def resolution():
    """Cells along the longest side of a new envelope."""
    return max(8, _group().GetInt("Resolution", 128))


def tolerance():
    """Simplification of a new envelope (mm)."""
    return max(0.0, _group().GetFloat("Tolerance", 0.0))


def backend():
    """Backend of a new envelope, by its name in the property."""
    names = ["Auto", "CPU", "GPU"]
    return names[min(max(_group().GetInt("Backend", 0), 0), 2)]


def threads():
    """Threads of a run; 0: all cores."""
    return min(max(_group().GetInt("Threads", 0), 0), 4096)


def memory_limit():
    """Memory a run may take (MiB); 0: three quarters of what is free."""
    return max(0, _group().GetInt("MemoryLimit", 0))


def page_template(pdf=False):
    """File with the template of reports, of HTML or of PDF; "": the workbench's own."""
    return _group().GetString("PrintTemplate" if pdf else "PageTemplate", "")


def preview_resolution():
    """Cells of the coarse envelope that follows the path editor."""
    return max(8, _group().GetInt("PreviewResolution", 128))


def preview():
    """Whether the path editor shows the coarse envelope."""
    return _group().GetBool("Preview", True)
