# SPDX-License-Identifier: LGPL-2.1-or-later
"""The result of a clearance check in its panel: the moving part of a row, and the envelope in colours."""
from ..features import clearance
from ..texts import mark, translate
from ..views.clearance_view import BANDS
from . import check_result, file_dialogs, guard, widgets
from .page_task import PageTask
from .widgets import QtWidgets


class ResultPanel(check_result.ResultPanel):
    """`hidden`: the envelope under its colours."""

    NAME = mark("Panels", "Neighbour")

    def stored_report(self):
        return clearance.report_of(self.obj)

    def build_more(self, rows):
        rows.addLayout(self._bands())

    def shown(self):
        self.coloured.setEnabled(bool(self.obj.MapDistances))
        self._paint()

    def show_row(self, index):
        if index is None:
            self._view().hide_row()
        else:
            self._view().show_row(self.obj, index)

    def _view(self):
        return self.obj.ViewObject.Proxy

    def _bands(self):
        """The legend of the colour map; its borders can be changed."""
        self.coloured = QtWidgets.QCheckBox(translate("Panels", "Colour the envelope by distance"))
        self.coloured.setObjectName("SweptVolumeColours")
        self.contact_band = widgets.length(0.1, 0.0, 0.1)
        self.required_band = widgets.length(5.0, 0.0, 0.5)
        self.contact_band.setObjectName("SweptVolumeContactBand")
        self.required_band.setObjectName("SweptVolumeRequiredBand")
        grid = QtWidgets.QGridLayout()
        grid.addWidget(self.coloured, 0, 0, 1, 3)
        texts = (
            translate("Panels", "clash: inside"),
            translate("Panels", "contact: up to"),
            translate("Panels", "too near: up to"),
            translate("Panels", "clear: beyond"),
        )
        fields = (None, self.contact_band, self.required_band, None)
        for k, (text, colour, field) in enumerate(zip(texts, BANDS, fields)):
            patch = QtWidgets.QLabel()
            patch.setFixedSize(22, 14)
            style = "background: rgb({}, {}, {}); border: 1px solid #555;"
            patch.setStyleSheet(style.format(*(int(255 * c) for c in colour)))
            grid.addWidget(patch, k + 1, 0)
            grid.addWidget(QtWidgets.QLabel(text), k + 1, 1)
            if field is not None:
                grid.addWidget(field, k + 1, 2)
                field.valueChanged.connect(lambda *ignored: self._paint())
        grid.setColumnStretch(2, 1)
        self.coloured.toggled.connect(lambda *ignored: self._paint())
        return grid

    @guard.told
    def _paint(self):
        if self.obj is None:
            return
        envelope = self.obj.Envelope
        if not self.coloured.isChecked():
            self._view().hide_colours()
            if self.hidden is not None and widgets.alive(self.hidden):
                self.hidden.ViewObject.Visibility = True
            self.hidden = None
            return
        shown = self._view().show_colours(
            self.obj,
            float(self.contact_band.property("rawValue")),
            float(self.required_band.property("rawValue")),
        )
        if shown:
            if envelope.ViewObject.Visibility:
                self.hidden = envelope
            envelope.ViewObject.Visibility = False
        else:
            text = translate("Panels", "The envelope has changed since the check: check again.")
            widgets.show_message(self.message, text)

    def build_export(self, rows):
        self.page = QtWidgets.QPushButton(translate("Panels", "Report..."))
        self.page.setObjectName("SweptVolumeReport")
        self.page.clicked.connect(lambda *ignored: self.export_page())
        rows.addWidget(self.page)

    @guard.told
    def export_page(self):
        if self.run is not None:
            return
        path = file_dialogs.ask_report(self.obj.Label)
        if path:
            self.begin(lambda: PageTask(self.obj, path), self.ended)

    def standing_rows(self):
        rows = self.report["neighbours"]
        pairs = clearance.Plan.of(self.obj).pairs_named([row["name"] for row in rows])
        return [(pair, row) for pair, row in zip(pairs, rows) if pair is not None]

    def leave(self):
        super().leave()
        if self.obj is not None and widgets.alive(self.obj):
            self.coloured.setChecked(False)
            self._view().clear()
