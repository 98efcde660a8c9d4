# SPDX-License-Identifier: LGPL-2.1-or-later
"""Reads the inputs of an envelope from an object or a panel (parts, motions, settings), and
converts them to plain arrays for the core."""
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

#: Approximate largest number of cells along one side of a grid; the core checks the exact limit.
MOST_CELLS = 8000
#: Largest deviation of the straight segments that approximate a smooth motion, in cells.
STRAIGHT = 0.02
#: Deflection of solids for the closer estimate, as a fraction of the part's size.
TRIAL_DEFLECTION = 2e-3


class Plan:
    """The inputs of an envelope: moving parts, motions, reference part, and the settings by
    property name.

    Created from an object or a panel, anew for each use. Reads documents only in the GUI thread.
    motions: empty, or one motion for each item of pairs. reference: (root, sub).
    """

    SETTINGS = [name for _, name, *_ in ACCURACY]

    def __init__(self, pairs, motion, values, motions=(), reference=None, reference_motion=None):
        self.lost = ""  # text about a deleted input, or ""
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
        """Writes the plan into an envelope object."""
        missing.forget(obj)
        containers.set_pairs(obj, "MovingParts", self.pairs)
        obj.Motion = self.motion
        obj.Motions = self.motions
        self.assign_parts()
        containers.set_pairs(obj, "Reference", [self.reference] if self.reference else [])
        obj.ReferenceMotion = self.reference_motion
        for name, value in self.values.items():
            if getattr(getattr(obj, name), "Value", getattr(obj, name)) != value:
                setattr(obj, name, value)

    def assign_parts(self):
        """Assigns the moving parts to motions that have no parts yet."""
        for motion in {m.Name: m for m in self.motions or [self.motion] if m is not None}.values():
            if is_motion(motion):
                own = zip(self.pairs, self.motions or [self.motion] * len(self.pairs))
                set_parts(motion, [pair for pair, m in own if m is motion])

    def objects(self):
        """Returns the document objects that a run needs until its end."""
        found = [root for root, _ in self.pairs] + [self.motion, self.reference_motion]
        found += self.motions + ([self.reference[0]] if self.reference else [])
        return [obj for obj in found if obj is not None]

    def groups(self):
        """Returns the parts that move together, as a list of Moving. Raises InputProblem."""
        if self.lost:
            raise InputProblem(self.lost)
        if self.motions and len(self.motions) != len(self.pairs):
            raise InputProblem(
                translate(
                    "SweptVolume",
                    "The number of moving parts is {0}, but the number of own motions is {1}: "
                    "give every part a motion of its own, or none.",
                ).format(len(self.pairs), len(self.motions))
            )
        reference = (self.reference, self.reference_motion)
        motions = self.motions or [self.motion] * len(self.pairs)
        groups = grouped(self.pairs, motions, *reference)
        if len(groups) > 1 and self.values["KeepCavities"]:
            raise InputProblem(
                translate(
                    "SweptVolume",
                    "Cavities cannot be kept if parts have motions of their own: clear Keep "
                    "cavities, or create one envelope for each motion.",
                )
            )
        return groups or [Moving([], self.motion, *reference)]

    def _settings(self):
        """Returns the settings by the names of the core. Works without the compiled module."""
        v = self.values
        found = {
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
        if v["Accuracy"] > 0:
            found.update(accuracy=float(v["Accuracy"]), resolution=0, cell=0.0, tolerance=0.0)
        return found

    def options(self):
        """Returns the settings as the core takes them. Raises CoreError, CoreMissing."""
        found = self._settings()
        if "accuracy" in found:
            # The envelopes of several groups are sampled again to join them. Each of the two
            # samplings may use half of the accuracy.
            accuracy = found.pop("accuracy") / (1 if len(self.groups()) == 1 else 2)
            found.update(core.options_of_accuracy(accuracy))
        return found

    def records(self):
        """Returns whether the run records what made each triangle, which is impossible for grown
        envelopes."""
        v = self.values
        return v["MadeBy"] != "Off" and not v["Offset"] > 0 and not v["Conservative"]

    def hash(self, without=()):
        """Returns a short text that identifies all inputs of the result, or "" if inputs are
        unusable. without: options that are left out."""
        return status.hash_or_problem(lambda: self.checked_hash(without))[0]

    def words(self):
        """Returns the words (contents.words()) of parts and motions, in their state at the first
        call. Raises InputProblem, whose text says why the inputs are unusable."""
        if self._words is None:
            self._words = [word for group in self.groups() for word in group.words()]
        return self._words

    def checked_hash(self, without=()):
        """Returns the same as hash(), but raises InputProblem if inputs are unusable; its text says
        why. Any thread may call this after contents.prepared() was called for the words."""
        return status.VERSION + self._hash(contents.texts(self.words()), without)

    def hash_of_before(self):
        """Returns the hash of version 1. Raises InputProblem."""
        return self._hash([word for group in self.groups() for word in group.words_of_before()])

    def _hash(self, inputs, without=()):
        options = self._settings()
        # The surface depends neither on the backend nor on the recording of sources.
        for name in ("backend", "sources") + tuple(without):
            del options[name]
        if not options["position_filter"]:
            # With a filter of 0, the hash is the same as in documents without this property.
            del options["position_filter"]
        options = json.dumps(contents.steady(options), sort_keys=True)
        words = [options, repr(contents.steady(self.values["MeshDeflection"]))]
        return contents.short(words + inputs)

    def cell(self, groups):
        """Returns the cell size (mm): the given size, or else a size computed from the resolution
        and the bounding boxes of the parts."""
        given = self.options()["cell"]
        if given > 0:
            return given
        low, high = np.full(3, np.inf), np.full(3, -np.inf)
        for group in groups:
            box = swept_box(group.corners(), group.trajectory(np.inf)[0])
            low, high = np.minimum(low, box[0]), np.maximum(high, box[1])
        return max(float((high - low).max()) / max(self.values["Resolution"], 1), 1e-9)

    def requests(self, finest=0.0, read=convert.body_from):
        """Returns one request, independent of the document, for each group of parts that move
        together. finest: mm, smallest deflection for solids. read: a function like
        convert.body_from()."""
        groups, options = self.groups(), self.options()
        cell = self.cell(groups)
        if any(np.ptp(g.corners(), axis=0).max() > MOST_CELLS * cell for g in groups):
            # The cell is too small: estimate() raises the core's error before any solid is meshed.
            self.estimate()
        if len(groups) > 1:
            options.update(cell=cell, tolerance=0.0)
        deflection = max(max(self.values["MeshDeflection"], 1e-3) * cell, finest)
        return [g.body_request(deflection, STRAIGHT * cell, options, read) for g in groups]

    def coarse_requests(self, cells):
        """Returns requests() for a quick preview: with `cells` cells along the longest side, and
        without simplification."""
        values = dict(
            self.values,
            Accuracy=0.0,
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
        """Returns findings about the motions themselves: between two frames, a part may deviate
        from its interpolated path by more than a cell; or a motion may have ended early."""
        groups, found = self.groups(), []
        cell = self.cell(groups)
        for group in groups:
            off, text = group.frame_deviation()
            if off > cell:
                found.append({"code": "FramesFarApart", "text": text})
            if group.motion.Message:
                found.append({"code": "MotionIncomplete", "text": group.motion.Message})
        return found

    def union_options(self, requests):
        """Returns the settings of the run that joins the envelopes of several groups."""
        return dict(
            self.options(), cell=requests[0].options["cell"], offset=0.0, position_filter=0.0
        )

    def estimate(self):
        """Estimates the run from the outermost points of the parts. Returns the core's estimate
        (dict). Its grid and cell are the same as in the run."""
        groups, options = self.groups(), self.options()
        if len(groups) > 1:
            options["cell"] = self.cell(groups)
        tolerance = STRAIGHT * self.cell(groups)
        return _together(
            [core.estimate(g.request(g.outline()(), tolerance, options)) for g in groups]
        )

    def is_outlined(self):
        """Returns whether estimate() is fast because the outermost points of the parts are
        known."""
        return all(contents.is_outlined(group.pairs) for group in self.groups())

    def closer_estimate(self, read=convert.body_from):
        """Returns a function of a core.Control, for another thread, which returns a better
        estimate. It samples a few steps of the motion with coarse triangles of the solids. It also
        finds the outermost points."""
        groups = self.groups()
        size = min(float(np.ptp(group.corners(), axis=0).max()) for group in groups)
        outlines = [group.outline() for group in groups]
        requests = self.requests(TRIAL_DEFLECTION * size, read)

        def found(control):
            for outline in outlines:
                outline()
            return _together([core.estimate(request, control) for request in requests])

        return found


def _together(found):
    """Adds up the estimates of runs that are computed one after the other."""
    most = max(found, key=lambda e: e["memory_bytes"])
    return dict(most, seconds=sum(e["seconds"] for e in found))
