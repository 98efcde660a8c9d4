# SPDX-License-Identifier: LGPL-2.1-or-later
"""What checks of distances share: of one moving body, and of a whole mechanism. `execute` only marks; a
run is Plan.request() - work() - apply()."""
import contextlib
import json

from .. import convert, core
from ..convert import InputProblem
from ..core_texts import said
from . import containers, missing, status
from .base import Feature
from .neighbour_rules import PARTS_PROPERTY


class Check(Feature):
    """Base of their proxies. Subclasses give PLAN, RULES (the module of their rules), report_of()."""

    NAMES_PARTS = True
    PLAN = None
    RULES = None

    def report_of(self, obj):
        """The stored report (dict); None if there is none, or a damaged one."""
        raise NotImplementedError

    def summary(self, report):
        """A report in one line."""
        raise NotImplementedError

    def execute(self, obj):
        """Marks the result stale or current; keeps it."""
        follow_all_visible(obj)
        update_status(obj)

    def look(self, obj):
        update_status(obj)

    def onChanged(self, obj, name):
        missing.changed(obj, name)

    def shortened(self, obj):
        """Links begin below the groups around the check, those of rules too."""
        if PARTS_PROPERTY in obj.PropertiesList:
            with contextlib.suppress(InputProblem):
                self.RULES.write(obj, self.RULES.read(obj))

    def lost(self, obj, gone):
        self.RULES.drop(obj, gone)


def notes_of(obj):
    """What is to be said of the stored result."""
    report = obj.Proxy.report_of(obj) if obj.Report else None
    if report is None:
        return ""
    found = [said(w["code"], w["text"]) for w in report.get("warnings", [])]
    return "\n".join(list(report.get("notes", [])) + found)


def follow_all_visible(obj):
    """Links to all that AllVisible looks at, hidden things too: what is shown, moved or changed there
    then makes the result stale. Not to what depends on the check itself."""
    found = []
    if obj.AllVisible:
        above = set(obj.InListRecursive)
        standing = [(o, "") for o in containers.standing(obj.Document)]
        roots = [root for root, _ in containers.links_for(obj, standing)]
        found = [o for o in roots if o not in above and o is not obj]
    if obj.Seen != found:
        obj.Seen = found


def update_status(obj):
    """Compares inputs and stored result."""
    plan = obj.Proxy.PLAN.of(obj)
    _rename(obj, plan)
    now, problem, waits = status.inputs_of(obj, plan.words, plan.checked_hash)
    if waits:
        return
    waiting = any(map(status.is_behind, plan.objects() + convert.targets(plan.neighbours)))
    status.judge(obj, now, problem, waiting, notes_of(obj))


def _rename(obj, plan):
    """The stored report names parts as they are called now: a name that another part has got since would tell
    of the wrong one. Whether the result is current does not depend on names."""
    report = obj.Proxy.report_of(obj) if obj.Report else None
    if report is None:
        return
    with contextlib.suppress(InputProblem):
        if plan.rename(report):
            obj.Report, obj.Summary = json.dumps(report), obj.Proxy.summary(report)


def keep(obj, hash_at_start):
    """A result was written: it is that of these inputs."""
    obj.InputHash, obj.TriedHash = hash_at_start, ""
    follow_all_visible(obj)
    update_status(obj)


def fail(obj, text, tried, cancelled=False):
    """Remembers a run that gave nothing; the stored result stays. tried: hash of its inputs."""
    status.mark_failure(obj, obj.Proxy.PLAN.of(obj).hash, text, tried, cancelled)


def compute(obj, feature, title, control=None):
    """Checks in this thread (scripts, no GUI): one undo step; returns the outcome. feature: the module with
    work() and apply(). Raises core.CoreError."""
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
