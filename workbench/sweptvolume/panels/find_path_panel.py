# SPDX-License-Identifier: LGPL-2.1-or-later
"""Task panel: finds the way of a part to its place. What it finds becomes a motion, each one step of Undo;
nothing else is written."""
import FreeCAD as App
import FreeCADGui as Gui
from PySide import QtCore

from .. import convert
from ..convert import InputProblem
from ..features import motion, path_plan
from ..texts import translate
from ..views.ghost import MovingPart
from . import focus, guard, path_texts, paths_table, selection, widgets
from .neighbours_box import NeighboursBox
from .path_tasks import FindPathTask
from .place_field import PlaceField
from .run_panel import StartPanel
from .widgets import QtWidgets

#: ms between two looks at where the search came to.
LOOK = 100


class FindPathPanel(StartPanel):
    """path: a motion whose ends are the start and the goal."""

    def __init__(self, document, pairs=(), neighbours=(), path=None):
        self.document, self.pairs, self.run, self.ghost = document, list(pairs), None, None
        self.form, self.layout = widgets.window(
            translate("Panels", "Find path"), "SweptVolume_FindPath"
        )
        self.box, self.message = widgets.RunBox(), widgets.message_label()
        self.find = QtWidgets.QPushButton(translate("Panels", "&Find path"))
        self.find.setObjectName("SweptVolumeFind")
        self.find.setDefault(True)  # Enter
        self.find.clicked.connect(lambda *ignored: self.start())
        for widget in (self.find, self.box, self.message):  # seen without scrolling
            self.layout.addWidget(widget)
        self.found = paths_table.PathsTable(document, self.layout)
        self._build_ends()
        self.beside = NeighboursBox(document, lambda: self.pairs, self.layout)
        self._build_rules()
        self.layout.addStretch(1)
        self.looks = QtCore.QTimer()
        self.looks.timeout.connect(self._look)
        self.watch = widgets.DocumentWatch(document, self.reject)
        self.beside.take_visible()
        if neighbours:
            self._take_neighbours(neighbours)
        if path is not None:
            self._take_ends(path)
        self._show_part()

    # --- building

    def _build_ends(self):
        rows = widgets.group(translate("Panels", "Way of the part"), self.layout)
        self.part = QtWidgets.QLabel()
        self.part.setWordWrap(True)
        pick = QtWidgets.QPushButton(translate("Panels", "&Pick"))
        pick.setObjectName("SweptVolumePickPart")
        widgets.hint(
            pick, translate("Panels", "Takes the part that is selected in the tree or in the view")
        )
        line = QtWidgets.QHBoxLayout()
        line.addWidget(self.part, 1)
        line.addWidget(pick)
        self.goal = PlaceField("SweptVolumeGoal", ["Now", "Place"], self._pair)
        kinds = ["Out", "Along", "Place"]
        self.start_at = PlaceField("SweptVolumeStart", kinds, self._pair, self._size())
        rows.addRow(translate("Panels", "Part"), line)
        rows.addRow(translate("Panels", "It belongs"), self.goal)
        rows.addRow(translate("Panels", "It comes from"), self.start_at)
        pick.clicked.connect(lambda *ignored: self._pick())
        for field in (self.goal, self.start_at):
            field.failed.connect(lambda text: widgets.show_message(self.message, text))

    def _build_rules(self):
        rows = widgets.group(translate("Panels", "Rules"), self.layout)
        now = path_plan.DEFAULTS
        self.required = widgets.length(now["Required"], 0.0, 0.5)
        self.required.setObjectName("SweptVolumePathClearance")
        self.release = widgets.hint(
            widgets.length(now["Release"], 0.0, 5.0),
            translate(
                "Panels",
                "Parts that touch, or are nearer than the clearance, where the way begins or ends may do "
                "so until no point of the part is farther than this from there",
            ),
        )
        self.release.setObjectName("SweptVolumeRelease")
        self.straight = QtWidgets.QCheckBox(translate("Panels", "The part never turns"))
        self.straight.setObjectName("SweptVolumeTranslationOnly")
        self.turn = widgets.hint(
            widgets.angle(now["LargestTurn"], 0.0, 15.0),
            translate("Panels", "From how the part stands where it belongs; 180: as it likes"),
        )
        self.turn.setObjectName("SweptVolumeLargestTurn")
        self.budget = QtWidgets.QDoubleSpinBox()
        self.budget.setObjectName("SweptVolumeBudget")
        self.budget.setRange(0.0, 86400.0)
        self.budget.setDecimals(1)
        self.budget.setSuffix(" s")
        self.budget.setValue(now["Budget"])
        self.seed = widgets.hint(
            QtWidgets.QSpinBox(), translate("Panels", "Another number may find another path")
        )
        self.seed.setObjectName("SweptVolumeSeed")
        self.seed.setRange(1, 1000000)
        self.deflection = widgets.length(now["Deflection"], 1e-4, 0.01)
        rows.addRow(translate("Panels", "Clearance"), self.required)
        rows.addRow(translate("Panels", "Contact allowed for"), self.release)
        rows.addRow(self.straight)
        rows.addRow(translate("Panels", "Largest turn"), self.turn)
        rows.addRow(translate("Panels", "Time at most"), self.budget)
        rows.addRow(translate("Panels", "Seed"), self.seed)
        rows.addRow(translate("Panels", "Mesh deflection"), self.deflection)
        self.straight.toggled.connect(lambda on: self.turn.setEnabled(not on))

    # --- inputs

    def _pair(self):
        return self.pairs[0] if self.pairs else None

    def _size(self):
        """Diagonal of the part, rounded: so far it is out, as a rule."""
        try:
            corners = convert.box_corners(self.pairs) if self.pairs else None
        except InputProblem:
            corners = None
        if corners is None:
            return 100.0
        size = float(((corners.max(axis=0) - corners.min(axis=0)) ** 2).sum()) ** 0.5
        return float("{:.2g}".format(size))

    def _show_part(self):
        none = translate("Panels", "none: select it, then press Pick")
        self.part.setText(", ".join(convert.label_of(*p) for p in self.pairs) or none)

    @guard.told
    def _pick(self):
        chosen = selection.parts()
        if not chosen:
            raise InputProblem(
                translate("Messages", "select the part that moves in the tree or in the 3D view.")
            )
        self.pairs = chosen[:1]
        self.beside.drop_moving()
        self.start_at.distance.setProperty("rawValue", self._size())
        self._show_part()

    @guard.told
    def _take_neighbours(self, pairs):
        self.beside.take(pairs)

    @guard.told
    def _take_ends(self, path):
        poses = motion.world_poses_of(path).placements
        if path.Frame == "Absolute" and len(poses) > 1:
            self.start_at.show_placement(poses[0])
            self.goal.show_placement(poses[-1])

    def plan(self):
        """What is asked for. Raises InputProblem."""
        return path_plan.PathPlan(
            self.document,
            self.pairs,
            self.beside.pairs,
            start=self.start_at.placement(),
            extract=self.start_at.extract(),
            goal=self.goal.placement(),
            clearances=self.beside.clearances(),
            Required=float(self.required.property("rawValue")),
            Release=float(self.release.property("rawValue")),
            TranslationOnly=self.straight.isChecked(),
            LargestTurn=float(self.turn.property("rawValue")),
            Budget=self.budget.value(),
            Seed=self.seed.value(),
            Deflection=float(self.deflection.property("rawValue")),
        )

    # --- run

    def start(self):
        self._forget_ghost()
        self.beside.mark([])
        if not self.begin(lambda: FindPathTask(self.plan()), self.ended):
            return False
        self.find.setEnabled(False)
        self.looks.start(LOOK)
        return True

    def _look(self):
        """Shows where the search came to."""
        farthest = self.run.task.seen.farthest() if self.run is not None else None
        if farthest is not None:
            self._show_at(self.run.task, App.Placement(App.Matrix(*farthest.ravel())))

    def _show_at(self, task, placement):
        """The part where the search came to. Its triangles are there: the search has them."""
        if self.ghost is None:
            body = task.request.body
            self.ghost = MovingPart(self.document, body.vertices, body.triangles)
        self.ghost.show(placement)

    def ended(self, run):
        self.looks.stop()
        self.run = None
        if not widgets.alive(self.document):
            return
        self.find.setEnabled(True)
        self.box.leave(self.form)
        task = run.task
        if run.state != "ok":
            self._forget_ghost()
            widgets.show_failure(self.message, run)
            return
        widgets.show_message(self.message, path_texts.told(task.outcome.report))
        if task.obj is not None:
            self._forget_ghost()
            self.found.add(task.obj, task.outcome.report)
        else:
            self._show_at(task, task.outcome.farthest())
            self.beside.mark(task.outcome.report["escape"]["blockers"])

    def _forget_ghost(self):
        if self.ghost is not None:
            self.ghost.remove()
            self.ghost = None

    # --- task panel

    def getStandardButtons(self):
        return widgets.standard_buttons(QtWidgets.QDialogButtonBox.Close)

    def modifyStandardButtons(self, box):
        """The button that starts is one of the form."""
        widgets.forget_with(box)

    def reject(self):
        """Close: stops what still runs; the paths that were found stay."""
        self.watch.stop()
        self.looks.stop()
        if self.run is not None:
            self.run.ended.disconnect(self.ended)
            self.run.cancel()
            self.run = None
        if widgets.alive(self.document):
            self._forget_ghost()
        Gui.Control.closeDialog()
        return True


def show(document, **given):
    panel = FindPathPanel(document, **given)
    focus.show(panel)
    return panel
