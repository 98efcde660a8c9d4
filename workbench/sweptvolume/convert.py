# SPDX-License-Identifier: LGPL-2.1-or-later
"""FreeCAD objects <-> numpy arrays. Units: mm, s. No GUI.

Coordinates of a FreeCAD mesh are single precision, so bodies are taken in their own local frame and
moved to the world in double precision.
"""
import FreeCAD as App
import numpy as np

from . import apart, core
from .body import Body, InputProblem, transform  # noqa: F401 (read from here as well)
from .meshes import arrays_from_mesh, mesh_from_arrays  # noqa: F401 (read from here as well)
from .safe_file import passing
from .texts import translate

#: Angular deflection of meshed solids (rad); the linear one follows the cell.
ANGULAR_DEFLECTION = 0.35


# --- placements


def matrix_of(placement):
    """Placement -> 4x4 float64."""
    return np.array(placement.toMatrix().A, dtype=float).reshape(4, 4)


def pose_arrays(placements):
    """Placements -> translations (n,3) in mm, quaternions (n,4) as x,y,z,w."""
    translations = np.array([tuple(p.Base) for p in placements], dtype=float).reshape(-1, 3)
    rotations = np.array([p.Rotation.Q for p in placements], dtype=float).reshape(-1, 4)
    return translations, rotations


def matrices_from(translations, rotations):
    """The same as 4x4 matrices (n,4,4), to the last bit as matrix_of() has them."""
    x, y, z, w = np.asarray(rotations).T
    size = np.sqrt(x * x + y * y + z * z + w * w)
    x, y, z, w = x / size, y / size, z / size, w / size
    found = np.zeros((len(translations), 4, 4))
    found[:, 0, 0] = 1.0 - 2.0 * (y * y + z * z)
    found[:, 0, 1] = 2.0 * (x * y - z * w)
    found[:, 0, 2] = 2.0 * (x * z + y * w)
    found[:, 1, 0] = 2.0 * (x * y + z * w)
    found[:, 1, 1] = 1.0 - 2.0 * (x * x + z * z)
    found[:, 1, 2] = 2.0 * (y * z - x * w)
    found[:, 2, 0] = 2.0 * (x * z - y * w)
    found[:, 2, 1] = 2.0 * (y * z + x * w)
    found[:, 2, 2] = 1.0 - 2.0 * (x * x + y * y)
    found[:, :3, 3] = translations
    found[:, 3, 3] = 1.0
    return found


def placements_from(translations, rotations):
    """The way back from pose_arrays."""
    return [
        App.Placement(App.Vector(*map(float, t)), App.Rotation(*map(float, q)))
        for t, q in zip(translations, rotations)
    ]


# --- solids and meshes as bodies


def _faces_of_facets(mesh, shape):
    """(m,): number of the shape's face that each facet is a piece of; None where they cannot be told."""
    if mesh.countSegments() != len(shape.Faces):
        return None
    faces = np.full(mesh.CountFacets, -1, dtype=np.int32)
    for number in range(mesh.countSegments()):
        faces[list(mesh.getSegment(number))] = number
    return faces if faces.min() >= 0 else None


def _read_by_core(shape, deflection):
    """The triangles of a shape made by the core, which lets the window go on meanwhile; FreeCAD's mesher
    keeps Python's lock. None where the core cannot: built without OpenCASCADE, or faces beside the solids.
    """
    inside = sum(solid.countElement("Face") for solid in shape.Solids)
    if not (core.available() and core.has_solids()) or inside != shape.countElement("Face"):
        return None
    try:
        with passing(".brep") as path:
            shape.exportBrep(path)
            return core.read_solid(path, deflection, ANGULAR_DEFLECTION)
    except (core.CoreError, OSError) as problem:
        App.Console.PrintLog("Swept Volume: meshed by FreeCAD: {}\n".format(problem))
        return None


def _shape_reader(part, deflection):
    """As reader()."""
    import MeshPart

    shape = part.shape
    if not shape.Solids and not any(s.isClosed() for s in shape.Shells):
        raise InputProblem(
            translate(
                "Messages",
                "The shape has {0} faces but no solid: make it a solid with Part > "
                "Convert to solid or Part > Shape builder, or choose a closed mesh.",
            ).format(len(shape.Faces))
        )
    kept = part.detached()

    def read():
        own = kept.copy()
        found = _read_by_core(own, float(deflection))
        if found is not None:
            return found
        # A copy: the triangulation is cached in the shape, a finer one would be reused for ever.
        local = own.copy()
        mesh = MeshPart.meshFromShape(
            Shape=local,
            LinearDeflection=float(deflection),
            AngularDeflection=ANGULAR_DEFLECTION,
            Relative=False,
            Segments=True,
        )
        if mesh.CountFacets == 0:
            raise InputProblem(
                translate(
                    "Messages",
                    "The shape could not be turned into triangles: check it with Part > "
                    "Check geometry.",
                )
            )
        return arrays_from_mesh(mesh) + (_faces_of_facets(mesh, local),)

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


def paths_to(sub):
    """The paths of all that holds an object, and its own: "A.B." -> "", "A.", "A.B."."""
    names = sub.split(".")[:-1]
    return [".".join(names[:k] + [""]) if k else "" for k in range(len(names) + 1)]


def label_of(root, sub):
    """What the tree shows for a path, for messages."""
    target = root.getSubObject(sub, retType=1)
    return target.Label if target is not None else "{}.{}".format(root.Label, sub)


def own_names(pairs):
    """What the tree shows for each of some paths, with a number where a name is there already."""
    found, seen = [], {}
    for pair in pairs:
        name = label_of(*pair)
        count = seen[name] = seen.get(name, 0) + 1
        found.append(name if count == 1 else "{} ({})".format(name, count))
    return found


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
                "Messages", 'The path "{0}" no longer leads to an object: choose the part again.'
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
    """A shape or a mesh as it is now: a function for any thread that gives vertices (n,3), triangles
    (m,3) in its own frame, and the number of each triangle's face (m,), None: not known. deflection: mm,
    chord height of solids. Raises InputProblem, and so does the function."""
    if linked.isDerivedFrom("Mesh::Feature"):
        mesh = linked.Mesh.copy()
        return lambda: arrays_from_mesh(mesh) + (None,)
    return _shape_reader(apart.of(linked), deflection)


def solid_like(linked):
    """Helper geometry inside groups (datum planes, sketches) is passed over silently."""
    return linked.isDerivedFrom("Mesh::Feature") or bool(linked.Shape.Solids or linked.Shape.Shells)


def solid_leaves(root, sub):
    """leaves() without helper geometry beside others."""
    parts = leaves(root, sub)
    return parts if len(parts) == 1 else [part for part in parts if solid_like(part[0])]


def holds_nothing(root, sub):
    """InputProblem: a path leads to no solid and no mesh."""
    target = root.getSubObject(sub, retType=1)
    if target.isDerivedFrom("App::Link") and target.LinkedObject is None:
        text = translate(
            "Messages",
            'The link "{0}" is empty: its target was deleted, or the document of the '
            "target is not open. Open that document, or choose another target.",
        )
    else:
        text = translate(
            "Messages", '"{0}" contains neither a solid nor a mesh: choose another object.'
        )
    return InputProblem(text.format(label_of(root, sub)))


def no_part_text():
    return translate(
        "Messages", "No moving part is chosen: select a solid or a mesh, then press Add selected."
    )


def owner(root, path):
    """Whose the faces of a solid or mesh are, as features.made_by tells it."""
    return {"label": label_of(root, path), "root": root.Name, "sub": path}


def body_from(pairs, deflection):
    """All generators of a LinkSubList as one body. `deflection`: mm, for solids."""
    if not pairs:
        raise InputProblem(no_part_text())
    read, labels = [], []
    for root, sub in pairs:
        label = label_of(root, sub)
        labels.append(label)
        parts = solid_leaves(root, sub)
        if not parts:
            raise holds_nothing(root, sub)
        for linked, path in parts:
            try:
                how = reader(linked, deflection)
            except InputProblem as problem:
                raise InputProblem('"{}": {}'.format(label, problem)) from None
            read.append((label, global_matrix(root, path), how, owner(root, path)))
    return Body(read, global_placement(*pairs[0]), labels)


def box_corners(pairs):
    """The eight world corners of each leaf's box (k,3): cheap, no meshing."""
    corners = []
    for root, sub in pairs:
        for linked, path in solid_leaves(root, sub):
            local = apart.of(linked).corners()
            if local is not None:
                corners.append(transform(global_matrix(root, path), local))
    if not corners:
        raise InputProblem(
            translate(
                "Messages", "The moving part has no faces: choose a part with a shape or a mesh."
            )
        )
    return np.vstack(corners)
