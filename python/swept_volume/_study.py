# SPDX-License-Identifier: LGPL-2.1-or-later
"""Studies: many runs that one file describes, with one table and one folder for their results."""
from __future__ import annotations

import csv
import dataclasses
import io
import math
import time
from typing import Any, Callable, Dict, Iterator, List, Optional, Sequence, Tuple

from . import _core
from ._calls import RunContext, logger
from ._study_file import Run, Study, read_study
from ._study_folder import STUDY_PAGE, STUDY_REPORT, TABLE, Folder
from ._study_page import page_date, study_text
from ._study_run import (
    DONE,
    FAILED,
    NOT_CLEAR,
    Report,
    file_hash,
    json_text,
    run_key,
    state_of,
)
from ._study_workers import Done, Task, compute_here, compute_on_cluster, cores
from ._values import Path, bad_option

NOT_RUN = "not run"
_ORDER = (FAILED, NOT_CLEAR, NOT_RUN, DONE)  # the worst first
#: Names of the columns of the table -> keys of a row.
COLUMNS = {
    "run": "run",
    "state": "state",
    "neighbour": "neighbour",
    "verdict": "verdict",
    "distance_mm": "distance",
    "guaranteed_mm": "guaranteed",
    "time_s": "time_seconds",
    "depth_mm": "depth",
    "volume_mm3": "volume",
    "triangles": "triangles",
    "faces": "faces",
    "deviation_mm": "deviation",
    "findings": "findings",
    "message": "message",
}

Row = Dict[str, Any]


def _worst_neighbour(report: Report) -> Optional[Row]:
    """Returns the neighbour of a run that the table shows: first one that breaks its rule; among
    these, one without a contact rule; among these, the nearest; at equal distance, the deepest."""
    rows: List[Row] = report.get("clearance", {}).get("neighbours", [])

    def order(row: Row) -> Tuple[bool, bool, float, float]:
        depth = row.get("penetration", {}).get("depth", 0.0)
        return row["meets_rule"], "contact" in row.get("rule", {}), row["distance"], -depth

    return min(rows, key=order) if rows else None


def _row(run: Run, report: Optional[Report], strict: bool = False) -> Row:
    """Returns the row of a run. With strict=True, a finding that costs accuracy is a failure."""
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
        if "penetration" in nearest:
            row["depth"] = nearest["penetration"]["depth"]
    envelope, solid = report.get("envelope", {}), report.get("solid", {})
    row.update((key, envelope[key]) for key in ("volume", "triangles") if key in envelope)
    row.update((key, solid[key]) for key in ("faces", "deviation") if key in solid)
    stages = [report, *(report[stage] for stage in run.compute if stage in report)]
    findings = [finding for stage in stages for finding in stage.get("warnings", [])]
    if findings:
        row["findings"] = " ".join(dict.fromkeys(finding["code"] for finding in findings))
    costly = [finding["text"] for finding in findings if _core.costs_accuracy(finding["code"])]
    if strict and costly and row["state"] != FAILED:
        row.update(state=FAILED, message=f"strict: {costly[0]}")
    return row


def worst_first(rows: Sequence[Row]) -> List[int]:
    """Returns the indices of the rows in this order: failures; rows that are not clear (the deepest
    clash first, then the smallest distance); runs that were not computed; runs that are done (the
    smallest distance first)."""

    def order(number: int) -> Tuple[int, float, float]:
        row = rows[number]
        depth = row.get("depth", 0.0) if row["state"] == NOT_CLEAR else 0.0
        return _ORDER.index(row["state"]), -depth, row.get("distance", math.inf)

    return sorted(range(len(rows)), key=order)


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
        text = f"stopped; {counts[NOT_RUN]} of {len(rows)} runs are left; repeat the command to continue"
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
    report["worst"] = rows[worst_first(rows)[0]]["run"]
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


class _StudyState:
    """The content of a study file, the hashes of its files, and the results in its folder."""

    def __init__(self, path: Path, output: Optional[Path], strict: bool = False) -> None:
        self.strict = strict
        self.study = read_study(path, output)
        files = dict.fromkeys(file for one in self.study.runs for file in one.files())
        self.hashes = {file: file_hash(file) for file in [str(self.study.file), *files]}
        self.keys = [run_key(one, self.hashes) for one in self.study.runs]
        self.folder = Folder(self.study.output)
        self.reports: List[Optional[Report]] = [None] * len(self.keys)
        self.rows = [_row(one, None) for one in self.study.runs]

    def read_results(self) -> None:
        """Reads the results that an earlier call has left in the folder."""
        for number, (one, key) in enumerate(zip(self.study.runs, self.keys)):
            self.store(number, self.folder.earlier(one, key))

    def store(self, number: int, report: Optional[Report]) -> None:
        """Stores the report of a run (None: no report yet) and the row of the run."""
        self.reports[number] = report
        self.rows[number] = _row(self.study.runs[number], report, self.strict)

    def tasks(self) -> List[Task]:
        """Returns a task for each run without a report."""
        found = []
        for number, (one, key) in enumerate(zip(self.study.runs, self.keys)):
            if self.reports[number] is None:
                own = {file: self.hashes[file] for file in one.files()}
                found.append(Task(number, one, key, str(self.study.output), own))
        return found

    def summary(self) -> Report:
        return _summary(self.study, self.rows)

    def page(self, folder: str = "", run: Optional[RunContext] = None) -> str:
        order = worst_first(self.rows)
        found = self.summary()
        return study_text(self.study, found, self.reports, self.hashes, order, folder, run)


def run_study(
    path: Path,
    *,
    output: Optional[Path] = None,
    jobs: Optional[int] = None,
    scheduler: Optional[str] = None,
    send_files: bool = False,
    again: bool = False,
    page: bool = False,
    strict: bool = False,
    progress: Optional[Progress] = None,
    kept: Optional[Callable[[Sequence[Row]], None]] = None,
    run: Optional[RunContext] = None,
) -> Report:
    """Computes all runs of a study file (docs/studies.md). Writes their results and a table to a folder.

    output          folder for the results, in place of the folder that the file names
    jobs            number of runs at the same time on this machine (None: one for each core). The
                    results do not depend on this number
    scheduler       address of a dask scheduler (tcp://host:8786), whose workers compute the runs
    send_files      send the files through the scheduler. Without this option, all machines must have
                    access to the same folders
    again           also compute runs for which results with the same input and options exist
    page            also write study.html, a page for people, even if the file does not request it
    strict          count a run as failed if it has a finding that costs accuracy
                    (docs/command_line.md, "--strict"). Its results are written and kept
    progress        function(ended, all, row), called after each run: the number of runs that have
                    ended, the number of all runs, and the row of this run
    kept            function(rows), called first, with the rows of runs whose results exist
    run             RunContext with which another thread can cancel the study

    Returns the report of the study. `runs` are the rows of the table, and `worst` names the run that
    needs attention first. If a run fails, its row says so, and the other runs go on. After a cancelled
    call, the next call computes the missing runs. Raises InvalidInput (BadStudy, BadOption, FolderInUse) and
    FileNotFoundError. Raises OSError if the scheduler does not answer or results cannot be written.
    """
    if jobs is not None and jobs < 1:
        raise bad_option(f"jobs is {jobs}; it must be 1 or more")
    if send_files and scheduler is None:
        raise bad_option("send_files is for a scheduler; name its address")
    state, context, began = _StudyState(path, output, strict), run or RunContext(), time.monotonic()
    study, folder = state.study, state.folder
    if page or study.page:
        page_date()  # raises an error for a wrong date before anything is computed
    with folder.locked():
        if not again:
            state.read_results()
        todo = state.tasks()
        ended = len(study.runs) - len(todo)
        kept_count = ended
        if kept is not None:
            left = {task.number for task in todo}
            kept([row for number, row in enumerate(state.rows) if number not in left])
        try:
            for number, report, filled in _reports(todo, jobs, scheduler, send_files, context):
                folder.take(study.runs[number], report, filled)
                state.store(number, report)
                ended += 1
                if progress is not None:
                    progress(ended, len(study.runs), state.rows[number])
        finally:
            folder.remove_partial()
            found = state.summary()
            folder.write(TABLE, _table(state.rows))
            folder.write(STUDY_REPORT, json_text(found))
            if page or study.page:
                folder.write(STUDY_PAGE, state.page())
    found["kept"] = kept_count
    found["seconds"] = {"total": round(time.monotonic() - began, 3)}
    logger.info("%s: %d runs, %d of them kept", study.name, len(study.runs), kept_count)
    return found


def study_page(
    path: Path,
    *,
    output: Optional[Path] = None,
    folder: str = "",
    template: Optional[str] = None,
    run: Optional[RunContext] = None,
) -> str:
    """Returns the text of an HTML file about all runs of a study file, from the results in its folder.
    Computes nothing: runs without results, or with results of other input, are shown as "not run".
    output: folder for the results, in place of the folder that the file names. folder: path from the
    page to the folder of results, such as "results/", for links to the pages of single runs.
    template: text, in place of the template that the file names. Raises InvalidInput (BadStudy, BadTemplate),
    FileNotFoundError, Cancelled."""
    state = _StudyState(path, output)
    if template is not None:
        state.study = dataclasses.replace(state.study, template=template)
    state.read_results()
    return state.page(folder, run)
