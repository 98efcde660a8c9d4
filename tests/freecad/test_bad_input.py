# SPDX-License-Identifier: LGPL-2.1-or-later
"""The rows of docs/bad_input.md that a user of FreeCAD can reach."""
import os
import subprocess
import sys
import tempfile
import zipfile
from unittest import mock

import FreeCAD as App
import numpy as np
import Part

from bad_case import BadCase
from case import shift, turn
from sweptvolume import __version__, core, export, runner
from sweptvolume.convert import InputProblem
from sweptvolume.features import envelope, motion, solid
from sweptvolume.panels import tasks


class FailingTask(runner.Task):
    """Adds an object. Raises an error in the method with the name `method`. For "fail", work() also
    raises one, so that fail() is called."""

    title = "Failing"

    def __init__(self, document, method):
        self.document = document
        self.method = method

    def at(self, method):
        if self.method == method:
            raise RuntimeError("fault planted in " + method)

    def work(self, control):
        self.at("work")
        if self.method == "fail":
            raise RuntimeError("what fail() is told")

    def room(self, value):
        self.at("room")
        return 0

    def finish(self, value):
        self.document.addObject("App::FeaturePython", "Made")
        self.at("finish")

    def fail(self, text, cancelled=False):
        self.at("fail")


class BadInput(BadCase):
    def test_bad_input_01_empty_mesh(self):
        self.refused(self.envelope([self.mesh_object([])], self.line()), "has no faces")

    def test_bad_input_06_open_mesh(self):
        part = self.mesh_object(self.box_facets()[2:])
        still = motion.motion_from_poses(self.doc, [0], [shift()])
        self.refused(self.envelope([part], still), "open", "close the gaps")

    def test_bad_input_11_duplicate_faces(self):
        facets = self.box_facets()
        obj = self.envelope([self.mesh_object(facets + facets[:2])], self.line())
        envelope.compute(obj)
        self.assertEqual(obj.Status, envelope.UP_TO_DATE)
        self.assertIn("same corners", obj.Message)

    def test_bad_input_15_cell_against_body(self):
        obj = self.envelope([self.box()], self.line(), CellSize=1000)
        self.refused(obj, "mm")
        obj.CellSize = 1e-5
        self.refused(obj, "smallest cell that fits")

    def test_bad_input_17_no_poses(self):
        self.refused(self.envelope([self.box()], motion.make_motion(self.doc)), "no poses")

    def test_bad_input_19_repeated_poses(self):
        path = motion.motion_from_poses(self.doc, [0, 1, 2], [shift(), shift(), shift(9)])
        obj = self.envelope([self.box()], path)
        envelope.compute(obj)
        self.assertIn("same placement", obj.Message)

    def test_bad_input_23_half_turn(self):
        path = motion.motion_from_poses(self.doc, [0, 1], [shift(), turn(180)])
        self.refused(self.envelope([self.box()], path), "180", "insert a pose")

    def test_bad_input_24_cancel_keeps_the_old_shape(self):
        obj = self.envelope([self.box()], self.line())
        envelope.compute(obj)
        facets = obj.Mesh.CountFacets
        control = core.Control()
        control.context._cancel_at_checkpoint(9)
        with self.assertRaises(core.CoreError):
            envelope.compute(obj, control)
        self.assertEqual((obj.Status, obj.Mesh.CountFacets), (envelope.CANCELLED, facets))
        envelope.compute(obj)
        self.assertEqual(obj.Status, envelope.UP_TO_DATE)

    def test_bad_input_34_broken_table(self):
        path = self.file("m.csv", "t,tx,ty,tz,qx,qy,qz,qw\n0,1,two,3,0,0,0,1\n")
        before = len(self.doc.Objects)
        with self.assertRaisesRegex((core.CoreError, InputProblem), "line 2, column 3"):
            motion.motion_from_file(self.doc, path, "mm")
        self.assertEqual(len(self.doc.Objects), before)

    def test_bad_input_38_targets(self):
        for name in ("a.xyz", os.path.join("no", "a.step")):
            with self.assertRaises(InputProblem):
                export.check_target(os.path.join(self.folder, name))
        self.assertEqual(os.listdir(self.folder), [])

    def test_write_protected_targets_are_named(self):
        old = self.file("old.stl", "old")
        for protected, text in ((self.folder, 'folder "{}" is'), (old, 'file "{}" is')):
            with mock.patch("os.access", lambda path, mode, known=protected: path != known):
                with self.assertRaises(InputProblem) as caught:
                    export.check_target(old)
            self.assertIn(text.format(protected) + " write-protected", str(caught.exception))

    def test_exports_of_results_that_are_not_up_to_date_say_so(self):
        """Each kind of result and each kind of file gets the same note; a result that is up to date
        gets none."""
        box = self.box()
        obj = self.envelope([box], self.line())
        envelope.compute(obj)
        body = solid.make_solid(self.doc, obj)
        solid.compute(body)
        for source in (obj, body, box):
            self.assertEqual(export.outdated_note(source), "", source.Label)
        box.Length = 7
        self.doc.recompute()
        self.assertEqual(obj.Status, envelope.STALE)
        for source in (obj, body):
            note = '"{}" is not up to date, so the file will contain the result of its last run'.format(
                source.Label
            )
            self.assertIn(note, export.outdated_note(source))
        envelope.fail(obj, "no memory", "")
        self.assertEqual(obj.Status, envelope.FAILED)
        self.assertIn("not up to date", export.outdated_note(obj))
        envelope.compute(obj)
        self.assertEqual(export.outdated_note(obj), "")

    def events(self):
        from PySide import QtCore

        return QtCore.QCoreApplication.instance() or QtCore.QCoreApplication([])

    def loop_until(self, ended, seconds=60):
        from PySide import QtCore

        application = self.events()
        clock = QtCore.QElapsedTimer()
        clock.start()
        while not ended() and clock.elapsed() < 1000 * seconds:
            application.processEvents(QtCore.QEventLoop.AllEvents, 50)
        self.assertTrue(ended(), "the run does not end")

    def running(self):
        self.application = self.events()
        ball = self.doc.addObject("Part::Sphere", "Ball")
        self.doc.recompute()
        path = motion.motion_from_poses(self.doc, [0, 1], [shift(), turn(80, base=shift(9).Base)])
        obj = self.envelope([ball], path, Resolution=500)
        run = runner.start(tasks.EnvelopeTask(self.doc, envelope.Plan.of(obj), obj))
        self.assertTrue(runner.is_running(obj))
        return obj, ball, run

    def test_bad_input_41_document_closed_during_a_run(self):
        _, _, run = self.running()
        App.closeDocument(self.doc.Name)
        self.loop_until(lambda: run.state != "running")
        self.assertEqual((run.state, runner.running()), ("cancelled", []))

    def test_bad_input_41_object_deleted_during_a_run(self):
        obj, ball, run = self.running()
        self.doc.removeObject(ball.Name)
        self.loop_until(lambda: run.state != "running")
        self.assertEqual(run.state, "cancelled")
        self.assertEqual(obj.Mesh.CountFacets, 0)

    def test_bad_input_41_input_edited_during_a_run(self):
        obj, ball, run = self.running()
        ball.Radius = 7
        self.doc.recompute()
        self.loop_until(lambda: run.state != "running")
        self.assertIn(run.state, ("ok", "cancelled"))
        self.assertNotEqual(obj.Status, envelope.UP_TO_DATE)

    def test_an_exception_anywhere_ends_a_run(self):
        self.application = self.events()
        for place in ("work", "room", "finish", "fail"):
            task, ended = FailingTask(self.doc, place), []
            run = runner.start(task)
            run.ended.connect(ended.append)
            self.loop_until(lambda: run.state != "running")
            self.assertEqual((run.state, runner.running(), len(ended)), ("failed", [], 1), place)
            self.assertIn(place, run.message)
            self.assertEqual(len(self.doc.Objects), 0, place)
        task = FailingTask(self.doc, None)
        run = runner.start(task)
        self.loop_until(lambda: run.state != "running")
        self.assertEqual((run.state, len(self.doc.Objects)), ("ok", 1))

    def saved(self):
        obj = self.envelope([self.box()], self.line())
        envelope.compute(obj)
        path = os.path.join(self.folder, "d.FCStd")
        self.doc.saveAs(path)
        return obj.Name, obj.Mesh.CountFacets, path

    def test_bad_input_43_document_without_the_module(self):
        name, facets, path = self.saved()
        home, empty = os.environ["FREECAD_USER_HOME"], tempfile.mkdtemp(dir=self.folder)
        script = f"""
import sys
for folder in {[p for p in sys.path if "freecad" in p.lower()]!r}: sys.path.append(folder)
import FreeCAD as App
from sweptvolume import core, core_search
core_search.folders = lambda: [{empty!r}]
sys.modules["_swept"] = None
doc = App.openDocument({path!r})
doc.recompute(None, True)
obj = doc.getObject({name!r})
assert obj.Mesh.CountFacets == {facets}, obj.Mesh.CountFacets
assert not core.available()
from sweptvolume.features import envelope
try:
    envelope.compute(obj)
except core.CoreMissing as error:
    assert "cmake --build build" in str(error), error
else:
    raise SystemExit("computed without the module")
assert obj.Mesh.CountFacets == {facets}
print("fine")
"""
        done = subprocess.run(
            [sys.executable, "-c", script],
            env={**os.environ, "FREECAD_USER_HOME": home},
            capture_output=True,
            text=True,
        )
        self.assertIn("fine", done.stdout, done.stdout + done.stderr)

    def test_a_core_of_another_version_is_refused_by_name(self):
        there, folder = core.module().__file__, tempfile.mkdtemp(dir=self.folder)
        with open(there, "rb") as file:
            data = file.read()
        mine, other = (b"\0%s\0" % text.encode() for text in (__version__, "9" + __version__[1:]))
        self.assertIn(mine, data)
        with open(os.path.join(folder, os.path.basename(there)), "wb") as file:
            file.write(data.replace(mine, other))
        script = f"""
import sys
for folder in {[p for p in sys.path if "freecad" in p.lower()]!r}: sys.path.append(folder)
from sweptvolume import core
for attempt in range(2):
    try:
        core.module()
    except core.CoreMissing as error:
        assert "9{__version__[1:]}" in str(error) and "has version {__version__}" in str(error), error
        print("refused")
"""
        done = subprocess.run(
            [sys.executable, "-c", script],
            env={**os.environ, "SWEPT_CORE": folder},
            capture_output=True,
            text=True,
        )
        self.assertEqual(done.stdout.count("refused"), 2, done.stdout + done.stderr)

    def test_bad_input_44_old_document_gains_properties(self):
        name, facets, path = self.saved()
        App.closeDocument(self.doc.Name)
        old = os.path.join(self.folder, "old.FCStd")
        with zipfile.ZipFile(path) as source, zipfile.ZipFile(old, "w") as target:
            for item in source.namelist():
                data = source.read(item)
                if item == "Document.xml":
                    text = data.decode()
                    for gone in ("Conservative", "MeshDeflection", "Offset"):
                        start = text.index(f'<Property name="{gone}"')
                        text = text[:start] + text[text.index("</Property>", start) + 11 :]
                    data = text.encode()
                target.writestr(item, data)
        self.doc = App.openDocument(old)
        obj = self.doc.getObject(name)
        self.assertEqual(obj.Mesh.CountFacets, facets)
        self.assertEqual((obj.Conservative, obj.Offset.Value), (False, 0))
        self.assertAlmostEqual(obj.MeshDeflection, 0.1)
        envelope.compute(obj)
        self.assertEqual(obj.Status, envelope.UP_TO_DATE)

    def test_damaged_documents_open_without_code_or_crash(self):
        """Changes bytes of the stored properties at random: the document is opened or refused, and
        nothing worse happens."""
        name, _, path = self.saved()
        App.closeDocument(self.doc.Name)
        random = np.random.default_rng(5)
        with zipfile.ZipFile(path) as source:
            items = {item: source.read(item) for item in source.namelist()}
        for n in range(12):
            broken = os.path.join(self.folder, f"b{n}.FCStd")
            data = bytearray(items["Document.xml"])
            start = data.index(b"<ObjectData")
            for at in random.integers(start, len(data), 6):
                if chr(data[at]).isalnum():
                    data[at] = random.choice(list(b"0189azAZ-."))
            with zipfile.ZipFile(broken, "w") as target:
                for item, content in items.items():
                    target.writestr(item, bytes(data) if item == "Document.xml" else content)
            try:
                doc = App.openDocument(broken)
            except Exception:  # FreeCAD's own refusal
                continue
            obj = doc.getObject(name)
            if obj is not None and getattr(obj, "Proxy", None) is not None:
                try:
                    envelope.compute(obj)
                except (core.CoreError, InputProblem, AttributeError, ValueError, KeyError):
                    pass
            App.closeDocument(doc.Name)

    def test_shape_without_volume(self):
        part = self.doc.addObject("Part::Feature", "Wire")
        part.Shape = Part.makeLine((0, 0, 0), (1, 2, 3))
        self.refused(self.envelope([part], self.line()), "Wire")
