# SPDX-License-Identifier: LGPL-2.1-or-later
"""What task panels with a run share, and the one that shows nothing else: progress, stop, what went
wrong."""
import FreeCADGui as Gui

from .. import reading, runner
from ..texts import translate
from . import focus, guard, widgets
from .widgets import QtWidgets


class StartPanel:
    """Buttons of a panel that starts a run and stays open until its end. The panel has `run` (None: none
    is under way), start(), ended(run) and _close()."""

    #: Names of the buttons that start the run.
    STARTERS = ("Ok",)

    def getStandardButtons(self):
        kinds = [getattr(QtWidgets.QDialogButtonBox, name) for name in self.STARTERS]
        return widgets.standard_buttons(*kinds, QtWidgets.QDialogButtonBox.Cancel)

    def modifyStandardButtons(self, box):
        """FreeCAD hands over the buttons of the open panel."""
        widgets.forget_with(box)
        self.buttons = [
            box.button(getattr(QtWidgets.QDialogButtonBox, name)) for name in self.STARTERS
        ]
        self._button_box = box  # keeps the wrappers of the buttons alive

    def close_dialog(self):
        """The buttons go with the dialog."""
        self.buttons, self._button_box = [], None
        Gui.Control.closeDialog()

    def enable_buttons(self, on):
        for button in self.buttons:
            button.setEnabled(on)

    @guard.told
    def begin(self, task, ended, words=list, again=None):
        """Starts task() and follows it; ended(run) is called at its end. Returns whether it runs. words:
        gives contents.words() of the parts; where those are large, again() follows when they are read.
        """
        widgets.show_message(self.message, "")
        guard.check_fields(self.form)
        if reading.first(self.document, words, id(self), lambda: self._read(again)):
            text = translate("Panels", "Reading the parts ...")
            widgets.show_message(self.message, text)
            return False
        self.run = runner.start(task())
        self.box.follow(self.run)
        self.run.ended.connect(ended)
        return True

    def _read(self, again):
        open_ = widgets.shiboken.isValid(self.form)
        if open_ and widgets.alive(self.document) and self.run is None:
            widgets.show_message(self.message, "")
            again()

    def accept(self):
        if self.run is None:
            self.start()
        return False

    def reject(self):
        """Cancel: stops a run first; nothing was written before it ended."""
        if self.run is not None:
            self.run.ended.disconnect(self.ended)
            self.run.cancel()
        return self._close()


class StayingPanel(StartPanel):
    """A panel with Close alone, whose runs are started by a button of the form. It has `watch`, of its
    document, besides."""

    def getStandardButtons(self):
        return widgets.standard_buttons(QtWidgets.QDialogButtonBox.Close)

    def modifyStandardButtons(self, box):
        """The button that starts is one of the form."""
        widgets.forget_with(box)

    def leave(self):
        """What else ends with the panel."""

    def reject(self):
        """Close: stops what still runs; results stay."""
        self.watch.stop()
        if self.run is not None:
            self.run.ended.disconnect(self.ended)
            self.run.cancel()
            self.run = None
        self.leave()
        Gui.Control.closeDialog()
        return True


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
        widgets.show_failure(self.message, run)

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
    focus.show(panel)
    return panel
