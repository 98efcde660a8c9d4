# SPDX-License-Identifier: LGPL-2.1-or-later
"""Creates solids with FreeCAD if the core was built without OpenCASCADE: each triangle becomes a
face.

In: mesh arrays in mm, a path. Out: the file, and a dict like that of the core's write_solid().
Writes beside the target, reads the file back, then renames it. Cost: at least 0.3 ms for each
triangle; suitable for some thousands.
"""
import os

import FreeCAD as App
import numpy as np

from ..convert import InputProblem
from ..safe_file import written_beside
from ..texts import mark, translate

#: Approximate size in a STEP file, and time to make and write, for each face.
MEGABYTES, SECONDS = 0.0024, 0.001

NOTE = mark(
    "Messages",
    "the core was built without OpenCASCADE, so FreeCAD made one face for each triangle "
    "and recognised no surfaces",
)


def shape_of(vertices, triangles):
    import Part

    points = [App.Vector(*p) for p in vertices.tolist()]
    facets = Part.Shape()
    # Without sewing: the faces already share their edges.
    facets.makeShapeFromMesh((points, [tuple(t) for t in triangles.tolist()]), 1e-7, False)
    solid = Part.Solid(Part.Shell(facets.Faces))
    if solid.Volume < 0:
        solid.reverse()
    return solid


def check(shape, volume):
    if not shape.Solids or not shape.isValid() or abs(shape.Volume - volume) > 1e-4 * abs(volume):
        raise InputProblem(
            translate(
                "Messages",
                "FreeCAD could not make a valid solid from this envelope: build the core with "
                "OpenCASCADE, or export a mesh file.",
            )
        )


def write(vertices, triangles, path, max_faces):
    """Writes the solid. Raises InputProblem."""
    import Part

    if len(triangles) > max_faces:
        raise InputProblem(
            translate(
                "Messages",
                "the core was built without OpenCASCADE, so each of the {0} triangles would "
                "become a face, but the limit is {1} faces: simplify the envelope, or export "
                "STL, PLY or OBJ.",
            ).format(len(triangles), max_faces)
        )
    corners = vertices[triangles]
    volume = float((corners[:, 0] * np.cross(corners[:, 1], corners[:, 2])).sum() / 6)
    shape = shape_of(vertices, triangles)
    check(shape, volume)
    with written_beside(path) as beside:
        if path.lower().endswith((".brep", ".brp")):
            shape.exportBrep(beside)
        else:
            shape.exportStep(beside)
        check(Part.read(beside), volume)
    return {
        "faces": len(shape.Faces), "solids": 1, "valid": True, "volume": shape.Volume,
        "tolerance": 0.0, "deviation": 0.0, "file_bytes": os.path.getsize(path),
        "note": translate("Messages", NOTE),
    }  # fmt: skip
