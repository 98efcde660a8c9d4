# SPDX-License-Identifier: LGPL-2.1-or-later
"""Shows the motion in the result of a check. A player moves the parts. The shortest line between
the two parts of a row and a section through this line follow. The user can keep the volume of a
clash as an object."""
import numpy as np

from .. import convert, core_paths, quantities, runner
from ..convert import InputProblem
from ..texts import translate
from ..views.ghost import MOVING_TRIANGLES, MovingParts
from ..views.live_distance import LiveDistance
from ..views.section import SectionPlane
from . import check_result, guard, widgets
from .live_clearance import LiveClearance, Scene
from .player import Player
from .tasks import ShapesTask, SharedTask
from .widgets import QtWidgets


class RowScene(Scene):
    """The two parts of a row. first, second: bodies, in the frames that their courses move. A
    course returns the Placement at a time; None: the part stands still."""

    def __init__(self, first, second, courses, chord):
        super().__init__(chord)
        self.first, self.second, self.courses = first, second, courses

    def at(self, time):
        """Returns (4x4 of the first part relative to the frame of the second one, 4x4 of that frame
        in the world)."""
        first, second = (
            np.eye(4) if course is None else convert.matrix_of(course(time))
            for course in self.courses
        )
        return np.linalg.inv(second) @ first, second

    def make(self, control):
        body = self.first.vertices, self.first.triangles
        rows = [("", self.second.vertices, self.second.triangles)]
        return core_paths.live_clearance(*body, rows, control), [""]


class PlayedPanel(check_result.ResultPanel):
    """Subclasses define what moves, and which two parts belong to a row."""

    def plan_shown(self):
        """Returns the plan of `obj`. The parts that its seen() returns are drawn."""
        raise NotImplementedError

    def row_scene(self, index):
        """Returns the RowScene of a row. Raises InputProblem."""
        raise NotImplementedError

    def clash_plan(self, index):
        """Returns the shared.Plan of the two parts of a row at its time. Raises InputProblem."""
        raise NotImplementedError

    def build_played(self, rows):
        self.shapes, self.ghosts, self.line, self.courses = None, None, None, []
        self.live, self.followed, self.frames, self.cut = None, -1, {}, None
        self.player = Player()
        self.player.moved.connect(self._moved)
        self.section = widgets.hint(
            QtWidgets.QCheckBox(translate("SweptVolume", "S&ection through the closest place")),
            translate(
                "SweptVolume",
                "Cuts the view at the place where the distance is smallest, and hides everything "
                "in front of it. The cut follows the selected row and the playback",
            ),
        )
        self.section.setObjectName("SweptVolumeSection")
        self.section.toggled.connect(lambda *ignored: self._cut_again())
        self.clash = widgets.hint(
            QtWidgets.QPushButton(translate("SweptVolume", "Keep clas&h volume")),
            translate(
                "SweptVolume",
                "Creates an object from the volume that the two parts of the chosen row share at "
                "the time of that row",
            ),
        )
        self.clash.setObjectName("SweptVolumeKeepClash")
        self.clash.setEnabled(False)
        self.clash.clicked.connect(lambda *ignored: self.keep(self.clash_plan))
        self.ends = None  # ends of the line that is shown
        for widget in (self.player, self.section, self.clash):
            rows.addWidget(widget)

    def set_span(self, times):
        """Sets the time span of the player. Nothing is drawn until the user moves it."""
        self.player.blockSignals(True)
        self.player.set_times(sorted(times))
        self.player.blockSignals(False)

    def go_to(self, time):
        """Moves the player to a time without further effects."""
        self.player.blockSignals(True)
        self.player.go_to(time)
        self.player.blockSignals(False)

    # --- a row

    def show_buttons(self, index):
        """Enables the buttons that keep a shared volume of a row; None: no row is chosen."""
        row = self.report["neighbours"][index] if index is not None else None
        self.clash.setEnabled(row is not None and row["verdict"] == "clash")

    @guard.shows_problems
    def keep(self, make):
        """Creates the shared volume whose plan make(index of the chosen row) returns."""
        index = self.chosen_row()
        if index >= 0 and self.run is None:
            plan = make(index)
            self.begin(lambda: SharedTask(self.document, plan), self.ended)

    # --- the player

    @guard.shows_problems
    def _moved(self):
        """Handles a move of the player to another time."""
        if getattr(self, "report", None) is None or not self.result.isVisible():
            return
        self.left_row()
        if self.player.times and self.ready():
            self.show_parts_at(self.player.now())
            self._follow(self.player.now())

    def left_row(self):
        """Called when the view no longer shows the moment of a row. The line stays until the next
        distance is known."""

    def show_parts_at(self, time, marked=()):
        self.ghosts.show([course(time) for course in self.courses], marked)
        self.graph.mark(time)

    def _follow(self, time):
        """Measures the line between the parts of the chosen row, or of the worst one."""
        index = self.chosen_row() if self.chosen_row() >= 0 else self.worst_first[0]
        if index != self.followed:
            self._stop_following()
            self.scene, self.followed = self.row_scene(index), index
            self.live = LiveClearance(self.document, self.scene, self._answered, self._failed)
        if self.live is not None:
            matrix, base = self.scene.at(time)
            number = self.live.want(None, matrix)
            self.frames = {n: b for n, b in self.frames.items() if n > number - 5}
            self.frames[number] = base

    def _answered(self, answer):
        base = self.frames.get(answer.number)
        if self.line is None or base is None or answer.number != self.live.number:
            return
        if answer.points[0] is None:
            self.line.hide()
            return
        ends = [base[:3, :3] @ np.asarray(p) + base[:3, 3] for p in answer.points]
        text = quantities.quantity(answer.distance, quantities.TABLE_DIGITS)
        clash = answer.distance <= 0
        text = translate("SweptVolume", "clash") if clash else text
        self.draw_line(ends, text, clash)

    def draw_line(self, ends, text, clash):
        """Draws the line and the section through it."""
        self.ends = ends
        self.line.show_between(ends, text, clash)
        self._cut_again()

    def _failed(self, text):
        widgets.show_message(self.message, text)
        self._stop_following()

    def _stop_following(self):
        if self.live is not None:
            self.live.stop()
        self.live, self.followed, self.frames = None, -1, {}

    # --- the section

    @guard.shows_problems
    def _cut_again(self):
        if not self.section.isChecked() or self.ends is None:
            if self.cut is not None and widgets.alive(self.document):
                self.cut.remove()
            return
        if self.cut is None:
            self.cut = SectionPlane(self.document)
        self.cut.show(self.ends)

    # --- the parts, read in the background

    def ready(self):
        """Returns whether the parts can be drawn. If not, they are read, and parts_read()
        follows."""
        if self.ghosts is not None:
            return True
        if self.shapes is None and self.obj is not None:
            self.shapes = runner.start(ShapesTask(self.plan_shown(), MOVING_TRIANGLES))
            self.shapes.ended.connect(self._shapes_read)
        return False

    @guard.shows_problems
    def _shapes_read(self, run):
        self.shapes = None
        if run.state != "ok" or not widgets.alive(self.document):
            return
        self.courses = [course for _, _, course in run.task.found]
        self.points = [np.asarray(drawn[0], dtype=float) for drawn, _, _ in run.task.found]
        self.ghosts = MovingParts(self.document, [found[:2] for found in run.task.found])
        self.line = LiveDistance(self.document)
        self.parts_read()

    def parts_read(self):
        """Called when the parts can be drawn."""
        self._moved()

    def clear_view(self):
        """Removes all drawings. The parts are read again when needed."""
        self.player.stop()
        self._stop_following()
        if self.shapes is not None:
            self.shapes.ended.disconnect(self._shapes_read)
            self.shapes.cancel()
        if widgets.alive(self.document):
            for drawn in (self.ghosts, self.line, self.cut):
                if drawn is not None:
                    drawn.remove()
        self.shapes, self.ghosts, self.line, self.cut, self.courses = None, None, None, None, []
        self.ends = None

    def lost(self):
        super().lost()
        self.clear_view()

    def leave(self):
        super().leave()
        self.clear_view()


def gone():
    """Returns the InputProblem for a part in the report that does not exist any more."""
    return InputProblem(
        translate(
            "SweptVolume", "One of the parts in this row no longer exists: run the check again."
        )
    )
