# SPDX-License-Identifier: LGPL-2.1-or-later
"""Solid: the B-rep solid of an envelope. It depends on the envelope as a parametric object.

As with the envelope, `execute` only updates the state. A run consists of request(),
core.write_solid() and apply().
"""
import os
import tempfile

import numpy as np

from .. import contents, convert, core
from ..convert import InputProblem
from ..quantities import quantity
from ..texts import translate
from . import envelope as envelope_feature
from . import missing, solid_origin, status, step_reader
from .base import (  # noqa: F401 (the states are read from here as well)
    FAILED,
    NOT_COMPUTED,
    STALE,
    UP_TO_DATE,
    Feature,
    add_object,
    kind_of,
    quietly,
    set_changed,
)
from .solid_properties import MAX_FACES, PROPERTIES

TYPE = "Part::FeaturePython"

#: Relative accuracy of the coordinates of a FreeCAD mesh, which have 24 bits: a few units in the
#: last place. Used to find flat regions.
SINGLE_PRECISION = 2.0**-22


missing.watch()

#: mm: gaps at edges up to this are accepted, because CAD systems treat such edges as closed.
LEAST_GAP = 1e-3

#: Default options of a new solid for request_for(). max_megabytes: limit of the file size (0: no
#: limit); tessellated: write the triangles unchanged, as a STEP file.
DEFAULTS = {
    "merge": True,
    "max_faces": MAX_FACES,
    "tolerance": 0.0,
    "max_megabytes": 0.0,
    "tessellated": False,
}

#: The smallest tolerance that the panel proposes, as a fraction of the diagonal of the bounding box.
#: It is also the smallest one that the core chooses by itself.
PROPOSED_SHARE = 1 / 4000


class Solid(Feature):
    """Proxy of the solid."""

    KIND = "SweptVolume::Solid"

    def properties(self):
        return PROPERTIES

    def execute(self, obj):
        """Marks the solid as stale or current, and keeps the shape."""
        update_status(obj)

    refresh_status = execute

    def onChanged(self, obj, name):
        missing.changed(obj, name)

    def onDocumentRestored(self, obj):
        from_old_version = "Placed" not in obj.PropertiesList
        with quietly(obj):
            super().onDocumentRestored(obj)
            if from_old_version:
                status.remember_place(obj)
                before = status.hash_or_problem(lambda: hash_of_before(obj))[0]
                status.renew(obj, before, input_hash(obj))


def is_solid(obj):
    return kind_of(obj) == Solid.KIND


def can_be_source(obj):
    """Returns whether an object can be converted to a solid: a mesh with triangles."""
    return obj.isDerivedFrom("Mesh::Feature") and obj.Mesh.CountFacets > 0


def input_hash(obj):
    """Returns a short text that identifies all inputs of the result, or "" if inputs are unusable."""
    return status.hash_or_problem(lambda: checked_hash(obj.Source, settings(obj)))[0]


def checked_hash(source, wanted):
    """Returns the hash for a source and settings. wanted: a dict like DEFAULTS. Raises
    InputProblem."""
    return hash_of(words_of(source, wanted))


def hash_of(words):
    """Returns the hash for the result of words_of(). Any thread may call this after
    contents.prepared(words)."""
    return status.VERSION + contents.short(contents.texts(words))


def words_of(source, wanted):
    """Returns what identifies the inputs: texts and apart.Apart objects, as from contents.words().
    Raises InputProblem."""
    _check_source(source)
    return contents.words([convert.root_path(source)]) + _words(source, wanted)


def hash_of_before(obj):
    """Returns the hash of version 1. Raises InputProblem."""
    _check_source(obj.Source)
    words = [contents.signature_of_before([(obj.Source, "")])]
    words += _words(obj.Source, settings(obj))
    if envelope_feature.is_envelope(obj.Source):
        # The stored hash of the solid contains its envelope's hash of version 1. The envelope may
        # have a hash of the present version by now.
        plan = envelope_feature.Plan.of(obj.Source)
        if obj.Source.InputHash == plan.hash():
            words[-1] = plan.hash_of_before()
    return contents.short(words)


def _words(source, wanted):
    words = [str(wanted["merge"])]
    # With default values, the hashed words are the same as in older versions, which lacked these
    # properties. So solids of older documents stay up to date.
    if wanted["tolerance"] > 0:
        words.append(repr(contents.steady(wanted["tolerance"])))
    if wanted["max_faces"] != MAX_FACES:
        words.append("at most {} faces".format(wanted["max_faces"]))
    if envelope_feature.is_envelope(source):
        words.append(source.InputHash)
    return words


def _check_source(source):
    if source is None or not can_be_source(source):
        raise InputProblem(
            translate("SweptVolume", "The envelope has no mesh yet: compute it first.")
        )


def update_status(obj):
    """Compares the present inputs with those of the stored result. A solid of a stale envelope is
    stale, too."""
    lost = missing.text(obj)
    given = obj.Source, settings(obj)
    now, problem, waits = status.inputs_of(
        obj, lambda: words_of(*given), lambda: checked_hash(*given)
    )
    if waits:
        return
    if now and status.is_displaced(obj):
        now += " moved"
    waiting = obj.Source is not None and status.is_behind(obj.Source)
    status.judge(obj, now, lost or problem, waiting, notes_of(obj))


def notes_of(obj):
    """Returns the notes to show for the stored result."""
    notes, wanted, off = [], obj.Tolerance.Value, obj.Deviation.Value
    if off > max(wanted, LEAST_GAP):
        if wanted > 0:
            text = translate(
                "SweptVolume",
                "The solid deviates from the envelope by {0}, which is more than its "
                "Tolerance of {1}. A smaller Tolerance usually reduces the deviation.",
            )
        else:
            text = translate(
                "SweptVolume",
                "To stay within Max faces, the solid was simplified: it deviates from the envelope by "
                "up to {0}. Allow more faces, or set a Tolerance.",
            )
        notes.append(text.format(quantity(off), quantity(wanted)))
    largest_gap = max(wanted, off, LEAST_GAP)
    if obj.EdgeTolerance.Value > largest_gap:
        text = translate(
            "SweptVolume",
            "At one edge, the gap between two faces of the solid is {0}. It should be at most {1}: the "
            "Tolerance or the deviation of the solid from the envelope, whichever is larger, but at "
            "least 0.001 mm. A smaller Tolerance gives more faces and smaller gaps.",
        )
        notes.append(text.format(quantity(obj.EdgeTolerance.Value), quantity(largest_gap)))
    return "\n".join(notes)


class Request:
    """A mesh and the settings of its solid, independent of any document. origin: a
    solid_origin.Origin, or None."""

    def __init__(self, vertices, triangles, name, exact, settings, origin=None):
        self.vertices = vertices
        self.triangles = triangles
        self.name = name
        self.exact = exact
        self.settings = settings
        self.origin = origin

    def with_settings(self, given):
        """Returns a request with the same mesh and other settings. Raises InputProblem."""
        wanted = dict(self.settings, **given)
        if self.exact and wanted["tolerance"] > 0 and not wanted["tessellated"]:
            raise InputProblem(
                translate(
                    "SweptVolume",
                    "The envelope is conservative, but a solid with a tolerance could cut into the "
                    "swept volume: set the Tolerance of the solid to 0.",
                )
            )
        return Request(self.vertices, self.triangles, self.name, self.exact, wanted, self.origin)

    def options(self):
        """Returns the settings as the core takes them."""
        reach = float(np.abs(self.vertices).max()) if len(self.vertices) else 1.0
        if self.settings["tessellated"]:
            return {
                "schema": "ap242-tessellated",
                "max_megabytes": self.settings["max_megabytes"],
            }
        return {
            "merge_coplanar": self.settings["merge"],
            "planar_tolerance": max(1e-6, reach * SINGLE_PRECISION),
            "max_faces": self.settings["max_faces"],
            "max_megabytes": self.settings["max_megabytes"],
            "tolerance": self.settings["tolerance"],
            "exact": self.exact,
        }

    def _options_with_origin(self, control):
        """Returns the options to make the solid. Any thread. Raises core.CoreError."""
        if self.origin is None or self.settings["tessellated"]:
            return self.options()
        return dict(self.options(), origin=self.origin.argument(control))

    def estimates(self, suffix):
        """Returns functions of a core.Control, for any thread, that estimate a file with this
        suffix: first a quick bound, then a trial. They return dicts as core.estimate_solid()
        does, and raise core.CoreError."""

        def estimate(quick):
            def found(control):
                options = self.options() if quick else self._options_with_origin(control)
                mesh = self.vertices, self.triangles
                return core.estimate_solid(*mesh, control, suffix, quick, **options)

            return found

        # Without OpenCASCADE in the core, a trial would take as long as writing the solid.
        if self.settings["tessellated"] or not core.has_solids():
            return [estimate(True)]
        return [estimate(True), estimate(False)]

    def write(self, path, control):
        """Writes STEP or BREP; the suffix gives the type. Returns the core's report (dict). Raises
        core.CoreError."""
        write = core.write_solid if core.has_solids() else step_reader.write
        options = dict(self._options_with_origin(control), product_name=self.name)
        return write(self.vertices, self.triangles, path, control, **options)


def is_exact(source):
    """Returns whether the solid of a mesh object must be exact."""
    return envelope_feature.is_envelope(source) and bool(source.Conservative)


def request_for(source, world=False, **given):
    """Reads a mesh object. `world`: return vertices in world coordinates (for export), not in its
    own frame. given: the settings that differ from DEFAULTS.

    The solid of a conservative envelope is exact, because a simplified one could cut into the swept
    volume."""
    _check_source(source)
    exact = is_exact(source)
    vertices, triangles = convert.arrays_from_mesh(source.Mesh)
    placed = convert.matrix_of(convert.global_placement(*convert.root_path(source)))
    if world:
        vertices = convert.transform(placed, vertices)
    origin = None
    if envelope_feature.is_envelope(source):
        origin = solid_origin.of(source, np.eye(4) if world else np.linalg.inv(placed))
    request = Request(vertices, triangles, source.Label, exact, DEFAULTS, origin)
    return request.with_settings(given)


def settings(obj):
    """Returns the settings of a solid object, as a dict like DEFAULTS."""
    return dict(
        DEFAULTS,
        merge=bool(obj.MergeCoplanar),
        max_faces=int(obj.MaxFaces),
        tolerance=obj.Tolerance.Value,
    )


def first_settings(source):
    """Returns the settings that the panel proposes for a new solid, as a dict like DEFAULTS. With
    their tolerance, which has one significant digit, the solid gets the surfaces that the part
    sweeps. It is about the deviation of the meshes of the parts. It is 0 for conservative
    envelopes, see request_for()."""
    if is_exact(source):
        return dict(DEFAULTS)
    tolerance = source.Mesh.BoundBox.DiagonalLength * PROPOSED_SHARE
    if envelope_feature.is_envelope(source):
        tolerance = max(tolerance, source.MeshDeflection * source.UsedCellSize.Value)
    return dict(DEFAULTS, tolerance=float("{:.0e}".format(tolerance)))


def set_settings(obj, wanted):
    """Writes settings into a solid object; the inverse of settings()."""
    set_changed(obj, "MergeCoplanar", wanted["merge"])
    set_changed(obj, "MaxFaces", wanted["max_faces"])
    if obj.Tolerance.Value != wanted["tolerance"]:
        obj.Tolerance = wanted["tolerance"]


def request(obj):
    """Returns the request of a solid object. Raises InputProblem."""
    missing.check(obj)
    return request_for(obj.Source, **settings(obj))


def work(req, control):
    """Runs the conversion, in any thread. Returns (BREP file, report). The caller removes the file."""
    handle, path = tempfile.mkstemp(suffix=".brep")
    os.close(handle)
    try:
        return path, req.write(path, control)
    except BaseException:
        os.remove(path)
        raise


def apply(obj, value, hash_at_start):
    """Loads the finished solid into the object."""
    import Part

    path, report = value
    try:
        shape = Part.Shape()
        shape.importBrep(path)
    finally:
        os.remove(path)
    if shape.ShapeType == "Compound" and len(shape.Solids) == 1:
        shape = shape.Solids[0]
    there = convert.global_placement(*convert.root_path(obj.Source))
    shape.Placement = status.outer_inverse(obj).multiply(there)
    obj.Shape = shape
    status.remember_place(obj)
    obj.Faces = len(shape.Faces)
    # The core's volume is used, because the kernel's is less exact for extruded profiles.
    obj.Volume = report.get("volume") or shape.Volume
    obj.Deviation = report["deviation"]
    obj.EdgeTolerance = max((edge.Tolerance for edge in shape.Edges), default=0.0)
    obj.InputHash, obj.TriedHash = hash_at_start, ""
    update_status(obj)
    status.update_users(obj)


def fail(obj, text, tried, cancelled=False):
    """Stores the error of a run without a result; the stored shape is kept. tried: hash of the
    inputs of the run."""
    status.mark_failure(obj, lambda: input_hash(obj), text, tried, cancelled)
    status.update_users(obj)


def compute(obj, control=None):
    """Converts in this thread (for scripts without a GUI) as one undo step. Raises core.CoreError."""
    hash_at_start = input_hash(obj)
    try:
        value = work(request(obj), control or core.Control())
    except (core.CoreError, InputProblem) as error:
        fail(obj, str(error), hash_at_start, getattr(error, "status", "") == "Cancelled")
        raise
    obj.Document.openTransaction(translate("SweptVolume", "Make solid"))
    apply(obj, value, hash_at_start)
    obj.purgeTouched()
    obj.Document.commitTransaction()
    return value[1]


def make_solid(document, source, label=None, **settings):
    """Creates a solid object, not yet computed."""
    label = label or translate("SweptVolume", "{0} solid").format(source.Label)
    view = "sweptvolume.views.solid_view:SolidView"
    settings = {"Source": source, **settings}
    return add_object(document, TYPE, "EnvelopeSolid", Solid, label, settings, view)
