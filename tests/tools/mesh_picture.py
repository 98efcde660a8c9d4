# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pictures of meshes without a display: parallel view, flat shading, edges and marks with hidden parts
hidden. Colours are (r, g, b) 0 to 255; lengths are those of the mesh."""
import numpy as np

OUTER, INNER = (150, 172, 205), (214, 178, 120)  # colours of the two sides of a surface
SAMPLES = 2  # samples per pixel and direction: pictures are drawn larger, then averaged


class Picture:
    """A picture of `pixels` = (width, height), seen from the direction `toward`. Its width shows the length
    `width` of the mesh.
    """

    def __init__(self, pixels, centre, toward, up, width):
        self.shape = (pixels[1] * SAMPLES, pixels[0] * SAMPLES)
        back = np.asarray(toward, float) / np.linalg.norm(toward)
        right = np.cross(up, back)
        right /= np.linalg.norm(right)
        self.axes = np.stack([right, -np.cross(back, right), back])  # across, down, to the viewer
        self.centre = np.asarray(centre, float)
        self.scale = self.shape[1] / width
        self.colour = np.full(self.shape + (3,), 255, np.float32)
        self.depth = np.full(self.shape, -np.inf)

    def project(self, points):
        """Returns pixels across, pixels down, and depth in pixels (large: near)."""
        seen = (np.asarray(points) - self.centre) @ self.axes.T * self.scale
        return seen + [self.shape[1] / 2, self.shape[0] / 2, 0]

    def inside(self, points):
        """Returns which points lie in the window."""
        seen = self.project(points)
        return (
            (seen[:, :2] >= 0).all(1) & (seen[:, 0] < self.shape[1]) & (seen[:, 1] < self.shape[0])
        )

    def put(self, across, down, depth, colour):
        """Draws pixels. Of several at the same place, the nearest remains."""
        kept = (across >= 0) & (across < self.shape[1]) & (down >= 0) & (down < self.shape[0])
        at = down[kept] * self.shape[1] + across[kept]
        depth, colour = depth[kept], np.broadcast_to(colour, (len(kept), 3))[kept]
        order = np.argsort(depth, kind="stable")  # the last one written is the nearest
        at, depth, colour = at[order], depth[order], colour[order]
        nearer = depth >= self.depth.ravel()[at]
        self.depth.ravel()[at[nearer]] = depth[nearer]
        self.colour.reshape(-1, 3)[at[nearer]] = colour[nearer]

    def fill(self, vertices, triangles, front=OUTER, behind=INNER):
        """Draws triangles, in another colour where their inner side is seen."""
        corners = self.project(vertices)[triangles]
        e, f = corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]
        normal = np.cross(e, f)
        area = normal[:, 2]  # negative for front faces, because the second axis points down
        length = np.linalg.norm(normal, axis=1)
        low, high = corners[:, :, :2].min(1), corners[:, :, :2].max(1)
        seen = (high >= 0).all(1) & (low < self.shape[::-1]).all(1) & (np.abs(area) > 1e-9)
        low = np.maximum(np.floor(low), 0).astype(int)
        high = np.minimum(np.ceil(high), np.array(self.shape[::-1]) - 1).astype(int)
        side = np.maximum((high - low).max(1) + 1, 1)
        light = normal @ [0.35, 0.5, -1.0] / np.maximum(length, 1e-30) / 1.17
        shade = 0.55 + 0.45 * np.abs(light)
        tint = np.where((area < 0)[:, None], front, behind) * shade[:, None]
        for box in 2 ** np.arange(1, 13):
            group = np.flatnonzero(seen & (side <= box) & (side > (box // 2 if box > 2 else 0)))
            step = max(1, 2_000_000 // (box * box))
            for chunk in (group[i : i + step] for i in range(0, len(group), step)):
                dy, dx = np.divmod(np.arange(box * box), box)
                x, y = low[chunk, :1] + dx, low[chunk, 1:] + dy
                px = x + 0.5 - corners[chunk, 0, :1]
                py = y + 0.5 - corners[chunk, 0, 1:2]
                ee, ff, whole = e[chunk, :, None], f[chunk, :, None], area[chunk, None]
                u = (px * ff[:, 1] - py * ff[:, 0]) / whole
                v = (py * ee[:, 0] - px * ee[:, 1]) / whole
                hit = (u >= -1e-9) & (v >= -1e-9) & (u + v <= 1 + 1e-9)
                z = corners[chunk, 0, 2:] + u * ee[:, 2] + v * ff[:, 2]
                which = np.broadcast_to(chunk[:, None], hit.shape)[hit]
                self.put(x[hit], y[hit], z[hit], tint[which])

    def dots(self, points, colour, radius=1.0, lift=1.0):
        """Draws points as discs of `radius` pixels, `lift` pixels nearer than they are."""
        seen = self.project(points)
        reach = int(np.ceil(radius * SAMPLES))
        dy, dx = np.mgrid[-reach : reach + 1, -reach : reach + 1]
        disc = np.hypot(dx, dy) <= radius * SAMPLES
        x = np.floor(seen[:, :1]).astype(int) + dx[disc]
        y = np.floor(seen[:, 1:2]).astype(int) + dy[disc]
        z = np.broadcast_to(seen[:, 2:] + lift * SAMPLES, x.shape)
        self.put(x.ravel(), y.ravel(), z.ravel(), np.asarray(colour, np.float32))

    def lines(self, starts, ends, colour, radius=1.0, lift=1.0):
        if not len(starts):
            return
        a, b = np.asarray(starts), np.asarray(ends)
        near = self.inside(a) | self.inside(b)
        a, b = a[near], b[near]
        counts = np.ceil(np.linalg.norm(b - a, axis=1) * self.scale).astype(int) + 1
        which = np.repeat(np.arange(len(a)), counts)
        first = np.repeat(np.cumsum(counts) - counts, counts)
        along = ((np.arange(len(which)) - first + 0.5) / counts[which])[:, None]
        for part in np.array_split(np.arange(len(which)), len(which) // 500_000 + 1):
            points = a[which[part]] + along[part] * (b - a)[which[part]]
            self.dots(points, colour, radius, lift)

    def array(self):
        """Returns the finished picture: uint8 (height, width, 3)."""
        h, w = self.shape[0] // SAMPLES, self.shape[1] // SAMPLES
        return self.colour.reshape(h, SAMPLES, w, SAMPLES, 3).mean((1, 3)).astype(np.uint8)
