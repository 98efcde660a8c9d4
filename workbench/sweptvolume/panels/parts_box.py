# SPDX-License-Identifier: LGPL-2.1-or-later
"""Moving parts of an envelope, each with its motion, and the reference part."""
import FreeCADGui as Gui

from .. import convert
from ..texts import translate
from . import selection, widgets
from .motion_table import MotionTable
from .widgets import QtWidgets


class PartsBox(MotionTable):
    """Signal `changed`: other parts, motions or another reference were chosen. None in `motions`
    means the common motion."""

    def __init__(self, document, plan, layout, chosen=False):
        """chosen: the plan belongs to an object. Then missing inputs stay empty."""
        own = [None if m is plan.motion else m for m in plan.motions]
        super().__init__(document, plan.pairs, own)
        self.chosen = chosen
        self.reference = plan.reference
        self._build_parts(plan, layout)
        self._build_reference(plan, layout)
        self.show_parts()

    def _build_parts(self, plan, layout):
        rows = widgets.group(translate("SweptVolume", "Moving parts"), layout)
        rows.addRow(
            self.build_table("SweptVolumeParts", translate("SweptVolume", "Own motion"), 96)
        )
        self.add = QtWidgets.QPushButton(translate("SweptVolume", "&Add selected"))
        self.remove = QtWidgets.QPushButton(translate("SweptVolume", "&Remove"))
        self.add.setObjectName("SweptVolumeAddParts")
        self.remove.setObjectName("SweptVolumeRemoveParts")
        tip = translate("SweptVolume", "Adds the solids and meshes selected in the tree")
        widgets.hint(self.add, tip)
        widgets.hint(
            self.remove, translate("SweptVolume", "Removes the selected parts from the list")
        )
        buttons = QtWidgets.QHBoxLayout()
        buttons.addWidget(self.add)
        buttons.addWidget(self.remove)
        rows.addRow(buttons)
        self.common = self._motion_box(plan.motion)
        self.common.setObjectName("SweptVolumeMotion")
        rows.addRow(translate("SweptVolume", "Motion"), self.common)
        self.add.clicked.connect(lambda *ignored: self.add_selected())
        self.remove.clicked.connect(lambda *ignored: self.remove_chosen())
        self.common.currentIndexChanged.connect(lambda *ignored: self.changed.emit())

    def _motion_box(self, now):
        """Returns a combo box with the document's motions."""
        known = self.known()
        names, texts = [o.Name for o in known], [o.Label for o in known]
        box = widgets.choice(names, now.Name if now is not None else "", texts)
        if now is None and self.chosen:
            box.setCurrentIndex(-1)
        return box

    def _build_reference(self, plan, layout):
        self.reference_box = QtWidgets.QGroupBox(
            translate("SweptVolume", "Relative to a moving part")
        )
        self.reference_box.setObjectName("SweptVolumeReference")
        self.reference_box.setCheckable(True)
        self.reference_box.setChecked(
            plan.reference_motion is not None or (self.chosen and plan.reference is not None)
        )
        self.reference_box.setToolTip(
            translate(
                "SweptVolume",
                "Computes the space that the moving parts occupy as seen from this part",
            )
        )
        grid = QtWidgets.QFormLayout(self.reference_box)
        grid.setContentsMargins(*widgets.MARGINS)
        grid.setFieldGrowthPolicy(QtWidgets.QFormLayout.AllNonFixedFieldsGrow)
        self.take = QtWidgets.QPushButton()
        self.take.setObjectName("SweptVolumeTakeReference")
        widgets.hint(
            self.take, translate("SweptVolume", "Takes the part that is selected in the tree")
        )
        self.reference_motions = self._motion_box(plan.reference_motion)
        self.reference_motions.setObjectName("SweptVolumeReferenceMotion")
        self.rows = [
            (QtWidgets.QLabel(translate("SweptVolume", "Reference")), self.take),
            (
                QtWidgets.QLabel(translate("SweptVolume", "Reference motion")),
                self.reference_motions,
            ),
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
        text = translate("SweptVolume", "Take selected")
        self.take.setText(convert.label_of(*self.reference) if self.reference else text)
        self.changed.emit()

    def take_reference(self):
        found = selection.parts()
        if found:
            self.reference = found[0]
            self._show_reference()

    def show_parts(self):
        texts = []
        for root, sub in self.pairs:
            text = convert.label_of(root, sub)
            if sub.count(".") >= 1:
                text += "  ({})".format(root.Label)
            texts.append(text)
        self.fill(texts, "SweptVolumeOwnMotion", translate("SweptVolume", "as below"))

    def add_selected(self):
        for pair in selection.parts():
            if pair not in self.pairs:
                self.pairs.append(pair)
                self.motions.append(None)
        Gui.Selection.clearSelection()
        self.show_parts()

    # --- what is chosen

    def motion(self):
        name = self.common.currentData()
        return self.document.getObject(name) if name else None

    def own_motions(self):
        """Returns one motion for each part, or an empty list."""
        if not any(self.motions):
            return []
        return [own or self.motion() for own in self.motions]

    def seen_from(self):
        """Returns (reference part, its motion); both are None if the box is not ticked."""
        name = self.reference_motions.currentData()
        if not self.reference_box.isChecked():
            return None, None
        return self.reference, self.document.getObject(name) if name else None
