# SPDX-License-Identifier: LGPL-2.1-or-later
"""How a motion looks: the path of its poses as a line, with a small frame at each pose."""
import FreeCAD as App
import numpy as np

from .. import icon
from ..convert import pose_arrays
from ..texts import mark, translate
from ..trajectory.poses import Poses, at_time
from .base import View, run_command

LINE = (0.85, 0.45, 0.05)
AXES = ((0.85, 0.15, 0.15), (0.15, 0.65, 0.15), (0.20, 0.35, 0.90))
#: Points drawn between two poses, and the most poses that get a frame.
BETWEEN, MOST_FRAMES = 8, 200


class MotionView(View):
    """View provider of the motion."""

    def __init__(self, view):
        super().__init__(view)
        self.add_properties(view)

    def add_properties(self, view):
        if "FrameSize" not in view.PropertiesList:
            text = mark("Properties", "Length of the axes drawn at each pose (mm); 0: automatic")
            view.addProperty(
                "App::PropertyFloat", "FrameSize", "Path", translate("Properties", text)
            )
        if "PathWidth" not in view.PropertiesList:
            text = mark("Properties", "Width of the path line (pixels)")
            view.addProperty(
                "App::PropertyFloat", "PathWidth", "Path", translate("Properties", text)
            )
            view.PathWidth = 3.0

    def attach(self, view):
        from pivy import coin

        super().attach(view)
        self.add_properties(view)
        self.root = coin.SoSeparator()
        view.addDisplayMode(self.root, "Path")
        self.draw(view.Object)

    def getDisplayModes(self, view):
        return ["Path"]

    def getDefaultDisplayMode(self):
        return "Path"

    def setDisplayMode(self, mode):
        return mode

    def updateData(self, obj, name):
        if name in ("Times", "Placements", "Interpolation"):
            self.draw(obj)
        super().updateData(obj, name)

    def onChanged(self, view, name):
        if name in ("FrameSize", "PathWidth"):
            self.draw(view.Object)

    def draw(self, obj):
        if not hasattr(self, "root"):
            return
        self.root.removeAllChildren()
        if "Placements" not in obj.PropertiesList or not obj.Placements:
            return
        view = obj.ViewObject
        points = path_points(obj)
        size = getattr(view, "FrameSize", 0) or frame_size(obj)
        self.root.addChild(_line(points, LINE, getattr(view, "PathWidth", 3.0)))
        step = max(1, len(obj.Placements) // MOST_FRAMES)
        for axis in range(3):
            self.root.addChild(_axes(obj.Placements[::step], axis, size))

    def getIcon(self):
        return icon("SweptVolume_Motion")

    def doubleClicked(self, view):
        run_command(view.Object, "SweptVolume_EditMotion")
        return True

    def setupContextMenu(self, view, menu):
        obj = view.Object
        for text, name in (
            (translate("Commands", "Edit motion"), "SweptVolume_EditMotion"),
            (translate("Commands", "Reload motion"), "SweptVolume_ReloadMotion"),
            (translate("Commands", "Create envelope"), "SweptVolume_Envelope"),
        ):
            self.add_menu(menu, text, name, lambda name=name: run_command(obj, name))


def path_points(obj):
    """Points (n,3) of the path of the poses' origin as the part will move."""
    places = obj.Placements
    if len(places) < 2 or len(places) > 2000 or len(obj.Times) != len(places):
        return pose_arrays(places)[0]
    poses = Poses(obj.Times, places)
    fine = []
    for a, b in zip(poses.times, poses.times[1:]):
        fine += [a + (b - a) * k / BETWEEN for k in range(BETWEEN)]
    fine.append(poses.times[-1])
    return np.array([tuple(at_time(poses, obj.Interpolation, t).Base) for t in fine])


def frame_size(obj):
    points = pose_arrays(obj.Placements)[0]
    size = float((points.max(axis=0) - points.min(axis=0)).max()) if len(points) else 0.0
    return max(size * 0.05, 1.0)


def _line(points, colour, width):
    from pivy import coin

    group = coin.SoSeparator()
    shade, style = coin.SoBaseColor(), coin.SoDrawStyle()
    shade.rgb = colour
    style.lineWidth = width
    light = coin.SoLightModel()
    light.model = coin.SoLightModel.BASE_COLOR
    where, line = coin.SoCoordinate3(), coin.SoLineSet()
    where.point.setValues(0, len(points), [tuple(map(float, p)) for p in points])
    line.numVertices = len(points)
    for node in (light, shade, style, where, line):
        group.addChild(node)
    return group


def _axes(placements, axis, size):
    """One axis of all frames as one line set."""
    from pivy import coin

    direction = App.Vector(*[size if k == axis else 0.0 for k in range(3)])
    points = []
    for placement in placements:
        points += [tuple(placement.Base), tuple(placement.multVec(direction))]
    group = coin.SoSeparator()
    shade, style = coin.SoBaseColor(), coin.SoDrawStyle()
    shade.rgb = AXES[axis]
    style.lineWidth = 2.0
    light = coin.SoLightModel()
    light.model = coin.SoLightModel.BASE_COLOR
    where, lines = coin.SoCoordinate3(), coin.SoLineSet()
    where.point.setValues(0, len(points), points)
    lines.numVertices.setValues(0, len(placements), [2] * len(placements))
    for node in (light, shade, style, where, lines):
        group.addChild(node)
    return group
