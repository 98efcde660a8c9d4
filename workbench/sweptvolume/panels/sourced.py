# SPDX-License-Identifier: LGPL-2.1-or-later
"""Motions with a source in the panels: name and settings of the source, and removing the link."""
import os

import FreeCADGui as Gui

from ..texts import translate
from .widgets import QtWidgets


def is_sourced(obj):
    """Returns whether the poses of a motion come from a source."""
    return obj is not None and obj.SourceType != "Stored"


def name_of(obj):
    """Returns the name of the source, for users."""
    if obj.SourceType == "File":
        return os.path.basename(obj.SourceFile)
    return ", ".join(source.Label for source in obj.SourceObjects)


def edit(obj):
    """Opens the panel with the settings of a motion's source."""
    from . import file_panel, source_panel

    if obj.SourceType == "File":
        file_panel.show(obj.Document, obj.SourceFile, obj)
    else:
        source_panel.show(obj.Document, obj.SourceType, list(obj.SourceObjects), obj)


def ask_to_unlink(obj):
    """Asks the user whether to remove the link of a motion to its source. Returns the answer."""
    text = translate(
        "SweptVolume",
        'The poses of "{0}" are linked to {1}. To edit a key, you must remove the '
        "link. The motion then keeps its current poses. Remove the link?",
    ).format(obj.Label, name_of(obj))
    buttons = QtWidgets.QMessageBox.Yes | QtWidgets.QMessageBox.No
    title = translate("SweptVolume", "Motion")
    answer = QtWidgets.QMessageBox.question(Gui.getMainWindow(), title, text, buttons)
    return answer == QtWidgets.QMessageBox.Yes
