# SPDX-License-Identifier: LGPL-2.1-or-later
"""Motion from driving value: changes a property, cell or constraint over a range and records how
parts move."""
from ..convert import InputProblem
from ..texts import QT_TRANSLATE_NOOP, translate
from .base import BaseCommand


class Command(BaseCommand):
    NAME = "SweptVolume_MotionDriven"
    TEXT = QT_TRANSLATE_NOOP("SweptVolume", "Motion from driving value...")
    TIP = QT_TRANSLATE_NOOP(
        "SweptVolume",
        "Changes a value (a spreadsheet cell, a sketch dimension or a variable of an assembly) "
        "and records how a part moves with it. Select the object with the value, then the part. "
        "If no part is selected, every part that moves gets a motion",
    )

    def missing(self, document):
        from ..panels import selection

        if len(selection.plain()) in (1, 2):
            return ""
        return translate(
            "SweptVolume",
            "Select the object with the value that drives the motion, then the part that moves.",
        )

    def run(self, document):
        from ..panels import selection, source_panel
        from ..trajectory import driven
        from ..trajectory.sources import in_order

        objects = in_order(selection.plain())
        if len(objects) not in (1, 2) or not driven.is_driver(objects[0]):
            raise InputProblem(
                translate(
                    "SweptVolume",
                    "Select the object with the value to change (a spreadsheet, a sketch "
                    "or variables), then the part that moves with the value.",
                )
            )
        source_panel.show(document, "Driven", objects)
