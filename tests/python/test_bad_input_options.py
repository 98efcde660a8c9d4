# SPDX-License-Identifier: LGPL-2.1-or-later
"""Row 16 of docs/bad_input.md: invalid numbers of threads and options of solids, in every function that
takes them.
"""
import numpy as np
import pytest

import _swept

STILL = np.eye(4)[None]


@pytest.mark.parametrize("threads", [-1, 4097, 2**31 - 1])
def test_bad_input_16_threads(box, tmp_path, threads):
    run = _swept.RunContext(threads=threads)
    calls = [
        lambda: _swept.compute(*box, STILL, resolution=16, run=run),
        lambda: _swept.compute(*box, STILL, resolution=16, tolerance=0.1).recut(0.2, run),
        lambda: _swept.PreviewSession(*box, resolution=16).compute(STILL, run=run),
        lambda: _swept.check_mesh(*box, run=run),
    ]
    if hasattr(_swept, "clearance"):
        calls.append(lambda: _swept.clearance(*box, STILL, [("far", box[0] + 99, box[1])], run=run))
    if _swept.HAS_SOLIDS:
        calls.append(lambda: _swept.write_solid(tmp_path / "box.step", *box, run=run))
    for call in calls:
        with pytest.raises(_swept.InvalidInput) as caught:
            call()
        assert caught.value.code == "BadOption"
        assert f"threads is {threads}; allowed: 1 to 4096, or not given (all cores)" in str(
            caught.value
        )


@pytest.mark.skipif(not _swept.HAS_SOLIDS, reason="built without OpenCASCADE")
@pytest.mark.parametrize(
    ("option", "value", "said"),
    [
        ("tolerance", float("inf"), "tolerance is inf mm; allowed: 0 to 1e9 mm"),
        ("planar_tolerance", -1.0, "the planar tolerance is -1 mm; allowed"),
        ("product_name", "x" * 100000, "the product's name has 100000 bytes; allowed: up to 1000"),
        ("colour", [0.5, float("nan"), 0], "a component of the colour is nan; allowed: 0 to 1"),
        ("max_faces", 3, "the limit of faces is 3; allowed: 4 or more"),
    ],
)
def test_bad_input_16_solid_options(box, tmp_path, option, value, said):
    target = tmp_path / "box.step"
    for call in (
        lambda: _swept.write_solid(target, *box, **{option: value}),
        lambda: _swept.estimate_solid(*box, **{option: value}),
    ):
        with pytest.raises(_swept.ExportFailed) as caught:
            call()
        assert caught.value.code == "BadOption" and said in str(caught.value)
    assert list(tmp_path.iterdir()) == []
