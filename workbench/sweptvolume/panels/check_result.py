# SPDX-License-Identifier: LGPL-2.1-or-later
"""The result of a check of distances in its panel: table, graph, export."""
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

#: Letters of a neighbour's name that are seen beside a column of depths; more take a second line.
NAME_LETTERS = 18


class ResultPanel(StayingPanel):
    """The half of the panel that shows `obj`, the check, if there is one. `layout`, `message`, `document` are
    the panel's. Subclasses say what a row is (NAME), how its result is written (TABLE, a module), and what is
    done with a row that is chosen."""

    NAME = ""
    TABLE = clearance_table

    def stored_report(self):
        """The stored report of `obj`, None where there is none."""
        raise NotImplementedError

    def rows_of(self, report):
        """The same as clearance_table takes it."""
        return report

    def build_more(self, rows):
        """What stands between graph and export."""

    def shown(self):
        """A result was shown."""

    def show_row(self, index):
        """A row was chosen; None: none is."""

    def standing_rows(self):
        """[((root, sub), row)] of the parts that stand still and are still there."""
        raise NotImplementedError

    def leave(self):
        self.painted.remove()

    def _build_result(self):
        self.one, self.unit = quantities.length_unit()
        self.worst_first, self.painted = [], VerdictColours()
        self.result = QtWidgets.QGroupBox(translate("Panels", "Result"))
        rows = QtWidgets.QVBoxLayout(self.result)
        self.summary = QtWidgets.QLabel()
        self.summary.setWordWrap(True)
        self.summary.setObjectName("SweptVolumeClearanceSummary")
        heads = (
            translate("Panels", self.NAME),
            translate("Panels", "Verdict"),
            self.unit,
            "{}\ns".format(translate("Panels", "Time")),
            "{}\n{}".format(translate("Panels", "Depth"), self.unit),
        )
        self.table = VerdictTable("SweptVolumeClearanceTable", heads)
        self.table.horizontalHeaderItem(2).setToolTip(
            translate(
                "Panels",
                "These distances are measured between the meshes. In the line above, "
                "the possible deviation of the meshes from the parts is subtracted",
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
        self.paint = QtWidgets.QCheckBox(translate("Panels", "Colour the &parts by their verdicts"))
        self.paint.setObjectName("SweptVolumePaint")
        self.paint.setChecked(True)
        self.paint.toggled.connect(lambda *ignored: self.paint_parts())
        rows.addWidget(self.paint)
        self.build_more(rows)
        buttons = QtWidgets.QHBoxLayout()
        self.csv = QtWidgets.QPushButton(translate("Panels", "CSV..."))
        self.sheet = QtWidgets.QPushButton(translate("Panels", "Spreadsheet"))
        self.csv.setObjectName("SweptVolumeCsv")
        self.sheet.setObjectName("SweptVolumeSheet")
        buttons.addWidget(self.csv)
        buttons.addWidget(self.sheet)
        rows.addLayout(buttons)
        self.page = QtWidgets.QPushButton(translate("Panels", "Report..."))
        self.page.setObjectName("SweptVolumeReport")
        rows.addWidget(self.page)
        self.layout.insertWidget(2, self.result)  # above the inputs: seen without scrolling
        # The table's own: gone with it where the panel is closed at once.
        self._fit = QtCore.QTimer(self.table, singleShot=True, interval=0)
        self._fit.timeout.connect(self.table.resizeRowsToContents)
        self.table.itemSelectionChanged.connect(self._row_chosen)
        self.csv.clicked.connect(lambda *ignored: self.export_csv())
        self.sheet.clicked.connect(lambda *ignored: self.export_sheet())
        self.page.clicked.connect(lambda *ignored: self.export_page())

    def _build_worst(self):
        """Buttons that go through the rows, the worst first, whatever the table is sorted by."""
        buttons = QtWidgets.QHBoxLayout()
        self.better, self.worse = (
            widgets.hint(QtWidgets.QPushButton(text), tip)
            for text, tip in (
                (
                    translate("Panels", "Pre&vious place"),
                    translate("Panels", "Goes to the previous place, which is worse than this one"),
                ),
                (
                    translate("Panels", "&Next worst place"),
                    translate(
                        "Panels",
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

    def show_result(self):
        report = self.stored_report() if self.obj is not None else None
        self.result.setVisible(report is not None)
        if report is None:
            return
        self.whole, self.report = report, self.rows_of(report)
        text = self.TABLE.summary(report)
        if self.obj.Status != clearance.UP_TO_DATE:
            text = translate("Panels", "{0} (stale: run the check again)").format(text)
        self.summary.setText("<b>{}</b>".format(text.replace("<", "&lt;")))
        if self.obj.Message:
            widgets.show_message(self.message, self.obj.Message)
        self.worst_first = clearance_table.worst_first(self.report)
        self._fill()
        self._show_place()
        self.graph.show_report(self.report)
        self.paint_parts()
        self.shown()

    @guard.told
    def paint_parts(self):
        """The parts that stand have the colours of their rows, the worst one's where there are several."""
        try:
            rows = self.standing_rows() if self.paint.isChecked() else []
        except InputProblem:  # the inputs lead nowhere now, which the message tells
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
            verdict = translate("Messages", clearance.VERDICTS[row["verdict"]])
            met = clearance_table.meets_rule(row)
            if met and row["verdict"] == "contact":
                verdict = translate("Messages", "Contact, allowed")
            rank = clearance_table.WORST_FIRST.index(clearance_table.judged(row))
            rule = clearance_table.rule_text(row, self.report)
            cells = (
                SortedCell(row["name"], row["name"].lower()),
                SortedCell(verdict, rank),
                SortedCell(self._length(row["distance"]), row["distance"]),
                SortedCell(quantities.number(row["time_seconds"], 4), row["time_seconds"]),
                SortedCell(self._length(deep) if deep else "", -deep),
            )
            cells[1].setToolTip(translate("Panels", "Rule: {0}").format(rule))
            self.table.put(r, cells, r, row)
        clashes = any(row["verdict"] == "clash" for row in self.report["neighbours"])
        self.table.setColumnHidden(4, not clashes)
        # Names keep room where the numbers take it all: then the table is scrolled.
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
        """Index of the row that is chosen, in the report; -1: none."""
        return self.table.chosen()

    def choose(self, index):
        """Chooses a row by its index in the report."""
        self.table.choose(index)

    def go_through(self, by):
        """To the row that is the next worst (1), or back (-1); from none to the worst."""
        place = self._place_among_worst() + by
        if 0 <= place < len(self.worst_first):
            self.choose(self.worst_first[place])

    def _place_among_worst(self):
        """Where the chosen row stands among the worst; -1: none is chosen."""
        row = self.chosen_row()
        return self.worst_first.index(row) if row in self.worst_first else -1

    def _show_place(self):
        place = self._place_among_worst()
        self.better.setEnabled(place > 0)
        self.worse.setEnabled(place + 1 < len(self.worst_first))

    @guard.told
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

    @guard.told
    def export_csv(self):
        path = file_dialogs.ask_table(self.obj.Label)
        if path:
            self.TABLE.write_csv(self.whole, path)

    @guard.told
    def export_sheet(self):
        self.document.openTransaction(translate("Messages", "Clearance table"))
        self.TABLE.make_spreadsheet(self.obj, self.whole)
        self.document.commitTransaction()
        self.document.recompute()

    @guard.told
    def export_page(self):
        if self.run is not None:
            return
        path = file_dialogs.ask_report(self.obj.Label)
        if path:
            self.begin(lambda: PageTask(self.obj, path), self.ended)
