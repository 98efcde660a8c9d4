# SPDX-License-Identifier: LGPL-2.1-or-later
"""Improve path: makes a motion shorter, with fewer keys, or with more clearance."""
from ..convert import InputProblem
from ..texts import QT_TRANSLATE_NOOP, translate
from .base import BaseCommand


class Command(BaseCommand):
    NAME = "SweptVolume_ImprovePath"
    TEXT = QT_TRANSLATE_NOOP("SweptVolume", "Improve path...")
    TIP = QT_TRANSLATE_NOOP(
        "SweptVolume",
        "Removes clashes from the selected motion, makes it shorter with fewer keys, or "
        "increases its clearance. The result is a new motion; the selected one is kept",
    )

    def missing(self, document):
        from ..panels import selection

        return selection.missing_motion_text(document)

    def run(self, document):
        from ..panels import improve_panel, selection

        obj = selection.the_motion(document)
        if len(obj.Placements) < 2:
            raise InputProblem(
                translate(
                    "SweptVolume",
                    '"{0}" has fewer than two keys, so there is no path to improve: add a key.',
                ).format(obj.Label)
            )
        part = selection.moved_part(obj)
        if part is None:
            raise InputProblem(
                translate(
                    "SweptVolume",
                    'The motion "{0}" does not say which part it moves: select the part '
                    "together with the motion.",
                ).format(obj.Label)
            )
        improve_panel.show(document, motion=obj, pairs=[part])
