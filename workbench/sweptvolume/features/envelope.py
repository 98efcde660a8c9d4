# SPDX-License-Identifier: LGPL-2.1-or-later
"""Envelope: the swept volume of moving parts, a mesh in the document.

`execute` never computes: it compares the inputs with those of the stored result and marks the
result as stale. A run has three steps: prepare() reads the document (GUI thread), the function that
it returns works on plain arrays (any thread), apply() writes the result (GUI thread).
"""
import json

from .. import contents, convert, core, joined
from ..convert import InputProblem
from ..core_texts import said
from ..texts import QT_TRANSLATE_NOOP, translate
from . import containers, kept, made_by, missing, status
from .base import (  # noqa: F401 (the states are read from here as well)
    CANCELLED,
    FAILED,
    HIDDEN,
    NOT_COMPUTED,
    READ_ONLY,
    STALE,
    UP_TO_DATE,
    Result,
    attach_view,
    kind_of,
    quietly,
    stored,
)
from .envelope_plan import Plan
from .envelope_properties import ACCURACY, INPUT, PLACED, RESULT

TYPE = "Mesh::FeaturePython"

#: Findings that only describe what was done.
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
#: The entries of a stored report that are used, with their shapes (base.fits()).
REPORT = {
    "cell": float,
    "backend": str,
    "simplification_deviation": float,
    "warnings": [{"code": str, "text": str}],
}

containers.watch()
missing.watch()


class Envelope(Result):
    """Proxy of the envelope."""

    KIND = "SweptVolume::Envelope"

    def properties(self):
        result = [(k, n, "Result", text, None, READ_ONLY) for k, n, text in RESULT]
        hidden = [
            ("App::PropertyString", name, "Result", text, None, HIDDEN)
            for name, text in (
                ("Report", QT_TRANSLATE_NOOP("App::Property", "Report of the run (JSON)")),
                (
                    "InputHash",
                    QT_TRANSLATE_NOOP(
                        "App::Property", "Checksum of the inputs of the stored result"
                    ),
                ),
                (
                    "TriedHash",
                    QT_TRANSLATE_NOOP(
                        "App::Property", "Checksum of the inputs of the last failed run"
                    ),
                ),
                (
                    missing.PROPERTY,
                    QT_TRANSLATE_NOOP("App::Property", "Inputs that were deleted (JSON)"),
                ),
                (
                    made_by.PROPERTY,
                    QT_TRANSLATE_NOOP(
                        "App::Property",
                        "Record of which face or edge made each triangle (compressed)",
                    ),
                ),
            )
        ]
        hidden.append(PLACED)
        return INPUT + ACCURACY + result + hidden

    def execute(self, obj):
        """Marks the result as stale or current, and keeps the mesh."""
        update_status(obj)

    refresh_status = execute

    def onChanged(self, obj, name):
        missing.changed(obj, name)
        made_by.changed(obj, name)

    def onDocumentRestored(self, obj):
        from_old_version = "Placed" not in obj.PropertiesList
        with quietly(obj):
            super().onDocumentRestored(obj)
            containers.shorten(obj)  # documents of earlier versions may have circular links
            if from_old_version:
                status.remember_place(obj)
                plan = Plan.of(obj)
                status.renew(obj, status.hash_or_problem(plan.hash_of_before)[0], plan.hash())


def is_envelope(obj):
    return kind_of(obj) == Envelope.KIND


def work(requests, union_options, control, compute=core.compute):
    """Computes one envelope. For several groups of parts, computes an envelope for each and the
    outer surface of all. Any thread.

    `compute` runs one request. Raises core.CoreError.
    """
    if len(requests) == 1:
        return compute(requests[0], control)
    found = []
    for k, request in enumerate(requests):
        control.enter(k, len(requests) + 1)
        found.append(compute(request, control))
    control.enter(len(requests), len(requests) + 1)
    return joined.join(found, union_options, control)


def prepare(plan, document):
    """Reads what a run needs. Returns a function run(control) for any thread, which returns an
    Outcome.

    If the inputs differ from the last simplified result only in the tolerance, that result is
    simplified again. Raises InputProblem.
    """
    findings = plan.findings()
    known = not contents.unread(plan.words())  # kept.find() needs parts that were read
    before = kept.find(document, plan.hash(without=("tolerance",))) if known else None
    if before is not None and plan.records() and not core.has_sources(before):
        before = None
    if before is None:
        requests = plan.requests()
        union_options = plan.union_options(requests)

    def run(control):
        if before is None:
            found = work(requests, union_options, control)
        else:
            found = core.recut(before, plan.options()["tolerance"], control)
        found.key = plan.hash(without=("tolerance",))
        found.report["warnings"] = list(found.report["warnings"]) + findings
        return found

    return run


def can_recut(obj):
    """Returns whether the stored result is stale only because of a new tolerance, and can be
    simplified again without sampling."""
    if not obj.InputHash:
        return False
    plan = Plan.of(obj)
    unread = contents.unread(status.hash_or_problem(plan.words)[0])
    if unread or plan.hash() == obj.InputHash:  # no surface is kept for parts that were not read
        return False
    return kept.find(obj.Document, plan.hash(without=("tolerance",))) is not None


def update_status(obj):
    """Compares the present inputs with those of the stored result."""
    plan = Plan.of(obj)
    now, problem, waits = status.inputs_of(obj, plan.words, plan.checked_hash)
    if waits:
        return
    if now and status.is_displaced(obj):
        now += " moved"
    waiting = any(map(status.is_behind, plan.objects() + convert.targets(plan.pairs)))
    status.judge(obj, now, problem, waiting, notes_of(obj))


def notes_of(obj):
    """Returns the notes to show for the stored result."""
    report = report_of(obj) if obj.Report else None
    return "\n".join(w["text"] for w in warnings_of(report)) if report else ""


def report_of(obj):
    """Returns the stored report (dict), or None if there is none or it is damaged."""
    return stored(obj.Report, REPORT)


def warnings_of(report):
    """Returns the findings of a report that the user should see, in the user's language. The
    property Report keeps all findings."""
    found = [w for w in report["warnings"] if w["code"] not in NOTES]
    return [dict(w, text=said(w["code"], w["text"])) for w in found]


def apply(obj, outcome, hash_at_start):
    """Writes the result of a successful run into the object."""
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
    obj.AccuracyBound = report.get("accuracy_bound", 0.0)
    obj.Seconds = report["seconds"]["total"]
    obj.Report = json.dumps(report)
    obj.InputHash, obj.TriedHash = hash_at_start, ""
    made_by.keep(obj, outcome)
    kept.keep(obj.Document, outcome.key, outcome)
    update_status(obj)
    status.update_users(obj)


def fail(obj, text, tried, cancelled=False):
    """Stores the error of a run without a result; the stored mesh is kept. tried: hash of the
    inputs of the run."""
    status.mark_failure(obj, Plan.of(obj).hash, text, tried, cancelled)
    status.update_users(obj)


def compute(obj, control=None):
    """Computes in this thread (for scripts without a GUI) as one undo step. Raises core.CoreError."""
    plan = Plan.of(obj)
    hash_at_start = plan.hash()
    document = obj.Document
    try:
        outcome = prepare(plan, document)(control or core.Control())
    except (core.CoreError, InputProblem) as error:
        fail(obj, str(error), hash_at_start, getattr(error, "status", "") == "Cancelled")
        raise
    document.openTransaction(translate("SweptVolume", "Compute envelope"))
    apply(obj, outcome, hash_at_start)
    obj.purgeTouched()
    document.commitTransaction()
    return outcome


def pairs_of_items(generators):
    """Converts objects or (object, sub path) tuples to (root, sub) pairs."""
    pairs = []
    for item in generators:
        if isinstance(item, (tuple, list)):
            pairs.append((item[0], convert.split_path(item[0], item[1])))
        else:
            pairs.append(convert.root_path(item))
    return pairs


def make_envelope(document, generators, motion, label=None, **settings):
    """Creates an envelope, not yet computed. `settings`: property names with values."""
    obj = document.addObject(TYPE, "Envelope")
    Envelope(obj)
    obj.Label = label or translate("SweptVolume", "Envelope")
    containers.set_pairs(obj, "MovingParts", pairs_of_items(generators))
    obj.Motion = motion
    for name, value in settings.items():
        setattr(obj, name, value)
    Plan.of(obj).assign_parts()
    attach_view(obj, "sweptvolume.views.envelope_view:EnvelopeView")
    return obj
