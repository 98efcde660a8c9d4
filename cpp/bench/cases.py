# SPDX-License-Identifier: LGPL-2.1-or-later
"""The measured cases: those of the tables, and series of inputs in which one size grows."""
import csv
import json
import lzma
import pathlib

import numpy as np

# name in cases.json, resolution, seconds of the reference implementation, goal (s), limit (s),
# which the tables call "least"
TABLE = [
    ("bunny_still", 512, 360, 0.5, 1),
    ("bunny_still", 1024, 2632, 2, 4),
    ("fandisk_keys16", 256, None, 0.1, 0.25),
    ("fandisk_keys16", 512, 327, 0.35, 0.8),
    ("bunny_keys16", 512, 319, 0.8, 1.6),
    ("station_keys16", 1024, 2485, 5, 12),
    ("gripper_path34", 1024, 2437, 3, 7),
    ("bunny_vibration", 512, 943, 3, 15),
    ("housing_vibration", 1024, 7084, 15, 75),
]
# Preview sessions (preview.py): name, resolution, goal and limit (s) of all calls after the first.
PREVIEW = [("fandisk_keys16", 128, 0.05, 0.15), ("bunny_keys16", 128, 0.05, 0.15)]
LARGE = [("fandisk_keys16", 4096, None, 40, 150)]
QUICK = [("fandisk_keys16", 128), ("fandisk_keys16", 256), ("bunny_still", 256)]


class Case:
    """One run of the program: its name in the tables, and its arguments."""

    def __init__(self, name, resolution, arguments, limits=None):
        self.name = name
        self.resolution = resolution
        self.arguments = [str(a) for a in arguments] + ["--resolution", str(resolution)]
        self.reference, self.goal, self.least = limits or (None, None, None)


def shared_cases(shared):
    listed = json.loads((shared / "cases.json").read_text())["cases"]
    return {c["name"]: c for c in listed}


def arguments_of(shared, entry):
    return [
        shared / entry["mesh"],
        "--generator-unit",
        entry["mesh_unit"],
        "--motion",
        shared / entry["motion"],
        "--motion-unit",
        entry["motion_unit"],
        "--interpolation",
        entry["interpolation"],
    ]


def table(shared, which):
    entries = shared_cases(shared)
    rows = {"quick": QUICK, "table": TABLE, "large": LARGE}[which]
    return [Case(r[0], r[1], arguments_of(shared, entries[r[0]]), r[2:] or None) for r in rows]


def growth(shared, folder):
    """Returns cases that grow in resolution, placements (same envelope) or triangles."""
    entries = shared_cases(shared)
    folder.mkdir(parents=True, exist_ok=True)
    cases = []
    for name in ("bunny_still", "fandisk_keys16"):
        for resolution in (64, 128, 256, 512, 1024):
            cases.append(Case(name, resolution, arguments_of(shared, entries[name])))
    fandisk, vibration = entries["fandisk_keys16"], entries["bunny_vibration"]
    for factor in (1, 4, 16, 64, 256):
        path = denser_path(shared / fandisk["motion"], factor, folder)
        arguments = arguments_of(shared, dict(fandisk, motion=path))
        cases.append(Case(f"fandisk, {15 * factor + 1} poses on one path", 256, arguments))
    for step in (256, 64, 16, 4, 1):
        path, count = thinned(shared / vibration["motion"], step, folder)
        arguments = arguments_of(shared, dict(vibration, motion=path))
        cases.append(Case(f"bunny, {count} placements of the vibration", 256, arguments))
    bunny = entries["bunny_still"]
    for level in (0, 1, 2):
        path, count = subdivided(shared / bunny["mesh"], level, folder)
        for entry in (bunny, entries["bunny_keys16"]):
            arguments = arguments_of(shared, dict(entry, mesh=path))
            cases.append(Case(f"{entry['name']}, {count} triangles", 256, arguments))
    return cases


def read_table(path):
    opened = lzma.open(path, "rt") if path.suffix == ".xz" else open(path)
    with opened as file:
        rows = [r for r in csv.reader(file) if r and not r[0].startswith("#")]
    return rows[0], rows[1:]


def write_table(path, header, rows):
    with open(path, "w", newline="") as file:
        csv.writer(file).writerows([header] + [list(r) for r in rows])
    return path


def thinned(source, step, folder):
    header, rows = read_table(source)
    rows = rows[::step]
    return write_table(folder / f"vibration_{step}.csv", header, rows), len(rows)


def slerp(p, q, s):
    dot = float(np.dot(p, q))
    q, dot = (-q, -dot) if dot < 0 else (q, dot)
    angle = np.arccos(min(1.0, dot))
    if angle < 1e-9:
        return p
    return (np.sin((1 - s) * angle) * p + np.sin(s * angle) * q) / np.sin(angle)


def denser_path(source, factor, folder):
    """Writes the same linear path with `factor` times as many poses; returns the new file."""
    header, rows = read_table(source)
    poses = np.array(rows, float)
    out = [poses[0]]
    for a, b in zip(poses[:-1], poses[1:]):
        for n in range(1, factor + 1):
            s = n / factor
            rotation = slerp(a[4:8], b[4:8], s)
            out.append(np.concatenate([a[:4] + s * (b[:4] - a[:4]), rotation]))
    text = [[repr(float(x)) for x in row] for row in out]
    return write_table(folder / f"path_{factor}.csv", header, text)


def subdivided(source, levels, folder):
    """Divides every triangle into four, `levels` times, without changing the surface."""
    vertices, triangles = read_ply(source)
    for _ in range(levels):
        edges = np.sort(
            np.concatenate([triangles[:, [0, 1]], triangles[:, [1, 2]], triangles[:, [2, 0]]])
        )
        unique, where = np.unique(edges, axis=0, return_inverse=True)
        middle = where.reshape(3, -1).T + len(vertices)
        vertices = np.concatenate([vertices, vertices[unique].mean(axis=1)])
        a, b, c = triangles.T
        ab, bc, ca = middle.T
        parts = [(a, ab, ca), (b, bc, ab), (c, ca, bc), (ab, bc, ca)]
        triangles = np.concatenate([np.stack(p, axis=1) for p in parts])
    path = folder / f"{pathlib.Path(source).stem}_{levels}.ply"
    write_ply(path, vertices, triangles)
    return path, len(triangles)


def read_ply(path):
    import _swept

    mesh = _swept.read_mesh(str(path))
    return np.array(mesh.vertices), np.array(mesh.triangles)


def write_ply(path, vertices, triangles):
    import _swept

    _swept.write_mesh(str(path), vertices, triangles.astype(np.int32))
