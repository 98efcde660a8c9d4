# SPDX-License-Identifier: LGPL-2.1-or-later
"""An accuracy in mm, given instead of cell size, tolerance and chord error: in Python, program and studies.
"""
import numpy as np
import pytest

import bodies
import swept_volume as sv
from test_program import call, envelope, inputs  # noqa: F401
from test_recut import slide
from test_reports import report_of, validator  # noqa: F401


def depths(points, half, travel):
    """Returns signed distances (negative inside) of points (N, 3) from the sweep of a box along `travel`: the
    largest distance from its bounding planes. The box has these half sizes and the origin as its middle.
    """
    planes = [sign * axis for axis in np.eye(3) for sign in (-1, 1)]
    for axis in np.eye(3):
        across = np.cross(axis, travel)
        planes += [sign * across / np.linalg.norm(across) for sign in (-1, 1)]
    planes = np.array(planes)
    farthest = np.abs(planes) @ half + np.maximum(planes @ travel, 0)
    return (points @ planes.T - farthest).max(axis=1)


@pytest.mark.parametrize("accuracy", [1.5, 0.4])
def test_the_surface_lies_within_the_accuracy(accuracy):
    half, travel = np.array([4.0, 2.0, 1.0]), slide()[1, :3, 3]
    result = sv.compute(bodies.box(-half, half), slide_motion(), accuracy=accuracy)
    bound = result.report["accuracy_bound"]
    assert 0 < bound <= accuracy
    centres = result.vertices[result.triangles].mean(axis=1)
    off = np.abs(depths(np.vstack([result.vertices, centres]), half, travel))
    assert off.max() <= bound
    assert result.report["simplification_deviation"] > 0


def slide_motion():
    poses = slide()
    return sv.Motion([0, 1], [[0, 0, 0, 1]] * 2, poses[:, :3, 3])


def test_a_finer_accuracy_is_nearer(box):
    coarse, fine = (sv.compute(box, slide_motion(), accuracy=a).report for a in (2.0, 0.5))
    assert fine["accuracy_bound"] < coarse["accuracy_bound"] / 3
    assert fine["cell"] < coarse["cell"]


@pytest.mark.parametrize(
    "other", [{"resolution": 64}, {"cell": 1}, {"tolerance": 1}, {"chord_tolerance": 0.1}]
)
def test_python_refuses_what_the_accuracy_chooses(box, other):
    with pytest.raises(sv.InvalidInput, match="exclude one another"):
        sv.compute(box, slide_motion(), accuracy=1, **other)


@pytest.mark.parametrize("accuracy", [0, -1, np.nan, np.inf])
def test_python_refuses_an_accuracy_that_is_not_above_0(box, accuracy):
    with pytest.raises(sv.InvalidInput, match="above 0"):
        sv.compute(box, slide_motion(), accuracy=accuracy)


def test_the_estimate_follows_the_accuracy(box):
    estimated = sv.estimate(box, slide_motion(), accuracy=0.5, trial=False)
    assert estimated["cell"] == sv.compute(box, slide_motion(), accuracy=0.5).report["cell"]


def test_program(report_of, inputs):  # noqa: F811
    report = report_of(*envelope(inputs, "o.ply", "--accuracy", 1))
    assert 0 < report["accuracy_bound"] <= 1


def test_program_refuses_what_the_accuracy_chooses(call, inputs):  # noqa: F811
    for other in ("--resolution", "--cell", "--tolerance", "--chord-tolerance"):
        done = call(*envelope(inputs, "o.ply", "--accuracy", 1, other, 64))
        assert done.returncode == 2 and "--accuracy" in done.stderr
    done = call(*envelope(inputs, "o.ply", "--accuracy", 0))
    assert done.returncode == 2 and "above 0" in done.stderr
