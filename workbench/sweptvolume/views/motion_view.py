# SPDX-License-Identifier: LGPL-2.1-or-later
"""Drawing of a motion: the path of its poses as a line, with a small frame at each pose."""
from ..convert import InputProblem
from ..features.motion import STALE, poses_of
from ..features.motion_source import has_settings
from ..texts import QT_TRANSLATE_NOOP, translate
from . import path
from .base import View, run_command, shown_icon


class MotionView(View):
    """View provider of the motion."""

    COUNTER = "Count"
    EDITOR = "SweptVolume_EditMotion"

    def __init__(self, view):
        super().__init__(view)
        self.add_properties(view)

    def add_properties(self, view):
        if "FrameSize" not in view.PropertiesList:
            text = QT_TRANSLATE_NOOP(
                "App::Property",
                "Length of the axes drawn at each pose (mm). 0: chosen automatically",
            )
            view.addProperty("App::PropertyFloat", "FrameSize", "Path", text)
        if "PathWidth" not in view.PropertiesList:
            text = QT_TRANSLATE_NOOP(
                "App::Property", "Width of the line that shows the motion (pixels)"
            )
            view.addProperty("App::PropertyFloat", "PathWidth", "Path", text)
            view.PathWidth = 3.0

    def attach(self, view):
        super().attach(view)
        self.add_properties(view)
        self.path_lines = path.PathLines()
        view.addDisplayMode(self.path_lines.root, "Path")
        self.draw(view.Object)

    def getDisplayModes(self, view):
        return ["Path"]

    def getDefaultDisplayMode(self):
        return "Path"

    def setDisplayMode(self, mode):
        return mode

    def updateData(self, obj, name):
        if name in ("Times", "Placements", "Interpolation", "Tangents", "Velocities", "Pivot"):
            self.draw(obj)
        super().updateData(obj, name)

    def onChanged(self, view, name):
        if name in ("FrameSize", "PathWidth"):
            self.draw(view.Object)

    def draw(self, obj):
        if not hasattr(self, "path_lines") or "Placements" not in obj.PropertiesList:
            return
        try:
            poses = poses_of(obj)
        except InputProblem:  # times and placements are set one after the other
            return
        view = obj.ViewObject
        width, size = getattr(view, "PathWidth", 3.0), getattr(view, "FrameSize", 0)
        self.path_lines.show(poses, obj.Interpolation, width, size)

    def getIcon(self):
        status = getattr(self.Object, "Status", "")
        if status == STALE:
            return shown_icon("SweptVolume_Motion_stale")
        broken = status and len(self.Object.Placements)
        return shown_icon("SweptVolume_Motion_failed" if broken else "SweptVolume_Motion")

    def setupContextMenu(self, view, menu):
        obj = view.Object
        for text, name in (
            (translate("SweptVolume", "Edit motion"), "SweptVolume_EditMotion"),
            (translate("SweptVolume", "Settings of the source"), "SweptVolume_EditSource"),
            (translate("SweptVolume", "Reload motion"), "SweptVolume_ReloadMotion"),
            (translate("SweptVolume", "Improve path"), "SweptVolume_ImprovePath"),
            (translate("SweptVolume", "Find path"), "SweptVolume_FindPath"),
            (translate("SweptVolume", "Create envelope"), "SweptVolume_Envelope"),
            (translate("SweptVolume", "Check clearance"), "SweptVolume_Clearance"),
        ):
            if name == "SweptVolume_EditSource" and not has_settings(obj):
                continue
            if name == "SweptVolume_ReloadMotion" and obj.SourceType == "Stored":
                continue
            self.add_menu(menu, text, name, lambda name=name: run_command(obj, name))
