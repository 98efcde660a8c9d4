# SPDX-License-Identifier: LGPL-2.1-or-later
"""One run of a driver or a simulation, and where parts of the document stand in each of its frames.

Whatever runs gives its frames as a generator: it brings the document into a frame and yields the time (s);
it puts the document back when it ends or is closed, and returns what is to be said of the run.
"""
import numpy as np

from ..convert import InputProblem, global_placement, label_of, matrix_of, root_path
from ..quantities import count
from ..texts import translate
from .poses import Poses

#: A part moves where its placement changes by more than this (mm, or of a matrix).
STILL = 1e-6


def change(matrices):
    """How far 4x4 matrices (k, 4, 4) are from the first of them."""
    return float(abs(matrices - matrices[0]).max()) if len(matrices) else 0.0


class Recording:
    """places: (root, sub) of what is watched. times (s); placements: a list for each place, one for each
    time; note: what is to be said of the run, once it has ended."""

    def __init__(self, frames, places):
        self.frames, self.places = frames, list(places)
        self.times, self.placements, self.note = [], [[] for _ in self.places], ""

    def advance(self):
        """One frame on; False at the end. Raises InputProblem, and the document is as before then."""
        try:
            time = next(self.frames)
        except StopIteration as end:
            self.note = end.value or ""
            return False
        try:
            for place, found in zip(self.places, self.placements):
                found.append(global_placement(*place))
        except BaseException:
            self.close()
            raise
        self.times.append(time)
        return True

    def run(self):
        """All frames at once; returns itself."""
        while self.advance():
            pass
        return self

    def close(self):
        """Ends the run early: the document is as before."""
        self.frames.close()

    def poses(self, k):
        """Of one place, as they stand in the document."""
        notes = [self.note] if self.note else []
        if change(np.array([matrix_of(p) for p in self.placements[k]])) <= STILL:
            text = translate(
                "Messages",
                '"{0}" stands still in all {1} frames: choose a part that is moved, or check the '
                "joints and formulas.",
            )
            notes.append(text.format(label_of(*self.places[k]), count(len(self.times))))
        return Poses(self.times, self.placements[k], note=" ".join(notes))


def poses_of(frames, part):
    """Poses of one part over a whole run."""
    return Recording(frames, [root_path(part)]).run().poses(0)


def check_valid(objects, text):
    """Raises InputProblem with a text where one of the objects could not be recomputed."""
    if any("Invalid" in obj.State for obj in objects):
        raise InputProblem(text)


def no_frames(label):
    """What is to be said of a run without frames."""
    return InputProblem(
        translate(
            "Messages", 'The simulation "{0}" gave no frames: open it and check that it runs.'
        ).format(label)
    )
