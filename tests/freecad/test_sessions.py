# SPDX-License-Identifier: LGPL-2.1-or-later
"""Coarse runs while a motion is edited: sessions of the core that are kept, and bodies with fewer
triangles.
"""
import unittest

import numpy as np

from case import Case
from sweptvolume import core, core_previews


def ball(rings):
    """Returns a sphere of radius 1 with about 4 * rings * rings triangles."""
    u = np.linspace(0, np.pi, rings + 1)[1:-1]
    v = np.linspace(0, 2 * np.pi, 2 * rings, endpoint=False)
    u, v = np.meshgrid(u, v, indexing="ij")
    points = np.stack([np.sin(u) * np.cos(v), np.sin(u) * np.sin(v), np.cos(u)], -1)
    points = np.vstack([points.reshape(-1, 3), [[0, 0, 1], [0, 0, -1]]])
    around, last = 2 * rings, (rings - 2) * 2 * rings
    j = np.arange(around)
    k = (j + 1) % around
    faces = []
    for i in range(0, last, around):
        faces += [np.stack([i + j, i + j + around, i + k], 1)]
        faces += [np.stack([i + k, i + j + around, i + k + around], 1)]
    top, bottom = np.full(around, len(points) - 2), np.full(around, len(points) - 1)
    faces += [np.stack([top, j, k], 1), np.stack([bottom, last + k, last + j], 1)]
    return points, np.vstack(faces).astype(np.int32)


def request(body, travel, **options):
    rotations = np.tile([0.0, 0.0, 0.0, 1.0], (2, 1))
    times, places = np.array([0.0, 1.0]), np.array([[0.0, 0.0, 0.0], travel])
    return core.Request(
        core.Triangles(*body), times, places, rotations, "linear", dict(options, resolution=48)
    )


class Sessions(Case):
    NEEDS_CORE = True

    def test_a_heavy_body_becomes_a_light_one_that_sweeps_the_same(self):
        body = ball(90)
        self.assertGreater(len(body[1]), core_previews.HEAVY)
        sessions, control = core_previews.Sessions(), core.Control()
        before = sessions.compute(request(body, (3, 0, 0)), control)
        sessions.lighten(request(body, (1, 1, 1)), control)
        self.assertLess(len(sessions._light[0][1][1]), len(body[1]) / 10)
        after = sessions.compute(request(body, (3, 0, 0)), core.Control())
        for axis in range(3):
            for end in (np.min, np.max):
                a, b = (end(o.vertices[:, axis]) for o in (before, after))
                self.assertAlmostEqual(a, b, delta=after.report["cell"])
        self.assertEqual([w["code"] for w in after.report["warnings"]], ["NotChecked"])

    def test_a_light_body_stays_what_it_is(self):
        sessions = core_previews.Sessions()
        sessions.lighten(request(ball(10), (3, 0, 0)), core.Control())
        self.assertEqual(sessions._light, [])

    def test_a_conservative_preview_is_checked(self):
        found = core_previews.Sessions().compute(
            request(ball(10), (3, 0, 0), conservative=True), core.Control()
        )
        self.assertNotIn("NotChecked", [w["code"] for w in found.report["warnings"]])
        self.assertTrue(found.report["closed"])


if __name__ == "__main__":
    unittest.main()
