# SPDX-License-Identifier: LGPL-2.1-or-later
"""Task panel: searches for a path of a part to its goal, shows the progress, and creates a motion.
"""
from PySide import QtCore

from .. import convert
from ..convert import InputProblem
from ..features import motion, path_plan
from ..texts import QT_TRANSLATE_NOOP, translate
from ..views.ghost import MovingPart
from . import focus, guard, path_texts, selection, widgets
from .path_tasks import FindPathTask
from .place_field import PlaceField
from .search_panel import SearchPanel
from .widgets import QtWidgets

#: Interval (ms) between two checks of the search's progress.
POLL = 100


class FindPathPanel(SearchPanel):
    """path: a motion whose ends become the start and the goal."""

    TITLE, ICON = QT_TRANSLATE_NOOP("SweptVolume", "Find path"), "SweptVolume_FindPath"
    BUTTON = QT_TRANSLATE_NOOP("SweptVolume", "&Find path")

    def __init__(self, document, pairs=(), neighbours=(), path=None):
        self.ghost = None
        self.poll_timer = QtCore.QTimer()
        self.poll_timer.timeout.connect(self._poll)
        super().__init__(document, pairs)
        if neighbours:
            self.take_neighbours(neighbours)
        if path is not None:
            self._take_ends(path)

    # --- building

    def build_task(self):
        rows = widgets.group(translate("SweptVolume", "Start and goal"), self.layout)
        self.part = QtWidgets.QLabel(self.part_text())
        self.part.setWordWrap(True)
        pick = QtWidgets.QPushButton(translate("SweptVolume", "&Pick"))
        pick.setObjectName("SweptVolumePickPart")
        widgets.hint(
            pick,
            translate(
                "SweptVolume", "Takes the part that is selected in the tree or in the 3D view"
            ),
        )
        line = QtWidgets.QHBoxLayout()
        line.addWidget(self.part, 1)
        line.addWidget(pick)
        self.goal = PlaceField("SweptVolumeGoal", ["Now", "Place"], self._pair)
        kinds = ["Out", "Along", "Place"]
        self.start_at = PlaceField("SweptVolumeStart", kinds, self._pair, self._size())
        rows.addRow(translate("SweptVolume", "Part"), line)
        rows.addRow(translate("SweptVolume", "Goal"), self.goal)
        rows.addRow(translate("SweptVolume", "Start"), self.start_at)
        pick.clicked.connect(lambda *ignored: self._pick())
        for field in (self.goal, self.start_at):
            field.failed.connect(lambda text: widgets.show_message(self.message, text))

    def build_rules(self, rows):
        self.straight = QtWidgets.QCheckBox(translate("SweptVolume", "The part never turns"))
        self.straight.setObjectName("SweptVolumeTranslationOnly")
        self.turn = widgets.hint(
            widgets.angle(path_plan.DEFAULTS["LargestTurn"], 0.0, 15.0),
            translate(
                "SweptVolume",
                "Largest angle by which the part may turn away from its orientation "
                "at the goal. 180: no limit",
            ),
        )
        self.turn.setObjectName("SweptVolumeLargestTurn")
        rows.addRow(self.straight)
        rows.addRow(translate("SweptVolume", "Largest turn"), self.turn)
        self.straight.toggled.connect(lambda on: self.turn.setEnabled(not on))

    # --- inputs

    def _pair(self):
        return self.pairs[0] if self.pairs else None

    def _size(self):
        """Returns the diagonal of the part, rounded: after this distance, the part is usually
        clear."""
        try:
            corners = convert.box_corners(self.pairs) if self.pairs else None
        except InputProblem:
            corners = None
        if corners is None:
            return 100.0
        size = float(((corners.max(axis=0) - corners.min(axis=0)) ** 2).sum()) ** 0.5
        return float("{:.2g}".format(size))

    @guard.shows_problems
    def _pick(self):
        chosen = selection.parts()
        if not chosen:
            raise InputProblem(
                translate("SweptVolume", "Select the moving part in the tree or in the 3D view.")
            )
        self.pairs = chosen[:1]
        self.beside.drop_moving()
        self.start_at.distance.setProperty("rawValue", self._size())
        self.part.setText(self.part_text())

    @guard.shows_problems
    def _take_ends(self, path):
        poses = motion.world_poses_of(path).placements
        if path.PoseType == "Absolute" and len(poses) > 1:
            self.start_at.show_placement(poses[0])
            self.goal.show_placement(poses[-1])
            return
        text = translate(
            "SweptVolume",
            'The motion "{0}" does not set start and goal: this needs the pose type Absolute and '
            "at least two poses. Enter start and goal below.",
        )
        widgets.show_message(self.message, text.format(path.Label))

    def plan(self):
        """Returns the plan (path_plan.PathPlan) for these fields. Raises InputProblem."""
        return path_plan.PathPlan(
            self.document,
            self.pairs,
            self.beside.pairs,
            start=self.start_at.placement(),
            extract=self.start_at.extract(),
            goal=self.goal.placement(),
            rules=self.beside.rules(),
            TranslationOnly=self.straight.isChecked(),
            LargestTurn=float(self.turn.property("rawValue")),
            **self.rules(),
        )

    # --- run

    def task(self):
        return FindPathTask(self.plan())

    def start(self):
        self._forget_ghost()
        if not super().start():
            return False
        self.poll_timer.start(POLL)
        return True

    def _poll(self):
        """Shows the farthest placement that the search has reached."""
        farthest = self.run.task.seen.farthest() if self.run is not None else None
        if farthest is not None:
            self._show_at(self.run.task, path_plan.placement_of(farthest))

    def _show_at(self, task, placement):
        """Shows the part at the farthest placement. Uses the triangles that the search has already
        created."""
        if self.ghost is None:
            body = task.request.body
            self.ghost = MovingPart(self.document, body.vertices, body.triangles)
        self.ghost.show(placement)

    def ended(self, run):
        self.poll_timer.stop()
        if run.state != "ok" and widgets.alive(self.document):
            self._forget_ghost()
        super().ended(run)

    def found(self, task):
        report = task.outcome.report
        widgets.show_message(self.message, path_texts.result_text(report))
        if task.obj is not None:
            self._forget_ghost()
            return
        self._show_at(task, task.outcome.farthest())
        self.beside.mark(report["escape"]["blockers"])

    def _forget_ghost(self):
        if self.ghost is not None:
            self.ghost.remove()
            self.ghost = None

    def reject(self):
        self.poll_timer.stop()
        if widgets.alive(self.document):
            self._forget_ghost()
        return super().reject()


def show(document, **given):
    panel = FindPathPanel(document, **given)
    focus.show(panel)
    return panel
