# SPDX-License-Identifier: LGPL-2.1-or-later
"""The long tasks of the workbench for the runner."""
import contextlib
import os
import shutil
import tempfile
import time

import FreeCAD as App

from .. import contents, core, export, quantities, targets
from ..features import clearance, envelope, mechanism, overlap_plan, shared, solid
from ..runner import Task
from ..texts import QT_TRANSLATE_NOOP, translate
from ..views import surface

#: Time (s) for which parts may be read without a pause: a third of an acceptable delay of the
#: window.
AT_ONCE = 0.015


class PlanTask(Task):
    """Carries out a plan (of FEATURE) and stores the result in an object, as one undo step. Creates
    the object if there is none yet."""

    TITLE = ""
    FEATURE = None

    def __init__(self, document, plan, obj=None):
        self.title = translate("SweptVolume", self.TITLE)
        self.document = document
        self.plan = plan
        self.obj = obj
        self.hash = ""
        contents.prepared(plan.words())
        self.request = self.read()
        self.watched = [
            o for o in plan.objects() + ([obj] if obj else []) if o.Document is document
        ]

    def read(self):
        """Returns the plan as plain values for work(). Raises InputProblem."""
        return self.plan.request()

    def make(self):
        """Creates the object if there is none yet."""
        raise NotImplementedError

    def work(self, control):
        self.hash = self.plan.hash()
        return self.carry_out(control)

    def carry_out(self, control):
        """Computes the result, in any thread."""
        return self.FEATURE.work(self.request, control)

    def finish(self, value):
        if self.obj is None:
            self.obj = self.make()
        self.plan.write(self.obj)
        if self.undoable(value):
            self.apply(value)

    def undoable(self, value):
        """Returns whether the result is part of the undo step. If not, Undo restores only the
        inputs, and the result becomes stale."""
        return True

    def after(self, value):
        if not self.undoable(value):
            surface.watch_undo()
            self.apply(value)

    def apply(self, value):
        """Writes the result into the object."""
        self.FEATURE.apply(self.obj, value, self.hash)
        self.obj.purgeTouched()
        App.Console.PrintMessage("{}: {}\n".format(self.obj.Label, self.summary(value)))

    def summary(self, value):
        """Returns one line for the report view."""
        raise NotImplementedError

    def fail(self, text, cancelled=False):
        if self.obj is not None:
            self.FEATURE.fail(self.obj, text, self.hash, cancelled)


def read_in_pieces(plan):
    """A generator for Task.steps() that returns a plan's request. The window handles events between
    its steps. Raises InputProblem, also if the document was changed meanwhile."""
    plan.words()
    pieces, began = plan.reading(), 0.0
    while True:
        if time.perf_counter() - began > AT_ONCE:
            yield 0
            began = time.perf_counter()
        try:
            next(pieces)
        except StopIteration as end:
            yield 0
            plan.check_unchanged()
            return end.value


class EnvelopeTask(PlanTask):
    """Computes an envelope."""

    TITLE = QT_TRANSLATE_NOOP("SweptVolume", "Compute envelope")
    FEATURE = envelope

    def read(self):
        self.most = surface.most_of(self.obj)
        return envelope.prepare(self.plan, self.document)

    def make(self):
        return envelope.make_envelope(self.document, [], None)

    def carry_out(self, control):
        return surface.ready(self.request(control), self.most)

    def room(self, value):
        return surface.room(self.obj, value)

    def undoable(self, value):
        return surface.undoable(value)

    def apply(self, value):
        super().apply(value)
        surface.show(self.obj, value)
        for warning in envelope.warnings_of(value.report):
            App.Console.PrintMessage("{}: {}\n".format(self.obj.Label, warning["text"]))

    def summary(self, value):
        report = value.report
        return translate("SweptVolume", "{0} triangles, {1}, {2}").format(
            quantities.count(report["triangles"]),
            quantities.volume(report["volume"]),
            quantities.seconds(report["seconds"]["total"]),
        )


class ClearanceTask(PlanTask):
    """Runs a clearance check."""

    TITLE = QT_TRANSLATE_NOOP("SweptVolume", "Check clearance")
    FEATURE = clearance

    def make(self):
        return clearance.make_clearance(self.document)

    def summary(self, value):
        return self.obj.Summary


class FirstContactsTask(Task):
    """Finds the contacts at the first pose of a check's motion. found: {(root, sub): Rule}, the
    rules that would allow them."""

    writes = False

    def __init__(self, plan):
        self.title = translate("SweptVolume", "Look for contacts")
        self.document = plan.document
        plan.rules = {}
        self.request = plan.request()
        self.watched = [o for o in plan.objects() if o.Document is plan.document]
        self.found = {}

    def work(self, control):
        return clearance.offered(self.request, control)

    def finish(self, value):
        self.found = clearance.contacts_from(self.request, value)


class MechanismTask(PlanTask):
    """Runs a mechanism check."""

    TITLE = QT_TRANSLATE_NOOP("SweptVolume", "Check mechanism")
    FEATURE = mechanism

    def read(self):
        return None  # steps() has read the plan

    def steps(self, control):
        self.request = yield from read_in_pieces(self.plan)

    def make(self):
        return mechanism.make_mechanism(self.document)

    def summary(self, value):
        return self.obj.Summary


class SharedTask(PlanTask):
    """Computes a shared volume."""

    TITLE = QT_TRANSLATE_NOOP("SweptVolume", "Shared volume")
    FEATURE = shared

    def make(self):
        return shared.make_shared(self.document, label=" & ".join(self.plan.names()))

    def summary(self, value):
        return quantities.volume(value.row["volume"])


class OverlapTask(Task):
    """Compares parts that stand still. found: (report, the drawing of each pair's shared volume, or
    None)."""

    writes = False

    def __init__(self, plan):
        self.title, self.document = translate("SweptVolume", "Check reserved spaces"), plan.document
        self.plan, self.request, self.found = plan, plan.request(), None
        self.watched = [root for root, _ in plan.pairs]

    def work(self, control):
        report, meshes = overlap_plan.work(self.request, control)
        return report, [surface.drawn(*mesh) if len(mesh[1]) else None for mesh in meshes]

    def finish(self, found):
        self.found = found


class PairContactsTask(Task):
    """Finds the contacts at the beginning of the common time of a mechanism. found: {key of
    pair_rules: Rule}, the rules that would allow them."""

    writes = False

    def __init__(self, plan):
        self.title = translate("SweptVolume", "Look for contacts")
        self.document, self.found, self.plan, self.request = plan.document, {}, plan, None
        contents.prepared(plan.words())
        self.watched = [o for o in plan.objects() if o.Document is plan.document]

    def steps(self, control):
        self.request = yield from read_in_pieces(self.plan)

    def work(self, control):
        return mechanism.offered(self.request, control)

    def finish(self, value):
        self.found = value


class ShapesTask(Task):
    """Prepares the moving parts of a mechanism for drawing. found: for each part (result of
    surface.drawn(), whether it is solid, function that returns the placement at a time)."""

    writes = False

    def __init__(self, plan, most):
        self.title, self.document = translate("SweptVolume", "Read parts"), plan.document
        self.most, self.found = most, []
        self.parts = plan.seen()

    def work(self, control):
        found = []
        for body, course in self.parts:
            if control.is_cancelled():
                raise core.cancelled()
            arrays = body.vertices, body.triangles
            found.append((surface.drawn(*arrays, self.most), surface.is_solid(*arrays), course))
        return found

    def finish(self, value):
        self.found = value


def print_note(report, label):
    """Prints the core's note about what it gave up to get a valid solid."""
    if report.get("note"):
        App.Console.PrintMessage("{}: {}\n".format(label, report["note"]))


class SolidTask(Task):
    """Converts an envelope to a solid, as one undo step. Creates the object if there is none yet.

    settings: as in features.solid.DEFAULTS; if None, the settings of the object."""

    def __init__(self, document, source=None, obj=None, settings=None):
        self.title = translate("SweptVolume", "Make solid")
        self.document = document
        self.obj = obj
        self.source = source or obj.Source
        self.settings = settings or (solid.settings(obj) if obj else solid.DEFAULTS)
        self.request = solid.request_for(self.source, **self.settings)
        self.hash = ""
        self.words = contents.prepared(solid.words_of(self.source, self.settings))
        self.watched = [self.source] + ([obj] if obj else [])

    def work(self, control):
        self.hash = solid.hash_of(self.words)
        return solid.work(self.request, control)

    def drop(self, value):
        with contextlib.suppress(FileNotFoundError):
            os.remove(value[0])

    def finish(self, value):
        if self.obj is None:
            self.obj = solid.make_solid(self.document, self.source)
        solid.set_settings(self.obj, self.settings)
        solid.apply(self.obj, value, self.hash)
        print_note(value[1], self.obj.Label)
        self.obj.purgeTouched()
        if self.source.ViewObject is not None:
            self.source.ViewObject.Visibility = False

    def fail(self, text, cancelled=False):
        if self.obj is not None:
            solid.fail(self.obj, text, self.hash, cancelled)


class ExportTask(Task):
    """Writes an envelope to a file; the document does not change. The file is written in a
    temporary folder beside the target and then moved, so a stopped run leaves no file."""

    def __init__(self, source, path, settings=None):
        self.title = translate("SweptVolume", "Export envelope")
        self.document = source.Document
        self.watched = [source]
        self.path = path
        export.check_target(path)
        targets.check_not_read(path)
        self.request = export.request(source, settings)

    def work(self, control):
        folder = tempfile.mkdtemp(prefix=".", dir=os.path.dirname(os.path.abspath(self.path)))
        beside = os.path.join(folder, os.path.basename(self.path))
        try:
            return dict(export.write(self.request, beside, control), beside=beside)
        except BaseException:
            shutil.rmtree(folder, ignore_errors=True)
            raise

    def drop(self, value):
        shutil.rmtree(os.path.dirname(value["beside"]), ignore_errors=True)

    def finish(self, value):
        if os.path.exists(self.path):
            shutil.copymode(self.path, value["beside"])
        os.replace(value["beside"], self.path)
        self.drop(value)
        print_note(value, self.path)
        App.Console.PrintMessage(
            translate("SweptVolume", "Written: {0} ({1})\n").format(
                self.path, quantities.megabytes(os.path.getsize(self.path))
            )
        )
