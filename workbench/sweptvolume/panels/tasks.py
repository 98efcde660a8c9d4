# SPDX-License-Identifier: LGPL-2.1-or-later
"""The long tasks of the workbench as the runner takes them."""
import os

import FreeCAD as App

from .. import core, export
from ..features import clearance, envelope, solid
from ..runner import Task
from ..texts import translate


class EnvelopeTask(Task):
    """Computes an envelope; makes the object if there is none yet. One undo step."""

    def __init__(self, document, plan, obj=None):
        self.title = translate("Messages", "Compute envelope")
        self.document = document
        self.plan = plan
        self.obj = obj
        self.hash = plan.hash()
        self.request = plan.request()
        self.watched = [root for root, _ in plan.pairs] + [plan.motion] + ([obj] if obj else [])
        self.watched = [o for o in self.watched if o.Document is document]

    def work(self, control):
        return core.compute(self.request, control)

    def finish(self, value):
        if self.obj is None:
            self.obj = envelope.make_envelope(self.document, [], None)
        self.plan.write(self.obj)
        envelope.apply(self.obj, value, self.hash)
        self.obj.purgeTouched()
        report = value.report
        App.Console.PrintMessage(
            translate("Messages", "{0}: {1} triangles, {2:.3g} mm^3, {3:.2f} s\n").format(
                self.obj.Label, report["triangles"], report["volume"], report["seconds"]["total"]
            )
        )
        for warning in report.get("warnings", []):
            App.Console.PrintWarning("{}: {}\n".format(self.obj.Label, warning["text"]))

    def fail(self, text):
        if self.obj is not None:
            envelope.fail(self.obj, text)


class SolidTask(Task):
    """Makes the solid of an envelope; makes the object if there is none yet. One undo step."""

    def __init__(self, document, source=None, obj=None):
        self.title = translate("Messages", "Make solid")
        self.document = document
        self.obj = obj
        self.source = source or obj.Source
        self.request = solid.request(obj) if obj else solid.request_for(self.source)
        self.watched = [self.source] + ([obj] if obj else [])

    def work(self, control):
        return solid.work(self.request, control)

    def finish(self, value):
        try:
            if self.obj is None:
                self.obj = solid.make_solid(self.document, self.source)
        except BaseException:
            os.remove(value[0])
            raise
        solid.apply(self.obj, value, solid.input_hash(self.obj))
        self.obj.purgeTouched()
        if self.source.ViewObject is not None:
            self.source.ViewObject.Visibility = False

    def fail(self, text):
        if self.obj is not None:
            solid.fail(self.obj, text)


class ExportTask(Task):
    """Writes an envelope to a file; the document stays as it is."""

    def __init__(self, source, path):
        self.title = translate("Messages", "Export envelope")
        self.document = source.Document
        self.watched = [source]
        self.path = path
        export.check_target(path)
        self.request = export.request(source)

    def work(self, control):
        return export.write(self.request, self.path, control)

    def finish(self, value):
        App.Console.PrintMessage(
            translate("Messages", "Written: {0} ({1:.1f} kB)\n").format(
                self.path, os.path.getsize(self.path) / 1000.0
            )
        )


class ClearanceTask(Task):
    """Checks clearances; makes the object if there is none yet. One undo step."""

    def __init__(self, document, plan, obj=None):
        self.title = translate("Messages", "Check clearance")
        self.document = document
        self.plan = plan
        self.obj = obj
        self.hash = plan.hash()
        self.request = plan.request()
        self.watched = [root for root, _ in plan.pairs] + [plan.motion] + ([obj] if obj else [])
        self.watched = [o for o in self.watched if o.Document is document]

    def work(self, control):
        return clearance.work(self.request, control)

    def finish(self, value):
        if self.obj is None:
            self.obj = clearance.make_clearance(self.document)
        self.plan.write(self.obj)
        clearance.apply(self.obj, value, self.hash)
        self.obj.purgeTouched()
        App.Console.PrintMessage("{}: {}\n".format(self.obj.Label, self.obj.Summary))

    def fail(self, text):
        if self.obj is not None:
            clearance.fail(self.obj, text)
