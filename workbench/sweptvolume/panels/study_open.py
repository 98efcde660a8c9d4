# SPDX-License-Identifier: LGPL-2.1-or-later
"""Opens a run of a study: the panel of its envelope, or the panel of its check with the moving part
at the time of the worst row. A check that is not up to date is computed first."""
from PySide import QtCore

from ..features import clearance, clearance_table
from . import clearance_panel, envelope_panel, widgets


class Opener:
    """panel: the panel of the study. It closes before the run is opened."""

    def __init__(self, panel):
        self.panel = panel

    def show(self, source):
        """Opens the source of a run. Called from the event loop, after the panel of the study has
        closed."""
        self.panel.reject()
        QtCore.QTimer.singleShot(0, lambda: _open(source))


def _open(source):
    if not widgets.alive(source):
        return
    if not clearance.is_clearance(source):
        envelope_panel.show(source.Document, obj=source)
        return
    panel = clearance_panel.show(source.Document, obj=source)
    if source.Status == clearance.UP_TO_DATE:
        _worst(panel)
    elif panel.start():
        panel.run.ended.connect(lambda run: _worst(panel) if run.state == "ok" else None)


def _worst(panel):
    """Chooses the worst row, so that the part is shown at the time of this row."""
    for index in clearance_table.worst_rows(panel.report)[:1]:
        panel.choose(index)
