# SPDX-License-Identifier: LGPL-2.1-or-later
"""A slider-crank whose angle is a cell of a spreadsheet. The placements of crank, rod and slider are
expressions, so all distances follow from formulas. The crank turns about the z axis, the slider moves along
x. The parts lie in layers above each other, so they meet only where a test wants it.
"""
import math

import FreeCAD as App

V = App.Vector
CRANK, ROD, HALF = 30.0, 80.0, 10.0  # mm: radius, length of the rod, half the slider
STOP = 125.0  # mm: x at which the wall in front of the slider begins
PIN = 6.0  # mm: width of crank and rod


def _box(doc, name, lengths, low):
    """Returns a box as a Part::Feature with a coordinate system of its own, in which its corner is at
    `low`."""
    import Part

    obj = doc.addObject("Part::Feature", name)
    obj.Shape = Part.makeBox(*lengths, V(*low))
    return obj


def make(doc):
    """Returns (sheet, crank, rod, slider, wall)."""
    sheet = doc.addObject("Spreadsheet::Sheet", "Drive")
    sheet.set("A1", "0")
    sheet.setAlias("A1", "angle")
    doc.recompute()
    crank = _box(doc, "Crank", (CRANK + PIN, PIN, 4), (-PIN / 2, -PIN / 2, 0))
    rod = _box(doc, "Rod", (ROD + PIN, PIN, 4), (-PIN / 2, -PIN / 2, 5))
    slider = _box(doc, "Slider", (2 * HALF, 2 * HALF, 4), (-HALF, -HALF, 0))
    wall = _box(doc, "Wall", (5, 60, 14), (STOP, -30, 0))
    angle = "(Drive.angle * 1 deg)"
    y = "{} * sin({})".format(CRANK, angle)
    tilt = "asin({} / {})".format(y, ROD)
    pin = "{} * cos({})".format(CRANK, angle)
    for obj, name, text in (
        (crank, "Placement.Rotation.Angle", angle),
        (rod, "Placement.Rotation.Angle", "-" + tilt),
        (rod, "Placement.Base.x", pin),
        (rod, "Placement.Base.y", y),
        (slider, "Placement.Base.x", "{} + {} * cos({})".format(pin, ROD, tilt)),
    ):
        obj.setExpression(name, text)
    for obj in (crank, rod):
        obj.Placement = App.Placement(V(), App.Rotation(V(0, 0, 1), 1))  # sets the axis of the turn
    doc.recompute()
    return sheet, crank, rod, slider, wall


def at(degrees):
    """Returns (x of the pin, y of the pin, x of the slider) at an angle of the crank."""
    a = math.radians(degrees)
    x, y = CRANK * math.cos(a), CRANK * math.sin(a)
    return x, y, x + math.sqrt(ROD**2 - y**2)
