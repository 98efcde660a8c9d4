#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Makes solids of bodies with planes and cylinders that move along random motions and turn at the same time.

Half of the motions have two keys, the others three. Each key is 20 to 70 mm from the one before it,
and turned by 10 to 60 degrees. With --sliding, the motions are such that faces slide along
themselves: one half lies in planes, the others have straight steps before or after a turn.

Prints a row for each solid that contains facets or is not valid, then for each body: the number of
motions, of solids without facets, their faces, and the largest B-rep tolerance and deviation.

Usage: turning_suite.py [--sliding] BUILD [COUNT] [BODY...]
COUNT: motions for each body (default 25). BODY: box, ell, star, prism or cylinder (default: all).
The cylinder needs FreeCAD.
Ends with 1 if a solid is missing or not valid.
"""
import json
import math
import pathlib
import subprocess
import sys
import tempfile

import numpy as np
from shared_data import product, turn
from source_suite import kernel_module
from thin_parts import loft
from unseen_suite import write_ply

RESOLUTION, TOLERANCE, SEED = 64, 0.1, 2026


def polygon(corners, radii):
    return [
        (radii[i % len(radii)] * math.cos(a), radii[i % len(radii)] * math.sin(a))
        for i, a in enumerate(2 * math.pi * np.arange(corners) / corners)
    ]


CYLINDER = (12, 30)  # radius and height, mm
# The other bodies are prisms: base (mm), counter-clockwise, and height (mm).
PRISMS = {
    "box": ([(0, 0), (40, 0), (40, 25), (0, 25)], 15),
    "ell": ([(0, 0), (40, 0), (40, 12), (12, 12), (12, 30), (0, 30)], 15),
    "star": (polygon(10, (20, 9)), 10),
    "prism": (polygon(7, (15,)), 30),
}


def random_motions(count):
    rng = np.random.default_rng(SEED)
    for case in range(count):
        place, turned = np.zeros(3), turn((0, 0, 1), 0)
        rows = [[0, *place, *turned]]
        for key in range(1 + case % 2):
            step = rng.normal(size=3)
            place = place + step / np.linalg.norm(step) * rng.uniform(20, 70)
            turned = product(turn(rng.normal(size=3), rng.uniform(10, 60)), turned)
            rows.append([key + 1, *place, *turned])
        yield np.array(rows)


def moved(rng, place, turned, axis=None):
    """Returns the next key; if the number of an axis is given, one in the plane across this axis."""
    step = rng.normal(size=3)
    if axis is not None:
        step[axis] = 0
    place = place + step / np.linalg.norm(step) * rng.uniform(20, 70)
    about = rng.normal(size=3) if axis is None else rng.choice([-1, 1]) * np.eye(3)[axis]
    return place, product(turn(about, rng.uniform(10, 60)), turned)


def sliding_motions(count):
    rng = np.random.default_rng(SEED)
    x, y, z = np.eye(3)
    for case in range(count):
        keys = [(np.zeros(3), turn((0, 0, 1), 0))]
        kind = case // 2 % 4
        if case % 2 == 0:
            for _ in range(1 + kind % 2):
                keys.append(moved(rng, *keys[-1], axis=(2, 2, 0, 1)[kind]))
        elif kind == 0:
            keys.append((np.eye(3)[case // 8 % 3] * rng.uniform(20, 60), keys[0][1]))
            keys.append(moved(rng, *keys[-1]))
        elif kind == 1:
            keys.append(moved(rng, *keys[0], axis=2))
            keys.append((keys[-1][0] + 40 * z, keys[-1][1]))
        elif kind == 2:
            keys.append(moved(rng, *keys[0], axis=2))
            keys.append(moved(rng, *keys[-1]))
        else:
            keys += [(30 * x, keys[0][1]), (30 * x + 25 * y, keys[0][1])]
            keys.append(moved(rng, *keys[-1], axis=2))
        yield np.array([[number, *place, *turned] for number, (place, turned) in enumerate(keys)])


def run(words):
    return subprocess.run([str(word) for word in words], capture_output=True, text=True)


def make_body(program, body, folder):
    """Returns the STEP file of a body; None if FreeCAD is needed and not installed."""
    part = folder / f"{body}.step"
    if body == "cylinder":
        kernel = kernel_module()
        if kernel is None:
            return None
        kernel.makeCylinder(*CYLINDER).exportStep(str(part))
        return part
    mesh = folder / f"{body}.ply"
    base, height = PRISMS[body]
    write_ply(mesh, *loft(base, [0, height]))
    made = run([program, "solid", mesh, "--output", part, "--exact"])
    if made.returncode != 0:
        sys.exit(made.stderr)
    return part


def main():
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    words = [word for word in sys.argv[1:] if word != "--sliding"]
    motions = random_motions if len(words) + 1 == len(sys.argv) else sliding_motions
    program = pathlib.Path(words[0]) / "bin" / "swept"
    count = int(words[1]) if len(words) > 1 else 25
    failed = 0
    table = []
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        for body in words[2:] or [*PRISMS, "cylinder"]:
            part = make_body(program, body, folder)
            if part is None:
                print("SKIPPED:", body, "(FreeCAD not found)")
                continue
            exact = []
            for case, rows in enumerate(motions(count)):
                motion, report = folder / "motion.csv", folder / "report.json"
                np.savetxt(motion, rows, fmt="%.17g", delimiter=",")
                options = ["--output", folder / "envelope.step", "--report", report, "--quiet"]
                options += ["--resolution", RESOLUTION, "--solid-tolerance", TOLERANCE]
                made = run([program, "envelope", part, "--motion", motion] + options)
                solid = (
                    json.loads(report.read_text()).get("solid") if made.returncode == 0 else None
                )
                if solid is None or not solid["valid"]:
                    failed += 1
                    print(body, case, "FAILED", made.stderr[-200:], flush=True)
                elif solid["faces_by_kind"].get("facet", 0):
                    print(body, case, "facets:", solid["faces_by_kind"]["facet"], flush=True)
                else:
                    exact.append(solid)
            row = [body, count, len(exact)]
            if exact:
                faces = [solid["faces"] for solid in exact]
                row.append(f"{min(faces)} to {max(faces)}")
                row += [
                    f"{max(s[key] for s in exact):.2g}" for key in ("edge_tolerance", "deviation")
                ]
            table.append(row)
    print("| body | motions | without facets | faces | B-rep tolerance, mm | deviation, mm |")
    for row in table:
        print("|", " | ".join(map(str, row)), "|")
    sys.exit(1 if failed else 0)


if __name__ == "__main__":
    main()
