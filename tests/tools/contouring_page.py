#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Makes what docs/contouring.md shows: the five component methods compared, tables and pictures.

    contouring_page.py BUILD [BODY...] [--pictures FOLDER]
    contouring_page.py BUILD --walls        thin walls in cells twice as wide, with the default method
    contouring_page.py BUILD --simplified --pictures FOLDER         a body before and after simplification

The bodies stand still. Lengths are in cells; 60,000 points are spread evenly over each surface. A point
belongs to the outer surface of the body if an envelope with four times as many cells lies within half of
its own cell. Such a point with no envelope within half a cell is "lost" if it is outside the envelope, and
"filled" if it is inside, because then a gap of the body is filled.
"""
import argparse
import collections
import pathlib
import sys

import numpy as np

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))

from mesh_picture import INNER, Picture  # noqa: E402
from shared_data import FOLDER  # noqa: E402

METHODS = ("dc", "dmc", "equivalence", "greedy", "consistent")
POINTS = 60000
FAR = 0.5  # cells
FINER = 4

Body = collections.namedtuple("Body", "title file unit cells columns panel centre toward up width")
#: Places where the five methods differ: centre and width of the picture in mm.
BODIES = {
    "fandisk": Body(
        title="fandisk",
        file="fandisk_13k.ply",
        unit="m",
        cells=128,
        columns=3,
        panel=(430, 320),
        centre=(-600, -35, -45),
        toward=(-0.37, 0.6, 0.71),
        up=(0, 0, 1),
        width=150,
    ),
    "thin_shell": Body(
        title="shell cover, walls of 0.6 cell",
        file="robot_leg_shell_cover_69k_thin.ply",
        unit="mm",
        cells=64,
        columns=2,
        panel=(600, 216),
        centre=(-64, 0, -6),
        toward=(0.3, -0.6, 1),
        up=(0, 1, 0),
        width=178,
    ),
    "housing": Body(
        title="housing",
        file="housing_two_halves_360k_thin.ply",
        unit="mm",
        cells=96,
        columns=3,
        panel=(430, 320),
        centre=(-43.7, -63.2, -25.4),
        toward=(0.54, 0.45, -0.71),
        up=(0, 0, 1),
        width=36,
    ),
}
#: File, unit, wall in mm (thinnest and median of the inward rays) of bodies with thin walls.
WALLS = (
    ("robot_leg_shell_cover_69k_thin.ply", "mm", (1.5, 1.94)),
    ("robot_leg_shell_base_72k_thin.ply", "mm", (1.5, 2.5)),
    ("ship_propeller_37k.ply", "m", (2.65, 7.83)),
)
MAGENTA, ORANGE, RED, WIRE = (200, 0, 200), (255, 120, 0), (215, 25, 28), (70, 80, 100)
MARKS = {
    MAGENTA: "open edge",
    ORANGE: "edge with more than two triangles",
    RED: "lost: body outside the envelope, half a cell or more from it",
    INNER: "inner side",
}

Envelope = collections.namedtuple("Envelope", "vertices triangles report")


def spread(vertices, triangles, count):
    """Returns points that are spread evenly over a mesh."""
    random = np.random.default_rng(1)
    a, b, c = (vertices[triangles[:, k]] for k in range(3))
    sums = np.cumsum(np.linalg.norm(np.cross(b - a, c - a), axis=1))
    at = (np.arange(count) + random.random(count)) / count * sums[-1]
    which = np.minimum(np.searchsorted(sums, at), len(triangles) - 1)
    u, v = random.random((2, count))
    turned = u + v > 1
    u[turned], v[turned] = 1 - u[turned], 1 - v[turned]
    return a[which] + u[:, None] * (b - a)[which] + v[:, None] * (c - a)[which]


def all_edges(triangles):
    return np.concatenate([triangles[:, [0, 1]], triangles[:, [1, 2]], triangles[:, [2, 0]]])


def edges_by_use(triangles, count):
    """Returns (open, non-manifold) edges: those with one triangle, and those with more than two."""
    edges = np.sort(all_edges(triangles))
    keys, used = np.unique(edges[:, 0].astype(np.int64) * count + edges[:, 1], return_counts=True)
    pairs = np.stack([keys // count, keys % count], 1)
    return pairs[used == 1], pairs[used > 2]


def inside(points, mesh):
    """Returns which points lie inside a mesh, by winding numbers. Holes change the result little."""
    angles = np.zeros(len(points))
    for n, point in enumerate(points):
        a, b, c = (mesh.vertices[mesh.triangles[:, k]] - point for k in range(3))
        la, lb, lc = (np.linalg.norm(x, axis=1) for x in (a, b, c))
        down = la * lb * lc + (a * b).sum(1) * lc + (b * c).sum(1) * la + (c * a).sum(1) * lb
        angles[n] = np.arctan2((a * np.cross(b, c)).sum(1), down).sum() / (2 * np.pi)
    return angles > 0.5


def closed(vertices, triangles):
    """Returns the mesh with each open rim closed by a fan of triangles around the middle of the rim."""
    vertices, back = np.unique(vertices, axis=0, return_inverse=True)
    triangles = back.reshape(-1)[triangles]
    edges = all_edges(triangles)
    keys = edges[:, 0].astype(np.int64) * len(vertices) + edges[:, 1]
    turned = edges[:, 1].astype(np.int64) * len(vertices) + edges[:, 0]
    follows = dict(map(tuple, edges[~np.isin(keys, turned)][:, ::-1].tolist()))
    middles, fans = [], []
    while follows:
        start, rim = next(iter(follows)), []
        while start in follows:
            rim.append((start, follows.pop(start)))
            start = rim[-1][1]
        fans += [(a, b, len(vertices) + len(middles)) for a, b in rim]
        middles.append(vertices[[a for a, _ in rim]].mean(0))
    if not fans:
        return vertices, triangles
    return np.concatenate([vertices, middles]), np.concatenate([triangles, fans])


class Comparison:
    """The envelopes of one body, made by some of the five methods. `size`: resolution=cells or cell=mm."""

    def __init__(self, swept, file, unit, methods, **size):
        self.swept = swept
        mesh = swept.read_mesh(str(FOLDER / "meshes" / file), unit)
        self.mesh = closed(np.asarray(mesh.vertices), np.asarray(mesh.triangles))
        self.envelopes = {method: self.envelope(method, **size) for method in methods}
        self.cell = self.envelopes[methods[0]].report["cell"]
        self.fine = self.envelope("consistent", cell=self.cell / FINER)

    def envelope(self, method, **size):
        made = self.swept.compute(*self.mesh, np.eye(4)[None], components=method, **size)
        return Envelope(np.asarray(made.vertices), np.asarray(made.triangles), made.report)

    def distance(self, points, mesh):
        """Returns the distances of points from a mesh, in cells."""
        return np.abs(self.swept.distance_to_mesh(points, *mesh[:2])) / self.cell

    def outer(self, points):
        """Returns those of the body's points that lie on its outer surface."""
        return points[self.distance(points, self.fine) <= 0.5 / FINER]

    def far(self, method, count):
        """Returns (distances, lost points, filled points) of `count` points of the body's outer
        surface."""
        points = self.outer(spread(*self.mesh, count))
        distances = self.distance(points, self.envelopes[method])
        points = points[distances > FAR]
        filled = inside(points, self.envelopes[method])
        return distances, points[~filled], points[filled]

    def row(self, method):
        made = self.envelopes[method]
        report = made.report
        forth = self.distance(spread(made.vertices, made.triangles, POINTS), self.mesh)
        back, *far = self.far(method, POINTS)
        figures = [f"{np.quantile(d, 0.99):.3f} / {d.max():.2f}" for d in (forth, back)]
        shares = [f"{100 * len(points) / len(back):.2f} %" for points in far]
        bad = f"{report['non_manifold_edges']} / {report['non_manifold_vertices']}"
        counts = [report["open_edges"], bad, report["self_intersections"]]
        return (method, f"{report['triangles']:,}", *counts, *figures, *shares)

    def marks(self, method):
        """Returns the ends of open edges, the ends of non-manifold edges, and the lost points of
        the body's outer surface."""
        made = self.envelopes[method]
        ends = [made.vertices[e] for e in edges_by_use(made.triangles, len(made.vertices))]
        return (*ends, self.far(method, 2 * POINTS)[1])

    def panel(self, body, method, marks):
        """Draws the body, or an envelope with its marks, in the view of `body`. Returns the pixels."""
        picture = Picture(body.panel, body.centre, body.toward, body.up, body.width)
        if method not in self.envelopes:
            picture.fill(*self.mesh)
            return picture.array()
        draw_net(picture, *self.envelopes[method][:2])
        alone, many, lost = marks
        picture.dots(lost, RED, 1.5, 1)
        picture.lines(*many.transpose(1, 0, 2), ORANGE, 2, 4)
        picture.lines(*alone.transpose(1, 0, 2), MAGENTA, 2, 4)
        return picture.array()


def draw_net(picture, vertices, triangles):
    """Draws the triangles of a mesh and their edges."""
    picture.fill(vertices, triangles)
    edges = all_edges(triangles)
    edges = edges[edges[:, 0] < edges[:, 1]]
    picture.lines(vertices[edges[:, 0]], vertices[edges[:, 1]], WIRE, 0.3, 0.5)


def write(panels, columns, legend, path):
    """Writes one picture of panels {title: pixels}, side by side, with a legend {colour: text}."""
    from PIL import Image, ImageDraw, ImageFont

    down = -(-len(panels) // columns)
    high, wide = (a + b for a, b in zip(next(iter(panels.values())).shape, (24, 8)))
    page = Image.new("RGB", (columns * wide, down * high + 24 * bool(legend)), "white")
    draw, font = ImageDraw.Draw(page), ImageFont.truetype("DejaVuSans.ttf", 14)
    for n, (title, pixels) in enumerate(panels.items()):
        x, y = n % columns * wide, n // columns * high
        page.paste(Image.fromarray(pixels), (x, y + 22))
        draw.text((x + 4, y + 3), title, "black", font)
    x, y = 4, down * high + 4
    for colour, text in legend.items():
        draw.rectangle((x, y, x + 12, y + 12), colour)
        draw.text((x + 18, y - 2), text, "black", font)
        x += 40 + draw.textlength(text, font)
    few = Image.new("P", (1, 1))  # its palette contains the exact colours of the legend
    few.putpalette(page.quantize(120).getpalette()[:360] + [x for mark in legend for x in mark])
    page.quantize(palette=few, dither=Image.Dither.NONE).save(path, optimize=True)


def simplified(swept, folder):
    """Draws the fandisk at 128 cells, and simplified within 1.5 mm."""
    mesh = swept.read_mesh(str(FOLDER / "meshes/fandisk_13k.ply"), "m")
    panels = {}
    for tolerance in (0, 1.5):
        made = swept.compute(
            mesh.vertices, mesh.triangles, np.eye(4)[None], resolution=128, tolerance=tolerance
        )
        report = made.report
        picture = Picture((560, 440), (0, 0, -100), (1, -1.6, 1.4), (0, 0, 1), 2650)
        draw = draw_net if tolerance else Picture.fill
        draw(picture, np.asarray(made.vertices), np.asarray(made.triangles))
        title = f"{report['triangles']:,} triangles"
        if tolerance:
            title += f", at most {report['simplification_deviation']:.2f} mm away"
        panels[title] = picture.array()
        print(title, f"(cell {report['cell']:.2f} mm)")
    write(panels, 2, {}, folder / "simplified_fandisk.png")


def show(*cells):
    print("| " + " | ".join(map(str, cells)) + " |", flush=True)


def walls(swept):
    """Measures thin walls with cells twice as wide as the thinnest and the median wall."""
    for file, unit, widths in WALLS:
        for width in widths:
            made = Comparison(swept, file, unit, ("consistent",), cell=2 * width)
            show(file, f"{2 * width:.2f} mm", *made.row("consistent")[1:])


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("build")
    parser.add_argument("body", nargs="*", default=list(BODIES))
    parser.add_argument("--pictures", type=pathlib.Path)
    parser.add_argument("--walls", action="store_true")
    parser.add_argument("--simplified", action="store_true")
    arguments = parser.parse_args()
    sys.path.insert(0, str(pathlib.Path(arguments.build) / "python"))
    import _swept

    if arguments.walls:
        return walls(_swept)
    if arguments.simplified:
        return simplified(_swept, arguments.pictures)
    for name in arguments.body:
        body = BODIES[name]
        comparison = Comparison(_swept, body.file, body.unit, METHODS, resolution=body.cells)
        for method in METHODS:
            show(
                f"{body.title}, {body.cells}" if method == METHODS[0] else "",
                *comparison.row(method),
            )
        if arguments.pictures:
            panels = {"body": comparison.panel(body, "body", None)}
            for method in METHODS:
                panels[method] = comparison.panel(body, method, comparison.marks(method))
            write(panels, body.columns, MARKS, arguments.pictures / f"components_{name}.png")


if __name__ == "__main__":
    main()
