# SPDX-License-Identifier: LGPL-2.1-or-later
"""Reads STEP and BREP files with FreeCAD for a core that was built without OpenCASCADE. With such a
core, only FreeCAD's own OpenCASCADE is loaded in the process.

The core writes a solid as text and calls read() to learn which faces are valid after reading. For
invalid faces, the core gives up the recognised surface and writes the text again. For a part that
is a STEP or BREP file, it calls solids() for the triangles.

All functions run in the thread of the run. Cost: the same as opening the file in FreeCAD.
"""
import os

from .. import convert, core
from ..body import InputProblem
from ..safe_file import passing
from ..texts import translate


def read(text):
    """Reads the text of a STEP file (bytes) and judges the shape. Returns a dict in the form that
    the core's write_solid() describes for `reader`."""
    import Part

    with passing(".step") as path:
        with open(path, "wb") as file:
            file.write(text)
        try:
            return judged(Part.read(path))
        except (Part.OCCError, OSError, RuntimeError) as problem:
            return dict(
                judged(Part.Shape()), complaint="FreeCAD cannot read it: {}".format(problem)
            )


def judged(shape):
    """Returns the counts, the volume and the faults of a shape in the form that the core
    expects."""
    if shape.isNull():
        figures = dict.fromkeys("solids shells faces edges volume edge_tolerance".split(), 0)
        return dict(figures, valid=False, complaint="FreeCAD reads no shape", bad_faces=[])
    faces = shape.Faces
    # One call checks the whole shape. Most shapes are valid, and a call for each face takes longer.
    bad = [] if shape.isValid() else [i for i, face in enumerate(faces) if not face.isValid()]
    open_shells = sum(not shell.isClosed() for shell in shape.Shells)
    complaint = ""
    if bad:
        complaint = "{} faces are not valid".format(len(bad))
    elif open_shells:
        complaint = "{} shells are not closed".format(open_shells)
    elif not shape.Solids:
        complaint = "no solid"
    elif not shape.isValid():
        complaint = "FreeCAD finds the solid not valid"
    return {
        "solids": len(shape.Solids),
        "shells": len(shape.Shells),
        "faces": len(faces),
        "edges": len(shape.Edges),
        "valid": not complaint,
        "complaint": complaint,
        "volume": shape.Volume,
        "edge_tolerance": max(
            (part.Tolerance for part in shape.Edges + shape.Vertexes), default=0.0
        ),
        "bad_faces": bad,
    }


def write(vertices, triangles, path, control, **options):
    """Writes a solid as core.write_solid() does, also as BREP, with FreeCAD as the reader."""
    import Part

    if not path.lower().endswith((".brep", ".brp")):
        return core.write_solid(vertices, triangles, path, control, reader=read, **options)
    with passing(".step") as step:
        report = core.write_solid(vertices, triangles, step, control, reader=read, **options)
        Part.read(step).exportBrep(path)
    report["file_bytes"] = os.path.getsize(path)
    return report


def solids(path, deflection, angle):
    """Reads the solids of a file, or all faces if there is no solid, as the core's read_body()
    describes for `reader`. FreeCAD does not give the names of the products. So the solids get the
    name of the file, and numbers if there are several. Raises InputProblem."""
    import Part

    try:
        shape = Part.read(path)
    except (Part.OCCError, OSError, RuntimeError) as problem:
        text = translate("SweptVolume", 'FreeCAD cannot read "{0}": {1}')
        raise InputProblem(text.format(path, problem)) from None
    name = os.path.splitext(os.path.basename(path))[0]
    parts = shape.Solids or [shape]
    # Face numbers continue from solid to solid. If two solids share a face, the numbers are left
    # out.
    whole = sum(len(part.Faces) for part in parts) == len(shape.Faces)
    found, first = [], 0
    for number, part in enumerate(parts, 1):
        vertices, triangles, faces = convert.meshed(part, deflection, angle)
        faces = None if faces is None or not whole else faces + first
        first += len(part.Faces)
        label = "{} {}".format(name, number) if len(parts) > 1 else name
        found.append((label, vertices, triangles, faces))
    return found


def parts_reader():
    """Returns solids() if the core was built without OpenCASCADE, else None."""
    return None if core.has_solids() else solids
