# SPDX-License-Identifier: LGPL-2.1-or-later
"""Solid: the B-rep solid of an envelope, parametric on it.

As with the envelope, `execute` only marks; a run is request() - core.write_solid() - apply().
"""
import hashlib
import os
import tempfile

import numpy as np

from .. import convert, core
from ..convert import InputProblem
from ..texts import mark, translate
from . import envelope as envelope_feature
from . import faceted
from .base import HIDDEN, READ_ONLY, Feature, attach_view, kind_of, set_changed
from .envelope import FAILED, NOT_COMPUTED, STALE, UP_TO_DATE

TYPE = "Part::FeaturePython"

#: Coordinates of a FreeCAD mesh carry 24 bits; flat regions are found within a few units of the last.
SINGLE_PRECISION = 2.0**-22


#: Budget of faces of a new solid.
MAX_FACES = 20000
#: What request_for() takes for a new one; max_megabytes: of a file, 0: any size; tessellated: the
#: triangles as they are, in a STEP file.
DEFAULTS = {
    "merge": True,
    "max_faces": MAX_FACES,
    "tolerance": 0.0,
    "max_megabytes": 0.0,
    "tessellated": False,
}


class Solid(Feature):
    """Proxy of the solid."""

    KIND = "SweptVolume::Solid"

    def properties(self):
        return [
            (
                "App::PropertyLinkGlobal",
                "Source",
                "Solid",
                mark("Properties", "Envelope (or any closed mesh) of which this is the solid"),
                None,
                0,
            ),
            (
                "App::PropertyBool",
                "MergeCoplanar",
                "Solid",
                mark("Properties", "Flat regions become single faces"),
                True,
                0,
            ),
            (
                "App::PropertyInteger",
                "MaxFaces",
                "Solid",
                mark("Properties", "At most this many faces; without a Tolerance it is chosen so"),
                MAX_FACES,
                0,
            ),
            (
                "App::PropertyLength",
                "Tolerance",
                "Solid",
                mark(
                    "Properties",
                    "The solid may leave the mesh by this: cylinders, spheres and the like are found, "
                    "the rest is simplified. 0: exact, unless MaxFaces asks for more",
                ),
                0.0,
                0,
            ),
            (
                "App::PropertyLength",
                "Deviation",
                "Result",
                mark("Properties", "Largest distance of the mesh from the solid, as measured"),
                None,
                READ_ONLY,
            ),
            (
                "App::PropertyString",
                "Status",
                "Result",
                mark("Properties", "State of the result"),
                NOT_COMPUTED,
                READ_ONLY,
            ),
            (
                "App::PropertyString",
                "Message",
                "Result",
                mark("Properties", "Why the last run failed"),
                None,
                READ_ONLY,
            ),
            (
                "App::PropertyInteger",
                "Faces",
                "Result",
                mark("Properties", "Faces of the solid"),
                None,
                READ_ONLY,
            ),
            (
                "App::PropertyVolume",
                "Volume",
                "Result",
                mark("Properties", "Volume of the solid"),
                None,
                READ_ONLY,
            ),
            (
                "App::PropertyString",
                "InputHash",
                "Result",
                mark("Properties", "Inputs of the stored result"),
                None,
                HIDDEN,
            ),
        ]

    def execute(self, obj):
        """Marks the solid stale or current; keeps the shape."""
        update_status(obj)


def is_solid(obj):
    return kind_of(obj) == Solid.KIND


def can_be_source(obj):
    """Whether a solid can be made of an object: a mesh with triangles."""
    return obj.isDerivedFrom("Mesh::Feature") and obj.Mesh.CountFacets > 0


def input_hash(obj):
    source = obj.Source
    if source is None or not can_be_source(source):
        return ""
    words = [convert.signature([(source, "")]), str(obj.MergeCoplanar)]
    # With the defaults as before these properties: solids of older documents stay current.
    if obj.Tolerance.Value > 0:
        words.append(repr(obj.Tolerance.Value))
    if obj.MaxFaces != MAX_FACES:
        words.append("at most {} faces".format(obj.MaxFaces))
    if envelope_feature.is_envelope(source):
        words.append(source.InputHash)
    return hashlib.sha256("\n".join(words).encode()).hexdigest()[:32]


def update_status(obj):
    """Stale when the envelope's mesh changed, or when the envelope itself is stale."""
    now = input_hash(obj)
    if obj.InputHash and obj.InputHash == now:
        source_stale = envelope_feature.is_envelope(obj.Source) and obj.Source.Status != UP_TO_DATE
        set_changed(obj, "Status", STALE if source_stale else UP_TO_DATE)
    elif obj.InputHash:
        set_changed(obj, "Status", STALE)
    elif obj.Status != FAILED:
        set_changed(obj, "Status", NOT_COMPUTED)


class Request:
    """A mesh and how it becomes a solid; no document behind it."""

    def __init__(self, vertices, triangles, name, exact, settings):
        self.vertices = vertices
        self.triangles = triangles
        self.name = name
        self.exact = exact
        self.settings = settings

    def but(self, given):
        """The same mesh with other settings. Raises InputProblem."""
        wanted = dict(self.settings, **given)
        if self.exact and wanted["tolerance"] > 0 and not wanted["tessellated"]:
            raise InputProblem(
                translate(
                    "Messages",
                    "the envelope is conservative, and a solid with a tolerance could cut into the swept "
                    "volume: set the solid's Tolerance to 0.",
                )
            )
        return Request(self.vertices, self.triangles, self.name, self.exact, wanted)

    def options(self):
        """As the core takes them."""
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

    def estimate(self, control):
        """Any thread: triangles, faces, megabytes, seconds. Raises core.CoreError."""
        if core.has_solids():
            return core.estimate_solid(self.vertices, self.triangles, control, **self.options())
        count = len(self.triangles)  # of each a face
        return {
            "triangles": count,
            "faces": count,
            "megabytes": faceted.MEGABYTES * count,
            "seconds": faceted.SECONDS * count,
        }

    def write(self, path, control):
        """Writes STEP or BREP by suffix; returns the core's report (dict). Raises core.CoreError."""
        if not core.has_solids():
            return faceted.write(self.vertices, self.triangles, path, self.settings["max_faces"])
        return core.write_solid(
            self.vertices, self.triangles, path, control, product_name=self.name, **self.options()
        )


def request_for(source, world=False, **given):
    """Reads a mesh object. `world`: vertices in world coordinates (export), else in its own frame;
    given: what differs from DEFAULTS.

    The solid of a conservative envelope is exact: simplified it could cut into the swept volume."""
    if source is None or not can_be_source(source):
        raise InputProblem(
            translate(
                "Messages", "compute the envelope first: there is no mesh to make a solid of."
            )
        )
    exact = envelope_feature.is_envelope(source) and bool(source.Conservative)
    vertices, triangles = convert.arrays_from_mesh(source.Mesh)
    if world:
        placement = convert.global_placement(*convert.root_path(source))
        vertices = convert.transform(convert.matrix_of(placement), vertices)
    return Request(vertices, triangles, source.Label, exact, DEFAULTS).but(given)


def settings(obj):
    """What a solid object says about solids, as request_for() takes it."""
    return dict(
        DEFAULTS,
        merge=bool(obj.MergeCoplanar),
        max_faces=int(obj.MaxFaces),
        tolerance=obj.Tolerance.Value,
    )


def set_settings(obj, wanted):
    """The way back: writes them into a solid object."""
    set_changed(obj, "MergeCoplanar", wanted["merge"])
    set_changed(obj, "MaxFaces", wanted["max_faces"])
    if obj.Tolerance.Value != wanted["tolerance"]:
        obj.Tolerance = wanted["tolerance"]


def request(obj):
    return request_for(obj.Source, **settings(obj))


def work(req, control):
    """Any thread: returns (BREP file, report). The caller removes the file."""
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
    shape.Placement = obj.Source.Placement
    obj.Shape = shape
    obj.Faces = len(shape.Faces)
    # The kernel's own figure is less exact where profiles were pushed along a direction.
    obj.Volume = report.get("volume") or shape.Volume
    obj.Deviation = report["deviation"]
    obj.Message = ""
    obj.InputHash = hash_at_start
    update_status(obj)


def fail(obj, text):
    obj.Status = FAILED
    obj.Message = text


def compute(obj, control=None):
    """Makes the solid in this thread (scripts, no GUI): one undo step."""
    hash_at_start = input_hash(obj)
    value = work(request(obj), control or core.Control())
    obj.Document.openTransaction(translate("Messages", "Make solid"))
    apply(obj, value, hash_at_start)
    obj.purgeTouched()
    obj.Document.commitTransaction()
    return value[1]


def make_solid(document, source, label=None, **settings):
    """A solid object, not yet computed."""
    obj = document.addObject(TYPE, "EnvelopeSolid")
    Solid(obj)
    obj.Label = label or translate("Messages", "{0} solid").format(source.Label)
    obj.Source = source
    for name, value in settings.items():
        setattr(obj, name, value)
    attach_view(obj, "sweptvolume.views.solid_view:SolidView")
    return obj
