# SPDX-License-Identifier: LGPL-2.1-or-later
"""STEP and BREP files as the moving part, with the program and the module."""
import json
import shutil
import subprocess

import numpy as np
import pytest

import _swept

pytestmark = pytest.mark.skipif(not _swept.HAS_SOLIDS, reason="built without OpenCASCADE")


@pytest.fixture
def part(box, tmp_path):
    """Makes the same box as a solid in a STEP and a BREP file and as a mesh, and a motion."""
    for name in ("part.step", "part.brep"):
        _swept.write_solid(tmp_path / name, *box)
    _swept.write_mesh(tmp_path / "part.ply", *box)
    (tmp_path / "motion.csv").write_text("0,0,0,0,0,0,0,1\n1,50,0,0,0,0,0,1\n")
    return tmp_path


def swept(program, folder, *words):
    done = subprocess.run([program, *map(str, words)], cwd=folder, capture_output=True, text=True)
    return done


def envelope(program, folder, body, *more):
    words = [
        "envelope",
        body,
        "--motion",
        "motion.csv",
        "--output",
        "out.ply",
        "--report",
        "r.json",
    ]
    done = swept(program, folder, *words, "--cell", "1", "--backend", "cpu", *more)
    return done, json.loads((folder / "r.json").read_text())


@pytest.mark.parametrize("name", ["part.step", "part.brep"])
def test_a_solid_sweeps_as_its_mesh_does(program, part, name):
    done, report = envelope(program, part, name)
    assert done.returncode == 0, done.stderr
    _, plain = envelope(program, part, "part.ply")
    assert report["volume"] == pytest.approx(plain["volume"], rel=1e-9)
    warning = report["warnings"][0]
    assert warning["code"] == "Tessellated" and "12 triangles" in warning["text"]
    assert "at most 0.02 mm" in warning["text"], "0.02 of the cell of 1 mm"
    assert "Tessellated" in done.stderr
    assert "Tessellated" not in [finding["code"] for finding in plain["warnings"]]


def test_the_tolerance_is_an_option_or_follows_from_the_resolution(program, part):
    _, report = envelope(program, part, "part.step", "--body-tolerance", "0.5")
    assert "at most 0.5 mm" in report["warnings"][0]["text"]
    words = ["envelope", "part.step", "--motion", "motion.csv", "--output", "out.ply"]
    done = swept(program, part, *words, "--report", "r.json", "--resolution", "40")
    assert done.returncode == 0, done.stderr
    report = json.loads((part / "r.json").read_text())
    body = _swept.read_body(part / "part.step", resolution=40)
    # The body is 30 mm long, so no cell of its sweep is smaller than 30 / sqrt(3) / 40 mm.
    assert body.chord_error == pytest.approx(0.02 * 30 / np.sqrt(3) / 40)
    assert body.chord_error <= 0.02 * report["cell"]
    done, report = envelope(program, part, "part.step", "--body-tolerance", "0")
    assert done.returncode == 1 and report["code"] == "BadOption"


def test_the_angle_between_triangles_is_an_option(part):
    with pytest.raises(_swept.InvalidInput, match="0 rad, but must be above 0") as refused:
        _swept.read_body(part / "part.step", tolerance=1.0, angle=0)
    assert refused.value.code == "BadOption"
    assert len(_swept.read_body(part / "part.step", tolerance=1.0, angle=0.5).triangles) == 12


@pytest.mark.parametrize("name", ["part.step", "part.brep"])
def test_the_content_counts_where_the_suffix_says_nothing(program, part, name):
    shutil.copy(part / name, part / "body.data")
    done, report = envelope(program, part, "body.data")
    assert done.returncode == 0, done.stderr
    assert report["warnings"][0]["code"] == "Tessellated"
    assert np.allclose(np.ptp(_swept.read_body(part / "body.data").vertices, axis=0), [10, 20, 30])


def test_a_solid_states_its_own_unit(program, part):
    done, report = envelope(program, part, "part.step", "--body-unit", "m")
    assert done.returncode == 1
    assert (report["status"], report["code"]) == ("InvalidInput", "BadOption")
    assert "contains its own unit of length" in done.stderr


def test_a_broken_solid_is_named(program, part):
    text = (part / "part.step").read_bytes()
    (part / "half.step").write_bytes(text[: len(text) // 2])
    done, report = envelope(program, part, "half.step")
    assert done.returncode == 1 and report["code"] == "BadFile" and "half.step" in done.stderr


def test_several_solids_of_a_file_are_one_body(box, tmp_path):
    vertices, triangles = box
    two = np.concatenate([vertices, vertices + [100, 0, 0]])
    _swept.write_solid(tmp_path / "two.step", two, np.concatenate([triangles, triangles + 8]))
    body = _swept.read_body(tmp_path / "two.step", cell=1.0)
    assert body.findings[0]["count"] == 2 and len(body.triangles) == 24
    assert np.allclose(np.ptp(body.vertices, axis=0), [110, 20, 30])
    still = np.eye(4)[None]
    report = _swept.compute(body.vertices, body.triangles, still, resolution=40).report
    assert report["shells"] == 2


def test_clearance_takes_a_solid_as_the_moving_part(program, part, box):
    _swept.write_mesh(part / "wall.ply", box[0] + [0, 30, 0], box[1])
    words = ["clearance", "part.step", "wall.ply", "--motion", "motion.csv", "--report", "c.json"]
    done = swept(program, part, *words)
    assert done.returncode == 0, done.stderr
    report = json.loads((part / "c.json").read_text())
    row = report["neighbours"][0]
    assert row["distance"] == pytest.approx(10) and row["chord_error"] == pytest.approx(0.05)
    assert report["warnings"][0]["code"] == "Tessellated"
