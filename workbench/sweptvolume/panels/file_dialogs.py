# SPDX-License-Identifier: LGPL-2.1-or-later
"""Dialogs that ask for a file."""
import os

import FreeCADGui as Gui

from ..texts import translate
from .widgets import QtWidgets

_KINDS = [
    ("STEP", "*.step *.stp", ".step"),
    ("BREP", "*.brep *.brp", ".brep"),
    ("STL", "*.stl", ".stl"),
    ("PLY", "*.ply", ".ply"),
    ("OBJ", "*.obj", ".obj"),
    ("OFF", "*.off", ".off"),
    ("3MF", "*.3mf", ".3mf"),
]


def ask_export(name):
    """File to write, with a suffix; "" when cancelled."""
    filters = ["{} ({})".format(title, patterns) for title, patterns, _ in _KINDS]
    path, chosen = QtWidgets.QFileDialog.getSaveFileName(
        Gui.getMainWindow(),
        translate("Panels", "Export envelope"),
        name + ".step",
        ";;".join(filters),
    )
    if path and not os.path.splitext(path)[1]:
        path += _KINDS[filters.index(chosen)][2] if chosen in filters else ".step"
    return path


def ask_table(name):
    """CSV file to write; "" when cancelled."""
    path, _ = QtWidgets.QFileDialog.getSaveFileName(
        Gui.getMainWindow(), translate("Panels", "Export table"), name + ".csv", "CSV (*.csv)"
    )
    return path + ".csv" if path and not os.path.splitext(path)[1] else path
