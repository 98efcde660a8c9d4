# SPDX-License-Identifier: LGPL-2.1-or-later
"""Envelope: the swept volume of generators along a motion, a mesh in the document.

`execute` never computes: it compares the inputs with those of the stored result and marks it stale.
A run is three steps: request() reads the document (GUI thread), core.compute() works on plain arrays
(any thread), apply() writes the result (GUI thread).
"""
import hashlib
import json

import FreeCAD as App
import numpy as np

from .. import convert, core
from ..convert import InputProblem
from ..texts import mark, translate
from ..trajectory.poses import INTERPOLATIONS, in_frame, swept_box
from . import motion as motion_feature
from .base import HIDDEN, READ_ONLY, Feature, attach_view, kind_of, set_changed

TYPE = "Mesh::FeaturePython"

#: States of the result. Stored as they are; views translate them.
NOT_COMPUTED = mark("Messages", "Not computed")
UP_TO_DATE = mark("Messages", "Up to date")
STALE = mark("Messages", "Stale")
CANCELLED = mark("Messages", "Cancelled")
FAILED = mark("Messages", "Failed")

#: Name in the property -> name the core knows.
COMPONENTS = {
    "Consistent": "consistent",
    "DualContouring": "dc",
    "DualMarchingCubes": "dmc",
    "Equivalence": "equivalence",
    "Greedy": "greedy",
}
BACKENDS = {"Auto": "auto", "CPU": "cpu", "GPU": "gpu"}

_INPUT = [
    (
        "App::PropertyLinkSubListGlobal",
        "Generators",
        "Input",
        mark("Properties", "Solids and meshes that move together, seen through groups and links"),
        None,
        0,
    ),
    (
        "App::PropertyLinkGlobal",
        "Motion",
        "Input",
        mark("Properties", "Motion of the parts"),
        None,
        0,
    ),
]
_ACCURACY = [
    (
        "App::PropertyInteger",
        "Resolution",
        "Accuracy",
        mark("Properties", "Cells along the longest side of the sweep; used while CellSize is 0"),
        128,
        0,
    ),
    (
        "App::PropertyLength",
        "CellSize",
        "Accuracy",
        mark("Properties", "Edge of a cell of the sampling grid; 0: from Resolution"),
        None,
        0,
    ),
    (
        "App::PropertyFloat",
        "MeshDeflection",
        "Accuracy",
        mark("Properties", "How far the triangles of a solid may leave it, in cells"),
        0.1,
        0,
    ),
    (
        "App::PropertyLength",
        "Tolerance",
        "Accuracy",
        mark("Properties", "Simplification: largest deviation allowed; 0: none"),
        None,
        0,
    ),
    (
        "App::PropertyLength",
        "Offset",
        "Accuracy",
        mark("Properties", "Safety distance by which the envelope is grown"),
        None,
        0,
    ),
    (
        "App::PropertyBool",
        "Conservative",
        "Accuracy",
        mark("Properties", "The envelope provably contains the swept volume"),
        None,
        0,
    ),
    (
        "App::PropertyBool",
        "KeepCavities",
        "Accuracy",
        mark("Properties", "Keep sealed hollow spaces as inner shells"),
        None,
        0,
    ),
    (
        "App::PropertyEnumeration",
        "Components",
        "Method",
        mark("Properties", "How surface pieces inside one cell are told apart"),
        list(COMPONENTS),
        0,
    ),
    (
        "App::PropertyEnumeration",
        "Backend",
        "Method",
        mark("Properties", "Where the sampling runs"),
        list(BACKENDS),
        0,
    ),
]
_RESULT = [
    ("App::PropertyString", "Status", mark("Properties", "State of the result")),
    ("App::PropertyString", "Message", mark("Properties", "Why the last run failed; warnings")),
    ("App::PropertyVolume", "Volume", mark("Properties", "Volume of the envelope")),
    ("App::PropertyArea", "Area", mark("Properties", "Area of the envelope")),
    ("App::PropertyInteger", "Triangles", mark("Properties", "Triangles of the envelope")),
    ("App::PropertyInteger", "Shells", mark("Properties", "Closed surfaces of the envelope")),
    (
        "App::PropertyInteger",
        "SelfIntersections",
        mark("Properties", "Pairs of triangles that cross each other; -1: not counted"),
    ),
    ("App::PropertyLength", "UsedCellSize", mark("Properties", "Edge of a cell in this result")),
    ("App::PropertyFloat", "Seconds", mark("Properties", "Duration of the run (s)")),
]


class Envelope(Feature):
    """Proxy of the envelope."""

    KIND = "SweptVolume::Envelope"

    def properties(self):
        result = [(k, n, "Result", text, None, READ_ONLY) for k, n, text in _RESULT]
        hidden = [
            ("App::PropertyString", name, "Result", text, None, HIDDEN)
            for name, text in (
                ("Report", mark("Properties", "Report of the run (JSON)")),
                ("InputHash", mark("Properties", "Inputs of the stored result")),
            )
        ]
        return _INPUT + _ACCURACY + result + hidden

    def __init__(self, obj):
        super().__init__(obj)
        obj.Status = NOT_COMPUTED

    def execute(self, obj):
        """Marks the result stale or current; keeps the mesh."""
        update_status(obj)


def is_envelope(obj):
    return kind_of(obj) == Envelope.KIND


class Plan:
    """What is to be computed: generators, motion, values of the settings by property name.

    Made from an object or from a panel; reads documents only in the thread of the GUI.
    """

    SETTINGS = [name for _, name, *_ in _ACCURACY]

    def __init__(self, pairs, motion, values):
        self.pairs = list(pairs)
        self.motion = motion
        self.values = dict(values)

    @classmethod
    def of(cls, obj):
        values = {name: getattr(obj, name) for name in cls.SETTINGS}
        for name, value in values.items():
            values[name] = getattr(value, "Value", value)
        return cls(convert.pairs_of(obj.Generators), obj.Motion, values)

    def write(self, obj):
        """Puts the plan into an envelope object."""
        obj.Generators = self.pairs
        obj.Motion = self.motion
        for name, value in self.values.items():
            if getattr(getattr(obj, name), "Value", getattr(obj, name)) != value:
                setattr(obj, name, value)

    def options(self):
        """Settings as the core takes them."""
        v = self.values
        return {
            "resolution": int(v["Resolution"]),
            "cell": float(v["CellSize"]),
            "tolerance": float(v["Tolerance"]),
            "offset": float(v["Offset"]),
            "conservative": bool(v["Conservative"]),
            "keep_cavities": bool(v["KeepCavities"]),
            "components": COMPONENTS[v["Components"]],
            "backend": BACKENDS[v["Backend"]],
        }

    def hash(self):
        """Short text that stands for all the result depends on; "" while inputs are unusable."""
        motion = self.motion
        if not self.pairs or motion is None or not motion_feature.is_motion(motion):
            return ""
        options = self.options()
        del options["backend"]  # the surface is the same whoever computes it
        try:
            words = [convert.signature(self.pairs), json.dumps(options, sort_keys=True)]
        except (InputProblem, RuntimeError, AttributeError):
            return ""
        words.append(repr(self.values["MeshDeflection"]))
        words += [motion.Interpolation, motion.Frame, repr([round(t, 9) for t in motion.Times])]
        for placement in motion.Placements:
            words.append(np.array2string(convert.matrix_of(placement), precision=9))
        return hashlib.sha256("\n".join(words).encode()).hexdigest()[:32]

    def _placements(self):
        if self.motion is None or not motion_feature.is_motion(self.motion):
            raise InputProblem(
                translate("Messages", "no motion is given: make one with New motion and choose it.")
            )
        if not self.pairs:
            raise InputProblem(convert.no_part_text())
        poses = motion_feature.poses_of(self.motion)
        standing = convert.global_placement(*self.pairs[0])
        placements, base = in_frame(poses, self.motion.Frame, standing)
        return poses.times, placements, convert.matrix_of(base.inverse())

    def _request(self, vertices, triangles, times, placements):
        translations, rotations = convert.pose_arrays(placements)
        return core.Request(
            vertices,
            triangles,
            np.array(times, dtype=float),
            translations,
            rotations,
            INTERPOLATIONS[self.motion.Interpolation],
            self.options(),
        )

    def request(self):
        """The run as plain arrays, no document behind it."""
        times, placements, into_base = self._placements()
        cell = self.values["CellSize"]
        if cell <= 0:
            corners = convert.transform(into_base, convert.box_corners(self.pairs))
            low, high = swept_box(corners, placements)
            cell = max(float((high - low).max()) / max(self.values["Resolution"], 1), 1e-9)
        deflection = max(self.values["MeshDeflection"], 1e-3) * cell
        body = convert.body_from(self.pairs, deflection)
        vertices = convert.transform(into_base, body.vertices)
        return self._request(vertices, body.triangles, times, placements)

    def estimate(self):
        """What the run would take, from the boxes of the parts alone: dict of the core."""
        times, placements, into_base = self._placements()
        corners = convert.transform(into_base, convert.box_corners(self.pairs))
        return core.estimate(self._request(corners, convert.BOX_TRIANGLES, times, placements))


def update_status(obj):
    """Compares inputs and stored result. A failure stays readable until the inputs change."""
    now = Plan.of(obj).hash()
    if obj.InputHash and obj.InputHash == now:
        set_changed(obj, "Status", UP_TO_DATE)
    elif obj.InputHash:
        set_changed(obj, "Status", STALE)
    elif obj.Status not in (FAILED, CANCELLED):
        set_changed(obj, "Status", NOT_COMPUTED)


def apply(obj, outcome, hash_at_start):
    """Writes the result of a run that ended Ok."""
    mesh = convert.mesh_from_arrays(outcome.vertices, outcome.triangles)
    mesh.Placement = _inside_groups(obj)
    obj.Mesh = mesh
    report = outcome.report
    obj.Volume = report["volume"]
    obj.Area = report["area"]
    obj.Triangles = int(report["triangles"])
    obj.Shells = int(report["shells"])
    obj.SelfIntersections = int(report["self_intersections"])
    obj.UsedCellSize = report["cell"]
    obj.Seconds = report["seconds"]["total"]
    obj.Report = json.dumps(report)
    obj.Message = "\n".join(w["text"] for w in report.get("warnings", []))
    obj.InputHash = hash_at_start
    update_status(obj)


def fail(obj, text, cancelled=False):
    """Remembers a run that gave nothing; the stored mesh stays as it is."""
    obj.Status = CANCELLED if cancelled else FAILED
    obj.Message = text


def _inside_groups(obj):
    """The envelope stands in world coordinates: undo the placement of groups around it."""
    try:
        outer = obj.getGlobalPlacement().multiply(obj.Placement.inverse())
    except AttributeError:
        return App.Placement()
    return outer.inverse()


def compute(obj, control=None):
    """Computes in this thread (scripts, no GUI): one undo step. Raises core.CoreError."""
    plan = Plan.of(obj)
    hash_at_start = plan.hash()
    document = obj.Document
    try:
        outcome = core.compute(plan.request(), control or core.Control())
    except (core.CoreError, InputProblem) as error:
        fail(obj, str(error), getattr(error, "status", "") == "Cancelled")
        raise
    document.openTransaction(translate("Messages", "Compute envelope"))
    apply(obj, outcome, hash_at_start)
    obj.purgeTouched()
    document.commitTransaction()
    return outcome


def links_of(generators):
    """Objects or (object, sub path) tuples -> value of the property Generators."""
    links = []
    for item in generators:
        if isinstance(item, (tuple, list)):
            root, sub = item[0], item[1]
            links.append((root, convert.split_path(root, sub)))
        else:
            links.append(convert.root_path(item))
    return links


def make_envelope(document, generators, motion, label=None, **settings):
    """An envelope object, not yet computed. `settings` are property names with values."""
    obj = document.addObject(TYPE, "Envelope")
    Envelope(obj)
    obj.Label = label or translate("Messages", "Envelope")
    obj.Generators = links_of(generators)
    obj.Motion = motion
    for name, value in settings.items():
        setattr(obj, name, value)
    attach_view(obj, "sweptvolume.views.envelope_view:EnvelopeView")
    return obj
