# SPDX-License-Identifier: LGPL-2.1-or-later
"""A driver or a simulation is run in front of a dialog with Cancel, one frame between two events of the
window: the document belongs to the run meanwhile, and the dialog keeps everything else away from it."""
import FreeCADGui as Gui

from ..features import joint_motions
from ..texts import translate
from .widgets import QtCore, QtWidgets

#: ms after which the dialog is seen.
SHOWN_AFTER = 400


def recorded(document, settings):
    """The run (moved_parts.Run) of a source of sources.FROM_JOINTS; None where it was cancelled: the document
    is as before then. Raises InputProblem."""
    run = joint_motions.begin(document, settings)
    most = int(settings.get("count", 0))
    dialog = QtWidgets.QProgressDialog(Gui.getMainWindow())
    dialog.setObjectName("SweptVolumeFrames")
    text = translate("Panels", 'Running "{0}" ...').format(settings.objects[0].Label)
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
