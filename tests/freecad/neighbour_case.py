# SPDX-License-Identifier: LGPL-2.1-or-later
"""A box that moves towards a wall, past a part that stands far from it."""
from case import Case, shift
from sweptvolume.features import clearance


class Neighbours(Case):
    NEEDS_CORE = True

    def setUp(self):
        super().setUp()
        self.part = self.box()
        self.path = self.line()  # 30 mm along x: the box ends at x = 40
        self.wall = self.box("Wall")
        self.wall.Placement = shift(x=43.5)
        self.far = self.box("Far")
        self.far.Placement = shift(y=25)
        self.doc.recompute()

    def made(self, **settings):
        obj = clearance.make_clearance(
            self.doc, MovingParts=[(self.part, "")], Motion=self.path, **settings
        )
        self.doc.recompute()
        return obj
