# SPDX-License-Identifier: LGPL-2.1-or-later
"""FreeCAD's own dragger (arrows and arcs) for one placement in the 3D view. Not part of any
document."""
import math

import FreeCAD as App
import FreeCADGui as Gui
from PySide import QtCore, QtGui

try:
    from PySide import QtWidgets
except ImportError:  # in FreeCAD 0.20, the module PySide has the widgets in QtGui
    QtWidgets = QtGui

#: Names of FreeCAD's dragger, newest first. Without it, Coin's dragger is used.
_NAMES = ("SoTransformDragger", "SoFCCSysDragger")
#: Size of the dragger as a fraction of the part's diagonal: its arrows end a little outside a cube.
SIZE = 0.4
#: Interval (ms) between two checks of the dragger's placement. The dragger itself follows the
#: mouse; the panel decides how often its own drawing is updated.
POLL = 30


class PoseDragger:
    """Shows a dragger at a placement. Calls moved(placement) while the user drags it, and
    dropped(placement) at the end."""

    def __init__(self, document, size, moved, dropped):
        from pivy import coin

        self.graph = Gui.getDocument(document.Name).activeView().getSceneGraph()
        self.root = coin.SoSeparator()
        self.switch = coin.SoSwitch()
        self.node = _make(coin)
        self.own = self.node.getField("translationIncrement") is not None
        #: Distance from the middle (mm) at which the user can grasp an arrow; FreeCAD's arrows are
        #: 9 to 10 units long.
        self.arrow = SIZE * size * 0.93
        if self.node.getField("draggerSize") is not None:
            self.node.getField("draggerSize").setValue(SIZE * size / 10.0)
        self.switch.addChild(self.node)
        self.root.addChild(self.switch)
        self.graph.addChild(self.root)
        # A timer polls the dragger. Callbacks are not possible: pivy would call Python from mouse
        # events without the interpreter lock, which crashes the program.
        self.moved, self.dropped, self.last, self.dragging = moved, dropped, None, False
        self.timer = QtCore.QTimer()
        self.timer.timeout.connect(self._poll)
        self.hide()

    def _poll(self):
        now = self._fields()
        if now != self.last:
            self.last, self.dragging = now, True
            self.moved(self.placement())
        elif self.dragging and QtWidgets.QApplication.mouseButtons() == QtCore.Qt.NoButton:
            self.dragging = False
            self.dropped(self.placement())

    def _fields(self):
        names = ("translation", "rotation")
        return [tuple(self.node.getField(n).getValue().getValue()) for n in names]

    def snap(self, millimetres, degrees):
        """Sets the steps of arrows and arcs; 0: almost continuous."""
        if self.own:
            self.node.getField("translationIncrement").setValue(max(millimetres, 1e-3))
            self.node.getField("rotationIncrement").setValue(math.radians(max(degrees, 1e-2)))

    def show(self, placement):
        x, y, z = placement.Base
        self.node.getField("translation").setValue(x, y, z)
        self.node.getField("rotation").setValue(*placement.Rotation.Q)
        for name in ("X", "Y", "Z"):
            for kind in ("translation", "rotation"):
                count = self.node.getField("{}IncrementCount{}".format(kind, name))
                if count is not None:
                    count.setValue(0)
        self.switch.whichChild = 0
        self.last, self.dragging = self._fields(), False
        self.timer.start(POLL)

    def hide(self):
        self.switch.whichChild = -1
        self.timer.stop()

    def placement(self):
        """Returns the present placement of the dragger."""
        at, turn = self._fields()
        return App.Placement(App.Vector(*at), App.Rotation(*turn))

    def remove(self):
        self.timer.stop()
        if self.root is not None:
            self.graph.removeChild(self.root)
            self.root = None


def _make(coin):
    for name in _NAMES:
        kind = coin.SoType.fromName(name)
        if not kind.isBad():
            return kind.createInstance()
    return coin.SoTransformerDragger()
