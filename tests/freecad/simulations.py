# SPDX-License-Identifier: LGPL-2.1-or-later
"""A mechanism with a simulation, made with the classes of FreeCAD's Assembly (FreeCAD 1.1 or later): a base
that stands still, and an arm of 20 x 10 x 10 mm that turns about a corner, in five frames per second.
"""
import builtins
import math

import FreeCAD as App

V = App.Vector
HINGE = V(10, 10, 10)  # the corner of the base about which the arm turns
SPEED = 1.5  # radians a second


class Absent(Exception):
    """Raised if this FreeCAD has no simulations; says why."""


def _simulations():
    """Returns FreeCAD's module of simulations. Without a window the module uses QtCore without
    importing it, so this function imports QtCore."""
    from PySide import QtCore

    builtins.QtCore = QtCore
    try:
        import CommandCreateSimulation
    finally:
        del builtins.QtCore
    return CommandCreateSimulation


def _python(parent, name, make, make_view, *values):
    """Makes an object with one of FreeCAD's classes; in a window also its view provider."""
    obj = parent.newObject("App::FeaturePython", name)
    make(obj, *values)
    if App.GuiUp:
        make_view(obj.ViewObject)
    return obj


def hinge(doc):
    """Returns (simulation, arm, drive). The arm is a link, as for inserted parts; the drive has the
    formula."""
    try:
        import JointObject as joint
        import UtilsAssembly
    except ImportError as error:
        raise Absent("this FreeCAD has no built-in Assembly ({})".format(error))
    try:
        own = _simulations()
    except ImportError:
        raise Absent("this FreeCAD's Assembly has no simulations: they came with 1.1")
    whole = doc.addObject("Assembly::AssemblyObject", "Assembly")
    joints = whole.newObject("Assembly::JointGroup", "Joints")
    base = whole.newObject("Part::Box", "Base")
    block = doc.addObject("Part::Box", "Block")
    block.Length = 20
    arm = whole.newObject("App::Link", "Arm")
    arm.LinkedObject = block
    doc.recompute()
    _python(joints, "Ground", joint.GroundedJoint, joint.ViewProviderGroundedJoint, base)
    kind = joint.JointTypes.index("Revolute")
    turning = _python(joints, "Hinge", joint.Joint, joint.ViewProviderJoint, kind)
    corner = ["Face6", "Vertex7"]
    turning.Proxy.setJointConnectors(turning, [[base, corner], [arm, corner]])
    group = UtilsAssembly.getSimulationGroup(whole)
    simulation = _python(group, "Simulation", own.Simulation, own.ViewProviderSimulation)
    simulation.cTimeStepOutput = 0.25
    values = ("Angular", turning, "{}*time".format(SPEED))
    drive = _python(whole, "Drive", own.Motion, own.ViewProviderMotion, *values)
    simulation.Group = [drive]
    doc.recompute()
    return simulation, arm, drive


FOUND = 4  # frames that the solver finds before it gets stuck


def _begin(assembly, simulation):
    assembly.Before, assembly.Step = assembly.Part.Placement, simulation.cTimeStepOutput


def _frames(assembly):
    return FOUND + 1  # the first frame is the present placement


def _show(assembly, frame):
    travel = App.Placement(V(10 * assembly.Step * max(frame - 1, 0), 0, 0), App.Rotation())
    assembly.Part.Placement = travel.multiply(assembly.Before)


def stuck(doc):
    """Returns (simulation, part): an object with the functions of FreeCAD 1.1's Assembly, for any
    FreeCAD. For one second in steps of 0.25 s, its solver finds only the first three quarters. The
    missing frames are the only sign of this, as with FreeCAD's own solver, which fails on different
    mechanisms in each version."""
    part = doc.addObject("Part::Box", "Stuck")
    simulation = doc.addObject("App::FeaturePython", "StuckSimulation")
    for name, value in (("aTimeStart", 0.0), ("bTimeEnd", 1.0), ("cTimeStepOutput", 0.25)):
        simulation.addProperty("App::PropertyFloat", name)
        setattr(simulation, name, value)
    whole = doc.addObject("App::FeaturePython", "StuckAssembly")
    for kind, name in (
        ("Link", "Part"),
        ("Link", "Simulation"),
        ("Placement", "Before"),
        ("Float", "Step"),
    ):
        whole.addProperty("App::Property" + kind, name)
    whole.Part, whole.Simulation = part, simulation
    whole.generateSimulation, whole.numberOfFrames, whole.updateForFrame = _begin, _frames, _show
    doc.recompute()
    return simulation, part


def arm_after(seconds, speed=SPEED):
    """Returns the placement of the arm after this time: turned about the hinge."""
    turned = App.Rotation(V(0, 0, 1), math.degrees(speed * seconds))
    return App.Placement(HINGE - turned.multVec(V(20, 10, 10)), turned)
