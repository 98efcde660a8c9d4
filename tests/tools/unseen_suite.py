# SPDX-License-Identifier: LGPL-2.1-or-later
"""Runs the program on random inputs (unseen_inputs.py) and looks for slow runs and broken promises.

    python3 tests/tools/unseen_suite.py [SECONDS] [--program build/bin/swept] [--seed 1]

Draws one input after another until the time is over. Each runs in a process of its own and may take
MOST_SECONDS of the processor. Prints the slowest ten by processor time for each triangle of the
result, and all that break a promise:
    status      the run ends with something else than Ok, or takes too long
    open        the mesh is not closed, not manifold or not oriented
    pairs       triangles that meet where they should not
    volume      negative, not a number, or below half of that of the part itself
Exit status 1 if a promise is broken; slow runs are only listed.
"""
import argparse
import dataclasses
import json
import math
import pathlib
import resource
import subprocess
import sys
import tempfile
import time

import numpy as np
import unseen_inputs

MOST_SECONDS = 300
#: A smaller output counts as this many triangles, because every run needs some time to start.
LEAST_OUTPUT = 20_000
SLOW_FACTOR = 20  # a run that takes this many times the median is marked as slow


@dataclasses.dataclass(frozen=True)
class Outcome:
    """The result of one run. Seconds are CPU seconds."""

    name: str
    seconds: float
    triangles: int
    broken: tuple

    @property
    def microseconds(self):
        """Returns the CPU microseconds for each triangle of the result."""
        return 1e6 * self.seconds / max(LEAST_OUTPUT, self.triangles)


def volume_of(vertices, triangles):
    """Returns the signed volume; positive for a closed mesh that faces outwards."""
    a, b, c = (vertices[triangles[:, n]] - vertices.mean(axis=0) for n in range(3))
    return float(np.einsum("ij,ij->i", a, np.cross(b, c)).sum() / 6)


def broken_promises(report, part_volume):
    """Returns the broken promises of a report, as words of the list above. part_volume: mm^3.

    The surface may deviate by a part of a cell, and a part may be thinner than a cell. So the volume must
    only be at least half of that of the part.
    """
    if report["status"] != "Ok":
        return (f"status {report['status']} {report.get('code', '')}: {report['message']}",)
    broken = []
    counted = ("open_edges", "non_manifold_edges", "non_manifold_vertices", "misoriented_edges")
    for name in counted:
        if report[name] > 0:
            broken.append(f"open: {report[name]} {name}")
    for name in ("finite", "closed", "manifold", "oriented"):
        if not report[name]:
            broken.append(f"open: not {name}")
    if report["self_intersections"] > 0:
        broken.append(f"pairs: {report['self_intersections']}")
    volume = report["volume"]
    if not (math.isfinite(volume) and volume > 0) or volume < part_volume / 2:
        broken.append(f"volume: {volume:.6g} mm3, the part has {part_volume:.6g}")
    return tuple(broken)


def write_ply(path, vertices, triangles):
    """Writes a binary PLY file with double coordinates."""
    rows = np.empty(len(triangles), dtype=[("n", "u1"), ("v", "<i4", 3)])
    rows["n"], rows["v"] = 3, triangles
    head = (
        "ply\nformat binary_little_endian 1.0\n"
        f"element vertex {len(vertices)}\n"
        "property double x\nproperty double y\nproperty double z\n"
        f"element face {len(triangles)}\nproperty list uchar int vertex_indices\nend_header\n"
    )
    path.write_bytes(head.encode() + np.asarray(vertices, "<f8").tobytes() + rows.tobytes())


def run_case(case, program, folder):
    """Runs the program on a case. Returns an Outcome."""
    vertices, triangles = case.mesh
    times, quaternions, places = case.motion
    write_ply(folder / "part.ply", vertices, triangles)
    np.savetxt(folder / "motion.csv", np.column_stack([times, places, quaternions]), fmt="%.17g",
               delimiter=",", header="t,tx,ty,tz,qx,qy,qz,qw", comments="")  # fmt: skip
    words = [program, "envelope", folder / "part.ply", "--motion", folder / "motion.csv",
             "--output", folder / "out.ply", "--report", folder / "report.json", "--quiet"]  # fmt: skip
    for option, value in case.options.items():
        words += [f"--{option}", str(value)]
    (folder / "report.json").unlink(missing_ok=True)

    def limit():
        resource.setrlimit(resource.RLIMIT_CPU, (MOST_SECONDS, MOST_SECONDS + 5))

    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    done = subprocess.run(words, capture_output=True, text=True, preexec_fn=limit)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    seconds = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
    if not (folder / "report.json").exists():
        errors = done.stderr.strip().splitlines()[-1:] or ["nothing said"]
        return Outcome(case.name, seconds, 0, (f"status {done.returncode}: {errors[0]}",))
    report = json.loads((folder / "report.json").read_text())
    return Outcome(case.name, seconds, report.get("triangles", 0),
                   broken_promises(report, volume_of(vertices, triangles)))  # fmt: skip


def table(outcomes):
    """Returns the lines to print: the slowest ten, the median, and the runs that break a promise."""
    lines = []
    if not outcomes:
        return ["no run"]
    slowest = sorted(outcomes, key=lambda o: -o.microseconds)
    median = slowest[len(slowest) // 2].microseconds
    lines.append(f"{len(outcomes)} runs; median {median:.1f} us of the processor for a triangle")
    for o in slowest[:10]:
        mark = "*" if o.microseconds > SLOW_FACTOR * median else " "
        lines.append(
            f"{mark} {o.microseconds:9.1f} us  {o.seconds:8.2f} s  {o.triangles:8d}  {o.name}"
        )
    for o in outcomes:
        lines += [f"BROKEN {promise}  {o.name}" for promise in o.broken]
    return lines


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("seconds", type=float, nargs="?", default=600)
    parser.add_argument("--program", type=pathlib.Path, default=pathlib.Path("build/bin/swept"))
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--copies", type=float, default=math.inf, help="triangles x poses at most")
    given = parser.parse_args()
    end = time.monotonic() + given.seconds
    outcomes, number = [], 0
    with tempfile.TemporaryDirectory() as name:
        while time.monotonic() < end:
            case = unseen_inputs.draw_case(1_000_003 * given.seed + number)
            number += 1
            if case.copies > given.copies:
                continue
            outcomes.append(run_case(case, given.program.resolve(), pathlib.Path(name)))
            last = outcomes[-1]
            print(f"{last.seconds:8.2f} s  {'; '.join(last.broken) or 'as promised'}  {last.name}",
                  flush=True)  # fmt: skip
    print("\n".join(table(outcomes)))
    return 1 if any(o.broken for o in outcomes) else 0


if __name__ == "__main__":
    sys.exit(main())
