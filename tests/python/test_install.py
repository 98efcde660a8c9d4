# SPDX-License-Identifier: LGPL-2.1-or-later
"""`cmake --install`: afterwards FreeCAD's folder Mod contains a complete workbench."""
import os
import pathlib
import shutil
import subprocess

import pytest

import _swept

SCRIPT = """
import FreeCAD
from sweptvolume import core
with open({done!r}, "w") as file:
    file.write(core.module().__file__)
"""


def install(root, component, prefix):
    build = pathlib.Path(os.environ.get("SWEPT_BUILD", root / "build"))
    if not (build / "cmake_install.cmake").exists():
        pytest.skip(f"no build in {build}")
    command = ["cmake", "--install", build, "--component", component, "--prefix", prefix]
    subprocess.run(list(map(str, command)), check=True, capture_output=True)
    return prefix


@pytest.fixture(scope="module")
def mod(root, tmp_path_factory):
    prefix = tmp_path_factory.mktemp("user") / ".local/share/FreeCAD"
    return install(root, "workbench", prefix) / "Mod/SweptVolume"


def test_manual_and_completions_are_installed_as_the_program_prints_them(root, tmp_path):
    share = install(root, "program", tmp_path) / "share"
    pages = {
        "man/man1/swept.1": ["manual"],
        "bash-completion/completions/swept": ["completion", "bash"],
        "zsh/site-functions/_swept": ["completion", "zsh"],
        "zsh/vendor-completions/_swept": ["completion", "zsh"],
        "fish/vendor_completions.d/swept.fish": ["completion", "fish"],
    }
    for page, words in pages.items():
        done = subprocess.run([tmp_path / "bin/swept", *words], capture_output=True, check=True)
        assert (share / page).read_bytes() == done.stdout, page
    assert {p for p in share.rglob("*") if p.is_file()} == {share / page for page in pages}


def test_the_installed_program_finds_the_package_for_studies(root, tmp_path, box):
    install(root, "program", tmp_path / "usr")
    _swept.write_mesh(tmp_path / "box.ply", *box)
    (tmp_path / "still.csv").write_text("0,0,0,0,0,0,0,1\n")
    (tmp_path / "s.toml").write_text(
        '[[run]]\npart = "box.ply"\nmotion = "still.csv"\ncompute = ["envelope"]\n'
    )
    environment = {k: v for k, v in os.environ.items() if k != "PYTHONPATH"}
    command = [tmp_path / "usr/bin/swept", "study", tmp_path / "s.toml"]
    done = subprocess.run(command, env=environment, capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    assert (tmp_path / "results/box still/envelope.ply").stat().st_size > 0


def test_the_installed_workbench_is_whole(root, mod):
    for name in ("Init.py", "InitGui.py", "package.xml", "LICENSE", "README.md"):
        assert (mod / name).read_bytes() == (root / name).read_bytes()
    for folder in ("workbench", "resources"):
        there = {p.relative_to(root) for p in (root / folder).rglob("*") if p.is_file()}
        there = {p for p in there if "__pycache__" not in p.parts}
        assert there == {p.relative_to(mod) for p in (mod / folder).rglob("*") if p.is_file()}
    assert list((mod / "build/python").glob("_swept*.so"))
    assert not list(mod.rglob("*.cpp")) and not (mod / "tests").exists()


def test_freecad_finds_it_in_its_mod_folder(mod, tmp_path):
    freecad = shutil.which("freecadcmd") or shutil.which("FreeCADCmd")
    if not freecad:
        pytest.skip("FreeCAD is not installed")
    script, done = tmp_path / "look.py", tmp_path / "done"
    script.write_text(SCRIPT.format(done=str(done)))
    home = mod.parents[4]
    environment = {**os.environ, "HOME": str(home), "LANG": "C.UTF-8"}
    for name in ("SWEPT_CORE", "PYTHONPATH", "XDG_DATA_HOME", "FREECAD_USER_HOME"):
        environment.pop(name, None)
    subprocess.run(
        [freecad, str(script)],
        env=environment,
        stdin=subprocess.DEVNULL,
        capture_output=True,
        timeout=120,
    )
    assert done.exists(), "the script did not run to its end"
    assert pathlib.Path(done.read_text()).parent == mod / "build/python"


def test_the_script_asks_freecad_for_its_folder(root, tmp_path):
    freecad = shutil.which("freecadcmd") or shutil.which("FreeCADCmd")
    build = pathlib.Path(os.environ.get("SWEPT_BUILD", root / "build"))
    if not freecad or not (build / "cmake_install.cmake").exists():
        pytest.skip("FreeCAD is not installed, or no build")
    environment = {**os.environ, "FREECADCMD": freecad, "FREECAD_USER_HOME": str(tmp_path)}
    script = root / "resources/install-workbench"
    done = subprocess.run(
        [str(script), str(build)], env=environment, capture_output=True, text=True, check=True
    )
    assert (tmp_path / "Mod/SweptVolume/InitGui.py").is_file(), done.stdout
    assert "installed in {}/Mod/SweptVolume".format(tmp_path) in done.stdout
    environment["FREECADCMD"] = "/bin/false"
    failed = subprocess.run([str(script)], env=environment, capture_output=True, text=True)
    assert failed.returncode != 0 and "did not name its folder" in failed.stderr
