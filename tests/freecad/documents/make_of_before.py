# SPDX-License-Identifier: LGPL-2.1-or-later
"""This script made names_of_before.FCStd, with the workbench as of commit 79aede3, before
properties were renamed.

    python3 make_of_before.py CHECKOUT FILE      CHECKOUT: of that commit, with its core built
"""
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
from sweptvolume.features import (  # noqa: E402
    clearance,
    envelope,
    mechanism,
    motion,
    sequence,
    shared,
    solid,
)


def box(doc, name, x, y, z, size=10.0):
    obj = doc.addObject("Part::Box", name)
    obj.Length = obj.Width = obj.Height = size
    obj.Placement.Base = App.Vector(x, y, z)
    return obj


def shift(x, y, z):
    return App.Placement(App.Vector(x, y, z), App.Rotation())


def main():
    doc = App.newDocument("NamesOfBefore")
    part, other = box(doc, "Part", 0, 0, 0), box(doc, "Other", 0, 0, 50)
    wall, gauge = box(doc, "Wall", 0, 15, 0), box(doc, "Gauge", 500, 0, 0)
    values = doc.addObject("Spreadsheet::Sheet", "Values")
    values.set("A1", "8")
    values.setAlias("A1", "length")
    path = motion.motion_from_poses(doc, [0, 1], [shift(0, 0, 0), shift(30, 0, 0)])
    path.Frame = "Relative"
    path.SourceConvention = "Table"
    second = motion.motion_from_poses(doc, [0, 1], [shift(0, 0, 50), shift(0, 9, 50)])
    hull = envelope.make_envelope(doc, [part], path, Resolution=24, Tolerance=0.25)
    body = solid.make_solid(doc, hull, Tolerance=0.5, MaxFaces=700)
    check = clearance.make_clearance(
        doc,
        "Front check",
        Generators=[(part, "")],
        Motion=path,
        AllVisible=False,
        Neighbours=[(wall, "")],
        Tolerance=0.02,
    )
    check.setExpression("Required", "Values.length * 1 mm")
    check.setExpression("Deflection", "Required / 100")
    pairs = mechanism.make_mechanism(
        doc,
        Generators=[(part, ""), (other, "")],
        Motions=[path, second],
        Required=4.0,
        Tolerance=0.03,
        Deflection=0.06,
        Range=100.0,
    )
    order = sequence.make_sequence(
        doc,
        Generators=[(part, ""), (other, "")],
        Motions=[path, second],
        Required=0.7,
        Release=11.0,
    )
    space = shared.make_shared(doc, [(hull, "")], [(wall, "")], Deflection=0.07)
    gauge.setExpression("Length", "<<Front check>>.Required + Sequence.Release")
    gauge.setExpression("Width", "Clearance.Deflection * 10")
    values.set("B1", "=Mechanism.Required * 2")
    # A second check, whose part has been deleted.
    lost = box(doc, "Lost", 0, 0, 100)
    left = clearance.make_clearance(doc, "Left", Generators=[(lost, "")], Motion=path)
    doc.recompute()
    doc.removeObject(lost.Name)
    doc.recompute()
    for feature, obj in (
        (envelope, hull),
        (solid, body),
        (clearance, check),
        (mechanism, pairs),
        (shared, space),
    ):
        feature.compute(obj)
    doc.recompute()
    for obj in (path, hull, body, check, pairs, order, space, left):
        print(obj.Name, obj.Status, getattr(obj, "Missing", ""), obj.ExpressionEngine)
    print(gauge.Length, gauge.Width, values.B1, path.SourceConvention)
    doc.saveAs(FILE)


main()
