# SPDX-License-Identifier: LGPL-2.1-or-later
"""Makes the files of the handbook's tutorials, beside this script:

    FREECAD_USER_HOME=FOLDER xvfb-run -a freecad resources/tutorials/make.py

with a copy of resources/demo-user.cfg as FOLDER/user.cfg, which disables the start page. Needs a window,
because the files store colours, too.

engine_bay.FCStd: a starter motor in its installed position, and the parts around it. starter.csv: its
installation path. exhaust.csv: the motion that lifts the exhaust pipe into its installed position.
beam_and_posts.FCStd: two posts, and a beam on the floor behind them. Lengths are in mm.
"""
import os

import FreeCAD as App
import FreeCADGui as Gui
import Part
from PySide import QtCore

HERE = os.path.dirname(os.path.realpath(__file__))
#: Turns a cylinder's axis from z to x.
ALONG_X = App.Rotation(App.Vector(0, 1, 0), 90)
#: Bodies of each part. A body: position, then radius and length of a cylinder along x, or the three sides
#: of a box. Bodies after None are cut away from the union of those before it.
PARTS = {
    "Starter": [
        ((-140, 0, 0), (38, 127)),
        ((-104, 0, 58), (23, 91)),
        ((-96, -13, 20), (83, 26, 32)),
        ((-14, 0, 0), (44, 14)),
        ((-14, -75, -15), (14, 150, 30)),
        ((-1, 0, 0), (29.5, 15)),
        ((10, 0, 0), (8, 44)),
        ((18, 0, 0), (17.5, 26)),
    ],
    "BellHousing": [
        ((0, -130, 60), (190, 16)),
        ((0, -78, -18), (16, 156, 36)),
        None,
        ((-5, 0, 0), (31, 30)),
    ],
    "Flywheel": [((22, -130, 60), (124, 14))],
    "Engine": [
        ((-330, -240, -45), (328, 148, 210)),
        ((-320, -230, -160), (314, 164, 120)),
        ((-330, -94, -20), (84, 114, 80)),
    ],
    "Exhaust": [((-230, 98, -72), (28, 420)), None, ((-235, 98, -72), (25.5, 430))],
    "FrameRail": [((-345, 152, -175), (535, 60, 110)), None, ((-346, 157, -170), (537, 56, 100))],
}
COLOURS = {
    "Starter": (0.80, 0.80, 0.83),
    "BellHousing": (0.62, 0.66, 0.70),
    "Flywheel": (0.45, 0.45, 0.48),
    "Engine": (0.55, 0.60, 0.66),
    "Exhaust": (0.72, 0.52, 0.38),
    "FrameRail": (0.28, 0.30, 0.33),
    "Beam": (0.80, 0.66, 0.44),
}
#: Motions of both parts: time (s), position (mm), and yaw, pitch, roll (degrees) of each pose.
STARTER = [
    (0, (-80, 200, -345), (38, -28, 90)),
    (1, (-88, 130, -330), (30, -26, 90)),
    (2, (-92, 66, -300), (14, -20, 90)),
    (3, (-84, 28, -235), (4, -11, 90)),
    (4, (-74, 24, -165), (0, -4, 90)),
    (5, (-68, 22, -95), (0, 0, 90)),
    (6, (-66, 20, -30), (0, 0, 84)),
    (7, (-64, 14, 8), (0, 0, 48)),
    (8, (-62, 0, 4), (0, 0, 14)),
    (9, (-60, 0, 0), (0, 0, 0)),
    (10, (-30, 0, 0), (0, 0, 0)),
    (11, (0, 0, 0), (0, 0, 0)),
]
EXHAUST = [
    (0, (0, 0, -140), (0, 0, 0)),
    (8, (0, 0, -140), (0, 0, 0)),
    (11, (0, 0, 0), (0, 0, 0)),
]
#: Each box: name, sides, position of its centre, rotation about z (degrees).
BLOCKS = [
    ("Base", (160, 20, 15), (0, 0, 7.5), 0),
    ("PostLeft", (15, 15, 60), (-50, 0, 45), 0),
    ("PostRight", (15, 15, 60), (50, 0, 45), 0),
    ("Beam", (130, 20, 15), (0, 90, 7.5), 90),
]


def body(doc, place, sizes):
    """Adds a cylinder along x (sizes: radius, length) or a box (sizes: sides). Returns the object."""
    if len(sizes) == 2:
        obj = doc.addObject("Part::Cylinder", "Cylinder")
        obj.Radius, obj.Height = sizes
        obj.Placement.Rotation = ALONG_X
    else:
        obj = doc.addObject("Part::Box", "Box")
        obj.Length, obj.Width, obj.Height = sizes
    obj.Placement.Base = App.Vector(*place)
    return obj


def part(doc, name, rows):
    """Adds a part. rows: the bodies to unite, then optionally None and the bodies to cut away
    (arguments of body())."""
    at = rows.index(None) if None in rows else len(rows)
    kept = [body(doc, *row) for row in rows[:at]]
    away = [body(doc, *row) for row in rows[at + 1 :]]
    made = kept[0]
    if len(kept) > 1:
        made = doc.addObject("Part::MultiFuse", name if not away else "Union")
        made.Shapes, made.Refine = kept, True
    if away:
        base, made = made, doc.addObject("Part::Cut", name)
        made.Base, made.Tool = base, away[0]
        base.Visibility = False
    for inner in kept * (len(kept) > 1) + away:
        inner.Visibility = False
    made.Label = name


def poses(name, rows):
    """Writes a motion file: time, position and quaternion of each pose."""
    with open(os.path.join(HERE, name), "w", encoding="utf-8") as file:
        file.write("t,tx,ty,tz,qx,qy,qz,qw\n")
        for time, place, angles in rows:
            numbers = (time,) + place + App.Rotation(*angles).Q
            file.write(",".join("{:.9g}".format(number + 0.0) for number in numbers) + "\n")


def save(doc, name):
    doc.recompute()
    for obj in doc.Objects:
        if obj.Label in COLOURS:
            obj.ViewObject.ShapeColor = COLOURS[obj.Label]
    Gui.activeDocument().activeView().viewIsometric()
    Gui.SendMsgToActiveView("ViewFit")
    doc.saveAs(os.path.join(HERE, name))
    App.closeDocument(doc.Name)


def main():
    bay = App.newDocument("engine_bay")
    for name, rows in PARTS.items():
        part(bay, name, rows)
    save(bay, "engine_bay.FCStd")
    poses("starter.csv", STARTER)
    poses("exhaust.csv", EXHAUST)
    joint = App.newDocument("beam_and_posts")
    for name, sizes, place, degrees in BLOCKS:
        obj = joint.addObject("Part::Feature", name)
        obj.Shape = Part.makeBox(*sizes, App.Vector(*(-size / 2 for size in sizes)))
        obj.Placement = App.Placement(
            App.Vector(*place), App.Rotation(App.Vector(0, 0, 1), degrees)
        )
    save(joint, "beam_and_posts.FCStd")
    Gui.getMainWindow().close()


QtCore.QTimer.singleShot(1000, main)
