# SPDX-License-Identifier: LGPL-2.1-or-later
"""Bodies of the corpus: generated bodies for every row of the table of bad input, and variants of
the shared meshes.

`all_bodies` gives entries (name, family, valid, make); make() -> (vertices, triangles, cell).
valid: a solid whose run must end with the status Ok; others end as docs/bad_input.md says.
cell: None, or the cell size to use for the resolution of 64 cells.
"""
import numpy as np

from bodies import ball, box, frame, joined, moved, prism, torus
from shared_data import FOLDER

SEEDS = 50
#: Bodies that are closed and orientable: they are valid solids, and so are their mirrored copies.
CLOSED = (
    "armadillo beam_joint bunny counter_wheel differential fandisk gripper housing robot_leg tooth"
).split()


def solid(rng):
    """Returns a box, prism, torus or ball, or two of them, turned by random angles; 1 to 5 mm."""

    def piece():
        kind = rng.integers(4)
        if kind == 0:
            half = rng.uniform(0.6, 2.5, 3)
            made = box(-half, half)
        elif kind == 1:
            made = prism(int(rng.integers(3, 24)), *rng.uniform((0.7, 1, 0.3), (2, 3, 1.5)))
        elif kind == 2:
            made = torus(rng.uniform(1.8, 2.5), rng.uniform(0.5, 1), 24, 12)
        else:
            made = ball(rng.uniform(0.8, 2))
        return moved(made, frame(rng.normal(size=3), rng.uniform(0, 180), rng.normal(size=3)))

    return joined(piece(), piece()) if rng.random() < 0.4 else piece()


def empty(rng, body):
    v, t = body
    return (v[:0], t[:0]) if rng.random() < 0.5 else (v, t[:0])


def bad_index(rng, body):
    v, t = body
    t = t.copy()
    t[rng.integers(len(t)), rng.integers(3)] = rng.choice([len(v), -1, 2**31 - 1])
    return v, t


def not_finite(rng, body):
    v, t = body
    v = v.copy()
    v[rng.integers(len(v)), rng.integers(3)] = rng.choice([np.nan, np.inf, -np.inf])
    return v, t


def degenerate(rng, body):
    v, t = body
    a, b = rng.integers(0, len(v), (2, 7))
    v = np.vstack([v, (v[a] + v[b]) / 2])
    middle = np.arange(len(v) - 7, len(v))
    return v, np.vstack([t, np.stack([a, a, b], 1), np.stack([a, middle, b], 1)])


def soup(rng, body):
    v, t = body
    return v[t.ravel()], np.arange(3 * len(t)).reshape(-1, 3)


def opened(rng, body):
    v, t = body
    gone = rng.integers(1, max(2, len(t) // 3))
    return v, t[np.sort(rng.permutation(len(t))[gone:])]


def inward(rng, body):
    return body[0], body[1][:, ::-1]


def mixed(rng, body):
    v, t = body
    t = t.copy()
    turned = rng.random(len(t)) < rng.uniform(0.02, 0.6)
    t[turned] = t[turned][:, ::-1]
    return v, t


def touching(rng, body):
    """Returns two boxes that share an edge or a corner and its vertices, and a third body that touches
    neither.
    """
    first = box((0, 0, 0), (1, 1, 1))
    shift = np.array([1, 1, 0]) if rng.random() < 0.5 else np.array([1, 1, 1])
    v, t = joined(first, (first[0] + shift, first[1]), moved(body, frame((0, 0, 1), 0, (9, 0, 0))))
    unique, index = np.unique(v, axis=0, return_inverse=True)
    return unique, index.reshape(-1)[t]


def overlapping(rng, body):
    return joined(body, moved(solid(rng), frame((0, 0, 1), 20, rng.uniform(-1, 1, 3))))


def repeated(rng, body):
    v, t = body
    return v, np.vstack([t, t[rng.integers(0, len(t), 5)]])


def back_to_back(rng, body):
    v, t = body
    more = v[:4] * 1.7 + 3
    n = len(v)
    return np.vstack([v, more]), np.vstack([t, [(n, n + 1, n + 2), (n, n + 2, n + 1)]])


def hollow(rng, body):
    v, t = ball(3, 24, 12)
    inner = rng.uniform(0.3, 0.9)
    return joined((v, t), (v * inner, t[:, ::-1]))


def thin(rng, body):
    return moved(
        box((-2, -1.5, 0), (2, 1.5, 10 ** rng.uniform(-6, -1))),
        frame(rng.normal(size=3), rng.uniform(0, 180), (0, 0, 0)),
    )


def needle(rng, body):
    width = 10 ** rng.uniform(-9, -4)
    spike = moved(
        box((0, 0, 0), (6, width, width)),
        frame(rng.normal(size=3), rng.uniform(0, 180), (0, 0, 0)),
    )
    return joined(body, spike) if rng.random() < 0.7 else spike


def far(rng, body):
    return body[0] + 10 ** rng.uniform(2, 13, 3) * rng.choice([-1, 1], 3), body[1]


def sized(rng, body):
    return body[0] * 10 ** rng.uniform(-9, 8), body[1]


def uneven(rng, body):
    return body[0] * 10 ** rng.uniform(-4, 2, 3), body[1]


def crumpled(rng, body):
    return body[0] + rng.normal(0, 10 ** rng.uniform(-3, 0), body[0].shape), body[1]


def any_cell(rng, body):
    return body


#: Name, which begins with the row of the table of bad input (or 00); change to a body; whether the result is
#: a valid solid.
FAMILIES = [
    ("00_solid", any_cell, True),
    ("01_empty", empty, False),
    ("02_bad_index", bad_index, False),
    ("03_not_finite", not_finite, False),
    ("04_degenerate", degenerate, True),
    ("05_soup", soup, True),
    ("06_open", opened, False),
    ("07_inward", inward, True),
    ("08_mixed", mixed, True),
    ("09_touching", touching, True),
    ("10_overlapping", overlapping, True),
    ("11_repeated", repeated, True),
    ("11_back_to_back", back_to_back, True),
    ("12_hollow", hollow, True),
    ("13_thin", thin, False),
    ("14_far", far, False),
    ("15_cell", any_cell, False),
    ("15_size", sized, False),
    ("45_needle", needle, False),
    ("uneven", uneven, False),
    ("crumpled", crumpled, False),
]


def made(family, change, seed):
    rng = np.random.default_rng([seed, FAMILIES_INDEX[family]])
    vertices, triangles = change(rng, solid(rng))
    cell = float(10 ** rng.uniform(-7, 5)) if family == "15_cell" else None
    return vertices, triangles, cell


FAMILIES_INDEX = {name: i for i, (name, _, _) in enumerate(FAMILIES)}


def decimated(v, t, cells):
    """Merges the vertices in each cell of a lattice. A closed mesh stays closed, but a manifold may not
    stay one."""
    low, size = v.min(axis=0), np.ptp(v, axis=0).max()
    key = np.floor((v - low) / size * cells).astype(np.int64)
    _, index = np.unique(key, axis=0, return_inverse=True)
    index = index.reshape(-1)
    means = np.stack([np.bincount(index, v[:, k]) for k in range(3)], axis=1)
    return means / np.bincount(index)[:, None], index[t]


def variants(v, t, seed):
    """Yields variants of a shared mesh: (word, whether a valid solid stays valid, body)."""
    rng = np.random.default_rng(seed)
    size = np.ptp(v, axis=0).max()
    normal = rng.normal(size=3)
    centre = v.mean(axis=0)
    yield "plain", True, lambda: (v, t)
    yield "mirrored", True, lambda: (v * (-1, 1, 1), t[:, ::-1])
    yield "mirrored_inward", True, lambda: (v * (1, -1, 1), t)
    yield "merged", True, lambda: joined((v, t), (v + size * rng.uniform(0.1, 0.4, 3), t))
    yield "merged_box", True, lambda: joined((v, t), box(centre - size / 5, centre + size / 4))
    for cells in (12, 40):
        yield f"decimated_{cells}", False, lambda cells=cells: decimated(v, t, cells)
    for fraction in (1e-4, 1e-2):
        yield f"noised_{fraction:g}", False, lambda fraction=fraction: (
            v + rng.normal(0, fraction * size, v.shape),
            t,
        )
    yield "cut", False, lambda: (v, t[((v[t].mean(axis=1) - centre) @ normal) < 0])


def all_bodies(swept):
    """Returns all entries. A file is read only when its body is made."""
    for seed in range(SEEDS):
        for name, change, valid in FAMILIES:
            yield f"{name}/{seed}", name, valid, (
                lambda name=name, change=change, seed=seed: made(name, change, seed)
            )
    for path in sorted((FOLDER / "meshes").glob("*.ply")):
        whole = path.stem.startswith(tuple(CLOSED))
        for number, (word, keeps, _) in enumerate(
            variants(np.zeros((3, 3)), np.eye(3, dtype=int), 0)
        ):

            def make(path=path, number=number):
                body = swept.read_mesh(str(path))
                v, t = np.array(body.vertices), np.array(body.triangles)
                return (*list(variants(v, t, 7))[number][2](), None)

            yield f"{path.stem}/{word}", "shared_" + word, whole and keeps, make
