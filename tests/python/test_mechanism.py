# SPDX-License-Identifier: LGPL-2.1-or-later
"""Mechanisms (parts that move at the same time) from Python and from the program."""
import csv
import threading
import time

import numpy as np
import pytest

import swept_volume as sv
from bodies import box
from test_program import call, inputs  # noqa: F401


def slide(start, end, times=(0.0, 1.0), **options):
    """Returns a motion from start to end without a turn."""
    turn = np.tile([0.0, 0.0, 0.0, 1.0], (2, 1))
    return sv.Motion(times, turn, [start, end], **options)


CUBE = sv.Mesh(*box((-5, -5, -5), (5, 5, 5)))
PASSING = [
    ("left", CUBE, slide((-40, 0, 0), (40, 0, 0))),
    ("right", CUBE, slide((40, 13, 0), (-40, 13, 0))),
]


def test_two_that_pass_each_other():
    report = sv.mechanism(PASSING, required=4)
    (pair,) = report["pairs"]
    row = pair["clearance"]
    assert row["distance"] == pytest.approx(3, abs=0.01) and row["verdict"] == "below"
    assert report["from_seconds"] == 0 and report["to_seconds"] == 1
    # No position is nearer: both bodies are placed at many times, computed here, and measured by the
    # distances of their corners.
    for t in np.linspace(0, 1, 41):
        left, right = np.array([-40 + 80 * t, 0, 0]), np.array([40 - 80 * t, 13, 0])
        gap = np.maximum(np.abs(left - right) - 10, 0)
        assert np.linalg.norm(gap) >= row["guaranteed"]
    place = pair["pose_of_second"]["translation"]
    assert place[0] == pytest.approx(40 - 80 * row["time_seconds"], abs=1e-6)


def test_pairs_are_ignored_and_bad_input_is_named():
    assert sv.mechanism(PASSING, ignored=[("right", "left")])["pairs"] == []
    (pair,) = sv.mechanism(PASSING, required=2, rules=[("right", "left", 4)])["pairs"]
    assert pair["required"] == 4 and not pair["clearance"]["meets_rule"]
    with pytest.raises(sv.InvalidInput, match="contradict"):
        sv.mechanism(PASSING, ignored=[("left", "right")], rules=[("left", "right", "contact")])
    with pytest.raises(sv.InvalidInput, match="'left' is given twice"):
        sv.mechanism([PASSING[0], PASSING[0]])
    late = ("late", CUBE, slide((0, 0, 0), (9, 0, 0), times=(5.0, 6.0)))
    with pytest.raises(sv.InvalidInput, match="'late' begins at t = 5 s") as error:
        sv.mechanism([PASSING[0], late])
    assert error.value.code == "NoCommonTime"
    with pytest.raises(TypeError, match="a part is"):
        sv.mechanism([("left", CUBE)])
    with pytest.raises(sv.InvalidInput, match="names 'boom', but no part has this name") as error:
        sv.mechanism(PASSING, rules=[("left", "boom", 4)])
    assert error.value.code == "UnknownPart"
    still = [(name, mesh, None) for name, mesh, _ in PASSING]  # all motions are missing
    with pytest.raises(sv.InvalidInput) as error:
        sv.mechanism(still)
    assert error.value.code == "NothingMoves", error.value


def test_a_run_is_cancelled_soon():
    angles = np.linspace(0, 40, 4000)
    turn = np.stack([0 * angles, 0 * angles, np.sin(angles / 2), np.cos(angles / 2)], 1)

    def gear(k):
        return sv.Motion(angles, turn, np.outer(np.ones(4000), [6.0 * k, 0, 0]))

    parts = [(str(k), CUBE, gear(k)) for k in range(9)]
    for k, (name, mesh, motion) in enumerate(parts):  # every second one turns the other way
        if k % 2:
            parts[k] = (name, mesh, sv.Motion(angles, turn * [1, 1, -1, 1], motion.translations))
    run = sv.RunContext()
    ended = []

    def work():
        with pytest.raises(sv.Cancelled):
            sv.mechanism(parts, run=run)
        ended.append(time.perf_counter())

    thread = threading.Thread(target=work)
    thread.start()
    while run.progress <= 0 and thread.is_alive():
        time.sleep(0.001)
    run.cancel()
    thread.join()
    assert ended


def test_the_program_writes_a_table(call, inputs):  # noqa: F811
    for name, motion in (("left", PASSING[0][2]), ("right", PASSING[1][2])):
        sv.write_mesh(inputs / (name + ".ply"), CUBE)
        rows = np.column_stack([motion.times, motion.translations, motion.quaternions])
        header = "t,tx,ty,tz,qx,qy,qz,qw"
        np.savetxt(inputs / (name + ".csv"), rows, delimiter=",", header=header, comments="")
    words = ["mechanism", "--csv", "-", "--quiet", "--required", "4"]
    for name in ("left", "right"):
        words += ["--moving", inputs / (name + ".ply"), inputs / (name + ".csv")]
    done = call(*words)
    assert done.returncode == 3, done.stderr
    (row,) = csv.DictReader(done.stdout.splitlines())
    assert (row["first"], row["second"], row["verdict"]) == ("left", "right", "below")
    assert float(row["distance_mm"]) == pytest.approx(3, abs=0.01)
    assert call(*words, "--ignore", "left", "right").returncode == 0
    assert call(*words, "--rule", "right", "left", "2.5").returncode == 0
    for extra, named in (
        (["--ignore", "left", "boom"], "'boom'"),
        ([inputs / "left.ply"], "'left' is given twice"),
        (["--moving", inputs / "left.ply"], "--moving needs a value"),
    ):
        done = call(*words, *extra)
        assert done.returncode in (1, 2) and named in done.stderr, done.stderr


def test_bad_input_of_the_programs_is_named(call, inputs):  # noqa: F811
    """Tests a part that is a moving part and a neighbour, missing motions, and times that do not
    overlap."""
    part = ["box.ply", "--motion", "slide.csv"]
    done = call("clearance", *part, "box.ply", cwd=inputs)
    assert (
        done.returncode == 2 and "'box.ply' is both the moving part and a neighbour" in done.stderr
    )
    (inputs / "twin.ply").write_bytes((inputs / "box.ply").read_bytes())
    assert (
        call("clearance", *part, "twin.ply", cwd=inputs).returncode == 3
    ), "a copy may stand there"
    moving = ["--moving", "box.ply", "slide.csv"]
    for words, status, text in (
        ([*moving, "box.ply"], 1, "PartTwice: part 'box' is given twice"),
        ([*moving, "--moving", "twin.ply", "gone.csv"], 1, "'gone.csv' does not exist"),
        ([*moving, "--moving", "twin.ply"], 2, "--moving"),
    ):
        done = call("mechanism", *words, cwd=inputs)
        assert done.returncode == status and text in done.stderr, (words, done.stderr)
    (inputs / "late.csv").write_text("50,0,0,0,0,0,0,1\n60,9,0,0,0,0,0,1\n")
    done = call("mechanism", *moving, "--moving", "twin.ply", "late.csv", cwd=inputs)
    assert done.returncode == 1 and "NoCommonTime" in done.stderr and "'twin'" in done.stderr
