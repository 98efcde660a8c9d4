# SPDX-License-Identifier: LGPL-2.1-or-later
"""Runs studies (docs/studies.md) outside FreeCAD's process. The package `swept_volume`, in the
folder of the compiled core, computes them in its own process, as `swept study` does. So the window
never waits, and a crash of that process does not affect FreeCAD. Any thread.
"""
import importlib
import json
import os
import queue
import signal
import subprocess
import sys
import tempfile
import threading

from . import core, interpreter
from .body import InputProblem
from .texts import translate

#: _POLL: interval (s) at which the workbench checks whether a running study must stop. _LEAVE:
#: longest time (s) to wait for the end of its process and of the threads that read its output.
_POLL, _LEAVE = 0.05, 20.0


def _folder():
    """Returns the folder of the core, which also holds the package. Raises core.CoreMissing,
    InputProblem."""
    folder = os.path.dirname(os.path.abspath(core.module().__file__))
    if os.path.isfile(os.path.join(folder, "swept_volume", "__main__.py")):
        return folder
    text = translate(
        "SweptVolume",
        "Studies need the Python package swept_volume, which is missing in {0}: "
        'install the workbench again, or build it with "cmake --build build".',
    )
    raise InputProblem(text.format(folder))


def _package(name):
    folder = _folder()
    sys.path.insert(0, folder)
    try:
        return importlib.import_module("swept_volume." + name)
    except ImportError as problem:  # before Python 3.11, tomli may be missing
        text = translate("SweptVolume", "A Python module is missing ({0}): install it.")
        raise InputProblem(text.format(problem)) from None
    finally:
        sys.path.remove(folder)


def read(path, output=None):
    """Reads and checks a study file. Returns an object with file, name, output (folder of the
    results) and runs; each run has name, part, motion, neighbours, rules, compute and options.
    Raises core.CoreError, core.CoreMissing, InputProblem."""
    package = _package("_study_file")
    try:
        with core.errors():
            return package.read_study(path, output or None)
    except OSError as problem:
        text = translate("SweptVolume", 'The study file "{0}" cannot be read: {1}')
        raise InputProblem(text.format(path, problem.strerror or problem)) from None


def load(run, reader):
    """Reads the inputs of a run of a study file: the part (with vertices (n,3) mm and triangles
    (m,3)), its motion (times s, translations mm, rotations as quaternions x, y, z, w), and for
    each neighbour (name, shape, rule as text; "" for the common distance). reader: reads STEP and BREP
    files, as the core's read_body() describes; None: the core does. Raises core.CoreError,
    InputProblem."""
    values, files = _package("_values"), run.options[""]
    deflection = run.options.get("clearance", {}).get("deflection", 0.05)
    try:
        with core.errors():
            unit = files.get("part_unit", "mm")
            body = values.read_body(run.part, unit=unit, tolerance=deflection, reader=reader)
            unit = files.get("neighbour_unit", "mm")
            parts = [
                part
                for file in run.neighbours
                for part in values.read_parts(file, unit=unit, deflection=deflection, reader=reader)
            ]
            texts = _package("_clearance").rule_texts(run.rules)
            rules = core.module().rules_for(texts, [name for name, _ in parts])
    except OSError as problem:
        raise InputProblem(str(problem)) from None
    motion = core.read_motion(run.motion, files.get("motion_unit", "mm"))
    return body, motion, [(*part, rule) for part, rule in zip(parts, rules)]


def worst_first(rows):
    """Returns the indices of the rows of a study, the most important first."""
    return _package("_study").worst_first(rows)


def _start(words):
    """Starts Python with these arguments in the folder of the core and the package. Nothing else
    could be imported from there."""
    python = interpreter.find()
    if python is None:
        text = translate(
            "SweptVolume", "Studies need the program {0}, but it was not found: install it."
        )
        raise InputProblem(text.format("python" + interpreter.VERSION))
    return subprocess.Popen(
        [python] + words,
        cwd=_folder(),
        stdin=subprocess.DEVNULL,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        **interpreter.HIDDEN,
    )


class _Output:
    """Output of a process, read by threads: line by line, and the rest at the end."""

    def __init__(self, process):
        self.lines, self.errors = queue.Queue(), b""
        self._process = process
        self._threads = [
            threading.Thread(target=target, daemon=True) for target in (self._read, self._complain)
        ]
        for thread in self._threads:
            thread.start()

    def _read(self):
        for line in self._process.stdout:
            self.lines.put(line)
        self.lines.put(None)

    def _complain(self):
        self.errors = self._process.stderr.read()

    def text(self):
        """Returns the text of standard error after the process has ended."""
        for thread in self._threads:
            thread.join(_LEAVE)
        return self.errors.decode("utf-8", "replace").strip()


def _ask_to_stop(process):
    if os.name == "nt":
        process.terminate()
    else:
        process.send_signal(signal.SIGINT)


def _followed(process, on_line, cancelled):
    """Passes each line to on_line() until the process has ended. Returns the text of its standard
    error. Raises core.CoreError if the study was cancelled."""
    output, stopping = _Output(process), False
    try:
        while True:
            if not stopping and cancelled():
                _ask_to_stop(process)
                stopping = True
            try:
                line = output.lines.get(timeout=_POLL)
            except queue.Empty:
                continue
            if line is None:
                break
            on_line(line)
        process.wait(_LEAVE)
    finally:
        if process.poll() is None:
            process.kill()
            process.wait()
    if stopping:
        raise core.cancelled()
    return output.text()


def run(path, output, jobs, on_row, cancelled):
    """Computes the remaining runs of a study and its page, in `jobs` processes (0: one for each
    core).

    Calls on_row(row, done, runs) in this thread for each run. Kept results come first; for them, done
    and runs are None. cancelled() returns whether to stop. Returns the report of the study
    (docs/report.md). Raises core.CoreError, core.CoreMissing, InputProblem."""

    def take(line):
        found = json.loads(line.decode("utf-8"))
        on_row(found["row"], found.get("done"), found.get("runs"))

    with tempfile.TemporaryDirectory() as folder:
        report = os.path.join(folder, "report.json")
        words = ["-m", "swept_volume", "study", "--rows", "--page", "--output=" + output]
        words += ["--report=" + report] + (["--jobs={}".format(jobs)] if jobs else [])
        process = _start(words + ["--", path])
        errors = _followed(process, take, cancelled)
        if os.path.exists(report):  # without a report, the study was refused or the process died
            with open(report, encoding="utf-8") as file:
                return json.load(file)
    text = translate(
        "SweptVolume",
        "The program that runs the study ended with exit status {0} and wrote no result: run the "
        "study again. To see the output of the program, enter this command in a terminal: swept "
        'study "{1}"',
    )
    raise InputProblem(errors or text.format(process.returncode, path))


#: Arguments: study, folder of the results, relative path from the page to that folder, template (""
#: for the template of the study, "print", or a file).
_PAGE = """
import sys, swept_volume as sv
path, output, relative, template = sys.argv[1:]
text = None
if template:
    own = template == "print"
    text = sv.page_template(template) if own else open(template, encoding="utf-8").read()
try:
    page = sv.study_page(path, output=output, folder=relative, template=text)
except (sv.Error, OSError) as error:
    sys.exit(str(error))
sys.stdout.buffer.write(page.encode())
"""


def page(path, output, target, template, cancelled):
    """Returns the page of all runs as text, for a file at `target`. template: "" for the template
    of the study, "print" for the built-in template for PDF, or a file. Raises core.CoreError,
    core.CoreMissing, InputProblem."""
    relative = os.path.relpath(output, os.path.dirname(os.path.abspath(target)))
    relative = "" if relative == "." else relative.replace(os.sep, "/") + "/"
    process, lines = _start(["-c", _PAGE, path, output, relative, template]), []
    errors = _followed(process, lines.append, cancelled)
    if process.returncode != 0:
        raise InputProblem(errors)
    return b"".join(lines).decode("utf-8")
