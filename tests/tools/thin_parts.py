# SPDX-License-Identifier: LGPL-2.1-or-later
"""Ten parts with thin walls and small details, and a motion of 16 keys for each.

    for part in parts(): part.name, part.vertices (mm), part.triangles, part.motion

Blades, threads, teeth, clips, ribs, letters, fins, tabs and slots. Every part is one closed mesh about
100 mm long; its thinnest walls are 1 to 2 mm. All numbers are fixed, so the parts are the same everywhere.
    loft     a polygon in layers, each turned and scaled
    blocks   the boundary of chosen blocks between planes
"""
import dataclasses
import math
import pathlib
import sys

import numpy as np

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "python"))

from bodies import rotation  # noqa: E402

SEED = 23
KEYS = 16


@dataclasses.dataclass(frozen=True)
class ThinPart:
    """A part with its motion: times (K,), quaternions x y z w (K, 4), translations (K, 3)."""

    name: str
    vertices: np.ndarray
    triangles: np.ndarray
    motion: tuple


def ears(polygon):
    """Returns the triangles (indices) of a simple counter-clockwise polygon (N, 2)."""
    left, triangles = list(range(len(polygon))), []
    while len(left) > 3:
        for at in range(len(left)):
            a, b, c = (left[(at + d) % len(left)] for d in (-1, 0, 1))
            if _side(*polygon[[a, b, c]]) <= 1e-12:
                continue
            others = np.array([p for p in left if p not in (a, b, c)])
            inside = np.ones(len(others), bool)
            for p, q in ((a, b), (b, c), (c, a)):
                inside &= _side(polygon[p], polygon[q], polygon[others]) >= 0
            if not inside.any():
                triangles.append((a, b, c))
                del left[at]
                break
        else:
            raise ValueError("the polygon is not simple")
    return triangles + [tuple(left)]


def _side(p, q, r):
    """Returns twice the area of p q r, positive if counter-clockwise; r may be many points."""
    u, v = q - p, np.asarray(r) - p
    return u[0] * v[..., 1] - u[1] * v[..., 0]


def loft(polygon, heights, turns=None, scales=None):
    """Returns a body with a polygon (N, 2) at each height, turned by `turns` (radians) and scaled."""
    polygon, count = np.asarray(polygon, float), len(polygon)
    turns = np.zeros(len(heights)) if turns is None else turns
    scales = np.ones(len(heights)) if scales is None else scales
    layers = []
    for height, turn, scale in zip(heights, turns, scales):
        c, s = math.cos(turn) * scale, math.sin(turn) * scale
        flat = polygon @ np.array([[c, s], [-s, c]])
        layers.append(np.column_stack([flat, np.full(count, height)]))
    triangles = []
    for layer in range(len(heights) - 1):
        a, b = layer * count, (layer + 1) * count
        for i in range(count):
            j = (i + 1) % count
            triangles += [(a + i, a + j, b + j), (a + i, b + j, b + i)]
    top = (len(heights) - 1) * count
    for p, q, r in ears(polygon):
        triangles += [(r, q, p), (top + p, top + q, top + r)]
    return np.vstack(layers), np.array(triangles)


def blocks(xs, ys, zs, full):
    """Returns the boundary of the blocks between planes for which full[x, y, z] is true."""
    full = np.pad(np.asarray(full, bool), 1)
    planes = np.arange((len(xs)) * len(ys) * len(zs)).reshape(len(xs), len(ys), len(zs))
    triangles = []
    for axis in range(3):
        u, v = (axis + 1) % 3, (axis + 2) % 3
        step = np.diff(full.astype(int), axis=axis)
        for at in np.argwhere(step):
            corner = [int(n) - (0 if a == axis else 1) for a, n in enumerate(at)]
            square = []
            for du, dv in ((0, 0), (1, 0), (1, 1), (0, 1)):
                place = list(corner)
                place[u] += du
                place[v] += dv
                square.append(planes[tuple(place)])
            if step[tuple(at)] > 0:  # the block lies on the far side: turn the face round
                square.reverse()
            a, b, c, d = square
            triangles += [(a, b, c), (a, c, d)]
    points = np.stack(np.meshgrid(xs, ys, zs, indexing="ij"), axis=-1).reshape(-1, 3)
    used, where = np.unique(np.array(triangles), return_inverse=True)
    return points[used].astype(float), where.reshape(-1, 3)


def _polar(radii, angles):
    radii, angles = np.broadcast_arrays(radii, angles)
    return np.column_stack([radii * np.cos(angles), radii * np.sin(angles)])


def _band(middle, wall):
    """Returns the outline of a band of width `wall` along the middle line (N, 2)."""
    along = np.gradient(middle, axis=0)
    along /= np.linalg.norm(along, axis=1, keepdims=True)
    across = np.column_stack([-along[:, 1], along[:, 0]]) * wall / 2
    return np.vstack([middle - across, (middle + across)[::-1]])


def rotor():
    """Returns a hub with seven twisted blades of 1.6 mm."""
    outline = []
    for blade in range(7):
        turn = 2 * math.pi * blade / 7
        c, s = math.cos(turn), math.sin(turn)
        root, half = 14.0, 0.8
        flat = np.array(
            [(root, -half), (30, -half), (50, -half), (50, half), (30, half), (root, half)]
        )
        outline.append(flat @ np.array([[c, s], [-s, c]]))
        gap = turn + np.linspace(0.12, 2 * math.pi / 7 - 0.12, 6)
        outline.append(_polar(root, gap))
    heights = np.linspace(0, 24, 13)
    return loft(np.vstack(outline), heights, turns=heights * 0.03)


def thread():
    """Returns a screw with a flat thread of 1.5 mm, eight turns."""
    angles = np.linspace(0, 2 * math.pi, 96, endpoint=False)
    radii = np.where(angles < 2.2, 11.0, 8.5)
    heights = np.linspace(0, 100, 321)
    return loft(_polar(radii, angles), heights, turns=heights * 2 * math.pi / 12.5)


def gear():
    """Returns a ring gear of 60 teeth on a disc."""
    angles = np.arange(240) * 2 * math.pi / 240
    radii = np.tile([48.0, 48.0, 50.2, 50.2], 60)
    return loft(_polar(radii, angles), np.linspace(0, 9, 4), turns=np.linspace(0, 0.06, 4))


def clip():
    """Returns a spring clip: a band of 1.4 mm bent round 300 degrees, with ends bent outward."""
    arc = _polar(30, np.linspace(0.5, 5.7, 60))
    low, high = arc[0], arc[-1]
    ends = np.linspace(0.2, 1, 5)[:, None]
    middle = np.vstack([(low + ends * [26, 6])[::-1], arc, high + ends * [26, -6]])
    return loft(_band(middle, 1.4), np.linspace(0, 18, 3))


def volute():
    """Returns a spiral wall of 1.2 mm that widens upward."""
    angles = np.linspace(0, 5 * math.pi, 150)
    middle = _polar(8 + 2.4 * angles, angles)
    return loft(_band(middle, 1.2), np.linspace(0, 30, 6), scales=np.linspace(0.8, 1.1, 6))


def tray():
    """Returns an open tray with walls of 1.3 mm, three ribs and a rim."""
    xs = [0, 1.3, 24, 25.3, 50, 51.1, 75, 76.3, 98.7, 100]
    ys = [0, 1.3, 20, 21.2, 58.7, 60]
    zs = [0, 1.5, 12, 17, 20]
    full = np.zeros((9, 5, 4), bool)
    full[:, :, 0] = True
    full[[0, -1], :, :] = full[:, [0, -1], :] = True
    full[[2, 4, 6], :, 1] = True
    full[:, 2, 1:3] = True
    return blocks(xs, ys, zs, full)


FONT = {
    "S": "0111 1000 0110 0001 1110", "W": "10001 10001 10101 11011 10001", "E": "111 100 110 100 111",
    "P": "1110 1001 1110 1000 1000", "T": "11111 00100 00100 00100 00100", "7": "1111 0001 0010 0100 0100",
}  # fmt: skip


def _letters(text):
    """Returns a text as an array of pixels [x, y], with a blank column after each letter."""
    columns = []
    for letter in text:
        rows = np.array([[int(c) for c in row] for row in FONT[letter].split()], bool)
        columns += [*rows[::-1].T, np.zeros(5, bool)]
    return np.pad(np.array(columns[:-1]), ((1, 1), (1, 1)))


def label(depth):
    """Returns a plate with letters, engraved (depth above 0) or raised."""
    pixels = _letters("SWEPT7")
    for x, y in np.argwhere(
        pixels[:-1, 1:] & pixels[1:, :-1] & ~pixels[:-1, :-1] & ~pixels[1:, 1:]
    ):
        pixels[x, y] = True  # blocks that share only an edge are not a manifold
    for x, y in np.argwhere(
        pixels[:-1, :-1] & pixels[1:, 1:] & ~pixels[:-1, 1:] & ~pixels[1:, :-1]
    ):
        pixels[x + 1, y] = True
    wide, high = pixels.shape
    full = np.ones((wide, high, 2), bool)
    full[:, :, 1] = ~pixels if depth > 0 else pixels
    xs, ys = np.linspace(0, 100, wide + 1), np.linspace(0, 30, high + 1)
    return blocks(xs, ys, [0, 4, 4 + abs(depth)], full)


def fins():
    """Returns a heat sink with 16 fins of 1.2 mm."""
    xs = np.sort(np.concatenate([6.2 * np.arange(16), 6.2 * np.arange(16) + 1.2]))
    full = np.zeros((len(xs) - 1, 1, 2), bool)
    full[:, :, 0] = True
    full[::2, :, 1] = True
    return blocks(xs, [0, 50], [0, 4, 25], full)


def bracket():
    """Returns an angle of 2 mm sheet with gussets, slots and tabs."""
    xs = [0, 2, 15, 22, 40, 60, 62]
    ys = [0, 8, 10, 30, 38, 40, 60, 68, 70, 90, 92, 100]
    zs = [0, 2, 12, 20, 40, 46]
    full = np.zeros((6, 11, 5), bool)
    full[:5, :, 0] = True  # the foot
    full[0, :, :4] = True  # the upright
    full[1:3, [1, 4, 9], 1] = True  # gussets
    full[3, [3, 7], 0] = False  # slots
    full[0, [3, 6], 3] = False  # notches
    full[0, [1, 4, 8], 4] = True  # tabs upward
    full[5, [0, 2, 5, 10], 0] = True  # tabs outward
    return blocks(xs, ys, zs, full)


def motion(rng, size):
    """Returns 16 keys along a curved path about as long as the part, with turns of about 70
    degrees."""
    s = np.linspace(0, 1, KEYS)[:, None]
    straight, bend = rng.normal(size=(2, 3))
    straight /= np.linalg.norm(straight)
    places = size * (s * straight + 0.3 * np.sin(math.pi * s) * bend / np.linalg.norm(bend))
    start, axis, wobble = rng.normal(size=(3, 3))
    turns = []
    for at in s[:, 0]:
        tilted = axis / np.linalg.norm(axis) + 0.3 * math.sin(3 * at) * wobble
        turns.append(rotation(tilted, 70 * at) @ rotation(start, 50))
    return np.arange(KEYS, dtype=float), np.array([_quaternion(m) for m in turns]), places


def _quaternion(m):
    w = math.sqrt(max(1e-12, 1 + np.trace(m))) / 2
    x, y, z = m[2, 1] - m[1, 2], m[0, 2] - m[2, 0], m[1, 0] - m[0, 1]
    return np.array([x / (4 * w), y / (4 * w), z / (4 * w), w])


MAKERS = {
    "rotor": rotor, "thread": thread, "gear": gear, "clip": clip, "volute": volute, "tray": tray,
    "engraved": lambda: label(1.5), "raised": lambda: label(-1.2), "fins": fins, "bracket": bracket,
}  # fmt: skip


def parts():
    """Returns all ten parts."""
    made = []
    for number, (name, make) in enumerate(MAKERS.items()):
        rng = np.random.default_rng(SEED + number)
        vertices, triangles = make()
        made.append(ThinPart(name, vertices, triangles, motion(rng, 100.0)))
    return made
