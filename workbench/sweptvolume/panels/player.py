# SPDX-License-Identifier: LGPL-2.1-or-later
"""Play, pause, step and scrub through a motion: the slider of the path editor."""
from PySide import QtCore

from ..texts import translate
from . import widgets
from .widgets import QtWidgets

#: ms between two pictures while playing; steps of the slider.
FRAME_TIME, SLIDER = 40, 1000


class Player(QtWidgets.QGroupBox):
    """A time (s) between the first and the last of some keys; `moved` tells that it changed."""

    moved = QtCore.Signal()

    def __init__(self):
        super().__init__(translate("Panels", "Play"))
        self.times = []
        self.slider = QtWidgets.QSlider(QtCore.Qt.Horizontal)
        self.slider.setObjectName("SweptVolumeTime")
        self.slider.setRange(0, SLIDER)
        self.slider.setToolTip(translate("Panels", "Time: the green ghost shows the part there"))
        self.back = self._button("Back", "|<", translate("Panels", "To the key before"))
        self.play = self._button("Play", translate("Panels", "Pl&ay"), "")
        self.play.setCheckable(True)
        self.play.setToolTip(translate("Panels", "Plays in real time, or pauses"))
        self.forth = self._button("Forth", ">|", translate("Panels", "To the next key"))
        self.time = QtWidgets.QLabel()
        self.time.setAlignment(QtCore.Qt.AlignRight | QtCore.Qt.AlignVCenter)
        self.time.setMinimumWidth(self.fontMetrics().boundingRect("000.00 s").width())
        line = QtWidgets.QHBoxLayout(self)
        line.setContentsMargins(*widgets.MARGINS)
        line.setSpacing(4)
        for button in (self.back, self.forth):
            button.setFixedWidth(30)
        for widget in (self.back, self.play, self.forth):
            line.addWidget(widget)
        line.addWidget(self.slider, 1)
        line.addWidget(self.time)
        self.timer = QtCore.QTimer(self)
        self.timer.timeout.connect(self._advance)
        self.slider.valueChanged.connect(self._slid)
        self.play.toggled.connect(self._toggle)
        self.back.clicked.connect(lambda *ignored: self.step(-1))
        self.forth.clicked.connect(lambda *ignored: self.step(1))

    def _button(self, name, text, tip):
        button = QtWidgets.QPushButton(text)
        button.setObjectName("SweptVolume" + name)
        button.setToolTip(tip)
        return button

    def set_times(self, times):
        """The times of the keys (s)."""
        self.times = list(times)
        self._slid()

    def now(self):
        """The time that is shown (s)."""
        if not self.times:
            return 0.0
        first, last = self.times[0], self.times[-1]
        return first + (last - first) * self.slider.value() / SLIDER

    def go_to(self, time):
        span = self.times[-1] - self.times[0] if self.times else 0.0
        part = (time - self.times[0]) / span if span > 0 else 0.0
        self.slider.setValue(int(round(part * SLIDER)))

    def step(self, by):
        """To the next key before or after the time that is shown."""
        now = self.now()
        half = 0.5 * (self.times[-1] - self.times[0]) / SLIDER if self.times else 0.0
        ahead = [t for t in self.times if (t - now) * by > half]
        if ahead:
            self.go_to(min(ahead) if by > 0 else max(ahead))

    def _slid(self, *ignored):
        self.time.setText("{:.2f} s".format(self.now()))
        self.moved.emit()

    def _toggle(self, on):
        self.play.setText(translate("Panels", "P&ause") if on else translate("Panels", "Pl&ay"))
        if on and len(self.times) > 1:
            if self.slider.value() >= SLIDER:
                self.slider.setValue(0)
            self.timer.start(FRAME_TIME)
        else:
            self.timer.stop()
            self.play.setChecked(False)

    def _advance(self):
        span = max(self.times[-1] - self.times[0], 1e-9)
        step = max(1, int(round(SLIDER * FRAME_TIME / 1000.0 / span)))
        self.slider.setValue(min(SLIDER, self.slider.value() + step))
        if self.slider.value() >= SLIDER:
            self.play.setChecked(False)

    def stop(self):
        self.timer.stop()
