# SPDX-License-Identifier: LGPL-2.1-or-later
"""Reads the inputs of a clearance check from an object or a panel (moving parts, neighbours,
settings), and converts them to plain arrays for the core."""

from .. import contents, convert
from ..convert import InputProblem
from ..texts import translate
from . import containers, missing, neighbour_rules, renamed, row_names, status
from . import envelope as envelope_feature
from .base import set_changed
from .moving import BodyInFrame, Moving
from .still_parts import StillParts, chord_of, has_surface, left_out_text, listed, no_neighbour


class Request:
    """Input of one check as plain arrays, independent of any document."""

    def __init__(self, body, neighbours, all_visible, options, points, notes, ignored=()):
        self.body = body  # core.Request
        self.neighbours = neighbours
        self.all_visible = all_visible
        self.options = options
        self.points = points  # points of the envelope to be coloured, or None
        self.notes = notes
        self.ignored = list(ignored)  # [name, place] of the neighbours that the rules ignore

    def rows(self):
        """Returns (name, vertices, triangles, chord, rule as text or None) for each neighbour. Any
        thread. A neighbour without triangles is left out with a note if AllVisible is set;
        otherwise it raises InputProblem."""
        rows, kept = [], []
        for n in self.neighbours:
            try:
                arrays = n.body.vertices, n.body.triangles
                rows.append((n.name, *arrays, n.chord, n.rule.text()))
                kept.append(n)
            except InputProblem as problem:
                if not self.all_visible:
                    raise
                self.notes.append(left_out_text(problem))
        if not rows:
            raise no_neighbour()
        self.neighbours = kept
        return rows


def _all_ignored():
    return InputProblem(
        translate(
            "SweptVolume",
            "The rules ignore every neighbour, so there is nothing to check: change at "
            "least one rule.",
        )
    )


def _place_of(obj):
    return convert.global_placement(*convert.root_path(obj))


class Plan(StillParts):
    """The inputs of a check. Reads documents only in the GUI thread."""

    SETTINGS = ("RequiredDistance", "Accuracy", "MeshDeflection")

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
        self.lost = ""  # text about a deleted input, or ""
        self._words = None

    @classmethod
    def of(cls, obj):
        source = obj.Envelope if envelope_feature.is_envelope(obj.Envelope) else obj
        plan = cls(
            obj.Document,
            convert.pairs_of(source.MovingParts),
            source.Motion,
            convert.pairs_of(obj.Neighbours),
            obj.AllVisible,
            {name: getattr(obj, name).Value for name in cls.SETTINGS},
            obj.Envelope,
        )
        plan.rules = plan.rules_of(obj, neighbour_rules)
        return plan

    def write(self, obj):
        """Writes the plan into a clearance object."""
        missing.forget(obj)
        obj.Envelope = self.envelope
        if self.envelope is None:
            containers.set_pairs(obj, "MovingParts", self.pairs)
            obj.Motion = self.motion
        containers.set_pairs(obj, "Neighbours", self.neighbours)
        obj.AllVisible = self.all_visible
        neighbour_rules.write(obj, self.rules)
        for name, value in self.values.items():
            set_changed(obj, name, value)

    def objects(self):
        """Returns the document objects that a run needs until its end."""
        found = [root for root, _ in self.pairs] + [self.motion, self.envelope]
        return [obj for obj in found if obj is not None]

    def moving(self):
        """Returns the moving parts. Raises InputProblem if each part has its own motion."""
        if self.lost:
            raise InputProblem(self.lost)
        if self.envelope is None:
            return Moving(self.pairs, self.motion)
        if not envelope_feature.is_envelope(self.envelope):
            raise InputProblem(
                translate("SweptVolume", '"{0}" is not an envelope: choose an envelope.').format(
                    self.envelope.Label
                )
            )
        groups = envelope_feature.Plan.of(self.envelope).groups()
        if len(groups) > 1:
            raise InputProblem(
                translate(
                    "SweptVolume",
                    'Each part of "{0}" has its own motion: use Check mechanism, or check '
                    "each part with its motion.",
                ).format(self.envelope.Label)
            )
        return groups[0]

    def is_own(self, obj):
        return obj is self.envelope or getattr(obj, "Motion", None) is self.moving().motion

    def moved_too(self):
        """Returns the note about neighbours that the source of the motion also moves. In this check
        they stand still."""
        moved = set(self.moving().motion.MovedToo)
        names = []
        for root, sub in self.leaves() if moved else []:
            if moved.intersection(convert.targets((root, a) for a in convert.paths_to(sub))):
                names.append(convert.label_of(root, sub))
        if not names:
            return []
        text = translate(
            "SweptVolume",
            "These parts also moved when this motion was read, but stand still in "
            "this check: {0}. If they move at the same time, use Check mechanism.",
        )
        return [text.format(listed(names))]

    def seen(self):
        """Returns the same as mechanism_plan.Plan.seen(), but one entry for all moving parts
        together."""
        moving = self.moving()
        body = convert.body_from(self.pairs, self.seen_deflection())
        rigid = moving.rigid_motion()
        return [(BodyInFrame(body, rigid.into_base), rigid.course())]

    def rename(self, report):
        """Updates the names in the rows of a report to the present labels of the parts. Returns
        whether a name changed."""
        changed, ignored = False, row_names.placed(report, "ignored", "ignored_places")
        for k, (known, place) in enumerate(ignored):
            report["ignored"][k] = row_names.label_at(self.document, place, known)
            changed |= report["ignored"][k] != known
        for k, row in enumerate(report["neighbours"]):
            known = row["name"]
            row["name"] = row_names.label_at(self.document, row.get("place"), known)
            changed |= row["name"] != known
            if k == report.get("smallest"):
                row_names.rename_in_summary(report, known, row["name"])
        return changed

    def hash(self):
        """Returns a short text that identifies all inputs of the result, or "" if inputs are
        unusable."""
        return status.hash_or_problem(self.checked_hash)[0]

    def words(self):
        """Returns the words (contents.words()) of all inputs, in their state at the first call.
        Raises InputProblem, whose text says why the inputs are unusable."""
        if self._words is None:
            # Sorted, because undo restores objects in a different order.
            beside = sorted(self.leaves(), key=lambda pair: (pair[0].Name, pair[1]))
            words = self.moving().words() + contents.words(beside) + [self._settings()]
            if neighbour_rules.words(self.rules):
                words.append(neighbour_rules.words(self.rules))
            if self.envelope is not None:  # its points are coloured
                words.append(contents.apart.of(self.envelope))
                words.append(contents.matrices(convert.matrix_of(_place_of(self.envelope))))
            self._words = words
        return self._words

    def checked_hash(self):
        """Returns the same as hash(), but raises InputProblem if inputs are unusable; its text says
        why. Any thread may call this after contents.prepared() was called for the words."""
        return status.VERSION + contents.short(contents.texts(self.words()))

    def hash_of_before(self):
        """Returns the hash of version 1, which left out objects without a surface. Raises
        InputProblem."""
        words = self.moving().words_of_before()
        counted = [pair for pair in self.leaves() if has_surface(*pair)]
        return contents.short(words + [contents.signature_of_before(counted), self._settings()])

    def _settings(self):
        return renamed.hashed(contents.steady(self.values))

    def request(self):
        """Returns the check as plain arrays. Raises InputProblem."""
        moving = self.moving()
        deflection = max(float(self.values["MeshDeflection"]), 1e-4)
        straight = 0.5 * float(self.values["Accuracy"])
        rigid, parts = moving.rigid_motion(), convert.body_from(self.pairs, deflection)
        body = rigid.request(BodyInFrame(parts, rigid.into_base, moving.motion), straight, {})
        chord = chord_of(self.pairs, deflection) + (straight if rigid.curved() else 0.0)
        neighbours, notes, ignored = self.still_parts(deflection)
        notes += self.moved_too()
        off, text = rigid.frame_deviation()
        if off > float(self.values["Accuracy"]):
            notes.append(text)
        if moving.motion.Message:
            notes.append(moving.motion.Message)
        if not neighbours:
            raise _all_ignored() if ignored else no_neighbour()
        points = None
        if self.envelope is not None and self.envelope.Mesh.CountFacets:
            points = envelope_arrays(self.envelope)[0]
        return Request(
            body,
            neighbours,
            self.all_visible,
            {
                "required": float(self.values["RequiredDistance"]),
                "tolerance": float(self.values["Accuracy"]),
                "body_chord": chord,
            },
            points,
            notes,
            ignored,
        )


def envelope_arrays(envelope):
    """Returns vertices and triangles of an envelope's mesh in world coordinates."""
    vertices, triangles = convert.arrays_from_mesh(envelope.Mesh)
    return convert.transform(convert.matrix_of(_place_of(envelope)), vertices), triangles
