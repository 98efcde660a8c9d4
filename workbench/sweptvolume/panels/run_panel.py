# SPDX-License-Identifier: LGPL-2.1-or-later
"""Base of the task panels with a run, and a panel that shows only a run: progress, stop, errors."""
import FreeCADGui as Gui

from .. import reading, runner
from ..texts import translate
from . import focus, guard, widgets
from .widgets import QtWidgets


class StartPanel:
    """Buttons of a panel that starts a run and stays open until its end. The panel defines `run`
    (None: no run), start(), ended(run) and _close()."""

    #: Names of the buttons that start the run.
    STARTERS = ("Ok",)

    def getStandardButtons(self):
        kinds = [getattr(QtWidgets.QDialogButtonBox, name) for name in self.STARTERS]
        return widgets.standard_buttons(*kinds, QtWidgets.QDialogButtonBox.Cancel)

    def modifyStandardButtons(self, box):
        """Called by FreeCAD with the buttons of the open panel."""
        widgets.forget_with(box)
        self.buttons = [
            box.button(getattr(QtWidgets.QDialogButtonBox, name)) for name in self.STARTERS
        ]
        self._button_box = box  # keeps the Python wrappers of the buttons alive

    def close_dialog(self):
        """Forgets the buttons, which disappear with the dialog."""
        self.buttons, self._button_box = [], None
        Gui.Control.closeDialog()

    def enable_buttons(self, on):
        for button in self.buttons:
            button.setEnabled(on)

    @guard.shows_problems
    def begin(self, task, ended, words=list, again=None):
        """Starts task() and calls ended(run) at its end. Returns whether the run has started.
        words: returns contents.words() of the parts. If the parts are large, they are read
        first, and again() is called afterwards.
        """
        widgets.show_message(self.message, "")
        guard.check_fields(self.form)
        if reading.first(self.document, words, id(self), lambda: self._read(again)):
            text = translate("SweptVolume", "Reading the parts ...")
            widgets.show_message(self.message, text)
            return False
        self.run = runner.start(task())
        self.box.follow(self.run)
        self.run.ended.connect(ended)
        return True

    def _read(self, again):
        # A panel that was closed meanwhile loses its labels before its form.
        open_ = all(map(widgets.shiboken.isValid, (self.form, self.message)))
        if open_ and widgets.alive(self.document) and self.run is None:
            widgets.show_message(self.message, "")
            again()

    def accept(self):
        if self.run is None:
            self.start()
        return False

    def reject(self):
        """Cancel: first stops the run, if there is one. Until then, the run has written nothing."""
        if self.run is not None:
            self.run.ended.disconnect(self.ended)
            self.run.cancel()
        return self._close()


class StayingPanel(StartPanel):
    """A panel whose only dialog button is Close. Buttons of the form start its runs. The panel also
    has `watch`, the observer of its document (watched()). A panel that shows the result of an
    object has that object in `obj` and defines show_result(), which calls note_state()."""

    obj = None

    def watched(self):
        """Returns the observer of the document: it closes the panel with the document, and shows
        the result again when the result or its state has changed."""
        return widgets.DocumentWatch(self.document, self.reject, self._refresh)

    def _state(self):
        names = "Status", "Message", "Summary", "InputHash"
        return tuple(getattr(self.obj, name, None) for name in names)

    def note_state(self):
        """Stores which state of the result is shown."""
        self._noted = self._state()

    @guard.shows_problems
    def _refresh(self):
        if self.run is not None:  # a run shows its result itself
            return
        self.renew_inputs()
        if self.obj is None:
            return
        if not widgets.alive(self.obj):
            self.lost()
            self.obj = None
        elif self._state() == self._noted:
            return
        self.show_result()

    def renew_inputs(self):
        """Called after changes of the document. Subclasses update the objects that they list."""

    def lost(self):
        """Called when the object was deleted while the panel shows it, for example by Undo."""

    def show_result(self):
        raise NotImplementedError

    def getStandardButtons(self):
        return widgets.standard_buttons(QtWidgets.QDialogButtonBox.Close)

    def modifyStandardButtons(self, box):
        """Keeps no buttons, because the button that starts a run belongs to the form."""
        widgets.forget_with(box)

    def leave(self):
        """Called on Close, after a run was cancelled. Subclasses stop their timers and players here,
        and remove what they show in the 3D view."""

    def reject(self):
        """Close: stops a run in progress. Results stay."""
        self.watch.stop()
        if self.run is not None:
            self.run.ended.disconnect(self.ended)
            self.run.cancel()
            self.run = None
        self.leave()
        Gui.Control.closeDialog()
        return True


class RunPanel:
    """Starts a task at once, and closes itself when the task succeeds."""

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
        """Close: stops a run in progress."""
        self.run.ended.disconnect(self.ended)
        self.run.cancel()
        Gui.Control.closeDialog()
        return True


def show(task, icon_name):
    panel = RunPanel(task, icon_name)
    focus.show(panel)
    return panel
