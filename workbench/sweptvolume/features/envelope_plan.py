# SPDX-License-Identifier: LGPL-2.1-or-later
"""What an envelope is to be computed from, read off an object or a panel: parts, motions, settings -> the
input of the core as plain arrays."""
import json

import numpy as np

from .. import contents, convert, core
from ..convert import InputProblem
from ..texts import translate
from ..trajectory.poses import swept_box
from . import containers, missing, status
from .envelope_properties import ACCURACY, BACKENDS, COMPONENTS
from .motion import is_motion, set_parts
from .moving import Moving, grouped

#: About as many cells as a grid can have along a side; the core says exactly.
MOST_CELLS = 8000
#: Straight pieces of a smooth motion leave it by at most this part of a cell.
STRAIGHT = 0.02
#: Of a part's size: to so much its solids get triangles for a closer estimate.
LOOK_DEFLECTION = 2e-3


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
        self._words = None

    @classmethod
    def of(cls, obj):
        values = {name: getattr(obj, name) for name in cls.SETTINGS}
        for name, value in values.items():
            values[name] = getattr(value, "Value", value)
        seen_from = convert.pairs_of(obj.Reference)
        plan = cls(
            convert.pairs_of(obj.MovingParts),
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
        containers.set_pairs(obj, "MovingParts", self.pairs)
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
                    "There are {0} moving parts but {1} individual motions: give one "
                    "motion for each part, or none.",
                ).format(len(self.pairs), len(self.motions))
            )
        reference = (self.reference, self.reference_motion)
        motions = self.motions or [self.motion] * len(self.pairs)
        groups = grouped(self.pairs, motions, *reference)
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
            "sources": self.records(),
        }

    def records(self):
        """Whether the run tells what made each triangle: grown envelopes cannot."""
        v = self.values
        return v["MadeBy"] != "Off" and not v["Offset"] > 0 and not v["Conservative"]

    def hash(self, without=()):
        """Short text that stands for all the result depends on; "" while inputs are unusable. without:
        options that are left out."""
        return status.hash_or_problem(lambda: self.checked_hash(without))[0]

    def words(self):
        """Of the parts and motions as they were when this was first asked (contents.words()). Raises
        InputProblem that says why the inputs are unusable."""
        if self._words is None:
            self._words = [word for group in self.groups() for word in group.words()]
        return self._words

    def checked_hash(self, without=()):
        """As hash(); raises InputProblem that says why the inputs are unusable. Any thread, where the words
        were prepared for that."""
        return status.VERSION + self._hash(contents.texts(self.words()), without)

    def hash_of_before(self):
        """As version 1 had it; raises InputProblem."""
        return self._hash([word for group in self.groups() for word in group.words_of_before()])

    def _hash(self, inputs, without=()):
        options = self.options()
        # The surface is the same whoever computes it, and whatever is told of it.
        for name in ("backend", "sources") + tuple(without):
            del options[name]
        if not options["position_filter"]:
            del options["position_filter"]  # so are those made before there was one
        options = json.dumps(contents.steady(options), sort_keys=True)
        words = [options, repr(contents.steady(self.values["MeshDeflection"]))]
        return contents.short(words + inputs)

    def cell(self, groups):
        """Edge of a cell (mm): as given, or from the resolution and the boxes of the parts."""
        if self.values["CellSize"] > 0:
            return float(self.values["CellSize"])
        low, high = np.full(3, np.inf), np.full(3, -np.inf)
        for group in groups:
            box = swept_box(group.corners(), group.trajectory(np.inf)[0])
            low, high = np.minimum(low, box[0]), np.maximum(high, box[1])
        return max(float((high - low).max()) / max(self.values["Resolution"], 1), 1e-9)

    def requests(self, finest=0.0, read=convert.body_from):
        """One run for each group of parts that move together, no document behind them. finest: mm, solids
        get no finer triangles; read: as convert.body_from."""
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
                        "Cavities cannot be kept if parts have individual motions: clear Keep "
                        "cavities, or create one envelope for each motion.",
                    )
                )
        deflection = max(max(self.values["MeshDeflection"], 1e-3) * cell, finest)
        return [g.body_request(deflection, STRAIGHT * cell, options, read) for g in groups]

    def coarse_requests(self, cells):
        """As requests(), of a quick look: `cells` along the longest side, nothing simplified."""
        values = dict(
            self.values,
            Resolution=cells,
            CellSize=0.0,
            Tolerance=0.0,
            KeepCavities=False,
            MeshDeflection=0.25,
            MadeBy="Off",
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
        return _together(
            [core.estimate(g.request(g.outline()(), tolerance, options)) for g in groups]
        )

    def is_outlined(self):
        """Whether estimate() answers at once: the outermost points of the parts are known."""
        return all(contents.is_outlined(group.pairs) for group in self.groups())

    def closer_estimate(self, read=convert.body_from):
        """A function of a core.Control that gives a better estimate, for another thread: a few steps of the
        parts are sampled. Solids get triangles for it that are quickly made. It finds the outermost points
        as well."""
        groups = self.groups()
        size = min(float(np.ptp(group.corners(), axis=0).max()) for group in groups)
        outlines = [group.outline() for group in groups]
        requests = self.requests(LOOK_DEFLECTION * size, read)

        def found(control):
            for outline in outlines:
                outline()
            return _together([core.estimate(request, control) for request in requests])

        return found


def _together(found):
    """Estimates of runs one after the other -> that of all."""
    most = max(found, key=lambda e: e["memory_bytes"])
    return dict(most, seconds=sum(e["seconds"] for e in found))
