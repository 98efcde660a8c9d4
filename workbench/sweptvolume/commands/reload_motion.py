# SPDX-License-Identifier: LGPL-2.1-or-later
"""Reload motion: reads the file or the source again."""
from .. import runner
from ..convert import InputProblem
from ..features import motion
from ..features.motion import Motion
from ..texts import mark, translate
from .base import BaseCommand


class Command(BaseCommand):
    NAME = "SweptVolume_ReloadMotion"
    TEXT = mark("Commands", "Reload motion")
    TIP = mark("Commands", "Reads the file or the source of the selected motion again")

    def missing(self, document):
        from ..panels import selection

        return selection.wanting_motion(document)

    def run(self, document):
        from ..panels import selection

        obj = selection.of_kind(document, Motion.KIND)[0]
        if obj is None:
            raise InputProblem(translate("Messages", "Select a motion first."))
        with runner.transaction(document, translate("Commands", self.TEXT)):
            motion.reload_source(obj)
            document.recompute()
