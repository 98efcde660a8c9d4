# SPDX-License-Identifier: LGPL-2.1-or-later
"""Base of the distance checks of one moving body and of a whole mechanism. `execute` only updates
the state. A run consists of Plan.request(), work() and apply()."""
import contextlib
import json

from .. import convert, core
from ..convert import InputProblem
from ..core_texts import said
from . import containers, missing, status
from .base import Result
from .neighbour_rules import PARTS_PROPERTY


class Check(Result):
    """Base of the proxies of checks. Subclasses define PLAN, RULES (the module of their rules) and
    report_of()."""

    NAMES_PARTS = True
    PLAN = None
    RULES = None

    def report_of(self, obj):
        """Returns the stored report (dict), or None if there is none or it is damaged."""
        raise NotImplementedError

    def summary(self, report):
        """Returns a report in one line."""
        raise NotImplementedError

    def execute(self, obj):
        """Marks the result as stale or current, and keeps it."""
        follow_all_visible(obj)
        update_status(obj)

    def refresh_status(self, obj):
        update_status(obj)

    def onChanged(self, obj, name):
        missing.changed(obj, name)

    def shorten_links(self, obj):
        """Rewrites the links of the check and of its rules so that they begin below the groups
        around the check."""
        if PARTS_PROPERTY in obj.PropertiesList:
            with contextlib.suppress(InputProblem):
                self.RULES.write(obj, self.RULES.read(obj))

    def lost(self, obj, gone):
        self.RULES.drop(obj, gone)


def notes_of(obj):
    """Returns the notes to show for the stored result."""
    report = obj.Proxy.report_of(obj) if obj.Report else None
    if report is None:
        return ""
    found = [said(w["code"], w["text"]) for w in report.get("warnings", [])]
    return "\n".join(list(report.get("notes", [])) + found)


def follow_all_visible(obj):
    """Links the check to everything that AllVisible depends on, including hidden objects. If such
    an object is shown, moved or changed, the result becomes stale. Leaves out objects that depend
    on the check itself."""
    found = []
    if obj.AllVisible:
        above = set(obj.InListRecursive)
        standing = [(o, "") for o in containers.standing(obj.Document)]
        roots = [root for root, _ in containers.links_for(obj, standing)]
        found = [o for o in roots if o not in above and o is not obj]
    if obj.Seen != found:
        obj.Seen = found


def update_status(obj):
    """Compares the present inputs with those of the stored result."""
    plan = obj.Proxy.PLAN.of(obj)
    _rename(obj, plan)
    now, problem, waits = status.inputs_of(obj, plan.words, plan.checked_hash)
    if waits:
        return
    waiting = any(map(status.is_behind, plan.objects() + convert.targets(plan.neighbours)))
    status.judge(obj, now, problem, waiting, notes_of(obj))


def _rename(obj, plan):
    """Updates the labels of parts in the stored report. Otherwise a row might show a label that now
    belongs to another part. The state of the result does not depend on labels."""
    report = obj.Proxy.report_of(obj) if obj.Report else None
    if report is None:
        return
    with contextlib.suppress(InputProblem):
        if plan.rename(report):
            obj.Report, obj.Summary = json.dumps(report), obj.Proxy.summary(report)


def keep(obj, hash_at_start):
    """Stores that the result that was just written belongs to the inputs with this hash."""
    obj.InputHash, obj.TriedHash = hash_at_start, ""
    follow_all_visible(obj)
    update_status(obj)


def fail(obj, text, tried, cancelled=False):
    """Stores the error of a run without a result; the stored result is kept. tried: hash of the
    inputs of the run."""
    status.mark_failure(obj, obj.Proxy.PLAN.of(obj).hash, text, tried, cancelled)


def compute(obj, feature, title, control=None):
    """Runs a check in this thread (for scripts without a GUI) as one undo step, and returns the
    outcome. feature: the module with work() and apply(). Raises core.CoreError."""
    plan = obj.Proxy.PLAN.of(obj)
    hash_at_start = plan.hash()
    try:
        outcome = feature.work(plan.request(), control or core.Control())
    except (core.CoreError, InputProblem) as error:
        fail(obj, str(error), hash_at_start, getattr(error, "status", "") == "Cancelled")
        raise
    obj.Document.openTransaction(title)
    feature.apply(obj, outcome, hash_at_start)
    obj.purgeTouched()
    obj.Document.commitTransaction()
    return outcome
