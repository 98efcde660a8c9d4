# SPDX-License-Identifier: LGPL-2.1-or-later
"""recut(): another tolerance for an envelope that has been computed."""
import numpy as np
import pytest

import _swept


def slide():
    poses = np.tile(np.eye(4), (2, 1, 1))
    poses[1, :3, 3] = 12, 5, 3
    return poses


def test_recut_equals_a_direct_run(box):
    first = _swept.compute(*box, slide(), resolution=48, tolerance=0.05)
    triangles = first.triangles.copy()
    again = first.recut(0.4)
    direct = _swept.compute(*box, slide(), resolution=48, tolerance=0.4)
    assert np.array_equal(again.vertices, direct.vertices)
    assert np.array_equal(again.triangles, direct.triangles)
    assert again.report["simplification_deviation"] <= 0.4
    assert np.array_equal(first.triangles, triangles), "the first result was changed"


def test_recut_to_nothing_gives_the_surface_itself(box):
    first = _swept.compute(*box, slide(), resolution=48, tolerance=0.4)
    plain = _swept.compute(*box, slide(), resolution=48)
    assert np.array_equal(first.recut(0).vertices, plain.vertices)
    assert len(first.triangles) < len(plain.triangles) / 20


def test_recut_is_refused_by_name(box):
    plain = _swept.compute(*box, slide(), resolution=24)
    with pytest.raises(_swept.InvalidInput) as caught:
        plain.recut(0.1)
    assert caught.value.code == "NothingKept"


@pytest.mark.parametrize("tolerance", [-1, 1.1e9, 1e150, np.inf, np.nan])
def test_recut_refuses_the_tolerances_that_compute_refuses(box, tolerance):
    kept = _swept.compute(*box, slide(), resolution=24, tolerance=0.1)
    with pytest.raises(_swept.InvalidInput) as caught:
        kept.recut(tolerance)
    assert caught.value.code == "BadOption"
