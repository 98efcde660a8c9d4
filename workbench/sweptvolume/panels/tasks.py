# SPDX-License-Identifier: LGPL-2.1-or-later
"""The long tasks of the workbench as the runner takes them."""
import os

import FreeCAD as App

from .. import export
from ..features import clearance, envelope, solid
from ..runner import Task
from ..texts import mark, translate
from ..views import surface


class PlanTask(Task):
    """Carries out a plan (of FEATURE) and keeps the result in an object; makes the object if there is
    none yet. One undo step."""

    TITLE = ""
    FEATURE = None

    def __init__(self, document, plan, obj=None):
        self.title = translate("Messages", self.TITLE)
        self.document = document
        self.plan = plan
        self.obj = obj
        self.hash = plan.hash()
        self.request = self.read()
        self.watched = [
            o for o in plan.objects() + ([obj] if obj else []) if o.Document is document
        ]

    def read(self):
        """The plan as plain values for work(). Raises InputProblem."""
        return self.plan.request()

    def make(self):
        """The object, where there is none yet."""
        raise NotImplementedError

    def work(self, control):
        return self.FEATURE.work(self.request, control)

    def finish(self, value):
        if self.obj is None:
            self.obj = self.make()
        self.plan.write(self.obj)
        self.FEATURE.apply(self.obj, value, self.hash)
        self.obj.purgeTouched()
        App.Console.PrintMessage("{}: {}\n".format(self.obj.Label, self.summary(value)))

    def summary(self, value):
        """One line for the report view."""
        raise NotImplementedError

    def fail(self, text, cancelled=False):
        if self.obj is not None:
            self.FEATURE.fail(self.obj, text, self.hash, cancelled)


class EnvelopeTask(PlanTask):
    """Computes an envelope."""

    TITLE = mark("Messages", "Compute envelope")
    FEATURE = envelope

    def read(self):
        self.most = surface.most_of(self.obj)
        return envelope.prepare(self.plan, self.document)

    def make(self):
        return envelope.make_envelope(self.document, [], None)

    def work(self, control):
        return surface.ready(self.request(control), self.most)

    def room(self, value):
        return surface.room(self.obj, value)

    def finish(self, value):
        super().finish(value)
        surface.show(self.obj, value)
        for warning in envelope.warnings_of(value.report):
            App.Console.PrintWarning("{}: {}\n".format(self.obj.Label, warning["text"]))

    def summary(self, value):
        report = value.report
        return translate("Messages", "{0} triangles, {1:.3g} mm^3, {2:.2f} s").format(
            report["triangles"], report["volume"], report["seconds"]["total"]
        )


class ClearanceTask(PlanTask):
    """Checks clearances."""

    TITLE = mark("Messages", "Check clearance")
    FEATURE = clearance

    def make(self):
        return clearance.make_clearance(self.document)

    def summary(self, value):
        return self.obj.Summary


def warn_of(report, label):
    """What was given up to get a solid."""
    if report.get("note"):
        App.Console.PrintWarning("{}: {}\n".format(label, report["note"]))


class SolidTask(Task):
    """Makes the solid of an envelope; makes the object if there is none yet. One undo step.

    settings: as features.solid.DEFAULTS; else those of the object."""

    def __init__(self, document, source=None, obj=None, settings=None):
        self.title = translate("Messages", "Make solid")
        self.document = document
        self.obj = obj
        self.source = source or obj.Source
        self.settings = settings or (solid.settings(obj) if obj else solid.DEFAULTS)
        self.request = solid.request_for(self.source, **self.settings)
        self.hash = solid.checked_hash(self.source, self.settings)
        self.watched = [self.source] + ([obj] if obj else [])

    def work(self, control):
        return solid.work(self.request, control)

    def finish(self, value):
        try:
            if self.obj is None:
                self.obj = solid.make_solid(self.document, self.source)
            solid.set_settings(self.obj, self.settings)
        except BaseException:
            os.remove(value[0])
            raise
        solid.apply(self.obj, value, self.hash)
        warn_of(value[1], self.obj.Label)
        self.obj.purgeTouched()
        if self.source.ViewObject is not None:
            self.source.ViewObject.Visibility = False

    def fail(self, text, cancelled=False):
        if self.obj is not None:
            solid.fail(self.obj, text, self.hash, cancelled)


class ExportTask(Task):
    """Writes an envelope to a file; the document stays as it is."""

    def __init__(self, source, path, settings=None):
        self.title = translate("Messages", "Export envelope")
        self.document = source.Document
        self.watched = [source]
        self.path = path
        export.check_target(path)
        self.request = export.request(source, settings)

    def work(self, control):
        return export.write(self.request, self.path, control)

    def finish(self, value):
        warn_of(value, self.path)
        App.Console.PrintMessage(
            translate("Messages", "Written: {0} ({1:.1f} kB)\n").format(
                self.path, os.path.getsize(self.path) / 1000.0
            )
        )
