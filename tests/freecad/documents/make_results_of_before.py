# SPDX-License-Identifier: LGPL-2.1-or-later
"""This script made results_of_before.FCStd and results_of_before.json, with the workbench as of
commit 5b04fd4. At that time, motions had no pivot, sources had no properties, and hashes were not
those of contents.

    python3 make_results_of_before.py CHECKOUT FILE      CHECKOUT: of that commit, with its core built
"""
import json
import os
import sys
import tempfile

CHECKOUT, FILE = sys.argv[1:]
HOME = tempfile.mkdtemp()
os.makedirs(os.path.join(HOME, "Mod"))
os.symlink(CHECKOUT, os.path.join(HOME, "Mod", "SweptVolume"))
os.environ["FREECAD_USER_HOME"] = HOME
sys.path += ["/usr/lib/freecad-python3/lib", "/usr/share/freecad/Ext"]

import FreeCAD as App  # noqa: E402
import Part  # noqa: E402
from sweptvolume.features import clearance, envelope, motion, solid  # noqa: E402

V = App.Vector


def box(doc, name, place, size=10.0):
    obj = doc.addObject("Part::Box", name)
    obj.Length = obj.Width = obj.Height = size
    obj.Placement = place
    return obj


def shift(x, y=0.0, z=0.0):
    return App.Placement(V(x, y, z), App.Rotation())


def main():
    doc = App.newDocument("ResultsOfBefore")
    part = box(doc, "Part", shift(0))
    wall = box(doc, "Wall", shift(70, 5))
    box(doc, "Post", shift(0, 60), 5)
    group = doc.addObject("App::Part", "Group")
    inner = box(doc, "Inner", shift(0, 0, 40), 8)
    group.addObject(inner)
    group.Placement = App.Placement(V(5, -30, 0), App.Rotation(V(0, 0, 1), 30))
    wire = doc.addObject("Part::Feature", "Wire")
    wire.Shape = Part.makePolygon([V(), V(30, 0, 0), V(30, 20, 0)])
    # The part turns while it moves. Without a pivot, the origin of its coordinates moves straight.
    turned = App.Placement(V(40, 0, 0), App.Rotation(V(0, 0, 1), 60))
    path = motion.motion_from_poses(doc, [0, 1], [shift(0), turned])
    curve = motion.motion_from_source(doc, "Curve", [wire], count=9)
    doc.recompute()
    hull = envelope.make_envelope(doc, [part], path, Resolution=32)
    grown = envelope.make_envelope(doc, [part], curve, Resolution=24, Offset=2)
    within = envelope.make_envelope(doc, [inner], path, Resolution=24)
    doc.recompute()
    body = solid.make_solid(doc, hull, Tolerance=0.3)
    chosen = clearance.make_clearance(
        doc, Generators=[(part, "")], Motion=path, AllVisible=False, Neighbours=[(wall, "")]
    )
    seen = clearance.make_clearance(doc, Envelope=within, AllVisible=True)
    doc.recompute()
    results = {}
    for obj in (hull, grown, within):
        envelope.compute(obj)
        results[obj.Name] = [obj.Status, obj.Mesh.CountFacets, obj.Volume.Value]
    solid.compute(body)
    results[body.Name] = [body.Status, len(body.Shape.Faces), body.Shape.Volume]
    for obj in (chosen, seen):
        clearance.compute(obj)
        rows = clearance.report_of(obj)["neighbours"]
        results[obj.Name] = [obj.Status, sorted((row["name"], row["distance"]) for row in rows)]
    doc.recompute()
    for obj in (hull, grown, within, body, chosen, seen):
        results[obj.Name][0] = obj.Status
    doc.saveAs(FILE)
    with open(FILE[: -len("FCStd")] + "json", "w") as out:
        json.dump(results, out, indent=1)
        out.write("\n")


main()
