# SPDX-License-Identifier: LGPL-2.1-or-later
"""Clearance: smallest distances of a moving part to its neighbours, kept in the document.

As with the envelope, `execute` only marks; a run is Plan.request() - work() - apply(). The distances
come from the true motion; the envelope, where one is given, is only coloured by them.
"""
import hashlib
import json

import numpy as np

from .. import convert, core
from ..convert import InputProblem
from ..core_texts import said
from ..texts import mark, translate
from . import containers
from . import envelope as envelope_feature
from . import motion as motion_feature
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
    mark_failure,
    mark_result,
    set_changed,
    stored,
)
from .moving import Moving

TYPE = "App::FeaturePython"

#: Verdict of the core -> what people read.
VERDICTS = {
    "clear": mark("Messages", "Clear"),
    "below": mark("Messages", "Too near"),
    "contact": mark("Messages", "Contact"),
    "clash": mark("Messages", "Clash"),
}
_POINT = (float, float, float)
#: What is read of a stored report.
REPORT = {
    "summary": str,
    "required": float,
    "neighbours": [
        {
            "name": str,
            "verdict": set(VERDICTS),
            "distance": float,
            "guaranteed": float,
            "time_seconds": float,
            "pose": {"translation": _POINT, "quaternion_xyzw": (float,) * 4},
            "point_on_body": _POINT,
            "point_on_neighbour": _POINT,
            "below": [(float, float)],
            "curve": [(float, float)],
        }
    ],
}
#: Columns of the exported table.
COLUMNS = [
    "Neighbour",
    "Verdict",
    "Distance (mm)",
    "Guaranteed (mm)",
    "Time (s)",
    "Depth (mm)",
    "Depth at most (mm)",
    "Too near for (s)",
    "Body X",
    "Body Y",
    "Body Z",
    "Neighbour X",
    "Neighbour Y",
    "Neighbour Z",
]

_INPUT = [
    (
        "App::PropertyLinkGlobal",
        "Envelope",
        mark("Properties", "Envelope whose parts and motion are checked, and which is coloured"),
        None,
    ),
    (
        "App::PropertyLinkSubListGlobal",
        "Generators",
        mark("Properties", "Parts that move together, where no envelope is given"),
        None,
    ),
    (
        "App::PropertyLinkGlobal",
        "Motion",
        mark("Properties", "Motion, where no envelope is given"),
        None,
    ),
    (
        "App::PropertyLinkSubListGlobal",
        "Neighbours",
        mark("Properties", "Parts that stand still, seen through groups and links"),
        None,
    ),
    (
        "App::PropertyBool",
        "AllVisible",
        mark("Properties", "Check all other visible parts instead of Neighbours"),
        True,
    ),
    ("App::PropertyLength", "Required", mark("Properties", "Distance asked for"), 5.0),
    (
        "App::PropertyLength",
        "Tolerance",
        mark("Properties", "How far the smallest distance may be off between two poses"),
        0.01,
    ),
    (
        "App::PropertyLength",
        "Deflection",
        mark(
            "Properties",
            "Chord error to which solids are meshed; it is subtracted from the distances",
        ),
        0.05,
    ),
]
_RESULT = [
    ("App::PropertyString", "Status", mark("Properties", "State of the result"), READ_ONLY),
    (
        "App::PropertyString",
        "Message",
        mark("Properties", "Why the last run failed; notes"),
        READ_ONLY,
    ),
    ("App::PropertyString", "Summary", mark("Properties", "Result in one line"), READ_ONLY),
    ("App::PropertyInteger", "Checked", mark("Properties", "Neighbours checked"), READ_ONLY),
    ("App::PropertyLength", "Smallest", mark("Properties", "Smallest distance"), READ_ONLY),
    ("App::PropertyString", "Report", mark("Properties", "Report of the run (JSON)"), HIDDEN),
    (
        "App::PropertyFloatList",
        "MapDistances",
        mark("Properties", "Distance at each point"),
        HIDDEN,
    ),
    ("App::PropertyString", "InputHash", mark("Properties", "Inputs of the stored result"), HIDDEN),
    (
        "App::PropertyString",
        "TriedHash",
        mark("Properties", "Inputs of the last run that gave nothing"),
        HIDDEN,
    ),
]

containers.watch()


class Clearance(Feature):
    """Proxy of the clearance check."""

    KIND = "SweptVolume::Clearance"

    def properties(self):
        given = [(k, n, "Input", text, default, 0) for k, n, text, default in _INPUT]
        return given + [(k, n, "Result", text, None, mode) for k, n, text, mode in _RESULT]

    def __init__(self, obj):
        super().__init__(obj)
        obj.Status = NOT_COMPUTED

    def execute(self, obj):
        """Marks the result stale or current; keeps it."""
        update_status(obj)

    def onDocumentRestored(self, obj):
        super().onDocumentRestored(obj)
        containers.shorten(obj)  # documents of before may have circles


def is_clearance(obj):
    return kind_of(obj) == Clearance.KIND


class Neighbour:
    """A part that stands still: name and world triangles (mm)."""

    def __init__(self, name, vertices, triangles, chord):
        self.name = name
        self.vertices = vertices
        self.triangles = triangles
        self.chord = chord


class Request:
    """Input of one check as plain arrays, no document behind it."""

    def __init__(self, body, neighbours, options, points, notes):
        self.body = body  # core.Request
        self.neighbours = neighbours
        self.options = options
        self.points = points  # of the envelope, to be coloured; may be None
        self.notes = notes


def _held(obj):
    """Whether a group or a link array holds an object and shows it."""
    lists = [getattr(user, "Group", []) + getattr(user, "ElementList", []) for user in obj.InList]
    return any(obj in held for held in lists)


class Plan:
    """What is to be checked. Reads documents only in the thread of the GUI."""

    SETTINGS = ("Required", "Tolerance", "Deflection")

    def __init__(self, document, pairs, motion, neighbours, all_visible, values, envelope=None):
        self.document = document
        self.pairs = list(pairs)
        self.motion = motion
        self.neighbours = list(neighbours)
        self.all_visible = all_visible
        self.values = dict(values)
        self.envelope = envelope

    @classmethod
    def of(cls, obj):
        source = obj.Envelope if envelope_feature.is_envelope(obj.Envelope) else obj
        return cls(
            obj.Document,
            convert.pairs_of(source.Generators),
            source.Motion,
            convert.pairs_of(obj.Neighbours),
            obj.AllVisible,
            {name: getattr(obj, name).Value for name in cls.SETTINGS},
            obj.Envelope,
        )

    def write(self, obj):
        """Puts the plan into a clearance object."""
        obj.Envelope = self.envelope
        if self.envelope is None:
            containers.set_pairs(obj, "Generators", self.pairs)
            obj.Motion = self.motion
        containers.set_pairs(obj, "Neighbours", self.neighbours)
        obj.AllVisible = self.all_visible
        for name, value in self.values.items():
            set_changed(obj, name, value)

    def objects(self):
        """Document objects that a run needs to its end."""
        found = [root for root, _ in self.pairs] + [self.motion, self.envelope]
        return [obj for obj in found if obj is not None]

    def moving(self):
        """The moving parts. Raises InputProblem where each has a motion of its own."""
        if self.envelope is None:
            return Moving(self.pairs, self.motion)
        if not envelope_feature.is_envelope(self.envelope):
            raise InputProblem(
                translate("Messages", '"{0}" is no envelope: choose another one.').format(
                    self.envelope.Label
                )
            )
        groups = envelope_feature.Plan.of(self.envelope).groups()
        if len(groups) > 1:
            raise InputProblem(
                translate(
                    "Messages",
                    'the parts of "{0}" have motions of their own: check each part with its motion.',
                ).format(self.envelope.Label)
            )
        return groups[0]

    def leaves(self):
        """(root, path) of every neighbour, each solid or mesh by itself, without the moving parts."""
        roots = self.neighbours
        if self.all_visible:
            # Not the document's RootObjects: those are what no other object uses in any way.
            roots = [(o, "") for o in self.document.Objects if o.Visibility and not _held(o)]
        found = []
        for root, sub in roots:
            target = root.getSubObject(sub, retType=1)
            if target is None or kind_of(target):
                continue
            for linked, path in convert.leaves(root, sub):
                if kind_of(linked) or (root, path) in found or self._moves(root, path):
                    continue
                if linked.isDerivedFrom("Mesh::Feature") or linked.Shape.Solids:
                    found.append((root, path))
        return found

    def _moves(self, root, path):
        return any(root is r and path.startswith(s) for r, s in self.pairs)

    def hash(self):
        """Short text that stands for all the result depends on; "" while inputs are unusable."""
        try:
            words = self.moving().words()
            words += [convert.signature(self.leaves()), json.dumps(self.values, sort_keys=True)]
        except (InputProblem, RuntimeError, AttributeError):
            return ""
        return hashlib.sha256("\n".join(words).encode()).hexdigest()[:32]

    def request(self):
        """The check as plain arrays. Raises InputProblem."""
        moving = self.moving()
        deflection = max(float(self.values["Deflection"]), 1e-4)
        straight = 0.5 * float(self.values["Tolerance"])
        body = moving.body_request(deflection, straight, {})
        chord = deflection if _has_shape(self.pairs) else 0.0
        if moving.curved():
            chord += straight
        neighbours, notes = self._neighbours(deflection)
        if not neighbours:
            raise InputProblem(
                translate("Messages", "no neighbour is given: choose parts or show some others.")
            )
        points = None
        if self.envelope is not None and self.envelope.Mesh.CountFacets:
            points = envelope_arrays(self.envelope)[0]
        return Request(
            body,
            neighbours,
            {
                "required": float(self.values["Required"]),
                "tolerance": float(self.values["Tolerance"]),
                "body_chord": chord,
            },
            points,
            notes,
        )

    def _neighbours(self, deflection):
        neighbours, notes = [], []
        for pair in self.leaves():
            name = convert.label_of(*pair)
            try:
                part = convert.body_from([pair], deflection)
            except InputProblem as problem:
                notes.append(translate("Messages", "Left out: {0}").format(problem))
                continue
            chord = deflection if _has_shape([pair]) else 0.0
            neighbours.append(Neighbour(name, part.vertices, part.triangles, chord))
        return neighbours, notes


def _has_shape(pairs):
    return any(
        not linked.isDerivedFrom("Mesh::Feature")
        for root, sub in pairs
        for linked, _ in convert.leaves(root, sub)
    )


def envelope_arrays(envelope):
    """World vertices and triangles of an envelope's mesh."""
    vertices, triangles = convert.arrays_from_mesh(envelope.Mesh)
    placement = convert.global_placement(*convert.root_path(envelope))
    return convert.transform(convert.matrix_of(placement), vertices), triangles


class Outcome:
    """Report (dict) and the distance at each point of the envelope (or None)."""

    def __init__(self, report, distances, notes):
        self.report = report
        self.distances = distances
        self.notes = notes


def work(request, control):
    """Any thread: the check itself. Raises core.CoreError."""
    neighbours = [(n.name, n.vertices, n.triangles, n.chord) for n in request.neighbours]
    report = core.clearance(request.body, neighbours, request.options, control)
    distances = None
    if request.points is not None:
        distances = np.full(len(request.points), np.inf)
        for n in request.neighbours:
            found = core.distance_to_mesh(request.points, n.vertices, n.triangles, control)
            distances = np.minimum(distances, found)
    return Outcome(report, distances, request.notes)


def apply(obj, outcome, hash_at_start):
    """Writes the result of a check."""
    report = outcome.report
    obj.Report = json.dumps(report)
    obj.Summary = report["summary"]
    obj.Checked = len(report["neighbours"])
    obj.Smallest = report["neighbours"][report["smallest"]]["distance"]
    obj.MapDistances = [] if outcome.distances is None else [float(d) for d in outcome.distances]
    obj.Message = "\n".join(
        outcome.notes + [said(w["code"], w["text"]) for w in report["warnings"]]
    )
    obj.InputHash = hash_at_start
    update_status(obj)


def fail(obj, text, tried, cancelled=False):
    """Remembers a run that gave nothing; the stored result stays. tried: hash of its inputs."""
    mark_failure(obj, Plan.of(obj).hash(), text, tried, cancelled)


def update_status(obj):
    """Compares inputs and stored result."""
    plan = Plan.of(obj)
    mark_result(obj, plan.hash(), any(motion_feature.is_stale(o) for o in plan.objects()))


def compute(obj, control=None):
    """Checks in this thread (scripts, no GUI): one undo step. Raises core.CoreError."""
    plan = Plan.of(obj)
    hash_at_start = plan.hash()
    try:
        outcome = work(plan.request(), control or core.Control())
    except (core.CoreError, InputProblem) as error:
        fail(obj, str(error), hash_at_start, getattr(error, "status", "") == "Cancelled")
        raise
    obj.Document.openTransaction(translate("Messages", "Check clearance"))
    apply(obj, outcome, hash_at_start)
    obj.purgeTouched()
    obj.Document.commitTransaction()
    return outcome.report


def report_of(obj):
    """The stored report (dict); None if there is none, or a damaged one."""
    return stored(obj.Report, REPORT)


def table(report):
    """The rows to export, as COLUMNS."""
    rows = []
    for row in report["neighbours"]:
        deep = row.get("penetration", {})
        rows.append(
            [
                row["name"],
                row["verdict"],
                row["distance"],
                row["guaranteed"],
                row["time_seconds"],
                deep.get("depth", 0.0),
                deep.get("depth_bound", 0.0),
                sum(b - a for a, b in row["below"]),
            ]
            + list(row["point_on_body"])
            + list(row["point_on_neighbour"])
        )
    return rows


def write_csv(report, path):
    """The table as a CSV file (UTF-8)."""
    import csv

    with open(path, "w", encoding="utf-8", newline="") as out:
        writer = csv.writer(out)
        writer.writerow(COLUMNS)
        writer.writerows(table(report))


def make_spreadsheet(obj):
    """The table as a spreadsheet in the document."""
    sheet = obj.Document.addObject("Spreadsheet::Sheet", "ClearanceTable")
    sheet.Label = translate("Messages", "{0} table").format(obj.Label)
    for r, row in enumerate([COLUMNS] + table(report_of(obj))):
        for c, value in enumerate(row):
            cell = "{}{}".format(chr(ord("A") + c), r + 1)
            sheet.set(cell, repr(value) if isinstance(value, float) else "'" + str(value))
    return sheet


def make_clearance(document, label=None, **settings):
    """A clearance object, not yet computed. `settings` are property names with values."""
    obj = document.addObject(TYPE, "Clearance")
    Clearance(obj)
    obj.Label = label or translate("Messages", "Clearance")
    for name, value in settings.items():
        setattr(obj, name, value)
    attach_view(obj, "sweptvolume.views.clearance_view:ClearanceView")
    return obj
