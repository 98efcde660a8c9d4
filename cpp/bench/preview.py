# SPDX-License-Identifier: LGPL-2.1-or-later
"""Measures a preview session: each call after the first one moves one pose of the motion.

Prints and stores the table of previews (PREVIEW in cases.py).
"""
import argparse
import json
import os
import pathlib
import statistics
import sys
import time

ROOT = pathlib.Path(__file__).resolve().parents[2]
HEAD = ["case", "resolution", "call", "elapsed s", "goal / least", "CPU s", "triangles", "load"]


def measure(shared, entry, resolution, calls, threads):
    """Returns elapsed seconds, CPU seconds and triangles of every call of one session."""
    import _swept

    body = _swept.read_mesh(str(shared / entry["mesh"]), unit=entry["mesh_unit"])
    motion = str(shared / entry["motion"])
    times, rotations, translations = _swept.read_trajectory_csv(motion, unit=entry["motion_unit"])
    session = _swept.PreviewSession(body.vertices, body.triangles, resolution=resolution)
    size = float((body.vertices.max(axis=0) - body.vertices.min(axis=0)).max())
    out = []
    edited = translations.copy()
    for call in range(calls):
        # Imitates a user who drags one pose after another, each in ten steps of 1 % of the body.
        if call > 0:
            edited[1 + (call - 1) // 10 % (len(times) - 2), 2] += 0.01 * size
        run = _swept.RunContext(threads=threads)
        elapsed, cpu = time.perf_counter(), time.process_time()
        result = session.compute((times, rotations, edited), entry["interpolation"], run=run)
        elapsed, cpu = time.perf_counter() - elapsed, time.process_time() - cpu
        out.append({"elapsed": elapsed, "cpu": cpu, "triangles": len(result.triangles)})
    return out


def line(name, resolution, call, runs, limits):
    medians = {k: statistics.median(r[k] for r in runs) for k in runs[0]}
    cells = [name, str(resolution), call, f"{medians['elapsed']:.3f}", limits]
    cells += [f"{medians['cpu']:.3f}", f"{medians['triangles']:.0f}", f"{os.getloadavg()[0]:.1f}"]
    return "| " + " | ".join(cells) + " |"


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--calls", type=int, default=30, help="calls after the first one")
    parser.add_argument("--threads", type=int, default=0, help="0: all cores")
    parser.add_argument("--shared", default=str(ROOT.parent / "shared" / "data"))
    parser.add_argument("--store", help="folder for preview.json and preview.md")
    options = parser.parse_args()

    shared = pathlib.Path(options.shared)
    if not (shared / "cases.json").is_file():
        print(f"SKIPPED: the inputs of the table are not at {shared}")
        return 0
    sys.path[:0] = [str(pathlib.Path(__file__).parent), str(ROOT / "build" / "python")]
    import cases

    lines = ["| " + " | ".join(HEAD) + " |", "| " + " | ".join(["---"] * len(HEAD)) + " |"]
    stored = []
    entries = cases.shared_cases(shared)
    for name, resolution, goal, least in cases.PREVIEW:
        calls = measure(shared, entries[name], resolution, options.calls + 1, options.threads)
        lines.append(line(name, resolution, "first", calls[:1], "-"))
        lines.append(line(name, resolution, "later", calls[1:], f"{goal:g} / {least:g}"))
        stored.append({"case": name, "resolution": resolution, "calls": calls})
    print("\n".join(lines))
    if options.store:
        store = pathlib.Path(options.store)
        store.mkdir(parents=True, exist_ok=True)
        (store / "preview.json").write_text(json.dumps(stored, indent=1))
        (store / "preview.md").write_text("\n".join(lines) + "\n")
    return 0


if __name__ == "__main__":
    sys.exit(main())
