# SPDX-License-Identifier: LGPL-2.1-or-later
"""Task panel: improves a motion. The result is a new motion; the given one does not change."""
from PySide import QtCore

from ..features.improve_plan import ImprovePlan
from ..quantities import TABLE_DIGITS, number
from ..texts import QT_TRANSLATE_NOOP, translate
from . import focus, path_texts, widgets
from .path_tasks import ImproveTask
from .search_panel import SearchPanel
from .widgets import QtWidgets


class ImprovePanel(SearchPanel):
    """motion: the motion to improve."""

    TITLE, ICON = QT_TRANSLATE_NOOP("SweptVolume", "Improve path"), "SweptVolume_ImprovePath"
    BUTTON = QT_TRANSLATE_NOOP("SweptVolume", "&Improve path")

    def __init__(self, document, motion, pairs, neighbours=()):
        self.motion, self.measured = motion, False
        super().__init__(document, pairs)
        if neighbours:
            self.take_neighbours(neighbours)

    def build_task(self):
        rows = widgets.group(translate("SweptVolume", "Motion"), self.layout)
        rows.addRow(translate("SweptVolume", "Motion"), QtWidgets.QLabel(self.motion.Label))
        rows.addRow(translate("SweptVolume", "Part"), QtWidgets.QLabel(self.part_text()))
        self.keys = QtWidgets.QListWidget()
        self.keys.setObjectName("SweptVolumeLockedKeys")
        self.keys.setFixedHeight(96)
        widgets.hint(
            self.keys, translate("SweptVolume", "Tick a key to keep its placement and its time")
        )
        text = translate("SweptVolume", "Key {0}, {1} s")
        last = len(self.motion.Times) - 1
        for k, time in enumerate(self.motion.Times):
            item = QtWidgets.QListWidgetItem(text.format(k + 1, number(time, TABLE_DIGITS)))
            free = QtCore.Qt.ItemIsEnabled | QtCore.Qt.ItemIsSelectable
            end = k in (0, last)  # the ends never change
            item.setFlags(free if end else free | QtCore.Qt.ItemIsUserCheckable)
            item.setCheckState(QtCore.Qt.Checked if end else QtCore.Qt.Unchecked)
            self.keys.addItem(item)
        rows.addRow(translate("SweptVolume", "Locked"), self.keys)

    def build_rules(self, rows):
        self.more = widgets.hint(
            QtWidgets.QCheckBox(translate("SweptVolume", "Maximise clearance")),
            translate(
                "SweptVolume",
                "Increases the clearance, even if the path becomes longer. Otherwise "
                "the path becomes as short as the required distance allows",
            ),
        )
        self.more.setObjectName("SweptVolumeMoreClearance")
        rows.addRow(self.more)

    def locked(self):
        """Returns the indices of the locked keys."""
        items = [self.keys.item(k) for k in range(self.keys.count())]
        return [k for k, item in enumerate(items) if item.checkState() == QtCore.Qt.Checked]

    def task(self):
        return ImproveTask(
            ImprovePlan(
                self.motion,
                self.pairs,
                self.beside.pairs,
                locked=self.locked(),
                more=self.more.isChecked(),
                rules=self.beside.rules(),
                **self.rules(),
            )
        )

    def ended(self, run):
        """Lists the given motion first in the table, for comparison."""
        if run.state == "ok" and not self.measured and run.task.obj is not None:
            self.measured = True
            self.paths.add(self.motion, run.task.outcome.report["before"])
        super().ended(run)

    def found(self, task):
        widgets.show_message(self.message, path_texts.improved(task.outcome.report))


def show(document, **given):
    panel = ImprovePanel(document, **given)
    focus.show(panel)
    return panel
