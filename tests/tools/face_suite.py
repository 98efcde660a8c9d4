#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Measures solids whose faces come from the faces and edges of the part, not from the mesh.

The program sweeps CAD parts (STEP files) along a motion and writes each envelope as a STEP file. It knows
which face or edge of the part made each triangle, and so which surface each face of the solid must have.
The table has one row for each part, with the columns of supplier_suite.py and these:
    real          share of the area of the solid that is not on triangular planar faces
    off, off99    mm: distances of exact points of the envelope (from --sources) from the solid: the
                  largest of a sample, and the 99 % quantile
    away          cells: largest distance of sample points on the solid from the nearest exact point. A
                  value of about 1 is good: exact points are about a cell apart

Usage: face_suite.py BUILD TABLE [--parts FOLDER] [--path lift2|path3|path5] [--resolution N]
       [--share S] [--keep FOLDER] [--mesh] [WORD...]    only parts whose name contains a WORD
       --share: tolerance as a fraction of the diagonal of the envelope's bounding box (default 0.001)
       --mesh: do not use the faces of the part, but recognise surfaces in the mesh
Ends with 1 if a solid is not clean. Needs FreeCAD's Python modules.
"""
import argparse
import csv
import json
import pathlib
import sys
import tempfile

import numpy as np
import shared_data
from source_suite import kernel_module
from supplier_suite import PATHS, box_of, is_clean, motion_rows, report_of, run

COLUMNS = (
    "part", "status", "valid", "faults", "edge_tolerance", "vertex_tolerance", "tolerance",
    "triangles", "faces", "facets", "real", "off", "off99", "away", "block_error", "seconds",
    "megabytes", "note",
)  # fmt: skip
SAMPLE = 400


def kernel():
    part = kernel_module()
    if part is None:
        sys.exit("FreeCAD not found")
    import FreeCAD

    return FreeCAD, part


def is_facet(face):
    kinds = [type(edge.Curve).__name__ for edge in face.Edges]
    return type(face.Surface).__name__ == "Plane" and kinds == ["Line"] * 3


def sampled(faces, count):
    """Returns points on the faces, in proportion to their area. Very small faces get none."""
    points = []
    area = sum(face.Area for face in faces)
    for face in faces:
        if face.Area * count < 0.2 * area:
            continue
        nodes, triangles = face.tessellate(0.05)
        nodes = np.array([tuple(p) for p in nodes])
        for triangle in triangles[:: 1 + len(triangles) // 20]:
            points.append(nodes[list(triangle)].mean(axis=0))
    return np.array(points)


def measured(solid, crossings, cell):
    """Returns real, off, off99, away, and the number of facets."""
    FreeCAD, Part = kernel()
    shape = Part.Shape()
    shape.read(str(solid))
    facets = [is_facet(face) for face in shape.Faces]
    areas = np.array([face.Area for face in shape.Faces])
    rng = np.random.default_rng(1)
    some = crossings[rng.choice(len(crossings), min(SAMPLE, len(crossings)), replace=False)]
    shell = Part.Compound(shape.Faces)
    off = [shell.distToShape(Part.Vertex(FreeCAD.Vector(*map(float, p))))[0] for p in some]
    points = sampled(shape.Faces, 4 * SAMPLE)
    nearest = [np.sqrt(((crossings - p) ** 2).sum(1).min()) for p in points]
    real = areas[~np.array(facets)].sum() / areas.sum()
    return real, max(off), np.quantile(off, 0.99), max(nearest) / cell, sum(facets)


def judged(part, folder, options):
    """Returns one row of the table. All files are written to `folder`."""
    program = options.build / "bin" / "swept"
    motion, mesh = folder / (part.stem + ".csv"), folder / (part.stem + ".ply")
    motion.write_text("0,0,0,0,0,0,0,1\n")
    sweep = [program, "envelope", part, "--motion", motion, "--resolution"]
    _, found = report_of(sweep + ["32", "-o", mesh], folder)
    if found["status"] != "Ok":
        return [part.stem, found["code"]]
    np.savetxt(motion, motion_rows(options.path, box_of(mesh).max()), fmt="%.17g", delimiter=",")
    rows = folder / (part.stem + "_sources.csv")
    sweep += [options.resolution]
    _, found = report_of(sweep + ["-o", mesh, "--sources", rows], folder)
    if found["status"] != "Ok":
        return [part.stem, found["code"]]
    tolerance = options.share * np.linalg.norm(box_of(mesh))
    solid = folder / (part.stem + ".step")
    wanted = ["-o", solid, "--solid-tolerance", repr(tolerance), "--max-faces", "1000000"]
    start = [program, "solid", mesh] if options.mesh else sweep
    seconds, report = report_of(start + wanted, folder)
    if report["status"] != "Ok":
        return [part.stem, report["code"]]
    made = report["solid"]
    crossings = np.genfromtxt(rows, delimiter=",", skip_header=1, usecols=(6, 7, 8))
    crossings = crossings[np.isfinite(crossings).all(axis=1)]
    real, off, off99, away, facets = measured(solid, crossings, found["cell"])
    _, done = run([options.build / "bin" / "swept_judge_solid", solid, "--block"])
    there = json.loads(done.stdout)
    return [
        part.stem, "Ok", there["valid"],
        " ".join("{} {}".format(n, kind) for kind, n in sorted(there["faults"].items())) or "none",
        "%.2g" % there["edge_tolerance"], "%.2g" % there["vertex_tolerance"],
        "%.4f" % made["tolerance"], found["triangles"], made["faces"], facets, "%.4f" % real,
        "%.4f" % off, "%.4f" % off99, "%.2f" % away, "%.1g" % there["block_error"],
        "%.1f" % seconds, "%.2f" % (made["file_bytes"] / 1e6), made.get("note", ""),
    ]  # fmt: skip


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("build", type=lambda p: pathlib.Path(p).resolve())
    parser.add_argument("table", type=pathlib.Path)
    parser.add_argument("words", nargs="*")
    parser.add_argument("--parts", type=pathlib.Path, default=shared_data.FOLDER / "cad")
    parser.add_argument("--path", choices=sorted(PATHS), default="lift2")
    parser.add_argument("--resolution", default="256")
    parser.add_argument("--share", type=float, default=1e-3)
    parser.add_argument("--mesh", action="store_true")
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
            if part.suffix.lower() not in (".step", ".stp", ".brep"):
                continue
            if options.words and not any(word in part.name for word in options.words):
                continue
            with tempfile.TemporaryDirectory() as name:
                row = judged(part, options.keep or pathlib.Path(name), options)
            table.writerow(row)
            file.flush()
            count += 1
            sound = is_clean(row, COLUMNS)
            clean += sound
            print(", ".join(map(str, row)) + ("" if sound else "   NOT CLEAN"), flush=True)
    print("solids: {} of {} clean".format(clean, count))
    return 0 if clean == count else 1


if __name__ == "__main__":
    sys.exit(main())
