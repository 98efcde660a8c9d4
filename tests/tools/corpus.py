#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Corpus: more than 1,000 defective, extreme and real bodies x 3 motions at 64 and 128 cells.

    corpus.py BUILD [--seconds S] [--resolution R]... [--only WORD]... [--store FILE]

Every run must end as promised: Ok with a mesh that is closed, manifold, oriented and finite (counted
here once more), or a failure with a code and a sentence. Each run is in a child process, so that a crash
or a hang is noticed too. Results are appended to FILE (out/corpus.jsonl). Cases that are in FILE already
are skipped, so a campaign can be continued later. At the end, the table is printed from FILE. Ends with
1 if a run broke the promise or less than 99.5 % of valid solids are Ok.
"""
import argparse
import collections
import json
import os
import pathlib
import random
import resource
import select
import subprocess
import sys
import time

import numpy as np

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path[:0] = [str(ROOT / "tests/tools"), str(ROOT / "tests/python")]

import corpus_bodies  # noqa: E402
from shared_data import FOLDER, MOTIONS, matrices, scaled_motion  # noqa: E402

HANG = 900  # s of processor time
MOST_BYTES = 8 << 30  # address space of the child; the limit of a run is 2.5 GB


def load(build):
    sys.path.insert(0, str(pathlib.Path(build) / "python"))
    import _swept

    return _swept


def faults(result):
    """Returns what is wrong with the mesh of a run with the status Ok, without the module's checker."""
    v, t = np.asarray(result.vertices), np.asarray(result.triangles)
    if not len(t):
        return ["empty"]
    found = []
    if not np.isfinite(v).all():
        found.append("not finite")
    if t.min() < 0 or t.max() >= len(v):
        return found + ["bad index"]
    half = np.concatenate([t[:, [0, 1]], t[:, [1, 2]], t[:, [2, 0]]]).astype(np.int64)
    forth = np.sort(half[:, 0] * len(v) + half[:, 1])
    back = np.sort(half[:, 1] * len(v) + half[:, 0])
    if (forth[1:] == forth[:-1]).any() or not np.array_equal(forth, back):
        found.append("edges")
    flags = [k for k in ("closed", "manifold", "oriented", "finite") if not result.report[k]]
    return found + flags


def one_run(swept, body, motion, resolution):
    vertices, triangles, cell = body
    finite = np.isfinite(vertices).all(axis=1) if len(vertices) else np.zeros(0, bool)
    size = float(np.ptp(vertices[finite], axis=0).max()) if finite.any() else 1.0
    poses = matrices(*scaled_motion(swept, motion, size or 1.0))
    start = time.process_time()
    outcome = {"valid_end": True, "self_intersections": 0}
    try:
        run = swept.RunContext(memory_limit_mb=2500)
        fine = {"cell": cell * 64 / resolution} if cell else {"resolution": resolution}
        result = swept.compute(vertices, triangles, poses, run=run, **fine)
        outcome["status"] = "Ok"
        outcome["self_intersections"] = result.report["self_intersections"]
        wrong = faults(result)
        if wrong:
            outcome.update(valid_end=False, text="Ok, but " + ", ".join(wrong))
    except swept.Error as error:
        outcome.update(status=f"{error.status}/{error.code}", text=str(error))
        outcome["valid_end"] = bool(error.code and str(error)) and error.status != "InternalError"
    except (ValueError, OverflowError) as error:  # arrays that are no mesh
        outcome.update(status="ValueError", text=str(error))
    outcome["seconds"] = round(time.process_time() - start, 2)
    return outcome


def serve(build):
    """Runs as the child process: reads each job as a line of JSON and prints its outcome as a line.
    A job that takes far more memory than its limit ends the child, not the machine."""
    resource.setrlimit(resource.RLIMIT_AS, (MOST_BYTES, MOST_BYTES))
    swept = load(build)
    makers = {name: make for name, _, _, make in corpus_bodies.all_bodies(swept)}
    name, body = None, None
    for line in sys.stdin:
        job = json.loads(line)
        try:
            if job["body"] != name:
                name, body = job["body"], makers[job["body"]]()
            outcome = one_run(swept, body, job["motion"], job["resolution"])
        except Exception as error:  # any exception but the module's own breaks the promise
            outcome = {"status": type(error).__name__, "text": str(error), "valid_end": False}
        print(json.dumps(outcome), flush=True)


class Child:
    def __init__(self, build):
        self.build, self.process = build, None

    def run(self, job):
        if self.process is None:
            self.process = subprocess.Popen(
                [sys.executable, __file__, self.build, "--serve"],
                stdin=subprocess.PIPE,
                stdout=subprocess.PIPE,
                text=True,
            )
        self.process.stdin.write(json.dumps(job) + "\n")
        self.process.stdin.flush()
        ready, end = [], self.processor_seconds() + HANG
        while not ready and self.processor_seconds() < end:
            ready, _, _ = select.select([self.process.stdout], [], [], 5)
        line = self.process.stdout.readline() if ready else ""
        if line:
            return json.loads(line)
        self.process.kill()
        code = self.process.wait()
        self.process = None
        status = "hang" if not ready else f"crash {code}"
        return {"status": status, "text": f"after {HANG} s at most", "valid_end": False}

    def processor_seconds(self):
        fields = (
            pathlib.Path(f"/proc/{self.process.pid}/stat").read_text().rsplit(")", 1)[1].split()
        )
        return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")

    def stop(self):
        if self.process is not None:
            self.process.stdin.close()
            self.process.wait()


def table(results):
    """Prints counts by family. Returns whether the promise holds for all runs, and 99.5 % are Ok."""
    rows = collections.defaultdict(list)
    for r in results:
        rows[r["family"]].append(r)
    print("| family | bodies | runs | Ok | refused | broken | self-intersecting | most often |")
    print("| --- | --- | --- | --- | --- | --- | --- | --- |")

    def line(name, runs):
        ok = [r for r in runs if r["status"] == "Ok"]
        broken = sum(not r["valid_end"] for r in runs)
        crossing = sum(r.get("self_intersections", 0) > 0 for r in ok)
        codes = collections.Counter(r["status"] for r in runs if r["status"] != "Ok")
        most = ", ".join(f"{c} {n}" for c, n in codes.most_common(2))
        bodies = len({r["body"] for r in runs})
        refused = (
            len(runs) - len(ok) - sum(not r["valid_end"] and r["status"] != "Ok" for r in runs)
        )
        counts = (name, bodies, len(runs), len(ok), refused, broken, crossing, most)
        print("| " + " | ".join(map(str, counts)) + " |")

    for name in sorted(rows):
        line(name, rows[name])
    line("all", results)
    valid = [r for r in results if r["valid"]]
    good = sum(r["status"] == "Ok" for r in valid)
    ended = sum(r["valid_end"] for r in results)
    crossing = sum(r.get("self_intersections", 0) > 0 for r in results)
    every, most = ended == len(results), good >= 0.995 * len(valid)
    print(
        f"\nend as promised, bar 100 %: {ended} of {len(results)}: {'holds' if every else 'MISSED'}\n"
        f"valid solids Ok, bar 99.5 %: {good} of {len(valid)} "
        f"({100 * good / max(len(valid), 1):.2f} %): {'holds' if most else 'MISSED'}\n"
        f"self-intersecting results, bar 0 or each listed: {crossing}"
    )
    for r in results:
        if not r["valid_end"] or (r["valid"] and r["status"] != "Ok"):
            text = r.get("text", "")[:160]
            print(f"  {r['body']} {r['motion'][:12]} {r['resolution']}: {r['status']} {text}")
        elif r.get("self_intersections", 0) > 0:
            count = r["self_intersections"]
            print(f"  {r['body']} {r['motion'][:12]} {r['resolution']}: {count} self-intersections")
    return every and most


def one_of_each_first(jobs, resolutions):
    """Returns the jobs in an order that tries every kind of body early: resolution by resolution, the
    families in turn, and the bodies of a family in random order. The motions of a body stay together,
    so that the body is made only once."""
    bodies = sorted({(job["family"], job["body"]) for job in jobs})
    random.Random(1).shuffle(bodies)
    seen, turn = collections.Counter(), {}
    for family, body in bodies:
        turn[body] = (seen[family], len(turn))
        seen[family] += 1
    return sorted(jobs, key=lambda job: (resolutions.index(job["resolution"]), turn[job["body"]]))


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("build")
    parser.add_argument("--seconds", type=float, default=1e9)
    parser.add_argument("--resolution", type=int, action="append")
    parser.add_argument("--only", action="append", default=[])
    parser.add_argument("--store", default=str(ROOT / "out/corpus.jsonl"))
    parser.add_argument("--serve", action="store_true", help=argparse.SUPPRESS)
    options = parser.parse_args()
    if options.serve:
        return serve(options.build)
    if not FOLDER.exists():
        print("shared test data not found: {}".format(FOLDER))
        return 0
    store = pathlib.Path(options.store)
    store.parent.mkdir(exist_ok=True)
    key = ("body", "motion", "resolution")
    stored = [json.loads(line) for line in store.open()] if store.exists() else []
    done = {tuple(r[k] for k in key): r for r in stored}
    results = list(done.values())
    resolutions = options.resolution or [64, 128]
    jobs = [
        {"body": name, "family": family, "valid": valid, "motion": motion, "resolution": r}
        for name, family, valid, _ in corpus_bodies.all_bodies(None)
        for motion in MOTIONS
        for r in resolutions
        if not options.only or any(word in name for word in options.only)
    ]
    bodies = len({job["body"] for job in jobs})
    print(f"{bodies} bodies, {len(jobs)} runs, {len(done)} stored in {store}", flush=True)
    jobs = one_of_each_first(jobs, resolutions)
    child, end = Child(options.build), time.time() + options.seconds
    with store.open("a") as file:
        for job in jobs:
            if time.time() > end:
                break
            if tuple(job[k] for k in key) in done:
                continue
            ask = {k: job[k] for k in key}
            results.append({**job, **child.run(ask)})
            file.write(json.dumps(results[-1]) + "\n")
            file.flush()
    child.stop()
    return 0 if table(results) else 1


if __name__ == "__main__":
    sys.exit(main())
