# SPDX-License-Identifier: LGPL-2.1-or-later
"""Base of the commands: resources, when a command is active, and how problems are shown."""
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
    _reason, _tip = "", None

    def GetResources(self):
        resources = {
            "Pixmap": icon(self.ICON or self.NAME),
            "MenuText": translate("SweptVolume", self.TEXT),
            "ToolTip": translate("SweptVolume", self.TIP),
        }
        if self.ACCEL:
            resources["Accel"] = self.ACCEL
        if self.KIND:
            resources["CmdType"] = self.KIND
        return resources

    def missing(self, document):
        """Returns the text about what is missing for the command, or "" if it can run. Must be
        fast, because FreeCAD calls it very often."""
        return ""

    def IsActive(self):
        if Gui.Control.activeDialog():
            return False
        reason = ""
        if self.NEEDS_DOCUMENT:
            document = App.ActiveDocument
            reason = translate("SweptVolume", "Open a document first.")
            if document is not None:
                reason = self.missing(document)
        self._explain(reason)
        return not reason

    def _explain(self, reason):
        """Shows in the tool tip why the command is disabled."""
        if reason == self._reason:
            return
        self._reason = reason
        from ..panels.widgets import actions_of

        for action in actions_of(self.NAME):
            if self._tip is None:
                self._tip = action.toolTip()
            text = reason.replace("<", "&lt;")
            action.setToolTip("{}<p><b>{}</b></p>".format(self._tip, text) if text else self._tip)

    def Activated(self):
        from ..panels import core_dialog
        from ..panels.widgets import warn

        try:
            self.run(App.ActiveDocument)
        except core.CoreMissing:
            core_dialog.offer()
        except (InputProblem, core.CoreError) as problem:
            warn(translate("SweptVolume", self.TEXT), str(problem))

    def run(self, document):
        raise NotImplementedError
