# SPDX-License-Identifier: LGPL-2.1-or-later
"""Reads the inputs of a mechanism check from an object or a panel (parts with their own motions,
parts that stand still, rules of pairs), and converts them to plain arrays for the core."""
import itertools

from .. import contents, convert
from ..convert import InputProblem
from ..quantities import number
from ..texts import translate
from ..trajectory.poses import Poses, at_time
from . import containers, missing, pair_rules, renamed, row_names, status
from . import motion as motion_feature
from .base import set_changed, whole
from .moving import BodyInFrame, grouped
from .still_parts import StillParts, chord_of, left_out_text


class Part:
    """A part of a mechanism. name: different for each part; pair: (root, sub); body: a
    convert.Body; chord: largest deviation of its triangles from its surface (mm); rigid: a
    moving.RigidMotion, or None if the part stands still; straight: largest deviation of straight segments
    from a curved path (mm)."""

    def __init__(self, name, pair, body, chord, rigid=None, straight=0.0):
        self.name, self.pair, self.body, self.chord = name, pair, body, chord
        self.place = row_names.place_of(*pair)
        self._rigid, self._straight = rigid, straight

    def moves(self):
        return self._rigid is not None

    @property
    def run(self):
        """Returns the motion as core.Request, or None if the part stands still. Any thread. Raises
        InputProblem."""
        return self._rigid.request(self.body, self._straight, {}) if self.moves() else None

    def row(self):
        """Returns the part as core.mechanism() takes it. Any thread. Raises InputProblem."""
        arrays = self.name, self.body.vertices, self.body.triangles
        run = self.run
        if run is None:
            return (*arrays, None, "linear", self.chord)
        motion = run.times, run.rotations, run.translations
        return (*arrays, motion, run.interpolation, self.chord)

    def points_at(self, time):
        """Returns the vertices in world coordinates at a time (s). Any thread may call it."""
        run = self.run
        if run is None:
            return self.body.vertices
        placements = convert.placements_from(run.translations, run.rotations)
        kind = "Screw" if run.interpolation == "screw" else "Linear"
        there = at_time(Poses(run.times, placements), kind, time)
        return convert.transform(convert.matrix_of(there), self.body.vertices)


class Request:
    """Input of one check as plain arrays, independent of any document."""

    def __init__(self, parts, rigid_motions, rules, all_visible, options, notes):
        self.parts = parts
        self.rigid_motions = rigid_motions  # a moving.RigidMotion for each group
        self.rules = rules  # {key of pair_rules: Rule}
        self.all_visible = all_visible
        self.options = options
        self.notes = notes

    def rows(self):
        """Returns the parts for the core. Any thread. If AllVisible is set, a part that stands
        still and gives no triangles is left out with a note; otherwise raises InputProblem."""
        rows, kept, far = [], [], [rigid.frame_deviation() for rigid in self.rigid_motions]
        self.notes[:0] = [text for off, text in far if off > self.options["tolerance"]]
        for part in self.parts:
            try:
                rows.append(part.row())
                kept.append(part)
            except InputProblem as problem:
                if part.moves() or not self.all_visible:
                    raise
                self.notes.append(left_out_text(problem))
        self.parts, self.notes = kept, list(dict.fromkeys(self.notes))
        return rows

    def own_rules(self):
        """Returns (name, name, rule) for the pairs that have their own rule."""
        found = []
        for one, other in itertools.combinations(self.parts if self.rules else [], 2):
            text = pair_rules.of(self.rules, one.pair, other.pair).text()
            if text is not None and (one.moves() or other.moves()):
                found.append((one.name, other.name, text))
        return found


class Plan(StillParts):
    """The inputs of a check. Reads documents only in the GUI thread. motions: one for each of
    pairs."""

    SETTINGS = ("RequiredDistance", "Accuracy", "MeshDeflection", "Range")

    def __init__(self, document, pairs, motions, neighbours, all_visible, values, rules=None):
        self.document = document
        self.pairs, self.motions = list(pairs), list(motions)
        self.neighbours, self.all_visible = list(neighbours), all_visible
        self.values = dict(values)
        self.rules = {}  # parts that stand still have no rules of their own
        self.pair_rules = dict(rules or {})
        self.lost = ""  # text about a deleted input, or ""
        self._words = None

    @classmethod
    def of(cls, obj):
        plan = cls(
            obj.Document,
            convert.pairs_of(obj.MovingParts),
            obj.Motions,
            convert.pairs_of(obj.Neighbours),
            obj.AllVisible,
            {name: getattr(obj, name).Value for name in cls.SETTINGS},
        )
        plan.pair_rules = plan.rules_of(obj, pair_rules)
        return plan

    def write(self, obj):
        """Writes the plan into an object."""
        missing.forget(obj)
        containers.set_pairs(obj, "MovingParts", self.pairs)
        set_changed(obj, "Motions", self.motions)
        containers.set_pairs(obj, "Neighbours", self.neighbours)
        set_changed(obj, "AllVisible", self.all_visible)
        pair_rules.write(obj, self.pair_rules)
        for name, value in self.values.items():
            set_changed(obj, name, value)

    def objects(self):
        """Returns the document objects that a run needs until its end."""
        found = [root for root, _ in self.pairs] + self.motions
        return [obj for obj in found if obj is not None]

    def is_own(self, obj):
        return getattr(obj, "Motion", None) in self.motions

    def leaves(self):
        """Returns (root, path) of the parts that stand still; the list may be empty. Raises
        InputProblem."""
        return super().leaves() if self._has_standing() else []

    def _has_standing(self):
        return bool(self._all_visible() if self.all_visible else self.neighbours)

    def groups(self):
        """Returns the parts that move together, as a list of Moving. Raises InputProblem if an
        input is missing or the check is impossible."""
        if self.lost:
            raise InputProblem(self.lost)
        if not self.pairs:
            raise InputProblem(convert.no_part_text())
        if len(self.motions) != len(self.pairs):
            text = translate(
                "SweptVolume",
                "There are {0} moving parts but {1} motions: give one motion for " "each part.",
            )
            raise InputProblem(text.format(len(self.pairs), len(self.motions)))
        self._check_parts()
        for pair, motion in zip(self.pairs, self.motions):
            if not motion_feature.is_motion(motion):
                text = translate("SweptVolume", '"{0}" has no motion: choose one in the table.')
                raise InputProblem(text.format(convert.label_of(*pair)))
        groups = grouped(self.pairs, self.motions)
        for group in groups:
            group.check()
        self._check_times([group.motion for group in groups])
        return groups

    def _check_parts(self):
        """Makes sure that no part is listed twice, and that no part lies inside another one with
        its own motion."""
        for (one, a), (other, b) in itertools.combinations(self.pairs, 2):
            if one is not other or not (a.startswith(b) or b.startswith(a)):
                continue
            names = convert.label_of(one, a), convert.label_of(other, b)
            if a == b:
                text = translate("SweptVolume", '"{0}" is in the list twice: remove one entry.')
            else:
                text = translate(
                    "SweptVolume",
                    '"{0}" and "{1}": one of them contains the other, so the inner part '
                    "would move twice. Remove one of them from the list.",
                )
            raise InputProblem(text.format(*names))

    def _check_times(self, motions):
        for motion in motions:
            if motion.Interpolation == "None":
                text = translate(
                    "SweptVolume",
                    '"{0}" has the interpolation None, so its part does not move between '
                    "its poses: choose another interpolation for parts that move at the "
                    "same time.",
                )
                raise InputProblem(text.format(motion.Label))
        late = max(motions, key=lambda m: m.Times[0] if m.Times else 0.0)
        early = min(motions, key=lambda m: m.Times[-1] if m.Times else 0.0)
        if late.Times and early.Times and late.Times[0] >= early.Times[-1] and late is not early:
            text = translate(
                "SweptVolume",
                'The motions do not overlap in time: "{0}" ends at {1} s, and "{2}" '
                "begins at {3} s. Change their times so that they overlap.",
            )
            begin, end = number(late.Times[0]), number(early.Times[-1])
            raise InputProblem(text.format(early.Label, end, late.Label, begin))

    # --- what the result depends on

    def hash(self):
        """Returns a short text that identifies all inputs of the result, or "" if inputs are
        unusable."""
        return status.hash_or_problem(self.checked_hash)[0]

    def words(self):
        """Returns the same as clearance_plan.Plan.words()."""
        if self._words is None:
            self._words = self._words_now()
        return self._words

    def _words_now(self):
        beside = sorted(self.leaves(), key=lambda pair: (pair[0].Name, pair[1]))
        words = [word for group in self.groups() for word in group.words()]
        words += contents.words(beside) if beside else []
        words.append(renamed.hashed(contents.steady(self.values)))
        words.append(pair_rules.words(self.pair_rules))
        return words

    def check_unchanged(self):
        """Raises InputProblem if the document has changed since the first call of words()."""
        if self.words() != self._words_now():
            text = translate(
                "SweptVolume",
                "The document changed while its parts were read: start the run again.",
            )
            raise InputProblem(text)

    def checked_hash(self):
        """Returns the same as clearance_plan.Plan.checked_hash()."""
        return status.VERSION + contents.short(contents.texts(self.words()))

    def count_pairs(self):
        """Returns the length of checked_pairs()."""
        count = len(self.pairs)
        return count * (count - 1) // 2 + count * len(self.leaves())

    def checked_pairs(self):
        """Returns the pair_rules keys of all pairs that are checked: at least one part of each pair
        moves."""
        moving, still = self.pairs, self.leaves()
        return [pair_rules.key(*pair) for pair in itertools.combinations(moving, 2)] + [
            pair_rules.key(*pair) for pair in itertools.product(moving, still)
        ]

    def names(self):
        """Returns {(root, sub): name} of all parts: their labels. Equal labels are numbered."""
        pairs = self.pairs + self.leaves()
        return dict(zip(pairs, convert.own_names(pairs)))

    def rename(self, report):
        """Updates the names in the pairs of a report to the present labels of the parts. Returns
        whether a name changed."""
        new = self._renamed(row_names.placed(report, "parts", "places"))
        if not new:
            return False
        report["parts"] = [new.get(known, known) for known in report["parts"]]
        for name in ("joined", "ignored"):
            report[name] = [[new.get(known, known) for known in both] for both in report[name]]
        for k, pair in enumerate(report["pairs"]):
            for side in ("first", "second"):
                pair[side] = new.get(pair[side], pair[side])
            row, name = pair["clearance"], "{} - {}".format(pair["first"], pair["second"])
            if k == report.get("smallest"):
                row_names.rename_in_summary(report, row["name"], name)
            row["name"] = name
        return True

    def _renamed(self, found):
        """Returns {name in a report: present name} for a list of (name, place). Returns an empty
        dict if no name changed."""
        pairs = {known: row_names.pair_at(self.document, place) for known, place in found}
        labels = {known: convert.label_of(*pair) for known, pair in pairs.items() if pair}
        if all(known == one or known.startswith(one + " (") for known, one in labels.items()):
            return {}
        names = self.names()
        return {known: names.get(pair, known) for known, pair in pairs.items()}

    # --- the run

    def request(self):
        """Returns the check as plain arrays. Raises InputProblem."""
        return whole(self.reading())

    def reading(self):
        """Does the same as request(), but in steps: a generator whose return value is the Request.
        Between two steps the window may handle events, but the document must not change
        (check_unchanged())."""
        deflection = max(float(self.values["MeshDeflection"]), 1e-4)
        tolerance = float(self.values["Accuracy"])
        parts, rigid_motions, notes, names = [], [], [], self.names()
        for group in self.groups():
            yield
            rigid_motions.append(group.rigid_motion())
            parts += self._moving_parts(
                group, rigid_motions[-1], names, deflection, 0.5 * tolerance
            )
            notes += [group.motion.Message] if group.motion.Message else []
        yield
        if self._has_standing():
            still, more, _ = self.still_parts(deflection)
            parts += [Part(names[n.pair], n.pair, n.body, n.chord) for n in still]
            notes += more
        if len(parts) < 2:
            raise InputProblem(
                translate(
                    "SweptVolume",
                    "Only one part is given: add a second part, either a moving part or a "
                    "neighbour.",
                )
            )
        options = {
            "required": float(self.values["RequiredDistance"]),
            "tolerance": tolerance,
            "range": float(self.values["Range"]),
        }
        return Request(parts, rigid_motions, self.pair_rules, self.all_visible, options, notes)

    def seen(self):
        """Returns, for each moving part, what the pictures of the check need: its coarse mesh (a
        BodyInFrame), and a function that returns its placement at a time (s). Raises
        InputProblem."""
        found, deflection = [], self.seen_deflection()
        for group in self.groups():
            rigid = group.rigid_motion()
            course = rigid.course()
            for pair in group.pairs:
                body = BodyInFrame(convert.body_from([pair], deflection), rigid.into_base)
                found.append((pair, (body, course)))
        order = {pair: seen for pair, seen in found}
        return [order[pair] for pair in self.pairs]

    def _moving_parts(self, group, rigid, names, deflection, straight):
        """Returns the parts of one motion. straight: the largest distance (mm) between a curved
        path and the straight segments that approximate it."""
        parts, more = [], straight if rigid.curved() else 0.0
        for pair in group.pairs:
            body = BodyInFrame(convert.body_from([pair], deflection), rigid.into_base, group.motion)
            chord = chord_of([pair], deflection) + more
            parts.append(Part(names[pair], pair, body, chord, rigid, straight))
        return parts
