# SPDX-License-Identifier: LGPL-2.1-or-later
"""Envelope: the swept volume of generators along a motion, a mesh in the document.

`execute` never computes: it compares the inputs with those of the stored result and marks it stale.
A run is three steps: prepare() reads the document (GUI thread), what it returns works on plain arrays
(any thread), apply() writes the result (GUI thread).
"""
import hashlib
import json

import numpy as np

from .. import convert, core
from ..convert import InputProblem
from ..core_texts import said
from ..texts import mark, translate
from ..trajectory.poses import swept_box
from . import containers, kept, missing, status
from .base import (  # noqa: F401 (the states are read from here as well)
    CANCELLED,
    FAILED,
    HIDDEN,
    NOT_COMPUTED,
    READ_ONLY,
    STALE,
    UP_TO_DATE,
    Feature,
    attach_view,
    kind_of,
    quietly,
    stored,
)
from .envelope_properties import ACCURACY, BACKENDS, COMPONENTS, INPUT, PLACED, RESULT
from .motion import is_motion, set_parts
from .moving import Moving

TYPE = "Mesh::FeaturePython"

#: Findings that only tell what was done.
NOTES = {
    "Welded",
    "PositionFiltered",
    "Mended",
    "SpecksDropped",
    "ShellsTurned",
    "CavitiesKept",
    "Offset",
    "Conservative",
    "CpuSampler",
}
#: What is read of a stored report.
REPORT = {
    "cell": float,
    "backend": str,
    "simplification_deviation": float,
    "warnings": [{"code": str, "text": str}],
}
#: About as many cells as a grid can have along a side; the core says exactly.
MOST_CELLS = 8000
#: Straight pieces of a smooth motion leave it by at most this part of a cell.
STRAIGHT = 0.02

containers.watch()
missing.watch()


class Envelope(Feature):
    """Proxy of the envelope."""

    KIND = "SweptVolume::Envelope"

    def properties(self):
        result = [(k, n, "Result", text, None, READ_ONLY) for k, n, text in RESULT]
        hidden = [
            ("App::PropertyString", name, "Result", text, None, HIDDEN)
            for name, text in (
                ("Report", mark("Properties", "Report of the run (JSON)")),
                ("InputHash", mark("Properties", "Inputs of the stored result")),
                ("TriedHash", mark("Properties", "Inputs of the last run that gave nothing")),
                (missing.PROPERTY, mark("Properties", "Inputs that were deleted (JSON)")),
            )
        ]
        hidden.append(PLACED)
        return INPUT + ACCURACY + result + hidden

    def __init__(self, obj):
        super().__init__(obj)
        obj.Status = NOT_COMPUTED

    def execute(self, obj):
        """Marks the result stale or current; keeps the mesh."""
        update_status(obj)

    look = execute

    def onChanged(self, obj, name):
        missing.changed(obj, name)

    def onDocumentRestored(self, obj):
        of_before = "Placed" not in obj.PropertiesList
        with quietly(obj):
            super().onDocumentRestored(obj)
            containers.shorten(obj)  # documents of before may have circles
            if of_before:
                status.remember_place(obj)
                plan = Plan.of(obj)
                status.renew(obj, status.hash_or_problem(plan.hash_of_before)[0], plan.hash())


def is_envelope(obj):
    return kind_of(obj) == Envelope.KIND


class Plan:
    """What is to be computed: generators, motions, reference, values of the settings by property name.

    Made from an object or from a panel, anew for each use; reads documents only in the thread of the
    GUI.
    motions: one for each of pairs, or empty; reference: (root, sub).
    """

    SETTINGS = [name for _, name, *_ in ACCURACY]

    def __init__(self, pairs, motion, values, motions=(), reference=None, reference_motion=None):
        self.lost = ""  # what was deleted that the object needs
        self.pairs = list(pairs)
        self.motion = motion
        self.values = dict(values)
        self.motions = list(motions) if any(m is not motion for m in motions) else []
        self.reference = reference
        self.reference_motion = reference_motion
        self._words = None  # of the parts and motions, as they were when first asked

    @classmethod
    def of(cls, obj):
        values = {name: getattr(obj, name) for name in cls.SETTINGS}
        for name, value in values.items():
            values[name] = getattr(value, "Value", value)
        seen_from = convert.pairs_of(obj.Reference)
        plan = cls(
            convert.pairs_of(obj.Generators),
            obj.Motion,
            values,
            obj.Motions,
            seen_from[0] if seen_from else None,
            obj.ReferenceMotion,
        )
        plan.lost = missing.text(obj)
        return plan

    def write(self, obj):
        """Puts the plan into an envelope object."""
        missing.forget(obj)
        containers.set_pairs(obj, "Generators", self.pairs)
        obj.Motion = self.motion
        obj.Motions = self.motions
        self.tell_motions()
        containers.set_pairs(obj, "Reference", [self.reference] if self.reference else [])
        obj.ReferenceMotion = self.reference_motion
        for name, value in self.values.items():
            if getattr(getattr(obj, name), "Value", getattr(obj, name)) != value:
                setattr(obj, name, value)

    def tell_motions(self):
        """Motions that know no part yet learn which ones they move."""
        for motion in {m.Name: m for m in self.motions or [self.motion] if m is not None}.values():
            if is_motion(motion):
                own = zip(self.pairs, self.motions or [self.motion] * len(self.pairs))
                set_parts(motion, [pair for pair, m in own if m is motion])

    def objects(self):
        """Document objects that a run needs to its end."""
        found = [root for root, _ in self.pairs] + [self.motion, self.reference_motion]
        found += self.motions + ([self.reference[0]] if self.reference else [])
        return [obj for obj in found if obj is not None]

    def groups(self):
        """Parts that move together: list of Moving. Raises InputProblem."""
        if self.lost:
            raise InputProblem(self.lost)
        if self.motions and len(self.motions) != len(self.pairs):
            raise InputProblem(
                translate(
                    "Messages",
                    "{0} moving parts and {1} motions of their own: give one for each part, or none.",
                ).format(len(self.pairs), len(self.motions))
            )
        reference = (self.reference, self.reference_motion)
        groups = []
        for pair, motion in zip(self.pairs, self.motions or [self.motion] * len(self.pairs)):
            for group in groups:
                if group.motion is motion:
                    group.pairs.append(pair)
                    break
            else:
                groups.append(Moving([pair], motion, *reference))
        return groups or [Moving([], self.motion, *reference)]

    def options(self):
        """Settings as the core takes them."""
        v = self.values
        return {
            "resolution": int(v["Resolution"]),
            "cell": float(v["CellSize"]),
            "tolerance": float(v["Tolerance"]),
            "offset": float(v["Offset"]),
            "conservative": bool(v["Conservative"]),
            "position_filter": float(v["PositionFilter"]),
            "keep_cavities": bool(v["KeepCavities"]),
            "components": COMPONENTS[v["Components"]],
            "backend": BACKENDS[v["Backend"]],
        }

    def hash(self, without=()):
        """Short text that stands for all the result depends on; "" while inputs are unusable. without:
        options that are left out."""
        return status.hash_or_problem(lambda: self.checked_hash(without))[0]

    def checked_hash(self, without=()):
        """As hash(); raises InputProblem that says why the inputs are unusable."""
        if self._words is None:
            self._words = [word for group in self.groups() for word in group.words()]
        return status.VERSION + self._hash(self._words, without)

    def hash_of_before(self):
        """As version 1 had it; raises InputProblem."""
        return self._hash([word for group in self.groups() for word in group.words_of_before()])

    def _hash(self, inputs, without=()):
        options = self.options()
        for name in ("backend",) + tuple(without):  # the surface is the same whoever computes it
            del options[name]
        if not options["position_filter"]:
            del options["position_filter"]  # so are those made before there was one
        words = [json.dumps(options, sort_keys=True), repr(self.values["MeshDeflection"])]
        return hashlib.sha256("\n".join(words + inputs).encode()).hexdigest()[:32]

    def cell(self, groups):
        """Edge of a cell (mm): as given, or from the resolution and the boxes of the parts."""
        if self.values["CellSize"] > 0:
            return float(self.values["CellSize"])
        low, high = np.full(3, np.inf), np.full(3, -np.inf)
        for group in groups:
            poses = group.trajectory(np.inf)[0]
            box = swept_box(group.corners(), poses.placements)
            low, high = np.minimum(low, box[0]), np.maximum(high, box[1])
        return max(float((high - low).max()) / max(self.values["Resolution"], 1), 1e-9)

    def requests(self):
        """One run for each group of parts that move together, no document behind them."""
        groups, options = self.groups(), self.options()
        cell = self.cell(groups)
        if any(np.ptp(g.corners(), axis=0).max() > MOST_CELLS * cell for g in groups):
            self.estimate()  # refused by the core, before solids get triangles for such a cell
        if len(groups) > 1:
            options.update(cell=cell, tolerance=0.0)
            if options["keep_cavities"]:
                raise InputProblem(
                    translate(
                        "Messages",
                        "cavities cannot be kept where parts have motions of their own: make one "
                        "envelope for each motion.",
                    )
                )
        deflection = max(self.values["MeshDeflection"], 1e-3) * cell
        return [g.body_request(deflection, STRAIGHT * cell, options) for g in groups]

    def coarse_requests(self, cells):
        """As requests(), of a quick look: `cells` along the longest side, nothing simplified."""
        values = dict(
            self.values,
            Resolution=cells,
            CellSize=0.0,
            Tolerance=0.0,
            KeepCavities=False,
            MeshDeflection=0.25,
        )
        reference = self.reference, self.reference_motion
        return Plan(self.pairs, self.motion, values, self.motions, *reference).requests()

    def findings(self):
        """What is to be said of the motions themselves, as findings of a report: they hide more than a cell
        between two frames, or ended early."""
        groups, found = self.groups(), []
        cell = self.cell(groups)
        for group in groups:
            off, text = group.hidden()
            if off > cell:
                found.append({"code": "FramesFarApart", "text": text})
            if group.motion.Message:
                found.append({"code": "MotionIncomplete", "text": group.motion.Message})
        return found

    def union_options(self, requests):
        """Settings of the run that joins the envelopes of several groups."""
        return dict(
            self.options(), cell=requests[0].options["cell"], offset=0.0, position_filter=0.0
        )

    def estimate(self):
        """What the run would take, from the outermost points of the parts: dict of the core. Grid and cell
        are those of the run."""
        groups, options = self.groups(), self.options()
        if len(groups) > 1:
            options["cell"] = self.cell(groups)
        tolerance = STRAIGHT * self.cell(groups)
        found = [core.estimate(g.request(*g.outline(), tolerance, options)) for g in groups]
        most = max(found, key=lambda e: e["memory_bytes"])
        return dict(most, seconds=sum(e["seconds"] for e in found))


def work(requests, union_options, control, compute=core.compute):
    """Any thread: one envelope, or those of several groups and the outer surface of them all.

    `compute` runs one request. Raises core.CoreError.
    """
    if len(requests) == 1:
        return compute(requests[0], control)
    found = []
    for k, request in enumerate(requests):
        control.enter(k, len(requests) + 1)
        found.append(compute(request, control))
    control.enter(len(requests), len(requests) + 1)
    return core.join(found, union_options, control)


def prepare(plan, document):
    """Reads what a run needs; returns run(control) for any thread, which gives an Outcome.

    Where only the tolerance is not that of the last simplified result, that one is cut again.
    Raises InputProblem.
    """
    findings = plan.findings()
    key = plan.hash(without=("tolerance",))
    before = kept.find(document, key)
    if before is None:
        requests = plan.requests()
        union_options = plan.union_options(requests)

    def run(control):
        if before is None:
            found = work(requests, union_options, control)
        else:
            found = core.recut(before, plan.options()["tolerance"], control)
        found.key = key
        found.report["warnings"] = list(found.report["warnings"]) + findings
        return found

    return run


def can_recut(obj):
    """Whether a new tolerance made the stored result stale that can be cut again without sampling."""
    if not obj.InputHash:
        return False
    plan = Plan.of(obj)
    if plan.hash() == obj.InputHash:
        return False
    return kept.find(obj.Document, plan.hash(without=("tolerance",))) is not None


def update_status(obj):
    """Compares inputs and stored result."""
    plan = Plan.of(obj)
    now, problem = status.hash_or_problem(plan.checked_hash)
    if now and status.is_displaced(obj):
        now += " moved"
    waiting = any(map(status.is_behind, plan.objects() + convert.targets(plan.pairs)))
    status.judge(obj, now, problem, waiting, notes_of(obj))


def notes_of(obj):
    """What is to be said of the stored result."""
    report = report_of(obj) if obj.Report else None
    return "\n".join(w["text"] for w in warnings_of(report)) if report else ""


def report_of(obj):
    """The stored report (dict); None if there is none, or a damaged one."""
    return stored(obj.Report, REPORT)


def warnings_of(report):
    """The findings of a report that ask for attention, in the user's language; all are kept in the
    property Report."""
    found = [w for w in report["warnings"] if w["code"] not in NOTES]
    return [dict(w, text=said(w["code"], w["text"])) for w in found]


def apply(obj, outcome, hash_at_start):
    """Writes the result of a run that ended Ok."""
    mesh = outcome.mesh or convert.mesh_from_arrays(outcome.vertices, outcome.triangles)
    mesh.Placement = status.outer_inverse(obj).multiply(mesh.Placement)
    obj.Mesh = mesh
    status.remember_place(obj)
    report = outcome.report
    obj.Volume = report["volume"]
    obj.Area = report["area"]
    obj.Triangles = int(report["triangles"])
    obj.Shells = int(report["shells"])
    obj.SelfIntersections = int(report.get("self_intersections", -1))
    obj.UsedCellSize = report["cell"]
    obj.Seconds = report["seconds"]["total"]
    obj.Report = json.dumps(report)
    obj.InputHash, obj.TriedHash = hash_at_start, ""
    kept.keep(obj.Document, outcome.key, outcome)
    update_status(obj)
    status.tell_users(obj)


def fail(obj, text, tried, cancelled=False):
    """Remembers a run that gave nothing; the stored mesh stays as it is. tried: hash of its inputs."""
    status.mark_failure(obj, Plan.of(obj).hash(), text, tried, cancelled)
    status.tell_users(obj)


def compute(obj, control=None):
    """Computes in this thread (scripts, no GUI): one undo step. Raises core.CoreError."""
    plan = Plan.of(obj)
    hash_at_start = plan.hash()
    document = obj.Document
    try:
        outcome = prepare(plan, document)(control or core.Control())
    except (core.CoreError, InputProblem) as error:
        fail(obj, str(error), hash_at_start, getattr(error, "status", "") == "Cancelled")
        raise
    document.openTransaction(translate("Messages", "Compute envelope"))
    apply(obj, outcome, hash_at_start)
    obj.purgeTouched()
    document.commitTransaction()
    return outcome


def pairs_of_items(generators):
    """Objects or (object, sub path) tuples -> (root, sub) pairs."""
    pairs = []
    for item in generators:
        if isinstance(item, (tuple, list)):
            pairs.append((item[0], convert.split_path(item[0], item[1])))
        else:
            pairs.append(convert.root_path(item))
    return pairs


def make_envelope(document, generators, motion, label=None, **settings):
    """An envelope object, not yet computed. `settings` are property names with values."""
    obj = document.addObject(TYPE, "Envelope")
    Envelope(obj)
    obj.Label = label or translate("Messages", "Envelope")
    containers.set_pairs(obj, "Generators", pairs_of_items(generators))
    obj.Motion = motion
    for name, value in settings.items():
        setattr(obj, name, value)
    Plan.of(obj).tell_motions()
    attach_view(obj, "sweptvolume.views.envelope_view:EnvelopeView")
    return obj
