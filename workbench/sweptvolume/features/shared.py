# SPDX-License-Identifier: LGPL-2.1-or-later
"""Shared volume: the space that two sides have in common, as a mesh in the document. A side
consists of parts, envelopes or their solids. If a side has a motion, its pose at a given time is
used (core: docs/overlap.md).

As with the envelope, `execute` only updates the state. A run consists of Plan.request(), work() and
apply().
"""
from .. import contents, convert, core, core_overlap
from ..convert import InputProblem
from ..quantities import TABLE_DIGITS, quantity
from ..texts import translate
from . import containers, missing, renamed, status
from .base import (  # noqa: F401 (the states are read from here as well)
    NOT_COMPUTED,
    STALE,
    UP_TO_DATE,
    Result,
    attach_view,
    kind_of,
    quietly,
    set_changed,
)
from .moving import BodyInFrame, Moving
from .shared_properties import PROPERTIES
from .still_parts import chord_of

TYPE = "Mesh::FeaturePython"
#: mm; smaller distances count as contact.
TOLERANCE = 0.01

containers.watch()
missing.watch()


class Shared(Result):
    """Proxy of the shared volume."""

    KIND = "SweptVolume::Shared"

    def properties(self):
        return PROPERTIES

    def execute(self, obj):
        """Marks the result as stale or current, and keeps the mesh."""
        update_status(obj)

    refresh_status = execute

    def onChanged(self, obj, name):
        missing.changed(obj, name)

    def onDocumentRestored(self, obj):
        with quietly(obj):
            super().onDocumentRestored(obj)


def is_shared(obj):
    return kind_of(obj) == Shared.KIND


class Request:
    """Input of one run: two sides, each (name, body, chord error in mm), independent of any
    document."""

    def __init__(self, first, second):
        self.first, self.second = first, second

    def rows(self):
        """Returns the sides as core_overlap.shared() takes them. Any thread. Raises
        InputProblem."""
        return [
            (name, body.vertices, body.triangles, chord)
            for name, body, chord in (self.first, self.second)
        ]


class Plan:
    """The inputs of a run. Reads documents only in the GUI thread. motions: of both sides, None for
    a side that stands still."""

    def __init__(self, document, first, second, motions=(None, None), time=0.0, deflection=0.05):
        self.document = document
        self.sides = list(first), list(second)
        self.motions = tuple(motions)
        self.time, self.deflection = float(time), float(deflection)
        self.lost = ""  # text about a deleted input, or ""
        self._words = None

    @classmethod
    def of(cls, obj):
        sides = convert.pairs_of(obj.MovingParts), convert.pairs_of(obj.Neighbours)
        motions = obj.Motion, obj.NeighbourMotion
        plan = cls(obj.Document, *sides, motions, obj.Time, obj.MeshDeflection.Value)
        plan.lost = missing.text(obj)
        return plan

    def write(self, obj):
        """Writes the plan into an object."""
        missing.forget(obj)
        containers.set_pairs(obj, "MovingParts", self.sides[0])
        containers.set_pairs(obj, "Neighbours", self.sides[1])
        set_changed(obj, "Motion", self.motions[0])
        set_changed(obj, "NeighbourMotion", self.motions[1])
        set_changed(obj, "Time", self.time)
        set_changed(obj, "MeshDeflection", self.deflection)

    def pairs(self):
        """Returns (root, sub) of both sides."""
        return self.sides[0] + self.sides[1]

    def objects(self):
        """Returns the document objects that a run needs until its end."""
        return [root for root, _ in self.pairs()] + [
            motion for motion in self.motions if motion is not None
        ]

    def names(self):
        """Returns the labels of both sides."""
        return [", ".join(convert.label_of(*pair) for pair in side) for side in self.sides]

    def hash(self):
        """Returns a short text that identifies all inputs of the result, or "" if inputs are
        unusable."""
        return status.hash_or_problem(self.checked_hash)[0]

    def words(self):
        """Returns the same as clearance_plan.Plan.words()."""
        if self._words is None:
            self._check()
            words = []
            for side, motion in zip(self.sides, self.motions):
                moves = motion is not None
                words += Moving(side, motion).words() if moves else contents.words(side)
                words.append("|")
            settings = {"Time": self.time, "MeshDeflection": self.deflection}
            words.append(renamed.hashed(contents.steady(settings)))
            self._words = words
        return self._words

    def checked_hash(self):
        """Returns the same as clearance_plan.Plan.checked_hash()."""
        return status.VERSION + contents.short(contents.texts(self.words()))

    def _check(self):
        if self.lost:
            raise InputProblem(self.lost)
        if not all(self.sides):
            raise InputProblem(
                translate(
                    "SweptVolume", "A shared volume needs two sides: choose two parts or envelopes."
                )
            )
        for pair in self.sides[0]:
            if pair in self.sides[1]:
                text = translate(
                    "SweptVolume", '"{0}" is on both sides: choose another object for one of them.'
                )
                raise InputProblem(text.format(convert.label_of(*pair)))

    def request(self):
        """Returns both sides as plain values. Raises InputProblem."""
        self._check()
        names = self.names()
        if names[0] == names[1]:  # both sides have the same name
            names[1] += " (2)"
        deflection = max(self.deflection, 1e-4)
        found = []
        for name, side, motion in zip(names, self.sides, self.motions):
            body = convert.body_from(side, deflection)
            if motion is not None:
                moving = Moving(side, motion)
                there = convert.matrix_of(moving.course()(self.time))
                body = BodyInFrame(body, there @ moving.into_base(), motion)
            found.append((name, body, chord_of(side, deflection)))
        return Request(*found)


class Outcome:
    """row: the core's result for the pair (dict); the shared volume, as arrays."""

    def __init__(self, row, vertices, triangles):
        self.row, self.vertices, self.triangles = row, vertices, triangles
        self.mesh = convert.mesh_from_arrays(vertices, triangles) if len(triangles) else None


def work(request, control):
    """Runs the core, in any thread. Raises core.CoreError, InputProblem."""
    return Outcome(*core_overlap.shared(*request.rows(), {"tolerance": TOLERANCE}, control))


def apply(obj, outcome, hash_at_start):
    """Writes the result of a run into the object."""
    import Mesh

    mesh = outcome.mesh or Mesh.Mesh()
    mesh.Placement = status.outer_inverse(obj).multiply(mesh.Placement)
    obj.Mesh = mesh
    status.remember_place(obj)
    row = outcome.row["clearance"]
    obj.Volume = outcome.row["volume"]
    obj.Distance = row["distance"]
    obj.Depth = row.get("penetration", {}).get("depth", 0.0)
    obj.InputHash, obj.TriedHash = hash_at_start, ""
    update_status(obj)
    status.update_users(obj)


def notes_of(obj):
    """Returns the notes to show for the stored result."""
    if not obj.InputHash or obj.Mesh.CountFacets:
        return ""
    text = translate(
        "SweptVolume",
        "The two compared objects or groups share no volume. The smallest distance between them "
        "is {0}.",
    )
    return text.format(quantity(obj.Distance.Value, TABLE_DIGITS))


def update_status(obj):
    """Compares the present inputs with those of the stored result."""
    plan = Plan.of(obj)
    now, problem, waits = status.inputs_of(obj, plan.words, plan.checked_hash)
    if waits:
        return
    if now and status.is_displaced(obj):
        now += " moved"
    used = plan.objects() + convert.targets(plan.pairs())
    status.judge(obj, now, problem, any(map(status.is_behind, used)), notes_of(obj))


def fail(obj, text, tried, cancelled=False):
    """Stores the error of a run without a result; the stored mesh is kept. tried: hash of the
    inputs of the run."""
    status.mark_failure(obj, Plan.of(obj).hash, text, tried, cancelled)
    status.update_users(obj)


def compute(obj, control=None):
    """Computes in this thread (for scripts without a GUI) as one undo step, and returns the
    outcome. Raises core.CoreError, InputProblem."""
    plan = Plan.of(obj)
    hash_at_start = plan.hash()
    try:
        outcome = work(plan.request(), control or core.Control())
    except (core.CoreError, InputProblem) as error:
        fail(obj, str(error), hash_at_start, getattr(error, "status", "") == "Cancelled")
        raise
    obj.Document.openTransaction(translate("SweptVolume", "Shared volume"))
    apply(obj, outcome, hash_at_start)
    obj.purgeTouched()
    obj.Document.commitTransaction()
    return outcome


def make_shared(document, first=(), second=(), label=None, **settings):
    """Creates a shared volume, not yet computed. first, second: (root, sub) pairs; `settings`:
    property names with values."""
    obj = document.addObject(TYPE, "SharedVolume")
    Shared(obj)
    obj.Label = label or translate("SweptVolume", "Shared volume")
    containers.set_pairs(obj, "MovingParts", list(first))
    containers.set_pairs(obj, "Neighbours", list(second))
    for name, value in settings.items():
        setattr(obj, name, value)
    attach_view(obj, "sweptvolume.views.shared_view:SharedView")
    return obj
