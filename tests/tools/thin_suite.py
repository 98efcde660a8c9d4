#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Measures envelopes of parts with thin walls (thin_parts.py) against the truth over continuous time.

    python3 tests/tools/thin_suite.py [BUILD] [--cells 112 256] [--samples 6000] [--parts fins gear ...]

Needs BUILD/bin/swept_deviation. Prints one row of a Markdown table for each part and number of cells;
lengths in cells.
"""
import argparse
import pathlib
import re
import subprocess
import tempfile

import thin_parts

#: Patterns of the figures that swept_deviation prints, in the order of the columns.
FIGURES = (
    r"creases .*mean (\S+)  p99 (\S+)",
    r"degrees off: (\S+) %",
    r"out to truth: .*p99 (\S+)",
    r"truth to out .*max (\S+)",
    r"self-intersections (\d+)",
)


def write(part, folder):
    """Writes a part. Returns the paths of the mesh (OFF) and the motion (CSV)."""
    mesh, motion = folder / f"{part.name}.off", folder / f"{part.name}.csv"
    rows = [f"OFF\n{len(part.vertices)} {len(part.triangles)} 0"]
    rows += [" ".join(repr(float(x)) for x in vertex) for vertex in part.vertices]
    rows += ["3 " + " ".join(map(str, triangle)) for triangle in part.triangles]
    mesh.write_text("\n".join(rows) + "\n", encoding="utf-8")
    rows = ["t,tx,ty,tz,qx,qy,qz,qw"]
    for time, turn, place in zip(*part.motion):
        rows.append(",".join(repr(float(x)) for x in (time, *place, *turn)))
    motion.write_text("\n".join(rows) + "\n", encoding="utf-8")
    return mesh, motion


def figures(text):
    """Returns the figures of one run, as printed."""
    found = []
    for pattern in FIGURES:
        match = re.search(pattern, text)
        found += match.groups() if match else ["-"]
    return found


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("build", nargs="?", default="build")
    parser.add_argument("--cells", nargs="+", default=["112", "256"])
    parser.add_argument("--samples", default="6000")
    parser.add_argument("--parts", nargs="+", default=list(thin_parts.MAKERS))
    given = parser.parse_args()
    program = pathlib.Path(given.build) / "bin" / "swept_deviation"
    print("| part | cells | crease mean | p99 | over 20 degrees | p99 | missing | pairs |")
    print("| --- | --- | --- | --- | --- | --- | --- | --- |")
    with tempfile.TemporaryDirectory() as folder:
        for part in thin_parts.parts():
            if part.name not in given.parts:
                continue
            mesh, motion = write(part, pathlib.Path(folder))
            for cells in given.cells:
                command = [program, mesh, motion, "1", cells, "--samples", given.samples]
                done = subprocess.run(list(map(str, command)), capture_output=True, text=True)
                row = [part.name, cells, *(figures(done.stdout) or [done.stderr.strip()])]
                print("| " + " | ".join(row) + " |", flush=True)


if __name__ == "__main__":
    main()
