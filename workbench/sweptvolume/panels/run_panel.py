# SPDX-License-Identifier: LGPL-2.1-or-later
"""Task panel that only shows one run: progress, stop, and what went wrong."""
import FreeCADGui as Gui

from .. import runner
from ..texts import translate
from . import widgets
from .widgets import QtWidgets


class RunPanel:
    """Starts a task at once and closes itself when the task ends well."""

    def __init__(self, task, icon_name):
        self.form, layout = widgets.window(task.title, icon_name)
        self.text = QtWidgets.QLabel(task.title)
        self.box = widgets.RunBox()
        self.message = widgets.message_label()
        for widget in (self.box, self.message):
            layout.addWidget(widget)
        layout.addStretch(1)
        self.run = runner.start(task)
        self.box.follow(self.run)
        self.run.ended.connect(self.ended)

    def ended(self, run):
        self.box.hide()
        if run.state == "ok" or not widgets.alive(run.task.document):
            Gui.Control.closeDialog()
            return
        text = run.message
        if run.state == "cancelled":
            text = translate("Messages", "Cancelled. Nothing was changed.")
        widgets.show_message(self.message, text)

    def getStandardButtons(self):
        return widgets.standard_buttons(QtWidgets.QDialogButtonBox.Close)

    def reject(self):
        """Close: stops what still runs."""
        self.run.ended.disconnect(self.ended)
        self.run.cancel()
        Gui.Control.closeDialog()
        return True


def show(task, icon_name):
    panel = RunPanel(task, icon_name)
    Gui.Control.showDialog(panel)
    return panel
