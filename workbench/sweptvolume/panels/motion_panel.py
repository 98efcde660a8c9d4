# SPDX-License-Identifier: LGPL-2.1-or-later
"""Task panel: the motion editor. OK changes the document in one step; Cancel undoes all."""
import FreeCAD as App
import FreeCADGui as Gui

from .. import convert, runner, settings
from ..convert import InputProblem
from ..features import motion
from ..texts import translate
from ..trajectory.edit import Keys, number_from, rounded
from ..trajectory.poses import FRAME_HELP, FRAMES, INTERPOLATIONS
from ..trajectory.spline import Spline
from ..views.edit_lock import EditLock
from . import focus, guard, key_table, selection, sourced, widgets
from .key_history import History, UndoKeys, content, copy_of
from .keys_in_view import KeysInView
from .live_box import LiveBox
from .pivot_box import PivotBox
from .place_picker import PlacePicker
from .player import Player
from .preview import MOST_CELLS, Preview
from .snap_line import SnapLine
from .tangent_box import TangentBox
from .widgets import QtWidgets

#: The panel opened last, for tests and macros. FreeCAD does not give access to it.
opened = []


class MotionPanel(KeysInView):
    """Creates a new motion (obj None), or changes an existing one."""

    def __init__(self, document, obj=None, pair=None):
        self.document, self.obj = document, obj
        self.pair = pair or selection.moved_part(obj)
        self.keys = Keys()
        if obj:
            self.keys = Keys(obj.Times, obj.Placements, motion.tangents_of(obj), pivot=obj.Pivot)
        self.before, self.history = content(self.keys), History(self.keys, 0)
        # Keys are in coordinates of the group that holds the motion; the drawing is in world
        # coordinates.
        self.container = motion.container_of(obj) if obj else App.Placement()
        self.body, self.ghosts, self.coarse, self.dragger = None, None, None, None
        self.light, self.undrawn, self.drawn, self.path_seen = None, None, 0.0, True
        self.target = self.pair[0].getSubObject(self.pair[1], retType=1) if self.pair else None
        self.home = App.Placement(self.target.Placement) if self.target is not None else None
        self.form, layout = widgets.window(
            translate("SweptVolume", "Motion"), "SweptVolume_EditMotion"
        )
        self.message = widgets.message_label()
        layout.addWidget(self.message)
        none = translate("SweptVolume", "none: select the part, then press Pick")
        self.keyboard = key_table.add_to(
            layout,
            convert.label_of(*self.pair) if self.pair else none,
            sourced.name_of(obj) if sourced.is_sourced(obj) else "",
        )
        self.table = self.keyboard.table
        self.cut, self.part_chosen = not sourced.is_sourced(obj), False
        self.few_keys = widgets.message_label()
        self.few_keys.setText(
            translate(
                "SweptVolume",
                "A motion needs at least two keys (poses): move the part, then press Capture.",
            )
        )
        layout.addWidget(self.few_keys)
        self._build_rules(layout)
        self.player = Player()
        layout.addWidget(self.player)
        self._build_view(layout)
        layout.addStretch(1)
        self.preview = Preview(document, self.show_preview, self.report_preview, lambda: MOST_CELLS)
        self.watch = widgets.DocumentWatch(document, self._close)
        self._make_ghosts()
        self._connect()
        self.picker = PlacePicker(document, self.place_clicked)
        self.undo_keys = UndoKeys(self.step_back)
        self.lock = EditLock(document, self.refuse_edit)
        self.fill(0)

    # --- building

    def _build_rules(self, layout):
        rows = widgets.group(translate("SweptVolume", "Motion"), layout)
        self.interpolation = widgets.choice(
            list(INTERPOLATIONS), self.obj.Interpolation if self.obj else "Linear"
        )
        self.interpolation.setObjectName("SweptVolumeInterpolation")
        self.frame = widgets.choice(FRAMES, self.obj.PoseType if self.obj else "Absolute")
        self.frame.setToolTip(translate("App::Property", FRAME_HELP))
        rows.addRow(translate("SweptVolume", "Interpolation"), self.interpolation)
        rows.addRow(translate("SweptVolume", "Pose type"), self.frame)
        self.pivot = PivotBox(self.pair)
        self.pivot.show_fixed(self.keys.pivot)
        rows.addRow(translate("SweptVolume", "Pivot"), self.pivot)
        self.tangent = TangentBox()
        layout.addWidget(self.tangent)

    def _build_view(self, layout):
        rows = widgets.group(translate("SweptVolume", "In the 3D view"), layout)
        self.drag_box = QtWidgets.QCheckBox(translate("SweptVolume", "Drag the chosen key"))
        self.drag_box.setObjectName("SweptVolumeDrag")
        self.drag_box.setChecked(True)
        self.snap_line = line = SnapLine()
        self.snap, self.snap_angle = line.length, line.angle
        line.changed.connect(self._set_snap)
        line.rounding.connect(lambda: self.act("Round"))
        self.preview_box = QtWidgets.QCheckBox(translate("SweptVolume", "Show a coarse envelope"))
        self.preview_box.setChecked(settings.preview())
        self.preview_text = widgets.message_label()
        rows.addRow(self.drag_box)
        rows.addRow(translate("SweptVolume", "Snap"), line)
        self.live, self.let_go = LiveBox(self.document, rows), False
        rows.addRow(self.preview_box)
        rows.addRow(self.preview_text)

    def _connect(self):
        self.keyboard.part.clicked.connect(lambda *ignored: self.choose_part())
        self.keyboard.wanted.connect(self.act)
        self.keyboard.typed.connect(self.edited)
        self.keyboard.chosen.connect(self.chosen)
        self.tangent.changed.connect(self._tangent_changed)
        self.player.moved.connect(self.show_moving)
        self.frame.currentIndexChanged.connect(lambda *ignored: self.fill(self.keyboard.row()))
        self.pivot.changed.connect(self._pivot_changed)
        self.pivot.failed.connect(lambda text: widgets.show_message(self.message, text))
        self.interpolation.currentIndexChanged.connect(lambda *ignored: self.show_all())
        self.preview_box.toggled.connect(lambda *ignored: self.ask_preview())
        self.live.reached.connect(self.reached)
        self.live.clashes.connect(self.show_clash)
        self.drag_box.toggled.connect(lambda *ignored: self.show_dragger())

    # --- keys

    def standing(self):
        """Returns the present placement of the part, which Capture uses."""
        if self.pair is None or not widgets.alive(self.pair[0]):
            raise InputProblem(
                translate(
                    "SweptVolume",
                    "There is no moving part: close the panel, select the part and open "
                    "the panel again.",
                )
            )
        return convert.global_placement(*self.pair)

    def _do(self, name, row):
        """Carries out an action on a row. Returns the row that is then current."""
        keys = self.keys
        if name in ("Capture", "Update") and self.frame.currentData() != "Absolute":
            raise InputProblem(
                translate(
                    "SweptVolume",
                    "A placement can be captured only as an absolute pose: set Pose type "
                    "to Absolute.",
                )
            )
        if name == "Capture":
            return keys.append(self.container.inverse().multiply(self.standing()))
        if name == "Insert":
            return keys.insert_after(row, self.interpolation.currentData())
        if name == "Reverse":
            keys.reverse()
            return len(keys) - 1 - row
        if name == "Paste":
            return keys.paste(row, self.keyboard.pasted())
        if name == "Even":
            keys.even(1.0)
            return row
        if not 0 <= row < len(keys):
            raise InputProblem(translate("SweptVolume", "Choose a key in the table first."))
        if name == "Duplicate":
            return keys.duplicate(row)
        if name in ("Up", "Down"):
            return keys.move(row, -1 if name == "Up" else 1)
        if name == "Update":
            keys.update(row, self.container.inverse().multiply(self.standing()))
        elif name == "Round":
            keys.update(row, keys.placed(rounded(keys.numbers(row), *self._snap_steps())))
        elif name == "Delete":
            keys.delete(row)
        return min(row, len(keys) - 1)

    @guard.shows_problems
    def act(self, name):
        """Carries out the action of a button or a key, and shows problems."""
        widgets.show_message(self.message, "")
        row = self.keyboard.row()
        if name == "Copy":
            self.keyboard.copy(self.keys)
            return
        self.fill(self._do(name, row if row >= 0 else len(self.keys) - 1))

    @guard.shows_problems
    def step_back(self, back):
        """Undoes the last change of the keys (back), or redoes it."""
        widgets.show_message(self.message, "")
        found = self.history.step(back)
        if found is None:
            text = translate("SweptVolume", "There is no change of the keys to undo or redo.")
            raise InputProblem(text)
        self.keys, row = found
        self.fill(row)

    def refuse_edit(self):
        """Ends FreeCAD's Transform, whose end would close this panel, and opens the panel again."""
        self._close()
        Gui.getDocument(self.document.Name).resetEdit()
        panel = show(self.document, self.obj, self.pair)
        panel.home = self.home
        text = translate(
            "SweptVolume",
            "Transform cannot be used while the motion editor is open: drag the "
            "chosen key, or enter numbers.",
        )
        panel.continue_from(self, text)

    @guard.shows_problems
    def choose_part(self):
        """Makes the selected part the moving part."""
        chosen = selection.parts()
        if not chosen:
            text = translate("SweptVolume", "Select the moving part in the tree or in the 3D view.")
            raise InputProblem(text)
        self._put_back()
        self._close()
        panel = show(self.document, self.obj, chosen[0])
        panel.part_chosen = True
        panel.continue_from(self)

    def continue_from(self, before, text=""):
        """Continues with the keys of an earlier panel."""
        self.keys, self.history = before.keys, before.history
        self.before, self.cut = before.before, before.cut
        for box, other in (
            (self.interpolation, before.chosen_rules[0]),
            (self.frame, before.chosen_rules[1]),
        ):
            box.setCurrentIndex(box.findData(other))
        if before.pair == self.pair:
            self.pivot.follow(*before.chosen_pivot)
        self.fill(self.history.now[1])
        widgets.show_message(self.message, text)

    def _refused(self):
        """Returns whether a change of the keys is refused. Asks the user if the motion has a source."""
        kept = self.history.now[0]
        if self.cut or content(self.keys)[:2] == content(kept)[:2]:
            return False
        self.cut = sourced.ask_to_unlink(self.obj)
        if self.cut:
            return False
        self.keys = copy_of(kept)
        self.fill(self.keyboard.row())
        return True

    def noted(self):
        """Stores a change of the keys as one step of Undo."""
        if self._refused():
            return
        self.history.note(self.keys, self.keyboard.row())
        self.undo_keys.show(self.history)
        self.few_keys.setVisible(len(self.keys) < 2)

    def fill(self, current):
        """Shows the keys in all widgets and in the view."""
        self.renew_pivot()
        self.keyboard.fill(self.keys, current)
        self.player.set_times(self.keys.times)
        self.chosen(self.keyboard.row())
        self.show_ghosts()
        self.noted()

    def edited(self, row, column, text):
        """Handles a typed number, which may have a unit ("2 in")."""
        widgets.show_message(self.message, "")
        try:
            unit, one = self.keyboard.units[column]
            number = number_from(text, unit) * one
            if column == 0:
                self.keys.set_time(row, number)
                self.player.set_times(self.keys.times)
            else:
                numbers = list(self.keys.numbers(row))
                numbers[column - 1] = number
                self.keys.update(row, self.keys.placed(numbers))
                self.renew_pivot()
        except Exception as problem:
            guard.show_problem(self.message, problem)
        self.keyboard.show_row(self.keys, row)
        self.noted()
        self.show_dragger()
        self.show_ghosts()

    def chosen(self, row):
        """Shows ghost, dragger and tangent of the chosen key."""
        self.live.quiet()
        if 0 <= row < len(self.keys):
            self.player.go_to(self.keys.times[row])
        self.show_dragger()
        self.show_tangent()

    def place_clicked(self, envelope, answer):
        """Handles a click on an envelope of this motion: shows the moment that created the
        point."""
        if answer is not None and self.obj is not None and answer.motion == self.obj.Name:
            self.player.go_to(answer.time)

    def show_tangent(self):
        row, smooth = self.keyboard.row(), self.interpolation.currentData() == "Spline"
        self.tangent.setVisible(smooth)
        self.tangent.setEnabled(0 <= row < len(self.keys) > 1)
        if smooth and self.tangent.isEnabled():
            poses = self.keys.poses().carried()
            if len(set(poses.times)) < len(poses.times):
                # Two keys at one time; the preview shows the problem.
                self.tangent.setEnabled(False)
                return
            spline = Spline(poses.times, poses.placements, poses.tangents)
            velocity = spline.velocity(row, after=row + 1 < len(self.keys))[0]
            self.tangent.show_tangent(self.keys.tangents[row][0], velocity)

    def _pivot_changed(self):
        widgets.show_message(self.message, "")
        self.fill(self.keyboard.row())

    def _tangent_changed(self, kind, velocity):
        if 0 <= self.keyboard.row() < len(self.keys):
            self.keys.set_tangent(self.keyboard.row(), kind, velocity)
            if kind != "Given":
                self.show_tangent()
            self.noted()
            self.show_ghosts()

    # --- task panel

    def _close(self):
        self.chosen_rules = self.interpolation.currentData(), self.frame.currentData()
        self.chosen_pivot = self.pivot.kind.currentData(), self.pivot.point
        self.watch.stop()
        self.undo_keys.stop()
        self.lock.stop()
        self.picker.stop()
        self.player.stop()
        self.preview.stop()
        if widgets.alive(self.document):
            self._show_own_path(True)
            for drawn in (self.ghosts, self.coarse, self.dragger, self.light, self.live):
                if drawn is not None:
                    drawn.remove()
        Gui.Control.closeDialog()
        return True

    @guard.shows_problems
    def accept(self):
        guard.check_fields(self.form)
        with runner.transaction(self.document, translate("SweptVolume", "Edit motion")):
            if self.obj is None or not widgets.alive(self.obj):  # the object was deleted meanwhile
                self.obj = motion.make_motion(
                    self.document, motion.label_for([self.pair] if self.pair else [])
                )
            if content(self.keys)[:2] != self.before[:2]:
                motion.make_stored(self.obj)
                motion.store(self.obj, self.keys.poses())
            if content(self.keys) != self.before:
                motion.set_tangents(self.obj, self.keys.tangents)
            self.obj.Interpolation = self.interpolation.currentData()
            self.obj.PoseType = self.frame.currentData()
            motion.set_changed(self.obj, "Pivot", self.keys.pivot)
            motion.set_parts(self.obj, [self.pair] if self.pair else [], anew=self.part_chosen)
            self.document.recompute()
        return self._close()

    def reject(self):
        """Cancel: moves the part back to where it was when the panel was opened."""
        self._put_back()
        return self._close()

    def _put_back(self):
        if self.target is not None and widgets.alive(self.target):
            if self.target.Placement != self.home:
                self.target.Placement = self.home
                self.document.recompute()


def show(document, obj=None, pair=None):
    panel = MotionPanel(document, obj, pair)
    opened[:] = [panel]
    focus.show(panel)
    return panel
