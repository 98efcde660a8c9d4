# SPDX-License-Identifier: LGPL-2.1-or-later
"""Create envelope: opens the panel with the selected parts and motion."""
from ..features import motion as motion_feature
from ..features.base import objects_of_kind
from ..texts import QT_TRANSLATE_NOOP
from .base import BaseCommand


class Command(BaseCommand):
    NAME = "SweptVolume_Envelope"
    TEXT = QT_TRANSLATE_NOOP("SweptVolume", "Create envelope...")
    TIP = QT_TRANSLATE_NOOP(
        "SweptVolume",
        "Computes the space that the selected parts occupy during a motion. Select "
        "solids or meshes (also inside groups and links) and a motion",
    )

    def run(self, document):
        from ..panels import envelope_panel, selection

        motion = selection.motion()
        motions = objects_of_kind(document, motion_feature.Motion.KIND)
        if motion is None and motions:
            motion = motions[-1]
        envelope_panel.show(document, selection.moving_parts(document), motion)
