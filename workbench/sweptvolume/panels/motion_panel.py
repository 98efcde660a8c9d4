# SPDX-License-Identifier: LGPL-2.1-or-later
"""Task panel: the path editor. Table of keys, capture, play; the part itself is never moved, and the
document changes only with OK, in one step."""
import FreeCAD as App
import FreeCADGui as Gui
from PySide import QtCore

from .. import convert, core, settings
from ..convert import InputProblem
from ..features import motion
from ..features.envelope import is_envelope
from ..texts import translate
from ..trajectory.edit import Keys, as_numbers, from_numbers, number_from
from ..trajectory.poses import FRAME_HELP, FRAMES, INTERPOLATIONS, at_time, base_of
from ..views.ghost import Ghosts
from . import selection, widgets
from .preview import Preview
from .widgets import QtWidgets

COLUMNS = ["t", "x", "y", "z", "yaw", "pitch", "roll"]
UNITS = ["s", "mm", "mm", "mm", "deg", "deg", "deg"]
#: ms between two pictures while playing; steps of the slider.
FRAME_TIME, SLIDER = 40, 1000
#: Ghosts are coarse: deflection as part of the part's box diagonal; most keys that get one.
GHOST_DEFLECTION, MOST_GHOSTS = 0.01, 60


#: The panel opened last (FreeCAD keeps it, but does not hand it out); for tests and macros.
opened = []


class MotionPanel:
    """Makes a new motion (obj None) or changes one."""

    def __init__(self, document, obj=None, pair=None):
        self.document, self.obj = document, obj
        self.pair = pair or _part_of(document, obj)
        self.keys = Keys(obj.Times, obj.Placements) if obj else Keys()
        self.before = ([], []) if obj is None else (list(obj.Times), list(obj.Placements))
        self.ghosts, self.filling = None, False
        self.target = self.pair[0].getSubObject(self.pair[1], retType=1) if self.pair else None
        self.home = App.Placement(self.target.Placement) if self.target is not None else None
        self.form, layout = widgets.window(translate("Panels", "Path"), "SweptVolume_EditMotion")
        self._build_table(layout)
        self._build_rules(layout)
        self._build_player(layout)
        self.message = widgets.message_label()
        layout.addWidget(self.message)
        layout.addStretch(1)
        self.body = None
        self.preview = Preview(document, self.show_preview, self.report_preview)
        self.timer = QtCore.QTimer(self.form)
        self.timer.timeout.connect(self.advance)
        self._make_ghosts()
        self.fill(0)

    # --- building

    def _build_table(self, layout):
        rows = widgets.group(translate("Panels", "Key placements"), layout)
        part = convert.label_of(*self.pair) if self.pair else translate("Panels", "none selected")
        rows.addRow(translate("Panels", "Part"), QtWidgets.QLabel(part))
        self.table = QtWidgets.QTableWidget(0, len(COLUMNS))
        self.table.setObjectName("SweptVolumeKeys")
        self.table.setHorizontalHeaderLabels(COLUMNS)
        self.table.setSelectionBehavior(QtWidgets.QAbstractItemView.SelectRows)
        self.table.setMinimumHeight(170)
        self.table.horizontalHeader().setSectionResizeMode(QtWidgets.QHeaderView.Stretch)
        self.table.itemChanged.connect(self.edited)
        self.table.currentCellChanged.connect(self.chosen)
        rows.addRow(self.table)
        grid = QtWidgets.QGridLayout()
        self.buttons = {}
        for i, (name, text, tip, action) in enumerate(self._actions()):
            button = QtWidgets.QPushButton(text)
            button.setObjectName("SweptVolume" + name)
            button.setToolTip(tip)
            button.clicked.connect(lambda checked=False, action=action: self.act(action))
            grid.addWidget(button, i // 3, i % 3)
            self.buttons[name] = button
        rows.addRow(grid)

    def _actions(self):
        t = lambda text: translate("Panels", text)  # noqa: E731
        return [
            ("Capture", t("Capture"), t("Adds the placement that the part has now"), self._capture),
            (
                "Update",
                t("Update"),
                t("Takes the part's placement of now for this key"),
                self._update,
            ),
            ("Insert", t("Insert"), t("A new key half-way to the next one"), self._insert),
            (
                "Duplicate",
                t("Duplicate"),
                t("The same placement again"),
                lambda i: self.keys.duplicate(i),
            ),
            ("Delete", t("Delete"), t("Removes the key"), self._delete),
            ("Reverse", t("Reverse"), t("The way back"), self._reverse),
            ("Up", t("Up"), t("Earlier"), lambda i: self.keys.move(i, -1)),
            ("Down", t("Down"), t("Later"), lambda i: self.keys.move(i, 1)),
            ("Even", t("Even times"), t("One second from key to key"), self._even),
        ]

    def _build_rules(self, layout):
        rows = widgets.group(translate("Panels", "Motion"), layout)
        self.interpolation = widgets.choice(
            list(INTERPOLATIONS), self.obj.Interpolation if self.obj else "Linear"
        )
        self.frame = widgets.choice(FRAMES, self.obj.Frame if self.obj else "Absolute")
        self.frame.setToolTip(translate("Properties", FRAME_HELP))
        rows.addRow(translate("Panels", "Between poses"), self.interpolation)
        rows.addRow(translate("Panels", "A pose is"), self.frame)
        self.frame.currentIndexChanged.connect(lambda i: self.show_ghosts())
        self.interpolation.currentIndexChanged.connect(self.ask_preview)
        self.preview_box = QtWidgets.QCheckBox(translate("Panels", "Show a coarse envelope"))
        self.preview_box.setChecked(settings.preview())
        self.preview_box.toggled.connect(self.ask_preview)
        self.preview_text = widgets.message_label()
        rows.addRow(self.preview_box)
        rows.addRow(self.preview_text)

    def _build_player(self, layout):
        rows = widgets.group(translate("Panels", "Play"), layout)
        self.slider = QtWidgets.QSlider(QtCore.Qt.Horizontal)
        self.slider.setObjectName("SweptVolumeTime")
        self.slider.setRange(0, SLIDER)
        self.slider.valueChanged.connect(lambda value: self.show_moving())
        self.play = QtWidgets.QPushButton(translate("Panels", "Play"))
        self.play.setObjectName("SweptVolumePlay")
        self.play.setCheckable(True)
        self.play.toggled.connect(self.toggle)
        self.time = QtWidgets.QLabel()
        line = QtWidgets.QHBoxLayout()
        line.addWidget(self.play)
        line.addWidget(self.slider, 1)
        line.addWidget(self.time)
        rows.addRow(line)

    # --- keys

    def standing(self):
        """Where the part stands now, by which a captured key is meant."""
        if self.pair is None:
            raise InputProblem(
                translate(
                    "Messages",
                    "no part: close the panel, select the moving part and open it again.",
                )
            )
        return convert.global_placement(*self.pair)

    def _capture(self, index):
        if self.frame.currentData() != "Absolute":
            raise InputProblem(translate("Messages", "only Absolute poses can be captured."))
        return self.keys.append(self.standing())

    def _update(self, index):
        self.keys.update(index, self.standing())
        return index

    def _insert(self, index):
        return self.keys.insert_after(index, self.interpolation.currentData())

    def _delete(self, index):
        self.keys.delete(index)
        return min(index, len(self.keys) - 1)

    def _reverse(self, index):
        self.keys.reverse()
        return len(self.keys) - 1 - index

    def _even(self, index):
        self.keys.even(1.0)
        return index

    def act(self, action):
        """Runs a button's action on the current row; problems are shown below."""
        widgets.show_message(self.message, "")
        row = self.table.currentRow()
        if row < 0 and action not in (self._capture, self._insert, self._reverse, self._even):
            widgets.show_message(
                self.message, translate("Messages", "choose a key in the table first.")
            )
            return
        try:
            self.fill(action(row if row >= 0 else len(self.keys) - 1))
        except InputProblem as problem:
            widgets.show_message(self.message, str(problem))

    def fill(self, current):
        """Shows the keys in the table."""
        self.filling = True
        self.table.setRowCount(len(self.keys))
        for row in range(len(self.keys)):
            self._fill_row(row)
        self.filling = False
        if len(self.keys):
            self.table.setCurrentCell(max(0, min(current, len(self.keys) - 1)), 1)
        self.show_ghosts()

    def _fill_row(self, row):
        numbers = (self.keys.times[row],) + as_numbers(self.keys.placements[row])
        for column, number in enumerate(numbers):
            item = QtWidgets.QTableWidgetItem("{:.6g}".format(number + 0.0))
            item.setTextAlignment(int(QtCore.Qt.AlignRight | QtCore.Qt.AlignVCenter))
            self.table.setItem(row, column, item)

    def edited(self, item):
        """A number was typed; units are understood ("2 in")."""
        if self.filling:
            return
        row, column = item.row(), item.column()
        widgets.show_message(self.message, "")
        try:
            number = number_from(item.text(), UNITS[column])
            if column == 0:
                self.keys.set_time(row, number)
            else:
                numbers = list(as_numbers(self.keys.placements[row]))
                numbers[column - 1] = number
                self.keys.update(row, from_numbers(numbers))
        except InputProblem as problem:
            widgets.show_message(self.message, str(problem))
        self.filling = True
        self._fill_row(row)
        self.filling = False
        self.show_ghosts()

    def chosen(self, row, *ignored):
        """The moving ghost jumps to the chosen key."""
        if self.filling or not 0 <= row < len(self.keys) or len(self.keys) < 2:
            return
        first, last = self.keys.times[0], self.keys.times[-1]
        part = (self.keys.times[row] - first) / (last - first)
        self.slider.setValue(int(round(part * SLIDER)))

    # --- ghosts and playing

    def _make_ghosts(self):
        if self.pair is None:
            return
        try:
            corners = convert.box_corners([self.pair])
            size = float(((corners.max(axis=0) - corners.min(axis=0)) ** 2).sum()) ** 0.5
            body = convert.body_from([self.pair], max(size * GHOST_DEFLECTION, 1e-6))
        except InputProblem as problem:
            widgets.show_message(self.message, str(problem))
            return
        self.body = body
        self.ghosts = Ghosts(self.document, body.vertices, body.triangles)

    def _applied(self, placements):
        """Placements that take the body to each pose."""
        # The ghosts' points are those of the body as it stood when they were made.
        base = base_of(self.keys.poses(), self.frame.currentData(), self.body.placement)
        return [p.multiply(base.inverse()) for p in placements]

    def show_ghosts(self):
        if self.ghosts is not None:
            step = max(1, len(self.keys) // MOST_GHOSTS)
            placements = self.keys.placements[::step]
            self.ghosts.show_keys(self._applied(placements) if placements else [])
        self.show_moving()
        self.ask_preview()

    def ask_preview(self, *ignored):
        """Wishes for a coarse envelope of the keys as they are now."""
        if self.ghosts is None:
            return
        if not self.preview_box.isChecked():
            self.preview.stop()
            self.ghosts.show_envelope([], [])
            return
        rules = self.frame.currentData(), self.interpolation.currentData()
        try:
            self.preview.want(
                self.body, Keys(self.keys.times, self.keys.placements).poses(), *rules
            )
        except (InputProblem, core.CoreMissing) as problem:
            self.report_preview(str(problem))

    def show_preview(self, vertices, triangles):
        if self.ghosts is not None and self.ghosts.root is not None:
            self.ghosts.show_envelope(vertices, triangles)

    def report_preview(self, text):
        self.preview_text.setText(text)
        self.preview_text.setVisible(bool(text))

    def now(self):
        """Time (s) at the slider."""
        first, last = self.keys.times[0], self.keys.times[-1]
        return first + (last - first) * self.slider.value() / SLIDER

    def show_moving(self):
        if not len(self.keys):
            return
        self.time.setText("{:.2f} s".format(self.now()))
        if self.ghosts is not None:
            here = at_time(self.keys.poses(), self.interpolation.currentData(), self.now())
            self.ghosts.show_moving(self._applied([here])[0])

    def toggle(self, on):
        self.play.setText(translate("Panels", "Pause") if on else translate("Panels", "Play"))
        if on and len(self.keys) > 1:
            if self.slider.value() >= SLIDER:
                self.slider.setValue(0)
            self.timer.start(FRAME_TIME)
        else:
            self.timer.stop()

    def advance(self):
        span = max(self.keys.times[-1] - self.keys.times[0], 1e-9)
        step = max(1, int(round(SLIDER * FRAME_TIME / 1000.0 / span)))
        self.slider.setValue(min(SLIDER, self.slider.value() + step))
        if self.slider.value() >= SLIDER:
            self.play.setChecked(False)

    # --- task panel

    def _close(self):
        self.timer.stop()
        self.preview.stop()
        if self.ghosts is not None and widgets.alive(self.document):
            self.ghosts.remove()
        Gui.Control.closeDialog()
        return True

    def accept(self):
        self.document.openTransaction(translate("Messages", "Edit motion"))
        try:
            if self.obj is None:
                self.obj = motion.make_motion(self.document)
            times, placements = self.before
            changed = times != self.keys.times or len(placements) != len(self.keys)
            changed = changed or any(a != b for a, b in zip(placements, self.keys.placements))
            if changed:
                self.obj.SourceType = "Stored"
                motion.store(self.obj, self.keys.poses())
            self.obj.Interpolation = self.interpolation.currentData()
            self.obj.Frame = self.frame.currentData()
            self.document.recompute()
        except InputProblem as problem:
            self.document.abortTransaction()
            widgets.show_message(self.message, str(problem))
            return False
        self.document.commitTransaction()
        return self._close()

    def reject(self):
        """Cancel: the part goes back to where it stood when the panel was opened."""
        if self.target is not None and widgets.alive(self.target):
            if self.target.Placement != self.home:
                self.target.Placement = self.home
                self.document.recompute()
        return self._close()


def _part_of(document, obj):
    """The part that a motion moves: the selected one, else the first of an envelope that uses it."""
    chosen = selection.parts()
    if chosen:
        return chosen[0]
    for user in obj.InList if obj else []:
        if is_envelope(user) and user.Generators:
            return convert.pairs_of(user.Generators)[0]
    return None


def show(document, obj=None, pair=None):
    panel = MotionPanel(document, obj, pair)
    opened[:] = [panel]
    Gui.Control.showDialog(panel)
    return panel
