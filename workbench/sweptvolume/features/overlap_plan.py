# SPDX-License-Identifier: LGPL-2.1-or-later
"""Reads parts, envelopes and solids that are compared at their present placements, and converts
them to plain values."""
import itertools

from .. import contents, convert, core_overlap
from ..convert import InputProblem
from ..texts import translate
from .still_parts import chord_of


class Plan:
    """pairs: (root, sub) of the objects, which are all compared with each other; required,
    deflection: mm."""

    def __init__(self, document, pairs, required=0.0, deflection=0.05):
        self.document, self.pairs = document, list(pairs)
        self.required, self.deflection = float(required), float(deflection)
        self.known = None  # state() at the time of request()

    def names(self):
        """Returns the label of each object. Equal labels are numbered."""
        return convert.own_names(self.pairs)

    def words(self):
        """Returns contents.words() of all objects. Raises InputProblem."""
        return contents.words(self.pairs)

    def state(self):
        """Returns the names, and the texts that identify the geometry and the placements of the
        objects. Returns None if an object is gone, or if large parts must be read first."""
        try:
            found = self.words()
            large = contents.is_much(contents.unread(found))
            return None if large else (self.names(), contents.texts(found))
        except (InputProblem, ReferenceError, RuntimeError, AttributeError):
            return None

    def request(self):
        """Returns the plain values for work(). Raises InputProblem."""
        if len(self.pairs) < 2:
            raise InputProblem(
                translate(
                    "SweptVolume",
                    "There is nothing to compare: choose two or more parts, envelopes or solids.",
                )
            )
        for (root, sub), (other, path) in itertools.combinations(self.pairs, 2):
            if root is other and (sub.startswith(path) or path.startswith(sub)):
                text = translate("SweptVolume", '"{0}" contains "{1}": remove one of them.')
                outer, inner = sorted((sub, path), key=len)
                raise InputProblem(
                    text.format(convert.label_of(root, outer), convert.label_of(root, inner))
                )
        deflection = max(self.deflection, 1e-4)
        parts = [
            (name, convert.body_from([pair], deflection), chord_of([pair], deflection))
            for name, pair in zip(self.names(), self.pairs)
        ]
        self.known = self.state()
        return Request(parts, {"required": self.required})


class Request:
    """Input of one comparison, independent of any document."""

    def __init__(self, parts, options):
        self.parts, self.options = parts, options


def work(request, control):
    """Runs core_overlap.overlap(), in any thread. Raises core.CoreError, InputProblem."""
    parts = [(name, body.vertices, body.triangles, chord) for name, body, chord in request.parts]
    return core_overlap.overlap(parts, request.options, control)
