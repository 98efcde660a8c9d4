# SPDX-License-Identifier: LGPL-2.1-or-later
"""Reads the inputs of a sequence from an object or a panel (parts in their order, each with a
motion or a search, and parts that stand still), and converts them to plain values for the core.

The goal of a part without a motion is its present placement. The poses of a new path are poses of
the part's middle, as in path_plan."""
import itertools
import math

from .. import contents, convert
from ..convert import InputProblem, matrix_of
from ..texts import translate
from ..trajectory.poses import shift_to
from . import mechanism_plan, pair_rules, path_plan, renamed, row_names, still_parts
from .base import UP_TO_DATE
from .mechanism_plan import Part
from .moving import BodyInFrame, Moving, middle_of

#: Values of a search that the object does not store. Out: distance (mm) by which a part must be
#: removed. MostMoves: as in the command-line program; 0: no limit.
SEARCH = {
    "Order": "given",
    "Out": 100.0,
    "TranslationOnly": False,
    "LargestTurn": 180.0,
    "Budget": 60.0,
    "Seed": 1,
    "MostMoves": 0,
}


class Row:
    """One part. part: mechanism_plan.Part. pivot (of the new poses) and goal (4,4): None unless a
    path is searched for."""

    def __init__(self, part, pivot=None, goal=None):
        self.part, self.pivot, self.goal = part, pivot, goal

    def row(self, out):
        """Returns the part as the core takes it. Any thread."""
        name, vertices, triangles, motion, interpolation, chord = self.part.row()
        extract = out if motion is None else None
        ends = self.goal, None, extract, []
        return (name, vertices, triangles, chord, *ends, motion, interpolation)


class Request:
    """Input of one search, independent of any document. rows: a Row for each part; still: a Part
    for each part that stands still."""

    def __init__(self, rows, still, rules, search, options, notes):
        self.rows, self.still, self.rules = rows, still, rules
        self.search, self.options, self.notes = search, options, notes

    def parts(self):
        return [row.row(float(self.search["Out"])) for row in self.rows]

    def standing(self):
        return [(p.name, p.body.vertices, p.body.triangles, p.chord) for p in self.still]

    def own_rules(self):
        """Returns (name, name, rule) for the pairs that have their own rule. Raises InputProblem."""
        found = []
        moving = [row.part for row in self.rows]
        pairs = itertools.chain(
            itertools.combinations(moving, 2), itertools.product(moving, self.still)
        )
        for one, other in pairs if self.rules else []:
            text = pair_rules.of(self.rules, one.pair, other.pair).text()
            if text is not None:
                found.append((one.name, other.name, text))
        return found


class Plan(mechanism_plan.Plan):
    """motions: one for each of pairs, None if a path is searched for; search: values of SEARCH;
    steps: steps of the stored report in the order of the parts, empty if the report is out of date;
    known: hash of the inputs of the stored report."""

    SETTINGS = ("RequiredDistance", "ReleaseDistance", "Accuracy", "MeshDeflection")

    def __init__(self, document, pairs, motions, neighbours, all_visible, values, rules=None):
        super().__init__(document, pairs, motions, neighbours, all_visible, values, rules)
        self.search, self.steps, self.known = dict(SEARCH), [], ""

    @classmethod
    def of(cls, obj):
        plan = super().of(obj)
        report = obj.Proxy.report_of(obj) if obj.Report else None
        current = obj.Status == UP_TO_DATE and report and report["verdict"] == "found"
        plan.steps, plan.known = report["steps"] if current else [], obj.InputHash
        return plan

    def groups(self):
        """Returns a list with the Moving of each part, or None where a path is searched for. Raises
        InputProblem."""
        if self.lost:
            raise InputProblem(self.lost)
        if not self.pairs:
            raise InputProblem(
                translate(
                    "SweptVolume",
                    "The list of parts is empty: select the parts, then press Add selected.",
                )
            )
        if len(self.motions) != len(self.pairs):
            text = translate(
                "SweptVolume",
                "There are {0} parts but {1} motions: give one motion for each part.",
            )
            raise InputProblem(text.format(len(self.pairs), len(self.motions)))
        self._check_parts()
        groups = []
        for pair, motion in zip(self.pairs, self.motions):
            groups.append(None if motion is None else Moving([pair], motion))
            if motion is None:
                continue
            groups[-1].check()
            if motion.Interpolation == "None":
                text = translate(
                    "SweptVolume",
                    '"{0}" has the interpolation None: choose another interpolation, or choose '
                    '"find a path" as the motion of this part.',
                )
                raise InputProblem(text.format(motion.Label))
        return groups

    def words(self):
        """Returns the same as clearance_plan.Plan.words(), but the order of the parts matters."""
        if self._words is None:
            beside = sorted(self.leaves(), key=lambda pair: (pair[0].Name, pair[1]))
            words = []
            for pair, group in zip(self.pairs, self.groups()):
                words += contents.words([pair]) if group is None else group.words()
            words += contents.words(beside) if beside else []
            words.append(renamed.hashed(contents.steady(self.values)))
            words.append(pair_rules.words(self.pair_rules))
            self._words = words
        return self._words

    def take(self, order, motions):
        """Puts the parts into the order that was found (a list of old indices). motions: one for each
        part, in the old order."""
        self.pairs = [self.pairs[k] for k in order]
        self.motions = [motions[k] for k in order]
        self._words = None

    def rename(self, report):
        """Updates the names in the steps of a report, and in their obstacles, to the present labels
        of the parts. Returns whether a name changed."""
        found = row_names.placed(report, "parts", "places")
        there = {s["part"]: pair for s, pair in zip(report["steps"], self.pairs)}
        whole = len(there) == len(self.pairs) and set(there) == {known for known, _ in found}
        if whole and self.known and self.known == self.hash():
            # Content and order of the parts are those of the report. So each step gets the name of
            # the part that now has the same index.
            found = [(known, row_names.place_of(*there[known])) for known, _ in found]
            report["places"] = [place for _, place in found]
        new = self._renamed(found + row_names.placed(report, "still", "still_places"))
        if not new:
            return False
        for name in ("parts", "still"):
            report[name] = [new.get(known, known) for known in report[name]]
        for step in report["steps"]:
            step["part"] = new.get(step["part"], step["part"])
            escape = step.get("escape")
            if escape is not None:
                escape["blockers"] = [new.get(known, known) for known in escape["blockers"]]
        return True

    # --- the run

    def request(self):
        """Returns the inputs of the search as plain values. Raises InputProblem."""
        deflection = max(float(self.values["MeshDeflection"]), 1e-4)
        straight = 0.5 * float(self.values["Accuracy"])
        names, rows, notes = self.names(), [], []
        for pair, group in zip(self.pairs, self.groups()):
            if group is None:
                rows.append(self._searched(pair, names[pair], deflection))
                continue
            parts = self._moving_parts(group, group.rigid_motion(), names, deflection, straight)
            rows += [Row(part) for part in parts]
            notes += [group.motion.Message] if group.motion.Message else []
        still = []
        if self._has_standing():
            found, more, _ = self.still_parts(deflection)
            still = [Part(names[n.pair], n.pair, n.body, n.chord) for n in found]
            notes += more
        return Request(rows, still, self.pair_rules, dict(self.search), self._options(), notes)

    def _searched(self, pair, name, deflection):
        body = convert.body_from([pair], deflection)
        pivot = middle_of([pair], body.placement)
        base = body.placement.multiply(shift_to(pivot))
        seen = BodyInFrame(body, matrix_of(base.inverse()))
        chord = still_parts.chord_of([pair], deflection)
        return Row(Part(name, pair, seen, chord), pivot, matrix_of(base))

    def _options(self):
        v, s = self.values, self.search
        return {
            "clearance": float(v["RequiredDistance"]),
            "release": float(v["ReleaseDistance"]),
            "tolerance": float(v["Accuracy"]),
            "translation_only": bool(s["TranslationOnly"]),
            "max_angle": None if s["LargestTurn"] >= 180.0 else math.radians(s["LargestTurn"]),
            "interpolation": path_plan.INTERPOLATION.lower(),
            "budget": float(s["Budget"]),
            "seed": int(s["Seed"]),
            "most_moves": int(s["MostMoves"]),
        }

    # --- pictures

    def seen(self):
        """Returns the same as mechanism_plan.Plan.seen(), but on the time axis of the stored
        result: before its motion a part waits at its first key, and afterwards it stays at its last
        key. Raises InputProblem."""
        found, deflection = [], self.seen_deflection()
        begins = [step["begin"] for step in self.steps] or [0.0] * len(self.pairs)
        for pair, group, begin in zip(self.pairs, self.groups(), begins):
            rigid = group.rigid_motion()
            body = BodyInFrame(convert.body_from([pair], deflection), rigid.into_base)
            times = rigid.poses.times
            found.append((body, _delayed(rigid.course(), times[0], times[-1], begin)))
        return found


def _delayed(course, first, last, begin):
    return lambda time: course(min(max(time - begin + first, first), last))
