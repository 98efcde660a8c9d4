# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a clearance check looks at, read off an object or a panel: moving parts, neighbours, settings -> the
input of the core as plain arrays."""
import hashlib
import json

from .. import contents, convert
from ..convert import InputProblem
from ..texts import translate
from . import containers, missing, neighbour_rules, status
from . import envelope as envelope_feature
from .base import kind_of, set_changed
from .moving import Moving


class Neighbour:
    """A part that stands still: name, convert.Body, how far its triangles may leave its surface (mm),
    where it is in the document (root, sub), and its rule."""

    def __init__(self, name, body, chord, pair, rule):
        self.name = name
        self.body = body
        self.chord = chord
        self.pair = pair
        self.rule = rule  # neighbour_rules.Rule


class Request:
    """Input of one check as plain arrays, no document behind it."""

    def __init__(self, body, neighbours, all_visible, options, points, notes, ignored=()):
        self.body = body  # core.Request
        self.neighbours = neighbours
        self.all_visible = all_visible
        self.options = options
        self.points = points  # of the envelope, to be coloured; may be None
        self.notes = notes
        self.ignored = list(ignored)  # names of neighbours that are not looked at

    def rows(self):
        """Any thread: (name, vertices, triangles, chord, rule as text or None) of the neighbours. One of
        which no triangles can be had is left out with a note where all that are visible are taken. Raises
        InputProblem."""
        rows, kept = [], []
        for n in self.neighbours:
            try:
                arrays = n.body.vertices, n.body.triangles
                rows.append((n.name, *arrays, n.chord, n.rule.text()))
                kept.append(n)
            except InputProblem as problem:
                if not self.all_visible:
                    raise
                self.notes.append(_left_out(problem))
        if not rows:
            raise _no_neighbour()
        self.neighbours = kept
        return rows


#: Kinds of results that stand in the document as parts do.
_RESULTS = (envelope_feature.Envelope.KIND, "SweptVolume::Solid")


def _left_out(problem):
    return translate("Messages", "Left out: {0}").format(problem)


def _no_neighbour():
    return InputProblem(
        translate("Messages", "no neighbour is given: choose parts or show some others.")
    )


def _all_ignored():
    return InputProblem(
        translate("Messages", "the rules ignore every neighbour: leave at least one to be checked.")
    )


def _short(words):
    return hashlib.sha256("\n".join(words).encode()).hexdigest()[:32]


def _has_geometry(obj):
    """Whether an object may show solids or meshes: by itself, as a group or as a link."""
    names = ("Shape", "Mesh", "Group", "LinkedObject", "ElementList")
    return hasattr(obj, "Visibility") and any(hasattr(obj, name) for name in names)


def _linked(root, path):
    return root.getSubObject(path, retType=1).getLinkedObject(True)


def _parts(root, sub):
    """(root, path) of all solids and meshes below a path; the object itself, where it is a single one,
    whatever it is."""
    if root.getSubObject(sub, retType=1) is None:
        convert.leaves(root, sub)  # raises
    found = convert.leaves(root, sub)
    if len(found) == 1 and found[0][1] == sub:
        return [(root, sub)]
    return [(root, path) for linked, path in found if convert.solid_like(linked)]


def _place_of(obj):
    return convert.global_placement(*convert.root_path(obj))


class Plan:
    """What is to be checked. Reads documents only in the thread of the GUI."""

    SETTINGS = ("Required", "Tolerance", "Deflection")

    def __init__(
        self, document, pairs, motion, neighbours, all_visible, values, envelope=None, rules=None
    ):
        self.document = document
        self.pairs = list(pairs)
        self.motion = motion
        self.neighbours = list(neighbours)
        self.all_visible = all_visible
        self.values = dict(values)
        self.envelope = envelope
        self.rules = dict(rules or {})  # {(root, sub): neighbour_rules.Rule}
        self.lost = ""  # what was deleted that the object needs
        self._words = None

    @classmethod
    def of(cls, obj):
        source = obj.Envelope if envelope_feature.is_envelope(obj.Envelope) else obj
        plan = cls(
            obj.Document,
            convert.pairs_of(source.Generators),
            source.Motion,
            convert.pairs_of(obj.Neighbours),
            obj.AllVisible,
            {name: getattr(obj, name).Value for name in cls.SETTINGS},
            obj.Envelope,
        )
        plan.lost = missing.text(obj)
        try:
            plan.rules = neighbour_rules.read(obj)
        except InputProblem as problem:
            plan.lost = plan.lost or str(problem)
        return plan

    def write(self, obj):
        """Puts the plan into a clearance object."""
        missing.forget(obj)
        obj.Envelope = self.envelope
        if self.envelope is None:
            containers.set_pairs(obj, "Generators", self.pairs)
            obj.Motion = self.motion
        containers.set_pairs(obj, "Neighbours", self.neighbours)
        obj.AllVisible = self.all_visible
        neighbour_rules.write(obj, self.rules)
        for name, value in self.values.items():
            set_changed(obj, name, value)

    def objects(self):
        """Document objects that a run needs to its end."""
        found = [root for root, _ in self.pairs] + [self.motion, self.envelope]
        return [obj for obj in found if obj is not None]

    def moving(self):
        """The moving parts. Raises InputProblem where each has a motion of its own."""
        if self.lost:
            raise InputProblem(self.lost)
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

    def candidates(self):
        """What AllVisible looks at, hidden or not: objects that stand in the document by themselves.

        Not the document's RootObjects: those are what no other object uses in any way."""
        return [
            o
            for o in self.document.Objects
            if not kind_of(o) and _has_geometry(o) and not containers.is_held(o)
        ]

    def leaves(self):
        """(root, path) of every neighbour, each solid or mesh by itself, without the moving parts.
        Raises InputProblem where something was chosen that cannot be checked."""
        found = self._all_visible() if self.all_visible else self._chosen()
        if not found:
            raise _no_neighbour()
        return found

    def _chosen(self):
        found = []
        for root, sub in self.neighbours:
            below = [pair for pair in _parts(root, sub) if not self._moves(*pair)]
            if not below:
                raise self._not_checked(root, sub)
            found += [pair for pair in below if pair not in found]
        return found

    def _all_visible(self):
        found = []
        for root in self.candidates():
            if root.Visibility:
                found += [
                    (r, path)
                    for r, path in _parts(root, "")
                    if not kind_of(_linked(r, path)) and not self._moves(r, path)
                ]
        return found

    def left_out(self):
        """Notes on results of ours that stand there: AllVisible does not take them, they may be chosen."""
        if not self.all_visible:
            return []
        labels = [
            o.Label
            for o in self.document.Objects
            if kind_of(o) in _RESULTS and o.Visibility and not self._is_own(o)
        ]
        if not labels:
            return []
        return [
            translate(
                "Messages",
                "Left out: {0} (envelopes and their solids are checked where they are chosen as "
                "neighbours).",
            ).format(", ".join('"{}"'.format(label) for label in labels))
        ]

    def _is_own(self, obj):
        """Whether an envelope or solid is the sweep of the moving parts themselves."""
        while kind_of(obj) == _RESULTS[1] and obj.Source is not None:
            obj = obj.Source
        return obj is self.envelope or getattr(obj, "Motion", None) is self.moving().motion

    def _not_checked(self, root, sub):
        label = convert.label_of(root, sub)
        if any(self._moves(*pair) for pair in _parts(root, sub)):
            return InputProblem(
                translate(
                    "Messages",
                    '"{0}" is chosen as a neighbour and is a moving part itself: choose another one.',
                ).format(label)
            )
        return InputProblem(
            translate("Messages", '"{0}" holds neither a solid nor a mesh.').format(label)
        )

    def _moves(self, root, path):
        return any(root is r and path.startswith(s) for r, s in self.pairs)

    def hash(self):
        """Short text that stands for all the result depends on; "" while inputs are unusable."""
        return status.hash_or_problem(self.checked_hash)[0]

    def words(self):
        """Of all the result depends on, as it was when this was first asked (contents.words()). Raises
        InputProblem that says why the inputs are unusable."""
        if self._words is None:
            # Undo brings objects back in another order.
            beside = sorted(self.leaves(), key=lambda pair: (pair[0].Name, pair[1]))
            words = self.moving().words() + contents.words(beside) + [self._settings()]
            if neighbour_rules.words(self.rules):
                words.append(neighbour_rules.words(self.rules))
            if self.envelope is not None:  # whose points are coloured
                words.append(contents.apart.of(self.envelope))
                words.append(contents.matrices(convert.matrix_of(_place_of(self.envelope))))
            self._words = words
        return self._words

    def checked_hash(self):
        """As hash(); raises InputProblem that says why the inputs are unusable. Any thread, where the words
        were prepared for that."""
        return status.VERSION + _short(contents.texts(self.words()))

    def hash_of_before(self):
        """As version 1 had it; raises InputProblem."""
        words = self.moving().words_of_before()
        return _short(words + [contents.signature_of_before(self.leaves()), self._settings()])

    def _settings(self):
        return json.dumps(contents.steady(self.values), sort_keys=True)

    def request(self):
        """The check as plain arrays. Raises InputProblem."""
        moving = self.moving()
        deflection = max(float(self.values["Deflection"]), 1e-4)
        straight = 0.5 * float(self.values["Tolerance"])
        body = moving.body_request(deflection, straight, {})
        chord = chord_of(self.pairs, deflection)
        if moving.curved():
            chord += straight
        neighbours, notes, ignored = self.still_parts(deflection)
        off, text = moving.hidden()
        if off > float(self.values["Tolerance"]):
            notes.append(text)
        if moving.motion.Message:
            notes.append(moving.motion.Message)
        if not neighbours:
            raise _all_ignored() if ignored else _no_neighbour()
        points = None
        if self.envelope is not None and self.envelope.Mesh.CountFacets:
            points = envelope_arrays(self.envelope)[0]
        return Request(
            body,
            neighbours,
            self.all_visible,
            {
                "required": float(self.values["Required"]),
                "tolerance": float(self.values["Tolerance"]),
                "body_chord": chord,
            },
            points,
            notes,
            ignored,
        )

    def still_parts(self, deflection):
        """(neighbours as plain values, notes on what was left out, names of the ignored). Raises
        InputProblem."""
        neighbours, notes, ignored = [], self.left_out(), []
        for pair in self.leaves():
            name = convert.label_of(*pair)
            rule = neighbour_rules.of(self.rules, *pair)
            neighbour_rules.check(rule, name)
            if rule.kind == neighbour_rules.IGNORE:
                ignored.append(name)
                continue
            try:
                part = convert.body_from([pair], deflection)
            except InputProblem as problem:
                if not self.all_visible:
                    raise
                notes.append(_left_out(problem))
                continue
            neighbours.append(Neighbour(name, part, chord_of([pair], deflection), pair, rule))
        return neighbours, notes, ignored


def chord_of(pairs, deflection):
    """How far (mm) the triangles of parts may leave them: meshes are what they are."""
    shapes = any(
        not linked.isDerivedFrom("Mesh::Feature")
        for root, sub in pairs
        for linked, _ in convert.leaves(root, sub)
    )
    return deflection if shapes else 0.0


def envelope_arrays(envelope):
    """World vertices and triangles of an envelope's mesh."""
    vertices, triangles = convert.arrays_from_mesh(envelope.Mesh)
    return convert.transform(convert.matrix_of(_place_of(envelope)), vertices), triangles
