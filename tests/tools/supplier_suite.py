#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Checks solids as the recipient of their files would: CAD parts along three poses with turns.

Each part is swept, and its envelope is written as STEP with a tolerance of 0.1 % of the box diagonal. The
program swept_judge_solid then lists the faults that FreeCAD's geometry check finds (with its test for Boolean
operations), the tolerances of edges and vertices, and the volumes of the cut and the common with a block.
TABLE (CSV) gets a row for each part.

Usage: supplier_suite.py BUILD TABLE [--parts FOLDER] [--path path3|path5|lift2] [--facets]
       [--resolution N] [--keep FOLDER] [WORD...]      only parts whose name contains a WORD
Ends with 1 if a solid is not clean.
"""
import argparse
import csv
import json
import pathlib
import resource
import subprocess
import sys
import tempfile

import numpy as np
import shared_data

SHARE = 1e-3  # tolerance, as a fraction of the box diagonal of the envelope
COLUMNS = (
    "part", "status", "valid", "faults", "edge_tolerance", "vertex_tolerance", "tolerance",
    "deviation", "triangles", "faces", "facets", "seconds", "megabytes", "block_error",
)  # fmt: skip
# Shift (in sizes of the part), axis and angle (degrees) of the turn, by key.
PATHS = {
    "lift2": [((0, 0, 0), (0, 0, 1), 0), ((0.31, 0.17, 0.83), (0, 0, 1), 0)],
    "path3": [
        ((0, 0, 0), (0, 0, 1), 0),
        ((0.62, 0.13, 0.21), (0.3, 0.5, 0.8), 25),
        ((0.93, 0.71, 0.12), (-0.2, 0.7, 0.4), 41),
    ],
    "path5": [
        ((0, 0, 0), (0, 0, 1), 0),
        ((0.52, 0.1, 0.2), (0.3, 0.5, 0.8), 20),
        ((0.8, 0.6, 0.1), (-0.2, 0.7, 0.4), 35),
        ((0.7, 1.1, -0.2), (0.1, -0.6, 0.7), 30),
        ((0.2, 1.4, -0.1), (0.8, 0.1, 0.2), 50),
    ],
}


def motion_rows(path, size):
    """Returns rows t, tx, ty, tz, qx, qy, qz, qw; lengths in mm for a part of this size."""
    rows = []
    for time, (shift, axis, degrees) in enumerate(PATHS[path]):
        axis = np.asarray(axis) / np.linalg.norm(axis)
        half = np.radians(degrees) / 2
        rows.append([time, *(size * np.asarray(shift)), *(np.sin(half) * axis), np.cos(half)])
    return rows


def box_of(mesh):
    """Returns the sides (3,) of the bounding box of a binary PLY file of the program, mm."""
    data = mesh.read_bytes()
    header, rest = data.split(b"end_header\n", 1)
    count = int(header.split(b"element vertex ")[1].split()[0])
    return np.ptp(np.frombuffer(rest, "<f8", 3 * count).reshape(-1, 3), axis=0)


def run(words):
    """Returns the CPU seconds of a program, and the completed process."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
    done = subprocess.run([str(w) for w in words], capture_output=True, text=True)
    return resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before, done


def report_of(words, folder):
    path = folder / "report.json"
    seconds, _ = run(words + ["--report", path, "--quiet"])
    return seconds, json.loads(path.read_text())


def judged(part, folder, options):
    """Returns one row of the table. All files stay in `folder`."""
    program = options.build / "bin" / "swept"
    # The size is that of the moving part, which is swept once without a motion.
    motion, envelope = folder / (part.stem + ".csv"), folder / (part.stem + ".ply")
    motion.write_text("0,0,0,0,0,0,0,1\n")
    _, found = report_of(
        [program, "envelope", part, "--motion", motion, "--resolution", "32", "-o", envelope],
        folder,
    )
    if found["status"] != "Ok":
        return [part.stem, found["code"]]
    size = box_of(envelope).max()
    np.savetxt(motion, motion_rows(options.path, size), fmt="%.17g", delimiter=",")
    _, found = report_of(
        [program, "envelope", part, "--motion", motion, "-o", envelope]
        + ["--resolution", options.resolution],
        folder,
    )
    if found["status"] != "Ok":
        return [part.stem, found["code"]]
    diagonal = np.linalg.norm(box_of(envelope))
    solid = folder / (part.stem + ".step")
    seconds, report = report_of(
        [program, "solid", envelope, "-o", solid, "--solid-tolerance", repr(SHARE * diagonal)]
        + ["--max-faces", "1000000"]
        + ["--facets"] * options.facets,
        folder,
    )
    if report["status"] != "Ok":
        return [part.stem, report["code"]]
    made = report["solid"]
    _, done = run([options.build / "bin" / "swept_judge_solid", solid, "--block"])
    found_there = json.loads(done.stdout)
    faults = found_there["faults"]
    return [
        part.stem, "Ok", found_there["valid"],
        " ".join("{} {}".format(n, kind) for kind, n in sorted(faults.items())) or "none",
        "%.2g" % found_there["edge_tolerance"], "%.2g" % found_there["vertex_tolerance"],
        "%.4f" % made["tolerance"], "%.4f" % made["deviation"], found["triangles"],
        made["faces"], made["faces_by_kind"].get("facet", 0), "%.1f" % seconds,
        "%.2f" % (made["file_bytes"] / 1e6), "%.1g" % found_there["block_error"],
    ]  # fmt: skip


def is_clean(row, columns=None):
    """Returns whether the solid has no faults, and no edge or vertex tolerance above its own tolerance."""
    cell = dict(zip(columns or COLUMNS, row))
    return (
        cell["status"] == "Ok"
        and cell["valid"] is True
        and cell["faults"] == "none"
        and max(float(cell["edge_tolerance"]), float(cell["vertex_tolerance"]))
        <= float(cell["tolerance"])
    )


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("build", type=lambda p: pathlib.Path(p).resolve())
    parser.add_argument("table", type=pathlib.Path)
    parser.add_argument("words", nargs="*")
    parser.add_argument("--parts", type=pathlib.Path, default=shared_data.FOLDER / "cad")
    parser.add_argument("--path", choices=sorted(PATHS), default="path3")
    parser.add_argument("--resolution", default="256")
    parser.add_argument("--facets", action="store_true")
    parser.add_argument("--keep", type=pathlib.Path, help="a folder for the files")
    options = parser.parse_intermixed_args()
    if not options.parts.exists():
        print("no parts in {}".format(options.parts))
        return 0
    clean = count = 0
    with open(options.table, "w", newline="") as file:
        table = csv.writer(file)
        table.writerow(COLUMNS)
        for part in sorted(options.parts.iterdir(), key=lambda p: p.stat().st_size):
            if part.suffix.lower() not in (".step", ".stp", ".stl", ".ply"):
                continue
            if options.words and not any(word in part.name for word in options.words):
                continue
            with tempfile.TemporaryDirectory() as name:
                row = judged(part, options.keep or pathlib.Path(name), options)
            table.writerow(row)
            file.flush()
            count += 1
            clean += is_clean(row)
            print(", ".join(map(str, row)) + ("" if is_clean(row) else "   NOT CLEAN"), flush=True)
    print("solids: {} of {} clean".format(clean, count))
    return 0 if clean == count else 1


if __name__ == "__main__":
    sys.exit(main())
