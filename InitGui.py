# SPDX-License-Identifier: LGPL-2.1-or-later
"""The workbench class. Its methods cannot see names at the top of this file, so they import them."""
import FreeCADGui


class SweptVolumeWorkbench(FreeCADGui.Workbench):
    """Swept envelopes of moving parts."""

    def __init__(self):
        import sweptvolume
        from sweptvolume.texts import translate

        self.__class__.MenuText = translate("SweptVolume", "Swept Volume")
        self.__class__.ToolTip = translate(
            "SweptVolume",
            "The space that moving parts need: motions, swept envelopes, solids, STEP",
        )
        self.__class__.Icon = sweptvolume.icon("SweptVolumeWorkbench")

    def Initialize(self):
        from sweptvolume import commands

        commands.load()
        commands.register()
        commands.fill_workbench(self)
        # The first UiLoader searches for plug-ins, which takes 16 ms. Created here, so that no panel
        # has to wait for it.
        FreeCADGui.UiLoader()

    def Activated(self):
        from sweptvolume import core
        from sweptvolume.panels import core_dialog

        core.warn_if_missing()
        core_dialog.offer_once()

    def ContextMenu(self, recipient):
        from sweptvolume import commands

        commands.fill_context_menu(self, recipient)

    def GetClassName(self):
        return "Gui::PythonWorkbench"


import sweptvolume  # noqa: E402 (found on the path that Init.py prepared)

FreeCADGui.addLanguagePath(sweptvolume.resource("translations"))
FreeCADGui.updateLocale()
FreeCADGui.addIconPath(sweptvolume.resource("icons"))
FreeCADGui.addPreferencePage(sweptvolume.resource("ui", "preferences.ui"), "Swept Volume")
FreeCADGui.addWorkbench(SweptVolumeWorkbench())
