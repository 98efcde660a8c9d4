# SPDX-License-Identifier: LGPL-2.1-or-later
"""Compares GPU and CPU sampling on this machine: seconds by stage, memory, and whether the results are equal.

A run that takes longer than the limit is ended.
"""
import argparse
import pathlib
import sys
import threading

ROOT = pathlib.Path(__file__).resolve().parents[2]
HEAD = "case|r|sampler|pass 1 / sampling s|signs s|pass 2 s|total s|MB|result".split("|")
# name, mesh, its unit, motion with 16 keys, and mm per unit of this motion: bodies without a motion
# of their own get that of the fandisk, scaled
BODIES = [
    ("bunny", "bunny_stanford_70k.ply", "m", "keyposes_16_arc_for_bunny.csv", 1000),
    ("fandisk", "fandisk_13k.ply", "m", "keyposes_16_arc_for_fandisk.csv", 1000),
    ("gripper", "gripper_robotiq_2f140_30k.ply", "mm", "keyposes_16_arc_for_fandisk.csv", 100),
    ("housing", "housing_two_halves_360k_thin.ply", "mm", "keyposes_16_arc_for_fandisk.csv", 100),
    ("gear", "differential_ring_gear_58k.ply", "mm", "keyposes_16_arc_for_fandisk.csv", 100),
]


def paths_of(arc, scale):
    return [
        ("still", "static_1_pose.csv", 1, "none"),
        ("keys16", arc, scale, "linear"),
        ("path34", "installation_34_from_baxter_left.csv", 1000, "linear"),
        ("vibration", "vibration_sensor_193200.csv.xz", 1, "none"),
        ("recording", "vibration_sensor_193200.csv.xz", 1, "linear"),
    ]


def line(cells):
    print("| " + " | ".join(cells) + " |", flush=True)


def measure(name, body, motion, interpolation, resolution, backend, limit):
    """Computes the envelope, but not for longer than `limit` seconds. Returns the result (None if
    there is none) and the report, and the cells of the row but the last."""
    import _swept

    run = _swept.RunContext()
    watch = threading.Timer(limit, run.cancel)
    watch.start()
    try:
        options = {"resolution": resolution, "backend": backend, "run": run}
        result = _swept.compute(body.vertices, body.triangles, motion, interpolation, **options)
        report = result.report
    except _swept.Error as error:
        result, report = None, error.report
    finally:
        watch.cancel()
    seconds = [report["seconds"].get(s, 0) for s in ("sampling", "signs", "winners", "total")]
    cells = [name, str(resolution), backend, *(f"{s:.3f}" for s in seconds)]
    return result, report, cells + [f"{report.get('peak_memory_bytes', 0) / 1e6:.0f}"]


def compare(*case, limit):
    """Prints a row for each sampler, and one for the choice of `auto`. Returns the device."""
    cpu, report, cells = measure(*case, "cpu", limit)
    line(cells + [report["status"]])
    gpu, report, cells = measure(*case, "gpu", limit)
    device = report.get("device", "")
    outcome = report["status"]
    if cpu and gpu:
        same = all(
            getattr(cpu, part).tobytes() == getattr(gpu, part).tobytes()
            for part in ("vertices", "triangles")
        )
        outcome = "same bytes" if same else "DIFFERS"
    line(cells + [outcome])
    chosen, report, cells = measure(*case, "auto", limit)
    line(cells + [report["backend"] if chosen else report["status"]])
    for finding in report["warnings"]:
        if finding["code"] == "CpuSampler":
            print(f"{case[0]}: {finding['text']}", file=sys.stderr)
    return device


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("resolution", nargs="*", type=int, default=[512, 1024])
    parser.add_argument("--shared", default=str(ROOT.parent / "shared" / "data"))
    parser.add_argument("--only", default="", help="part of the name of a case")
    parser.add_argument("--limit", type=float, default=60, help="seconds")
    options = parser.parse_args()
    sys.path.insert(0, str(ROOT / "build" / "python"))
    import _swept

    shared = pathlib.Path(options.shared)
    device = ""
    line(HEAD)
    line(["---"] * len(HEAD))
    for body_name, mesh, unit, arc, scale in BODIES:
        body = _swept.read_mesh(shared / "meshes" / mesh, unit=unit)
        for path_name, file, per_unit, interpolation in paths_of(arc, scale):
            name = f"{body_name}_{path_name}"
            if options.only not in name:
                continue
            times, turns, shifts = _swept.read_trajectory_csv(shared / "motions" / file)
            # A software rasteriser would take hours for long motions, and its times are not useful.
            if "llvmpipe" in device and len(times) > 1000:
                continue
            motion = (times, turns, shifts * per_unit)
            for resolution in options.resolution:
                case = (name, body, motion, interpolation, resolution)
                device = compare(*case, limit=options.limit) or device
    print(f"\ndevice: {device or 'none'}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
