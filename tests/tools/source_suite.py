#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Checks the faces, edges and times that an envelope names for its triangles, on the shared CAD parts.

    source_suite.py BUILD [--cells N] [--parts NAME ...]

For each part and each of three motions (a straight lift; three and five keys with turns), a line with
    known     share of the triangles that have a source
    right     share of those whose point is on the named triangles or edge of the part, after it is moved
              back by the pose at the named time: within 0.001 cells, and within the permitted chord error
              (0.02 cells)
    on faces  share of a sample of these points that are on the exact face of the STEP file, within the mesh
              deflection plus 1 % of a cell (measured by FreeCAD's kernel)
    corners   share of the corners of the triangles that are within a cell of that face
    faults    share that is still "right" with wrong faces (numbers shifted by one) and with wrong times
              (shifted by 1 % of the step): shows that the check finds faults
    time      CPU time with sources, divided by the time without; several runs of each, in turn
"""
import argparse
import pathlib
import sys
import time

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tests" / "python"))

import numpy as np  # noqa: E402

import source_check  # noqa: E402
from shared_data import FOLDER, product, turn  # noqa: E402

NEAR, CHORD, SAMPLE, ON_CORNERS = 1e-3, 0.02, 400, 1.0


def motions(low, high):
    """Returns motions for a part with this box, by name: times, quaternions, translations, pivot."""
    size, middle = np.linalg.norm(high - low), (low + high) / 2
    none, one = turn((1, 0, 0), 0), turn((1, 2, 3), 25)
    two = product(turn((2, -1, 1), 35), one)
    four = product(turn((-1, 0, 1), 20), product(turn((0, 1, 2), 30), two))
    keys = {
        "lift2": [((0, 0, 0), none), ((0.31, 0.17, 0.93), none)],
        "path3": [((0, 0, 0), none), ((0.6, 0.1, 0.2), one), ((1.2, 0.5, 0.1), two)],
        "path5": [
            ((0, 0, 0), none),
            ((0.3, 0, 0.1), none),
            ((0.7, 0.15, 0.2), one),
            ((1.1, 0.5, 0.2), two),
            ((1.3, 1.0, 0.1), four),
        ],
    }
    for name, poses in keys.items():
        turns = np.array([q for _, q in poses])
        shifts = np.array([middle + size * np.array(x) for x, _ in poses])
        shifts -= np.einsum("nij,j->ni", source_check.matrices_of(turns), middle)
        yield name, (np.arange(len(poses), dtype=float), turns, shifts, np.zeros(3))


def share(of):
    return float(np.mean(of)) if len(of) else float("nan")


def on_faces(shape, points, rows, limit):
    """Returns, for each point (part coordinates), whether it lies on all faces that its row names (n,)."""
    import FreeCAD
    import Part

    found = []
    for point, faces in zip(points, rows.faces):
        vertex = Part.Vertex(FreeCAD.Vector(*map(float, point)))
        off = [shape.Faces[n].distToShape(vertex)[0] for n in faces if n >= 0]
        found.append(max(off) <= limit)
    return np.array(found)


def kernel_module():
    """Returns FreeCAD's module Part; None if FreeCAD is not installed."""
    for folder in ("/usr/lib/freecad-python3/lib", "/usr/lib/freecad/lib"):
        if pathlib.Path(folder).is_dir() and folder not in sys.path:
            sys.path.append(folder)
    try:
        import FreeCAD  # noqa: F401
        import Part
    except ImportError:
        return None
    return Part


def kernel_shape(path):
    """Returns the shape of the STEP file, read by FreeCAD; None if FreeCAD is not installed."""
    part = kernel_module()
    if part is None:
        return None
    shape = part.Shape()
    shape.read(str(path))
    return shape


def timed(swept, body, motion, cells, rounds):
    """Runs with and without sources in turn. Returns the least CPU seconds of each, and the last result."""
    best = [np.inf, np.inf]
    for _ in range(rounds):
        for on in (False, True):
            began = time.process_time()
            result = swept.compute(body, motion, resolution=cells, sources=on, backend="cpu")
            best[on] = min(best[on], time.process_time() - began)
            if not on:
                plain = result
    same = all(
        np.array_equal(getattr(plain, name), getattr(result, name))
        for name in ("vertices", "triangles", "contact_time")
    )
    assert same, "the mesh is another one with sources"
    return best, result


def judge(swept, path, cells, rounds):
    body = swept.read_body(path, resolution=cells)
    faces = source_check.BodyFaces(body.vertices, body.triangles, body.faces)
    shape = kernel_shape(path)
    rng = np.random.default_rng(1)
    for name, motion in motions(body.vertices.min(0), body.vertices.max(0)):
        trajectory = swept.Motion(*motion[:3])
        seconds, result = timed(swept, body, trajectory, cells, rounds)
        sources, cell = result.sources, result.report["cell"]
        known = np.nonzero(sources.kind >= 0)[0]
        some = rng.choice(known, min(10 * SAMPLE, len(known)), replace=False)

        def right(spoil=lambda rows: None, near=NEAR):
            rows = source_check.Rows(sources, some)
            spoil(rows)
            return share(source_check.residuals(rows.point, rows, faces, motion) <= near * cell)

        def other_face(rows):
            rows.faces[:, 0] = (rows.faces[:, 0] + 1) % (faces.faces.max() + 1)

        def later(rows):
            rows.time = rows.time + 0.01

        line = [len(result.triangles), share(sources.kind >= 0), right(), right(near=CHORD)]
        if shape is not None:
            sample = some[:SAMPLE]
            rows = source_check.Rows(sources, sample)
            back = source_check.moved_back(rows.point, rows, motion)
            line.append(share(on_faces(shape, back, rows, body.chord_error + 0.01 * cell)))
            corner = result.vertices[result.triangles[sample, rng.integers(0, 3, len(sample))]]
            back = source_check.moved_back(corner, rows, motion)
            line.append(share(on_faces(shape, back, rows, body.chord_error + ON_CORNERS * cell)))
        kinds = np.bincount(sources.kind[known], minlength=3) / len(known)
        print(
            f"{path.stem:26s} {name:6s} triangles {line[0]:8d} known {line[1]:.5f}",
            f"right {line[2]:.5f} {line[3]:.5f}",
            "on faces {:.4f} corners {:.4f}".format(*line[4:]) if shape is not None else "",
            f"faults {right(other_face):.4f} {right(later):.4f}",
            f"cap {kinds[0]:.2f} edge {kinds[1]:.2f} graze {kinds[2]:.2f}",
            f"time {seconds[0]:.3f} s x {seconds[1] / seconds[0]:.3f}",
            flush=True,
        )


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("build")
    parser.add_argument("--cells", type=int, default=256)
    parser.add_argument("--rounds", type=int, default=3, help="runs that are timed")
    parser.add_argument("--parts", nargs="*", default=[])
    arguments = parser.parse_args()
    sys.path.insert(0, str(pathlib.Path(arguments.build) / "python"))
    import swept_volume

    for path in sorted((FOLDER / "cad").glob("*.step")):
        if not arguments.parts or path.stem in arguments.parts:
            judge(swept_volume, path, arguments.cells, arguments.rounds)


if __name__ == "__main__":
    main()
