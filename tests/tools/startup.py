#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Measures what the workbench adds to the start of FreeCAD: CPU seconds from the command until the window
is shown, with and without the workbench, in turn.

    python3 tests/tools/startup.py [TIMES]      (5)
"""
import os
import pathlib
import resource
import shutil
import statistics
import subprocess
import sys
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parents[2]
#: Ends FreeCAD as soon as its event loop runs.
WINDOW = """
import os
from PySide import QtCore
QtCore.QTimer.singleShot(0, lambda: os._exit(0))
"""
CONSOLE = "import os; os._exit(0)\n"


def started(command, home):
    """Returns the CPU seconds and wall seconds of one start."""
    environment = {**os.environ, "FREECAD_USER_HOME": home, "LC_ALL": "C.UTF-8"}
    for name in ("PYTHONPATH", "DISPLAY"):
        environment.pop(name, None)
    before, wall = resource.getrusage(resource.RUSAGE_CHILDREN), time.perf_counter()
    subprocess.run(
        command, env=environment, stdin=subprocess.DEVNULL, capture_output=True, timeout=300
    )
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    used = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
    return used, time.perf_counter() - wall


def main(times):
    window, console = shutil.which("freecad"), shutil.which("freecadcmd")
    if not (window and console and shutil.which("xvfb-run")):
        print("SKIPPED: freecad, freecadcmd and xvfb-run are needed")
        return 0
    with tempfile.TemporaryDirectory() as folder:
        homes = {"without": os.path.join(folder, "a"), "with": os.path.join(folder, "b")}
        for name, home in homes.items():
            os.makedirs(os.path.join(home, "Mod"))
            shutil.copy(ROOT / "resources/demo-user.cfg", os.path.join(home, "user.cfg"))
            if name == "with":
                os.symlink(ROOT, os.path.join(home, "Mod", "SweptVolume"))
        script = os.path.join(folder, "quit.py")
        virtual = ["xvfb-run", "-a", "-s", "-screen 0 1400x900x24"]
        for what, command, text in (
            ("console", [console, script], CONSOLE),
            ("window", virtual + [window, script], WINDOW),
        ):
            pathlib.Path(script).write_text(text)
            found = {name: [] for name in homes}
            for n in range(times + 1):
                for name, home in homes.items():
                    seconds = started(command, home)
                    if n:  # the first start of each kind only fills caches
                        found[name].append(seconds)
            for name, seconds in found.items():
                used = [s[0] for s in seconds]
                print(
                    f"{what:8}{name:8} processor: median {statistics.median(used):.2f} s, "
                    f"least {min(used):.2f} s; wall: median "
                    f"{statistics.median(s[1] for s in seconds):.2f} s",
                    flush=True,
                )
    return 0


if __name__ == "__main__":
    sys.exit(main(int(sys.argv[1]) if len(sys.argv) > 1 else 5))
