# SPDX-License-Identifier: LGPL-2.1-or-later
"""Finds all parts that a driver or a simulation moves, in one run of it. A part is the outermost
group, link or body that moves as a rigid whole."""
import numpy as np

from .. import convert
from ..trajectory import sources
from ..trajectory.frames import STILL, Recording, change
from . import containers


def _leaves(document):
    """Returns (root, path) of all visible solids and meshes."""
    return [
        (root, path)
        for root in containers.standing(document)
        if convert.is_shown(root)
        for linked, path in convert.leaves(root)
        if convert.solid_like(linked)
    ]


class Run(Recording):
    """Records all parts of a document while a source of sources.FROM_JOINTS runs. settings.objects:
    the source and, optionally, the part that must recompute in every frame."""

    def __init__(self, document, settings):
        self.leaves = _leaves(document)
        pairs = [(root, above) for root, sub in self.leaves for above in convert.paths_to(sub)]
        pairs += [convert.root_path(part) for part in settings.objects[1:]]
        pairs = list(dict.fromkeys(pairs))
        super().__init__(sources.run(settings, settings.objects[1:]), pairs)

    def poses_of_part(self, pair):
        """Returns the poses of one of the parts that moved() returns."""
        return self.poses(self.pairs.index(pair))

    def moved(self):
        """Returns (root, sub) of the parts that moved."""
        found = {
            pair: np.array([convert.matrix_of(p) for p in placements])
            for pair, placements in zip(self.pairs, self.placements)
        }

        def moves(pair):
            return change(found[pair]) > STILL

        def carries(pair):
            root, sub = pair
            back = np.linalg.inv(found[pair])
            below = [p for p in self.leaves if p[0] is root and p[1].startswith(sub)]
            return all(change(back @ found[p]) <= STILL for p in below)

        parts = []
        for root, sub in self.leaves:
            if moves((root, sub)):
                whole = [
                    (root, a)
                    for a in convert.paths_to(sub)
                    if moves((root, a)) and carries((root, a))
                ]
                parts.append((whole or [(root, sub)])[0])
        return list(dict.fromkeys(parts))


def read(document, settings):
    """Returns the same as sources.read(). If the source moves several parts, `moved` of the poses
    lists the other objects that moved."""
    if settings.kind not in sources.FROM_JOINTS:
        return sources.read(settings)
    part = sources.watched(settings)
    run = Run(document, settings).run()
    poses = run.poses_of_part(convert.root_path(part))
    others = convert.targets(run.moved())
    poses.moved = [obj for obj in dict.fromkeys(others) if obj is not part]
    return poses
