# SPDX-License-Identifier: LGPL-2.1-or-later
"""Installation paths from the program and from Python: what is found is clear, wrong input is named."""
import numpy as np
import pytest

import _swept
import swept_volume as sv
from test_program import call, inputs  # noqa: F401


def block(low, high):
    low, high = np.asarray(low, float), np.asarray(high, float)
    corners = np.array([[i & 1, i >> 1 & 1, i >> 2 & 1] for i in range(8)])
    faces = [[0, 2, 3], [0, 3, 1], [4, 5, 7], [4, 7, 6], [0, 1, 5], [0, 5, 4],
             [2, 6, 7], [2, 7, 3], [0, 4, 6], [0, 6, 2], [1, 3, 7], [1, 7, 5]]  # fmt: skip
    return sv.Mesh(low + corners * (high - low), np.array(faces, np.int32))


PART = block([-1, -1, -1], [1, 1, 1])
WALLS = [
    ("left", block([-20, 2, -20], [20, 4, 20])),
    ("right", block([-20, -4, -20], [20, -2, 20])),
    ("floor", block([-20, -2, -20], [20, 2, -5])),
]


def shift(x, y, z):
    pose = np.eye(4)
    pose[:3, 3] = x, y, z
    return pose


def test_a_path_is_clear_and_leads_from_start_to_goal():
    report, motion = sv.find_path(
        PART, shift(0, 0, 0), WALLS, start=shift(0, 0, -60), clearance=0.5
    )
    assert report["verdict"] == "found" and report["clearance"] >= 0.5
    assert motion.translations[0].tolist() == [0, 0, -60]
    assert motion.translations[-1].tolist() == [0, 0, 0]
    checked = sv.clearance(PART, motion, WALLS, required=0.5)
    assert [row["verdict"] for row in checked["neighbours"]] == ["clear"] * 3
    again, same = sv.find_path(PART, shift(0, 0, 0), WALLS, start=shift(0, 0, -60), clearance=0.5)
    assert same.translations.tobytes() == motion.translations.tobytes()
    assert again["steps"] == report["steps"]


def test_extraction_and_places_on_the_way():
    report, motion = sv.find_path(PART, shift(0, 0, 0), WALLS, extract=50, clearance=0.5)
    assert np.linalg.norm(motion.translations[0]) >= 50
    _, motion = sv.find_path(PART, shift(0, 0, 0), WALLS, extract=(0, 0, 1), clearance=0.5)
    assert motion.translations[0][2] > 21
    via = [shift(40, 0, 0), shift(0, 0, 30)]
    _, motion = sv.find_path(
        PART, shift(0, 0, 0), WALLS, start=shift(40, 40, 0), via=via, clearance=0.5
    )
    keys = motion.translations.round(9).tolist()
    assert keys.index([40, 0, 0]) < keys.index([0, 0, 30])


def test_contact_is_released():
    on_floor = shift(0, 0, -4)
    with pytest.raises(sv.InvalidInput, match="floor") as refused:
        sv.find_path(PART, on_floor, WALLS, start=shift(0, 0, 60), clearance=0.5)
    assert refused.value.code == "GoalBlocked"
    report, motion = sv.find_path(
        PART, on_floor, WALLS, start=shift(0, 0, 60), clearance=0.5, release=3
    )
    assert report["contacts"] == ["floor"] and motion.translations[-1].tolist() == [0, 0, -4]
    with pytest.raises(sv.InvalidInput, match="'floor', 0.7 mm deep"):
        sv.find_path(
            PART, shift(0, 0, -4.7), WALLS, start=shift(0, 0, 60), clearance=0.5, release=3
        )


@pytest.mark.parametrize(
    "change, code",
    [
        ({"start": shift(0, 0, 0)}, "SamePose"),
        ({"start": None}, "NoStart"),
        ({"extract": 5.0}, "BadOption"),
        ({"budget": 0.0}, "BadOption"),
        ({"clearance": -1.0}, "BadOption"),
        ({"clearance": 3.0}, "GoalBlocked"),
        ({"max_angle": 7.0}, "BadOption"),
        ({"interpolation": "none"}, "BadOption"),
        ({"start": shift(0, 3, 0)}, "StartBlocked"),
        ({"via": [shift(0, 3, 0)]}, "ViaBlocked"),
        ({"neighbours": []}, "NoNeighbours"),
    ],
)
def test_wrong_input_is_named(change, code):
    options = {"start": shift(50, 0, 0), "clearance": 0.5, "neighbours": WALLS, **change}
    with pytest.raises(sv.InvalidInput) as refused:
        sv.find_path(PART, shift(0, 0, 0), **options)
    assert refused.value.code == code, refused.value


def test_the_program_writes_what_clearance_finds_clear(call, tmp_path):  # noqa: F811
    for name, mesh in [("part", PART)] + WALLS:
        _swept.write_mesh(tmp_path / f"{name}.ply", mesh.vertices, mesh.triangles)
    walls = [tmp_path / f"{name}.ply" for name, _ in WALLS]
    words = ["path", tmp_path / "part.ply", *walls, "--clearance", "0.5"]
    done = call(*words, "--start", "0,0,-60", "-o", tmp_path / "path.csv", "--via=0,0,40")
    assert done.returncode == 0 and "path of" in done.stdout, done.stderr
    checked = call(
        "clearance", tmp_path / "part.ply", *walls, "--motion", tmp_path / "path.csv",
        "--required", "0.5",
    )  # fmt: skip
    assert checked.returncode == 0, checked.stdout
    lines = (tmp_path / "path.csv").read_text().splitlines()
    assert any(line.split(",")[1:4] == ["0", "0", "40"] for line in lines), lines
    done = call(*words, "--start", "0,0,0")
    assert done.returncode == 1 and "SamePose" in done.stderr
    done = call(*words, "--start", "0,0")
    assert done.returncode == 2 and "--start is '0,0'" in done.stderr
    assert call(*words, "--extract", "1,2").returncode == 2


def test_no_way_out_ends_with_status_3(call, tmp_path):  # noqa: F811
    _swept.write_mesh(tmp_path / "part.ply", PART.vertices, PART.triangles)
    box = [block([-5, -5, -5], [5, 5, -4]), block([-5, -5, 4], [5, 5, 5]),
           block([-5, -5, -4], [5, -4, 4]), block([-5, 4, -4], [5, 5, 4]),
           block([-5, -4, -4], [-4, 4, 4]), block([4, -4, -4], [5, 4, 4])]  # fmt: skip
    names = []
    for i, wall in enumerate(box):
        names.append(tmp_path / f"wall{i}.ply")
        _swept.write_mesh(names[-1], wall.vertices, wall.triangles)
    done = call(
        "path", tmp_path / "part.ply", *names, "--extract", "1,0,0", "--translation-only",
        "-o", tmp_path / "path.csv",
    )  # fmt: skip
    assert done.returncode == 3 and "no path without turning exists" in done.stdout, done.stderr
    assert not (tmp_path / "path.csv").exists()
