# SPDX-License-Identifier: LGPL-2.1-or-later
"""The parts of the demo, modelled here: a starter motor and the parts past which it moves. Units: mm.

World frame: x along the crankshaft towards the gearbox, y away from the engine, z up. The origin is
the centre of the starter's mounting face in its final position.
"""
import math

import FreeCAD as App
import Part

from .texts import QT_TRANSLATE_NOOP

V = App.Vector
X, Y, Z = V(1, 0, 0), V(0, 1, 0), V(0, 0, 1)

#: Half the distance of the two flange bolts, and radius of their holes (mm).
BOLT_Y, BOLT_RADIUS = 60.0, 5.5
#: Axis of the crankshaft in the frame of the starter.
CRANK = V(0, -130, 60)


def _rod(radius, start, end, y=0.0, z=0.0):
    """Returns a cylinder along x."""
    return Part.makeCylinder(radius, end - start, V(start, y, z), X)


def _box(x, y, z):
    """Returns a box from three (low, high) pairs."""
    low, size = V(x[0], y[0], z[0]), [b - a for a, b in (x, y, z)]
    return Part.makeBox(size[0], size[1], size[2], low)


def _one(shape):
    """Returns the only solid in the compound of a Boolean operation, with coplanar faces merged."""
    solids = shape.removeSplitter().Solids
    if len(solids) != 1 or not solids[0].isValid():
        raise RuntimeError("demo part: {} solids where one valid one is due".format(len(solids)))
    return solids[0]


def _round(shape, radius, test):
    """Rounds the edges for which test(edge) is true."""
    edges = [edge for edge in shape.Edges if test(edge)]
    return shape.makeFillet(radius, edges)


def _circle_at(x, radius):
    """Returns a test for circular edges around the starter's axis."""

    def test(edge):
        curve = edge.Curve
        if not isinstance(curve, Part.Circle) or abs(curve.Radius - radius) > 1e-6:
            return False
        return abs(curve.Center.x - x) < 1e-6

    return test


def _pinion(teeth=9, root=12.0, tip=17.5, start=18.0, end=44.0):
    """Returns a spur pinion with straight flanks and chamfered ends."""
    points = []
    for k in range(teeth):
        middle = 2 * math.pi * k / teeth
        step = 2 * math.pi / teeth
        for radius, part in ((root, -0.32), (tip, -0.13), (tip, 0.13), (root, 0.32)):
            a = middle + part * step
            points.append(V(start, radius * math.cos(a), radius * math.sin(a)))
    wire = Part.makePolygon(points + points[:1])
    gear = Part.Face(wire).extrude(V(end - start, 0, 0))
    cone = Part.makeCone(tip + 3.5, tip - 2.0, 6.0, V(end - 6.0 + 0.5, 0, 0), X)
    body = _rod(tip + 3.5, start, end - 5.5)
    return gear.common(body.fuse(cone))


def _flange():
    """Returns the mounting flange: a disc with two ears and two bolt holes."""
    plate = _rod(44.0, -14.0, 0.0)
    for side in (-1, 1):
        plate = plate.fuse(_rod(15.0, -14.0, 0.0, y=side * BOLT_Y))
    plate = plate.fuse(_box((-14, 0), (-BOLT_Y, BOLT_Y), (-15, 15)))
    plate = plate.removeSplitter()
    for side in (-1, 1):
        plate = plate.cut(_rod(BOLT_RADIUS, -20.0, 5.0, y=side * BOLT_Y))
    return plate


def starter():
    """Returns the starter motor as one solid. Its origin is the centre of the mounting face."""
    can = _rod(38.0, -140.0, -13.0)
    can = _round(can, 6.0, _circle_at(-140.0, 38.0))
    for x in (-122.0, -34.0):
        groove = _rod(39.0, x, x + 3.0).cut(_rod(36.5, x, x + 3.0))
        can = can.cut(groove)
    solenoid = _rod(23.0, -104.0, -13.0, z=58.0)
    rim = solenoid.Edges
    solenoid = solenoid.makeFillet(
        4.0,
        [
            e
            for e in rim
            if abs(e.BoundBox.XMax + 104.0) < 1e-6 and isinstance(e.Curve, Part.Circle)
        ],
    )
    saddle = _box((-96, -13), (-13, 13), (20, 52))
    body = can.fuse([solenoid, saddle, _flange()])
    for y in (-10.0, 10.0):
        stud = _rod(4.0, -120.0, -100.0, y=y, z=58.0)
        nut = _rod(6.5, -108.0, -103.0, y=y, z=58.0)
        body = body.fuse([stud, nut])
    nose = _rod(29.5, -1.0, 14.0).fuse(_rod(22.0, 13.0, 16.0))
    shaft = _rod(8.0, 10.0, 54.0)
    shaft = shaft.makeChamfer(2.0, [e for e in shaft.Edges if e.BoundBox.XMin > 53.9])
    body = body.fuse([nose, _pinion(), shaft])
    for angle in (0, 120, 240):
        screw = _rod(4.0, -144.0, -139.0, y=27.0)
        screw.rotate(V(0, 0, 0), X, angle + 30)
        body = body.fuse(screw)
    return _one(body)


def bell_housing():
    """Returns the hollow bell housing with the opening for the starter and a rim of bolts."""
    plate = Part.makeCylinder(190.0, 16.0, V(0, CRANK.y, CRANK.z), X)
    pad = _rod(50.0, 0.0, 16.0).fuse(_box((0, 16), (-BOLT_Y, BOLT_Y), (-18, 18)))
    pad = pad.fuse([_rod(18.0, 0.0, 16.0, y=s * BOLT_Y) for s in (-1, 1)])
    outer = Part.makeCone(188.0, 105.0, 140.0, V(16, CRANK.y, CRANK.z), X)
    inner = Part.makeCone(179.0, 96.0, 140.0, V(16, CRANK.y, CRANK.z), X)
    bulge = _rod(50.0, 15.0, 70.0)
    hollow = inner.fuse(
        [_rod(42.0, 14.0, 62.0), Part.makeCylinder(165, 20, V(-2, CRANK.y, CRANK.z), X)]
    )
    shell = plate.fuse([pad, outer, bulge]).cut(hollow)
    # The clutch side stays closed around the starter's opening.
    lid = pad.cut(Part.makeCylinder(128.0, 30.0, V(-5, CRANK.y, CRANK.z), X))
    shell = shell.fuse(lid)
    holes = [_rod(31.0, -5.0, 20.0)]
    holes += [_rod(BOLT_RADIUS, -5.0, 20.0, y=s * BOLT_Y) for s in (-1, 1)]
    for k in range(12):
        a = 2 * math.pi * k / 12 + 0.05
        y, z = CRANK.y + 178 * math.cos(a), CRANK.z + 178 * math.sin(a)
        if math.hypot(y, z) > 75:
            holes.append(_rod(5.5, -5.0, 30.0, y=y, z=z))
    return _one(shell.cut(holes))


def flywheel():
    """Returns the flywheel with its ring gear, simplified."""
    disc = Part.makeCylinder(124.0, 14.0, V(22, CRANK.y, CRANK.z), X)
    hub = Part.makeCylinder(45.0, 26.0, V(14, CRANK.y, CRANK.z), X)
    wheel = disc.fuse(hub)
    for k in range(6):
        a = math.pi * k / 3
        hole = Part.makeCylinder(
            16.0, 60.0, V(0, CRANK.y + 85 * math.cos(a), CRANK.z + 85 * math.sin(a)), X
        )
        wheel = wheel.cut(hole)
    return _one(wheel)


def engine():
    """Returns the side of the engine block with ribs, the oil pan, and the engine mount behind the
    starter."""
    block = _box((-330, -2), (-240, -92), (-45, 165))
    block = _round(block, 8.0, lambda e: e.BoundBox.ZMin > 164 and e.BoundBox.YMin > -93)
    ribs = [_box((x, x + 8), (-94, -86), (0, 150)) for x in range(-310, -20, 48)]
    pan = _box((-320, -6), (-230, -66), (-160, -40))
    pan = _round(pan, 14.0, lambda e: e.BoundBox.ZMax < -159)
    plug = Part.makeCylinder(9.0, 8.0, V(-280, -67, -130), Y)
    mount = _box((-330, -246), (-94, 20), (-20, 60))
    mount = _round(mount, 10.0, lambda e: e.BoundBox.YMin > 19)
    mount = mount.cut(Part.makeCylinder(14.0, 120.0, V(-290, -20, -40), Z))
    return _one(block.fuse(ribs + [pan, plug, mount]))


def exhaust():
    """Returns the exhaust pipe with a bend and a flanged joint."""
    low, knee, top, r = -72.0, V(-230, 98, -72), V(-300, 98, 90), 70.0
    middle = V(-230 - r * math.sin(math.pi / 4), 98, low + r * (1 - math.cos(math.pi / 4)))
    side = V(-300, 98, low + r)
    bend = Part.Arc(side, middle, knee).toShape()
    end = V(190, 98, low)
    path = Part.Wire([Part.makeLine(top, side), bend, Part.makeLine(knee, end)])
    pipe = _sweep(path, 28.0).cut(_sweep(path, 25.5))
    joint = _rod(40.0, 60.0, 82.0, y=98, z=-72).cut(_rod(27.0, 50.0, 90.0, y=98, z=-72))
    bolts = []
    for k in range(3):
        angle = 2 * math.pi * k / 3 + 0.5
        bolts.append(_rod(4.5, 48, 94, 98 + 34 * math.cos(angle), -72 + 34 * math.sin(angle)))
    return _one(pipe.fuse([joint] + bolts))


def _sweep(path, radius):
    start = path.OrderedEdges[0]
    tangent = start.tangentAt(start.FirstParameter)
    profile = Part.Wire(Part.makeCircle(radius, start.valueAt(start.FirstParameter), tangent))
    shell = Part.BRepOffsetAPI.MakePipeShell(path)
    shell.add(profile)
    shell.setTransitionMode(2)
    shell.build()
    shell.makeSolid()
    return shell.shape()


def frame_rail():
    """Returns the side member of the frame: a channel with lightening holes."""
    rail = _box((-345, 190), (152, 212), (-175, -65))
    rail = rail.cut(_box((-346, 191), (157, 213), (-170, -70)))
    for x in (-280, -180, -80, 20, 120):
        rail = rail.cut(Part.makeCylinder(22.0, 40.0, V(x, 140, -120), Y))
    return _one(rail)


#: Installation path of the starter: time (s), position, and (yaw, pitch, roll) in degrees.
PATH = [
    (0.0, (-80, 200, -345), (38, -28, 90)),
    (1.0, (-88, 130, -330), (30, -26, 90)),
    (2.0, (-92, 66, -300), (14, -20, 90)),
    (3.0, (-84, 28, -235), (4, -11, 90)),
    (4.0, (-74, 24, -165), (0, -4, 90)),
    (5.0, (-68, 22, -95), (0, 0, 90)),
    (6.0, (-66, 20, -30), (0, 0, 84)),
    (7.0, (-64, 14, 8), (0, 0, 48)),
    (8.0, (-62, 0, 4), (0, 0, 14)),
    (9.0, (-60, 0, 0), (0, 0, 0)),
    (10.0, (-30, 0, 0), (0, 0, 0)),
    (11.0, (0, 0, 0), (0, 0, 0)),
]


def path():
    """Returns times and placements of the installation."""
    times = [row[0] for row in PATH]
    return times, [App.Placement(V(*row[1]), App.Rotation(*row[2])) for row in PATH]


#: Name, label, function, colour of each part. The first part moves.
PARTS = [
    ("Starter", QT_TRANSLATE_NOOP("SweptVolume", "Starter motor"), starter, (0.80, 0.80, 0.83)),
    (
        "BellHousing",
        QT_TRANSLATE_NOOP("SweptVolume", "Bell housing"),
        bell_housing,
        (0.62, 0.66, 0.70),
    ),
    ("Flywheel", QT_TRANSLATE_NOOP("SweptVolume", "Flywheel"), flywheel, (0.45, 0.45, 0.48)),
    (
        "Engine",
        QT_TRANSLATE_NOOP("SweptVolume", "Engine block and pan"),
        engine,
        (0.55, 0.60, 0.66),
    ),
    ("Exhaust", QT_TRANSLATE_NOOP("SweptVolume", "Exhaust pipe"), exhaust, (0.72, 0.52, 0.38)),
    ("FrameRail", QT_TRANSLATE_NOOP("SweptVolume", "Frame rail"), frame_rail, (0.28, 0.30, 0.33)),
]
