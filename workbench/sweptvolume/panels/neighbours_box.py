# SPDX-License-Identifier: LGPL-2.1-or-later
"""Parts that stand still, each with the clearance that it asks for: a table with its buttons."""
from .. import convert, quantities
from ..convert import InputProblem
from ..features import path_plan
from ..texts import translate
from ..trajectory.edit import number_from
from . import selection, widgets
from .widgets import QtCore, QtGui, QtWidgets


class NeighboursBox(QtCore.QObject):
    """`moving`: a function that gives the parts that move, which are no neighbours."""

    def __init__(self, document, moving, layout):
        super().__init__()
        self.document, self.moving, self.pairs = document, moving, []
        self.one, self.unit = quantities.length_unit()
        rows = widgets.group(translate("Panels", "Neighbours"), layout)
        self.table = QtWidgets.QTableWidget(0, 2)
        self.table.setObjectName("SweptVolumeNeighbours")
        head = "{} ({})".format(translate("Panels", "Clearance"), self.unit)
        self.table.setHorizontalHeaderLabels([translate("Panels", "Neighbour"), head])
        self.table.horizontalHeaderItem(1).setToolTip(
            translate("Panels", "What this one asks for; empty: the common clearance below")
        )
        self.table.setFixedHeight(110)
        self.table.verticalHeader().hide()
        self.table.setTabKeyNavigation(False)
        self.table.setSelectionBehavior(QtWidgets.QAbstractItemView.SelectRows)
        modes = QtWidgets.QHeaderView
        self.table.horizontalHeader().setSectionResizeMode(0, modes.Stretch)
        self.table.horizontalHeader().setSectionResizeMode(1, modes.ResizeToContents)
        rows.addRow(self.table)
        line = QtWidgets.QHBoxLayout()
        for name, text, tip, act in (
            (
                "SweptVolumeAddNeighbours",
                translate("Panels", "&Add selected"),
                translate("Panels", "Adds the solids and meshes selected in the tree"),
                self.add_selected,
            ),
            (
                "SweptVolumeRemoveNeighbours",
                translate("Panels", "&Remove"),
                translate("Panels", "Takes the marked parts out of the list"),
                self.remove_chosen,
            ),
            (
                "SweptVolumeAllNeighbours",
                translate("Panels", "All &visible"),
                translate("Panels", "All other parts that are visible now"),
                self.take_visible,
            ),
        ):
            button = QtWidgets.QPushButton(text)
            button.setObjectName(name)
            widgets.hint(button, tip)
            button.clicked.connect(lambda checked=False, act=act: act())
            line.addWidget(button)
        rows.addRow(line)

    def take_visible(self):
        """All that is visible beside the moving parts."""
        try:
            found = path_plan.beside(self.document, self.moving()).leaves()
        except InputProblem:  # nothing stands there
            found = []
        self._show(found)

    def take(self, pairs):
        """These, each solid or mesh by itself. Raises InputProblem."""
        self._show(path_plan.beside(self.document, self.moving(), pairs).leaves())

    def add_selected(self):
        chosen = [pair for pair in selection.parts() if pair not in self.moving()]
        if chosen:
            found = path_plan.beside(self.document, self.moving(), chosen).leaves()
            self._show(self.pairs + [pair for pair in found if pair not in self.pairs])

    def remove_chosen(self):
        rows = {index.row() for index in self.table.selectedIndexes()}
        self._show([pair for row, pair in enumerate(self.pairs) if row not in rows])
        self.table.setFocus()

    def drop_moving(self):
        """Another part moves now: it is no neighbour of itself."""
        moving = self.moving()
        self._show(
            [p for p in self.pairs if not any(p[0] is r and p[1].startswith(s) for r, s in moving)]
        )

    def _show(self, pairs):
        """Shows these; what was typed for those that stay is kept."""
        typed = {pair: self.table.item(row, 1).text() for row, pair in enumerate(self.pairs)}
        self.pairs = list(pairs)
        self.table.setRowCount(len(pairs))
        for row, pair in enumerate(pairs):
            name = QtWidgets.QTableWidgetItem(convert.label_of(*pair))
            name.setFlags(QtCore.Qt.ItemIsEnabled | QtCore.Qt.ItemIsSelectable)
            name.setToolTip(name.text())
            own = QtWidgets.QTableWidgetItem(typed.get(pair, ""))
            own.setTextAlignment(widgets.number_of(QtCore.Qt.AlignRight | QtCore.Qt.AlignVCenter))
            self.table.setItem(row, 0, name)
            self.table.setItem(row, 1, own)
        self.table.resizeRowsToContents()

    def clearances(self):
        """{pair: mm} of those that ask for one of their own. Raises InputProblem."""
        found = {}
        for row, pair in enumerate(self.pairs):
            text = self.table.item(row, 1).text().strip()
            if not text:
                continue
            value = number_from(text, self.unit) * self.one
            if value < 0:
                self.table.setCurrentCell(row, 1)
                raise InputProblem(
                    translate("Messages", '"{0}": a clearance of {1} is not possible.').format(
                        convert.label_of(*pair), text
                    )
                )
            found[pair] = value
        return found

    def mark(self, names):
        """Writes the names of these neighbours in bold: they are in the way."""
        for row in range(self.table.rowCount()):
            item = self.table.item(row, 0)
            font = QtGui.QFont(self.table.font())
            font.setBold(item.text() in names)
            item.setFont(font)
