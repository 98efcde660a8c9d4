# SPDX-License-Identifier: LGPL-2.1-or-later
"""The only importer of the compiled module `_swept`.

Searched in this order: the folder in the environment variable SWEPT_CORE, build/python of the
repository, then the ordinary Python path. Nothing is imported before somebody needs it, so the
workbench starts, opens documents and shows stored results without the module.
"""
import collections
import contextlib
import importlib
import json
import os
import sys

import FreeCAD as App

from . import ROOT, __version__, settings
from .core_texts import said
from .texts import translate

_module = None
_problem = None
_told = False


class CoreMissing(RuntimeError):
    """The compiled module was not found or cannot be loaded; the text says what to do."""


def _search_folders():
    folders = []
    if os.environ.get("SWEPT_CORE"):
        folders.append(os.environ["SWEPT_CORE"])
    folders.append(os.path.join(ROOT, "build", "python"))
    return folders


def _load_from(folder):
    """Imports _swept from one folder without leaving that folder on the path."""
    sys.path.insert(0, folder)
    try:
        return importlib.import_module("_swept")
    finally:
        sys.path.remove(folder)


def _find():
    tried = []
    for folder in _search_folders():
        names = os.listdir(folder) if os.path.isdir(folder) else []
        if not any(n.startswith("_swept") and n.endswith((".so", ".pyd")) for n in names):
            tried.append("{}: not there".format(folder))
            continue
        try:
            return _load_from(folder), None
        except ImportError as error:
            tried.append("{}: {}".format(folder, error))
    try:
        return importlib.import_module("_swept"), None
    except ImportError as error:
        tried.append("Python path: {}".format(error))
    return None, tried


def _missing_text(tried):
    python = "{}.{}".format(*sys.version_info[:2])
    return translate(
        "Messages",
        "The compiled core of Swept Volume (_swept, for Python {0}) cannot be "
        "loaded.\n"
        "Build it once, in the folder {1}:\n"
        "    cmake --preset release && cmake --build build\n"
        "README.md lists the packages that the build needs. If the core is "
        "elsewhere, set the environment variable SWEPT_CORE to its folder.\n"
        "Tried:\n"
        "  {2}",
    ).format(python, ROOT, "\n  ".join(tried))


def _other_version_text(found):
    return translate(
        "Messages",
        "The compiled core of Swept Volume in {0} has version {1}, but the workbench "
        "has version {2}. Install the same version of both, or build the core again "
        "in the folder {3}:\n"
        "    cmake --preset release && cmake --build build",
    ).format(found.__file__, found.__version__, __version__, ROOT)


def module():
    """The compiled module; raises CoreMissing with a text for users."""
    global _module, _problem
    if _module is None:
        found, tried = _find()
        if found is None:
            _problem = _missing_text(tried)
        elif found.__version__ != __version__:
            _problem = _other_version_text(found)
        else:
            _module, _problem = found, None
        if _problem:
            raise CoreMissing(_problem)
        if App.GuiUp:
            _module.stand_back()  # the window answers first
    return _module


def available():
    """Whether the compiled module can be loaded."""
    try:
        module()
    except CoreMissing:
        return False
    return True


def tell_if_missing():
    """Says once a session, in the report view, how to build the core; never raises."""
    global _told
    if not _told and not available():
        _told = True
        App.Console.PrintWarning(_problem + "\n")


class CoreError(RuntimeError):
    """A run that gave no result. `status`: InvalidInput, ResourceLimit, Cancelled...; `code`: finding."""

    def __init__(self, status, code, message):
        super().__init__(message or code or status)
        self.status = status
        self.code = code


def cancelled():
    """What a run raises that was asked to stop, for one that could not answer."""
    return CoreError("Cancelled", "Cancelled", said("Cancelled", ""))


class Request:
    """Input of one run: plain arrays, independent of any document.

    times (k,) s, translations (k,3) mm, rotations (k,4) x,y,z,w.
    body: what has `vertices` (n,3) mm, `triangles` (m,3), `faces` and `parts` (as convert.Body); those may be
    made when they are first asked for, in the thread of the run.
    """

    def __init__(self, body, times, translations, rotations, interpolation, options):
        self.body = body
        self.times = times
        self.translations = translations
        self.rotations = rotations
        self.interpolation = interpolation
        self.options = options


#: A body whose arrays are there.
Triangles = collections.namedtuple(
    "Triangles", "vertices triangles faces parts", defaults=(None, ())
)


class Outcome:
    """Result of a run that ended Ok. What others add to it: result: what recut() takes, if it can be cut
    again; key: what it was made of; mesh, drawn: the same as a Mesh.Mesh and for the 3D view; sources:
    kind int8 (m,), faces int32 (m,2), time (m,) s of its triangles or None, parts: whose faces they are.
    """

    def __init__(self, report, vertices, triangles, contact_time):
        self.report = report
        self.vertices = vertices
        self.triangles = triangles
        self.contact_time = contact_time
        self.result, self.key, self.mesh, self.drawn = None, "", None, None
        self.sources, self.parts = None, []


@contextlib.contextmanager
def errors():
    """The module's exceptions as CoreError, the only kind the workbench knows."""
    try:
        yield
    except module().Error as error:
        raise CoreError(error.status, error.code, said(error.code, str(error))) from None


class Control:
    """Cancel flag and progress of one run, usable from any thread."""

    def __init__(self):
        self._cancelled, self._part, self._parts = False, 0, 1
        self.enter(0, 1)

    def enter(self, part, parts):
        """Begins part number `part` of a run that has several: each has a context of its own."""
        context = module().RunContext(settings.threads(), settings.memory_limit())
        self._part, self._parts, self.context = part, parts, context
        if self._cancelled:
            context.cancel()

    def cancel(self):
        self._cancelled = True
        self.context.cancel()

    def is_cancelled(self):
        return self._cancelled

    def progress(self):
        """Overall progress, 0 to 1."""
        return (self._part + self.context.progress) / self._parts

    def phase(self):
        """Name of the stage under way."""
        return self.context.phase


def arguments(request):
    """Body, motion and interpolation as the module's calls take them."""
    motion = (request.times, request.rotations, request.translations)
    return request.body.vertices, request.body.triangles, motion, request.interpolation


def outcome_of(found, request=None):
    """The module's result as ours. request: with its tolerance the surface may be cut again."""
    options = request.options if request is not None else {}
    again = options.get("tolerance", 0) > 0 and not options.get("conservative")
    if again:  # an open surface is left as it is
        again = all(w["code"] != "NotSimplified" for w in found.report["warnings"])
    outcome = Outcome(found.report, found.vertices, found.triangles, found.contact_time)
    parts = request.body.parts if request is not None else []
    outcome.result = (found, parts) if again else None
    return _with_sources(outcome, found, parts)


def _with_sources(outcome, found, parts):
    if found.sources is not None:
        outcome.sources = found.sources.kind, found.sources.faces, found.sources.time
        outcome.parts = parts
    return outcome


def compute(request, control):
    """Runs the core; the calling thread waits, others run. Returns Outcome or raises CoreError."""
    with errors():
        faces = request.body.faces if request.options.get("sources") else None
        found = module().compute(
            *arguments(request), run=control.context, faces=faces, **request.options
        )
    return outcome_of(found, request)


def recut(result, tolerance, control):
    """The `result` of an Outcome at another tolerance, not sampled again: Outcome."""
    surface, parts = result
    with errors():
        found = surface.recut(tolerance, run=control.context)
    again = _with_sources(outcome_of(found), found, parts)
    again.result = found, parts
    return again


def has_sources(result):
    """Whether what recut() gives of it knows what made its triangles."""
    return result[0].sources is not None


def estimate(request, control=None):
    """Grid, cell, memory, seconds of a run without running it: dict. Raises CoreError.

    control: then a few steps of the motion are sampled; up to a second or so. Else from boxes only.
    """
    how = {} if control is None else {"trial": True, "run": control.context}
    with errors():
        return module().estimate(*arguments(request), **how, **request.options)


def drawable(vertices, triangles, most, crease):
    """A mesh for the 3D view, thinned to about `most` triangles: points, normals, indices (arrays)."""
    return module().drawable(vertices, triangles, most, crease)


def warm_memory(size):
    """So many bytes for a copy that this thread is about to make: touch() in another thread, release()
    before the copy; to be kept until it is made."""
    return module().WarmMemory(int(size))


def mesh_file(vertices, triangles):
    """The bytes of FreeCAD's own kind of mesh file."""
    return module().freecad_mesh(vertices, triangles)


def read_motion(path, unit):
    """Motion file -> times (s), translations (mm), quaternions (x, y, z, w). Raises CoreError."""
    with errors():
        times, rotations, translations = module().read_trajectory_csv(path, unit)
    return times, translations, rotations


def read_solid(path, deflection, angle):
    """All solids of a BREP file as triangles: vertices (n,3) mm, triangles (m,3), number of each one's face
    (m,). deflection: mm; angle: rad. Raises CoreError."""
    with errors():
        found = module().read_body(path, tolerance=deflection, angle=angle)
    return found.vertices, found.triangles, found.faces


def write_mesh(vertices, triangles, path):
    """PLY, STL, OBJ or OFF by suffix. Raises CoreError."""
    with errors():
        module().write_mesh(path, vertices, triangles)


def has_solids():
    """Whether the module was built with OpenCASCADE."""
    return bool(module().HAS_SOLIDS)


def estimate_solid(vertices, triangles, control, suffix, quick, **options):
    """What write_solid() of this suffix with the same options would give: triangles, faces, megabytes,
    seconds, tolerance, tried. quick: bounds, from a look at the mesh; else from a trial."""
    with errors():
        return module().estimate_solid(
            vertices, triangles, run=control.context, format=suffix, quick=quick, **options
        )


def write_solid(vertices, triangles, path, control, **options):
    """Closed mesh -> STEP or BREP by suffix; options as the module's write_solid.

    Returns the report (dict); raises CoreError.
    """
    with errors():
        return module().write_solid(path, vertices, triangles, run=control.context, **options)


def clearance(request, neighbours, options, control):
    """Smallest distances of a moving body to (name, vertices, triangles, chord, rule) each: report (dict).

    `request.options` are not used; raises CoreError.
    """
    vertices, triangles, motion, interpolation = arguments(request)
    with errors():
        return module().clearance(
            vertices, triangles, motion, neighbours, interpolation, run=control.context, **options
        )


def mechanism(parts, options, control):
    """Smallest distances between parts that move at the same time: report (dict). parts: (name, vertices,
    triangles, (times, rotations, translations) or None, interpolation, chord error in mm). Raises CoreError.
    """
    with errors():
        return module().mechanism(parts, run=control.context, **options)


def first_contacts(request, neighbours, options, control):
    """The rules, as texts, that would allow what the body touches at its first pose; arguments as those of
    clearance(). Raises CoreError."""
    vertices, triangles, motion, interpolation = arguments(request)
    with errors():
        return module().first_contacts(
            vertices,
            triangles,
            motion,
            neighbours,
            interpolation,
            options["tolerance"],
            options["body_chord"],
            run=control.context,
        )


def has_page_view():
    """Whether pages have a 3D view."""
    return bool(module().page_has_view())


def report_page(report, control, **options):
    """A report (dict) as one HTML file, as text; options as the module's report_page. Raises CoreError."""
    with errors():
        return module().report_page(
            json.dumps(report), version=__version__, run=control.context, **options
        )


def page_template(name):
    """A template of the program: "page" or "print"."""
    return module().page_template(name)


def distance_to_mesh(points, vertices, triangles, control):
    """Distance (mm) of each point to a mesh, negative inside. Raises CoreError."""
    with errors():
        return module().distance_to_mesh(points, vertices, triangles, run=control.context)
