# SPDX-License-Identifier: LGPL-2.1-or-later
"""Runs the window scenarios of gui/ in a real FreeCAD on a virtual display.

SWEPT_SHOTS=DIR keeps the screenshots there.
"""
import os
import shutil
import subprocess
import tempfile

import pytest

from conftest import ROOT

HERE = os.path.join(ROOT, "tests", "freecad", "gui")
SCENARIOS = sorted(n for n in os.listdir(HERE) if n.endswith(".py") and n != "driver.py")


def _freecad():
    return shutil.which("freecad") or shutil.which("FreeCAD")


def _profile(home, dark):
    """The settings of a fresh FreeCAD that asks nothing at its start."""
    with open(os.path.join(ROOT, "resources", "demo-user.cfg"), encoding="utf-8") as file:
        text = file.read()
    if dark:
        style = '<FCParamGroup Name="MainWindow"><FCText Name="StyleSheet">Behave-dark.qss</FCText>'
        group = '<FCParamGroup Name="Preferences">'
        assert text.count(group) == 1
        text = text.replace(group, group + style + "</FCParamGroup>")
    with open(os.path.join(home, "user.cfg"), "w", encoding="utf-8") as out:
        out.write(text)


@pytest.mark.skipif(not shutil.which("xvfb-run"), reason="xvfb-run is not installed")
@pytest.mark.skipif(not _freecad(), reason="FreeCAD with a window is not installed")
@pytest.mark.parametrize("scenario", SCENARIOS)
def test_scenario(scenario):
    from sweptvolume import core

    if not core.available():
        pytest.skip("the compiled core _swept is not built")
    with tempfile.TemporaryDirectory() as home:
        os.makedirs(os.path.join(home, "Mod"))
        os.symlink(ROOT, os.path.join(home, "Mod", "SweptVolume"))
        _profile(home, dark=scenario == "dark.py")
        environment = dict(os.environ, FREECAD_USER_HOME=home)
        environment.pop("DISPLAY", None)
        environment.pop("PYTHONPATH", None)
        display = str(100 + os.getpid() % 800)  # two of these may run side by side
        screen = ["-a", "-n", display, "-s", "-screen 0 1400x900x24"]
        command = ["xvfb-run"] + screen + [_freecad()]
        done = subprocess.run(
            command + [os.path.join(HERE, scenario)],
            env=environment,
            stdin=subprocess.DEVNULL,
            capture_output=True,
            encoding="utf-8",  # the locale of this process is FreeCAD's business
            errors="replace",
            timeout=300,
        )
    print(done.stdout[-4000:])
    assert done.returncode == 0, done.stdout[-2000:] + done.stderr[-4000:]
    assert "passed" in done.stdout
    # An error in a button's own code is only printed.
    assert "Traceback" not in done.stdout + done.stderr, done.stdout + done.stderr
