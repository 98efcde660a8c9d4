# SPDX-License-Identifier: LGPL-2.1-or-later
"""Poses of a part in a simulation of the built-in Assembly workbench (FreeCAD 1.1 and later).

FreeCAD runs the simulation. Frame 0 is the present state of the assembly. The motion begins with
frame 1 at the start time of the simulation and continues with its output step. Afterwards the parts
are moved back.
"""
import math

from ..convert import InputProblem, global_placement, matrix_of, root_path
from ..quantities import count, number
from ..texts import translate
from .frames import no_frames, poses_of

_CALLS = ("generateSimulation", "numberOfFrames", "updateForFrame")


def is_simulation(obj):
    """Returns whether an object is a simulation. Only its properties distinguish a simulation,
    because all objects made in Python have the same type."""
    names = getattr(obj, "PropertiesList", [])
    return {"aTimeStart", "bTimeEnd", "cTimeStepOutput"}.issubset(names)


def assembly_of(simulation):
    """Returns the assembly of a simulation."""
    seen, waiting = set(), [simulation]
    while waiting:
        obj = waiting.pop()
        if all(hasattr(obj, call) for call in _CALLS):
            return obj
        for user in obj.InList:
            if user.Name not in seen:
                seen.add(user.Name)
                waiting.append(user)
    raise InputProblem(
        translate(
            "SweptVolume",
            '"{0}" cannot be simulated by this version of FreeCAD: simulations need FreeCAD 1.1.',
        ).format(simulation.Label)
    )


def pair(objects):
    """Returns (the simulation, the part to record). Raises InputProblem."""
    if len(objects) != 2 or not is_simulation(objects[0]):
        raise InputProblem(
            translate(
                "SweptVolume",
                "Select an assembly simulation in the tree, then also the part whose motion you "
                "want.",
            )
        )
    return objects


def _seconds(value):
    return float(getattr(value, "Value", value))


def poses(objects):
    """Returns the poses. objects: the simulation, the part to record."""
    simulation, part = pair(objects)
    return poses_of(frames(simulation), part)


def frames(simulation):
    """Runs the simulation; a generator as in frames.py."""
    assembly = assembly_of(simulation)
    start, step = _seconds(simulation.aTimeStart), _seconds(simulation.cTimeStepOutput)
    try:
        assembly.generateSimulation(simulation)
        found = assembly.numberOfFrames() - 1
        if found < 2:
            raise no_frames(simulation.Label)
        for frame in range(found):
            assembly.updateForFrame(frame + 1)
            yield start + step * frame
    finally:
        assembly.updateForFrame(0)
    return shortfall(simulation.Label, start, _seconds(simulation.bTimeEnd), step, found)


def shortfall(label, start, end, step, frames):
    """Returns the note if a simulation from start to end by step (s) gave only this number of
    frames, or "" if it is complete."""
    expected = int(math.floor((end - start) / step + 1e-6)) + 1 if step > 0 else frames
    if frames >= expected:
        return ""
    return translate(
        "SweptVolume",
        'The simulation "{0}" stopped early, at {3} s of {4} s ({1} of {2} frames): '
        "its solver found no valid position. Check the joints and formulas, or set "
        "an earlier end time.",
    ).format(
        label, count(frames), count(expected), number(start + step * (frames - 1)), number(end)
    )


def signature(objects):
    """Returns a text that changes when the simulation or the placement of the part changes."""
    simulation, part = pair(objects)
    words = [repr(_seconds(getattr(simulation, n))) for n in ("aTimeStart", "bTimeEnd")]
    words.append(repr(_seconds(simulation.cTimeStepOutput)))
    for motion in getattr(simulation, "Group", []):
        words += [str(getattr(motion, "Formula", "")), str(getattr(motion, "MotionType", ""))]
    matrix = matrix_of(global_placement(*root_path(part))).round(7) + 0.0
    return " ".join(words) + str(matrix.tolist())
