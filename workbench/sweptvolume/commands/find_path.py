# SPDX-License-Identifier: LGPL-2.1-or-later
"""Find path: searches for a path on which a part reaches its installed position between other parts."""
from ..texts import QT_TRANSLATE_NOOP, translate
from .base import BaseCommand


class Command(BaseCommand):
    NAME = "SweptVolume_FindPath"
    TEXT = QT_TRANSLATE_NOOP("SweptVolume", "Find path...")
    TIP = QT_TRANSLATE_NOOP(
        "SweptVolume",
        "Finds a path on which the selected part reaches its installed position and keeps a "
        "distance from its neighbours. Select the part first, then its neighbours. A selected "
        "motion sets the start and the goal",
    )

    def missing(self, document):
        from ..panels import selection

        if selection.motion() is not None or selection.moving_parts(document):
            return ""
        return translate("SweptVolume", "Select the part for which to find a path.")

    def run(self, document):
        from ..panels import find_path_panel, selection

        path = selection.motion()
        if path is not None:
            part = selection.moved_part(path)
            find_path_panel.show(document, pairs=[part] if part else [], path=path)
            return
        chosen = selection.moving_parts(document)
        find_path_panel.show(document, pairs=chosen[:1], neighbours=chosen[1:])
