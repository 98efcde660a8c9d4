# SPDX-License-Identifier: LGPL-2.1-or-later
"""The examples of README.md and of docs/command_line.md run when they are pasted one after the other, with
real files."""
import os
import re
import subprocess
import sys

import numpy as np
import pytest

import _swept
from bodies import box, joined
from conftest import BUILD

SOLIDS = pytest.mark.skipif(not _swept.HAS_SOLIDS, reason="no OpenCASCADE in this build")


@pytest.fixture
def folder(tmp_path, root):
    """Makes the files of the examples: a gripper and its path in metres, past a housing and a
    bracket."""
    gripper = joined(box((0, 0, 0), (40, 20, 20)), box((10, 5, 20), (30, 15, 60)))
    _swept.write_mesh(tmp_path / "gripper.stl", *gripper)
    _swept.write_mesh(tmp_path / "bracket.stl", *box((0, 300, 0), (50, 350, 50)))
    _swept.write_solid(tmp_path / "housing.step", *box((-100, -200, -100), (300, -100, 100)))
    half = np.radians(np.linspace(0, 60, 7)) / 2
    rows = [f"{n},{0.05 * n},0,0,{np.sin(a)},0,0,{np.cos(a)}" for n, a in enumerate(half)]
    (tmp_path / "path.csv").write_text("t,tx,ty,tz,qx,qy,qz,qw\n" + "\n".join(rows) + "\n")
    subprocess.run(["xz", "-k", "path.csv"], cwd=tmp_path, check=True)
    (tmp_path / "build").symlink_to(BUILD)
    return tmp_path


def blocks(root, language):
    return re.findall(rf"^```{language}\n(.*?)^```$", (root / "README.md").read_text(), re.M | re.S)


@SOLIDS
def test_the_commands_chain(root, folder):
    found = [text for text in blocks(root, "sh") if "bin/swept" in text]
    assert found, "no example of the program is left"
    for text in found:
        done = subprocess.run(
            ["bash", "-e", "-o", "pipefail", "-c", text], cwd=folder, capture_output=True, text=True
        )
        assert done.returncode == 0, text + done.stdout + done.stderr
    assert (folder / "envelope.step").stat().st_size > 1000


def test_the_commands_within_the_text(root, folder):
    page = (root / "docs" / "command_line.md").read_text()
    found = re.findall(r"`([^`\n]*\bswept [^`\n]*[|>][^`\n]*)`", page)
    found = [text for text in found if "FILE" not in text]
    assert any("xzcat" in text for text in found) and any("manual" in text for text in found)
    path = f"{BUILD / 'bin'}:{os.environ['PATH']}"
    for text in found:
        text = text.replace("man -l -", "cat")  # man may be missing
        done = subprocess.run(
            ["bash", "-e", "-o", "pipefail", "-c", text], cwd=folder, capture_output=True,
            text=True, env={**os.environ, "PATH": path},
        )  # fmt: skip
        assert done.returncode == 0, text + done.stderr
    assert (folder / "out.stl").stat().st_size > 1000


@SOLIDS
def test_the_python_example(root, folder):
    (text,) = blocks(root, "python")
    done = subprocess.run(
        [sys.executable, "-c", text], cwd=folder, capture_output=True, text=True, timeout=300
    )
    assert done.returncode == 0, done.stderr
    volume, seconds = map(float, done.stdout.split())
    assert volume > 40 * 20 * 20 and seconds > 0 and (folder / "envelope.step").exists()


def test_the_first_screen_says_how_to_get_it_and_what_is_not_published(root):
    screen = (root / "README.md").read_text().splitlines()[:40]
    for system in ("Windows", "AppImage", "Debian 12", "Debian 13"):
        (row,) = [line for line in screen if line.startswith("| " + system)]
        assert "steps](docs/handbook/installation.md#" in row
    assert not [line for line in screen if line.startswith("![")], "pictures push it down"
    text = (root / "workbench/sweptvolume/core_install.py").read_text()
    published = re.search(r"^PUBLISHED = (True|False)$", text, re.M)[1] == "True"
    assert any("Nothing is published yet" in line for line in screen) != published
