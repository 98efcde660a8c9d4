# SPDX-License-Identifier: LGPL-2.1-or-later
"""Times the check of a mechanism of fifty moving parts, each with its own motion of 1,000 poses.

    python3 tests/tools/fifty_parts.py [BUILD_FOLDER] [DISTANCE ...]

The parts are bumpy balls of 20,160 triangles and about 20 mm across. They stand in a lattice of 10 x 5 with
DISTANCE (mm) from centre to centre, spin and swing. The required distance is 5 mm. The smaller DISTANCE is,
the more of the 85 pairs of neighbours clash. Prints one row of the table in docs/clearance.md per DISTANCE.
"""
import collections
import pathlib
import resource
import sys
import time

import numpy as np

ROOT = pathlib.Path(__file__).resolve().parents[2]
SEED, PARTS, POSES, RADIUS, SWING = 5, 50, 1000, 10.0, 2.0


def parts(module, bodies, distance):
    """Returns the list of (name, Mesh, Motion) that mechanism() takes."""
    random = np.random.default_rng(SEED)
    times = np.linspace(0, 10, POSES)
    result = []
    for k in range(PARTS):
        vertices, triangles = bodies.ball(1.0, 144, 71)
        waves = random.integers(3, 9, 3)
        bumps = np.prod(np.cos(vertices * waves), axis=1, keepdims=True)
        axis = random.normal(size=3)
        axis /= np.linalg.norm(axis)
        half = np.pi * random.uniform(0.3, 1) * times[:, None]
        centre = np.array([distance * (k % 10), distance * (k // 10), 0.0])
        phases = random.uniform(0, 6, 2)
        swing = [
            np.sin(1.7 * times + phases[0]),
            np.sin(1.3 * times + phases[1]),
            np.sin(times + k),
        ]
        motion = module.Motion(
            times,
            np.hstack([np.sin(half) * axis, np.cos(half)]),
            centre + SWING * np.column_stack(swing),
        )
        mesh = module.Mesh(RADIUS * vertices * (1 + 0.06 * bumps), triangles)
        result.append(("ball {}".format(k + 1), mesh, motion))
    return result


def main(arguments):
    build = ROOT / "build"
    if arguments and not arguments[0].replace(".", "").isdigit():
        build = pathlib.Path(arguments.pop(0))
    sys.path[:0] = [str(build / "python"), str(ROOT / "tests" / "python")]
    import bodies
    import swept_volume

    print("| mm apart | pairs in range | verdicts | queries | proofs | CPU s | s | MB |")
    print("| --- | --- | --- | --- | --- | --- | --- | --- |")
    for distance in [float(x) for x in arguments] or [24.0, 22.0]:
        scene = parts(swept_volume, bodies, distance)
        cpu, wall = time.process_time(), time.monotonic()
        report = swept_volume.mechanism(scene, required=5.0)
        cpu, wall = time.process_time() - cpu, time.monotonic() - wall
        rows = [pair["clearance"] for pair in report["pairs"]]
        verdicts = collections.Counter(row["verdict"] for row in rows)
        print(
            "| {:g} | {} | {} | {:,} | {:,} | {:.1f} | {:.1f} | {:.0f} |".format(
                distance,
                len(rows),
                ", ".join("{} {}".format(n, word) for word, n in sorted(verdicts.items())),
                sum(row["distance_queries"] for row in rows),
                sum(row["certificates"] for row in rows),
                cpu,
                wall,
                resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1e3,
            ),
            flush=True,
        )


if __name__ == "__main__":
    main(sys.argv[1:])
