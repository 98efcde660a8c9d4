# SPDX-License-Identifier: LGPL-2.1-or-later
"""Offers to install the core: lists what is fetched and from where, shows the progress, and can be
cancelled. FreeCAD can be used while the dialog is open."""
import os
import sys
import threading

import FreeCADGui as Gui

from .. import __version__, core, core_install, icon, interpreter, quantities
from ..texts import translate
from .widgets import QtCore, QtWidgets, show_message

#: Interval (ms) between two checks of the background work.
POLL = 100
#: The open dialog, or None.
opened = None
_offered = False


def offer():
    """Shows the dialog. Only one can be open."""
    global opened
    if opened is None:
        opened = CoreDialog()
    opened.show()
    opened.raise_()
    return opened


def offer_once():
    """Shows the dialog if the core is missing, once in a session."""
    global _offered
    if not _offered and not core.available():
        _offered = True
        offer()


class CoreDialog(QtWidgets.QDialog):
    def __init__(self):
        super().__init__(Gui.getMainWindow())
        self.setObjectName("SweptVolumeCore")
        self.setWindowTitle(translate("SweptVolume", "Install the core"))
        self.setWindowIcon(Gui.getIcon(icon("SweptVolume_InstallCore")))
        self.setAttribute(QtCore.Qt.WA_DeleteOnClose)
        self.run, self.found, self.lookup = None, None, None
        layout = QtWidgets.QVBoxLayout(self)
        self.state = self._label("SweptVolumeCoreState")
        layout.addWidget(self.state)
        layout.addWidget(self._facts())
        self.bar = QtWidgets.QProgressBar()
        self.line = self._label("SweptVolumeCoreLine")
        self.message = self._label("SweptVolumeCoreMessage")
        for widget in (self.bar, self.line, self.message):
            layout.addWidget(widget)
            widget.hide()
        layout.addStretch(1)
        layout.addLayout(self._buttons())
        self.timer = QtCore.QTimer(self)
        self.timer.timeout.connect(self._poll)
        self.setMinimumWidth(560)
        self._show_state()
        self._ask_pip()

    def _label(self, name):
        label = QtWidgets.QLabel()
        label.setObjectName(name)
        label.setWordWrap(True)
        label.setTextInteractionFlags(QtCore.Qt.TextSelectableByMouse)
        return label

    def _facts(self):
        """Returns the box that lists what is fetched."""
        box = QtWidgets.QGroupBox(translate("SweptVolume", "What is fetched"))
        rows = QtWidgets.QFormLayout(box)
        self.source = self._label("SweptVolumeCoreSource")
        self.source.setText(translate("SweptVolume", "asking pip..."))
        folder = self._label("SweptVolumeCoreFolder")
        folder.setText(core_install.target())
        package = self._label("SweptVolumeCorePackage")
        text = translate("SweptVolume", "{0}, version {1}, for Python {2}")
        package.setText(text.format(core_install.PACKAGE, __version__, interpreter.VERSION))
        size = QtWidgets.QLabel(translate("SweptVolume", "about {0} MB").format(core_install.SIZE))
        rows.addRow(translate("SweptVolume", "Package"), package)
        rows.addRow(translate("SweptVolume", "Size"), size)
        rows.addRow(translate("SweptVolume", "From"), self.source)
        rows.addRow(translate("SweptVolume", "Into"), folder)
        return box

    def _buttons(self):
        row = QtWidgets.QHBoxLayout()
        self.install = QtWidgets.QPushButton(translate("SweptVolume", "Install"))
        self.file = QtWidgets.QPushButton(translate("SweptVolume", "From a file..."))
        self.file.setToolTip(
            translate(
                "SweptVolume", "Installs a package file (.whl) that you have downloaded or built."
            )
        )
        self.stop = QtWidgets.QPushButton(translate("SweptVolume", "Stop"))
        self.done = QtWidgets.QPushButton(translate("SweptVolume", "Close"))
        names = ("SweptVolumeCoreInstall", "SweptVolumeCoreFile", "SweptVolumeCoreStop")
        row.addStretch(1)
        for button, name in zip((self.install, self.file, self.stop, self.done), names + ("",)):
            button.setObjectName(name or "SweptVolumeCoreClose")
            row.addWidget(button)
        self.install.clicked.connect(lambda: self._start(""))
        self.file.clicked.connect(self._choose)
        self.stop.clicked.connect(self._stop)
        self.done.clicked.connect(self.close)
        return row

    def _show_state(self):
        """Shows whether the core works, and enables the buttons that can be used."""
        running, works = self.run is not None, core.available()
        blocked = "" if works else core_install.obstacle()
        if works:
            text = translate("SweptVolume", "The core is installed: {0}").format(
                core.module().__file__
            )
        elif blocked:
            text = translate(
                "SweptVolume",
                "The core in {0} cannot be used, but FreeCAD would load it instead of an installed "
                "core. Build it again, or delete it.",
            ).format(blocked)
        elif "_swept" in sys.modules:
            text = core.problem().split("\n")[0]
        else:
            text = translate(
                "SweptVolume",
                "The workbench computes with a compiled Python package, its core. It is not "
                "installed for the Python {0} of this FreeCAD.",
            ).format(interpreter.VERSION)
        self.state.setText(text)
        for button in (self.install, self.file):
            button.setEnabled(not running and not works and not blocked)
        self.stop.setEnabled(running)
        self.done.setEnabled(not running)

    def _say(self, label, text):
        """Shows a text in a label, and makes the window high enough for all its texts."""
        if label.text() == text and label.isVisible() == bool(text):
            return
        show_message(label, text)
        self.layout().activate()
        needed = self.layout().totalHeightForWidth(self.width())
        if needed > self.height():
            self.resize(self.width(), needed)

    def _ask_pip(self):
        """Asks pip in the background from where it fetches packages."""

        def ask():
            try:
                self.found = "\n".join(map(source_text, core_install.sources()))
            except Exception as problem:
                self.found = str(problem)

        self.lookup = threading.Thread(target=ask, daemon=True)
        self.lookup.start()
        self.timer.start(POLL)

    def _choose(self):
        path = ask_wheel()
        if path:
            size = quantities.megabytes(os.path.getsize(path))
            self._say(self.source, "{} ({})".format(path, size))
            self._start(path)

    def _start(self, wheel):
        self.run = core_install.Installation(wheel)
        self.run.start()
        self.bar.setRange(0, 0)  # pip does not say how much is left
        self.bar.show()
        self._say(self.message, "")
        self._show_state()
        self.stop.setFocus()
        self.timer.start(POLL)

    def _stop(self):
        self.stop.setEnabled(False)
        self.run.cancel()

    def _poll(self):
        if self.lookup is not None and not self.lookup.is_alive():
            self._say(self.source, self.found)
            self.lookup = None
        if self.run is not None:
            self._say(self.line, self.run.line)
            if not self.run.is_alive():
                self._ended()
        if self.run is None and self.lookup is None:
            self.timer.stop()

    def _ended(self):
        run, self.run = self.run, None
        self.bar.hide()
        self.line.hide()
        text = run.problem
        if not text and not run.restart and core.available():
            text = translate("SweptVolume", "Installed. You can use the workbench now.")
        elif not text:
            text = translate("SweptVolume", "Installed. Start FreeCAD again to use it.")
        self._show_state()
        self._say(self.message, text)
        if run.restart and not run.problem:
            self.install.setEnabled(False)
            self.file.setEnabled(False)
        self.done.setFocus()

    def closeEvent(self, event):  # noqa: N802
        global opened
        if self.run is not None:
            self.run.cancel()
        self.timer.stop()
        opened = None
        event.accept()

    def reject(self):
        """Closes by Escape, which cancels a run."""
        self.close()


def source_text(source):
    """Returns the address of a source as users see it: with a remark if the core is not there yet."""
    if core_install.is_unpublished_on(source):
        text = translate("SweptVolume", "{0} (the core is not published there yet)")
        return text.format(source)
    return source


def ask_wheel():
    """Asks for the file of the package. Returns "" if cancelled."""
    path, _ = QtWidgets.QFileDialog.getOpenFileName(
        Gui.getMainWindow(),
        translate("SweptVolume", "Install the core"),
        os.path.expanduser("~"),
        "Python (swept_volume-*.whl)",
    )
    return path
