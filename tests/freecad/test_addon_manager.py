# SPDX-License-Identifier: LGPL-2.1-or-later
"""FreeCAD's own Addon Manager installs a copy of this repository into an empty user folder, and the core
from an index on this machine. The workbench then computes.
"""
import json
import os
import pathlib
import shutil
import subprocess
import sys

import pytest

from conftest import ROOT
from package_index import Index, make_wheel

CASE = pathlib.Path(__file__).with_name("addon_manager_case.py")
COMPUTE = """
import json, os
import FreeCAD as App
import numpy
from sweptvolume import core
from sweptvolume.features import envelope, motion
doc = App.newDocument()
box, path = doc.addObject("Part::Box", "Box"), motion.make_motion(doc)
path.Placements = [App.Placement(), App.Placement(App.Vector(30, 0, 0), App.Rotation())]
path.Times = [0.0, 1.0]
doc.recompute()
hull = envelope.make_envelope(doc, [box], path, Resolution=32)
envelope.compute(hull)
report = {"core": core.module().__file__, "workbench": core.__file__, "volume": hull.Mesh.Volume}
report["numpy"] = numpy.__file__
print("\\nreport:" + json.dumps(report), flush=True)
os._exit(0)
"""


FOLDER = """
import json, os
import FreeCAD as App
print("\\nreport:" + json.dumps(App.getUserAppDataDir()), flush=True)
os._exit(0)
"""
INSTALL = """
import json, os
from sweptvolume import core, core_install
assert not core.available()
run = core_install.Installation()
run.run()
assert not run.problem, run.problem
assert core.available() and not run.restart
print("\\nreport:" + json.dumps(core_install.target()), flush=True)
os._exit(0)
"""


@pytest.fixture(scope="module")
def freecad():
    found = shutil.which("freecadcmd") or shutil.which("FreeCADCmd")
    if not found or not shutil.which("git"):
        pytest.skip("FreeCAD or git is not installed")
    return found


@pytest.fixture(scope="module")
def tree(tmp_path_factory):
    """Returns the files that git knows, as a repository of its own with the branch main."""
    listed = ["git", "-C", ROOT, "ls-files", "-z", "--cached", "--others", "--exclude-standard"]
    done = subprocess.run(listed, capture_output=True, text=True)
    if done.returncode != 0:
        pytest.skip("not a git checkout")
    folder = tmp_path_factory.mktemp("published") / "swept-volume"
    for name in filter(None, done.stdout.split("\0")):
        source, target = pathlib.Path(ROOT, name), folder / name
        if source.is_file() and not name.startswith(("cpp/", "tests/")):  # large, not needed here
            target.parent.mkdir(parents=True, exist_ok=True)
            shutil.copy2(source, target)
    git = ["git", "-C", str(folder), "-c", "user.name=test", "-c", "user.email=test@localhost"]
    for words in (["init", "-q", "-b", "main"], ["add", "-A"], ["commit", "-q", "-m", "test"]):
        subprocess.run(git + words, check=True, capture_output=True)
    return folder


@pytest.fixture(scope="module")
def index(tmp_path_factory):
    """Serves the wheels in the folder SWEPT_WHEELS, or the built core."""
    folder = tmp_path_factory.mktemp("index")
    if os.environ.get("SWEPT_WHEELS"):
        return Index(os.environ["SWEPT_WHEELS"])
    from sweptvolume import __version__, core

    if not core.available():
        pytest.skip("the compiled core _swept is not built")
    make_wheel(os.path.dirname(core.module().__file__), __version__, str(folder))
    return Index(str(folder))


def _written(path, text):
    path.write_text(text)
    return path


def report_of(freecad, script, environment):
    done = subprocess.run(
        [freecad, str(script)],
        env=environment,
        stdin=subprocess.DEVNULL,
        capture_output=True,
        encoding="utf-8",
        errors="replace",
        timeout=600,
    )
    lines = [line[7:] for line in done.stdout.splitlines() if line.startswith("report:")]
    assert lines, done.stdout[-3000:] + done.stderr[-3000:]
    return json.loads(lines[-1])


@pytest.fixture
def home(index, tmp_path):
    """Returns the environment for FreeCAD with an empty user folder."""
    home = {**index.environment(), "HOME": str(tmp_path), "LC_ALL": "C.UTF-8"}
    for name in ("FREECAD_USER_HOME", "XDG_DATA_HOME", "XDG_CONFIG_HOME"):
        home.pop(name, None)
    return home


def test_the_addon_manager_installs_workbench_and_core(freecad, tree, index, home, tmp_path):
    done = report_of(freecad, CASE, {**home, "ADDON_SOURCE": str(tree)})
    assert done["failures"] == []
    assert done["packages"] == ["swept_volume"], "of its packages, FreeCAD lacks the core alone"
    assert any(path.endswith(".whl") for path in index.requests)
    assert done["user"].startswith(str(tmp_path))
    made = report_of(freecad, _written(tmp_path / "compute.py", COMPUTE), home)
    assert made["workbench"].startswith(os.path.join(done["user"], "Mod", "SweptVolume"))
    packages = os.path.join(done["user"], "AdditionalPythonPackages")
    assert made["core"].startswith(packages)
    # pip fetches numpy with the core, since it looks only into the target folder. FreeCAD loads its own.
    own = [sys.executable, "-c", "import numpy; print(numpy.__file__)"]
    assert made["numpy"] == subprocess.run(own, capture_output=True, text=True).stdout.strip()
    assert made["volume"] == pytest.approx(40 * 10 * 10, rel=1e-5)


def test_the_workbench_installs_its_core_itself(freecad, tree, index, home, tmp_path):
    mods = pathlib.Path(report_of(freecad, _written(tmp_path / "folder.py", FOLDER), home)) / "Mod"
    mods.mkdir(parents=True, exist_ok=True)
    shutil.copytree(tree, mods / "SweptVolume")
    folder = report_of(freecad, _written(tmp_path / "install.py", INSTALL), home)
    made = report_of(freecad, _written(tmp_path / "compute.py", COMPUTE), home)
    assert os.path.dirname(made["core"]) == folder
    assert made["volume"] == pytest.approx(40 * 10 * 10, rel=1e-5)
