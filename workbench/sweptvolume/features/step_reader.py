# SPDX-License-Identifier: LGPL-2.1-or-later
"""Reads STEP files with FreeCAD for a core that was built without OpenCASCADE. The core makes the text
of a solid and asks here whether its faces are valid after reading; faces that are not lose their
surface, and the core makes the text again. So only FreeCAD's own OpenCASCADE is in the process.

In: the text of a STEP file (bytes). Out: a dict, as the core's write_solid() describes for `reader`.
Runs in the thread of the run. Cost: as opening the file in FreeCAD.
"""
import os

from ..safe_file import passing


def read(text):
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
    """Returns what the core asks about a shape."""
    if shape.isNull():
        figures = dict.fromkeys("solids shells faces edges volume edge_tolerance".split(), 0)
        return dict(figures, valid=False, complaint="FreeCAD reads no shape", bad_faces=[])
    faces = shape.Faces
    # One call for the whole shape: most are valid, and one for each face takes longer.
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

    from .. import core

    if not path.lower().endswith((".brep", ".brp")):
        return core.write_solid(vertices, triangles, path, control, reader=read, **options)
    with passing(".step") as step:
        report = core.write_solid(vertices, triangles, step, control, reader=read, **options)
        Part.read(step).exportBrep(path)
    report["file_bytes"] = os.path.getsize(path)
    return report
