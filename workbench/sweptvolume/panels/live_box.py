# SPDX-License-Identifier: LGPL-2.1-or-later
"""Live clearance in the motion editor: the distance of the dragged part from its neighbours, and
whether it stops at them."""
import time

from PySide import QtCore

from .. import contents, quantities
from ..convert import InputProblem, matrix_of
from ..features import path_plan
from ..features.moving import middle_of
from ..features.path_plan import placement_of
from ..texts import translate
from ..trajectory.poses import shift_to
from ..views.live_distance import LiveDistance
from . import shades, widgets
from .live_clearance import LiveClearance, VisibleScene
from .widgets import QtWidgets


#: Time (s) after a request during which the neighbours are not compared again, because nobody
#: changes them during a drag.
PAUSE = 0.5


class LiveBox(QtCore.QObject):
    """Signal `reached(row, placement, last)` answers reach(): the part of key `row` may go to
    `placement`. last: there is no newer request."""

    reached = QtCore.Signal(int, object, bool)
    #: Whether the part clashes at its present placement.
    clashes = QtCore.Signal(bool)

    def __init__(self, document, rows):
        super().__init__()
        self.document, self.live, self.drawn = document, None, None
        self.pair, self.body, self.row, self.failed = None, None, -1, False
        self._read = None  # contents of the neighbours when they were read
        self._asked = 0.0  # time of the last request
        self.show_box = QtWidgets.QCheckBox(
            translate("SweptVolume", "Show the clearance while dragging")
        )
        self.show_box.setObjectName("SweptVolumeLive")
        self.show_box.setChecked(True)
        self.stop_box = widgets.hint(
            QtWidgets.QCheckBox(translate("SweptVolume", "Stop at contact")),
            translate(
                "SweptVolume",
                "Stops the dragged key where the part would touch a neighbour. All "
                "other visible parts are neighbours",
            ),
        )
        self.stop_box.setObjectName("SweptVolumeStopAtContact")
        self.text = widgets.message_label()
        self.text.setObjectName("SweptVolumeLiveText")
        for widget in (self.show_box, self.stop_box, self.text):
            rows.addRow(widget)
            widget.setEnabled(False)
        for box in (self.show_box, self.stop_box):
            box.toggled.connect(lambda *ignored: self._forget())

    def begin(self, pair, body):
        """Sets the part (convert.Body at its present placement) whose keys are dragged."""
        self.pair, self.body = pair, body
        self.middle = shift_to(middle_of([pair], body.placement))
        for widget in (self.show_box, self.stop_box, self.text):
            widget.setEnabled(True)

    def stops(self):
        """Returns whether the part stops at its neighbours, as reach() reports."""
        return self.stop_box.isEnabled() and self.stop_box.isChecked() and self._begun()

    def follow(self, world, at):
        """Measures the part at a placement (world coordinates). at: position of the number in the
        view."""
        if self.show_box.isEnabled() and self.show_box.isChecked() and self._begun():
            self.at = at
            self.live.want(None, self._matrix(world))

    def reach(self, row, before, world, at):
        """Asks how far the part of a key may move from `before` towards `world`."""
        self.row, self.at = row, at
        self.live.want(self._matrix(before), self._matrix(world), stop=True)

    def _begun(self):
        """Returns whether there is a part with neighbours to measure. Reads the neighbours if they
        were not read or have changed."""
        if self.pair is not None and time.monotonic() - self._asked > PAUSE:
            stands = self._stands()
            if stands != self._read:
                self._forget()
                self._read = stands
        self._asked = time.monotonic()
        if self.live is None and self.pair is not None and not self.failed:
            frame = matrix_of(self.body.placement.multiply(self.middle).inverse())
            try:
                scene = VisibleScene(self.document, self.pair, frame)
                self.live = LiveClearance(self.document, scene, self._answered, self._failed)
            except InputProblem as problem:  # there is no neighbour
                self._failed(str(problem))
        return self.live is not None

    def _stands(self):
        """Returns what identifies the neighbours and their placements, for comparison, or None if
        there are none."""
        try:
            return contents.words(path_plan.beside(self.document, [self.pair]).leaves())
        except InputProblem:
            return None

    def _matrix(self, world):
        return matrix_of(world.multiply(self.middle))

    def _answered(self, answer):
        text = translate("SweptVolume", "{0} to {1}")
        clash = answer.distance <= 0
        if clash:
            text = translate("SweptVolume", "Clash with {1}")
        elif answer.distance <= self.live.scene.chord:
            text = translate("SweptVolume", "Contact with {1} ({0})")
        text = text.format(quantities.quantity(answer.distance), answer.name)
        self.clashes.emit(clash)
        widgets.show_message(self.text, text)
        style = "color: {}; font-weight: bold;".format(shades.alarm(self.text))
        self.text.setStyleSheet(style if clash else "")
        if self.show_box.isChecked():
            if self.drawn is None:
                self.drawn = LiveDistance(self.document)
            self.drawn.show(self.at, text.split(" (")[:1], answer.points, clash)
        if self.row >= 0:
            place = placement_of(answer.matrix)
            last = answer.number == self.live.number
            self.reached.emit(self.row, place.multiply(self.middle.inverse()), last)

    def _failed(self, text):
        widgets.show_message(self.text, text)
        self.failed = True  # do not ask again

    def quiet(self):
        """Removes the drawing when no key is dragged."""
        self.row = -1
        self.clashes.emit(False)
        if self.drawn is not None:
            self.drawn.hide()
        widgets.show_message(self.text, "")

    def _forget(self):
        """Forgets the neighbours, so that they are read again."""
        if self.live is not None:
            self.live.stop()
            self.live = None
        self.failed = False
        self.quiet()

    def remove(self):
        if self.live is not None:
            self.live.stop()
        if self.drawn is not None:
            self.drawn.remove()
