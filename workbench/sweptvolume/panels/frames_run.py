# SPDX-License-Identifier: LGPL-2.1-or-later
"""Runs a driver or a simulation behind a dialog with Cancel. Between two frames, the window handles
its events. The run changes the document; the dialog blocks all other input."""
import FreeCADGui as Gui

from ..features import joint_motions
from ..texts import translate
from .widgets import QtCore, QtWidgets

#: Time (ms) until the dialog appears.
SHOWN_AFTER = 400


def recorded(document, settings):
    """Returns the finished run (moved_parts.Run) of a source of sources.FROM_JOINTS, or None if it
    was cancelled; then the document is as before. Raises InputProblem."""
    run = joint_motions.begin(document, settings)
    most = int(settings.get("count", 0))
    dialog = QtWidgets.QProgressDialog(Gui.getMainWindow())
    dialog.setObjectName("SweptVolumeFrames")
    text = translate("SweptVolume", 'Running "{0}" ...').format(settings.objects[0].Label)
    dialog.setLabelText(text)
    dialog.setRange(0, most)
    dialog.setWindowModality(QtCore.Qt.ApplicationModal)
    dialog.setMinimumDuration(SHOWN_AFTER)
    try:
        while run.advance():
            dialog.setValue(min(len(run.times), most - 1) if most else 0)
            QtWidgets.QApplication.processEvents()
            if dialog.wasCanceled():
                return None
        return run
    finally:
        run.close()
        dialog.reset()
        dialog.deleteLater()
