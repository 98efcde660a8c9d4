# SPDX-License-Identifier: LGPL-2.1-or-later
"""FreeCAD objects <-> numpy arrays. Units: mm, s. No GUI.

Ways chosen by measurement: meshes go in and out as binary PLY, solids are meshed by MeshPart.
Coordinates of a FreeCAD mesh are single precision, so bodies are taken in their own local frame and
moved to the world in double precision.
"""
import io
import os
import tempfile
import threading

import FreeCAD as App
import numpy as np

from . import core
from .texts import translate

#: Angular deflection of meshed solids (rad); the linear one follows the cell.
ANGULAR_DEFLECTION = 0.35


class InputProblem(ValueError):
    """Something selected cannot be swept; the text says what, why and what to do."""


class Body:
    """Parts as they stood when they were read, as triangles in world coordinates (mm), and the placement
    of the first one.

    The triangles are made when they are first asked for, in any thread: FreeCAD's mesher lets the window
    go on. Raises InputProblem then if a part gives none."""

    def __init__(self, parts, placement, labels):
        self._parts = parts  # (label, 4x4 to the world, function that gives vertices and triangles)
        self.placement = placement
        self.labels = labels
        self._arrays, self._seen, self._lock = None, None, threading.Lock()

    @property
    def vertices(self):
        return self.arrays()[0]

    @property
    def triangles(self):
        return self.arrays()[1]

    def arrays(self):
        """Vertices (n,3) and triangles (m,3)."""
        with self._lock:
            if self._arrays is None:
                self._arrays = self._made()
                self._parts = None
        return self._arrays

    def _made(self):
        vertices, triangles, count = [], [], 0
        for label, matrix, read in self._parts:
            try:
                points, facets = read()
            except InputProblem as problem:
                raise InputProblem('"{}": {}'.format(label, problem)) from None
            vertices.append(transform(matrix, points))
            triangles.append(facets + count)
            count += len(points)
        return np.vstack(vertices), np.vstack(triangles).astype(np.int32)

    def seen(self, matrix):
        """The vertices moved by a 4x4 matrix; those of the last call are kept."""
        if self._seen is None or not np.array_equal(self._seen[0], matrix):
            self._seen = matrix, transform(matrix, self.vertices)
        return self._seen[1]


# --- placements


def matrix_of(placement):
    """Placement -> 4x4 float64."""
    return np.array(placement.toMatrix().A, dtype=float).reshape(4, 4)


def pose_arrays(placements):
    """Placements -> translations (n,3) in mm, quaternions (n,4) as x,y,z,w."""
    translations = np.array([tuple(p.Base) for p in placements], dtype=float).reshape(-1, 3)
    rotations = np.array([p.Rotation.Q for p in placements], dtype=float).reshape(-1, 4)
    return translations, rotations


def placements_from(translations, rotations):
    """The way back from pose_arrays."""
    return [
        App.Placement(App.Vector(*map(float, t)), App.Rotation(*map(float, q)))
        for t, q in zip(translations, rotations)
    ]


def transform(matrix, points):
    """Applies a 4x4 matrix to (n,3) points."""
    return points @ matrix[:3, :3].T + matrix[:3, 3]


# --- meshes


def _far_middle(vertices):
    """Middle of a mesh that is farther from the origin than 32 times its size, in whole mm, or None."""
    if not len(vertices) or not np.isfinite(vertices).all():
        return None
    low, high = vertices.min(axis=0), vertices.max(axis=0)
    middle = np.round((low + high) / 2)
    return middle if np.abs(middle).max() > 32 * (high - low).max() else None


def _ply(vertices, triangles):
    """As FreeCAD reads a binary PLY file."""
    head = (
        "ply\nformat binary_little_endian 1.0\nelement vertex {}\nproperty float x\n"
        "property float y\nproperty float z\nelement face {}\n"
        "property list uchar int vertex_indices\nend_header\n"
    ).format(len(vertices), len(triangles))
    faces = np.zeros(len(triangles), dtype=[("c", "u1"), ("i", "<i4", 3)])
    faces["c"] = 3
    faces["i"] = triangles
    return head.encode() + np.ascontiguousarray(vertices, "<f4").tobytes() + faces.tobytes()


class _Stream:
    """Bytes to read. FreeCAD asks for some hundred at a time, and between two of these calls other
    threads come to their turn, which they would not with a stream that is no Python code."""

    def __init__(self, data):
        self._inner = io.BytesIO(data)

    def read(self, size=-1):
        return self._inner.read(size)

    def seek(self, *where):
        return self._inner.seek(*where)

    def tell(self):
        return self._inner.tell()


def mesh_from_arrays(vertices, triangles, beside=False):
    """(n,3) and (m,3) -> Mesh.Mesh, the order of points kept. `beside`: in a thread beside the window's,
    which goes on meanwhile.

    Far from the origin single precision would bend the mesh: there it is local, with a placement.
    """
    import Mesh

    middle = _far_middle(vertices)
    if middle is not None:
        mesh = mesh_from_arrays(vertices - middle, triangles, beside)
        mesh.Placement = App.Placement(App.Vector(*middle), App.Rotation())
        return mesh
    mesh = Mesh.Mesh()
    if beside:
        try:
            mesh.read(_Stream(core.mesh_file(vertices, triangles)), "BMS")
        except Exception as problem:  # a FreeCAD that takes no such stream
            App.Console.PrintLog("Swept Volume: mesh not read as BMS: {}\n".format(problem))
        if (mesh.CountPoints, mesh.CountFacets) == (len(vertices), len(triangles)):
            return mesh
        mesh = Mesh.Mesh()
    mesh.read(io.BytesIO(_ply(vertices, triangles)), "PLY")
    return mesh


def _no_room_text():
    return translate(
        "Messages",
        "the mesh could not be written to the temporary folder {0}: make room there, or set the "
        "environment variable TMPDIR to another folder.",
    ).format(tempfile.gettempdir())


def arrays_from_mesh(mesh):
    """Mesh.Mesh -> vertices, triangles in the mesh's own frame (its Placement is left out)."""
    local = mesh.copy()
    local.Placement = App.Placement()
    handle, path = tempfile.mkstemp(suffix=".ply")
    os.close(handle)
    try:
        local.write(path)
        with open(path, "rb") as file:
            data = file.read()
    finally:
        os.remove(path)
    if b"end_header\n" not in data:
        raise InputProblem(_no_room_text())
    start = data.index(b"end_header\n") + len(b"end_header\n")
    head = data[:start].decode("ascii")
    points = int(head.split("element vertex ")[1].split()[0])
    facets = int(head.split("element face ")[1].split()[0])
    if len(data) < start + 12 * points + 13 * facets:
        raise InputProblem(_no_room_text())
    vertices = np.frombuffer(data, "<f4", points * 3, start).reshape(-1, 3).astype(float)
    kind = [("c", "u1"), ("i", "<i4", 3)]
    triangles = np.frombuffer(data, kind, facets, start + 12 * points)["i"].astype(np.int32)
    return vertices, triangles


def _shape_reader(shape, deflection):
    """As reader()."""
    import MeshPart

    if not shape.Solids and not any(s.isClosed() for s in shape.Shells):
        raise InputProblem(
            translate(
                "Messages",
                "the shape has no solid (faces: {0}). Sweep a solid or a closed mesh; Part > Convert to "
                "solid or Part > Shape builder close a shape.",
            ).format(len(shape.Faces))
        )
    # A copy: the triangulation is cached in the shape, a finer one would be reused for ever.
    local = shape.copy()
    local.Placement = App.Placement()

    def read():
        mesh = MeshPart.meshFromShape(
            Shape=local,
            LinearDeflection=float(deflection),
            AngularDeflection=ANGULAR_DEFLECTION,
            Relative=False,
        )
        if mesh.CountFacets == 0:
            raise InputProblem(translate("Messages", "the shape gave no triangles."))
        return arrays_from_mesh(mesh)

    return read


# --- objects of a document


def split_path(root, sub):
    """Drops a trailing element name ("L.Box.Face3" -> "L.Box.")."""
    return sub[: sub.rfind(".") + 1] if sub else ""


def root_path(obj):
    """(root, sub) through which an object given alone is seen in the document.

    The first chain of groups is taken, so that moving a group around the object is noticed.
    """
    for root, sub in getattr(obj, "Parents", []) or []:
        if root.isDerivedFrom("App::DocumentObject") and not root.isDerivedFrom("App::Link"):
            return root, sub
    return obj, ""


def links_in(links):
    """Value of a LinkSubList or LinkSub property -> flat list of (object, sub), as it stands."""
    if isinstance(links, tuple):
        links = [links]
    pairs = []
    for root, subs in links or []:
        names = [subs] if isinstance(subs, str) else list(subs)
        pairs += [(root, name) for name in (names or [""])]
    return pairs


def pairs_of(links):
    """The same as (root, sub), each from the outermost group around the object."""
    pairs = []
    for obj, sub in links_in(links):
        root, path = root_path(obj)
        pairs.append((root, path + sub))
    return pairs


def label_of(root, sub):
    """What the tree shows for a path, for messages."""
    target = root.getSubObject(sub, retType=1)
    return target.Label if target is not None else "{}.{}".format(root.Label, sub)


def targets(pairs):
    """The objects at the ends of paths, as far as they lead to one."""
    found = [root.getSubObject(sub, retType=1) for root, sub in pairs]
    return [obj for obj in found if obj is not None]


def global_placement(root, sub):
    """Placement of the object at the end of a path, seen from the document."""
    return root.getSubObject(sub, retType=3)


def global_matrix(root, sub):
    """World from the frame of the linked geometry: placements, scales and transforms of links."""
    target = root.getSubObject(sub, retType=1)
    path = np.array(root.getSubObject(sub, retType=4).A, dtype=float).reshape(4, 4)
    inner = target.getLinkedObject(True, App.Matrix(), False)[1]
    return path @ np.array(inner.A, dtype=float).reshape(4, 4)


def leaves(root, sub="", hidden=False):
    """All shapes and meshes below a path: list of (linked object, path).

    Hidden children are left out (they are inputs of booleans as a rule), the path itself is not.
    """
    target = root.getSubObject(sub, retType=1)
    if target is None:
        raise InputProblem(
            translate(
                "Messages", '"{0}" no longer leads to an object; choose the part again.'
            ).format(root.Label + "." + sub)
        )
    if hidden and not getattr(target, "Visibility", True):
        return []
    linked = target.getLinkedObject(True)
    if hasattr(linked, "Mesh") and linked.isDerivedFrom("Mesh::Feature"):
        return [(linked, sub)]
    if hasattr(linked, "Shape") and linked.isDerivedFrom("Part::Feature"):
        return [(linked, sub)]
    found = []
    for child in target.getSubObjects():
        # Groups may name elements of a shape here; only names that end in a dot are objects.
        if child.endswith("."):
            found += leaves(root, sub + child, hidden=True)
    return found


def reader(linked, deflection):
    """A shape or a mesh as it is now: a function for any thread that gives vertices (n,3) and triangles
    (m,3) in its own frame. deflection: mm, chord height of solids. Raises InputProblem, and so does the
    function."""
    if linked.isDerivedFrom("Mesh::Feature"):
        mesh = linked.Mesh.copy()
        return lambda: arrays_from_mesh(mesh)
    return _shape_reader(linked.Shape, deflection)


def solid_like(linked):
    """Helper geometry inside groups (datum planes, sketches) is passed over silently."""
    return linked.isDerivedFrom("Mesh::Feature") or bool(linked.Shape.Solids or linked.Shape.Shells)


def no_part_text():
    return translate("Messages", "no moving part is given: choose a solid or a mesh that moves.")


def body_from(pairs, deflection):
    """All generators of a LinkSubList as one body. `deflection`: mm, for solids."""
    if not pairs:
        raise InputProblem(no_part_text())
    read, labels = [], []
    for root, sub in pairs:
        label = label_of(root, sub)
        labels.append(label)
        parts = leaves(root, sub)
        if len(parts) > 1:
            parts = [part for part in parts if solid_like(part[0])]
        if not parts:
            raise InputProblem(
                translate("Messages", '"{0}" holds neither a solid nor a mesh.').format(label)
            )
        for linked, path in parts:
            try:
                read.append((label, global_matrix(root, path), reader(linked, deflection)))
            except InputProblem as problem:
                raise InputProblem('"{}": {}'.format(label, problem)) from None
    return Body(read, global_placement(*pairs[0]), labels)


def box_corners(pairs):
    """The eight world corners of each leaf's box (k,3): cheap, no meshing."""
    corners = []
    for root, sub in pairs:
        parts = leaves(root, sub)
        for linked, path in parts:
            if len(parts) > 1 and not solid_like(linked):
                continue
            data = (
                linked.Mesh.copy() if linked.isDerivedFrom("Mesh::Feature") else linked.Shape.copy()
            )
            data.Placement = App.Placement()
            box = data.BoundBox
            if not box.isValid():
                continue
            local = np.array(
                [
                    (x, y, z)
                    for x in (box.XMin, box.XMax)
                    for y in (box.YMin, box.YMax)
                    for z in (box.ZMin, box.ZMax)
                ]
            )
            corners.append(transform(global_matrix(root, path), local))
    if not corners:
        raise InputProblem(translate("Messages", "the moving part is empty."))
    return np.vstack(corners)
