#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Makes solids of envelopes: each test mesh of the shared data, standing still, along 16 poses and along
34 poses. Each envelope must become a valid STEP file, or be refused with a code that is allowed.

Each case runs in a process of its own and adds a row to TABLE. Cases that are in TABLE already are
skipped, so a suite that was stopped can be continued.

Usage: solid_suite.py BUILD TABLE [RESOLUTION] [MESH...]
Ends with 1 if a case fails.
"""
import csv
import json
import pathlib
import subprocess
import sys
import tempfile

import numpy as np
import shared_data

SHARE = 1e-3  # tolerance, as a fraction of the box diagonal
SECONDS = 900
COLUMNS = ("case", "outcome", "triangles", "faces", "curved", "megabytes", "share", "seconds")
# Codes of allowed refusals: the envelope has no surface of which a solid can be made.
NAMED = ("OpenMesh", "AmbiguousTurn", "TooManyFaces", "NotClosed", "NonManifold")


def run(build, mesh, motion, resolution):
    """Returns one row of the table."""
    import _swept

    program = build / "bin" / "swept"
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        size = np.ptp(np.asarray(_swept.read_mesh(str(mesh)).vertices), axis=0).max()
        rotations, shifts = shared_data.scaled_motion(_swept, motion, size)
        rows = np.column_stack([np.arange(len(shifts)), shifts, rotations])
        table = folder / "motion.csv"
        np.savetxt(table, rows, fmt="%.17g", delimiter=",")
        envelope, report = folder / "envelope.ply", folder / "report.json"
        words = ["--output", envelope, "--report", report, "--quiet"]
        subprocess.run(
            [program, "envelope", mesh, "--motion", table, "--resolution", str(resolution)] + words,
            capture_output=True,
        )
        found = json.loads(report.read_text())
        if found["status"] != "Ok":
            return [found["code"], 0, 0, 0, 0, 0, 0]
        diagonal = np.linalg.norm(np.ptp(np.asarray(_swept.read_mesh(str(envelope)).vertices), 0))
        tolerance = SHARE * diagonal
        words = ["--output", folder / "solid.step", "--report", report, "--quiet"]
        limits = ["--solid-tolerance", repr(tolerance), "--max-faces", "1000000"]
        triangles = found["triangles"]
        try:
            subprocess.run(
                [program, "solid", envelope] + words + limits, capture_output=True, timeout=SECONDS
            )
        except subprocess.TimeoutExpired:
            return ["Timeout", triangles, 0, 0, 0, 0, SECONDS]
        found = json.loads(report.read_text())
        if found["status"] != "Ok":
            return [found["code"], triangles, 0, 0, 0, 0, 0]
        solid = found["solid"]
        kinds = solid["faces_by_kind"]
        curved = sum(n for kind, n in kinds.items() if kind not in ("facet", "plane"))
        seconds = sum(solid["seconds"][part] for part in ("build", "write", "reread"))
        return [
            "valid" if solid["valid"] else "INVALID", triangles, solid["faces"], curved,
            round(solid["file_bytes"] / 1e6, 3), round(solid["deviation"] / tolerance, 3),
            round(seconds, 1),
        ]  # fmt: skip


def main():
    build, table = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2])
    resolution = int(sys.argv[3]) if len(sys.argv) > 3 else 128
    if not shared_data.FOLDER.exists():
        print("shared test data not found: {}".format(shared_data.FOLDER))
        return 0
    sys.path.insert(0, str(build / "python"))
    done = {}
    if table.exists():
        with open(table, newline="") as file:
            done = {row[0]: row for row in list(csv.reader(file))[1:]}
    else:
        table.write_text(",".join(COLUMNS) + "\n")
    failed = 0
    for mesh in sorted(
        (shared_data.FOLDER / "meshes").glob("*.ply"), key=lambda p: p.stat().st_size
    ):
        if len(sys.argv) > 4 and not any(word in mesh.name for word in sys.argv[4:]):
            continue
        for name in shared_data.MOTIONS:
            case = "{} {}".format(mesh.stem, name[:12])
            row = done.get(case)
            if row is None:
                row = [case] + run(build, mesh, name, resolution)
                with open(table, "a", newline="") as file:
                    csv.writer(file).writerow(row)
            bad = row[1] != "valid" and row[1] not in NAMED
            failed += bad
            print(", ".join(map(str, row)) + ("   BAD" if bad else ""), flush=True)
    print("solids: {} bad cases".format(failed))
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
