# SPDX-License-Identifier: LGPL-2.1-or-later
"""Creates document objects from a run of a study file: the part and its neighbours as meshes, the
motion, and a clearance check or an envelope with the settings of the run. The check or envelope is
not computed yet. Its result will be computed from these objects."""
import pathlib

import FreeCAD as App

from .. import convert, studies
from ..meshes import mesh_from_arrays
from ..texts import translate
from ..trajectory.poses import INTERPOLATIONS
from . import clearance, envelope, motion, neighbour_rules, step_reader

#: Options of a run -> properties; lengths in mm.
_CLEARANCE = {
    "required": "RequiredDistance",
    "tolerance": "Accuracy",
    "deflection": "MeshDeflection",
}
_ENVELOPE = {
    "accuracy": "Accuracy",
    "resolution": "Resolution",
    "cell": "CellSize",
    "tolerance": "Tolerance",
    "offset": "Offset",
    "conservative": "Conservative",
    "keep_cavities": "KeepCavities",
    "position_filter": "PositionFilter",
}


class Taken:
    """A run that was read from a study file, in any thread. put() creates the objects. Raises
    core.CoreError, InputProblem."""

    def __init__(self, run):
        self.run = run
        body, self.motion, parts = studies.load(run, step_reader.parts_reader())
        self.mesh = mesh_from_arrays(body.vertices, body.triangles, beside=App.GuiUp)
        self.parts = [
            (name, mesh_from_arrays(part.vertices, part.triangles, beside=App.GuiUp), rule)
            for name, part, rule in parts
        ]

    def put(self, document):
        """Creates the check or envelope, and all its inputs in a group. GUI thread."""
        group = document.addObject("App::DocumentObjectGroup", "Run")
        group.Label = translate("SweptVolume", "Run {0}").format(self.run.name)
        body = self._shown(document, group, pathlib.PurePath(self.run.part).stem, self.mesh)
        times, translations, rotations = self.motion
        files = self.run.options[""]
        kinds = {core_name: name for name, core_name in INTERPOLATIONS.items() if name != "Spline"}
        path = motion.motion_from_poses(
            document,
            list(map(float, times)),
            convert.placements_from(translations, rotations),
            kinds[files.get("interpolation", "linear")],
        )
        path.Pivot = App.Vector(*files.get("pivot", (0.0, 0.0, 0.0)))
        group.addObject(path)
        if "clearance" not in self.run.compute:
            made = envelope.make_envelope(document, [body], path, self.run.name)
            self._set(made, _ENVELOPE, "envelope")
        else:
            made = self._check(document, group, body, path)
        # If two labels are equal, FreeCAD changes the one that is set last. So this label is set
        # after that of the check or envelope.
        path.Label = pathlib.PurePath(self.run.motion).stem
        group.addObject(made)
        return made

    def _check(self, document, group, body, path):
        found = [(self._shown(document, group, n, mesh), rule) for n, mesh, rule in self.parts]
        made = clearance.make_clearance(
            document,
            self.run.name,
            MovingParts=[(body, "")],
            Motion=path,
            Neighbours=[(obj, "") for obj, _ in found],
            AllVisible=False,
            RequiredDistance=0.0,
        )
        self._set(made, _CLEARANCE, "clearance")
        rules = {(obj, ""): neighbour_rules.from_text(rule) for obj, rule in found}
        neighbour_rules.write(made, rules)
        return made

    def _set(self, obj, names, stage):
        for key, value in self.run.options.get(stage, {}).items():
            if key in names:
                setattr(obj, names[key], value)

    def _shown(self, document, group, name, mesh):
        obj = document.addObject("Mesh::Feature", "Part")
        obj.Label, obj.Mesh = name, mesh
        group.addObject(obj)
        return obj


def problem_text(name):
    """Returns the text about a run that the study file does not contain any more."""
    text = translate(
        "SweptVolume",
        'The study file no longer contains the run "{0}": run the study again to update the list.',
    )
    return text.format(name)
