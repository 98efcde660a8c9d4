# SPDX-License-Identifier: LGPL-2.1-or-later
"""`cmake --install --component development`: a project outside the repository can be built with the
installed files.
"""
import os
import pathlib
import re
import shutil
import subprocess

import pytest

import _swept


@pytest.fixture(scope="module")
def prefix(root, tmp_path_factory):
    build = pathlib.Path(os.environ.get("SWEPT_BUILD", root / "build"))
    if not (build / "libswept_clearance.a").exists():
        pytest.skip(f"no library in {build}")
    folder = tmp_path_factory.mktemp("installed")
    command = ["cmake", "--install", str(build), "--component", "development"]
    subprocess.run(command + ["--prefix", str(folder)], check=True, capture_output=True)
    return folder


def test_all_public_headers_are_there_and_nothing_of_the_inside(root, prefix):
    there = {path.name for path in (prefix / "include/swept").iterdir()}
    public = {path.name for path in (root / "cpp/include/swept").iterdir()}
    assert there == public
    for header in (prefix / "include/swept").iterdir():
        for name in re.findall(r'#include "([^"]+)"', header.read_text()):
            assert name.startswith("swept/") and name.split("/")[1] in there, (header.name, name)
    for path in prefix.rglob("*.cmake"):
        assert str(root) not in path.read_text(), f"{path.name} names the source tree"


def test_the_example_builds_and_runs_outside_the_tree(root, prefix, tmp_path):
    source, build = tmp_path / "source", tmp_path / "build"
    shutil.copytree(root / "examples/cpp", source)
    configure = ["cmake", "-G", "Ninja", "-S", str(source), "-B", str(build)]
    configure.append(f"-DCMAKE_PREFIX_PATH={prefix}")
    for command in (configure, ["cmake", "--build", str(build)]):
        done = subprocess.run(command, capture_output=True, text=True)
        assert done.returncode == 0, done.stdout + done.stderr
    output = tmp_path / "envelope.ply"
    done = subprocess.run([str(build / "sweep_box"), str(output)], capture_output=True, text=True)
    assert done.returncode == 0 and "triangles" in done.stdout, done.stderr
    mesh = _swept.read_mesh(output)
    assert _swept.check_mesh(mesh.vertices, mesh.triangles)["passes"]
    # The library throws an Error, which is printed in one line.
    done = subprocess.run(
        [str(build / "sweep_box"), str(tmp_path / "none" / "x.ply")], capture_output=True, text=True
    )
    assert done.returncode == 1 and done.stderr.startswith("ExportFailed: ")
