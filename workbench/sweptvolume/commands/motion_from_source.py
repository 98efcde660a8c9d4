# SPDX-License-Identifier: LGPL-2.1-or-later
"""Motion from object: reads a wire, sketch, robot trajectory, array, CAM operation or assembly
simulation."""
from ..convert import InputProblem
from ..texts import QT_TRANSLATE_NOOP, translate
from .base import BaseCommand


class Command(BaseCommand):
    NAME = "SweptVolume_MotionFromSource"
    TEXT = QT_TRANSLATE_NOOP("SweptVolume", "Motion from object...")
    TIP = QT_TRANSLATE_NOOP(
        "SweptVolume",
        "Makes a motion from the selected wire, sketch, robot trajectory, link "
        "array, Draft array, CAM operation or assembly simulation. If you select a "
        "second curve, it sets the orientation. The motion stays linked to its source",
    )

    def missing(self, document):
        from ..panels import selection
        from ..trajectory import sources

        if sources.kind_for(sources.in_order(selection.plain())):
            return ""
        return translate(
            "SweptVolume",
            "Select a wire, sketch, array, CAM operation or robot trajectory; or an assembly "
            "simulation and the part whose motion you want.",
        )

    def run(self, document):
        from ..panels import selection, source_panel
        from ..trajectory import sources

        objects = sources.in_order(selection.plain())
        kind = sources.kind_for(objects)
        if not kind:
            raise InputProblem(
                translate(
                    "SweptVolume",
                    "Select one wire, sketch, robot trajectory, link array, Draft array or CAM "
                    "operation; or two curves; or an assembly simulation and the part whose "
                    "motion you want.",
                )
            )
        source_panel.show(document, kind, objects)
