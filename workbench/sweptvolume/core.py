# SPDX-License-Identifier: LGPL-2.1-or-later
"""The compiled module `_swept`, which core_search finds. Only core.py and core_*.py call it.

It is imported on first use. So the workbench starts, opens documents and shows stored results
without it.
"""
import collections
import contextlib
import json

import FreeCAD as App

from . import __version__, core_search, settings
from .core_texts import said

_module = None
_problem = None
_warned = False


class CoreMissing(RuntimeError):
    """The compiled module was not found or cannot be loaded. The text says what to do."""


def module():
    """Returns the compiled module. Raises CoreMissing with a text for users."""
    global _module, _problem
    if _module is None:
        found, tried = core_search.find()
        if found is None:
            _problem = core_search.missing_text(tried)
        elif found.__version__ != __version__:
            _problem = core_search.other_version_text(found)
        else:
            _module, _problem = found, None
        if _problem:
            raise CoreMissing(_problem)
        if App.GuiUp:
            _module.stand_back()  # runs get a lower priority than the window
    return _module


def available():
    """Returns whether the compiled module can be loaded."""
    try:
        module()
    except CoreMissing:
        return False
    return True


def problem():
    """Returns why the module cannot be used, or ""."""
    return "" if available() else _problem


def warn_if_missing():
    """If the core is missing, prints in the report view, once in a session, how to get it. Never
    raises."""
    global _warned
    if not _warned and not available():
        _warned = True
        App.Console.PrintWarning(_problem + "\n")


class CoreError(RuntimeError):
    """A run without a result. `status`: a status of the core, such as InvalidInput. `code`: the
    code of the finding."""

    def __init__(self, status, code, message):
        super().__init__(message or code or status)
        self.status = status
        self.code = code


def cancelled():
    """Returns the error of a cancelled run, for a run that could not respond itself."""
    return CoreError("Cancelled", "Cancelled", said("Cancelled", ""))


class Request:
    """Input of one run as plain arrays, independent of any document.

    times (k,) s, translations (k,3) mm, rotations (k,4) x,y,z,w.
    body: an object with `vertices` (n,3) mm, `triangles` (m,3), `faces` and `parts`, such as
    convert.Body. It may create them on first use, in the thread of the run.
    """

    def __init__(self, body, times, translations, rotations, interpolation, options):
        self.body = body
        self.times = times
        self.translations = translations
        self.rotations = rotations
        self.interpolation = interpolation
        self.options = options


#: A body with arrays that already exist.
Triangles = collections.namedtuple(
    "Triangles", "vertices triangles faces parts", defaults=(None, ())
)


class Outcome:
    """Result of a successful run. Other modules add: result, the argument for recut(), if the
    result can be simplified again; key, which identifies its inputs; mesh and drawn, the surface
    as a Mesh.Mesh and for the 3D view; sources, with kind int8 (m,), faces int32 (m,2) and time
    (m,) s of its triangles, or None; parts, to which the faces belong.
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
    """Converts the exceptions of the module to CoreError, the only kind that the workbench handles."""
    try:
        yield
    except module().Error as error:
        raise CoreError(error.status, error.code, said(error.code, str(error))) from None


class Control:
    """Cancel flag and progress of one run. Any thread may use it."""

    def __init__(self):
        self._cancelled, self._part, self._parts = False, 0, 1
        self.enter(0, 1)

    def enter(self, part, parts):
        """Begins part number `part` of a run with several parts. Each part has its own context."""
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
        """Returns the progress of the whole run, 0 to 1."""
        return (self._part + self.context.progress) / self._parts

    def phase(self):
        """Returns the name of the current stage."""
        return self.context.phase


def arguments(request):
    """Returns body, motion and interpolation in the form that the module's functions take."""
    motion = (request.times, request.rotations, request.translations)
    return request.body.vertices, request.body.triangles, motion, request.interpolation


def outcome_of(found, request=None):
    """Converts a result to an Outcome. If the request has a tolerance, the Outcome can usually be
    simplified again."""
    options = request.options if request is not None else {}
    again = options.get("tolerance", 0) > 0 and not options.get("conservative")
    if again:  # an open surface is not simplified
        again = all(w["code"] != "NotSimplified" for w in found.report["warnings"])
    outcome = Outcome(found.report, found.vertices, found.triangles, found.contact_time)
    parts = request.body.parts if request is not None else []
    outcome.result = (found, parts, lambda outcome: outcome) if again else None
    return _with_sources(outcome, found, parts)


def _with_sources(outcome, found, parts):
    if found.sources is not None:
        outcome.sources = found.sources.kind, found.sources.faces, found.sources.time
        outcome.parts = parts
    return outcome


def compute(request, control):
    """Runs the core in the calling thread. Returns an Outcome or raises CoreError."""
    with errors():
        faces = request.body.faces if request.options.get("sources") else None
        found = module().compute(
            *arguments(request), run=control.context, faces=faces, **request.options
        )
    return outcome_of(found, request)


def recut(result, tolerance, control):
    """Simplifies the `result` of an Outcome to another tolerance. Returns an Outcome."""
    surface, parts, completed = result
    with errors():
        found = surface.recut(tolerance, run=control.context)
    again = _with_sources(outcome_of(found), found, parts)
    again.result = found, parts, completed
    return completed(again)


def has_sources(result):
    """Returns whether recut() of this result will return the sources of the triangles
    (Outcome.sources)."""
    return result[0].sources is not None


def estimate(request, control=None):
    """Estimates grid, cell, memory and seconds of a run. Returns a dict. Raises CoreError.

    With control, the core samples a few steps of the motion, which takes up to about a second.
    Without control, it uses only bounding boxes.
    """
    how = {} if control is None else {"trial": True, "run": control.context}
    with errors():
        return module().estimate(*arguments(request), **how, **request.options)


def options_of_accuracy(accuracy):
    """Returns cell (mm), tolerance (mm) and chord_tolerance (mm) of runs with this accuracy (mm). Raises
    CoreError."""
    with errors():
        return module().options_of_accuracy(accuracy)


def drawable(vertices, triangles, most, crease):
    """Returns points, normals, indices of a mesh for the 3D view, with about `most` triangles."""
    return module().drawable(vertices, triangles, most, crease)


def warm_memory(size):
    """Reserves bytes for a copy that this thread will make. Call touch() in another thread and
    release() before the copy. Keep the object until the copy is made."""
    return module().WarmMemory(int(size))


def mesh_file(vertices, triangles):
    """Returns the bytes of a FreeCAD mesh file."""
    return module().freecad_mesh(vertices, triangles)


def read_motion(path, unit):
    """Returns times (s), translations (mm), quaternions (x, y, z, w). Raises CoreError."""
    with errors():
        times, rotations, translations = module().read_trajectory_csv(path, unit)
    return times, translations, rotations


def read_solid(path, deflection, angle):
    """Reads all solids of a BREP file. Returns vertices (n,3) mm, triangles (m,3) and the face
    index of each triangle (m,). deflection: mm; angle: rad. Raises CoreError."""
    with errors():
        found = module().read_body(path, tolerance=deflection, angle=angle)
    return found.vertices, found.triangles, found.faces


def write_mesh(vertices, triangles, path):
    """Writes PLY, STL, OBJ or OFF; the suffix gives the type. Raises CoreError."""
    with errors():
        module().write_mesh(path, vertices, triangles)


def has_solids():
    """Returns whether the module was built with OpenCASCADE."""
    return bool(module().HAS_SOLIDS)


def estimate_solid(vertices, triangles, control, suffix, quick, **options):
    """Estimates the result of write_solid() for a file with this suffix and the same options.
    Returns triangles, faces, megabytes, seconds, tolerance and tried. quick=True gives upper
    bounds from the mesh alone; otherwise a trial builds the solid."""
    with errors():
        return module().estimate_solid(
            vertices, triangles, run=control.context, format=suffix, quick=quick, **options
        )


def read_body_shape(path, control):
    """Reads the faces and edges of a STEP or BREP file, for the argument `origin` of write_solid().
    Raises CoreError."""
    with errors():
        return module().read_body_shape(path, control.context)


def write_solid(vertices, triangles, path, control, **options):
    """Writes a closed mesh as a STEP or BREP file; the suffix gives the type. Options are those of
    the module's write_solid().

    Returns the report (dict). Raises CoreError.
    """
    with errors():
        return module().write_solid(path, vertices, triangles, run=control.context, **options)


def clearance(request, neighbours, options, control):
    """Measures the smallest distance of a moving body from each neighbour (name, vertices,
    triangles, mesh deflection in mm, rule). Returns the report (dict).

    Ignores `request.options`. Raises CoreError.
    """
    vertices, triangles, motion, interpolation = arguments(request)
    with errors():
        return module().clearance(
            vertices, triangles, motion, neighbours, interpolation, run=control.context, **options
        )


def mechanism(parts, options, control):
    """Measures the smallest distances between parts that move at the same time. Returns the report
    (dict). parts: (name, vertices, triangles, (times, rotations, translations) or None,
    interpolation, chord error in mm). Raises CoreError.
    """
    with errors():
        return module().mechanism(parts, run=control.context, **options)


def first_contacts(request, neighbours, options, control):
    """Returns the rules, as texts, that would allow the contacts of the body at its first pose.
    Arguments are those of clearance(). Raises CoreError."""
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
    """Returns whether pages have a 3D view."""
    return bool(module().page_has_view())


def report_page(report, control, **options):
    """Returns an HTML page of a report (dict); options as in the module. Raises CoreError."""
    with errors():
        return module().report_page(
            json.dumps(report), version=__version__, run=control.context, **options
        )


def page_template(name):
    """Returns a built-in template: "page" or "print"."""
    return module().page_template(name)


def distance_to_mesh(points, vertices, triangles, control):
    """Returns the distance (mm) of each point from a mesh, negative inside. Raises CoreError."""
    with errors():
        return module().distance_to_mesh(points, vertices, triangles, run=control.context)
