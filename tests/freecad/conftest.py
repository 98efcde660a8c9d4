# SPDX-License-Identifier: LGPL-2.1-or-later
"""Lets plain Python import FreeCAD with a private profile that holds this module and nothing else."""
import os
import sys
import tempfile

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.realpath(__file__))))


def _private_profile():
    home = tempfile.mkdtemp(prefix="swept-freecad-")
    os.makedirs(os.path.join(home, "Mod"))
    os.symlink(ROOT, os.path.join(home, "Mod", "SweptVolume"))
    return home


os.environ.setdefault("FREECAD_USER_HOME", _private_profile())
for _folder in ("/usr/lib/freecad-python3/lib", "/usr/share/freecad/Ext"):
    if os.path.isdir(_folder) and _folder not in sys.path:
        sys.path.append(_folder)
sys.path.insert(0, os.path.dirname(os.path.realpath(__file__)))


def _add_other_workbenches():
    """Adds Debian's folders of workbenches (CAM, Draft) to the path: FreeCAD as a module of Python does
    not look there."""
    for folder in ("/usr/share/freecad/Mod", "/usr/lib/freecad/Mod"):
        names = sorted(os.listdir(folder)) if os.path.isdir(folder) else []
        found = [os.path.join(folder, name) for name in names]
        known = {os.path.realpath(path) for path in sys.path}
        sys.path.extend(path for path in found if os.path.realpath(path) not in known)


try:
    import FreeCAD  # noqa: F401 (runs our Init.py, which puts workbench/ on the path)

    _add_other_workbenches()
except ImportError as error:
    # Not skipped silently: pytest prints the reason and every file that it leaves out.
    collect_ignore_glob = ["test_*.py"]
    print("tests/freecad skipped: FreeCAD cannot be imported ({})".format(error))
