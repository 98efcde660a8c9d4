# SPDX-License-Identifier: LGPL-2.1-or-later
"""Sequences from Python and from the program: each part is clear of the parts already in place, and wrong
input is named.
"""
import json

import numpy as np
import pytest

import _swept
import swept_volume as sv
from test_paths import block, shift
from test_program import call, inputs  # noqa: F401

WALLS = [
    ("floor", block([-13, -13, -3], [13, 13, 0])),
    ("west", block([-13, -13, 0], [-10, 13, 40])),
    ("east", block([10, -13, 0], [13, 13, 40])),
    ("south", block([-10, -13, 0], [10, -10, 40])),
    ("north", block([-10, 10, 0], [10, 13, 40])),
]
LOWER, UPPER = block([-9, -9, 1], [9, 9, 10]), block([-9, -9, 11], [9, 9, 20])


def parts(**how):
    how = how or {"extract": 90.0}
    return [sv.SequencePart("upper", UPPER, **how), sv.SequencePart("lower", LOWER, **how)]


def test_the_only_order_is_found_and_each_motion_is_clear():
    report, motions = sv.find_sequence(parts(), WALLS, order="find", clearance=0.4)
    assert report["verdict"] == "found" and list(motions) == ["upper", "lower"]
    assert [step["part"] for step in report["steps"]] == ["lower", "upper"]
    first, second = report["steps"]
    assert first["begin"] == 0 and first["end"] == second["begin"]
    for motion in motions.values():
        assert (motion.times[0], motion.times[-1]) == (0, report["duration"])
    for name, mesh, there in (("lower", LOWER, WALLS), ("upper", UPPER, WALLS + [("l", LOWER)])):
        checked = sv.clearance(mesh, motions[name], there, required=0.4)
        assert {row["verdict"] for row in checked["neighbours"]} == {"clear"}, name
    again, same = sv.find_sequence(parts(), WALLS, order="find", clearance=0.4)
    assert again["moves"] == report["moves"]
    assert all(same[n].translations.tobytes() == motions[n].translations.tobytes() for n in same)


def test_a_given_order_that_cannot_be_says_who_was_stopped():
    report, motions = sv.find_sequence(
        parts(extract=(0, 0, 1)), WALLS, clearance=0.4, translation_only=True
    )
    assert motions is None and report["verdict"] == "not_found"
    upper, lower = report["steps"]
    assert (upper["verdict"], lower["verdict"]) == ("found", "no_translation")
    assert "'lower'" in report["summary"] and "1 of 2" in report["summary"]


def test_motions_of_ones_own_keep_their_times_and_pivots():
    down = sv.Motion.from_matrices(np.array([shift(0, 0, 80), shift(0, 0, 0)]), np.array([2.0, 7]))
    given = sv.Motion(down.times, down.quaternions, down.translations, pivot=(1.0, 2, 3))
    order = [sv.SequencePart("lower", LOWER, extract=90.0)]
    order.append(sv.SequencePart("upper", UPPER, motion=given))
    report, motions = sv.find_sequence(order, WALLS, clearance=0.4)
    assert report["steps"][1]["method"] == "given"
    assert motions["upper"].pivot.tolist() == [1, 2, 3]
    assert report["duration"] - report["steps"][1]["begin"] == pytest.approx(5)


@pytest.mark.parametrize("nothing", [None, 0])
def test_none_and_0_mean_no_limit_of_moves(nothing):
    _, motions = sv.find_sequence(parts(), WALLS, order="find", clearance=0.4, most_moves=nothing)
    assert motions is not None
    assert _swept.SequenceWatch().seen() == (None, 0, None)


@pytest.mark.parametrize(
    "change, code",
    [
        ({"parts": []}, "NoParts"),
        ({"parts": parts() + parts()[:1]}, "PartTwice"),
        ({"parts": parts(start=None)}, "NoStart"),
        ({"clearance": 1.2}, "PartsTooNear"),
        ({"budget": 0.0}, "BadOption"),
        ({"most_moves": -1}, "BadOption"),
        ({"rules": [("upper", "nobody", 1)]}, "UnknownPart"),
        ({"rules": [("upper", "lower", "contact")]}, "BadRule"),
        ({"parts": parts()[:1], "neighbours": ()}, "NoNeighbours"),
        ({"parts": parts(extract=90.0, goal=shift(0, 0, -2))}, "PartsIntersect"),
    ],
)
def test_wrong_input_is_named(change, code):
    options = {"parts": parts(), "neighbours": WALLS, "clearance": 0.4, **change}
    with pytest.raises(sv.InvalidInput) as refused:
        sv.find_sequence(options.pop("parts"), options.pop("neighbours"), **options)
    assert refused.value.code == code, refused.value
    if code == "PartsIntersect":
        assert "mm deep" in str(refused.value) and "'floor'" in str(refused.value)


def test_the_program_writes_motions_on_one_timeline(call, tmp_path):  # noqa: F811
    for name, mesh in [("upper", UPPER), ("lower", LOWER)] + WALLS:
        _swept.write_mesh(tmp_path / f"{name}.ply", mesh.vertices, mesh.triangles)
    walls = [tmp_path / f"{name}.ply" for name, _ in WALLS]
    words = ["sequence", "--part", tmp_path / "upper.ply", "out:90"]
    words += ["--part", tmp_path / "lower.ply", "out:90", *walls, "--clearance", "0.4"]
    motions = tmp_path / "motions"
    motions.mkdir()
    done = call(*words, "--order", "find", "-o", motions, "--report", tmp_path / "report.json")
    assert done.returncode == 0 and "lower, upper" in done.stdout, done.stderr + done.stdout
    report = json.loads((tmp_path / "report.json").read_text())
    assert report["command"] == "sequence" and report["order"] == "find"
    for name, there in (("lower", walls), ("upper", walls + [tmp_path / "lower.ply"])):
        checked = call(
            "clearance", tmp_path / f"{name}.ply", *there, "--motion", motions / f"{name}.csv",
            "--required", "0.4",
        )  # fmt: skip
        assert checked.returncode == 0, checked.stdout
    down = ["--part", tmp_path / "lower.ply", f"motion:{motions / 'lower.csv'}"]
    done = call(*words[:4], *down, *walls, "--clearance", "0.4", "--most-moves", "1")
    assert done.returncode == 3 and "'lower'" in done.stdout, done.stderr + done.stdout
    assert call(*words, "--order", "any").returncode == 2
    assert call(*words[:3], "down:3", *walls).returncode == 2
    done = call("sequence", *walls)
    assert done.returncode == 2 and "--part PART HOW is missing" in done.stderr
    done = call(*words, "--part", tmp_path / "upper.ply", "out:5")
    assert done.returncode == 1 and "PartTwice" in done.stderr
