# SPDX-License-Identifier: LGPL-2.1-or-later
"""Task panel "What made this?": colours an envelope. After a click on the envelope, shows the face
of the part that created this point, and the part at that moment. Only remember() changes the
document."""
import FreeCADGui as Gui
from PySide import QtCore

from .. import convert
from ..convert import InputProblem
from ..features import made_by
from ..features.base import UP_TO_DATE
from ..features.envelope_plan import STRAIGHT, Plan
from ..texts import translate
from ..trajectory.poses import INTERPOLATIONS, at_time
from ..views.ghost import Ghosts
from ..views.made_colours import CHOICES
from . import focus, guard, widgets
from .place_picker import PlacePicker
from .player import Player
from .run_panel import StayingPanel
from .tasks import EnvelopeTask
from .widgets import QtWidgets

#: Deflection of the parts for the ghost, as a fraction of their box diagonal.
GHOST_DEFLECTION = 0.003

#: The panel opened last, for tests and macros.
opened = []


def _stale_note():
    return translate(
        "SweptVolume",
        "The envelope is stale: the information shown belongs to its earlier parts and motion. "
        "Recompute the envelope to update the information.",
    )


class _MovingParts:
    """Draws the parts of one motion as a ghost."""

    def __init__(self, document, group, cell):
        self.poses, kind = group.trajectory(STRAIGHT * cell)
        self.kind = next(name for name, known in INTERPOLATIONS.items() if known == kind)
        points = group.corners()
        size = float(((points.max(axis=0) - points.min(axis=0)) ** 2).sum()) ** 0.5
        body = convert.body_from(group.pairs, max(size * GHOST_DEFLECTION, 1e-6))
        vertices = convert.transform(group.into_base(), body.vertices)
        self.ghosts = Ghosts(document, vertices, body.triangles)
        self.ghosts.show_keys([])

    def show(self, time):
        self.ghosts.show_moving(at_time(self.poses, self.kind, time))

    def remove(self):
        self.ghosts.remove()


class MadePanel(StayingPanel):
    """Shows one envelope."""

    def __init__(self, document, obj):
        self.document, self.obj, self.run = document, obj, None
        self.answer, self.moving, self.motion = None, None, ""
        title = translate("SweptVolume", "What made this?")
        self.form, layout = widgets.window(title, "SweptVolume_MadeBy")
        self.box, self.message = widgets.RunBox(), widgets.message_label()
        layout.addWidget(self.box)
        layout.addWidget(self.message)
        self._build_colours(layout)
        self._build_answer(layout)
        self.player = Player()
        self.player.moved.connect(self.show_moving)
        layout.addWidget(self.player)
        layout.addStretch(1)
        Gui.Selection.clearSelection()  # the colour of the selection would cover the others
        self.picker = PlacePicker(document, self.found)
        self.watch = self.watched()
        self.renew()

    # --- building

    def _build_colours(self, layout):
        rows = widgets.group(self.obj.Label, layout)
        self.by = widgets.choice(CHOICES, self.obj.ViewObject.ColourBy)
        self.by.setObjectName("SweptVolumeColourBy")
        self.by.currentIndexChanged.connect(lambda *ignored: self._colour())
        self.again = QtWidgets.QPushButton(translate("SweptVolume", "Compute and record"))
        self.again.setObjectName("SweptVolumeRemember")
        self.again.clicked.connect(lambda *ignored: self.remember())
        rows.addRow(translate("SweptVolume", "Colour by"), self.by)
        rows.addRow(self.again)

    def _build_answer(self, layout):
        box = QtWidgets.QGroupBox(translate("SweptVolume", "Clicked place"))
        column = QtWidgets.QVBoxLayout(box)
        column.setContentsMargins(*widgets.MARGINS)
        self.text = QtWidgets.QLabel()
        self.text.setObjectName("SweptVolumeMadeText")
        self.text.setWordWrap(True)
        self.text.setTextInteractionFlags(QtCore.Qt.TextSelectableByMouse)
        self.choose = QtWidgets.QPushButton(translate("SweptVolume", "Select on the part"))
        self.choose.setObjectName("SweptVolumeSelectFace")
        self.choose.clicked.connect(lambda *ignored: self.select())
        column.addWidget(self.text)
        column.addWidget(self.choose)
        layout.addWidget(box)

    # --- what is known

    def renew(self):
        """Shows whether there is a record."""
        known = made_by.find(self.obj) is not None
        self.by.setEnabled(known)
        self.again.setVisible(not known)
        self.answer = None
        self.choose.setEnabled(False)
        self._remove_parts()
        self.note_state()
        self.text.setText(
            translate("SweptVolume", "Click a place of the envelope in the 3D view.")
            if known
            else translate(
                "SweptVolume",
                "This envelope has no record of what made it. Either nothing was recorded, or "
                "the record was lost when the document was closed: press Compute and record.",
            )
        )
        self.player.setEnabled(False)

    def show_result(self):
        """Shows another state of the envelope. The answer for the clicked point stays, marked as
        outdated, until the envelope is computed again."""
        if self.obj is None:
            self.reject()
        elif self.answer is None or self.obj.Status == UP_TO_DATE:
            self.renew()
        else:
            self.note_state()
            self._show_answer()

    def _colour(self):
        self.obj.ViewObject.ColourBy = self.by.currentData()

    @guard.shows_problems
    def remember(self):
        """Computes the envelope again with the same inputs, and records what made it."""
        if self.obj.Offset.Value > 0 or self.obj.Conservative:
            raise InputProblem(
                translate(
                    "SweptVolume",
                    "If an envelope has an offset or is conservative, the faces that made it "
                    "cannot be recorded: set Offset to 0 and switch Conservative off.",
                )
            )
        plan = Plan.of(self.obj)
        if plan.values["MadeBy"] == "Off":
            plan.values["MadeBy"] = "Session"
        if self.begin(lambda: EnvelopeTask(self.document, plan, self.obj), self.ended):
            self.again.setEnabled(False)

    def ended(self, run):
        self.run = None
        if not (widgets.alive(self.document) and widgets.alive(self.obj)):
            self.reject()
            return
        self.box.leave(self.form)
        self.again.setEnabled(True)
        if run.state != "ok":
            widgets.show_failure(self.message, run)
        self.renew()

    # --- a click

    @guard.shows_problems
    def found(self, obj, answer):
        """Handles a click on a point of an envelope."""
        if obj.Name != self.obj.Name or made_by.find(self.obj) is None:
            return
        self.answer = answer
        if answer is not None:
            text = made_by.text_of(answer)
            Gui.getMainWindow().statusBar().showMessage(text.replace("\n", ", "))
            self._show_answer()
            return
        self.choose.setEnabled(False)
        self.text.setText(
            translate(
                "SweptVolume", "It is not known what made this place: click a point beside it."
            )
        )

    def _show_answer(self):
        text, current = made_by.text_of(self.answer), self.obj.Status == UP_TO_DATE
        self.text.setText(text if current else text + "\n" + _stale_note())
        for widget in (self.choose, self.player):
            widget.setEnabled(current)
        if current:
            self._show_parts(self.answer.motion)
            self.player.go_to(self.answer.time)
        else:  # the motion may no longer pass there
            self._remove_parts()

    def _show_parts(self, motion):
        if self.motion == motion:
            return
        self._remove_parts()
        plan = Plan.of(self.obj)
        group = next(g for g in plan.groups() if g.motion.Name == motion)
        self.moving, self.motion = _MovingParts(self.document, group, self.cell()), motion
        self.player.setEnabled(True)
        self.player.set_times(self.moving.poses.times)

    def cell(self):
        return self.obj.UsedCellSize.Value

    def show_moving(self):
        if self.moving is not None:
            self.moving.show(self.player.now())

    @guard.shows_problems
    def select(self):
        """Selects the face, or the two faces at the edge, on the part at its present placement."""
        Gui.Selection.clearSelection()
        for part, number in self.answer.faces:
            element = "" if part["facets"] else "Face{}".format(number)
            Gui.Selection.addSelection(self.document.Name, part["root"], part["sub"] + element)

    def _remove_parts(self):
        if self.moving is not None and widgets.alive(self.document):
            self.moving.remove()
        self.moving, self.motion = None, ""

    def leave(self):
        self.picker.stop()
        self.player.stop()
        self._remove_parts()


def show(document, obj):
    panel = MadePanel(document, obj)
    opened[:] = [panel]
    focus.show(panel)
    return panel
