# SPDX-License-Identifier: LGPL-2.1-or-later
"""A mechanism with a simulation, made by the classes of FreeCAD's own Assembly (from 1.1 on): a base that
stands, an arm of 20 x 10 x 10 that turns about a corner, five frames in a second."""
import builtins
import math

import FreeCAD as App

V = App.Vector
HINGE = V(10, 10, 10)  # the corner of the base about which the arm turns
SPEED = 1.5  # radians a second


class Absent(Exception):
    """The running FreeCAD has no simulations; says why."""


def _simulations():
    """FreeCAD's module of simulations. It names QtCore even without a window, where it has not
    imported it."""
    from PySide import QtCore

    builtins.QtCore = QtCore
    try:
        import CommandCreateSimulation
    finally:
        del builtins.QtCore
    return CommandCreateSimulation


def _python(parent, name, make, look, *values):
    """An object of a class `make` of FreeCAD's, in a window with its view provider."""
    obj = parent.newObject("App::FeaturePython", name)
    make(obj, *values)
    if App.GuiUp:
        look(obj.ViewObject)
    return obj


def hinge(doc):
    """(simulation, arm, drive): the arm is a link, as inserted parts are; the drive has the formula."""
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


class Stuck:
    """The calls of an assembly of FreeCAD 1.1, for a solver that finds no position after 0.75 s: frames are
    missing at the end, and nothing else says so. Frame 0 is the part as it stands."""

    FRAMES = 4

    def __init__(self, assembly):
        assembly.Proxy = self

    def generateSimulation(self, simulation):  # noqa: N802 (FreeCAD's names)
        self.part = simulation.Document.getObject("Stuck")
        self.before, self.step = App.Placement(self.part.Placement), simulation.cTimeStepOutput
        self.found = self.FRAMES

    def numberOfFrames(self):  # noqa: N802
        return self.found + 1

    def updateForFrame(self, frame):  # noqa: N802
        way = App.Placement(V(10 * self.step * max(frame - 1, 0), 0, 0), App.Rotation())
        self.part.Placement = way.multiply(self.before)


def stuck(doc):
    """(simulation, part): one second by 0.25 s, of which the solver gives 0.75 s. Any FreeCAD has it: what
    FreeCAD's own solver makes of a mechanism that gets stuck changes with its version."""
    part = doc.addObject("Part::Box", "Stuck")
    simulation = doc.addObject("App::FeaturePython", "StuckSimulation")
    for name, value in (("aTimeStart", 0.0), ("bTimeEnd", 1.0), ("cTimeStepOutput", 0.25)):
        simulation.addProperty("App::PropertyFloat", name)
        setattr(simulation, name, value)
    whole = doc.addObject("App::FeaturePython", "StuckAssembly")
    whole.addProperty("App::PropertyLinkList", "Members")
    whole.Members = [part, simulation]
    Stuck(whole)
    doc.recompute()
    return simulation, part


def arm_after(seconds, speed=SPEED):
    """Where the arm is after so long: turned about the hinge."""
    turned = App.Rotation(V(0, 0, 1), math.degrees(speed * seconds))
    return App.Placement(HINGE - turned.multVec(V(20, 10, 10)), turned)
