# SPDX-License-Identifier: LGPL-2.1-or-later
"""Counts instructions of small runs under callgrind and compares them with the stored counts.

Instructions do not depend on the load of the machine, so they show small changes. If a count is
more than 10 % above the stored one, the script warns; its exit status stays 0. --store stores new
counts.
"""
import argparse
import json
import math
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
STORED = pathlib.Path(__file__).parent / "instructions.json"
WARN = 1.10


def write_torus(path, around=48, across=24):
    """Writes a torus around z with radii 20 and 8 as OBJ."""
    lines = []
    for i in range(around):
        for j in range(across):
            a, b = 2 * math.pi * i / around, 2 * math.pi * j / across
            r = 20 + 8 * math.cos(b)
            lines.append(f"v {r * math.cos(a):.9f} {r * math.sin(a):.9f} {8 * math.sin(b):.9f}")
    for i in range(around):
        for j in range(across):
            p, q = (i + 1) % around, (j + 1) % across
            a, b, c, d = (1 + across * m + n for m, n in ((i, j), (p, j), (p, q), (i, q)))
            lines += [f"f {a} {b} {c}", f"f {a} {c} {d}"]
    path.write_text("\n".join(lines) + "\n")


def write_path(path, poses, turn, travel):
    lines = ["t,tx,ty,tz,qx,qy,qz,qw"]
    for n in range(poses):
        s = n / max(1, poses - 1)
        half = math.radians(turn) * s / 2
        lines.append(f"{s},{travel * s},{travel * s * s},0,{math.sin(half)},0,0,{math.cos(half)}")
    path.write_text("\n".join(lines) + "\n")


# name: poses, turn in degrees, travel in mm, interpolation, resolution
CASES = {
    "torus at rest": (1, 0, 0, "none", 64),
    "torus on a path": (5, 120, 40, "linear", 48),
    "copies of a torus": (40, 20, 10, "none", 40),
}


def count(program, case, folder):
    poses, turn, travel, interpolation, resolution = case
    write_torus(folder / "torus.obj")
    write_path(folder / "path.csv", poses, turn, travel)
    command = ["valgrind", "--tool=callgrind", f"--callgrind-out-file={folder}/callgrind.out"]
    command += [program, "envelope", folder / "torus.obj", "--motion", folder / "path.csv"]
    command += ["--interpolation", interpolation, "--resolution", resolution, "--threads", 1]
    command += ["--backend", "cpu", "--quiet", "--output", folder / "out.ply"]
    done = subprocess.run([str(c) for c in command], capture_output=True, text=True)
    found = re.search(r"Collected : (\d+)", done.stderr)
    if done.returncode != 0 or not found:
        raise RuntimeError(done.stderr.strip()[-500:])
    return int(found.group(1))


def compiler():
    text = (ROOT / "build" / "CMakeCache.txt").read_text()
    path = re.search(r"CMAKE_CXX_COMPILER:\w+=(.*)", text).group(1)
    return subprocess.run([path, "--version"], capture_output=True, text=True).stdout.split("\n")[0]


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--program", default=str(ROOT / "build" / "bin" / "swept"))
    parser.add_argument("--store", action="store_true")
    options = parser.parse_args()
    if shutil.which("valgrind") is None:
        print("SKIPPED: valgrind is not installed")
        return 0
    stored = json.loads(STORED.read_text()) if STORED.exists() else {}
    counts = {}
    with tempfile.TemporaryDirectory() as folder:
        for name, case in CASES.items():
            counts[name] = count(options.program, case, pathlib.Path(folder))
            before = stored.get("instructions", {}).get(name)
            change = counts[name] / before if before else None
            note = "" if change is None else f", {100 * (change - 1):+.1f} % of what is stored"
            print(f"{name}: {counts[name] / 1e6:.1f} million instructions{note}")
            if change is not None and change > WARN:
                print(
                    f"WARNING: {name} takes {100 * (change - 1):.0f} % more instructions than stored"
                )
    if stored and stored["compiler"] != compiler():
        print(f"note: the stored counts are those of {stored['compiler']}, this is {compiler()}")
    if options.store:
        text = json.dumps({"compiler": compiler(), "instructions": counts}, indent=2)
        STORED.write_text(text + "\n")
        print(f"stored in {STORED}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
