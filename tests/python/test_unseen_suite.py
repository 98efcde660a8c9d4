# SPDX-License-Identifier: LGPL-2.1-or-later
"""The tool unseen_suite.py finds the faults that it is made to find."""
import pathlib
import sys

import numpy as np
import pytest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "tools"))

import unseen_inputs  # noqa: E402
import unseen_suite  # noqa: E402
from unseen_suite import Outcome  # noqa: E402

BOX = unseen_inputs._grid_box((0, 0, 0), (10, 20, 30), 1)
STILL = (np.zeros(1), np.array([[0, 0, 0, 1.0]]), np.zeros((1, 3)))


def case_of(mesh, motion=STILL, resolution=32):
    return unseen_inputs.Case("box", mesh, motion, {"resolution": resolution})


@pytest.fixture
def report(program, tmp_path):
    """Returns the report of a run that keeps its promises."""
    outcome = unseen_suite.run_case(case_of(BOX), pathlib.Path(program), tmp_path)
    assert outcome.broken == ()
    assert outcome.triangles > 1000 and outcome.seconds > 0
    return unseen_suite.json.loads((tmp_path / "report.json").read_text())


def test_volume_of_the_part():
    assert unseen_suite.volume_of(*BOX) == pytest.approx(6000)
    assert unseen_suite.volume_of(BOX[0], BOX[1][:, ::-1]) == pytest.approx(-6000)


@pytest.mark.parametrize(
    "field, value, word",
    [
        ("open_edges", 1, "open"),
        ("misoriented_edges", 3, "open"),
        ("oriented", False, "open"),
        ("self_intersections", 2, "pairs"),
        ("volume", -6000.0, "volume"),
        ("volume", float("nan"), "volume"),
        ("volume", 2000.0, "volume"),
        ("status", "Cancelled", "status"),
    ],
)
def test_each_broken_promise_is_named(report, field, value, word):
    report[field] = value
    (promise,) = unseen_suite.broken_promises(report, 6000.0)
    assert promise.startswith(word)


def test_a_refused_input_is_a_broken_promise(program, tmp_path):
    motion = (np.arange(2.0), np.array([[0, 0, 0, 1.0], [1, 0, 0, 0]]), np.zeros((2, 3)))
    outcome = unseen_suite.run_case(case_of(BOX, motion), pathlib.Path(program), tmp_path)
    assert outcome.broken[0].startswith("status") and outcome.triangles == 0


def test_the_slowest_for_their_output_come_first():
    runs = [Outcome(f"run {n}", 1.0, 100_000 * (n + 1), ()) for n in range(12)]
    runs.append(Outcome("slow", 100.0, 100_000, ("pairs: 3",)))
    lines = unseen_suite.table(runs)
    assert "13 runs" in lines[0]
    assert lines[1].endswith("slow") and lines[1].startswith("*")
    assert lines[2].endswith("run 0") and len(lines) == 12
    assert lines[-1] == "BROKEN pairs: 3  slow"


def test_little_output_does_not_make_a_quick_run_slow():
    assert Outcome("", 0.02, 12, ()).microseconds == pytest.approx(1.0)


def test_no_drawn_cell_is_larger_than_the_part():
    fewest = []
    for case in unseen_inputs.cases(3, 60, most_triangles=300, most_poses=300):
        part, travel = np.ptp(case.mesh[0], axis=0).max(), np.ptp(case.motion[2], axis=0).max()
        assert travel / case.options["resolution"] < part
        fewest.append(travel / part)
    assert max(fewest) > 24  # 24 cells, the smallest resolution, would be too few
