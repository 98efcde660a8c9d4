# SPDX-License-Identifier: LGPL-2.1-or-later
"""The pivot of a motion: the point of the body that goes straight between two poses."""
import json
import math
import pickle
import subprocess

import numpy as np
import pytest
from bodies import box

import _swept
import swept_volume as sv

MIDDLE = np.array([105.0, 5.0, 5.0])
REACH = 5 * math.sqrt(2)
CUBE = box((100, 0, 0), (110, 10, 10))
TURN = np.array([[0.0, -1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0]])  # 90 degrees about z
TIMES, QUATERNIONS = [0, 1], [[0, 0, 0, 1], [0, 0, math.sqrt(0.5), math.sqrt(0.5)]]


def turned_in_place(**options):
    """Returns a motion of the cube: a turn by 90 degrees about its middle."""
    return sv.Motion(TIMES, QUATERNIONS, [np.zeros(3), MIDDLE - TURN @ MIDDLE], **options)


def box_of(result):
    return result.vertices.min(axis=0), result.vertices.max(axis=0)


def assert_in_place(result):
    low, high = box_of(result)
    np.testing.assert_allclose(low[:2], MIDDLE[:2] - REACH, atol=0.25)
    np.testing.assert_allclose(high[:2], MIDDLE[:2] + REACH, atol=0.25)


def test_a_pose_turned_in_place_does_not_make_the_body_swing():
    low, high = box_of(sv.compute(CUBE, turned_in_place(), cell=0.25))
    assert (high - low)[1] > 2 * REACH + 14
    assert_in_place(sv.compute(CUBE, turned_in_place(pivot=MIDDLE), cell=0.25))


def test_it_is_the_motion_of_the_body_seen_from_the_pivot():
    shifted = CUBE[0] - MIDDLE, CUBE[1]
    carried = sv.Motion(TIMES, QUATERNIONS, [MIDDLE, MIDDLE])
    one = sv.compute(CUBE, turned_in_place(pivot=MIDDLE), cell=0.5)
    other = sv.compute(shifted, carried, cell=0.5)
    np.testing.assert_allclose(box_of(one), box_of(other), atol=1e-5)
    assert one.report["volume"] == pytest.approx(other.report["volume"], rel=2e-4)
    assert one.report["refined_placements"] == other.report["refined_placements"]


@pytest.mark.parametrize("interpolation", ["none", "screw"])
def test_copies_and_screws_do_not_depend_on_it(interpolation):
    still = turned_in_place(interpolation=interpolation)
    one, other = (sv.compute(CUBE, m, cell=1.0) for m in (still, still.with_pivot(MIDDLE)))
    assert np.array_equal(one.vertices, other.vertices)


def test_estimates_and_previews_know_it():
    assert sv.estimate(CUBE, turned_in_place(pivot=MIDDLE), cell=0.5)["grid"][1] < 40
    assert sv.estimate(CUBE, turned_in_place(), cell=0.5)["grid"][1] > 56
    session = sv.PreviewSession(CUBE, cell=0.25)
    fresh = session.compute(turned_in_place())
    assert_in_place(session.compute(turned_in_place(pivot=MIDDLE)))
    again = session.compute(turned_in_place())
    np.testing.assert_allclose(box_of(again), box_of(fresh), atol=0.3)


def test_clearance_goes_the_same_way_and_tells_the_placement_of_the_body():
    wall = box((100, 5 + REACH + 2, 0), (110, 5 + REACH + 12, 10))
    args = [("wall", wall)]
    swinging = sv.clearance(CUBE, turned_in_place(), args)["neighbours"][0]
    assert swinging["verdict"] == "clash"
    found = sv.clearance(CUBE, turned_in_place(pivot=MIDDLE), args)["neighbours"][0]
    assert found["verdict"] == "clear" and found["distance"] == pytest.approx(2, abs=0.02)
    x, y, z, w = found["pose"]["quaternion_xyzw"]
    assert found["time_seconds"] == pytest.approx(0.5, abs=0.01)
    angle = 2 * math.atan2(z, w)
    turn = np.array(
        [[math.cos(angle), -math.sin(angle)], [math.sin(angle), math.cos(angle)]],
    )
    here = turn @ MIDDLE[:2] + found["pose"]["translation"][:2]
    np.testing.assert_allclose(here, MIDDLE[:2], atol=1e-9)


def test_motions_with_a_pivot_are_values():
    motion = turned_in_place(pivot=MIDDLE)
    assert motion != turned_in_place() and motion == turned_in_place().with_pivot(MIDDLE)
    assert pickle.loads(pickle.dumps(motion)) == motion
    assert "pivot 105, 5, 5 mm" in repr(motion) and "pivot" not in repr(turned_in_place())
    with pytest.raises(ValueError):
        motion.pivot[0] = 1.0
    with pytest.raises(ValueError, match="pivot has shape"):
        turned_in_place(pivot=[1, 2])


@pytest.mark.parametrize("bad", [math.nan, math.inf, 1e10])
def test_a_pivot_beyond_all_measure_is_refused(bad):
    for run in (sv.compute, sv.estimate):
        with pytest.raises(_swept.InvalidInput, match="the pivot is") as error:
            run(CUBE, turned_in_place(pivot=[0, bad, 0]))
        assert error.value.code == "BadOption"


def test_the_program_takes_it(program, tmp_path):
    sv.write_mesh(tmp_path / "cube.ply", CUBE)
    rows = ["0,0,0,0,0,0,0,1"]
    end = MIDDLE - TURN @ MIDDLE
    rows.append(",".join(repr(float(n)) for n in [1, *end, *QUATERNIONS[1]]))
    (tmp_path / "turn.csv").write_text("t,tx,ty,tz,qx,qy,qz,qw\n" + "\n".join(rows) + "\n")
    sv.write_mesh(tmp_path / "wall.ply", box((100, 14.2, 0), (110, 20, 10)))

    def call(*words):
        done = subprocess.run([program, *words], capture_output=True, text=True, cwd=tmp_path)
        return done.returncode, done.stderr

    same = ["cube.ply", "--motion", "turn.csv"]
    out = ["-o", "e.ply", "--cell", "0.25", "--report", "r.json"]
    assert call("envelope", *same, *out, "--pivot", "105,5,5")[0] == 0
    mesh = sv.read_mesh(tmp_path / "e.ply")
    assert_in_place(sv.Result(mesh, {}))
    assert json.loads((tmp_path / "r.json").read_text())["pivot"] == [105, 5, 5]
    code, _ = call("clearance", "cube.ply", "wall.ply", "--motion", "turn.csv")
    assert code == 3
    code, text = call(
        "clearance", "cube.ply", "wall.ply", "--motion", "turn.csv", "--pivot", "105,5,5"
    )
    assert code == 0, text
    for wrong in ("105,5", "a,b,c", "1,2,3,4", ""):
        code, text = call("envelope", *same, *out, "--pivot", wrong)
        assert code == 2 and "--pivot" in text, (wrong, text)
