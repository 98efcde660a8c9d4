# SPDX-License-Identifier: LGPL-2.1-or-later
"""Study: many runs, from a study file or from the document's own envelopes and clearance checks,
with their rows kept in the document (docs/studies.md).

`execute` only updates the state. A run consists of Plan.request(), work() and apply(). A folder
holds the results; the document holds the rows. After a stop the study keeps its rows, and the next
run continues from there.
"""
import json
import os

from .. import core
from ..convert import InputProblem
from ..texts import translate
from . import missing, status, study_table
from .base import (  # noqa: F401 (the states are read from here as well)
    CANCELLED,
    NOT_COMPUTED,
    STALE,
    UP_TO_DATE,
    Result,
    add_object,
    inputs_and_results,
    kind_of,
    stored,
)
from .study_plan import Plan
from .study_properties import INPUT, RESULT

TYPE = "App::FeaturePython"
missing.watch()


class Study(Result):
    """Proxy of the study."""

    KIND = "SweptVolume::Study"
    NAMES_PARTS = True

    def properties(self):
        return inputs_and_results(INPUT, RESULT)

    def execute(self, obj):
        """Marks the result as stale or current, and keeps it."""
        update_status(obj)

    def refresh_status(self, obj):
        update_status(obj)

    def onChanged(self, obj, name):
        missing.changed(obj, name)


def is_study(obj):
    return kind_of(obj) == Study.KIND


def report_of(obj):
    """Returns the stored report (dict), or None if there is none or it is damaged."""
    return stored(obj.Report, study_table.REPORT)


def update_status(obj):
    """Compares the present inputs with those of the stored result. Without the core a study file
    cannot be read; then the state does not change."""
    plan = Plan.of(obj)
    if not plan.sources and plan.file and not core.available():
        return
    now, problem, waits = status.inputs_of(obj, plan.words, plan.checked_hash)
    if waits:
        return
    if not problem and now == status.NOT_READ and not plan.sources:
        # Shows the fault of a study file that has not run yet.
        _, problem = status.hash_or_problem(plan.runs)
    report = report_of(obj) if obj.Report else None
    if not problem and report is not None and report.get("labels") is not None:
        if report["labels"] != plan.labels():
            now += ", other names"
    status.judge(obj, now, problem, plan.waits(), report["message"] if report else "")


def work(request, control):
    """Writes the study file, if its runs come from the document, and computes the remaining runs.
    Any thread. Returns the report. Raises core.CoreError, InputProblem, OSError."""
    from .. import studies  # imports modules that start processes, so not at FreeCAD's start

    request.prepare(control)

    def on_row(row, done, runs):
        request.rows[row["run"]] = row
        if done is not None:
            control.enter(done, runs)

    return studies.run(request.file, request.output, request.jobs, on_row, control.is_cancelled)


def _store(obj, report, request):
    rows = report["runs"]
    obj.Report = json.dumps(dict(report, labels=request.labels))
    obj.Summary = study_table.summary(report)
    obj.Checked = len(rows) - study_table.count(rows, "not run")
    obj.Verdict = study_table.verdict(report)
    obj.Results, obj.Written = request.output, request.file


def apply(obj, report, request, hash_at_start):
    """Writes the result of a study into the object."""
    _store(obj, report, request)
    obj.InputHash, obj.TriedHash = hash_at_start, ""
    update_status(obj)


def written(obj):
    """Returns (study file, folder of the results), for a page. Raises InputProblem if they are
    gone, or if the document has changed since, because the page would describe other parts. A
    page of a study file shows by itself which runs must be computed again."""
    update_status(obj)
    of_file = bool(obj.File) and not obj.Sources
    if not of_file and obj.Status not in (UP_TO_DATE, CANCELLED):
        text = translate(
            "SweptVolume", 'The result of "{0}" is not up to date: run the study again first.'
        ).format(obj.Label)
        raise InputProblem("\n".join(filter(None, (text, obj.Message))))
    if not os.path.isfile(obj.Written) or not os.path.isdir(obj.Results):
        text = translate(
            "SweptVolume",
            "The results of the study cannot be found in their folder: run the study again.",
        )
        raise InputProblem(text)
    return obj.Written, obj.Results


def unfinished(names, rows):
    """Returns the report of a study that was stopped. rows: rows of the runs that have ended, by
    name."""
    from .. import studies

    found = [rows.get(name, {"run": name, "state": "not run"}) for name in names]
    left = study_table.count(found, "not run")
    text = translate(
        "SweptVolume", "{0} of {1} runs are not done. Start the study again to continue."
    )
    worst = found[studies.worst_first(found)[0]]["run"]
    return {"runs": found, "worst": worst, "message": text.format(left, len(found))}


def fail(obj, text, tried, cancelled=False):
    """Stores the error of a run without a result."""
    status.mark_failure(obj, Plan.of(obj).hash, text, tried, cancelled)


def stop(obj, names, request, tried):
    """Stores that a run was stopped, with the rows so far."""
    report = unfinished(names, request.rows)
    _store(obj, report, request)
    obj.InputHash = ""
    fail(obj, report["message"], tried, cancelled=True)


def compute(obj, control=None):
    """Runs in this thread (for scripts without a GUI) as one undo step, and returns the report.
    Raises core.CoreError, core.CoreMissing, InputProblem, OSError."""
    plan = Plan.of(obj)
    hash_at_start = plan.hash()
    request = plan.request()
    try:
        report = work(request, control or core.Control())
    except (core.CoreError, InputProblem, OSError) as error:
        if getattr(error, "status", "") == "Cancelled":
            stop(obj, plan.runs(), request, hash_at_start)
        else:
            fail(obj, str(error), hash_at_start)
        raise
    obj.Document.openTransaction(translate("SweptVolume", "Run study"))
    apply(obj, report, request, hash_at_start)
    obj.purgeTouched()
    obj.Document.commitTransaction()
    return report


def make_study(document, label=None, **settings):
    """Creates a study, not yet computed. `settings`: property names with values."""
    label = label or translate("SweptVolume", "Study")
    view = "sweptvolume.views.study_view:StudyView"
    return add_object(document, TYPE, "Study", Study, label, settings, view)
