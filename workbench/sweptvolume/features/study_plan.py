# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a study runs, read off its object or a panel: the runs of a study file, or envelopes and clearance
checks of the document."""
import contextlib
import hashlib
import json
import os

from .. import contents, convert
from ..convert import InputProblem
from ..texts import translate
from . import clearance, clearance_plan, envelope, envelope_plan, missing, status, study_export
from .base import kind_of, set_changed


def _plan_of(source):
    """Raises InputProblem for what is no run of a study."""
    if clearance.is_clearance(source):
        return clearance_plan.Plan.of(source)
    if envelope.is_envelope(source):
        return envelope_plan.Plan.of(source)
    text = translate(
        "Messages",
        '"{0}" cannot be a run of a study: choose envelopes, or clearance checks with one motion.',
    )
    raise InputProblem(text.format(source.Label))


def names_of(sources):
    """Names of runs, which are names of folders: the labels, with a number where one is there twice."""
    names = (study_export.file_name(source.Label) for source in sources)
    return study_export.numbered(names, same=str.casefold)


class Request:
    """What one study computes, no document behind it: file and folder ("": that of the file), and the runs
    that are written into the file first (None: it is there). labels: Plan.labels()."""

    def __init__(self, file, output, jobs, runs, look, labels):
        self.file, self.output, self.jobs, self.runs, self.look = file, output, jobs, runs, look
        self.labels = labels
        self.rows = {}  # name of a run -> its row, as they end

    def prepare(self, control):
        """Any thread: writes the study file. Raises InputProblem, core.CoreError, OSError."""
        if self.runs is not None:
            study_export.write(self.file, self.runs, self.look, control)
        elif not self.output:
            from .. import studies

            self.output = str(studies.read(self.file).output)


class Plan:
    """Reads documents only in the thread of the GUI."""

    def __init__(self, document, file="", sources=(), folder="", jobs=0):
        self.document, self.file, self.sources = document, file, list(sources)
        self.folder, self.jobs = folder, max(0, int(jobs))
        self.lost = ""
        self._plans, self._names, self._words, self._study = None, None, None, None

    @classmethod
    def of(cls, obj):
        plan = cls(obj.Document, obj.File, obj.Sources, obj.Folder, obj.Jobs)
        plan.lost = missing.text(obj)
        return plan

    def write(self, obj):
        """Puts the plan into an object."""
        missing.forget(obj)
        for name in ("File", "Sources", "Folder", "Jobs"):
            set_changed(obj, name, getattr(self, name.lower()))

    def objects(self):
        """Document objects that a run needs to its end."""
        return list(self.sources)

    def waits(self):
        """Whether what a run is made of is itself stale: a motion. Results of the sources do not count, since
        the study computes its own."""
        with contextlib.suppress(InputProblem):
            inputs = [obj for plan in self._read()[0] for obj in plan.objects()]
            return any(status.is_behind(obj) for obj in inputs if not envelope.is_envelope(obj))
        return False

    # --- runs

    def place(self):
        """(study file, folder for results; "" for that of the file). Raises InputProblem."""
        if self.lost:
            raise InputProblem(self.lost)
        if not self.sources:
            if not self.file:
                text = translate(
                    "Messages",
                    "The study has no runs: choose a study file, or envelopes and "
                    "clearance checks.",
                )
                raise InputProblem(text)
            return self.file, self.folder
        folder = self.folder
        if not folder:
            path = self.document.FileName
            if not path:
                text = translate(
                    "Messages",
                    "There is no folder for the results: save the document first, or "
                    "choose a folder.",
                )
                raise InputProblem(text)
            folder = os.path.splitext(path)[0] + "-study"
        return os.path.join(folder, "study.toml"), os.path.join(folder, "results")

    def runs(self):
        """Names of the runs. Raises InputProblem, core.CoreError, core.CoreMissing."""
        self.place()
        return self._read()[1] if self.sources else [run.name for run in self.study().runs]

    def study(self):
        """The study file as it was when this was first asked (studies.read()); raises as that does."""
        if self._study is None:
            from .. import studies  # brings what starts processes: not at FreeCAD's start

            self._study = studies.read(*self.place())
        return self._study

    def source_of(self, name):
        """The object behind a run; None where it comes from a file."""
        return dict(zip(self._read()[1], self.sources)).get(name)

    # --- what the result depends on

    def _read(self):
        """Plans of the sources, and names of their runs, as they were when this was first asked."""
        if self._plans is None:
            self._plans = [_plan_of(source) for source in self.sources]
            self._names = names_of(self.sources)
        return self._plans, self._names

    def words(self):
        """As clearance_plan.Plan.words()."""
        if self._words is None:
            self.place()  # says what is missing
            self._words = [word for plan in self._read()[0] for word in plan.words()]
        return self._words

    def checked_hash(self):
        """As clearance_plan.Plan.checked_hash(). Files count by their sizes and the times of their last
        change: their bytes are the business of the run, which computes only what is new."""
        if self.sources:
            plans, names = self._read()
            found = [plan.checked_hash() for plan in plans] + names
        else:
            try:
                found = _stamps(self.study())
            except OSError as problem:  # gone meanwhile
                raise InputProblem(str(problem)) from None
        return status.VERSION + contents.short([json.dumps(found)])

    def labels(self):
        """What parts, motions and neighbours are called: rows and pages tell of them by these names. None of
        a study file. Raises InputProblem."""
        found = []
        for plan in self._read()[0] if self.sources else []:
            beside = plan.leaves() if isinstance(plan, clearance_plan.Plan) else []
            found += [convert.label_of(*pair) for pair in plan.pairs + beside]
            motions = [plan.motion] + getattr(plan, "motions", [])
            found += [motion.Label for motion in motions if motion is not None]
        return found

    def hash(self):
        """As clearance_plan.Plan.hash()."""
        return status.hash_or_problem(self.checked_hash)[0]

    def request(self):
        """Raises InputProblem, core.CoreError, core.CoreMissing."""
        path, output = self.place()
        if not self.sources:
            return Request(path, output, self.jobs, None, None, [])
        plans, names = self._read()
        runs = [
            study_export.run_of(name, source, plan)
            for name, source, plan in zip(names, self.sources, plans)
        ]
        look = study_export.Look.now(self.document.Label)
        return Request(path, output, self.jobs, runs, look, self.labels())


def _stamps(study):
    """Text of a study file, and what tells a change of the files that it names."""
    with open(study.file, "rb") as file:
        stamps = [hashlib.sha256(file.read()).hexdigest(), study.template]
    for name in sorted({file for run in study.runs for file in run.files()}):
        about = os.stat(name)
        stamps.append([os.path.relpath(name, study.file.parent), about.st_size, about.st_mtime_ns])
    return stamps


def can_run(obj):
    """Whether an object may be a run."""
    return kind_of(obj) in (clearance.Clearance.KIND, envelope.Envelope.KIND)
