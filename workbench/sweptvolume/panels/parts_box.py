# SPDX-License-Identifier: LGPL-2.1-or-later
"""Moving parts of an envelope, each with its motion, and the part from which they are seen."""
import FreeCADGui as Gui
from PySide import QtCore

from .. import convert
from ..features import motion
from ..features.base import objects_of_kind
from ..texts import translate
from . import selection, widgets
from .widgets import QtWidgets


class PartsBox(QtCore.QObject):
    """`changed`: parts, motions or reference are others now."""

    changed = QtCore.Signal()

    def __init__(self, document, plan, layout, chosen=False):
        """chosen: the plan is that of an object; what is missing there is not filled in silently."""
        super().__init__()
        self.chosen = chosen
        self.document, self.pairs = document, list(plan.pairs)
        self.own = [None if m is plan.motion else m for m in plan.motions]
        self.own += [None] * (len(self.pairs) - len(self.own))
        self.reference = plan.reference
        self.known = objects_of_kind(document, motion.Motion.KIND)
        self._build_parts(plan, layout)
        self._build_reference(plan, layout)
        self._show_parts()

    def _build_parts(self, plan, layout):
        rows = widgets.group(translate("Panels", "Moving parts"), layout)
        self.table = QtWidgets.QTableWidget(0, 2)
        self.table.setObjectName("SweptVolumeParts")
        self.table.setHorizontalHeaderLabels(
            [translate("Panels", "Part"), translate("Panels", "Own motion")]
        )
        self.table.setFixedHeight(96)
        self.table.verticalHeader().hide()
        self.table.setTabKeyNavigation(False)
        self.table.setSelectionBehavior(QtWidgets.QAbstractItemView.SelectRows)
        self.table.setEditTriggers(QtWidgets.QAbstractItemView.NoEditTriggers)
        self.table.horizontalHeader().setSectionResizeMode(QtWidgets.QHeaderView.Stretch)
        self.add = QtWidgets.QPushButton(translate("Panels", "&Add selected"))
        self.remove = QtWidgets.QPushButton(translate("Panels", "&Remove"))
        self.add.setObjectName("SweptVolumeAddParts")
        self.remove.setObjectName("SweptVolumeRemoveParts")
        tip = translate("Panels", "Adds the solids and meshes selected in the tree")
        widgets.hint(self.add, tip)
        widgets.hint(self.remove, translate("Panels", "Takes the marked parts out of the list"))
        buttons = QtWidgets.QHBoxLayout()
        buttons.addWidget(self.add)
        buttons.addWidget(self.remove)
        rows.addRow(self.table)
        rows.addRow(buttons)
        self.motions = self._motion_box(plan.motion, None)
        self.motions.setObjectName("SweptVolumeMotion")
        rows.addRow(translate("Panels", "Motion"), self.motions)
        self.add.clicked.connect(lambda *ignored: self.add_selected())
        self.remove.clicked.connect(lambda *ignored: self.remove_chosen())
        self.motions.currentIndexChanged.connect(lambda *ignored: self.changed.emit())

    def _motion_box(self, now, empty):
        """Combo box of the document's motions; `empty`: text of an entry for none."""
        names = [o.Name for o in self.known]
        texts = [o.Label for o in self.known]
        if empty is not None:
            names, texts = [""] + names, [empty] + texts
        box = widgets.choice(names, now.Name if now is not None else "", texts)
        if now is None and empty is None and self.chosen:
            box.setCurrentIndex(-1)
        return box

    def _build_reference(self, plan, layout):
        self.reference_box = QtWidgets.QGroupBox(translate("Panels", "Seen from a moving part"))
        self.reference_box.setObjectName("SweptVolumeReference")
        self.reference_box.setCheckable(True)
        self.reference_box.setChecked(
            plan.reference_motion is not None or (self.chosen and plan.reference is not None)
        )
        self.reference_box.setToolTip(
            translate("Panels", "The envelope is what the moving parts take up for this part")
        )
        grid = QtWidgets.QFormLayout(self.reference_box)
        grid.setContentsMargins(*widgets.MARGINS)
        grid.setFieldGrowthPolicy(QtWidgets.QFormLayout.AllNonFixedFieldsGrow)
        self.take = QtWidgets.QPushButton()
        self.take.setObjectName("SweptVolumeTakeReference")
        widgets.hint(self.take, translate("Panels", "Takes the part that is selected in the tree"))
        self.reference_motions = self._motion_box(plan.reference_motion, None)
        self.reference_motions.setObjectName("SweptVolumeReferenceMotion")
        self.rows = [
            (QtWidgets.QLabel(translate("Panels", "Part")), self.take),
            (QtWidgets.QLabel(translate("Panels", "Its motion")), self.reference_motions),
        ]
        for row in self.rows:
            grid.addRow(*row)
        layout.addWidget(self.reference_box)
        self.take.clicked.connect(lambda *ignored: self.take_reference())
        self.reference_box.toggled.connect(lambda *ignored: self._show_reference())
        self.reference_motions.currentIndexChanged.connect(lambda *ignored: self.changed.emit())
        self._show_reference()

    def _show_reference(self):
        on = self.reference_box.isChecked()
        for row in self.rows:
            for widget in row:
                widget.setVisible(on)
        text = translate("Panels", "Take selected")
        self.take.setText(convert.label_of(*self.reference) if self.reference else text)
        self.changed.emit()

    def take_reference(self):
        found = selection.parts()
        if found:
            self.reference = found[0]
            self._show_reference()

    def _show_parts(self):
        before = self.table
        self.table.setRowCount(len(self.pairs))
        for row, (root, sub) in enumerate(self.pairs):
            text = convert.label_of(root, sub)
            if sub.count(".") >= 1:
                text += "  ({})".format(root.Label)
            item = QtWidgets.QTableWidgetItem(text)
            item.setToolTip(text)
            self.table.setItem(row, 0, item)
            box = self._motion_box(self.own[row], translate("Panels", "as below"))
            box.setFrame(False)
            box.setObjectName("SweptVolumeOwnMotion{}".format(row + 1))
            box.currentIndexChanged.connect(lambda i, row=row, box=box: self._chose(row, box))
            self.table.setCellWidget(row, 1, box)
            QtWidgets.QWidget.setTabOrder(before, box)  # else they come last of the whole window
            before = box
        QtWidgets.QWidget.setTabOrder(before, self.add)
        self.table.resizeRowsToContents()
        self.changed.emit()

    def _chose(self, row, box):
        name = box.currentData()
        self.own[row] = self.document.getObject(name) if name else None
        self.changed.emit()

    def add_selected(self):
        for pair in selection.parts():
            if pair not in self.pairs:
                self.pairs.append(pair)
                self.own.append(None)
        Gui.Selection.clearSelection()
        self._show_parts()

    def remove_chosen(self):
        rows = {index.row() for index in self.table.selectedIndexes()}
        kept = [k for k in range(len(self.pairs)) if k not in rows]
        self.pairs = [self.pairs[k] for k in kept]
        self.own = [self.own[k] for k in kept]
        self._show_parts()
        self.table.setFocus()  # the box that may have had the keyboard is gone

    # --- what is chosen

    def motion(self):
        name = self.motions.currentData()
        return self.document.getObject(name) if name else None

    def own_motions(self):
        """One motion for each part, or none at all."""
        if not any(self.own):
            return []
        return [own or self.motion() for own in self.own]

    def seen_from(self):
        """(reference, its motion); both None where the box is off."""
        name = self.reference_motions.currentData()
        if not self.reference_box.isChecked():
            return None, None
        return self.reference, self.document.getObject(name) if name else None
