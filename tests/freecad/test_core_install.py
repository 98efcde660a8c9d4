# SPDX-License-Identifier: LGPL-2.1-or-later
"""Installing the core without a window: which pip command runs, and what stays unchanged after a failure.
The scenario gui/install_core.py has the rest.
"""
import os
import sys
import tempfile
import unittest
from unittest import mock

from package_index import Index, make_wheel
from sweptvolume import __version__, core, core_install, core_search, interpreter


class Sources(unittest.TestCase):
    def test_variables_come_before_files_and_the_default_is_said(self):
        listed = (
            "global.index-url='https://files.test/simple'\n:env:.index-url='https://env.test/s'\n"
        )
        self.assertEqual(core_install.sources_of(listed), ["https://env.test/s"])
        self.assertEqual(core_install.sources_of(""), [core_install.DEFAULT_INDEX])
        listed = "install.find-links='/a\\n/b'\nglobal.extra-index-url='https://x.test'\n"
        found = core_install.sources_of(listed)
        self.assertEqual(found, [core_install.DEFAULT_INDEX, "https://x.test", "/a", "/b"])
        self.assertEqual(core_install.sources_of(listed + "global.no-index='true'\n"), ["/a", "/b"])
        self.assertEqual(core_install.sources_of("global.cert='/c'\nnonsense\n=''\n"), found[:1])


class Installing(unittest.TestCase):
    """Installs from an index on this machine into a separate folder."""

    def setUp(self):
        if not core.available():
            self.skipTest("the compiled core _swept is not built")
        self.folder = os.path.join(tempfile.mkdtemp(), "packages")
        self.index = Index(tempfile.mkdtemp())
        self.build = os.path.dirname(core.module().__file__)
        self.wheel = make_wheel(self.build, __version__, self.index.folder)
        self.patched = [
            mock.patch.object(core_search, "package_folders", lambda: [self.folder]),
            mock.patch.dict(os.environ, self.index.environment(), clear=True),
        ]
        for patch in self.patched:
            patch.start()
            self.addCleanup(patch.stop)

    def installed(self, wheel=""):
        run = core_install.Installation(wheel)
        run.run()
        return run

    def there(self):
        return sorted(os.listdir(self.folder)) if os.path.isdir(self.folder) else []

    def plant_old(self):
        """Writes a core of another version, as an earlier installation leaves it."""
        os.makedirs(os.path.join(self.folder, "swept_volume-0.0.1.dist-info"))
        os.makedirs(os.path.join(self.folder, "swept_volume"))
        for name in ("_swept.cpython-00-old.so", "swept_volume/gone.py", "of_another.py"):
            with open(os.path.join(self.folder, name), "w") as file:
                file.write("old")
        return self.there()

    def test_an_older_core_is_replaced_and_nothing_else_touched(self):
        self.plant_old()
        run = self.installed()
        self.assertEqual(run.problem, "")
        self.assertTrue(run.restart, "this process has loaded a core")
        name = os.path.basename(core.module().__file__)
        info = "swept_volume-{}.dist-info".format(__version__)
        self.assertEqual(self.there(), sorted([name, "of_another.py", "swept_volume", info]))
        self.assertNotIn("gone.py", os.listdir(os.path.join(self.folder, "swept_volume")))
        self.assertFalse([path for path in self.index.requests if "numpy" in path])

    def test_the_old_core_stays_if_the_new_one_cannot_be_moved(self):
        old = self.plant_old()
        moves = []

        def refuse(source, target, move=os.replace):
            moves.append(source)
            if len(moves) == 5:  # after three old parts were moved away and a new one was moved in
                raise OSError(28, "No space left on device")
            move(source, target)

        with mock.patch.object(core_install.os, "replace", refuse):
            run = self.installed()
        self.assertIn("No space left", run.problem)
        self.assertEqual([n for n in self.there() if not n.startswith(".")], old)
        with open(os.path.join(self.folder, "_swept.cpython-00-old.so")) as file:
            self.assertEqual(file.read(), "old")

    def test_a_file_is_installed_without_the_index(self):
        self.assertEqual(self.installed(self.wheel).problem, "")
        self.assertEqual(self.index.requests, [])
        self.assertTrue(core_search.holds_core(self.folder))

    def test_a_wheel_for_another_python_is_refused(self):
        other = os.path.join(tempfile.mkdtemp(), os.path.basename(self.wheel).replace("cp3", "cp2"))
        os.rename(self.wheel, other)
        run = self.installed(other)
        self.assertIn("There is no core of version " + __version__, run.problem)
        self.assertIn("for Python " + interpreter.VERSION, run.problem)
        self.assertEqual(self.there(), [])

    def test_an_interpreter_without_pip_is_said(self):
        python = os.path.join(tempfile.mkdtemp(), "python3")
        with open(python, "w") as file:
            file.write("#!/bin/sh\necho '{0}: No module named pip' >&2\nexit 1\n".format(python))
        os.chmod(python, 0o755)
        with mock.patch.object(core_install, "_python", lambda: python):
            for problem in (self.installed().problem, str(self.failure_of(core_install.sources))):
                self.assertIn("has no pip", problem)
                self.assertIn("python3-pip", problem)

    def failure_of(self, call):
        with self.assertRaises(core_install.Failed) as caught:
            call()
        return caught.exception

    def test_an_index_that_cannot_be_reached_is_said(self):
        os.environ.update(PIP_INDEX_URL="http://127.0.0.1:9/simple", PIP_RETRIES="1")
        run = self.installed()
        self.assertIn("could not be reached", run.problem)
        self.assertEqual(self.there(), [])

    def test_an_index_that_may_belong_to_anybody_is_not_asked(self):
        del os.environ["PIP_INDEX_URL"]
        with mock.patch.object(core_install.Installation, "_run_pip") as fetched:
            problem = self.installed().problem
            self.assertEqual("not published" in problem, not core_install.PUBLISHED)
            self.assertEqual(fetched.called, core_install.PUBLISHED)
            with mock.patch.object(core_install, "PUBLISHED", True):
                self.installed()
            self.assertTrue(fetched.called)

    def test_cancelled_before_it_began(self):
        run = core_install.Installation()
        run.cancel()
        run.run()
        self.assertIn("Nothing was changed", run.problem)
        self.assertEqual((self.there(), self.index.requests), ([], []))

    def test_a_core_that_would_be_loaded_first_is_named(self):
        with mock.patch.object(core_search, "searched_first", lambda: ["/nowhere", self.build]):
            self.assertEqual(core_install.obstacle(), self.build)
        with mock.patch.object(core_search, "searched_first", lambda: ["/nowhere"]):
            self.assertEqual(core_install.obstacle(), "")

    def test_an_interpreter_outside_of_freecad_is_kept_from_freecads_modules(self):
        os.environ["PYTHONHOME"] = "/bundle"
        self.assertNotIn("PYTHONHOME", core_install._environment("/opt/other/bin/python3"))
        inside = os.path.join(os.path.realpath(sys.exec_prefix), "bin", "python3")
        self.assertEqual(core_install._environment(inside)["PYTHONHOME"], "/bundle")


if __name__ == "__main__":
    unittest.main()
