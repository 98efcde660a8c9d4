# SPDX-License-Identifier: LGPL-2.1-or-later
"""Motion from selection: one pose for each selected object, in the order of selection."""
from .. import runner
from ..convert import InputProblem
from ..features import motion
from ..texts import mark, translate
from .base import BaseCommand


class Command(BaseCommand):
    NAME = "SweptVolume_MotionFromSelection"
    TEXT = mark("Commands", "Motion from selected placements")
    TIP = mark(
        "Commands",
        "Makes a motion from the placements of the selected objects, in the order of "
        "selection. The motion stays linked: if you move an object, its pose follows",
    )

    def missing(self, document):
        from ..panels import selection

        if len(selection.placed()) >= 2:
            return ""
        return translate("Messages", "Select at least two objects whose placements are the poses.")

    def run(self, document):
        from ..panels import selection

        objects = selection.placed()
        if len(objects) < 2:
            raise InputProblem(
                translate(
                    "Messages",
                    "Select at least two objects whose placements are the poses, in the order of the "
                    "motion: copies or links of the part, or local coordinate systems.",
                )
            )
        with runner.transaction(document, translate("Commands", self.TEXT)):
            obj = motion.motion_from_objects(document, objects)
            document.recompute([obj])
