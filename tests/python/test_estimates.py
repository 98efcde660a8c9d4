# SPDX-License-Identifier: LGPL-2.1-or-later
"""Compares estimates with runs, over random inputs. Also tests these inputs.

tests/tools/estimate_suite.py does this over all orders of size, which takes minutes.
"""
import pathlib
import sys

import numpy as np
import pytest

import swept_volume as sv
from conftest import BUILD

TOOLS = pathlib.Path(__file__).resolve().parents[1] / "tools"
sys.path.insert(0, str(TOOLS))

import estimate_suite  # noqa: E402
import unseen_inputs  # noqa: E402


def test_the_inputs_are_the_same_for_a_seed_and_solids():
    for seed in range(12):
        case, again = (unseen_inputs.draw_case(seed, most_triangles=5000) for _ in range(2))
        arrays = [*case.mesh, *case.motion]
        assert all(np.array_equal(a, b) for a, b in zip(arrays, [*again.mesh, *again.motion]))
        assert case.options == again.options and 100 <= 4 * len(case.mesh[1])
        check = sv.check_mesh(case.mesh)
        assert check["closed"] and check["manifold"] and check["oriented"], case.name
        times, quaternions, translations = case.motion
        assert len(times) == len(quaternions) == len(translations)
        assert np.allclose(np.linalg.norm(quaternions, axis=1), 1)


@pytest.mark.parametrize(
    "seed",
    [
        1000008,
        1000011,
        1000018,
        1000030,
        1000036,
        2000009,
        2000014,
        43000134,
        53000180,
        67000227,
        73000231,
        403000357,
    ],
)
def test_estimates_are_near_what_runs_take(seed):
    found = estimate_suite.measure(seed, BUILD, threads=1)
    memory, seconds = estimate_suite.factors(found)
    assert memory <= estimate_suite.MOST_MEMORY and seconds <= estimate_suite.MOST_SECONDS, found


def test_far_off_estimates_would_be_found():
    found = {"foreseen": {"memory_bytes": 1e9, "seconds": 1}, "bytes": 4e8, "seconds": 4}
    assert estimate_suite.factors(found) == pytest.approx((2.5, 4))
    found = {"foreseen": {"memory_bytes": 1e6, "seconds": 0.001}, "bytes": 9e6, "seconds": 0.2}
    assert estimate_suite.factors(found) == (1, 1)


def wobble(poses):
    """Returns the recorded motion of a part that hardly moves, and at the end moves 50 mm aside."""
    rng = np.random.default_rng(5)
    places = rng.normal(scale=1e-3, size=(poses, 3))
    places[-10:, 0] += np.linspace(5, 50, 10)
    return np.arange(poses) * 0.001, np.tile([0.0, 0, 0, 1], (poses, 1)), places


def test_a_filter_that_would_save_most_of_the_time_is_named_and_does(box):
    motion = wobble(3000)
    foreseen = sv.estimate(box, motion, interpolation="none", resolution=48)
    useful = foreseen["useful_filter"]
    plain = sv.compute(box, motion, interpolation="none", resolution=48)
    (finding,) = [w for w in plain.report["warnings"] if w["code"] == "FilterUseful"]
    assert f"{useful:.3g}" in finding["text"]
    filtered = sv.compute(box, motion, interpolation="none", resolution=48, position_filter=useful)
    assert filtered.report["refined_placements"] < plain.report["refined_placements"] / 3
    distances = np.abs(sv.distance_to_mesh(filtered.vertices, plain.mesh))
    # The filter moves no point by more than `useful`; twice this length leaves a margin. The rest covers
    # the chord error, and the errors of the crossings of both meshes.
    assert distances.max() < 2 * useful + 0.05 * plain.report["cell"]
    assert not [w for w in filtered.report["warnings"] if w["code"] == "FilterUseful"]
    assert "useful_filter" not in sv.estimate(
        box, motion, interpolation="none", resolution=48, position_filter=useful
    )


def test_with_interpolation_steps_are_merged_and_no_filter_is_named(box):
    report = sv.compute(box, wobble(3000), resolution=48).report
    assert report["placements"] == 3000 and report["refined_placements"] < 1000
    assert 0 < report["chord_error"] <= 0.02 * report["cell"] * 1.000001
    assert not [w for w in report["warnings"] if w["code"] == "FilterUseful"]
    assert "useful_filter" not in sv.estimate(box, wobble(3000), resolution=48)


def test_no_filter_is_named_where_none_saves(box):
    times = np.linspace(0, 1, 2000)
    places = np.stack([200 * times, 0 * times, 0 * times], axis=1)
    motion = times, np.tile([0.0, 0, 0, 1], (2000, 1)), places
    assert "useful_filter" not in sv.estimate(box, motion, resolution=48)
    report = sv.compute(box, motion, resolution=48).report
    assert not [w for w in report["warnings"] if w["code"] == "FilterUseful"]
