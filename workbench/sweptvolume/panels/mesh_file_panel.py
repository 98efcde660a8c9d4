# SPDX-License-Identifier: LGPL-2.1-or-later
"""Task panel that warns before an outdated envelope is written to a mesh file. An envelope that is
up to date is written at once (run_panel)."""
import os

from .. import export, targets
from ..texts import translate
from . import focus, run_panel, tasks, widgets
from .run_panel import StartPanel
from .widgets import QtWidgets


class MeshFilePanel(StartPanel):
    """Says what the file will contain, and writes it after OK."""

    def __init__(self, source, path, note):
        self.document, self.source, self.path = source.Document, source, path
        self.run, self.buttons = None, []
        title = translate("SweptVolume", "Export envelope")
        self.form, layout = widgets.window(title, "SweptVolume_Export")
        self.box, self.message = widgets.RunBox(), widgets.message_label()
        where, self.note = QtWidgets.QLabel(os.path.basename(path)), QtWidgets.QLabel(note)
        widgets.hint(where, path)
        self.note.setObjectName("SweptVolumeWritten")
        self.note.setWordWrap(True)
        for widget in (self.box, self.message, where, self.note):
            layout.addWidget(widget)
        layout.addStretch(1)

    def start(self):
        if self.begin(lambda: tasks.ExportTask(self.source, self.path), self.ended):
            self.enable_buttons(False)

    def ended(self, run):
        self.run = None
        if run.state == "ok" or not widgets.alive(self.document):
            self._close()
            return
        self.enable_buttons(True)
        self.box.leave(self.form)
        widgets.show_failure(self.message, run)

    def _close(self):
        self.close_dialog()
        return True


def show(source, path):
    """Writes the mesh file. If the source is not up to date, first opens a panel that says so.
    Raises InputProblem."""
    note = export.outdated_note(source)
    if not note:
        return run_panel.show(tasks.ExportTask(source, path), "SweptVolume_Export")
    export.check_target(path)
    targets.check_not_read(path)
    panel = MeshFilePanel(source, path, note)
    focus.show(panel)
    return panel
