# SPDX-License-Identifier: LGPL-2.1-or-later
"""Parts that move at the same time, each with its motion: chosen parts, or all parts that a driver
or a simulation moves."""
import FreeCADGui as Gui

from .. import convert, runner
from ..convert import InputProblem
from ..features import joint_motions, motion
from ..texts import translate
from . import frames_run, guard, selection, widgets
from .motion_table import MotionTable
from .widgets import QtWidgets


class MovingBox(MotionTable):
    """message: the panel's label for problems."""

    def __init__(self, document, pairs, motions, layout, message):
        super().__init__(document, pairs, motions)
        self.message = message
        rows = widgets.group(translate("SweptVolume", "Moving parts"), layout)
        head = translate("SweptVolume", "Motion")
        rows.addRow(self.build_table("SweptVolumeMovingParts", head, 150))
        line = QtWidgets.QHBoxLayout()
        self.add = self._button(
            line,
            "SweptVolumeAddMoving",
            translate("SweptVolume", "&Add selected"),
            translate(
                "SweptVolume",
                "Adds the parts selected in the tree, and the parts of selected motions",
            ),
            self.add_selected,
        )
        self._button(
            line,
            "SweptVolumeRemoveMoving",
            translate("SweptVolume", "&Remove"),
            translate("SweptVolume", "Removes the selected parts from the list"),
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
        """Builds the row to choose a source that moves several parts, and to add all of them."""
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
            translate("SweptVolume", "Add a&ll its parts"),
            translate(
                "SweptVolume",
                "Runs the chosen simulation or driving value once, and adds every part that "
                "moves. Existing motions of these parts are recorded again, missing ones are "
                "created",
            ),
            self.take_all,
        )
        rows.addRow(line)

    @guard.shows_problems
    def take_all(self):
        """Adds all parts of the chosen source, with motions, as one undo step."""
        settings = self.sources[self.source.currentData()]
        widgets.show_message(self.message, "")
        with runner.transaction(self.document, translate("SweptVolume", "Motions of all parts")):
            run = frames_run.recorded(self.document, settings)
            if run is None:
                return
            found, notes = joint_motions.take(self.document, settings, run)
            self.document.recompute()
        self.take_motions(found)
        notes += [m.Message for m in found[:1] if m.Message]
        widgets.show_message(self.message, "\n".join(notes))

    def take_motions(self, found):
        """Adds the parts of motions. Raises InputProblem for a motion without parts."""
        for path in found:
            pairs = motion.parts_of(path)
            if not pairs:
                text = translate(
                    "SweptVolume",
                    'The motion "{0}" does not say which part it moves: add the part to the '
                    "table of moving parts, then choose this motion in the row of the part.",
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

    @guard.shows_problems
    def add_selected(self):
        chosen = selection.motions()
        for pair in selection.parts():
            known = [m for m in self.known() if pair in motion.parts_of(m)]
            self._take(pair, known[0] if known else None)
        self.take_motions(chosen)
        Gui.Selection.clearSelection()

    def show_parts(self):
        texts = [convert.label_of(*pair) for pair in self.pairs]
        self.fill(texts, "SweptVolumeMotionOf", translate("SweptVolume", "(choose)"))


def _text_of(settings):
    """Returns the text for a source."""
    label, name = settings.objects[0].Label, settings.get("property", "")
    return "{}: {}".format(label, name) if name else label
