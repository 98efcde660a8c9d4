# SPDX-License-Identifier: LGPL-2.1-or-later
"""Motion from selection: each selected object gives one pose, in the order of selection."""
from .. import runner
from ..convert import InputProblem
from ..features import motion
from ..texts import QT_TRANSLATE_NOOP, translate
from .base import BaseCommand


class Command(BaseCommand):
    NAME = "SweptVolume_MotionFromSelection"
    TEXT = QT_TRANSLATE_NOOP("SweptVolume", "Motion from selected placements")
    TIP = QT_TRANSLATE_NOOP(
        "SweptVolume",
        "Makes a motion from the placements of the selected objects, in the order of "
        "selection. The motion stays linked to the objects: if you move an object, "
        "its pose changes too",
    )

    def missing(self, document):
        from ..panels import selection

        if len(selection.placed()) >= 2:
            return ""
        return translate(
            "SweptVolume", "Select at least two objects: their placements become the poses."
        )

    def run(self, document):
        from ..panels import selection

        objects = selection.placed()
        if len(objects) < 2:
            raise InputProblem(
                translate(
                    "SweptVolume",
                    "Select at least two objects in the order of the motion: their "
                    "placements become the poses. Use copies or links of the part, or "
                    "local coordinate systems.",
                )
            )
        with runner.transaction(document, translate("SweptVolume", self.TEXT)):
            obj = motion.motion_from_objects(document, objects)
            document.recompute([obj])
