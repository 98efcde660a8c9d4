# SPDX-License-Identifier: LGPL-2.1-or-later
"""Parts, envelopes and solids that are compared as they stand, read off the document: -> plain values."""
import itertools

from .. import contents, convert, core_overlap
from ..convert import InputProblem
from ..texts import translate
from .still_parts import chord_of


class Plan:
    """pairs: (root, sub) of what is compared, each with each; required, deflection: mm."""

    def __init__(self, document, pairs, required=0.0, deflection=0.05):
        self.document, self.pairs = document, list(pairs)
        self.required, self.deflection = float(required), float(deflection)

    def names(self):
        """Of each: its label, with a number where one is there twice."""
        return convert.own_names(self.pairs)

    def words(self):
        """As contents.words(). Raises InputProblem."""
        return contents.words(self.pairs)

    def request(self):
        """Plain values for work(). Raises InputProblem."""
        if len(self.pairs) < 2:
            raise InputProblem(
                translate(
                    "Messages",
                    "there is nothing to compare: choose two or more parts, envelopes or solids.",
                )
            )
        for (root, sub), (other, path) in itertools.combinations(self.pairs, 2):
            if root is other and (sub.startswith(path) or path.startswith(sub)):
                text = translate("Messages", '"{0}" contains "{1}": remove one of them.')
                outer, inner = sorted((sub, path), key=len)
                raise InputProblem(
                    text.format(convert.label_of(root, outer), convert.label_of(root, inner))
                )
        deflection = max(self.deflection, 1e-4)
        parts = [
            (name, convert.body_from([pair], deflection), chord_of([pair], deflection))
            for name, pair in zip(self.names(), self.pairs)
        ]
        return Request(parts, {"required": self.required})


class Request:
    """Input of one comparison, no document behind it."""

    def __init__(self, parts, options):
        self.parts, self.options = parts, options


def work(request, control):
    """Any thread: as core_overlap.overlap(). Raises core.CoreError, InputProblem."""
    parts = [(name, body.vertices, body.triangles, chord) for name, body, chord in request.parts]
    return core_overlap.overlap(parts, request.options, control)
