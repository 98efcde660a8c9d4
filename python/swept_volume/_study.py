# SPDX-License-Identifier: LGPL-2.1-or-later
"""Studies: many runs from one file, kept in a folder that knows what is done, with one table."""
from __future__ import annotations

import csv
import io
import json
import math
import os
import pathlib
import shutil
import time
from typing import Any, Callable, Dict, Iterator, List, Optional, Sequence, Tuple

from ._calls import RunContext, logger
from ._study_file import Run, Study, read_study
from ._study_run import (
    DONE,
    FAILED,
    NOT_CLEAR,
    PARTIAL,
    REPORT_FILE,
    Report,
    file_hash,
    json_text,
    output_names,
    partial_folder,
    run_key,
    state_of,
)
from ._study_workers import Done, Task, compute_here, compute_on_cluster, cores
from ._values import Path, bad_option

NOT_RUN = "not run"
_ORDER = (FAILED, NOT_CLEAR, NOT_RUN, DONE)  # the worst first
TABLE = "study.csv"
STUDY_REPORT = "study.json"
#: Of the table: names of columns and the keys of a row that they show.
COLUMNS = {
    "run": "run",
    "state": "state",
    "neighbour": "neighbour",
    "verdict": "verdict",
    "distance_mm": "distance",
    "guaranteed_mm": "guaranteed",
    "time_s": "time_seconds",
    "volume_mm3": "volume",
    "triangles": "triangles",
    "faces": "faces",
    "deviation_mm": "deviation",
    "findings": "findings",
    "message": "message",
}

Row = Dict[str, Any]


def _worst_neighbour(report: Report) -> Optional[Row]:
    """The row of a clearance that meets its rule least: what breaks a rule first, then the nearest."""
    rows: List[Row] = report.get("clearance", {}).get("neighbours", [])

    def order(row: Row) -> Tuple[bool, float, float]:
        return row["meets_rule"], row["distance"], -row.get("penetration", {}).get("depth", 0.0)

    return min(rows, key=order) if rows else None


def _row(run: Run, report: Optional[Report]) -> Row:
    row: Row = {"run": run.name, "state": NOT_RUN}
    if report is None:
        return row
    row["state"] = state_of(report)
    if report["message"]:
        row["message"] = report["message"]
    nearest = _worst_neighbour(report)
    if nearest is not None:
        row["neighbour"] = nearest["name"]
        keys = ("verdict", "distance", "guaranteed", "time_seconds")
        row.update((key, nearest[key]) for key in keys)
    envelope, solid = report.get("envelope", {}), report.get("solid", {})
    row.update((key, envelope[key]) for key in ("volume", "triangles") if key in envelope)
    row.update((key, solid[key]) for key in ("faces", "deviation") if key in solid)
    stages = [report, *(report[stage] for stage in run.compute if stage in report)]
    codes = [finding["code"] for stage in stages for finding in stage.get("warnings", [])]
    if codes:
        row["findings"] = " ".join(dict.fromkeys(codes))
    return row


def _worst_row(rows: Sequence[Row]) -> Row:
    """What to look at first: a failure, else what is not clear, else the smallest distance."""
    return min(rows, key=lambda row: (_ORDER.index(row["state"]), row.get("distance", math.inf)))


class _Folder:
    """The folder of a study's results: a folder a run, each with its report, and the table."""

    def __init__(self, study: Study) -> None:
        self.study, self.path = study, study.output
        self.path.mkdir(parents=True, exist_ok=True)
        self.remove_partial()

    def remove_partial(self) -> None:
        """What a study that was stopped has left."""
        for left in self.path.glob(PARTIAL + "*"):
            shutil.rmtree(left, ignore_errors=True)

    def earlier(self, run: Run, key: str) -> Optional[Report]:
        """The report of an earlier run of the same input with the same options, unless it failed."""
        folder = self.path / run.name
        try:
            report: Report = json.loads((folder / REPORT_FILE).read_text(encoding="utf-8"))
            whole = all((folder / name).is_file() for name in output_names(run))
            same = report["key"] == key and report["status"] == "Ok"
        except (OSError, ValueError, KeyError, TypeError):
            return None
        return report if whole and same else None

    def take(self, run: Run, report: Report, filled: Optional[str]) -> None:
        """Puts the folder that a run filled in the place of an older one."""
        folder = self.path / run.name
        if filled is None:
            filled = partial_folder(str(self.path))
            text = json_text(report)
            pathlib.Path(filled, REPORT_FILE).write_text(text, encoding="utf-8")
        if folder.exists():
            old = self.path / (PARTIAL + run.name + ".old")
            folder.rename(old)
            pathlib.Path(filled).rename(folder)
            shutil.rmtree(old)
        else:
            pathlib.Path(filled).rename(folder)

    def write(self, name: str, text: str) -> None:
        made = self.path / (PARTIAL + name)
        made.write_text(text, encoding="utf-8", newline="")
        os.replace(made, self.path / name)


def _table(rows: Sequence[Row]) -> str:
    lines = io.StringIO(newline="")
    writer = csv.writer(lines, lineterminator="\n")
    writer.writerow(COLUMNS)
    writer.writerows([row.get(key, "") for key in COLUMNS.values()] for row in rows)
    return lines.getvalue()


def _summary(study: Study, rows: Sequence[Row]) -> Report:
    counts = {state: sum(row["state"] == state for row in rows) for state in _ORDER}
    report: Report = {"report_version": 1, "command": "study", "status": "Ok", "code": ""}
    report["message"] = ""
    failure = next((row for row in rows if row["state"] == FAILED), None)
    if counts[NOT_RUN]:
        text = f"stopped; {counts[NOT_RUN]} of {len(rows)} runs are left: the same command goes on"
        report.update(status="Cancelled", code="Cancelled", message=text)
    elif failure is not None:
        text = (
            f"{counts[FAILED]} of {len(rows)} runs failed; '{failure['run']}': {failure['message']}"
        )
        report.update(status="InvalidInput", code="RunsFailed", message=text)
    report["name"] = study.name
    report["output"] = str(study.output)
    keys = {DONE: "done", NOT_CLEAR: "not_clear", FAILED: "failed", NOT_RUN: "not_run"}
    report.update((key, counts[state]) for state, key in keys.items())
    report["worst"] = _worst_row(rows)["run"]
    report["runs"] = list(rows)
    return report


Progress = Callable[[int, int, Row], None]


def _reports(
    tasks: Sequence[Task],
    jobs: Optional[int],
    scheduler: Optional[str],
    send_files: bool,
    context: RunContext,
) -> Iterator[Done]:
    if not tasks:
        return iter(())
    if scheduler is not None:
        return compute_on_cluster(tasks, scheduler, send_files, lambda: context.cancelled)
    return compute_here(tasks, jobs or cores(), lambda: context.cancelled)


def run_study(
    path: Path,
    *,
    output: Optional[Path] = None,
    jobs: Optional[int] = None,
    scheduler: Optional[str] = None,
    send_files: bool = False,
    again: bool = False,
    progress: Optional[Progress] = None,
    run: Optional[RunContext] = None,
) -> Report:
    """Computes all runs of a study file (docs/studies.md) into a folder, and a table of them.

    output          another folder for results than the file says
    jobs            runs at once on this machine (None: one for each core); all compute the same bytes
    scheduler       address of a dask scheduler (tcp://host:8786), whose workers compute instead
    send_files      files travel through the scheduler; else all machines see the same folders
    again           compute runs again whose results are there, with the same input and options
    progress        called with the number of runs that have ended, of all runs, and the row of the last
    run             cancels

    Returns the report of the study: its `runs` are the rows of the table, `worst` names the run to look
    at first. A run that fails has a row that says so and stops no other. What was cancelled goes on at
    the next call. Raises InvalidInput (BadStudy, BadOption), FileNotFoundError, OSError where the
    scheduler does not answer or results cannot be written.
    """
    if jobs is not None and jobs < 1:
        raise bad_option(f"jobs is {jobs}; it must be 1 or more")
    if send_files and scheduler is None:
        raise bad_option("send_files is for a scheduler; name its address")
    study, context, began = read_study(path, output), run or RunContext(), time.monotonic()
    hashes = {file: file_hash(file) for one in study.runs for file in one.files()}
    folder = _Folder(study)
    keys = [run_key(one, hashes) for one in study.runs]
    reports: List[Optional[Report]] = [
        None if again else folder.earlier(one, key) for one, key in zip(study.runs, keys)
    ]
    rows = [_row(one, report) for one, report in zip(study.runs, reports)]
    numbered = enumerate(zip(study.runs, keys))
    todo = [Task(i, one, key, str(study.output)) for i, (one, key) in numbered if not reports[i]]
    kept, ended = len(rows) - len(todo), 0
    try:
        for number, report, filled in _reports(todo, jobs, scheduler, send_files, context):
            folder.take(study.runs[number], report, filled)
            rows[number] = _row(study.runs[number], report)
            ended += 1
            if progress is not None:
                progress(kept + ended, len(rows), rows[number])
    finally:
        folder.remove_partial()
        found = _summary(study, rows)
        folder.write(TABLE, _table(rows))
        folder.write(STUDY_REPORT, json_text(found))
    found["kept"] = kept
    found["seconds"] = {"total": round(time.monotonic() - began, 3)}
    logger.info("%s: %d runs, %d of them kept", study.name, len(rows), kept)
    return found
