# SPDX-License-Identifier: LGPL-2.1-or-later
"""A small run of each command, for tests that apply to all of them."""
import dataclasses
import pathlib
import shlex
import subprocess
from typing import Tuple

import pytest

import _swept
from test_paths import block


@dataclasses.dataclass(frozen=True)
class Command:
    """A small run of a command: its arguments, which of them are input files, its options that name
    outputs, and which of these may be standard output."""

    words: str
    inputs: Tuple[str, ...]
    outputs: Tuple[str, ...]
    streams: Tuple[str, ...] = ()
    status: int = 0

    @property
    def needed(self):
        """Returns the output that must be named."""
        return self.outputs[0] if self.outputs[0] in ("-o made.ply", "-o made.step") else ""


RUNS = {
    "envelope": Command(
        "part.ply --motion way.csv --cell 0.5", ("part.ply", "way.csv"),
        ("-o made.ply", "--report made.json", "--sources made.csv"), ("-o made.ply",),
    ),
    "check": Command("part.ply", ("part.ply",), ("--report made.json",)),
    "solid": Command("part.ply", ("part.ply",), ("-o made.step", "--report made.json")),
    "clearance": Command(
        "part.ply --motion way.csv wall.ply --rules rules.txt --curve 3",
        ("part.ply", "way.csv", "wall.ply", "rules.txt"),
        ("--csv made.csv", "--page made.html", "--report made.json"),
        ("--csv made.csv", "--page made.html"),
    ),
    "mechanism": Command(
        "--moving part.ply way.csv wall.ply", ("part.ply", "way.csv", "wall.ply"),
        ("--csv made.csv", "--page made.html", "--report made.json"),
        ("--csv made.csv", "--page made.html"),
    ),
    "overlap": Command(
        "part.ply over.ply", ("part.ply", "over.ply"),
        ("--csv made.csv", "--shared made.ply", "--report made.json"),
        ("--csv made.csv", "--shared made.ply"), status=3,
    ),
    "path": Command(
        "part.ply wall.ply --start 0,0,60 --rules rules.txt", ("part.ply", "wall.ply", "rules.txt"),
        ("-o made.csv", "--report made.json"), ("-o made.csv",),
    ),
    "sequence": Command(
        "--part part.ply motion:way.csv --part other.ply out:90 wall.ply",
        ("part.ply", "way.csv", "other.ply", "wall.ply"), ("-o motions", "--report made.json"),
    ),
    "study": Command(
        "study.toml", ("study.toml", "part.ply", "way.csv", "wall.ply"), ("--report made.json",)
    ),
}  # fmt: skip
if not _swept.HAS_SOLIDS:
    del RUNS["solid"]
EACH = pytest.mark.parametrize("name", RUNS)
STUDY = (
    '[[run]]\npart = "part.ply"\nmotion = "way.csv"\nneighbours = ["wall.ply"]\n'
    'compute = ["envelope", "clearance"]\nenvelope = { cell = 0.5 }\n'
)


@pytest.fixture
def folder(tmp_path):
    """Makes the folder of the inputs: a part that moves 50 mm along x, a wall beside its path, and
    a part with which it overlaps."""
    parts = {
        "part": block([-1, -1, -1], [1, 1, 1]),
        "wall": block([-5, 3, -5], [60, 5, 5]),
        "over": block([0, -0.5, -0.5], [4, 0.5, 0.5]),
        "other": block([-1, -9, -1], [1, -7, 1]),
    }
    for name, mesh in parts.items():
        _swept.write_mesh(tmp_path / f"{name}.ply", mesh.vertices, mesh.triangles)
    (tmp_path / "way.csv").write_text("0,50,0,0,0,0,0,1\n1,0,0,0,0,0,0,1\n")
    (tmp_path / "rules.txt").write_text("wall=0.5\n")
    (tmp_path / "study.toml").write_text(STUDY)
    (tmp_path / "motions").mkdir()
    return tmp_path


@pytest.fixture
def run(program, folder):
    """Returns run(name, more arguments), which makes the small run of a command in the folder of inputs."""

    def run(name, *more, words=None, **keywords):
        keywords = {"timeout": 240, "text": True, **keywords}
        line = [
            program,
            name,
            *shlex.split(words or RUNS[name].words),
            *shlex.split(" ".join(more)),
        ]
        return subprocess.run(line, cwd=folder, capture_output=True, **keywords)

    return run


def contents(folder):
    """Returns {name: bytes} of all files."""
    files = (path for path in pathlib.Path(folder).rglob("*") if path.is_file())
    return {str(path.relative_to(folder)): path.read_bytes() for path in files}
