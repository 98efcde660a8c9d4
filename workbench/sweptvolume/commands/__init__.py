# SPDX-License-Identifier: LGPL-2.1-or-later
"""The commands, one file each, registered here in the order of menu and toolbar."""
import FreeCADGui as Gui

from ..texts import QT_TRANSLATE_NOOP

#: Names of the modules in commands/. "" is a separator.
_MODULES = [
    "new_motion",
    "motion_from_file",
    "motion_from_selection",
    "motion_from_source",
    "motion_driven",
    "find_path",
    "edit_motion",
    "improve_path",
    "sequence",
    "edit_source",
    "reload_motion",
    "",
    "create_envelope",
    "edit_envelope",
    "recompute_envelope",
    "",
    "made_by",
    "check_clearance",
    "check_mechanism",
    "check_reserved_spaces",
    "study",
    "make_solid",
    "export_envelope",
    "export_report",
    "",
    "to_tree",
    "demo_command",
    "install_core",
]
#: Commands that appear only in the menu.
_MENU_ONLY = {
    "SweptVolume_EditSource",
    "SweptVolume_EditEnvelope",
    "SweptVolume_ToTree",
    "SweptVolume_Demo",
    "SweptVolume_InstallCore",
}
_names = []


def register():
    """Registers all commands with FreeCAD, once."""
    import importlib

    if _names:
        return
    for name in _MODULES:
        if not name:
            _names.append("Separator")
            continue
        command = importlib.import_module("." + name, __name__).Command()
        Gui.addCommand(command.NAME, command)
        _names.append(command.NAME)


def load():
    """Imports the modules that the commands need, which takes a fifth of a second. Called early, so
    that the first use of a command need not wait."""
    import Mesh  # noqa: F401
    import MeshPart  # noqa: F401

    from ..panels import envelope_panel, motion_panel, solid_panel  # noqa: F401
    from ..views import envelope_view, solid_view  # noqa: F401


def fill_workbench(workbench):
    shown = [name for name in _names if name not in _MENU_ONLY]
    workbench.appendToolbar(QT_TRANSLATE_NOOP("Workbench", "Swept Volume"), shown)
    workbench.appendMenu(QT_TRANSLATE_NOOP("Workbench", "&Swept Volume"), list(_names))


def fill_context_menu(workbench, recipient):
    from ..panels import selection

    if recipient not in ("View", "Tree"):
        return
    names = []
    if recipient == "Tree" and selection.ours():
        return  # the view provider fills the context menu there, in any workbench
    if selection.motion():
        names += ["SweptVolume_EditMotion", "SweptVolume_ImprovePath"]
        names += ["SweptVolume_FindPath", "SweptVolume_ReloadMotion"]
    elif selection.parts():
        names += ["SweptVolume_NewMotion", "SweptVolume_FindPath"]
    if selection.sequence() or len(selection.parts()) > 1:
        names.append("SweptVolume_Sequence")
    if selection.motion() or selection.parts():
        names += ["SweptVolume_Envelope", "SweptVolume_Clearance"]
    if len(selection.spaces()) > 1:
        names.append("SweptVolume_Overlap")
    if len(selection.motions()) > 1:
        names.append("SweptVolume_Mechanism")
    if selection.envelope():
        names += [
            "SweptVolume_EditEnvelope",
            "SweptVolume_Recompute",
            "SweptVolume_MadeBy",
            "SweptVolume_Clearance",
            "SweptVolume_Solid",
            "SweptVolume_Export",
        ]
    if selection.reported():
        names.append("SweptVolume_ExportReport")
    if selection.study() or selection.runs():
        names.append("SweptVolume_Study")
    if names:
        workbench.appendContextMenu("", ["Separator"] + sorted(set(names), key=_names.index))
