# SPDX-License-Identifier: LGPL-2.1-or-later
"""The result of a clearance check in its panel: the moving part at a row's time, and the coloured
envelope."""
from .. import convert
from ..convert import InputProblem
from ..features import clearance, clearance_table, shared
from ..texts import QT_TRANSLATE_NOOP, translate
from ..views.clearance_view import BANDS
from . import guard, played_result, widgets
from .played_result import RowScene, gone
from .widgets import QtWidgets


class ResultPanel(played_result.PlayedPanel):
    """`hidden`: the envelope that is hidden while its coloured copy is shown."""

    NAME = QT_TRANSLATE_NOOP("SweptVolume", "Neighbour")

    def stored_report(self):
        return clearance.report_of(self.obj)

    def build_more(self, rows):
        self.build_played(rows)
        self.cut_away = widgets.hint(
            QtWidgets.QPushButton(translate("SweptVolume", "Keep volume to cut awa&y")),
            translate(
                "SweptVolume",
                "Creates an object from the volume that the envelope shares with the part of the "
                "chosen row",
            ),
        )
        self.cut_away.setObjectName("SweptVolumeKeepCut")
        self.cut_away.clicked.connect(lambda *ignored: self.keep(self.cut_plan))
        rows.addWidget(self.cut_away)
        rows.addLayout(self._bands())

    def shown(self):
        self.clear_view()
        self.show_buttons(None)
        curve = [time for row in self.report["neighbours"] for time, _ in row["curve"]]
        times = {row["time_seconds"] for row in self.report["neighbours"]}
        self.set_span(times | ({min(curve), max(curve)} if curve else set()))
        self.coloured.setEnabled(bool(self.obj.MapDistances))
        self._paint()

    def show_row(self, index):
        self.show_buttons(index)
        for drawn in (self.line, self.ghosts):
            if drawn is not None:
                drawn.hide()
        if index is None:
            self._view().hide_row()
            return
        row = self.report["neighbours"][index]
        self.go_to(row["time_seconds"])
        self._view().show_row(self.obj, index)
        self.ends = clearance_table.line_of(row)[0]
        self._cut_again()

    def left_row(self):
        self._view().hide_row()

    def show_buttons(self, index):
        super().show_buttons(index)
        self.cut_away.setEnabled(self.clash.isEnabled() and self.obj.Envelope is not None)

    # --- the two parts of a row

    def plan_shown(self):
        return clearance.Plan.of(self.obj)

    def _neighbour(self, plan, index):
        """Returns (root, sub) of the neighbour of a row, or None if it does not exist any more."""
        names = [row["name"] for row in self.report["neighbours"]]
        return plan.pairs_named(names)[index]

    def row_scene(self, index):
        plan = clearance.Plan.of(self.obj)
        pair = self._neighbour(plan, index)
        if pair is None:
            raise gone()
        deflection = plan.seen_deflection()
        ((body, course),) = plan.seen()
        beside = convert.body_from([pair], deflection)
        return RowScene(body, beside, (course, None), deflection)

    def clash_plan(self, index):
        plan, time = clearance.Plan.of(self.obj), self.report["neighbours"][index]["time_seconds"]
        if plan.moving().reference is not None:
            text = translate(
                "SweptVolume",
                "The envelope was computed relative to a moving part, so its clash "
                "volume has no fixed position in the document: run the check without "
                "a reference part.",
            )
            raise InputProblem(text)
        sides = plan.pairs, [self._neighbour(plan, index)]
        return self._shared(plan, sides, (plan.motion, None), time)

    def cut_plan(self, index):
        """Returns the shared.Plan for the volume that the envelope shares with the part of a
        row."""
        plan = clearance.Plan.of(self.obj)
        sides = [convert.root_path(self.obj.Envelope)], [self._neighbour(plan, index)]
        return self._shared(plan, sides, (None, None), 0.0)

    def _shared(self, plan, sides, motions, time):
        if None in sides[1]:
            raise gone()
        return shared.Plan(self.document, *sides, motions, time, plan.values["MeshDeflection"])

    def _view(self):
        return self.obj.ViewObject.Proxy

    def _bands(self):
        """Builds the legend of the colour map. The user can change the limits."""
        self.coloured = QtWidgets.QCheckBox(
            translate("SweptVolume", "Colour the envelope by distance")
        )
        self.coloured.setObjectName("SweptVolumeColours")
        self.contact_band = widgets.length(0.1, 0.0, 0.1)
        self.required_band = widgets.length(5.0, 0.0, 0.5)
        self.contact_band.setObjectName("SweptVolumeContactBand")
        self.required_band.setObjectName("SweptVolumeRequiredBand")
        grid = QtWidgets.QGridLayout()
        grid.addWidget(self.coloured, 0, 0, 1, 3)
        texts = (
            translate("SweptVolume", "clash: inside"),
            translate("SweptVolume", "contact: up to"),
            translate("SweptVolume", "below required: up to"),
            translate("SweptVolume", "clear: beyond"),
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

    @guard.shows_problems
    def _paint(self):
        if self.obj is None:
            return
        envelope = self.obj.Envelope
        if not self.coloured.isChecked():
            self._view().hide_colours()
            self._show_hidden()
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
            text = translate(
                "SweptVolume", "The envelope has changed since the check: run the check again."
            )
            widgets.show_message(self.message, text)

    def _show_hidden(self):
        if self.hidden is not None and widgets.alive(self.hidden):
            self.hidden.ViewObject.Visibility = True
        self.hidden = None

    def lost(self):
        super().lost()
        self._show_hidden()

    def standing_rows(self):
        rows = self.report["neighbours"]
        pairs = clearance.Plan.of(self.obj).pairs_named([row["name"] for row in rows])
        return [(pair, row) for pair, row in zip(pairs, rows) if pair is not None]

    def leave(self):
        super().leave()
        if self.obj is not None and widgets.alive(self.obj):
            self.coloured.setChecked(False)
            self._view().clear()
