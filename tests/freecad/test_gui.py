# SPDX-License-Identifier: LGPL-2.1-or-later
"""Runs the window scenarios of gui/ in a real FreeCAD on a virtual display.

SWEPT_SHOTS=DIR keeps the screenshots there.
"""
import glob
import os
import shutil
import subprocess
import tempfile

import pytest

import fresh_profile
from conftest import ROOT

HERE = os.path.join(ROOT, "tests", "freecad", "gui")
SCENARIOS = sorted(n for n in os.listdir(HERE) if n.endswith(".py") and n != "driver.py")


def _freecad():
    return shutil.which("freecad") or shutil.which("FreeCAD")


@pytest.mark.skipif(not shutil.which("xvfb-run"), reason="xvfb-run is not installed")
@pytest.mark.skipif(not _freecad(), reason="FreeCAD with a window is not installed")
@pytest.mark.parametrize("scenario", SCENARIOS)
def test_scenario(scenario):
    _run(scenario)


def _plug_ins_for_svg():
    """Returns the folders of all Qt plug-ins on this system that read SVG files."""
    found = glob.glob("/usr/lib/*/qt*/plugins/*/libqsvg*.so")
    return sorted({os.path.dirname(path) for path in found})


@pytest.mark.skipif(not shutil.which("xvfb-run"), reason="xvfb-run is not installed")
@pytest.mark.skipif(not _freecad(), reason="FreeCAD with a window is not installed")
def test_icons_are_drawn_without_the_plug_ins_for_svg():
    """Icons are drawn also if Qt finds no plug-in for SVG: the test hides them in a file system of its
    own."""
    folders = _plug_ins_for_svg()
    script = "; ".join(["set -e"] + ["mount -t tmpfs none " + f for f in folders] + ['exec "$@"'])
    # Root does not need the option, and a chroot refuses it.
    mapped = ["--map-root-user"] if os.geteuid() else []
    apart = ["unshare", "--mount"] + mapped + ["sh", "-c", script, "sh"]
    if not folders or subprocess.run(apart + ["true"], capture_output=True).returncode:
        pytest.skip("Qt has no such plug-ins here, or this user may not mount anything")
    _run("tree.py", apart)


def _run(scenario, before=()):
    """Runs a scenario. before: a command that is put before FreeCAD's command."""
    from sweptvolume import core

    if not core.available():
        pytest.skip("the compiled core _swept is not built")
    with tempfile.TemporaryDirectory() as home:
        os.makedirs(os.path.join(home, "Mod"))
        os.symlink(ROOT, os.path.join(home, "Mod", "SweptVolume"))
        fresh_profile.write(home, "Dark" if scenario == "dark.py" else "")
        environment = dict(os.environ, FREECAD_USER_HOME=home)
        environment.pop("DISPLAY", None)
        environment.pop("PYTHONPATH", None)
        display = str(100 + os.getpid() % 800)  # two test runs may overlap
        screen = ["-a", "-n", display, "-s", "-screen 0 1400x900x24"]
        command = ["xvfb-run"] + screen + list(before) + [_freecad()]
        done = subprocess.run(
            command + [os.path.join(HERE, scenario)],
            env=environment,
            stdin=subprocess.DEVNULL,
            capture_output=True,
            encoding="utf-8",  # whatever the locale of this process is
            errors="replace",
            timeout=900,  # s, for runs that hang; long enough for a busy machine
        )
    print(done.stdout[-4000:])
    assert done.returncode == 0, done.stdout[-2000:] + done.stderr[-4000:]
    assert scenario + " passed" in done.stdout.splitlines(), "another file's scenario was run"
    # An exception in the code of a button is only printed.
    for words in ("Traceback", "already deleted"):
        assert words not in done.stdout + done.stderr, done.stdout + done.stderr
