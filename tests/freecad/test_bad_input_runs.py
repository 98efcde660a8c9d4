# SPDX-License-Identifier: LGPL-2.1-or-later
"""The rows of docs/bad_input.md about motions, options, devices and files that a user of FreeCAD can reach.
"""
import contextlib
import os
import subprocess
import sys
import threading

from bad_case import BadCase
from case import shift, turn
from sweptvolume import core, export
from sweptvolume.convert import InputProblem
from sweptvolume.features import envelope, motion, solid

#: A document with a moving box, in a separate process; `run` is code that uses the envelope.
SCRIPT = """
import sys
for folder in {folders!r}: sys.path.append(folder)
import FreeCAD as App
import resource
from sweptvolume import core
from sweptvolume.features import envelope, motion
doc = App.newDocument()
box = doc.addObject("Part::Box", "Box")
ends = [App.Placement(App.Vector(x, 0, 0), App.Rotation()) for x in (0, 30)]
path = motion.motion_from_poses(doc, [0, 1], ends)
obj = envelope.make_envelope(doc, [box], path, Resolution=40)
doc.recompute()
def compute():
    try:
        envelope.compute(obj)
        return "Ok"
    except core.CoreError as error:
        return error.status + "/" + error.code + ": " + str(error)
{run}
"""


class BadRuns(BadCase):
    def in_a_process(self, run, **environment):
        folders = [p for p in sys.path if "freecad" in p.lower()]
        done = subprocess.run(
            [sys.executable, "-c", SCRIPT.format(folders=folders, run=run)],
            env={**os.environ, **environment},
            capture_output=True,
            text=True,
            timeout=120,
        )
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        return done.stdout

    def motion_of(self, *rows):
        return motion.motion_from_file(self.doc, self.file("m.csv", "\n".join(rows) + "\n"), "mm")

    def test_bad_input_16_cell(self):
        obj = self.envelope([self.box()], self.line(), Resolution=1)
        self.refused(obj, "the resolution is 1", "allowed: 4 to 16384")

    def test_bad_input_18_one_pose(self):
        still = motion.motion_from_poses(self.doc, [0], [shift()])
        obj = self.accepted(self.box(), still)
        self.assertAlmostEqual(obj.Volume.Value, 1000, delta=0.05 * 600 * obj.UsedCellSize.Value)

    def test_bad_input_20_small_drift(self):
        path = self.motion_of("0,0,0,0,0,0,0,1", "1,30,0,0,0,0,0,1.00002")
        self.accepted(self.box(), path)

    def test_bad_input_21_not_rigid(self):
        before = len(self.doc.Objects)
        matrix = "1 0 0 {} 0 1 0 0 0 0 {} 0 0 0 0 1"
        for rows, words in (
            (("0,0,0,0,0,0,0,1", "1,30,0,0,0,0,0,1.1"), "line 2.*length 1.1"),
            ((matrix.format(0, 1), matrix.format(30, -1)), "line 2.*mirror"),
            ((matrix.format(0, 1), matrix.format(30, 2)), "line 2.*scale"),
        ):
            with self.assertRaisesRegex((core.CoreError, InputProblem), words):
                self.motion_of(*rows)
        self.assertEqual(len(self.doc.Objects), before)

    def test_bad_input_22_bad_pose(self):
        before = len(self.doc.Objects)
        with self.assertRaisesRegex((core.CoreError, InputProblem), "Pose 2.*must not decrease"):
            self.motion_of("1,0,0,0,0,0,0,1", "0,30,0,0,0,0,0,1")
        self.assertEqual(len(self.doc.Objects), before)

    def test_bad_input_25_cancel_before_and_after(self):
        obj = self.envelope([self.box()], self.line())
        control = core.Control()
        control.cancel()
        control.cancel()
        with self.assertRaises(core.CoreError) as caught:
            envelope.compute(obj, control)
        self.assertEqual((caught.exception.status, obj.Status), ("Cancelled", envelope.CANCELLED))
        control = core.Control()
        envelope.compute(obj, control)
        control.cancel()
        self.assertEqual(obj.Status, envelope.UP_TO_DATE)

    def test_bad_input_26_memory_budget(self):
        obj = self.envelope([self.box()], self.line(), Resolution=4000)
        control = core.Control()
        control.context = core.module().RunContext(1, 1)  # 1 MB
        with self.assertRaises(core.CoreError) as caught:
            envelope.compute(obj, control)
        self.assertEqual(caught.exception.status, "ResourceLimit")
        self.assertIn("smallest cell", obj.Message)
        self.assertEqual((obj.Status, obj.Mesh.CountFacets), (envelope.FAILED, 0))

    def test_bad_input_27_out_of_memory(self):
        output = self.in_a_process(
            """
compute()
control = core.Control()
control.context = core.module().RunContext(1, 100000)  # the estimate is not to refuse it
page = resource.getpagesize()
used = int(open("/proc/self/statm").read().split()[0]) * page
resource.setrlimit(resource.RLIMIT_AS, (used + (60 << 20), resource.RLIM_INFINITY))
obj.Resolution = 2000
facets = obj.Mesh.CountFacets
try:
    envelope.compute(obj, control)
except core.CoreError as error:
    print(error.status, obj.Status, facets == obj.Mesh.CountFacets)
resource.setrlimit(resource.RLIMIT_AS, (resource.RLIM_INFINITY, resource.RLIM_INFINITY))
obj.Resolution = 48
print(compute())
"""
        )
        self.assertIn("OutOfMemory Failed True\nOk", output)

    def test_bad_input_28_no_gpu(self):
        output = self.in_a_process(
            """
obj.Backend = "GPU"
print(compute(), obj.Status)
obj.Backend = "Auto"
print(compute(), obj.Status)
""",
            __EGL_VENDOR_LIBRARY_FILENAMES="/nowhere.json",
        )
        gpu, auto = output.strip().split("\n")[-2:]
        self.assertRegex(gpu, "^DeviceUnavailable/.*EGL.* Failed$")
        self.assertEqual(auto, "Ok Up to date")

    def test_bad_input_29_software_only(self):
        output = self.in_a_process(
            """
import json
obj.Backend = "GPU"
print(compute())
print(json.loads(obj.Report)["device"] if obj.Report else "")
obj.Backend = "Auto"
print(compute(), json.loads(obj.Report)["backend"])
""",
            LIBGL_ALWAYS_SOFTWARE="1",
        )
        gpu, device, auto = output.strip().split("\n")[-3:]
        if gpu.startswith("DeviceUnavailable"):
            self.skipTest("no software rasteriser: " + gpu)
        self.assertEqual(gpu, "Ok")
        self.assertIn("llvmpipe", device)
        self.assertEqual(auto, "Ok cpu")

    def test_bad_input_35_empty_table(self):
        for text in ("", "t,tx,ty,tz,qx,qy,qz,qw\n", "# nothing\n\n"):
            before = len(self.doc.Objects)
            with self.assertRaisesRegex((core.CoreError, InputProblem), "pose|row"):
                motion.motion_from_file(self.doc, self.file("m.csv", text), "mm")
            self.assertEqual(len(self.doc.Objects), before)

    def computed(self):
        obj = self.envelope([self.box()], self.line())
        envelope.compute(obj)
        return obj

    def test_bad_input_36_full_disk_leaves_the_old_file(self):
        output = self.in_a_process(
            """
import os, signal, tempfile
from sweptvolume import export
compute()
with tempfile.TemporaryDirectory() as folder:
    for name in ("o.ply", "o.step"):
        target = os.path.join(folder, name)
        open(target, "w").write("old")
        signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
        request = export.request(obj)
        resource.setrlimit(resource.RLIMIT_FSIZE, (2000, resource.RLIM_INFINITY))
        try:
            export.write(request, target)
        except core.CoreError as error:
            print(error.status, open(target).read())
        try:
            export.request(obj)
        except ValueError as error:
            print(type(error).__name__, "delete files there" in str(error))
        resource.setrlimit(resource.RLIMIT_FSIZE, (resource.RLIM_INFINITY,) * 2)
    print(sorted(os.listdir(folder)))
"""
        )
        expected = "ExportFailed old\nInputProblem True\n" * 2 + "['o.ply', 'o.step']"
        self.assertIn(expected, output)

    def test_bad_input_37_solid_that_reads_back_wrong(self):
        """The file is damaged between writing and reading back. It must not replace the target."""
        path = motion.motion_from_poses(self.doc, [0, 1], [shift(), turn(50, base=shift(9).Base)])
        obj = self.envelope([self.box()], path)
        envelope.compute(obj)
        target = self.file("o.step", "old")
        done = threading.Event()

        def damage():
            while not done.is_set():
                for name in os.listdir(self.folder):
                    with contextlib.suppress(FileNotFoundError):  # it may go at any moment
                        other = os.path.join(self.folder, name)
                        if other != target and os.path.getsize(other) > 100:
                            with open(other, "r+b") as file:
                                file.write(b"garbage")

        thread = threading.Thread(target=damage)
        thread.start()
        try:
            with self.assertRaises(core.CoreError) as caught:
                export.write(solid.request_for(obj, merge=False, max_faces=10**6), target)
        finally:
            done.set()
            thread.join()
        self.assertEqual(caught.exception.status, "ExportFailed")
        self.assertTrue(caught.exception.code.startswith("Reread"), caught.exception)
        with open(target) as file:
            self.assertEqual(file.read(), "old")
        self.assertEqual(os.listdir(self.folder), ["o.step"])

    def test_bad_input_39_too_many_faces(self):
        path = motion.motion_from_poses(self.doc, [0, 1], [shift(), turn(90)])
        obj = self.envelope([self.box()], path)
        envelope.compute(obj)
        target = os.path.join(self.folder, "o.step")
        request = solid.request_for(obj, max_faces=5, tolerance=0.001)
        with self.assertRaisesRegex(core.CoreError, r"faces.* 5 faces.*STL"):
            export.write(request, target)
        self.assertEqual(os.listdir(self.folder), [])

    def test_bad_input_40_names(self):
        folder = os.path.join(self.folder, "Hüllkörper 扫掠 (1)", "x" * 120)
        os.makedirs(folder)
        table = os.path.join(folder, "pohyb ž.csv")
        with open(table, "w") as file:
            file.write("0,0,0,0,0,0,0,1\n1,30,0,0,0,0,0,1\n")
        path = motion.motion_from_file(self.doc, table, "mm")
        box = self.box()
        box.Label = "Těleso 体"
        obj = self.envelope([box], path)
        obj.Label = "Obálka 扫"
        envelope.compute(obj)
        for name in ("obálka ž.stl", "obálka ž.step"):
            export.write(export.request(obj), os.path.join(folder, name))
        self.doc.saveAs(os.path.join(folder, "doklad č.FCStd"))
        self.assertEqual(len([n for n in os.listdir(folder) if n.startswith("ob")]), 2)

    def test_bad_input_42_two_runs_at_once(self):
        first = self.envelope([self.box()], self.line())
        second = self.envelope([self.box("Other", 7)], self.line(20))
        requests = [envelope.Plan.of(obj).requests() for obj in (first, second)]
        alone = [core.compute(r[0], core.Control()).vertices.tobytes() for r in requests]
        found = [None, None]

        def work(n):
            found[n] = core.compute(requests[n][0], core.Control()).vertices.tobytes()

        threads = [threading.Thread(target=work, args=(n,)) for n in (0, 1)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        self.assertEqual(found, alone)
