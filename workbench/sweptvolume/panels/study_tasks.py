# SPDX-License-Identifier: LGPL-2.1-or-later
"""Tasks of a study's panel: the study itself, its report, and a run of a study file as document
objects."""
import FreeCAD as App

from .. import page, settings, studies, targets
from ..convert import InputProblem
from ..features import study
from ..features.study_import import Taken, problem_text
from ..runner import Task, transaction
from ..texts import QT_TRANSLATE_NOOP, translate
from .page_task import WritingTask, pdf_of
from .tasks import PlanTask


class StudyTask(PlanTask):
    """Computes the remaining runs of a study. If it is stopped, its rows are kept."""

    TITLE = QT_TRANSLATE_NOOP("SweptVolume", "Run study")
    FEATURE = study

    names = None  # names of the runs, when they are known

    def read(self):
        return self.plan.request()

    def carry_out(self, control):
        self.names = self.plan.runs()
        return super().carry_out(control)

    def make(self):
        return study.make_study(self.document)

    def apply(self, value):
        study.apply(self.obj, value, self.request, self.hash)
        self.obj.purgeTouched()
        App.Console.PrintMessage("{}: {}\n".format(self.obj.Label, self.obj.Summary))

    def fail(self, text, cancelled=False):
        if not cancelled:
            super().fail(text)
        elif self.request.rows:
            with transaction(self.document, self.title):
                if self.obj is None:
                    self.obj = self.make()
                self.plan.write(self.obj)
                study.stop(self.obj, self.names, self.request, self.hash)
                self.obj.purgeTouched()


class StudyPageTask(WritingTask):
    """Writes the page of all runs of a study."""

    def __init__(self, obj, path):
        self.title = translate("SweptVolume", "Export report")
        self.document, self.watched, self.path = obj.Document, [obj], path
        page.check_target(path)
        targets.check_not_read(path)
        self.study, self.results = study.written(obj)

    def work(self, control):
        pdf = page.is_pdf(self.path)
        page.template(pdf)  # raises if the template is faulty
        template = settings.page_template(pdf) or ("print" if pdf else "")
        given = self.study, self.results, self.path, template, control.is_cancelled
        text = studies.page(*given)
        return pdf_of(text) if pdf else text.encode("utf-8")


class TakeRunTask(Task):
    """Reads a run of a study file into the document, as one undo step: part, motion, neighbours,
    and its check or envelope, which is not computed. found: the check or envelope."""

    def __init__(self, obj, name):
        self.title = translate("SweptVolume", "Open run")
        self.document, self.watched = obj.Document, [obj]
        runs = {run.name: run for run in study.Plan.of(obj).study().runs}
        if name not in runs:
            raise InputProblem(problem_text(name))
        self.run, self.found = runs[name], None

    def work(self, control):
        return Taken(self.run)

    def finish(self, value):
        self.found = value.put(self.document)
        self.document.recompute()
