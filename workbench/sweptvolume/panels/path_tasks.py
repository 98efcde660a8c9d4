# SPDX-License-Identifier: LGPL-2.1-or-later
"""Searches for paths as the runner takes them."""
from .. import contents, core_paths
from ..features import improve_plan, path_plan, sequence
from ..runner import Task
from ..texts import translate


class FindPathTask(Task):
    """Finds a path and makes a motion of it; one undo step. `outcome`: what was found (path_plan.Outcome),
    `obj`: the motion, or None; seen: what a view may look at meanwhile (core_paths.watch())."""

    def __init__(self, plan):
        self.title = translate("Commands", "Find path")
        self.document, self.plan = plan.document, plan
        self.request = plan.request()
        self.pivot = plan.pivot
        self.watched = [o for o in plan.objects() if o.Document is plan.document]
        self.seen = core_paths.watch()
        self.outcome, self.obj = None, None

    def work(self, control):
        return path_plan.work(self.request, self.pivot, control, self.seen)

    def finish(self, value):
        self.outcome = value
        if value.poses is not None:
            self.obj = path_plan.make(self.document, self.plan.pairs, value.poses)


class ImproveTask(Task):
    """Makes a better motion beside one; one undo step. outcome, obj: as FindPathTask has them."""

    def __init__(self, plan):
        self.title = translate("Commands", "Improve path")
        self.document, self.plan = plan.document, plan
        self.request = plan.request()
        self.watched = [o for o in plan.objects() if o.Document is plan.document]
        self.outcome, self.obj = None, None

    def work(self, control):
        return improve_plan.work(self.request, control)

    def finish(self, value):
        self.outcome = value
        if value.poses is not None:
            self.obj = improve_plan.make(self.plan, value)


class SequenceTask(Task):
    """Finds the ways of a sequence, makes motions of them and keeps the sequence; one undo step. seen:
    core_paths.sequence_watch(); outcome: sequence.Outcome; obj: the sequence, None where not all ways were
    found: nothing is written then."""

    def __init__(self, plan, obj=None):
        self.title = translate("Commands", "Sequence")
        self.document, self.plan, self.kept = plan.document, plan, obj
        contents.prepared(plan.words())
        self.request = plan.request()
        watched = plan.objects() + ([obj] if obj is not None else [])
        self.watched = [o for o in watched if o.Document is plan.document]
        self.seen = core_paths.sequence_watch()
        self.outcome, self.obj = None, None

    def work(self, control):
        return sequence.work(self.request, control, self.seen)

    def finish(self, value):
        self.outcome = value
        if value.is_found():
            self.obj = sequence.keep(self.plan, value, self.kept)
