# SPDX-License-Identifier: LGPL-2.1-or-later
"""Motion from path object: wire, sketch, robot trajectory, array, CAM path, assembly simulation."""
from ..convert import InputProblem
from ..texts import mark, translate
from .base import BaseCommand


class Command(BaseCommand):
    NAME = "SweptVolume_MotionFromSource"
    TEXT = mark("Commands", "Motion from path object...")
    TIP = mark(
        "Commands",
        "Makes a motion from the selected wire, sketch, robot trajectory, link or Draft array, or CAM "
        "path; from a path and a second curve that orients; from an assembly simulation, of a part or of "
        "all that move. It stays linked to it",
    )

    def missing(self, document):
        from ..panels import selection
        from ..trajectory import sources

        if sources.kind_for(sources.in_order(selection.plain())):
            return ""
        return translate(
            "Messages",
            "Select a wire, sketch, array, path, trajectory, or a simulation and a part.",
        )

    def run(self, document):
        from ..panels import selection, source_panel
        from ..trajectory import sources

        objects = sources.in_order(selection.plain())
        kind = sources.kind_for(objects)
        if not kind:
            raise InputProblem(
                translate(
                    "Messages",
                    "Select one wire, sketch, robot trajectory, link or Draft array, or CAM path; or a path "
                    "and a second curve; or a simulation of an assembly and the part to watch.",
                )
            )
        source_panel.show(document, kind, objects)
