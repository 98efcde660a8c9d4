# SPDX-License-Identifier: LGPL-2.1-or-later
"""Task panel: a motion from a CSV file, with the unit of its lengths."""
import os

import FreeCAD as App
import FreeCADGui as Gui

from .. import quantities, runner
from ..convert import pose_arrays
from ..features import motion
from ..features.motion import UNITS
from ..texts import translate
from ..trajectory import csv_file
from ..trajectory.poses import FRAME_HELP, FRAMES, INTERPOLATIONS
from . import focus, guard, widgets
from .file_dialogs import folder_of
from .widgets import QtWidgets


class FilePanel:
    """Shows the content of the file in the chosen unit before it is stored in a new motion (obj
    None) or in a motion that was read from a file before."""

    def __init__(self, document, path, obj=None):
        self.document, self.obj = document, obj
        self.form, layout = widgets.window(
            translate("SweptVolume", "Motion from file"), "SweptVolume_MotionFromFile"
        )
        rows = widgets.group(translate("SweptVolume", "File"), layout)
        self.path = QtWidgets.QLineEdit(path)
        browse = QtWidgets.QPushButton("...")
        browse.clicked.connect(self.browse)
        line = QtWidgets.QHBoxLayout()
        line.addWidget(self.path, 1)
        line.addWidget(browse)
        rows.addRow(line)
        self.unit = widgets.choice(UNITS, obj.SourceUnit if obj else "mm")
        self.unit.setObjectName("SweptVolumeUnit")
        now = (obj.Interpolation, obj.PoseType) if obj else ("Linear", "Absolute")
        self.interpolation = widgets.choice(list(INTERPOLATIONS), now[0])
        self.frame = widgets.choice(FRAMES, now[1])
        self.frame.setToolTip(translate("App::Property", FRAME_HELP))
        rows.addRow(translate("SweptVolume", "Unit"), self.unit)
        rows.addRow(translate("SweptVolume", "Interpolation"), self.interpolation)
        rows.addRow(translate("SweptVolume", "Pose type"), self.frame)
        self.message = widgets.message_label()
        layout.addWidget(self.message)
        layout.addStretch(1)
        self.path.editingFinished.connect(self.read_file)
        self.unit.currentIndexChanged.connect(self.read_file)
        self.read_file()

    def browse(self):
        path = ask_file()
        if path:
            self.path.setText(path)
            self.read_file()

    @guard.shows_problems
    def read_file(self, *ignored):
        """Reads the file and describes its content."""
        poses = csv_file.read(self.path.text(), self.unit.currentData())
        points = pose_arrays(poses.placements)[0]
        size = points.max(axis=0) - points.min(axis=0)
        text = translate("SweptVolume", "{0} poses, {1} to {2} s, travel {3} x {4} x {5}")
        widgets.show_message(
            self.message,
            text.format(
                quantities.count(len(poses)),
                quantities.number(poses.times[0], quantities.TABLE_DIGITS),
                quantities.number(poses.times[-1], quantities.TABLE_DIGITS),
                *map(quantities.quantity, size),
            ),
        )

    @guard.shows_problems
    def accept(self):
        with runner.transaction(self.document, translate("SweptVolume", "Motion from file")):
            given = self.path.text(), self.unit.currentData()
            rules = self.interpolation.currentData(), self.frame.currentData()
            if self.obj is None:
                obj = motion.motion_from_file(self.document, *given, *rules)
                obj.Label = os.path.splitext(os.path.basename(self.path.text()))[0]
                self.document.recompute([obj])
            else:
                self.obj.SourceFile, self.obj.SourceUnit = given
                self.obj.Interpolation, self.obj.PoseType = rules
                motion.reload_source(self.obj)
                self.document.recompute()
        Gui.Control.closeDialog()
        return True

    def reject(self):
        Gui.Control.closeDialog()
        return True


def ask_file():
    """Asks for a file. Returns "" if cancelled."""
    kinds = translate("SweptVolume", "Motions") + " (*.csv *.txt *.csv.gz *.csv.xz);;"
    kinds += translate("SweptVolume", "All files") + " (*)"
    answer = QtWidgets.QFileDialog.getOpenFileName(
        Gui.getMainWindow(),
        translate("SweptVolume", "Motion from file"),
        folder_of(App.ActiveDocument),
        kinds,
    )
    return answer[0]


def show(document, path, obj=None):
    panel = FilePanel(document, path, obj)
    focus.show(panel)
    return panel
