# SPDX-License-Identifier: LGPL-2.1-or-later
"""Task panel: a motion from a path object."""
import FreeCADGui as Gui

from ..convert import InputProblem
from ..features import motion
from ..texts import translate
from ..trajectory.curve import ORIENTATIONS
from ..trajectory.poses import FRAME_HELP, FRAMES, INTERPOLATIONS
from . import widgets
from .widgets import QtWidgets


class SourcePanel:
    """Asks what the kind of source needs."""

    def __init__(self, document, kind, objects):
        self.document, self.kind, self.objects = document, kind, objects
        title = translate("Panels", "Motion from path object")
        self.form, layout = widgets.window(title, "SweptVolume_MotionFromSource")
        rows = widgets.group(", ".join(o.Label for o in objects), layout)
        self.values = {}
        if kind in ("Curve", "Robot"):
            count = QtWidgets.QSpinBox()
            count.setRange(2, 100000)
            count.setValue(32)
            rows.addRow(translate("Panels", "Poses"), count)
            self.values["count"] = count.value
        if kind == "Curve":
            orientation = widgets.choice(ORIENTATIONS, "Fixed")
            rows.addRow(translate("Panels", "Orientation"), orientation)
            self.values["orientation"] = orientation.currentData
            self._seconds(rows, "duration", translate("Panels", "Duration"), 10.0)
        if kind == "Array":
            self._seconds(rows, "step", translate("Panels", "Time a pose"), 1.0)
        self.interpolation = widgets.choice(list(INTERPOLATIONS), "Linear")
        self.frame = widgets.choice(FRAMES, "Absolute")
        self.frame.setToolTip(translate("Properties", FRAME_HELP))
        rows.addRow(translate("Panels", "Between poses"), self.interpolation)
        rows.addRow(translate("Panels", "A pose is"), self.frame)
        self.message = widgets.message_label()
        layout.addWidget(self.message)
        layout.addStretch(1)

    def _seconds(self, rows, name, title, value):
        field = QtWidgets.QDoubleSpinBox()
        field.setRange(0.001, 1e6)
        field.setSuffix(" s")
        field.setValue(value)
        rows.addRow(title, field)
        self.values[name] = field.value

    def accept(self):
        self.document.openTransaction(translate("Messages", "Motion from path object"))
        try:
            values = {name: read() for name, read in self.values.items()}
            obj = motion.motion_from_source(
                self.document,
                self.kind,
                self.objects,
                self.interpolation.currentData(),
                self.frame.currentData(),
                **values,
            )
            self.document.recompute([obj])
        except InputProblem as problem:
            self.document.abortTransaction()
            widgets.show_message(self.message, str(problem))
            return False
        self.document.commitTransaction()
        Gui.Control.closeDialog()
        return True

    def reject(self):
        Gui.Control.closeDialog()
        return True


def show(document, kind, objects):
    panel = SourcePanel(document, kind, objects)
    Gui.Control.showDialog(panel)
    return panel
