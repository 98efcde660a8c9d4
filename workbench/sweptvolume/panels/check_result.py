# SPDX-License-Identifier: LGPL-2.1-or-later
"""The result of a distance check in its panel: table, graph, export."""
from PySide import QtCore

from .. import quantities
from ..convert import InputProblem
from ..features import clearance, clearance_table
from ..texts import translate
from ..views.clearance_view import BANDS
from ..views.verdict_colours import VerdictColours, painted_object
from . import file_dialogs, focus, guard, widgets
from .clearance_graph import DistanceGraph
from .page_task import PageTask
from .run_panel import StayingPanel
from .sorted_cell import SortedCell
from .verdict_table import VerdictTable
from .widgets import QtWidgets

#: Letters of a neighbour's name that fit beside a column of depths. Longer names take a second
#: line.
NAME_LETTERS = 18


class ResultPanel(StayingPanel):
    """The half of the panel that shows the result of the check `obj`, if there is one. The panel
    provides `layout`, `message` and `document`. Subclasses define the word for what a row is about
    (NAME), the module that writes the result (TABLE), and what happens when a row is chosen."""

    NAME = ""
    TABLE = clearance_table

    def stored_report(self):
        """Returns the stored report of `obj`, or None if there is none."""
        raise NotImplementedError

    def rows_of(self, report):
        """Returns the rows of the report, with the keys that clearance_table reads."""
        return report

    def build_more(self, rows):
        """Adds widgets between graph and export."""

    def shown(self):
        """Called after a result was shown."""

    def show_row(self, index):
        """Called when a row was chosen; None: no row."""

    def standing_rows(self):
        """Returns [((root, sub), row)] for the parts that stand still and still exist."""
        raise NotImplementedError

    def leave(self):
        self.painted.remove()

    def _build_result(self):
        self.one, self.unit = quantities.length_unit()
        self.worst_first, self.painted = [], VerdictColours()
        self.result = QtWidgets.QGroupBox(translate("SweptVolume", "Result"))
        rows = QtWidgets.QVBoxLayout(self.result)
        self.summary = QtWidgets.QLabel()
        self.summary.setWordWrap(True)
        self.summary.setObjectName("SweptVolumeClearanceSummary")
        heads = (
            translate("SweptVolume", self.NAME),
            translate("SweptVolume", "Verdict"),
            "{}\n{}".format(translate("SweptVolume", "Distance"), self.unit),
            "{}\ns".format(translate("SweptVolume", "Time")),
            "{}\n{}".format(translate("SweptVolume", "Depth"), self.unit),
        )
        self.table = VerdictTable("SweptVolumeClearanceTable", heads)
        self.table.horizontalHeaderItem(2).setToolTip(
            translate(
                "SweptVolume",
                "These distances are measured between the meshes. From the distance in the line "
                "above, the possible deviation of the meshes from the parts has already been "
                "subtracted",
            )
        )
        font = self.table.font()
        font.setPointSizeF(font.pointSizeF() * 0.9)
        self.table.setFont(font)
        self.table.horizontalHeader().setFont(font)
        self.table.setSortingEnabled(True)
        self.keys = focus.SortKeys(self.table)
        self.graph = DistanceGraph()
        self.graph.picked.connect(self.choose)
        rows.addWidget(self.summary)
        rows.addWidget(self.table)
        rows.addLayout(self._build_worst())
        rows.addWidget(self.graph)
        self.paint = QtWidgets.QCheckBox(
            translate("SweptVolume", "Colour the &parts by their verdicts")
        )
        self.paint.setObjectName("SweptVolumePaint")
        self.paint.setChecked(True)
        self.paint.toggled.connect(lambda *ignored: self.paint_parts())
        rows.addWidget(self.paint)
        self.build_more(rows)
        buttons = QtWidgets.QHBoxLayout()
        self.csv = QtWidgets.QPushButton(translate("SweptVolume", "CSV..."))
        self.sheet = QtWidgets.QPushButton(translate("SweptVolume", "Spreadsheet"))
        self.csv.setObjectName("SweptVolumeCsv")
        self.sheet.setObjectName("SweptVolumeSheet")
        buttons.addWidget(self.csv)
        buttons.addWidget(self.sheet)
        rows.addLayout(buttons)
        self.page = QtWidgets.QPushButton(translate("SweptVolume", "Report..."))
        self.page.setObjectName("SweptVolumeReport")
        rows.addWidget(self.page)
        self.layout.insertWidget(2, self.result)  # above the inputs, visible without scrolling
        # A child of the table, so that it disappears with the table if the panel is closed at once.
        self._fit = QtCore.QTimer(self.table, singleShot=True, interval=0)
        self._fit.timeout.connect(self.table.resizeRowsToContents)
        self.table.itemSelectionChanged.connect(self._row_chosen)
        self.csv.clicked.connect(lambda *ignored: self.export_csv())
        self.sheet.clicked.connect(lambda *ignored: self.export_sheet())
        self.page.clicked.connect(lambda *ignored: self.export_page())

    def _build_worst(self):
        """Builds buttons that go through the rows, the worst first, independent of the table's
        order."""
        buttons = QtWidgets.QHBoxLayout()
        self.better, self.worse = (
            widgets.hint(QtWidgets.QPushButton(text), tip)
            for text, tip in (
                (
                    translate("SweptVolume", "Pre&vious place"),
                    translate(
                        "SweptVolume",
                        "Goes back to the previous place, where the clash is deeper or "
                        "the distance is smaller than at the current place",
                    ),
                ),
                (
                    translate("SweptVolume", "&Next worst place"),
                    translate(
                        "SweptVolume",
                        "Goes to the next place. Clashes come first, beginning with the deepest, "
                        "then all other places, beginning with the closest",
                    ),
                ),
            )
        )
        self.better.setObjectName("SweptVolumePlaceBefore")
        self.worse.setObjectName("SweptVolumeNextWorst")
        self.better.clicked.connect(lambda *ignored: self.go_through(-1))
        self.worse.clicked.connect(lambda *ignored: self.go_through(1))
        buttons.addWidget(self.better)
        buttons.addWidget(self.worse)
        return buttons

    def lost(self):
        self.painted.remove()

    def show_result(self):
        report = self.stored_report() if self.obj is not None else None
        self.note_state()
        self.result.setVisible(report is not None)
        if report is None:
            return
        self.table.clearSelection()  # the order of the rows may have changed
        self.whole, self.report = report, self.rows_of(report)
        text = self.TABLE.summary(report)
        if self.obj.Status != clearance.UP_TO_DATE:
            text = translate("SweptVolume", "{0} (stale: run the check again)").format(text)
        self.summary.setText("<b>{}</b>".format(text.replace("<", "&lt;")))
        if self.obj.Message:
            widgets.show_message(self.message, self.obj.Message)
        self.worst_first = clearance_table.worst_first(self.report)
        self._fill()
        self._show_place()
        self.graph.show_report(self.report)
        self.paint_parts()
        self.shown()

    @guard.shows_problems
    def paint_parts(self):
        """Colours the parts that stand still by the verdicts of their rows. A part with several
        rows gets the worst one."""
        try:
            rows = self.standing_rows() if self.paint.isChecked() else []
        except InputProblem:  # the message shows the problem of the inputs
            rows = []
        ranks = {}
        for pair, row in rows:
            found = painted_object(*pair)
            rank = clearance_table.WORST_FIRST.index(clearance_table.judged(row))
            ranks[found] = min(rank, ranks.get(found, rank))
        self.painted.show({obj: BANDS[rank] for obj, rank in ranks.items()})

    def _length(self, value):
        return quantities.number(round(value, 9) / self.one, quantities.TABLE_DIGITS)

    def _fill(self):
        self.table.setSortingEnabled(False)
        self.table.setRowCount(len(self.report["neighbours"]))
        for r, row in enumerate(self.report["neighbours"]):
            deep = row.get("penetration", {}).get("depth", 0.0)
            verdict = translate("SweptVolume", clearance.VERDICTS[row["verdict"]])
            met = clearance_table.meets_rule(row)
            if met and row["verdict"] == "contact":
                verdict = translate("SweptVolume", "Allowed contact")
            rank = clearance_table.WORST_FIRST.index(clearance_table.judged(row))
            rule = clearance_table.rule_text(row, self.report)
            cells = (
                SortedCell(row["name"], row["name"].lower()),
                SortedCell(verdict, rank),
                SortedCell(self._length(row["distance"]), row["distance"]),
                SortedCell(quantities.number(row["time_seconds"], 4), row["time_seconds"]),
                SortedCell(self._length(deep) if deep else "", -deep),
            )
            cells[1].setToolTip(translate("SweptVolume", "Rule: {0}").format(rule))
            self.table.put(r, cells, r, row)
        clashes = any(row["verdict"] == "clash" for row in self.report["neighbours"])
        self.table.setColumnHidden(4, not clashes)
        # Names keep a minimum width; if the numbers need more room, the table can be scrolled.
        modes = QtWidgets.QHeaderView
        self.table.horizontalHeader().setSectionResizeMode(
            0, modes.Interactive if clashes else modes.Stretch
        )
        self.table.setColumnWidth(0, self.table.fontMetrics().averageCharWidth() * NAME_LETTERS)
        self.table.setSortingEnabled(True)
        self.table.sortItems(2)
        self._fit.start()

    # --- choosing rows

    def chosen_row(self):
        """Returns the index, in the report, of the chosen row, or -1."""
        return self.table.chosen()

    def choose(self, index):
        """Chooses a row by its index in the report."""
        self.table.choose(index)

    def go_through(self, by):
        """Chooses the next row (1) or the previous row (-1) in the order from worst to best.
        Without a chosen row, chooses the worst."""
        place = self._place_among_worst() + by
        if 0 <= place < len(self.worst_first):
            self.choose(self.worst_first[place])

    def _place_among_worst(self):
        """Returns the position of the chosen row in the order from worst to best, or -1."""
        row = self.chosen_row()
        return self.worst_first.index(row) if row in self.worst_first else -1

    def _show_place(self):
        place = self._place_among_worst()
        self.better.setEnabled(place > 0)
        self.worse.setEnabled(place + 1 < len(self.worst_first))

    @guard.shows_problems
    def _row_chosen(self):
        index = self.chosen_row()
        self._show_place()
        if index < 0:
            self.graph.choose(-1, None)
            if self.obj is not None:
                self.show_row(None)
            return
        self.graph.choose(index, self.report["neighbours"][index]["time_seconds"])
        self.show_row(index)

    @guard.shows_problems
    def export_csv(self):
        path = file_dialogs.ask_table(self.obj.Label)
        if path:
            self.TABLE.write_csv(self.whole, path)

    @guard.shows_problems
    def export_sheet(self):
        self.document.openTransaction(translate("SweptVolume", "Clearance table"))
        self.TABLE.make_spreadsheet(self.obj, self.whole)
        self.document.commitTransaction()
        self.document.recompute()

    @guard.shows_problems
    def export_page(self):
        if self.run is not None:
            return
        path = file_dialogs.ask_report(self.obj.Label)
        if path:
            self.begin(lambda: PageTask(self.obj, path), self.ended)
