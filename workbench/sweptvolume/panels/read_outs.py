# SPDX-License-Identifier: LGPL-2.1-or-later
"""Numbers and warnings of a computed envelope, which the user can read and copy."""
from PySide import QtCore

from .. import quantities
from ..features.envelope import CANCELLED, FAILED, UP_TO_DATE, report_of, warnings_of
from ..texts import translate
from . import widgets
from .widgets import QtWidgets


class ReadOuts(QtWidgets.QGroupBox):
    """Hidden until there is a result. Follows the document until stop()."""

    def __init__(self, document):
        super().__init__(translate("SweptVolume", "Result"))
        self.obj = None
        self.watch = widgets.DocumentWatch(document, self.hide, self._refresh)
        self.text = QtWidgets.QLabel()
        self.text.setObjectName("SweptVolumeReadOuts")
        self.text.setTextInteractionFlags(QtCore.Qt.TextSelectableByMouse)
        self.text.setWordWrap(True)
        column = QtWidgets.QVBoxLayout(self)
        column.setContentsMargins(*widgets.MARGINS)
        column.addWidget(self.text)
        self.hide()

    def show_result(self, obj):
        """Shows the stored result of an envelope object (or None)."""
        self.obj = obj
        report = report_of(obj) if obj is not None and obj.Mesh.CountFacets else None
        if report is None:
            self.hide()
            return
        self.text.setText("\n".join(lines_of(obj, report)))
        self.show()

    def _refresh(self):
        self.show_result(self.obj if self.obj is not None and widgets.alive(self.obj) else None)

    def stop(self):
        self.watch.stop()


def lines_of(obj, report):
    """Returns the lines of text about an envelope."""
    box = obj.Mesh.BoundBox
    sides = " x ".join(quantities.quantity(v) for v in (box.XLength, box.YLength, box.ZLength))
    deviation = report["simplification_deviation"]
    volume = translate("SweptVolume", "Volume: {0}").format(quantities.volume(obj.Volume.Value))
    if obj.Status != UP_TO_DATE:
        volume = translate("SweptVolume", "{0} (stale: run again)").format(volume)
    lines = [
        volume,
        translate("SweptVolume", "Box: {0}").format(sides),
        translate("SweptVolume", "Triangles: {0}, shells: {1}").format(
            quantities.count(obj.Triangles), quantities.count(obj.Shells)
        ),
        translate("SweptVolume", "Cell size: {0}, deviation by simplification: {1}").format(
            quantities.quantity(report["cell"]), quantities.quantity(deviation)
        ),
    ]
    if report.get("accuracy_bound"):
        bound = quantities.quantity(report["accuracy_bound"])
        lines.append(
            translate("SweptVolume", "Distance from the true surface: at most {0}").format(bound)
        )
    lines.append(
        translate("SweptVolume", "Computing time: {0} on the {1}").format(
            quantities.seconds(obj.Seconds), report["backend"].upper()
        )
    )
    if obj.Message and obj.Status in (CANCELLED, FAILED):
        lines.append(translate("SweptVolume", "Last run: {0}").format(obj.Message))
    findings = "\n".join(w["text"] for w in warnings_of(report))
    if findings:
        lines.append(translate("SweptVolume", "Findings: {0}").format(findings))
    return lines
