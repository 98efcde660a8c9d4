# SPDX-License-Identifier: LGPL-2.1-or-later
"""A table of moving parts, each with a combo box for its motion."""
from PySide import QtCore

from ..features import motion
from ..features.base import objects_of_kind
from ..texts import translate
from . import widgets
from .widgets import QtWidgets

#: If there are more rows, their heights are not measured.
MOST_MEASURED = 200
#: Number of combo boxes that are created before the window handles events. It exceeds the number of
#: boxes that are visible at first.
BOXES_AT_ONCE = 6


class MotionTable(QtCore.QObject):
    """Base of the boxes with such a table. The signal `changed` is emitted when parts or motions
    were changed. pairs: (root, sub) of each part. motions: the motion of each part, or None.
    Subclasses set `add`, the button after the table in the order of the Tab key."""

    changed = QtCore.Signal()

    def __init__(self, document, pairs, motions):
        super().__init__()
        self.document, self.pairs = document, list(pairs)
        self.motions = list(motions) + [None] * (len(self.pairs) - len(motions))

    def build_table(self, name, head, height):
        """Builds the table. head: title of the column of motions."""
        self.table = QtWidgets.QTableWidget(0, 2)
        self.table.setObjectName(name)
        self.table.setHorizontalHeaderLabels([translate("SweptVolume", "Part"), head])
        self.table.setFixedHeight(height)
        self.table.verticalHeader().hide()
        self.table.setTabKeyNavigation(False)
        self.table.setSelectionBehavior(QtWidgets.QAbstractItemView.SelectRows)
        self.table.setEditTriggers(QtWidgets.QAbstractItemView.NoEditTriggers)
        self.table.horizontalHeader().setSectionResizeMode(QtWidgets.QHeaderView.Stretch)
        return self.table

    def known(self):
        """Returns the motions of the document."""
        return objects_of_kind(self.document, motion.Motion.KIND)

    def fill(self, texts, name, empty):
        """Fills the table. texts: labels of the parts; name: name of the combo boxes, followed by a
        number; empty: text for no motion."""
        known = self.known()
        names, labels = [""] + [m.Name for m in known], [empty] + [m.Label for m in known]
        self.table.setRowCount(len(self.pairs))
        for row, text in enumerate(texts):
            item = QtWidgets.QTableWidgetItem(text)
            item.setToolTip(text)
            self.table.setItem(row, 0, item)
            self.table.removeCellWidget(row, 1)
        self._filling = self._boxes(name, names, labels)
        self._fill_on(self._filling)
        self.changed.emit()

    def _fill_on(self, filling):
        """Creates the next combo boxes of the table. The others follow between events of the
        window."""
        if filling is self._filling and widgets.shiboken.isValid(self.table):
            if next(filling, None) is not None:
                QtCore.QTimer.singleShot(0, lambda: self._fill_on(filling))

    def _boxes(self, name, names, labels):
        """A generator that creates the combo boxes and yields after some of them."""
        before = self.table
        for row, now in enumerate(list(self.motions)):
            box = widgets.choice(names, now.Name if motion.is_motion(now) else "", labels)
            box.setFrame(False)
            box.setObjectName("{}{}".format(name, row + 1))
            box.currentIndexChanged.connect(lambda i, row=row, box=box: self._chose(row, box))
            self.table.setCellWidget(row, 1, box)
            # Without this, Tab would reach the boxes only after all other widgets of the window.
            QtWidgets.QWidget.setTabOrder(before, box)
            before = box
            if row % BOXES_AT_ONCE == BOXES_AT_ONCE - 1:
                yield row
        QtWidgets.QWidget.setTabOrder(before, self.add)
        if len(self.pairs) <= MOST_MEASURED:
            self.table.resizeRowsToContents()

    def show_parts(self):
        """Fills the table."""
        raise NotImplementedError

    def remove_chosen(self):
        rows = {index.row() for index in self.table.selectedIndexes()}
        kept = [k for k in range(len(self.pairs)) if k not in rows]
        self.pairs = [self.pairs[k] for k in kept]
        self.motions = [self.motions[k] for k in kept]
        self.show_parts()
        self.table.setFocus()  # the combo box that had the focus may be gone

    def _chose(self, row, box):
        name = box.currentData()
        self.motions[row] = self.document.getObject(name) if name else None
        self.changed.emit()
