# SPDX-License-Identifier: LGPL-2.1-or-later
"""One run of a driver or a simulation, and the placements of parts in each of its frames.

A source gives its frames as a generator. It brings the document into a frame and yields the time
(s). When it ends or is closed, it restores the document and returns a note about the run.
"""
import numpy as np

from ..convert import InputProblem, global_placement, label_of, matrix_of, root_path
from ..quantities import count
from ..texts import translate
from .poses import Poses

#: A part counts as moving if its placement changes by more than this (mm, or entries of the
#: rotation matrix).
STILL = 1e-6


def change(matrices):
    """Returns the largest difference of 4x4 matrices (k, 4, 4) from the first of them."""
    return float(abs(matrices - matrices[0]).max()) if len(matrices) else 0.0


class Recording:
    """pairs: (root, sub) of the recorded parts. times: s. placements: for each of `pairs` a list
    with one placement for each time. note: the note about the run, when it has ended."""

    def __init__(self, frames, pairs):
        self.frames, self.pairs = frames, list(pairs)
        self.times, self.placements, self.note = [], [[] for _ in self.pairs], ""

    def advance(self):
        """Advances by one frame. Returns False at the end. Raises InputProblem, and then the
        document is as before."""
        try:
            time = next(self.frames)
        except StopIteration as end:
            self.note = end.value or ""
            return False
        try:
            for pair, found in zip(self.pairs, self.placements):
                found.append(global_placement(*pair))
        except BaseException:
            self.close()
            raise
        self.times.append(time)
        return True

    def run(self):
        """Runs all frames at once. Returns self."""
        while self.advance():
            pass
        return self

    def close(self):
        """Ends the run early. The document is as before."""
        self.frames.close()

    def poses(self, k):
        """Returns the poses of the part pairs[k], in world coordinates."""
        notes = [self.note] if self.note else []
        if change(np.array([matrix_of(p) for p in self.placements[k]])) <= STILL:
            text = translate(
                "SweptVolume",
                '"{0}" stands still in all {1} frames: choose a part that moves, or check the '
                "joints and formulas.",
            )
            notes.append(text.format(label_of(*self.pairs[k]), count(len(self.times))))
        return Poses(self.times, self.placements[k], note=" ".join(notes))


def poses_of(frames, part):
    """Returns the poses of one part over a whole run."""
    return Recording(frames, [root_path(part)]).run().poses(0)


def check_valid(objects, text):
    """Raises InputProblem with this text if one of the objects could not be recomputed."""
    if any("Invalid" in obj.State for obj in objects):
        raise InputProblem(text)


def no_frames(label):
    """Returns the InputProblem for a run without frames."""
    return InputProblem(
        translate(
            "SweptVolume", 'The simulation "{0}" gave no frames: open it and check that it runs.'
        ).format(label)
    )
