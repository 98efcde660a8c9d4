# SPDX-License-Identifier: LGPL-2.1-or-later
"""Measures the program and prints and stores the tables of docs/performance.md.

Each case is run several times, and the medians are shown. If a baseline program is given, it runs
in turn with the new one, so that both have the same load. Other work on the machine affects elapsed
seconds, and CPU seconds much less. Both are shown, and the load during the measurement.
"""
import argparse
import datetime
import json
import os
import pathlib
import platform
import statistics
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
STAGES = ["sampling", "signs", "crossings", "contour", "intersections", "mend", "check", "features"]


def measure(program, case, threads, folder):
    """Runs a case once; returns numbers from the report of the program and from the system."""
    report = folder / "report.json"
    report.unlink(missing_ok=True)
    command = [program, "envelope", *case.arguments, "--backend", "cpu", "--quiet"]
    command += ["--output", str(folder / "out.ply"), "--report", str(report)]
    command += ["--threads", str(threads)] if threads else []
    child = subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE)
    message = child.stderr.read().decode(errors="replace").strip()
    _, status, usage = os.wait4(child.pid, 0)
    child.returncode = os.waitstatus_to_exitcode(status)
    child.stderr.close()
    (folder / "out.ply").unlink(missing_ok=True)
    if child.returncode != 0:
        return {"failed": message.splitlines()[-1] if message else f"exit {child.returncode}"}
    found = json.loads(report.read_text())
    seconds = found["seconds"]
    files = seconds.get("read", 0) + seconds.get("write", 0)
    return {
        # "total" includes reading and writing the files, which do not count here.
        "elapsed": seconds["total"] - (files if seconds["total"] > files else 0),
        "cpu": usage.ru_utime + usage.ru_stime,
        "stages": seconds,
        "peak_mb": found["peak_memory_bytes"] / 1e6,
        "triangles": found["triangles"],
        "self_intersections": found["self_intersections"],
        "chord_refined_placements": found["refined_placements"],
    }


def medians(runs):
    """Returns the medians of several runs of one case."""
    good = [r for r in runs if "failed" not in r]
    if not good:
        return runs[0]
    out = {k: statistics.median(r[k] for r in good) for k in good[0] if k != "stages"}
    names = good[0]["stages"]
    out["stages"] = {n: statistics.median(r["stages"].get(n, 0) for r in good) for n in names}
    out["runs"] = len(good)
    return out


def measure_cases(cases, options, folder):
    rows = []
    for case in cases:
        ours, theirs = [], []
        for _ in range(options.repeats):
            ours.append(measure(options.program, case, options.threads, folder))
            if options.baseline:
                theirs.append(measure(options.baseline, case, options.threads, folder))
        row = {"case": case.name, "resolution": case.resolution, "load": os.getloadavg()[0]}
        row.update(reference=case.reference, goal=case.goal, least=case.least)
        row["measured"] = medians(ours)
        row["baseline"] = medians(theirs) if theirs else None
        rows.append(row)
        print(line(row), flush=True)
    return rows


def number(value, digits=2):
    return "-" if value is None else f"{value:.{digits}f}"


def ratio(row):
    ours, theirs = row["measured"], row["baseline"]
    if not theirs or "failed" in theirs or "failed" in ours:
        return "-"
    return f"{ours['cpu'] / theirs['cpu']:.2f}"


HEAD = (
    ["case", "resolution", "elapsed s", "goal / least", "CPU s", "of the baseline", "peak MB"]
    + ["triangles", "pairs left"]
    + STAGES
    + ["load"]
)


def line(row):
    m = row["measured"]
    start = [row["case"], str(row["resolution"])]
    if "failed" in m:
        return "| " + " | ".join(start + ["failed: " + m["failed"].replace("|", "/")]) + " |"
    limits = "-" if row["goal"] is None else f"{row['goal']:g} / {row['least']:g}"
    cells = start + [number(m["elapsed"]), limits, number(m["cpu"]), ratio(row)]
    cells += [f"{m['peak_mb']:.0f}", f"{m['triangles']:.0f}", f"{m['self_intersections']:.0f}"]
    cells += [number(m["stages"].get(name)) for name in STAGES]
    return "| " + " | ".join(cells + [number(row["load"], 1)]) + " |"


def header():
    return ["| " + " | ".join(HEAD) + " |", "| " + " | ".join(["---"] * len(HEAD)) + " |"]


def processor():
    for text in pathlib.Path("/proc/cpuinfo").read_text().splitlines():
        if text.startswith("model name"):
            return text.split(":", 1)[1].strip()
    return platform.machine()


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--program", default=str(ROOT / "build" / "bin" / "swept"))
    parser.add_argument("--baseline", help="an older build of the program to compare with")
    parser.add_argument("--set", choices=["quick", "table", "growth", "large"], default="table")
    parser.add_argument("--only", help="cases whose name holds this")
    parser.add_argument("--repeats", type=int, default=3)
    parser.add_argument("--threads", type=int, default=0, help="0: all cores")
    parser.add_argument("--shared", default=str(ROOT.parent / "shared" / "data"))
    parser.add_argument("--store", help="folder for NAME.json and NAME.md, NAME being the set")
    options = parser.parse_args()

    shared = pathlib.Path(options.shared)
    if not (shared / "cases.json").is_file():
        print(f"SKIPPED: the inputs of the table are not at {shared}")
        return 0
    sys.path[:0] = [str(pathlib.Path(__file__).parent), str(ROOT / "build" / "python")]
    import cases

    with tempfile.TemporaryDirectory() as temporary:
        folder = pathlib.Path(temporary)
        if options.set == "growth":
            listed = cases.growth(shared, folder / "inputs")
        else:
            listed = cases.table(shared, options.set)
        listed = [c for c in listed if not options.only or options.only in c.name]
        about = {
            "set": options.set,
            "date": datetime.datetime.now(datetime.timezone.utc).strftime("%Y-%m-%d %H:%M UTC"),
            "processor": processor(),
            "cores": os.cpu_count(),
            "threads": options.threads or os.cpu_count(),
            "repeats": options.repeats,
        }
        caption = "{date}, {processor}, {threads} of {cores} cores, medians of {repeats}".format(
            **about
        )
        print(caption + "\n\n" + "\n".join(header()), flush=True)
        rows = measure_cases(listed, options, folder)
    if options.store:
        store = pathlib.Path(options.store)
        store.mkdir(parents=True, exist_ok=True)
        (store / f"{options.set}.json").write_text(json.dumps({**about, "rows": rows}, indent=1))
        text = [caption, "", *header(), *[line(row) for row in rows], ""]
        (store / f"{options.set}.md").write_text("\n".join(text))
        print(f"stored in {store}/{options.set}.json and .md")
    return 1 if any("failed" in row["measured"] for row in rows) else 0


if __name__ == "__main__":
    sys.exit(main())
