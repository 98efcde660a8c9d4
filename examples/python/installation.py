# SPDX-License-Identifier: LGPL-2.1-or-later
"""Finds the order in which two parts can be installed into a case, and a motion for each of them. Measures
the volume that both swept spaces share, and checks each motion with a study.

    python3 installation.py folder
"""
import pathlib
import sys
from typing import Dict, List, Tuple

import numpy as np

import swept_volume as sv
from sweep_box import box

CASE: List[Tuple[str, sv.Mesh]] = [
    ("floor", box([26, 26, 3], [-13, -13, -3])),
    ("west", box([3, 26, 40], [-13, -13, 0])),
    ("east", box([3, 26, 40], [10, -13, 0])),
    ("south", box([20, 3, 40], [-10, -13, 0])),
    ("north", box([20, 3, 40], [-10, 10, 0])),
]
PARTS: Dict[str, sv.Mesh] = {
    "lid": box([18, 18, 9], [-9, -9, 11]),
    "motor": box([18, 18, 9], [-9, -9, 1]),
}
STUDY = """
[defaults]
neighbours = [{neighbours}]
clearance = {{ required = 0.4 }}
compute = ["clearance"]
[[run]]
part = "motor.ply"
motion = "motor.csv"
"""


def find_motions() -> Dict[str, sv.Motion]:
    parts = [sv.SequencePart(name, mesh, extract=90.0) for name, mesh in PARTS.items()]
    report, motions = sv.find_sequence(parts, CASE, order="find", clearance=0.4)
    print("order: " + ", ".join(step["part"] for step in report["steps"]))
    if motions is None:
        sys.exit(report["summary"])
    return motions


def compare_spaces(motions: Dict[str, sv.Motion]) -> None:
    """Prints the volume that both swept spaces share. Parts that take the same path one after the
    other may share space."""
    spaces = [(name, sv.compute(PARTS[name], motions[name]).mesh) for name in PARTS]
    report, shared = sv.overlap(spaces)
    (pair,) = report["pairs"]
    text = f"{pair['first']} and {pair['second']} share {pair['volume']:.0f} mm^3"
    print(text if shared[0] is not None else "they share no space")


def check(folder: pathlib.Path, motions: Dict[str, sv.Motion]) -> None:
    for name, mesh in [*CASE, *PARTS.items()]:
        sv.write_mesh(folder / f"{name}.ply", mesh)
    for name, motion in motions.items():
        rows = np.column_stack([motion.times, motion.translations, motion.quaternions])
        np.savetxt(folder / f"{name}.csv", rows, "%.17g", ",", comments="")
    neighbours = ", ".join(f'"{name}.ply"' for name, _ in CASE)
    (folder / "study.toml").write_text(STUDY.format(neighbours=neighbours))
    report = sv.run_study(folder / "study.toml")
    print(f"study: {report['done']} done, nearest {report['runs'][0]['distance']:.3g} mm")


if __name__ == "__main__":
    target = pathlib.Path(sys.argv[1])
    target.mkdir()
    found = find_motions()
    compare_spaces(found)
    check(target, found)
