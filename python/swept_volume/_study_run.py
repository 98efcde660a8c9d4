# SPDX-License-Identifier: LGPL-2.1-or-later
"""Computes one run of a study: reads its files, computes its stages, writes the results to a folder."""
from __future__ import annotations

import hashlib
import json
import os
import pathlib
import time
import uuid
from typing import Any, Callable, Dict, List, Mapping, Optional, Tuple

from . import _core
from ._calls import Result, RunContext, compute, write_solid
from ._clearance import clearance
from ._pages import report_page
from ._study_file import Run
from ._values import Mesh, Motion, read_body, read_motion, read_parts

Report = Dict[str, Any]

REPORT_FILE = "report.json"
PAGE_FILE = "clearance.html"
PARTIAL = ".partial-"  # prefix of the names of incomplete folders and files
DONE, NOT_CLEAR, FAILED = "done", "not clear", "failed"
_SUFFIXES = {"envelope": "ply", "solid": "step"}  # unless the study file names a format


def json_text(report: Mapping[str, Any]) -> str:
    """Returns the JSON text of a report, as it is written to files."""
    return json.dumps(report, indent=1) + "\n"


def partial_folder(output: str) -> str:
    """Makes a new folder in `output` for the results of one run."""
    folder = os.path.join(output, PARTIAL + uuid.uuid4().hex)
    os.mkdir(folder)
    return folder


def file_hash(path: str) -> str:
    """Returns the SHA-256 of a file."""
    digest = hashlib.sha256()
    with open(path, "rb") as file:
        while block := file.read(1 << 20):
            digest.update(block)
    return digest.hexdigest()


def run_key(run: Run, hashes: Mapping[str, str]) -> str:
    """Returns one hash of everything on which the results of a run depend: the version of the core, the
    names (without folders), contents and roles of the files, the rules, the stages and the options.
    """
    files = [[pathlib.PurePath(file).name, hashes[file]] for file in run.files()]
    roles = [run.part, run.motion, *run.neighbours]
    order = [run.files().index(file) for file in roles]
    parts = [_core.__version__, files, order, run.rules, run.compute, run.options]
    return hashlib.sha256(json.dumps(parts, sort_keys=True).encode()).hexdigest()


def output_name(run: Run, stage: str) -> str:
    """Returns the name of the file that the stage "envelope" or "solid" writes."""
    suffix = run.options[stage].get("format", _SUFFIXES[stage])
    return f"{stage}.{suffix}"


def output_names(run: Run) -> List[str]:
    """Returns the file names of all results, without the report."""
    names = [output_name(run, stage) for stage in run.compute if stage in _SUFFIXES]
    return names + [PAGE_FILE] * run.options.get("clearance", {}).get("page", False)


class _Stages:
    """The stages of one run. The motion and the envelope are read or computed only once."""

    def __init__(
        self,
        run: Run,
        hashes: Mapping[str, str],
        locate: Callable[[str], str],
        context: RunContext,
    ) -> None:
        self.run, self.hashes, self.locate, self.context = run, hashes, locate, context
        self.files = run.options[""]
        pivot = self.files.get("pivot", (0.0, 0.0, 0.0))
        unit = self.files.get("motion_unit", "mm")
        interpolation = self.files.get("interpolation", "linear")
        self.motion: Motion = read_motion(
            locate(run.motion), unit=unit, interpolation=interpolation, pivot=pivot
        )
        self.warnings: List[Dict[str, Any]] = []  # findings of the stage solid
        self._result: Optional[Result] = None

    def _body(self, **options: Any) -> Mesh:
        return read_body(
            self.locate(self.run.part), unit=self.files.get("part_unit", "mm"), **options
        )

    def _options(self, stage: str, *without: str) -> Dict[str, Any]:
        options = self.run.options.get(stage, {})
        return {key: value for key, value in options.items() if key not in ("format", *without)}

    def _computed(self) -> Result:
        if self._result is None:
            options = self._options("envelope")
            sizes = ("accuracy", "cell", "resolution")
            size = {key: options[key] for key in sizes if key in options}
            self._result = compute(self._body(**size), self.motion, run=self.context, **options)
        return self._result

    def envelope(self, path: str) -> Report:
        result = self._computed()
        result.mesh.write(path)
        return result.report

    def solid(self, path: str) -> Report:
        mesh, options = self._computed().mesh, self._options("solid")
        report = write_solid(path, mesh, run=self.context, **options)
        self.warnings = report.pop("warnings")
        return report

    def clearance(self, folder: str) -> Report:
        own = ("deflection", "neighbour_chord", "page", "language", "template")
        options = self._options("clearance", *own)
        given = self.run.options["clearance"]
        deflection, chords = given.get("deflection", 0.05), given.get("neighbour_chord", 0.0)

        def chord_of(file: str) -> float:
            by_name = isinstance(chords, dict)
            return float(chords.get(pathlib.PurePath(file).stem, 0.0) if by_name else chords)

        neighbours = [
            part
            for file in self.run.neighbours
            for part in read_parts(
                self.locate(file),
                unit=self.files.get("neighbour_unit", "mm"),
                chord_error=chord_of(file),
                deflection=deflection,
            )
        ]
        body = self._body(tolerance=deflection)
        rules = self.run.rules
        report = clearance(body, self.motion, neighbours, rules=rules, run=self.context, **options)
        report["warnings"][:0] = body.findings
        if given.get("page"):
            self._write_page(os.path.join(folder, PAGE_FILE), report, body, neighbours)
        return report

    def _write_page(
        self, path: str, report: Report, body: Mesh, neighbours: List[Tuple[str, Mesh]]
    ) -> None:
        roles = [("body", self.run.part), ("motion", self.run.motion)]
        roles += [("neighbour", file) for file in self.run.neighbours]
        inputs = [(role, os.path.basename(file), "", self.hashes[file]) for role, file in roles]
        moving = (pathlib.PurePath(self.run.part).stem, body, self.motion)
        given = self.run.options["clearance"]
        text = report_page(
            report,
            parts=[moving, *neighbours],
            inputs=inputs,
            title=self.run.name,
            language=given["language"],
            template=given["template"],
        )
        with open(path, "w", encoding="utf-8", newline="") as file:
            file.write(text)


def _failure(error: BaseException) -> Report:
    if isinstance(error, _core.Error):
        return {"status": error.status, "code": error.code, "message": str(error)}
    if isinstance(error, MemoryError):
        text = "memory ran out; use a larger cell or smaller files"
        return {"status": "OutOfMemory", "code": "OutOfMemory", "message": text}
    if isinstance(error, OSError):
        return {"status": "InvalidInput", "code": "BadFile", "message": str(error)}
    text = f"{type(error).__name__}: {error}"
    return {"status": "InternalError", "code": "Unexpected", "message": text}


def failed(run: Run, key: str, status: str, code: str, message: str) -> Report:
    """Returns the report of a run that did not end normally."""
    found = {"status": status, "code": code, "message": message}
    return {
        "report_version": 1,
        "command": "run",
        "run": run.name,
        "key": key,
        "warnings": [],
        **found,
    }


def state_of(report: Mapping[str, Any]) -> str:
    """Returns DONE, NOT_CLEAR (a neighbour does not meet its rule) or FAILED."""
    if report["status"] != "Ok":
        return FAILED
    rows = report.get("clearance", {}).get("neighbours", ())
    return DONE if all(row["meets_rule"] for row in rows) else NOT_CLEAR


def execute(
    run: Run,
    key: str,
    output: str,
    hashes: Mapping[str, str],
    threads: int,
    locate: Optional[Callable[[str], str]] = None,
) -> Tuple[Report, str]:
    """Computes a run and writes its results and its report to a new folder in `output`. Returns the
    report and the folder. An error of the run is not raised; the report describes it. hashes: SHA-256
    of the files, for the page of the run. locate: returns the path of a file on this machine."""
    began = time.monotonic()
    folder = partial_folder(output)
    report = failed(run, key, "Ok", "", "")
    try:
        stages = _Stages(run, hashes, locate or (lambda file: file), RunContext(threads=threads))
        for stage in run.compute:
            if stage == "clearance":
                report[stage] = stages.clearance(folder)
            else:
                path = os.path.join(folder, output_name(run, stage))
                report[stage] = getattr(stages, stage)(path)
        report["warnings"] = stages.warnings
    except Exception as error:  # one run that fails does not stop the others
        report.update(_failure(error))
    report["seconds"] = {"total": round(time.monotonic() - began, 3)}
    with open(os.path.join(folder, REPORT_FILE), "w", encoding="utf-8") as file:
        file.write(json_text(report))
    return report, folder
