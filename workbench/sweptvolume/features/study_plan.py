# SPDX-License-Identifier: LGPL-2.1-or-later
"""Reads the runs of a study from its object or a panel: the runs in a study file, or envelopes and
clearance checks of the document."""
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
    """Returns the plan of a source. Raises InputProblem if it cannot be a run of a study."""
    if clearance.is_clearance(source):
        return clearance_plan.Plan.of(source)
    if envelope.is_envelope(source):
        return envelope_plan.Plan.of(source)
    text = translate(
        "SweptVolume",
        '"{0}" cannot be a run of a study: choose envelopes, or clearance checks with one motion.',
    )
    raise InputProblem(text.format(source.Label))


def names_of(sources):
    """Returns names of runs, which are also names of folders: the labels. Equal labels are
    numbered."""
    names = (study_export.file_name(source.Label) for source in sources)
    return study_export.numbered(names, same=str.casefold)


class Request:
    """Input of one study, independent of any document: file and folder ("": the one named in the
    file), and the runs to be written into the file first (None: the file exists). labels:
    Plan.labels()."""

    def __init__(self, file, output, jobs, runs, style, labels):
        self.file, self.output, self.jobs, self.runs, self.style = file, output, jobs, runs, style
        self.labels = labels
        self.rows = {}  # name of a run -> its row, added when the run ends

    def prepare(self, control):
        """Writes the study file, in any thread. Raises InputProblem, core.CoreError, OSError."""
        if self.runs is not None:
            study_export.write(self.file, self.runs, self.style, control)
        elif not self.output:
            from .. import studies

            self.output = str(studies.read(self.file).output)


class Plan:
    """The inputs of a study. Reads documents only in the GUI thread."""

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
        """Writes the plan into an object."""
        missing.forget(obj)
        for name in ("File", "Sources", "Folder", "Jobs"):
            set_changed(obj, name, getattr(self, name.lower()))

    def objects(self):
        """Returns the document objects that a run needs until its end."""
        return list(self.sources)

    def waits(self):
        """Returns whether an input of a run, such as a motion, is stale. Results of the sources do
        not matter, because the study computes its own."""
        with contextlib.suppress(InputProblem):
            inputs = [obj for plan in self._read()[0] for obj in plan.objects()]
            return any(status.is_behind(obj) for obj in inputs if not envelope.is_envelope(obj))
        return False

    # --- runs

    def paths(self):
        """Returns (study file, folder for results; "" for the one named in the file). Raises
        InputProblem."""
        if self.lost:
            raise InputProblem(self.lost)
        if not self.sources:
            if not self.file:
                text = translate(
                    "SweptVolume",
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
                    "SweptVolume",
                    "There is no folder for the results: save the document first, or "
                    "choose a folder.",
                )
                raise InputProblem(text)
            folder = os.path.splitext(path)[0] + "-study"
        return os.path.join(folder, "study.toml"), os.path.join(folder, "results")

    def runs(self):
        """Returns the names of the runs. Raises InputProblem, core.CoreError, core.CoreMissing."""
        self.paths()
        return self._read()[1] if self.sources else [run.name for run in self.study().runs]

    def study(self):
        """Returns the study file in its state at the first call (studies.read(), with its
        exceptions)."""
        if self._study is None:
            # Imports modules that start processes, so not at FreeCAD's start.
            from .. import studies

            self._study = studies.read(*self.paths())
        return self._study

    def source_of(self, name):
        """Returns the object of a run, or None if the run comes from a file."""
        return dict(zip(self._read()[1], self.sources)).get(name)

    # --- what the result depends on

    def _read(self):
        """Returns the plans of the sources and the names of their runs, in their state at the first
        call."""
        if self._plans is None:
            self._plans = [_plan_of(source) for source in self.sources]
            self._names = names_of(self.sources)
        return self._plans, self._names

    def words(self):
        """Returns the same as clearance_plan.Plan.words()."""
        if self._words is None:
            self.paths()  # raises InputProblem for missing inputs
            self._words = [word for plan in self._read()[0] for word in plan.words()]
        return self._words

    def checked_hash(self):
        """Returns the same as clearance_plan.Plan.checked_hash(). For a study file, the hash
        contains size and time of last change of the files that it names. The run itself compares
        the bytes of these files, and computes only runs whose inputs have changed."""
        if self.sources:
            plans, names = self._read()
            found = [plan.checked_hash() for plan in plans] + names
        else:
            try:
                found = _stamps(self.study())
            except OSError as problem:  # the file was deleted meanwhile
                raise InputProblem(str(problem)) from None
        return status.VERSION + contents.short([json.dumps(found)])

    def labels(self):
        """Returns the names of parts, motions and neighbours, for rows and pages. Empty for a study
        file. Raises InputProblem."""
        found = []
        for plan in self._read()[0] if self.sources else []:
            beside = plan.leaves() if isinstance(plan, clearance_plan.Plan) else []
            found += [convert.label_of(*pair) for pair in plan.pairs + beside]
            motions = [plan.motion] + getattr(plan, "motions", [])
            found += [motion.Label for motion in motions if motion is not None]
        return found

    def hash(self):
        """Returns the same as clearance_plan.Plan.hash()."""
        return status.hash_or_problem(self.checked_hash)[0]

    def request(self):
        """Returns the Request. Raises InputProblem, core.CoreError, core.CoreMissing."""
        path, output = self.paths()
        if not self.sources:
            return Request(path, output, self.jobs, None, None, [])
        plans, names = self._read()
        runs = [
            study_export.run_of(name, source, plan)
            for name, source, plan in zip(names, self.sources, plans)
        ]
        style = study_export.PageStyle.now(self.document.Label)
        return Request(path, output, self.jobs, runs, style, self.labels())


def _stamps(study):
    """Returns the hash of a study file, with size and time of last change of the files that it
    names."""
    with open(study.file, "rb") as file:
        stamps = [hashlib.sha256(file.read()).hexdigest(), study.template]
    for name in sorted({file for run in study.runs for file in run.files()}):
        about = os.stat(name)
        stamps.append([os.path.relpath(name, study.file.parent), about.st_size, about.st_mtime_ns])
    return stamps


def can_run(obj):
    """Returns whether an object may be a run."""
    return kind_of(obj) in (clearance.Clearance.KIND, envelope.Envelope.KIND)


def has_one_motion(obj):
    """Returns whether all parts of an envelope or check have the same motion, as a run requires."""
    motions = [motion for motion in getattr(obj, "Motions", ()) if motion]
    return len({(motion.Document.Name, motion.Name) for motion in motions}) <= 1
