# SPDX-License-Identifier: LGPL-2.1-or-later
"""Properties that hold for any body and motion, tested on random cases. Hypothesis draws them, and reduces
the cases that fail.

Each test tries a few cases; with SWEPT_EXAMPLES=500 it tries 500 (.ci/properties). The cases are the same in
every run. Volumes are compared in units of area x cell; each of two results may be off by 0.05.
"""
import os

import numpy as np
from hypothesis import HealthCheck, assume, given, settings
from hypothesis import strategies as st

import _swept
from bodies import ball, box, frame, joined, moved, prism, torus

RESOLUTION = 32
BAR = 0.1

cases = settings(
    max_examples=int(os.environ.get("SWEPT_EXAMPLES", "5")),
    deadline=None,
    derandomize=True,
    suppress_health_check=list(HealthCheck),
)


def number(low, high):
    return st.floats(low, high, allow_nan=False).map(lambda x: round(x, 3))


def vector(half):
    return st.tuples(*[number(-half, half)] * 3)


def frames(half, degrees):
    axis = vector(1).filter(lambda a: np.linalg.norm(a) > 0.2)
    return st.builds(frame, axis, number(0, degrees), vector(half))


pieces = st.one_of(
    st.builds(lambda s: box(-np.array(s), s), st.tuples(*[number(0.6, 2.5)] * 3)),
    st.builds(prism, st.integers(3, 24), number(0.7, 2), number(1, 3), number(0.3, 1.5)),
    st.builds(torus, number(1.8, 2.5), number(0.5, 1), st.integers(8, 24), st.integers(6, 12)),
    st.builds(ball, number(0.8, 2)),
)
placed = st.builds(moved, pieces, frames(1, 180))
bodies = st.one_of(placed, st.builds(joined, placed, placed))


@st.composite
def motions(draw, least=2):
    """Draws (matrices, interpolation), with turns of up to 100 degrees a step."""
    now, path = draw(frames(50, 180)), []
    for _ in range(draw(st.integers(least, least + 2))):
        path.append(now)
        now = now @ draw(frames(3, 100))
    return np.array(path), draw(st.sampled_from(["linear", "screw", "none"]))


def sweep(body, motion, **options):
    options.setdefault("resolution", RESOLUTION)
    result = _swept.compute(*body, motion[0], interpolation=motion[1], **options)
    report = result.report
    assert report["closed"] and report["manifold"] and report["oriented"]
    again = _swept.check_mesh(result.vertices, result.triangles)
    assert again["passes"] and again["volume"] == report["volume"]
    return result


def gap(a, b):
    """Returns the difference of two volumes in units of area x cell."""
    cell = max(a.report["cell"], b.report["cell"])
    return (a.report["volume"] - b.report["volume"]) / (max(a.report["area"], 1e-9) * cell)


@cases
@given(bodies, motions(), frames(100, 180))
def test_moving_everything_moves_the_result(body, motion, away):
    here = sweep(body, motion)
    there = sweep(body, (away @ motion[0], motion[1]), cell=here.report["cell"])
    assert abs(gap(here, there)) <= BAR


@cases
@given(bodies, motions())
def test_finer_cells_converge(body, motion):
    coarse = sweep(body, motion, resolution=24)
    fine = sweep(body, motion, resolution=72)
    assert abs(gap(coarse, fine)) <= BAR


@cases
@given(bodies, motions())
def test_reversed_motion_sweeps_the_same(body, motion):
    forth = sweep(body, motion)
    back = sweep(body, (motion[0][::-1], motion[1]), cell=forth.report["cell"])
    assert abs(gap(forth, back)) <= BAR


@cases
@given(bodies, motions())
def test_more_placements_never_remove_volume(body, motion):
    whole = sweep(body, motion)
    first = sweep(body, (motion[0][:-1], motion[1]), cell=whole.report["cell"])
    assert gap(whole, first) >= -BAR


@cases
@given(placed, placed, motions())
def test_two_bodies_together_are_their_union(one, other, motion):
    both = sweep(joined(one, other), motion)
    cell = both.report["cell"]
    a, b = sweep(one, motion, cell=cell), sweep(other, motion, cell=cell)
    assert gap(both, a) >= -BAR and gap(both, b) >= -BAR
    areas = sum(x.report["area"] for x in (both, a, b))
    assert both.report["volume"] <= a.report["volume"] + b.report["volume"] + BAR * cell * areas


@cases
@given(bodies, motions(), st.randoms(use_true_random=False))
def test_order_of_triangles_does_not_matter(body, motion, random):
    vertices, triangles = body
    order = list(range(len(triangles)))
    random.shuffle(order)
    turned = np.array([np.roll(triangles[t], random.randrange(3)) for t in order])
    one, other = sweep(body, motion), sweep((vertices, turned), motion)
    assert abs(gap(one, other)) <= 1e-3


@cases
@given(bodies, motions(least=3))
def test_motion_cut_in_two_is_the_union_of_its_parts(body, motion):
    path, kind = motion
    whole = sweep(body, motion)
    cell = whole.report["cell"]
    parts = [sweep(body, (p, kind), cell=cell) for p in (path[:2], path[1:])]
    assert all(gap(whole, part) >= -BAR for part in parts)
    areas = sum(x.report["area"] for x in [whole] + parts)
    total = sum(part.report["volume"] for part in parts)
    assert whole.report["volume"] <= total + BAR * cell * areas


def orders(low, high):
    """Draws numbers from 10^low to 10^high, each power of ten equally likely."""
    return st.floats(low, high).map(lambda x: 10**x)


@cases
@given(bodies, motions(), orders(-12, 0.4))
def test_offset_grows(body, motion, cells):
    plain = sweep(body, motion)
    cell = plain.report["cell"]
    assume(cell > 0)
    grown = sweep(body, motion, cell=cell, offset=cells * cell)
    assert gap(grown, plain) >= -BAR
    if cells < 0.05:
        most = (cells + BAR) * cell * plain.report["area"]
        assert grown.report["volume"] <= plain.report["volume"] + most


#: Options that reduce accuracy, from almost nothing to a cell: name, value in cells.
COSTS = st.one_of(
    st.tuples(st.sampled_from(["tolerance", "position_filter"]), orders(-12, 0)),
    st.tuples(st.just("chord_tolerance"), orders(-4, 0)),
    st.tuples(st.just("weld_tolerance"), orders(-12, -4)),
)


@cases
@given(bodies, motions(), COSTS)
def test_options_cost_no_more_than_they_say(body, motion, cost):
    plain = sweep(body, motion)
    name, cells = cost
    cell = plain.report["cell"]
    costly = sweep(body, motion, cell=cell, **{name: cells * cell})
    assert abs(gap(costly, plain)) <= BAR + cells
