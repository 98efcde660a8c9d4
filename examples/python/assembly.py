# SPDX-License-Identifier: LGPL-2.1-or-later
"""Checks parts that move at the same time, checks a part with a rule for a neighbour, and finds a path.

    python3 assembly.py path.csv
"""
import sys

import numpy as np

import swept_volume as sv
from sweep_box import box

STILL = [0.0, 0.0, 0.0, 1.0]


def slide(start: float, end: float) -> sv.Motion:
    """Returns a motion along x from start to end (mm) in one second."""
    return sv.Motion([0, 1], [STILL, STILL], [[start, 0, 0], [end, 0, 0]])


def turn(angle: float) -> sv.Motion:
    """Returns a turn about z by an angle (rad) in one second."""
    return sv.Motion(
        [0, 1], [STILL, [0, 0, np.sin(angle / 2), np.cos(angle / 2)]], np.zeros((2, 3))
    )


def check_mechanism() -> None:
    report = sv.mechanism(
        [
            ("slider", box([10, 10, 10], [20, 0, 0]), slide(0, 30)),
            ("crank", box([15, 4, 10]), turn(1.2)),
            ("base", box([80, 80, 5], [-20, -20, -20]), None),
        ],
        required=1.0,
        range=10.0,
        ignored=[("crank", "base")],
    )
    for pair in report["pairs"]:
        row = pair["clearance"]
        print(f"{pair['first']} and {pair['second']}: {row['verdict']}, {row['distance']:.3g} mm")


def check_rules() -> None:
    cover = box([100, 10, 10], [-10, 10, 0])
    report = sv.clearance(
        box([10, 10, 10]), slide(0, 50), [("cover", cover)], required=2.0, rules={"cov*": "contact"}
    )
    for row in report["neighbours"]:
        print(f"{row['name']}: {row['verdict']}, meets its rule: {row['meets_rule']}")


def find_way(path: str) -> None:
    wall = box([4, 60, 60], [30, -30, -30])
    start = np.eye(4)
    start[0, 3] = 80
    report, motion = sv.find_path(
        box([10, 10, 10]), np.eye(4), [("wall", wall)], start=start, clearance=1.0
    )
    print(f"way: {report['verdict']}")
    if motion is not None:
        rows = np.column_stack([motion.times, motion.translations, motion.quaternions])
        np.savetxt(path, rows, "%.17g", ",", header="t,tx,ty,tz,qx,qy,qz,qw", comments="")


if __name__ == "__main__":
    check_mechanism()
    check_rules()
    find_way(sys.argv[1])
