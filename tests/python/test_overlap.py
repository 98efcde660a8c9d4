# SPDX-License-Identifier: LGPL-2.1-or-later
"""Overlaps of parts that stand still, from Python and from the program."""
import csv
import json

import numpy as np
import pytest

import swept_volume as sv
from bodies import box
from test_program import call, inputs  # noqa: F401

LEFT = sv.Mesh(*box((0, 0, 0), (10, 10, 10)))
RIGHT = sv.Mesh(*box((8, 1, 1), (18, 11, 11)))
FAR = sv.Mesh(*box((0, 0, 13), (10, 10, 23)))


def volume_of(mesh):
    corners = mesh.vertices[mesh.triangles]
    return np.einsum("ij,ij->", corners[:, 0], np.cross(corners[:, 1], corners[:, 2])) / 6


def test_pairs_with_their_shared_solids():
    report, shared = sv.overlap([("left", LEFT), ("right", RIGHT), ("far", FAR)], required=5)
    assert [(p["first"], p["second"]) for p in report["pairs"]] == [
        ("left", "right"),
        ("left", "far"),
        ("right", "far"),
    ]
    clash, near, apart = report["pairs"]
    assert clash["volume"] == pytest.approx(162) and near["volume"] == apart["volume"] == 0
    assert near["clearance"]["distance"] == pytest.approx(3)
    assert volume_of(shared[0]) == pytest.approx(162) and shared[1:] == [None, None]
    low, high = shared[0].vertices.min(axis=0), shared[0].vertices.max(axis=0)
    assert np.allclose([low, high], [(8, 1, 1), (10, 10, 10)])
    report, shared = sv.overlap([("left", LEFT), ("right", RIGHT)], shared=False)
    assert "volume" not in report["pairs"][0] and shared == [None]


def test_an_envelope_is_a_reserved_space():
    motion = sv.Motion([0, 1], np.tile([0.0, 0, 0, 1], (2, 1)), [(0, 0, 0), (30, 0, 0)])
    swept = sv.compute(LEFT, motion, resolution=64).mesh
    report, (shared,) = sv.overlap(
        [("swept", swept), ("post", sv.Mesh(*box((15, 8, -5), (17, 12, 15))))]
    )
    assert report["pairs"][0]["volume"] == pytest.approx(2 * 2 * 10, rel=1e-6)
    assert shared.vertices[:, 1].max() == pytest.approx(10, abs=1e-6)


def test_bad_input_is_named():
    with pytest.raises(sv.InvalidInput, match="give at least two") as error:
        sv.overlap([("left", LEFT)])
    assert error.value.code == "NoParts"
    with pytest.raises(sv.InvalidInput, match="'left'"):
        sv.overlap([("left", LEFT), ("left", RIGHT)])
    with pytest.raises(TypeError, match="a part is"):
        sv.overlap([LEFT, RIGHT])


def test_the_program(call, inputs):  # noqa: F811
    for name, mesh in (("left", LEFT), ("right", RIGHT), ("far", FAR)):
        sv.write_mesh(inputs / (name + ".ply"), mesh)
    paths = [inputs / (name + ".ply") for name in ("left", "right", "far")]
    target = inputs / "shared.stl"
    done = call("overlap", *paths, "--csv", "-", "--shared", target, "--quiet")
    assert done.returncode == 3, done.stderr
    rows = list(csv.DictReader(done.stdout.splitlines()))
    assert [float(row["volume_mm3"]) for row in rows] == pytest.approx([162, 0, 0])
    assert [row["verdict"] for row in rows] == ["clash", "clear", "clear"]
    assert volume_of(sv.read_mesh(target)) == pytest.approx(162, rel=1e-5)
    target.unlink()
    done = call("overlap", paths[0], paths[2], "--report", "-", "--shared", target)
    assert done.returncode == 1 and "share a volume" in done.stderr and not target.exists()
    report = json.loads(done.stdout)
    assert report["command"] == "overlap" and report["summary"].startswith("1 pair checked")
    assert call("overlap", paths[0], paths[2]).returncode == 0
    assert call("overlap", paths[0], paths[2], "--required", "4").returncode == 3
    done = call("overlap", paths[0])
    assert done.returncode == 1 and "give at least two" in done.stderr, done.stderr
    done = call("overlap", *paths, "--shared", paths[0])
    assert done.returncode == 2 and "would be overwritten" in done.stderr, done.stderr
