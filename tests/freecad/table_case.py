# SPDX-License-Identifier: LGPL-2.1-or-later
"""Shared by the tests that change every input of a feature in every way, and check the state of the result
after each change.
"""
import os
import shutil

import FreeCAD as App

from case import Case, shift
from sweptvolume import core
from sweptvolume.convert import InputProblem
from sweptvolume.features import clearance, envelope, made_by, mechanism, sequence, shared, solid
from sweptvolume.features import study
from sweptvolume.features.base import FAILED, STALE, UP_TO_DATE, kind_of


def changes(known=()):
    """Returns ({name: function that changes the document}, the decorator that adds such a function).
    The dict begins with the given changes."""
    known = dict(known)

    def change(action):
        known[action.__name__] = action
        return action

    return known, change


def rows(case):
    """Makes a test for each change."""
    for name in case.CHANGES:
        setattr(case, "test_" + name, lambda self, name=name: self.changed(name))
    return case


def add_box(doc, name, place):
    """Returns a new box of FreeCAD's default size (10 mm)."""
    obj = doc.addObject("Part::Box", name)
    obj.Placement = place
    return obj


def hidden_link(doc, name, linked):
    """Returns a hidden link at the placement of its object, for a change to use. FreeCAD 1.0
    crashes if a document is closed after the creation of a link was undone, so changes create
    none."""
    link = doc.addObject("App::Link", name)
    link.LinkedObject, link.Placement = linked, linked.Placement
    link.Visibility = False
    return link


def put_into(group, obj, place=shift(0, 3)):
    """Puts an object into a moved group, so that the object is at another position."""
    group.Placement = place
    group.addObject(obj)


class Table(Case):
    """Checks the state after each change and after its undo: a result may be up to date only if a fresh
    computation, in a copy of the document, gives the same. Subclasses provide the document, and rows()
    their tests."""

    NEEDS_CORE = True
    #: name -> what a user does to the document.
    CHANGES = {}

    def results(self):
        return [o for o in self.doc.Objects if kind_of(o) and "InputHash" in o.PropertiesList]

    def content(self, obj):
        """Returns what a result shows to users, as numbers; None if a run is refused."""
        if kind_of(obj) == clearance.Clearance.KIND:
            rows = clearance.report_of(obj)["neighbours"]
            return [obj.RequiredDistance.Value] + sorted(
                (round(row["distance"], 5), row["time_seconds"]) for row in rows
            )
        if kind_of(obj) == mechanism.Mechanism.KIND:
            pairs = mechanism.report_of(obj)["pairs"]
            found = [(p["first"], p["second"], p["required"], p["clearance"]) for p in pairs]
            return [obj.RequiredDistance.Value, obj.Checked] + sorted(
                (*names, round(row["distance"], 5), row["verdict"]) for *names, row in found
            )
        if kind_of(obj) == sequence.Sequence.KIND:
            report = sequence.report_of(obj)
            rows = [
                (s["part"], s["verdict"], s.get("begin"), s.get("end")) for s in report["steps"]
            ]
            return [
                obj.RequiredDistance.Value,
                report["verdict"],
                round(obj.Smallest.Value, 5),
                rows,
            ]
        if kind_of(obj) == study.Study.KIND:
            keys = ("run", "state", "neighbour", "verdict", "distance", "time_seconds", "volume")
            return [[row.get(key) for key in keys] for row in study.report_of(obj)["runs"]]
        place = obj.getGlobalPlacement()
        box = (obj.Mesh if hasattr(obj, "Mesh") else obj.Shape).copy().BoundBox
        numbers = (place.Base.x, place.Base.y, place.Base.z, place.Rotation.Angle)
        numbers += (box.XMin, box.YMin, box.ZMin, box.XMax, box.YMax, box.ZMax, obj.Volume.Value)
        texts = [obj.Message]
        if kind_of(obj) == envelope.Envelope.KIND:
            numbers += (obj.Triangles, obj.Shells)
            numbers += (obj.UsedCellSize.Value, obj.AccuracyBound.Value)
            texts += self.record(obj)
        if kind_of(obj) == solid.Solid.KIND:
            numbers += (obj.Deviation.Value, obj.EdgeTolerance.Value, len(obj.Shape.Faces))
        return [round(n, 4) + 0.0 for n in numbers] + texts

    def record(self, obj):
        """Returns what the record of an envelope says about some of its triangles, if it must have one."""
        record = made_by.find(obj) if obj.MadeBy != "Off" else None
        answers = map(record.answer, range(0, len(record.kind), 40)) if record else []
        return [made_by.text_of(answer) for answer in answers if answer is not None]

    def modules(self):
        """Maps the kind of a result to the module that computes it."""
        return {
            envelope.Envelope.KIND: envelope,
            solid.Solid.KIND: solid,
            clearance.Clearance.KIND: clearance,
            mechanism.Mechanism.KIND: mechanism,
            sequence.Sequence.KIND: sequence,
            shared.Shared.KIND: shared,
            study.Study.KIND: study,
        }

    def fresh(self):
        """Returns {name: content} for the document computed again as it is now. The value is None for a
        refused input. It is a code if only a run finds the fault; before that run, the state is stale.
        """
        path = os.path.join(self.folder, "fresh.FCStd")
        self.doc.saveCopy(path)
        kept, self.doc = self.doc, App.openDocument(path)
        try:
            self.doc.recompute(None, True)
            found = {}
            for obj in self.results():
                try:
                    self.modules()[kind_of(obj)].compute(obj)
                    found[obj.Name] = self.content(obj)
                except InputProblem:
                    found[obj.Name] = None
                except core.CoreError as error:
                    found[obj.Name] = error.code
            return found
        finally:
            App.closeDocument(self.doc.Name)
            self.doc = kept
            os.remove(path)
            shutil.rmtree(path + "1", ignore_errors=True)

    def check_states(self, name):
        fresh = self.fresh()
        for obj in self.results():
            with self.subTest(change=name, result=obj.Name, status=obj.Status):
                anew = fresh[obj.Name]
                if obj.Status == UP_TO_DATE:
                    self.assertEqual(self.content(obj), anew)
                else:
                    self.assertEqual(obj.Status, STALE if anew is not None else FAILED)
                    if obj.Status == FAILED:
                        self.assertTrue(obj.Message)

    def changed(self, name):
        """Makes a change, and undoes it."""
        shown = {obj.Name: obj.Visibility for obj in self.doc.Objects}
        self.doc.openTransaction(name)
        self.CHANGES[name](self.doc)
        self.doc.commitTransaction()
        self.doc.recompute()
        self.check_states(name)
        if self.doc.UndoNames[0] == name:  # changes of visibility alone are not recorded
            self.doc.undo()
        # FreeCAD's Undo changes neither the visibility of objects nor values set by an expression.
        for obj in self.doc.Objects:
            obj.Visibility = shown[obj.Name]
        self.doc.recompute()
        self.check_states(name + ", undone")
        if "expression" not in name:
            self.assertEqual(
                {o.Name: o.Status for o in self.results() if o.Status != UP_TO_DATE}, {}
            )
