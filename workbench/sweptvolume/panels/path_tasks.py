# SPDX-License-Identifier: LGPL-2.1-or-later
"""Tasks that search for paths in the runner."""
from .. import contents, core_paths
from ..features import improve_plan, path_plan, sequence
from ..runner import Task
from ..texts import translate


class FindPathTask(Task):
    """Finds a path and creates its motion as one undo step. `outcome`: result (path_plan.Outcome);
    `obj`: the motion, or None; seen: the observer from core_paths.watch(), for the view."""

    def __init__(self, plan):
        self.title = translate("SweptVolume", "Find path")
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
    """Improves a motion and creates the result as another motion, as one undo step. outcome, obj:
    as in FindPathTask."""

    def __init__(self, plan):
        self.title = translate("SweptVolume", "Improve path")
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
    """Finds the paths of a sequence, creates their motions and stores the sequence, as one undo
    step. seen: core_paths.sequence_watch(); outcome: sequence.Outcome; obj: the sequence, or
    None if a path is missing; then nothing is written."""

    def __init__(self, plan, obj=None):
        self.title = translate("SweptVolume", "Sequence")
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
