# SPDX-License-Identifier: LGPL-2.1-or-later
"""Installation paths from Python and from the program: paths are clear, and wrong input is named."""
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
    assert done.returncode == 3 and "no path exists without turning" in done.stdout, done.stderr
    assert not (tmp_path / "path.csv").exists()


def test_a_motion_is_made_shorter_and_keeps_its_locked_keys():
    poses = np.array(
        [shift(0, 0, 60), shift(15, 0, 40), shift(3, 0.6, 20), shift(-9, 0, 9), shift(0, 0, 0)]
    )
    motion = sv.Motion.from_matrices(poses, np.arange(5.0))
    report, better = sv.improve_path(PART, motion, WALLS, clearance=0.3)
    assert report["before"]["keys"] == 5 and report["kept_moves"] == 0
    assert len(better.times) == 2 and report["length"] == pytest.approx(60)
    assert (better.times[0], better.times[-1]) == (0, 4)
    report, better = sv.improve_path(PART, motion, WALLS, clearance=0.3, locked=[2])
    assert better.translations.tolist() == [[0, 0, 60], [3, 0.6, 20], [0, 0, 0]]
    assert better.times.tolist() == [0, 2, 4]
    checked = sv.clearance(PART, better, WALLS, required=0.3)
    assert {row["verdict"] for row in checked["neighbours"]} == {"clear"}


def test_a_clash_is_led_round_and_clearance_raised():
    post = WALLS + [("post", block([-3, -1.2, 20], [3, 1.2, 26]))]
    motion = sv.Motion.from_matrices(np.array([shift(0, 0, 60), shift(0, 0, 0)]), [0, 1])
    report, better = sv.improve_path(PART, motion, post, clearance=0.3)
    assert report["before"]["clearance"] == 0 and report["unmended_moves"] == 0
    checked = sv.clearance(PART, better, post, required=0.3)
    assert {row["verdict"] for row in checked["neighbours"]} == {"clear"}
    more, wider = sv.improve_path(PART, better, post, clearance=0.3, more_clearance=True, budget=5)
    assert more["clearance"] > 0.7 > report["clearance"] - 0.4
    checked = sv.clearance(PART, wider, post, required=more["clearance"])
    assert {row["verdict"] for row in checked["neighbours"]} == {"clear"}


def test_what_cannot_be_mended_is_said_and_stays():
    lid = WALLS + [
        ("lid", block([-20, -4, 30], [20, 4, 33])),
        ("end", block([-20, -4, -5], [-18, 4, 33])),
    ]
    lid.append(("other end", block([18, -4, -5], [20, 4, 33])))
    lid += [("upper left", block([-20, 2, 19], [20, 4, 33]))]
    lid += [("upper right", block([-20, -4, 19], [20, -2, 33]))]
    motion = sv.Motion.from_matrices(np.array([shift(0, 0, 60), shift(0, 0, 0)]), [0, 1])
    report, same = sv.improve_path(PART, motion, lid, clearance=0.3, budget=1)
    assert report["unmended_moves"] == report["kept_moves"] == 1
    assert report["clearance"] >= 0.3 and np.ptp(same.translations[:, :2]) == pytest.approx(
        0, abs=1e-9
    )
    with pytest.raises(sv.InvalidInput) as refused:
        sv.improve_path(PART, motion, WALLS, locked=[2])
    assert refused.value.code == "BadOption"


def test_live_distances_agree_with_the_check():
    walls = [(name, mesh.vertices, mesh.triangles) for name, mesh in WALLS]
    live = _swept.LiveClearance(PART.vertices, PART.triangles, walls)
    assert live.at(shift(0, 0.4, 0))[:3] == (0, pytest.approx(0.6), False)
    assert live.at(shift(0, 0, -3.5))[:2] == (2, pytest.approx(0.5))
    assert live.at(shift(0, 1.5, 0))[1] == 0
    small = block([-0.1, -0.1, -0.1], [0.1, 0.1, 0.1])
    inner = _swept.LiveClearance(small.vertices, small.triangles, walls)
    assert inner.at(shift(0, 3, 0))[:3] == (0, 0, True)
    stopped = live.reached(shift(0, 0, 0), shift(0, 0, -30), 0.25)
    assert stopped[2, 3] == pytest.approx(-3.75, abs=0.01) and stopped[2, 3] >= -3.75
    assert live.reached(shift(0, 0.9, 0), shift(0, 0, 0), 0.25).tolist() == shift(0, 0, 0).tolist()
    for _ in range(2):
        rng = np.random.default_rng(3)
        for y, z in rng.uniform(-0.9, 0.9, (20, 2)):
            at = shift(0, y, z)
            report = _swept.clearance(PART.vertices, PART.triangles, np.array([at]), walls, "none")
            nearest = min(row["distance"] for row in report["neighbours"])
            assert live.at(at)[1] == pytest.approx(nearest, abs=1e-9)


def test_neighbours_ask_for_clearances_of_their_own_and_a_watch_sees_the_way():
    rows = [
        (name, mesh.vertices, mesh.triangles, 0.0, own)
        for (name, mesh), own in zip(WALLS, (0.9, None, 3.9))
    ]
    watch = _swept.PathWatch()
    options = dict(start=shift(0, 0, 60), clearance=0.5)
    report, _ = _swept.find_path(
        PART.vertices, PART.triangles, shift(0, 0, 0), rows, watch=watch, **options
    )
    # A straight path needs no search.
    assert report["verdict"] == "found" and watch.farthest() is None
    rows[2] = rows[2][:4] + (4.1,)
    with pytest.raises(sv.InvalidInput, match="floor"):
        _swept.find_path(PART.vertices, PART.triangles, shift(0, 0, 0), rows, **options)
