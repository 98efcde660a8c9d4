# SPDX-License-Identifier: LGPL-2.1-or-later
"""Settings of the source: changes the settings with which a motion was read from a wire,
driving value, array, file or other source."""
from ..convert import InputProblem
from ..features.motion import Motion
from ..features.motion_source import has_settings
from ..texts import QT_TRANSLATE_NOOP, translate
from .base import BaseCommand


class Command(BaseCommand):
    NAME = "SweptVolume_EditSource"
    TEXT = QT_TRANSLATE_NOOP("SweptVolume", "Settings of the source...")
    TIP = QT_TRANSLATE_NOOP(
        "SweptVolume",
        "Changes the settings with which the source of the selected motion is read "
        "(such as accuracy, duration or unit), and reads the source again",
    )
    ICON = "SweptVolume_MotionFromSource"

    def missing(self, document):
        from ..panels import selection, sourced

        found = selection.of_kind(document, Motion.KIND)[0]
        if found is None or has_settings(found):
            return selection.missing_motion_text(document)
        if sourced.is_sourced(found):
            return translate(
                "SweptVolume",
                "This motion was recorded from an assembly simulation, which has no settings "
                "here. To change the motion, change the simulation, then choose Reload motion.",
            )
        return translate(
            "SweptVolume",
            "This motion was not read from a source, so there are no settings to change.",
        )

    def run(self, document):
        from ..panels import selection, sourced

        problem = self.missing(document)
        if problem:
            raise InputProblem(problem)
        sourced.edit(selection.of_kind(document, Motion.KIND)[0])
