# SPDX-License-Identifier: LGPL-2.1-or-later
"""Compares estimate() with the time and memory of runs, for random inputs (unseen_inputs.py).

    python3 tests/tools/estimate_suite.py [--build build] [--seed 1] [--count 40] [--copies 2e9]
        [--least-copies 0] [--most-seconds 600]

Each run has its own process, and so has each estimate: a run would seem to need less memory if it could
use memory that an estimate has freed. Seconds are CPU seconds divided by the number of threads, so that
other work on the machine counts little. Memory: by how much the process grows. Prints a row for each
case. The exit status is 1 if a factor is above 2 for memory or 3 for seconds. Cases with an estimate
above --most-seconds are listed and not run.
"""
import argparse
import json
import math
import os
import pathlib
import resource
import subprocess
import sys
import time

import unseen_inputs

MOST_MEMORY, MOST_SECONDS = 2.0, 3.0
#: Below these, the cost of starting a run dominates.
LEAST_BYTES, LEAST_SECONDS = 32e6, 0.3


def resident():
    """Returns the resident size of this process in bytes."""
    with open("/proc/self/statm", encoding="ascii") as file:
        return int(file.read().split()[1]) * resource.getpagesize()


def in_child(work):
    """Runs work() in a process of its own and returns its result, which must fit into JSON."""
    reader, writer = os.pipe()
    child = os.fork()
    if child == 0:
        try:
            with os.fdopen(writer, "w", encoding="utf-8") as pipe:
                json.dump(work(), pipe)
        finally:
            os._exit(0)
    os.close(writer)
    with os.fdopen(reader, encoding="utf-8") as pipe:
        text = pipe.read()
    os.waitpid(child, 0)
    return json.loads(text)


def run_case(seed, build, threads, most_seconds):
    """Estimates a case and, unless the estimate exceeds most_seconds, runs it. Returns a dict. Must be
    called in a process of its own."""
    sys.path.insert(0, str(build / "python"))
    import swept_volume as sv

    case = unseen_inputs.draw_case(seed)
    mesh, motion = sv.Mesh(*case.mesh), sv.Motion(*case.motion)

    def estimate():
        start = time.process_time()
        try:
            found = sv.estimate(mesh, motion, threads=threads, **case.options)
        except sv.Error as error:  # refused as the run would be
            return {"failed": str(error)}, 0
        return found, time.process_time() - start

    foreseen, estimate_seconds = in_child(estimate)
    if "failed" in foreseen:
        return {"name": case.name, "failed": foreseen["failed"]}
    if foreseen["seconds"] > most_seconds:
        return {"name": case.name, "failed": f"not run: {foreseen['seconds']:.0f} s are foreseen"}
    usage, before = resource.getrusage(resource.RUSAGE_SELF), resident()
    try:
        report = sv.compute(mesh, motion, threads=threads, **case.options).report
    except sv.Error as error:
        return {"name": case.name, "failed": str(error)}
    now = resource.getrusage(resource.RUSAGE_SELF)
    return {
        "name": case.name,
        "looked": estimate_seconds,
        "foreseen": foreseen,
        "seconds": (now.ru_utime - usage.ru_utime + now.ru_stime - usage.ru_stime) / threads,
        "bytes": report["peak_memory_bytes"] - before,
        "stages": report["seconds"],
        "report": {k: report[k] for k in ("crossings", "refined_placements", "swept_faces",
                                          "swept_patches", "grid")},
        "filter": [w["text"] for w in report["warnings"] if "filter" in w["text"]],
    }  # fmt: skip


def factor(a, b, least):
    """Returns the ratio of the larger figure to the smaller; figures below `least` count as `least`."""
    a, b = max(a, least), max(b, least)
    return max(a / b, b / a)


def factors(found):
    foreseen = found["foreseen"]
    return (
        factor(foreseen["memory_bytes"], found["bytes"], LEAST_BYTES),
        factor(foreseen["seconds"], found["seconds"], LEAST_SECONDS),
    )


def measure(seed, build, threads=None, most_seconds=math.inf):
    """Calls run_case() in another process."""
    words = [sys.executable, __file__, "--case", str(seed), "--build", str(build)]
    words += ["--threads", str(threads or os.cpu_count() or 1)]
    words += ["--most-seconds", str(most_seconds)]
    done = subprocess.run(words, capture_output=True, text=True)
    if done.returncode != 0:
        raise RuntimeError(f"seed {seed}: {done.stderr}")
    return json.loads(done.stdout)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--build", type=pathlib.Path, default=pathlib.Path("build"))
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--count", type=int, default=40)
    parser.add_argument("--copies", type=float, default=2e9, help="triangles times poses at most")
    parser.add_argument("--least-copies", type=float, default=0)
    parser.add_argument("--most-seconds", type=float, default=math.inf)
    parser.add_argument("--threads", type=int, default=os.cpu_count() or 1)
    parser.add_argument("--case", type=int, help="one case, as JSON")
    parser.add_argument("--json", type=pathlib.Path, help="also write all that was found")
    given = parser.parse_args()
    if given.case is not None:
        found = run_case(given.case, given.build.resolve(), given.threads, given.most_seconds)
        print(json.dumps(found))
        return 0
    worst, rows = [0.0, 0.0], []
    for number in range(given.count):
        seed = 1_000_003 * given.seed + number
        case = unseen_inputs.draw_case(seed)
        if not given.least_copies <= case.copies <= given.copies:
            print(f"  not run  {case.name}", flush=True)
            continue
        found = measure(seed, given.build, given.threads, given.most_seconds)
        rows.append(found)
        if "failed" in found:
            print(f"  no run   {found['name']}: {found['failed']}", flush=True)
            continue
        memory, seconds = factors(found)
        worst = [max(worst[0], memory), max(worst[1], seconds)]
        mark = " " if memory <= MOST_MEMORY and seconds <= MOST_SECONDS else "*"
        foreseen = found["foreseen"]
        print(
            f"{mark} {memory:5.2f} {seconds:5.2f}  {foreseen['memory_bytes'] / 1e6:6.0f} "
            f"{found['bytes'] / 1e6:6.0f} MB  {foreseen['seconds']:7.2f} {found['seconds']:7.2f} s "
            f"(look {found['looked']:.2f} s)  {found['name']}",
            flush=True,
        )
    if given.json:
        given.json.write_text(json.dumps(rows, indent=1))
    print(f"worst factors: memory {worst[0]:.2f}, seconds {worst[1]:.2f}")
    return 0 if worst[0] <= MOST_MEMORY and worst[1] <= MOST_SECONDS else 1


if __name__ == "__main__":
    sys.exit(main())
