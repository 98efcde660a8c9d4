# SPDX-License-Identifier: LGPL-2.1-or-later
"""Motion from path object: wire, sketch, robot trajectory, array, CAM path."""
from ..convert import InputProblem
from ..texts import mark, translate
from .base import BaseCommand


class Command(BaseCommand):
    NAME = "SweptVolume_MotionFromSource"
    TEXT = mark("Commands", "Motion from path object...")
    TIP = mark(
        "Commands",
        "Makes a motion from the selected wire, sketch, robot trajectory, link or Draft array, or CAM "
        "path. It stays linked to it",
    )

    def run(self, document):
        from ..panels import selection, source_panel
        from ..trajectory import sources

        objects = selection.placed() or selection.plain()
        kind = sources.kind_for(objects)
        if not kind:
            raise InputProblem(
                translate(
                    "Messages",
                    "Select one wire, sketch, robot trajectory, link or Draft array, or CAM path.",
                )
            )
        source_panel.show(document, kind, objects)
