# SPDX-License-Identifier: LGPL-2.1-or-later
"""Computes the volume that an end mill cuts: the envelope of a cylinder that follows a CNC program for three
axes.

    python3 cnc.py ../data/pocket.nc 6 cut.stl

Arguments: program, diameter of the mill in mm, output. Known words: G0, G1, G2 and G3 in the plane XY with
I and J, G20 and G21, G90 and G91, F. Other words are ignored.
"""
import re
import sys
from typing import Dict, Iterator, List, Tuple

import numpy as np
import numpy.typing as npt

import swept_volume as sv
from robot import cylinder

Array = npt.NDArray[np.float64]
CHORD = 0.01  # mm: largest distance of a chord from its arc
RAPID = 5000.0  # mm/min, for G0


def words_of(line: str) -> List[Tuple[str, float]]:
    plain = re.sub(r"\(.*?\)|;.*", "", line).upper()
    return [(a, float(b)) for a, b in re.findall(r"([A-Z])\s*([-+]?\d*\.?\d+)", plain)]


def arc(start: Array, end: Array, centre: Array, clockwise: bool) -> Iterator[Array]:
    """Yields the points of an arc in the plane XY without its start; z changes evenly."""
    a, b = start[:2] - centre, end[:2] - centre
    radius = float(np.linalg.norm(a))
    first, last = np.arctan2(a[1], a[0]), np.arctan2(b[1], b[0])
    turn = (first - last if clockwise else last - first) % (2 * np.pi) or 2 * np.pi
    step = 2 * np.arccos(max(-1.0, 1 - CHORD / radius))
    count = max(1, int(np.ceil(turn / step)))
    for n in range(1, count + 1):
        angle = first + turn * n / count * (-1 if clockwise else 1)
        x, y = centre + radius * np.array([np.cos(angle), np.sin(angle)])
        yield np.array([x, y, start[2] + (end[2] - start[2]) * n / count])


def tool_path(text: str) -> Tuple[Array, Array]:
    """Returns times (K,), s, and positions (K, 3), mm, of the mill's tip."""
    unit, absolute, mode, feed = 1.0, True, 0, 500.0
    points, times = [np.zeros(3)], [0.0]
    for line in text.splitlines():
        given: Dict[str, float] = {}
        for letter, value in words_of(line):
            if letter == "G" and value in (0, 1, 2, 3):
                mode = int(value)
            elif letter == "G" and value in (20, 21):
                unit = 25.4 if value == 20 else 1.0
            elif letter == "G" and value in (90, 91):
                absolute = value == 90
            elif letter == "F":
                feed = value * unit
            elif letter in "XYZIJ":
                given[letter] = value * unit
        if not set(given) & set("XYZ"):
            continue
        start = points[-1]
        end = np.array([given.get(a, s if absolute else 0.0) for a, s in zip("XYZ", start)])
        end = end if absolute else start + end
        centre = start[:2] + [given.get("I", 0.0), given.get("J", 0.0)]
        way = [end] if mode < 2 else list(arc(start, end, centre, mode == 2))
        for point in way:
            length = float(np.linalg.norm(point - points[-1]))
            if length > 0:
                times.append(times[-1] + 60 * length / (RAPID if mode == 0 else feed))
                points.append(point)
    return np.array(times), np.array(points)


def main(program: str, diameter: float, output: str) -> None:
    with open(program) as file:
        times, points = tool_path(file.read())
    height = 20.0
    tool = cylinder(diameter / 2, height)
    tip = sv.Mesh(tool.vertices + [0, 0, height / 2], tool.triangles)
    turns = np.tile([0.0, 0.0, 0.0, 1.0], (len(times), 1))
    result = sv.compute(tip, sv.Motion(times, turns, points), cell=0.25)
    result.mesh.write(output)
    low, high = result.mesh.vertices.min(axis=0), result.mesh.vertices.max(axis=0)
    size = " x ".join(f"{side:.4g}" for side in high - low)
    print(f"{len(times)} positions in {times[-1]:.3g} s; the cut spans {size} mm")


if __name__ == "__main__":
    main(sys.argv[1], float(sys.argv[2]), sys.argv[3])
