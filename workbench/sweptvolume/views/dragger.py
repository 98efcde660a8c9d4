# SPDX-License-Identifier: LGPL-2.1-or-later
"""FreeCAD's own dragger (arrows and arcs) for one placement in the 3D view, part of no document."""
import math

import FreeCAD as App
import FreeCADGui as Gui
from PySide import QtCore, QtGui

try:
    from PySide import QtWidgets
except ImportError:  # FreeCAD 0.20: its shim keeps the widgets in QtGui
    QtWidgets = QtGui

#: Names of FreeCAD's dragger, newest first; Coin's stands in where there is none.
_NAMES = ("SoTransformDragger", "SoFCCSysDragger")
#: Share of the diagonal of the part that the dragger takes: its arrows end a little outside a cube.
SIZE = 0.4
#: ms between two looks at where the dragger is. It follows the mouse by itself; how often what follows
#: it is drawn is the panel's business.
POLL = 30


class PoseDragger:
    """Shows a dragger at a placement; calls moved(placement) while it is dragged and dropped(placement)
    when it is let go."""

    def __init__(self, document, size, moved, dropped):
        from pivy import coin

        self.graph = Gui.getDocument(document.Name).activeView().getSceneGraph()
        self.root = coin.SoSeparator()
        self.switch = coin.SoSwitch()
        self.node = _make(coin)
        self.own = self.node.getField("translationIncrement") is not None
        #: Where an arrow can be grasped (mm from the middle): FreeCAD's own are 9 to 10 units long.
        self.arrow = SIZE * size * 0.93
        if self.node.getField("draggerSize") is not None:
            self.node.getField("draggerSize").setValue(SIZE * size / 10.0)
        self.switch.addChild(self.node)
        self.root.addChild(self.switch)
        self.graph.addChild(self.root)
        # Looked at, not called back: pivy calls Python from the mouse's events without the
        # interpreter's lock, which ends the program.
        self.moved, self.dropped, self.last, self.dragging = moved, dropped, None, False
        self.timer = QtCore.QTimer()
        self.timer.timeout.connect(self._look)
        self.hide()

    def _look(self):
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
        """Steps of the arrows and arcs; 0: nearly none."""
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
        """Where the dragger is now."""
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
