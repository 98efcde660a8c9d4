# SPDX-License-Identifier: LGPL-2.1-or-later
"""Parts that stand still, each with its rule: a table with its buttons."""
from ..convert import InputProblem
from ..features import path_plan
from ..features.neighbour_rules import IGNORE, REQUIRED
from ..texts import translate
from . import selection, widgets
from .rules_table import RulesTable
from .widgets import QtCore, QtWidgets


class NeighboursBox(QtCore.QObject):
    """`moving`: a function that returns the moving parts, which cannot be neighbours."""

    def __init__(self, document, moving, layout):
        super().__init__()
        self.document, self.moving = document, moving
        rows = widgets.group(translate("SweptVolume", "Neighbours"), layout)
        self.table = RulesTable(
            "SweptVolumeNeighbours", translate("SweptVolume", "Distance"), (REQUIRED, IGNORE)
        )
        rows.addRow(self.table)
        line = QtWidgets.QHBoxLayout()
        for name, text, tip, act in (
            (
                "SweptVolumeAddNeighbours",
                translate("SweptVolume", "&Add selected"),
                translate("SweptVolume", "Adds the solids and meshes selected in the tree"),
                self.add_selected,
            ),
            (
                "SweptVolumeRemoveNeighbours",
                translate("SweptVolume", "&Remove"),
                translate("SweptVolume", "Removes the selected parts from the list"),
                self.remove_chosen,
            ),
            (
                "SweptVolumeAllNeighbours",
                translate("SweptVolume", "All &visible"),
                translate("SweptVolume", "Adds all other parts that are visible now"),
                self.take_visible,
            ),
        ):
            button = QtWidgets.QPushButton(text)
            button.setObjectName(name)
            widgets.hint(button, tip)
            button.clicked.connect(lambda checked=False, act=act: act())
            line.addWidget(button)
        rows.addRow(line)

    @property
    def pairs(self):
        """Returns the parts of the table."""
        return self.table.pairs

    def take_visible(self):
        """Adds all visible parts except the moving ones."""
        try:
            found = path_plan.beside(self.document, self.moving()).leaves()
        except InputProblem:  # there is no other part
            found = []
        self._show(found)

    def take(self, pairs):
        """Adds these parts, each solid or mesh by itself. Raises InputProblem."""
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
        """Removes parts that now move, because a moving part is not its own neighbour."""
        moving = self.moving()
        self._show(
            [p for p in self.pairs if not any(p[0] is r and p[1].startswith(s) for r, s in moving)]
        )

    def _show(self, pairs):
        """Shows these parts. Parts that were listed before keep their rules."""
        self.table.show_pairs(pairs)

    def rules(self):
        """Returns {pair: Rule} for the parts with their own rule. Raises InputProblem."""
        return self.table.rules()

    def mark(self, names):
        """Writes the names of these neighbours in bold, because they are obstacles."""
        self.table.mark(names)
