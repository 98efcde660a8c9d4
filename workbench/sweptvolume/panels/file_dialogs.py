# SPDX-License-Identifier: LGPL-2.1-or-later
"""Dialogs in which the user selects a file."""
import os

import FreeCAD as App
import FreeCADGui as Gui

from ..texts import translate
from .widgets import QtWidgets

#: Parameter group in which FreeCAD keeps the folder of the last file.
LAST = "User parameter:BaseApp/Preferences/General"
_KINDS = [
    ("STEP", "*.step *.stp", ".step"),
    ("BREP", "*.brep *.brp", ".brep"),
    ("STL", "*.stl", ".stl"),
    ("PLY", "*.ply", ".ply"),
    ("OBJ", "*.obj", ".obj"),
    ("OFF", "*.off", ".off"),
    ("3MF", "*.3mf", ".3mf"),
]


def folder_of(document):
    """Returns the default folder for files of a document: the folder of the document, the folder of
    the last file, or the home folder."""
    last = App.ParamGet(LAST).GetString("FileOpenSavePath", "")
    own = os.path.dirname(document.FileName) if document is not None else ""
    return next((f for f in (own, last) if f and os.path.isdir(f)), os.path.expanduser("~"))


def _beside_document(name):
    return os.path.join(folder_of(App.ActiveDocument), name.replace("/", "_"))


def ask_export(name):
    """Asks for the file to export, with a suffix. Returns "" if cancelled."""
    filters = ["{} ({})".format(title, patterns) for title, patterns, _ in _KINDS]
    path, chosen = QtWidgets.QFileDialog.getSaveFileName(
        Gui.getMainWindow(),
        translate("SweptVolume", "Export envelope"),
        _beside_document(name + ".step"),
        ";;".join(filters),
    )
    if path and not os.path.splitext(path)[1]:
        path += _KINDS[filters.index(chosen)][2] if chosen in filters else ".step"
    return path


def ask_report(name):
    """Asks for the HTML or PDF file to write. Returns "" if cancelled."""
    path, chosen = QtWidgets.QFileDialog.getSaveFileName(
        Gui.getMainWindow(),
        translate("SweptVolume", "Export report"),
        _beside_document(name + ".html"),
        "HTML (*.html);;PDF (*.pdf)",
    )
    if path and not os.path.splitext(path)[1]:
        path += ".pdf" if "pdf" in chosen else ".html"
    return path


def ask_table(name):
    """Asks for the CSV file to write. Returns "" if cancelled."""
    path, _ = QtWidgets.QFileDialog.getSaveFileName(
        Gui.getMainWindow(),
        translate("SweptVolume", "Export table"),
        _beside_document(name + ".csv"),
        "CSV (*.csv)",
    )
    return path + ".csv" if path and not os.path.splitext(path)[1] else path


def ask_study():
    """Asks for the study file to read. Returns "" if cancelled."""
    path, _ = QtWidgets.QFileDialog.getOpenFileName(
        Gui.getMainWindow(),
        translate("SweptVolume", "Study file"),
        folder_of(App.ActiveDocument),
        "TOML (*.toml)",
    )
    return path


def ask_folder(now):
    """Asks for the folder of the results. Returns "" if cancelled. now: the present folder, or ""."""
    return QtWidgets.QFileDialog.getExistingDirectory(
        Gui.getMainWindow(),
        translate("SweptVolume", "Folder for results"),
        now or folder_of(App.ActiveDocument),
    )
