# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the commands share: resources, when they are active, and how problems are shown."""
import FreeCAD as App
import FreeCADGui as Gui

from .. import core, icon
from ..convert import InputProblem
from ..texts import translate


class BaseCommand:
    """Subclasses give NAME, TEXT, TIP (marked for translation), ICON, ACCEL, KIND (CmdType) and run()."""

    NAME = ""
    TEXT = ""
    TIP = ""
    ICON = ""
    ACCEL = ""
    KIND = ""
    NEEDS_DOCUMENT = True

    def GetResources(self):
        resources = {
            "Pixmap": icon(self.ICON or self.NAME),
            "MenuText": translate("Commands", self.TEXT),
            "ToolTip": translate("Commands", self.TIP),
        }
        if self.ACCEL:
            resources["Accel"] = self.ACCEL
        if self.KIND:
            resources["CmdType"] = self.KIND
        return resources

    def IsActive(self):
        if Gui.Control.activeDialog():
            return False
        return App.ActiveDocument is not None or not self.NEEDS_DOCUMENT

    def Activated(self):
        from ..panels.widgets import warn

        try:
            self.run(App.ActiveDocument)
        except (InputProblem, core.CoreError, core.CoreMissing) as problem:
            warn(translate("Commands", self.TEXT), str(problem))

    def run(self, document):
        raise NotImplementedError
