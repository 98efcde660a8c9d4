# SPDX-License-Identifier: LGPL-2.1-or-later
"""Installs the core for this user, as the Addon Manager does it: by pip, into FreeCAD's folder for
Python packages. Works without a window; a thread does the work.

pip writes into a separate folder inside the target folder. Only a complete core of the workbench's
version is moved to the target. So a cancelled or failed installation leaves everything as it was.
"""
import glob
import importlib
import os
import re
import shutil
import subprocess
import sys
import tempfile
import threading
import zipfile

import FreeCAD as App

from . import __version__, core_search, interpreter
from .texts import translate

#: Name of the package on an index, and size of its largest file (MB, rounded up).
PACKAGE, SIZE = "swept-volume", 4
#: The index that pip uses unless the user has configured another.
DEFAULT_INDEX = "https://pypi.org/simple"
#: Whether the package is published on DEFAULT_INDEX. If not, the name of the package may belong to
#: anybody there.
PUBLISHED = False
#: Patterns for the files and folders of the installed package.
_PARTS = ("_swept*", "swept_volume", "swept_volume-*.dist-info")
#: Where the Addon Manager keeps the interpreter that the user has chosen for pip.
_PREFERENCES = "User parameter:BaseApp/Preferences/Addons"


class Failed(RuntimeError):
    """The core was not installed. The text says why and what to do."""


def target():
    """Returns the folder into which the core is installed."""
    return core_search.package_folders()[0]


def obstacle():
    """Returns the folder of a core that cannot be used, but that FreeCAD would load instead of an
    installed one; "" if there is none."""
    for folder in core_search.searched_first():
        if core_search.holds_core(folder):
            return folder
    return ""


def _python():
    """Returns the interpreter that runs pip. Its version does not matter, because _run_pip() names
    FreeCAD's version."""
    chosen = App.ParamGet(_PREFERENCES).GetString("PythonExecutableForPip", "")
    for path in (chosen if os.path.isfile(chosen) else "", interpreter.find()):
        if path:
            return path
    path = shutil.which("python3") or shutil.which("python")
    if path is None:
        raise Failed(
            translate("SweptVolume", "No Python interpreter was found to run pip: install Python.")
        )
    return path


def _environment(python):
    """Returns the environment variables for an interpreter. If it is not FreeCAD's own, it must not
    load FreeCAD's modules."""
    environment = dict(os.environ, PIP_DISABLE_PIP_VERSION_CHECK="1", PYTHONIOENCODING="utf-8")
    home = os.path.realpath(App.getHomePath())
    if not os.path.realpath(python).startswith((home, os.path.realpath(sys.exec_prefix))):
        for name in ("PYTHONHOME", "PYTHONPATH"):
            environment.pop(name, None)
    return environment


def sources():
    """Returns where pip looks for packages, as the user has configured it: addresses or folders.
    Asks pip, which takes a second. Raises Failed."""
    python = _python()
    done = subprocess.run(
        [python, "-m", "pip", "config", "list"],
        env=_environment(python),
        stdin=subprocess.DEVNULL,
        capture_output=True,
        encoding="utf-8",
        errors="replace",
        timeout=60,
        **interpreter.HIDDEN,
    )
    if done.returncode:
        raise Failed(_reason(python, done.stdout + done.stderr))
    return sources_of(done.stdout)


def sources_of(listed):
    """Returns the sources in the output of `pip config list`. Variables of the environment come
    before files."""
    values = {}
    for line in listed.splitlines():
        found = re.match(r"(:env:|install|global)\.([\w-]+)='(.*)'$", line.strip())
        if found and (found[2] not in values or found[1] == ":env:"):
            values[found[2]] = found[3]
    indexes = [values.get("index-url", DEFAULT_INDEX), values.get("extra-index-url", "")]
    if values.get("no-index", "").lower() in ("1", "true", "yes", "on"):
        indexes = []
    return " ".join(indexes + [values.get("find-links", "")]).replace("\\n", " ").split()


def is_unpublished_on(source):
    """Returns whether a source is the index on which the core is to be published, but is not yet."""
    return not PUBLISHED and source.rstrip("/") == DEFAULT_INDEX


def _reason(python, output):
    """Returns the reason for pip's failure, for users."""
    lines = [line.strip() for line in output.splitlines() if line.strip()]
    last = "\n".join([line for line in lines if line.startswith("ERROR")][:2] or lines[-3:])
    version = interpreter.VERSION
    if "No module named pip" in output:
        text = translate(
            "SweptVolume",
            "The interpreter {0} has no pip. Install pip (on Debian and Ubuntu: the package "
            "python3-pip), or choose another interpreter in the preferences of the Addon Manager.",
        )
        return text.format(python)
    if "connection broken" in output or "Could not fetch URL" in output:
        text = translate(
            "SweptVolume",
            "The package index could not be reached: check the network connection, or choose a "
            'package file (.whl) with the button "From a file". pip says:\n'
            "{0}",
        )
        return text.format("\n".join(lines[-3:]))
    if "No matching distribution" in output or "not a supported wheel" in output:
        text = translate(
            "SweptVolume",
            "There is no core of version {0} for Python {1} and this operating system: choose a "
            'package file (.whl) with the button "From a file", or build the core as described in '
            "docs/handbook/installation.md. pip says:\n"
            "{2}",
        )
        return text.format(__version__, version, last)
    return translate(
        "SweptVolume",
        "pip could not install the core: choose a package file (.whl) with the button "
        '"From a file", or build the core as described in docs/handbook/installation.md. '
        "pip says:\n"
        "{0}",
    ).format(last)


def version_in(path):
    """Returns the version of the core in a wheel file. Raises Failed."""
    try:
        with zipfile.ZipFile(path) as wheel:
            names = [re.match(r"swept_volume-([^/]+)\.dist-info/", n) for n in wheel.namelist()]
    except (OSError, zipfile.BadZipFile) as problem:
        text = translate(
            "SweptVolume",
            'The file "{0}" cannot be read as a Python package ({1}): choose another file.',
        )
        raise Failed(text.format(path, problem)) from None
    versions = {found[1] for found in names if found}
    if len(versions) != 1:
        text = translate(
            "SweptVolume",
            'The file "{0}" is not the core of Swept Volume: choose a file whose name begins with '
            "swept_volume.",
        )
        raise Failed(text.format(path))
    return versions.pop()


def _check_version(version, source):
    if version != __version__:
        text = translate(
            "SweptVolume",
            'The core in "{0}" has version {1}, but the workbench has version {2}: choose a '
            "core of version {2}.",
        )
        raise Failed(text.format(source, version, __version__))


def _move(staged, folder):
    """Replaces the core in `folder` by the core in `staged`. Windows cannot delete a loaded
    library, but can move it: such leftovers are deleted at the next installation."""
    old = tempfile.mkdtemp(prefix=".swept-old-", dir=folder)
    try:
        _move_parts(folder, old)
        _move_parts(staged, folder)
    except OSError:
        _move_parts(folder, staged)
        _move_parts(old, folder)
        raise
    for rest in glob.glob(os.path.join(folder, ".swept-*")):
        shutil.rmtree(rest, ignore_errors=True)


def _move_parts(source, destination):
    for part in _PARTS:
        for path in glob.glob(os.path.join(source, part)):
            os.replace(path, os.path.join(destination, os.path.basename(path)))


class Installation(threading.Thread):
    """Installs the core in the background. `line` is the last line that pip printed, `problem` the
    reason for a failure ("" after a success). `restart`: FreeCAD must be started again, because it
    has already loaded another core."""

    def __init__(self, wheel=""):
        """wheel: a file of the package; "": pip fetches it."""
        super().__init__(daemon=True)
        self.wheel, self.line, self.problem, self.restart = wheel, "", "", False
        self._process, self._lock, self.cancelled = None, threading.Lock(), False

    def cancel(self):
        with self._lock:
            self.cancelled = True
            if self._process is not None:
                self._process.kill()

    def run(self):
        try:
            self._install()
        except Failed as problem:
            self.problem = str(problem)
        except OSError as problem:
            text = translate("SweptVolume", "The core was not installed: {0}")
            self.problem = text.format(problem)
        if self.cancelled:
            self.problem = translate("SweptVolume", "Cancelled. Nothing was changed.")

    def _install(self):
        folder = target()
        os.makedirs(folder, exist_ok=True)
        if self.wheel:
            _check_version(version_in(self.wheel), self.wheel)
        elif any(is_unpublished_on(source) for source in sources()):
            text = translate(
                "SweptVolume",
                "The core is not published on {0} yet: choose a package file (.whl) with the "
                'button "From a file", or build the core as described in '
                "docs/handbook/installation.md.",
            )
            raise Failed(text.format(DEFAULT_INDEX))
        staged = tempfile.mkdtemp(prefix=".swept-new-", dir=folder)
        try:
            self._run_pip(staged)
            if not self.cancelled:
                self._settle(staged, folder)
        finally:
            shutil.rmtree(staged, ignore_errors=True)

    def _run_pip(self, staged):
        """Runs pip for FreeCAD's version of Python, without dependencies: FreeCAD has its own
        numpy, which pip must not replace."""
        python = _python()
        words = [python, "-m", "pip", "install", "--no-input", "--progress-bar", "off", "--no-deps"]
        words += ["--only-binary", ":all:", "--implementation", "cp", "--no-compile"]
        words += ["--python-version", interpreter.VERSION, "--target", staged]
        words.append(self.wheel or "{}=={}".format(PACKAGE, __version__))
        with self._lock:
            if self.cancelled:
                return
            self._process = subprocess.Popen(
                words,
                env=_environment(python),
                stdin=subprocess.DEVNULL,
                stdout=subprocess.PIPE,
                stderr=subprocess.STDOUT,
                encoding="utf-8",
                errors="replace",
                **interpreter.HIDDEN,
            )
        lines = []
        for line in self._process.stdout:
            lines.append(line)
            self.line = line.strip() or self.line
        if self._process.wait() and not self.cancelled:
            raise Failed(_reason(python, "".join(lines)))

    def _settle(self, staged, folder):
        """Moves a complete core of the right version to its folder."""
        infos = glob.glob(os.path.join(staged, "swept_volume-*.dist-info"))
        if len(infos) != 1 or not core_search.holds_core(staged):
            raise Failed(
                translate(
                    "SweptVolume",
                    "pip ended without an error, but installed no usable core: choose another "
                    'package file (.whl) with the button "From a file", or build the core as '
                    "described in docs/handbook/installation.md.",
                )
            )
        name = os.path.basename(infos[0])
        _check_version(name[len("swept_volume-") : -len(".dist-info")], name)
        self.restart = "_swept" in sys.modules
        _move(staged, folder)
        importlib.invalidate_caches()
