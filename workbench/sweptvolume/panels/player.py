# SPDX-License-Identifier: LGPL-2.1-or-later
"""Player of a motion: play, pause, step, and slider. Part of the motion editor."""
from PySide import QtCore

from ..texts import translate
from . import widgets
from .widgets import QtWidgets

#: Interval (ms) between two pictures during play; number of steps of the slider.
FRAME_TIME, SLIDER = 40, 1000
#: Seconds of the motion for each second of playing.
SPEEDS = (0.1, 0.25, 0.5, 1.0, 2.0, 5.0, 10.0)


class Player(QtWidgets.QGroupBox):
    """A time (s) between the first and the last key. Signal `moved`: the time has changed."""

    moved = QtCore.Signal()

    def __init__(self):
        super().__init__(translate("SweptVolume", "Play"))
        self.times, self.moment, self.moving = [], 0.0, False
        self.clock = QtCore.QElapsedTimer()
        self.slider = QtWidgets.QSlider(QtCore.Qt.Horizontal)
        self.slider.setObjectName("SweptVolumeTime")
        self.slider.setRange(0, SLIDER)
        self.slider.setToolTip(
            translate(
                "SweptVolume", "Time of the motion. A green ghost shows the part at this time"
            )
        )
        self.back = self._button("Back", "|<", translate("SweptVolume", "Goes to the previous key"))
        self.play = self._button("Play", translate("SweptVolume", "Pl&ay"), "")
        self.play.setCheckable(True)
        self.play.setToolTip(
            translate("SweptVolume", "Plays the motion, or pauses it. Speed 1 is real time")
        )
        self.forth = self._button("Forth", ">|", translate("SweptVolume", "Goes to the next key"))
        self.time = QtWidgets.QLabel()
        self.time.setAlignment(QtCore.Qt.AlignRight | QtCore.Qt.AlignVCenter)
        self.time.setMinimumWidth(self.fontMetrics().boundingRect("000.00 s").width())
        self.speed = widgets.choice(SPEEDS, 1.0, ["x {:g}".format(speed) for speed in SPEEDS])
        self.speed.setObjectName("SweptVolumeSpeed")
        self.speed.setMinimumContentsLength(4)
        self.speed.setToolTip(
            translate("SweptVolume", "Speed: seconds of the motion in one second of playback")
        )
        self.loop = QtWidgets.QCheckBox(translate("SweptVolume", "Loop"))
        self.loop.setObjectName("SweptVolumeLoop")
        self.loop.setToolTip(
            translate("SweptVolume", "Starts again from the beginning when the end is reached")
        )
        column = QtWidgets.QVBoxLayout(self)
        column.setContentsMargins(*widgets.MARGINS)
        column.setSpacing(4)
        above, middle, below = (QtWidgets.QHBoxLayout() for _ in range(3))
        # Slider and buttons have separate rows, because the buttons of some themes are wide.
        above.addWidget(self.slider, 1)
        above.addWidget(self.time)
        for button in (self.back, self.forth):
            button.setFixedWidth(30)
        for row, widgets_in_row in (
            (middle, (self.back, self.play, self.forth)),
            (below, (self.speed, self.loop)),
        ):
            for widget in widgets_in_row:
                row.addWidget(widget)
            row.addStretch(1)
        for row in (above, middle, below):
            column.addLayout(row)
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
        """Sets the times of the keys (s)."""
        self.times = list(times)
        self._show_time()

    def now(self):
        """Returns the time that is shown (s)."""
        if not self.times:
            return 0.0
        return min(max(self.moment, self.times[0]), self.times[-1])

    def go_to(self, time):
        span = self.times[-1] - self.times[0] if self.times else 0.0
        part = (time - self.times[0]) / span if span > 0 else 0.0
        self.moment, self.moving = time, True
        self.slider.setValue(int(round(part * SLIDER)))
        self.moving = False
        self._show_time()

    def step(self, by):
        """Goes to the next key (1) or the previous key (-1)."""
        now = self.now()
        half = 0.5 * (self.times[-1] - self.times[0]) / SLIDER if self.times else 0.0
        ahead = [t for t in self.times if (t - now) * by > half]
        if ahead:
            self.go_to(min(ahead) if by > 0 else max(ahead))

    def _slid(self, value):
        """Handles a move of the slider by the user."""
        if not self.moving and self.times:
            first, last = self.times[0], self.times[-1]
            self.moment = first + (last - first) * value / SLIDER
            self._show_time()

    def _show_time(self):
        self.time.setText("{:.2f} s".format(self.now()))
        self.moved.emit()

    def _toggle(self, on):
        self.play.setText(
            translate("SweptVolume", "P&ause") if on else translate("SweptVolume", "Pl&ay")
        )
        if on and len(self.times) > 1:
            if self.now() >= self.times[-1]:
                self.go_to(self.times[0])
            self.clock.start()
            self.timer.start(FRAME_TIME)
        else:
            self.timer.stop()
            self.play.setChecked(False)

    def _advance(self):
        """Advances by the time that has passed, so that slow pictures do not slow down the motion."""
        first, last = self.times[0], self.times[-1]
        after = self.now() + self.clock.restart() / 1000.0 * self.speed.currentData()
        if after < last:
            self.go_to(after)
        elif self.loop.isChecked() and last > first:
            self.go_to(first + (after - first) % (last - first))
        else:
            self.go_to(last)
            self.play.setChecked(False)

    def stop(self):
        self.timer.stop()
