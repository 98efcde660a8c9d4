# SPDX-License-Identifier: LGPL-2.1-or-later
"""Converts between FreeCAD objects and numpy arrays. Units: mm, s. No GUI.

FreeCAD meshes store coordinates in single precision. So bodies are read in their own local frame
and moved to the world in double precision.
"""
import FreeCAD as App
import numpy as np

from . import apart, core
from .body import Body, InputProblem, transform  # noqa: F401 (read from here as well)
from .meshes import arrays_from_mesh, mesh_from_arrays  # noqa: F401 (read from here as well)
from .safe_file import passing
from .texts import translate

#: Angular deflection of meshed solids (rad). The linear deflection depends on the cell.
ANGULAR_DEFLECTION = 0.35


# --- placements


def matrix_of(placement):
    """Returns a Placement as a 4x4 float64 matrix."""
    return np.array(placement.toMatrix().A, dtype=float).reshape(4, 4)


def pose_arrays(placements):
    """Returns translations (n,3) in mm and quaternions (n,4) in the order x, y, z, w."""
    translations = np.array([tuple(p.Base) for p in placements], dtype=float).reshape(-1, 3)
    rotations = np.array([p.Rotation.Q for p in placements], dtype=float).reshape(-1, 4)
    return translations, rotations


def matrices_from(translations, rotations):
    """Returns the poses of pose_arrays() as 4x4 matrices (n,4,4), equal to those of matrix_of() to
    the last bit."""
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
    """Returns the placements for arrays from pose_arrays()."""
    return [
        App.Placement(App.Vector(*map(float, t)), App.Rotation(*map(float, q)))
        for t, q in zip(translations, rotations)
    ]


# --- solids and meshes as bodies


def _faces_of_facets(mesh, shape):
    """Returns, for each facet, the index of its face of the shape (m,), or None if the faces are
    not known."""
    if mesh.countSegments() != len(shape.Faces):
        return None
    faces = np.full(mesh.CountFacets, -1, dtype=np.int32)
    for number in range(mesh.countSegments()):
        faces[list(mesh.getSegment(number))] = number
    return faces if faces.min() >= 0 else None


def _read_by_core(shape, deflection):
    """Returns the triangles of a shape, created by the core, or None. FreeCAD's mesher holds
    Python's lock and so blocks the window; the core does not. None means that the core was built
    without OpenCASCADE, or that the shape has faces outside its solids.
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


def meshed(shape, deflection, angle):
    """Returns the triangles of a shape, created by FreeCAD: vertices (n,3) mm, triangles (m,3) and the
    index of the face of each triangle (m,), or None if the faces are not known. Raises
    InputProblem."""
    import MeshPart

    # The shape caches its triangulation, and FreeCAD would always reuse one that is finer than
    # needed. So a copy is meshed.
    local = shape.copy()
    mesh = MeshPart.meshFromShape(
        Shape=local,
        LinearDeflection=float(deflection),
        AngularDeflection=float(angle),
        Relative=False,
        Segments=True,
    )
    if mesh.CountFacets == 0:
        raise InputProblem(
            translate(
                "SweptVolume",
                "The shape could not be turned into triangles: check it with Part > "
                "Check geometry.",
            )
        )
    return arrays_from_mesh(mesh) + (_faces_of_facets(mesh, local),)


def _shape_reader(part, deflection):
    """Returns the reader() of a shape."""
    shape = part.shape
    if not shape.Solids and not any(s.isClosed() for s in shape.Shells):
        raise InputProblem(
            translate(
                "SweptVolume",
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
        return meshed(own, deflection, ANGULAR_DEFLECTION)

    return read


# --- objects of a document


def split_path(root, sub):
    """Removes a trailing element name ("L.Box.Face3" -> "L.Box.")."""
    return sub[: sub.rfind(".") + 1] if sub else ""


def is_plain_group(obj):
    """Returns whether an object is a group without a placement of its own (Std Group)."""
    return obj.isDerivedFrom("App::DocumentObjectGroup")


def _plain_group_of(holder, member):
    """Returns the plain group through which the tree shows `member`, or None. The plain group lies
    in `holder`, a group with a placement. FreeCAD lists such a member in both groups."""
    group = getattr(holder.getLinkedObject(True), "Group", [])
    if is_plain_group(holder) or member not in group:
        return None
    return next((o for o in member.InList if is_plain_group(o) and o in group), None)


def as_in_tree(root, sub):
    """Returns a path with all plain groups that the tree shows on it: "Box." -> "Group.Box."."""
    names, holder = [], root
    for name in sub.split(".")[:-1]:
        member = holder.getSubObject(name + ".", retType=1)
        if member is None:
            return sub
        above, group = [], _plain_group_of(holder, member)
        while group is not None:
            above.insert(0, group.Name)
            group = _plain_group_of(holder, group)
        names += above + [name]
        holder = member
    return ".".join(names + [sub.rsplit(".", 1)[-1]])


def root_path(obj):
    """Returns (root, sub), the path by which the document shows an object.

    If several paths lead to it, returns the first. The path starts at the outermost group, so that
    a move of any group around the object is noticed.
    """
    for root, sub in getattr(obj, "Parents", []) or []:
        if root.isDerivedFrom("App::DocumentObject") and not root.isDerivedFrom("App::Link"):
            return root, as_in_tree(root, sub)
    return obj, ""


def links_in(links):
    """Returns the value of a LinkSubList or LinkSub property as a flat list of (object, sub),
    unchanged."""
    if isinstance(links, tuple):
        links = [links]
    pairs = []
    for root, subs in links or []:
        names = [subs] if isinstance(subs, str) else list(subs)
        pairs += [(root, name) for name in (names or [""])]
    return pairs


def pairs_of(links):
    """Returns the links as (root, sub). Each path starts at the outermost group around the object
    and ends at an object: a link to a face counts as a link to its part."""
    pairs = []
    for obj, sub in links_in(links):
        root, path = root_path(obj)
        pairs.append((root, split_path(root, path + as_in_tree(obj, sub))))
    return pairs


def paths_to(sub):
    """Returns the paths of all containers of an object, and its own path: "A.B." -> "", "A.",
    "A.B."."""
    names = sub.split(".")[:-1]
    return [".".join(names[:k] + [""]) if k else "" for k in range(len(names) + 1)]


def label_of(root, sub):
    """Returns the label that the tree shows for a path, for messages."""
    target = root.getSubObject(sub, retType=1)
    return target.Label if target is not None else "{}.{}".format(root.Label, sub)


def own_names(pairs):
    """Returns the labels that the tree shows for paths. Equal labels are numbered."""
    found, seen = [], {}
    for pair in pairs:
        name = label_of(*pair)
        count = seen[name] = seen.get(name, 0) + 1
        found.append(name if count == 1 else "{} ({})".format(name, count))
    return found


def targets(pairs):
    """Returns the objects to which the paths lead. Leaves out paths that lead to nothing."""
    found = [root.getSubObject(sub, retType=1) for root, sub in pairs]
    return [obj for obj in found if obj is not None]


def global_placement(root, sub):
    """Returns the placement, in the document, of the object at the end of a path."""
    return root.getSubObject(sub, retType=3)


def global_matrix(root, sub):
    """Returns the matrix from the frame of the linked geometry to the world, with the placements,
    scales and transforms of links."""
    target = root.getSubObject(sub, retType=1)
    path = np.array(root.getSubObject(sub, retType=4).A, dtype=float).reshape(4, 4)
    inner = target.getLinkedObject(True, App.Matrix(), False)[1]
    return path @ np.array(inner.A, dtype=float).reshape(4, 4)


def is_shown(obj):
    """Returns whether an object at the top level of the document shows its content. A plain group
    does so even if it is hidden: FreeCAD then draws those of its members that are visible."""
    return is_plain_group(obj) or getattr(obj, "Visibility", True)


def _shows(holder, name, member):
    """Returns whether a group or a link shows one of its members. Link arrays and groups of links
    decide this themselves: such a member may be visible while its original is hidden, and hidden
    while its original is visible."""
    shown = holder.isElementVisible(name)
    return bool(shown) if shown >= 0 else is_shown(member)


def leaves(root, sub=""):
    """Returns all shapes and meshes below a path as a list of (linked object, path).

    Leaves out hidden children, which are usually inputs of Boolean operations. Includes the object
    at the path itself, even if it is hidden.
    """
    target = root.getSubObject(sub, retType=1)
    if target is None:
        raise InputProblem(
            translate(
                "SweptVolume", 'The document has no object "{0}" any more: choose the part again.'
            ).format(root.Label + "." + sub)
        )
    linked = target.getLinkedObject(True)
    if hasattr(linked, "Mesh") and linked.isDerivedFrom("Mesh::Feature"):
        return [(linked, sub)]
    if hasattr(linked, "Shape") and linked.isDerivedFrom("Part::Feature"):
        return [(linked, sub)]
    found = []
    for child in target.getSubObjects():
        # A group may list elements of a shape here. Only names that end in a dot are objects.
        if not child.endswith("."):
            continue
        member = root.getSubObject(sub + child, retType=1)
        if member is not None and _plain_group_of(target, member) is not None:
            continue  # leaves() finds this member through its plain group
        if member is None or _shows(target, child[:-1], member):
            found += leaves(root, sub + child)
    return found


def reader(linked, deflection):
    """Returns a function for any thread that reads a shape or a mesh in its present state. The
    function returns vertices (n,3) and triangles (m,3) in the object's own frame, and the face
    index of each triangle (m,), or None. deflection: mm, for solids. Both raise InputProblem."""
    if linked.isDerivedFrom("Mesh::Feature"):
        mesh = linked.Mesh.copy()
        return lambda: arrays_from_mesh(mesh) + (None,)
    return _shape_reader(apart.of(linked), deflection)


def solid_like(linked):
    """Returns whether an object can be a part. Helper geometry in groups (datum planes, sketches)
    cannot."""
    return linked.isDerivedFrom("Mesh::Feature") or bool(linked.Shape.Solids or linked.Shape.Shells)


def solid_leaves(root, sub):
    """Returns leaves(). If there are several, leaves out helper geometry (datum planes,
    sketches)."""
    parts = leaves(root, sub)
    return parts if len(parts) == 1 else [part for part in parts if solid_like(part[0])]


def holds_nothing(root, sub):
    """Returns the InputProblem for a path that leads to no solid and no mesh."""
    target = root.getSubObject(sub, retType=1)
    if target.isDerivedFrom("App::Link") and target.LinkedObject is None:
        text = translate(
            "SweptVolume",
            'The link "{0}" is empty: its target was deleted, or the document of the '
            "target is not open. Open that document, or choose another target.",
        )
    else:
        text = translate(
            "SweptVolume", '"{0}" contains neither a solid nor a mesh: choose another object.'
        )
    return InputProblem(text.format(label_of(root, sub)))


def no_part_text():
    return translate(
        "SweptVolume",
        "No moving part is chosen: select a solid or a mesh, then press Add selected.",
    )


def owner(root, path):
    """Returns a dict that identifies the part to which faces belong. features.made_by stores it."""
    known = {"label": label_of(root, path), "root": root.Name, "sub": path}
    return dict(known, id=object_id(root, path))


def object_id(root, path):
    """Returns the ID of the object at the end of a path. FreeCAD never gives this number to a later
    object with the same name."""
    return root.getSubObject(path, retType=1).ID


def body_from(pairs, deflection):
    """Returns all parts of a LinkSubList as one body. `deflection`: mm, for solids."""
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
    """Returns the eight corners, in world coordinates, of the bounding box of each leaf (k,3).
    Fast, without meshing."""
    corners = []
    for root, sub in pairs:
        for linked, path in solid_leaves(root, sub):
            local = apart.of(linked).corners()
            if local is not None:
                corners.append(transform(global_matrix(root, path), local))
    if not corners:
        raise InputProblem(
            translate(
                "SweptVolume", "The moving part has no faces: choose a part with a shape or a mesh."
            )
        )
    return np.vstack(corners)
