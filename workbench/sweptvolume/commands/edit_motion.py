# SPDX-License-Identifier: LGPL-2.1-or-later
"""Edit motion: the path editor on an existing motion."""
from ..convert import InputProblem
from ..texts import mark, translate
from .base import BaseCommand


class Command(BaseCommand):
    NAME = "SweptVolume_EditMotion"
    TEXT = mark("Commands", "Edit motion...")
    TIP = mark(
        "Commands",
        "Edits the keys of the selected motion in a table, plays it with a ghost of the part",
    )

    def run(self, document):
        from ..panels import motion_panel, selection

        obj = selection.motion()
        if obj is None:
            raise InputProblem(translate("Messages", "Select a motion first."))
        motion_panel.show(document, obj)
