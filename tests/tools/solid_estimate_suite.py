#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Compares estimate_solid() with the results and the time of write_solid().

FOLDER has closed meshes (PLY). Each is estimated and written as STEP in five ways: with the tolerance 0
(the limit of 20,000 faces then chooses one), 0.02 %, 0.1 % and 0.5 % of its box diagonal, and with
planar faces only. Seconds are CPU seconds with one thread, so that other work on the machine counts
little. TABLE (CSV) gets a row for each case.

Usage: solid_estimate_suite.py BUILD FOLDER TABLE [--share I/N] [--brep]
Ends with 1 if faces, megabytes or seconds differ by more than a factor of 2.
"""
import argparse
import csv
import pathlib
import sys
import tempfile
import time

from supplier_suite import box_of

MOST = 2.0
#: Below this, the cost of starting a run dominates.
LEAST_SECONDS = 0.2
CASES = {
    "limit": {"tolerance": 0.0},
    "0.02 %": {"tolerance": 2e-4, "max_faces": 1000000},
    "0.1 %": {"tolerance": 1e-3, "max_faces": 1000000},
    "0.5 %": {"tolerance": 5e-3, "max_faces": 1000000},
    "0.1 % facets": {"tolerance": 1e-3, "max_faces": 1000000, "recognise": False},
}
COLUMNS = (
    "mesh", "case", "status", "faces", "faces_ratio", "megabytes", "megabytes_ratio", "seconds",
    "seconds_ratio", "guess_faces_ratio", "trial_share",
)  # fmt: skip


def judged(swept, mesh, options, suffix):
    """Returns the cells of a row after those for mesh and case. Seconds are CPU seconds."""
    read = swept.read_mesh(str(mesh))
    body = read.vertices, read.triangles

    try:
        guess = swept.estimate_solid(
            *body, run=swept.RunContext(threads=1), format=suffix, quick=True, **options
        )
        start = time.process_time()
        foretold = swept.estimate_solid(
            *body, run=swept.RunContext(threads=1), format=suffix, **options
        )
        trial = time.process_time() - start
        # Replaces the wall time of the trial in the estimate by its CPU time.
        seconds = trial + foretold["seconds"] - foretold["trial_seconds"]
    except swept.Error as error:
        guess, foretold, trial, seconds = None, str(error), 0, 0
    with tempfile.TemporaryDirectory() as folder:
        start = time.process_time()
        try:
            real = swept.write_solid(
                folder + "/solid." + suffix, *body, run=swept.RunContext(threads=1), **options
            )
        except swept.Error as error:
            return ["refused, as foretold" if foretold == str(error) else "refused: " + str(error)]
        took = time.process_time() - start
    if isinstance(foretold, str):
        return ["made, but foretold: " + foretold]
    megabytes = real["file_bytes"] / 1e6
    return [
        "Ok", real["faces"], "%.3f" % (foretold["faces"] / real["faces"]), "%.3f" % megabytes,
        "%.3f" % (foretold["megabytes"] / megabytes), "%.2f" % took,
        "%.3f" % (seconds / max(took, LEAST_SECONDS) if took > LEAST_SECONDS else 1),
        "%.1f" % (guess["faces"] / real["faces"]), "%.2f" % (trial / took),
    ]  # fmt: skip


def is_within(row):
    if row[2] != "Ok":
        return row[2].startswith("refused, as foretold")
    ratios = [float(row[COLUMNS.index(n + "_ratio")]) for n in ("faces", "megabytes", "seconds")]
    return all(1 / MOST <= ratio <= MOST for ratio in ratios)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("build", type=lambda p: pathlib.Path(p).resolve())
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("table", type=pathlib.Path)
    parser.add_argument("--share", default="0/1", help="every Nth mesh, from the Ith on")
    parser.add_argument("--brep", action="store_true")
    given = parser.parse_args()
    sys.path.insert(0, str(given.build / "python"))
    import _swept

    first, step = map(int, given.share.split("/"))
    outside = 0
    with open(given.table, "w", newline="", encoding="utf-8") as file:
        table = csv.writer(file)
        table.writerow(COLUMNS)
        for mesh in sorted(given.folder.glob("*.ply"))[first::step]:
            for case, options in CASES.items():
                options = dict(options, tolerance=options["tolerance"] * norm(box_of(mesh)))
                row = [mesh.stem, case] + judged(
                    _swept, mesh, options, "brep" if given.brep else "step"
                )
                outside += not is_within(row)
                table.writerow(row)
                file.flush()
                print(*row, "" if is_within(row) else "OUTSIDE", flush=True)
    return 1 if outside else 0


def norm(sides):
    return float((sides**2).sum() ** 0.5)


if __name__ == "__main__":
    sys.exit(main())
