#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Counts intersecting pairs of triangles in envelopes of the shared meshes: still, 16 and 34 keys.

    intersections.py BUILD RESOLUTION... [--only WORD]

Prints every run with such pairs, and the number of runs without. The 16 keys are the arc made for the
mesh if there is one, otherwise the arc of the bunny, scaled and moved to the middle of the mesh.
"""
import argparse
import pathlib
import sys

import numpy as np

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))

from shared_data import FOLDER, rotate  # noqa: E402

METRES = ("armadillo", "bunny", "fandisk", "motorbike", "ship", "space")
ARCS = {"bunny": "bunny", "fandisk": "fandisk", "space": "station"}
STILL = (np.zeros(1), np.array([[0.0, 0, 0, 1]]), np.zeros((1, 3)))


def trajectory(swept, name, unit):
    found = swept.read_trajectory_csv(str(FOLDER / "motions" / name), unit)
    return tuple(map(np.asarray, found))


def middle(vertices):
    return (vertices.min(0) + vertices.max(0)) / 2


def arc(swept, word, unit, vertices):
    """Returns 16 keys on an arc about the mesh."""
    if word in ARCS:
        return trajectory(swept, f"keyposes_16_arc_for_{ARCS[word]}.csv", unit)
    times, turns, shifts = trajectory(swept, "keyposes_16_arc_for_bunny.csv", "m")
    mesh = swept.read_mesh(str(FOLDER / "meshes/bunny_stanford_70k.ply"), "m")
    bunny = np.asarray(mesh.vertices)
    here, there = (np.tile(middle(v), (len(turns), 1)) for v in (vertices, bunny))
    scale = np.ptp(vertices, axis=0).max() / np.ptp(bunny, axis=0).max()
    shift = scale * (shifts - there + rotate(turns, there))  # scaled path of the middle
    return times, turns, here - rotate(turns, here) + shift


def runs(swept, path, resolution):
    """Yields (motion, outcome). The outcome has the numbers of triangles and of intersecting pairs, or
    says why there is no envelope."""
    word = path.name.split("_")[0]
    unit = "m" if word in METRES else "cm" if word == "beam" else "mm"
    mesh = swept.read_mesh(str(path), unit)
    vertices = np.asarray(mesh.vertices)
    for name, motion in (
        ("still", STILL),
        ("16 keys", arc(swept, word, unit, vertices)),
        ("34 keys", trajectory(swept, "installation_34_from_baxter_left.csv", "m")),
    ):
        try:
            made = swept.compute(vertices, mesh.triangles, motion, resolution=resolution)
            yield name, (made.report["triangles"], made.report["self_intersections"])
        except swept.Error as error:
            yield name, f"{error.status} {error.code}"


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("build")
    parser.add_argument("resolution", type=int, nargs="+")
    parser.add_argument("--only", default="")
    arguments = parser.parse_args()
    sys.path.insert(0, str(pathlib.Path(arguments.build) / "python"))
    import _swept

    for resolution in arguments.resolution:
        free = 0
        meshes = sorted((FOLDER / "meshes").glob("*.ply"))
        for path in (m for m in meshes if arguments.only in m.name):
            for motion, outcome in runs(_swept, path, resolution):
                if not isinstance(outcome, str) and outcome[1] == 0:
                    free += 1
                else:
                    print(f"{resolution} {path.stem}, {motion}: {outcome}", flush=True)
        print(f"{resolution}: {free} runs free of them", flush=True)


if __name__ == "__main__":
    main()
