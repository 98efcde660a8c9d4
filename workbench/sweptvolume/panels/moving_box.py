# SPDX-License-Identifier: LGPL-2.1-or-later
"""Parts that move at the same time, each with its motion: chosen, or all that a driver or a simulation
moves."""
import FreeCADGui as Gui

from .. import convert, runner
from ..convert import InputProblem
from ..features import joint_motions, motion
from ..features.base import objects_of_kind
from ..texts import translate
from . import frames_run, guard, selection, widgets
from .widgets import QtCore, QtWidgets


class MovingBox(QtCore.QObject):
    """`changed`: parts or motions are others now. message: the panel's label for problems."""

    changed = QtCore.Signal()

    def __init__(self, document, pairs, motions, layout, message):
        super().__init__()
        self.document, self.message = document, message
        self.pairs = list(pairs)
        self.motions = list(motions) + [None] * (len(self.pairs) - len(motions))
        rows = widgets.group(translate("Panels", "Moving parts"), layout)
        self.table = QtWidgets.QTableWidget(0, 2)
        self.table.setObjectName("SweptVolumeMovingParts")
        self.table.setHorizontalHeaderLabels(
            [translate("Panels", "Part"), translate("Panels", "Motion")]
        )
        self.table.setFixedHeight(150)
        self.table.verticalHeader().hide()
        self.table.setTabKeyNavigation(False)
        self.table.setSelectionBehavior(QtWidgets.QAbstractItemView.SelectRows)
        self.table.setEditTriggers(QtWidgets.QAbstractItemView.NoEditTriggers)
        self.table.horizontalHeader().setSectionResizeMode(QtWidgets.QHeaderView.Stretch)
        rows.addRow(self.table)
        line = QtWidgets.QHBoxLayout()
        self.add = self._button(
            line,
            "SweptVolumeAddMoving",
            translate("Panels", "&Add selected"),
            translate(
                "Panels", "Adds the parts selected in the tree, and the parts of selected motions"
            ),
            self.add_selected,
        )
        self._button(
            line,
            "SweptVolumeRemoveMoving",
            translate("Panels", "&Remove"),
            translate("Panels", "Takes the marked parts out of the list"),
            self.remove_chosen,
        )
        rows.addRow(line)
        self._build_source(rows)
        self.show_parts()

    def _button(self, line, name, text, tip, act):
        button = widgets.hint(QtWidgets.QPushButton(text), tip)
        button.setObjectName(name)
        button.clicked.connect(lambda *ignored: act())
        line.addWidget(button)
        return button

    def _build_source(self, rows):
        """Whatever moves several parts at once can give all of them."""
        self.sources = joint_motions.sources_in(self.document)
        if not self.sources:
            return
        line = QtWidgets.QHBoxLayout()
        texts = [_text_of(settings) for settings in self.sources]
        self.source = widgets.choice(list(range(len(texts))), 0, texts)
        self.source.setObjectName("SweptVolumeJointSource")
        line.addWidget(self.source, 1)
        self._button(
            line,
            "SweptVolumeTakeAll",
            translate("Panels", "Take a&ll its parts"),
            translate(
                "Panels",
                "Runs it once and takes every part that moves: motions that the document has of it are read "
                "again, others are made",
            ),
            self.take_all,
        )
        rows.addRow(line)

    @guard.told
    def take_all(self):
        """All parts of the chosen source, with motions; one undo step."""
        settings = self.sources[self.source.currentData()]
        widgets.show_message(self.message, "")
        with runner.transaction(self.document, translate("Messages", "Motions of all parts")):
            run = frames_run.recorded(self.document, settings)
            if run is None:
                return
            found, notes = joint_motions.take(self.document, settings, run)
            self.document.recompute()
        self.take_motions(found)
        notes += [m.Message for m in found[:1] if m.Message]
        widgets.show_message(self.message, "\n".join(notes))

    def take_motions(self, found):
        """Adds the parts of motions. Raises InputProblem for one that knows none."""
        for path in found:
            pairs = motion.parts_of(path)
            if not pairs:
                text = translate(
                    "Messages", '"{0}" does not know its part: add the part, then choose it.'
                )
                raise InputProblem(text.format(path.Label))
            for pair in pairs:
                self._take(pair, path)
        self.show_parts()

    def _take(self, pair, path):
        if pair in self.pairs:
            self.motions[self.pairs.index(pair)] = path or self.motions[self.pairs.index(pair)]
            return
        self.pairs.append(pair)
        self.motions.append(path)

    @guard.told
    def add_selected(self):
        chosen = selection.motions()
        for pair in selection.parts():
            known = [m for m in self._known() if pair in motion.parts_of(m)]
            self._take(pair, known[0] if known else None)
        self.take_motions(chosen)
        Gui.Selection.clearSelection()

    def remove_chosen(self):
        rows = {index.row() for index in self.table.selectedIndexes()}
        kept = [k for k in range(len(self.pairs)) if k not in rows]
        self.pairs = [self.pairs[k] for k in kept]
        self.motions = [self.motions[k] for k in kept]
        self.show_parts()
        self.table.setFocus()  # the box that may have had the keyboard is gone

    def _known(self):
        return objects_of_kind(self.document, motion.Motion.KIND)

    def show_parts(self):
        known = self._known()
        names, texts = [m.Name for m in known], [m.Label for m in known]
        before = self.table
        self.table.setRowCount(len(self.pairs))
        for row, pair in enumerate(self.pairs):
            item = QtWidgets.QTableWidgetItem(convert.label_of(*pair))
            item.setToolTip(item.text())
            self.table.setItem(row, 0, item)
            now = self.motions[row]
            now = now.Name if motion.is_motion(now) else ""
            box = widgets.choice([""] + names, now, [translate("Panels", "(choose)")] + texts)
            box.setFrame(False)
            box.setObjectName("SweptVolumeMotionOf{}".format(row + 1))
            box.currentIndexChanged.connect(lambda i, row=row, box=box: self._chose(row, box))
            self.table.setCellWidget(row, 1, box)
            QtWidgets.QWidget.setTabOrder(before, box)  # else they come last of the whole window
            before = box
        QtWidgets.QWidget.setTabOrder(before, self.add)
        if len(self.pairs) <= 200:  # each row is measured
            self.table.resizeRowsToContents()
        self.changed.emit()

    def _chose(self, row, box):
        name = box.currentData()
        self.motions[row] = self.document.getObject(name) if name else None
        self.changed.emit()


def _text_of(settings):
    """How people call a source."""
    label, name = settings.objects[0].Label, settings.get("property", "")
    return "{}: {}".format(label, name) if name else label
