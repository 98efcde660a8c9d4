# SPDX-License-Identifier: LGPL-2.1-or-later
"""Task panel "Reserved spaces": compares all pairs of envelopes, solids and parts that stand still.
A row shows what its two objects share. The document changes only if the user keeps a shared
volume."""
import FreeCADGui as Gui
from PySide import QtCore

from .. import quantities
from ..convert import label_of
from ..features import clearance, clearance_table, shared
from ..features.overlap_plan import Plan
from ..texts import translate
from ..views.clearance_view import zoom_to_box
from ..views.live_distance import LiveDistance
from ..views.shared_view import SharedBody
from . import focus, guard, selection, widgets
from .played_result import gone
from .run_panel import StayingPanel
from .tasks import OverlapTask, SharedTask
from .verdict_table import VerdictTable
from .widgets import QtWidgets

DEFAULTS = {"RequiredDistance": 0.0, "MeshDeflection": 0.05}


class OverlapPanel(StayingPanel):
    """Compares the chosen objects."""

    def __init__(self, document, pairs=()):
        self.document, self.run, self.pairs = document, None, list(pairs)
        self.report, self.drawn, self.plan, self.names = None, [], None, []
        self.body, self.line = None, None
        title = translate("SweptVolume", "Reserved spaces")
        self.form, self.layout = widgets.window(title, "SweptVolume_Overlap")
        self.box, self.message = widgets.RunBox(), widgets.message_label()
        self.layout.addWidget(self.box)
        self.layout.addWidget(self.message)
        self._build_inputs()
        self._build_result()
        self.layout.addStretch(1)
        self._show_chosen()
        self.watch = self.watched()

    # --- building

    def _build_inputs(self):
        rows = widgets.group(translate("SweptVolume", "Check"), self.layout)
        self.chosen = QtWidgets.QLabel()
        self.chosen.setWordWrap(True)
        self.chosen.setObjectName("SweptVolumeSpaces")
        self.take = QtWidgets.QPushButton(translate("SweptVolume", "Ta&ke selected"))
        self.take.setObjectName("SweptVolumeTakeSpaces")
        self.required = widgets.hint(
            widgets.length(DEFAULTS["RequiredDistance"], 0.0, 0.5),
            translate(
                "SweptVolume",
                "Distance that the objects must keep from each other. 0: they may lie close "
                "together, but must not touch",
            ),
        )
        self.required.setObjectName("SweptVolumeSpacesRequired")
        self.deflection = widgets.length(DEFAULTS["MeshDeflection"], 1e-4, 0.01)
        self.deflection.setObjectName("SweptVolumeSpacesDeflection")
        self.check = QtWidgets.QPushButton(translate("SweptVolume", "Check"))
        self.check.setObjectName("SweptVolumeCheckSpaces")
        self.check.setDefault(True)  # Enter presses this button
        for widget in (self.chosen, self.take):
            rows.addRow(widget)
        rows.addRow(translate("SweptVolume", "Required distance"), self.required)
        rows.addRow(translate("SweptVolume", "Mesh deflection"), self.deflection)
        rows.addRow(self.check)
        self.take.clicked.connect(lambda *ignored: self._take())
        for field in (self.required, self.deflection):
            field.valueChanged.connect(lambda *ignored: self._refresh())
        self.check.clicked.connect(lambda *ignored: self.start())

    def _build_result(self):
        self.result = QtWidgets.QGroupBox(translate("SweptVolume", "Result"))
        rows = QtWidgets.QVBoxLayout(self.result)
        self.summary = QtWidgets.QLabel()
        self.summary.setWordWrap(True)
        self.summary.setObjectName("SweptVolumeSpacesSummary")
        self.unit = quantities.length_unit()[1]
        heads = (
            translate("SweptVolume", "Pair"),
            translate("SweptVolume", "Verdict"),
            "{}\n{}".format(translate("SweptVolume", "Distance"), self.unit),
            "{}\n{}^3".format(translate("SweptVolume", "Volume"), self.unit),
        )
        self.table = VerdictTable("SweptVolumeSpacesTable", heads)
        self.table.horizontalHeaderItem(3).setToolTip(
            translate("SweptVolume", "Volume that the two objects share")
        )
        self.keep = widgets.hint(
            QtWidgets.QPushButton(translate("SweptVolume", "Keep s&hared volume")),
            translate(
                "SweptVolume",
                "Adds the shared volume of the two objects to the document. If one of them "
                "changes later, the icon of the shared volume gets a clock: it is out of date",
            ),
        )
        self.keep.setObjectName("SweptVolumeKeepShared")
        for widget in (self.summary, self.table, self.keep):
            rows.addWidget(widget)
        self.table.itemSelectionChanged.connect(self._row_chosen)
        self.table.itemDoubleClicked.connect(lambda *ignored: self._zoom_to_row())
        self.keep.clicked.connect(lambda *ignored: self.keep_shared())
        self.layout.addWidget(self.result)
        self.result.hide()

    # --- inputs

    @guard.shows_problems
    def _take(self):
        self.pairs = selection.spaces()
        self._show_chosen()
        self._refresh()

    def _show_chosen(self):
        names = [label_of(*pair) for pair in self.pairs]
        text = translate("SweptVolume", "{0} chosen: {1}")
        self.chosen.setText(text.format(len(names), ", ".join(names) or "-"))

    def new_plan(self):
        required = float(self.required.property("rawValue"))
        deflection = float(self.deflection.property("rawValue"))
        return Plan(self.document, self.pairs, required, deflection)

    # --- run

    def start(self):
        if self.begin(
            lambda: OverlapTask(self.new_plan()),
            self.ended,
            lambda: self.new_plan().words(),
            self.start,
        ):
            self._enable(False)

    @guard.shows_problems
    def keep_shared(self):
        """Creates an object from the shared volume of the chosen pair."""
        row = self.chosen_row()
        if row < 0:
            return
        sides = [[pair] for pair in self.two_of(row)]
        plan = shared.Plan(self.document, *sides, deflection=self.plan.deflection)
        if self.begin(lambda: SharedTask(self.document, plan), self.ended):
            self._enable(False)

    def _enable(self, on):
        self.check.setEnabled(on)
        self.keep.setEnabled(on and self._can_keep())

    def ended(self, run):
        self.run = None
        if not widgets.alive(self.document):
            return
        if run.state != "ok":
            self.box.leave(self.form)
            widgets.show_failure(self.message, run)
        elif isinstance(run.task, OverlapTask):
            self.box.leave(self.table)
            self.plan, (self.report, self.drawn) = run.task.plan, run.task.found
            self.names = [name for name, _, _ in run.task.request.parts]
            self.show_result()
        else:
            self.box.leave(self.table)
            self._clear_view()  # the new object shows the volume now
        self._enable(True)

    # --- result

    def two_of(self, row):
        """Returns (root, sub) of both parts of a row. Raises InputProblem."""
        pair = self.report["pairs"][row]
        numbers = [self.names.index(pair[side]) for side in ("first", "second")]
        found = [self.plan.pairs[number] for number in numbers]
        if not all(widgets.alive(root) for root, _ in found):
            raise gone()
        return found

    @guard.shows_problems
    def _refresh(self):
        if self.run is None and self.plan is not None:
            self._show_summary()

    def _is_outdated(self):
        """Returns whether objects or settings have changed since the result that is shown."""
        now = self.new_plan()
        known, wanted = ((plan.pairs, plan.required, plan.deflection) for plan in (self.plan, now))
        return known != wanted or now.state() != self.plan.known

    def show_result(self):
        pairs = self.report["pairs"]
        self._clear_view()
        self.result.show()
        self._show_summary()
        warnings = [w["text"] for w in self.report["warnings"]]
        widgets.show_message(self.message, "\n".join(warnings))
        rows = [pair["clearance"] for pair in pairs]
        order = clearance_table.worst_first(dict(self.report, neighbours=rows))
        self.table.setRowCount(len(pairs))
        for r, index in enumerate(order):
            self.table.put(r, self._cells(pairs[index]), index, rows[index])
        self.table.clearSelection()
        QtCore.QTimer.singleShot(0, self.table.resizeRowsToContents)

    def _show_summary(self):
        text = self._summary()
        if self._is_outdated():
            text = translate("SweptVolume", "{0} (stale: run the check again)").format(text)
        self.summary.setText("<b>{}</b>".format(text.replace("<", "&lt;")))

    def _summary(self):
        count = len(self.report["pairs"])
        total = sum(pair.get("volume", 0.0) for pair in self.report["pairs"])
        if total > 0:
            text = translate("SweptVolume", "Pairs checked: {0}, shared volume: {1}")
            return text.format(count, quantities.volume(total))
        least = min(pair["clearance"]["distance"] for pair in self.report["pairs"])
        text = translate(
            "SweptVolume", "Pairs checked: {0}, none shares volume, smallest distance: {1}"
        )
        return text.format(count, quantities.quantity(least, quantities.TABLE_DIGITS))

    def _cells(self, pair):
        row, one = pair["clearance"], quantities.length_unit()[0]
        return [
            QtWidgets.QTableWidgetItem(text)
            for text in (
                "{} - {}".format(pair["first"], pair["second"]),
                translate("SweptVolume", clearance.VERDICTS[row["verdict"]]),
                quantities.number(round(row["distance"], 9) / one, quantities.TABLE_DIGITS),
                self._volume(pair, one),
            )
        ]

    def _volume(self, pair, one):
        if "volume" not in pair:
            return translate("SweptVolume", "not known")
        if not pair["volume"]:
            return ""
        return quantities.number(pair["volume"] / one**3, quantities.TABLE_DIGITS)

    def chosen_row(self):
        """Returns the index, in the report, of the chosen pair, or -1."""
        return self.table.chosen()

    def _can_keep(self):
        row = self.chosen_row()
        return row >= 0 and self.report["pairs"][row].get("volume", 0.0) > 0

    @guard.shows_problems
    def _row_chosen(self):
        row = self.chosen_row()
        self.keep.setEnabled(self._can_keep() and self.run is None)
        if row < 0:
            return
        if self.body is None:
            self.body, self.line = SharedBody(self.document), LiveDistance(self.document)
        self.body.show(self.drawn[row])
        found = self.report["pairs"][row]["clearance"]
        self.line.show_between(*clearance_table.line_of(found))

    @guard.shows_problems
    def _zoom_to_row(self):
        """Moves the camera to the shared volume of the row, or to its nearest points."""
        row = self.chosen_row()
        if row < 0:
            return
        found, drawn = self.report["pairs"][row]["clearance"], self.drawn[row]
        ends = [found["point_on_body"], found["point_on_neighbour"]]
        zoom_to_box(drawn[0] if drawn is not None else ends)

    def _clear_view(self):
        if widgets.alive(self.document):
            for drawn in (self.body, self.line):
                if drawn is not None:
                    drawn.remove()
        self.body, self.line = None, None

    def leave(self):
        self._clear_view()


def show(document, pairs=()):
    panel = OverlapPanel(document, pairs)
    Gui.Selection.clearSelection()
    focus.show(panel)
    return panel
