# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pictures of finding and improving paths, in the engine bay of the demo, and of the clearance of a dragged
key."""
from driver import (
    App,
    Cancel,
    Close,
    Gui,
    QtWidgets,
    choose,
    click,
    find,
    no_panel,
    panel_button,
    select,
)


def paths(picture):
    """Finds and improves paths; a generator. picture(name): a generator that takes a picture."""
    from sweptvolume.features import motion
    from sweptvolume.panels import motion_panel

    Gui.runCommand("SweptVolume_Demo")
    yield 1.0
    doc = App.ActiveDocument
    starter, by_hand = doc.getObject("Starter"), doc.getObject("Motion")
    start = by_hand.Placements[0]

    def motions():
        return [o for o in doc.Objects if motion.is_motion(o)]

    by_hand.ViewObject.Visibility = False
    select(starter)
    Gui.runCommand("SweptVolume_FindPath")
    yield 0.6
    choose("SweptVolumeStartKind", "Place")
    numbers = list(start.Base) + list(start.Rotation.toEuler())
    text = " ".join("{:.6g}".format(n) for n in numbers)
    find(QtWidgets.QLineEdit, "SweptVolumeStartNumbers").setText(text)
    click(find(QtWidgets.QPushButton, "SweptVolumeFind"))
    yield lambda: len(motions()) == 2
    Gui.Selection.clearSelection()
    Gui.SendMsgToActiveView("ViewFit")
    yield 0.6
    yield from picture("find_path")
    click(panel_button(Close))
    yield no_panel

    select(starter, by_hand)
    Gui.runCommand("SweptVolume_EditMotion")
    yield 1.5
    Gui.Selection.clearSelection()
    panel = motion_panel.opened[-1]
    find(QtWidgets.QTableWidget, "SweptVolumeKeys").setCurrentCell(5, 1)
    yield 0.5
    here = panel._standing_at(5).multiply(panel.handle)
    here.Base.y += 30
    panel.dragged(here)
    yield lambda: panel.live.live.answers
    yield panel.preview.settled
    yield from picture("live_clearance")
    click(panel_button(Cancel))
    yield no_panel

    select(starter, by_hand)
    Gui.runCommand("SweptVolume_ImprovePath")
    yield 0.6
    click(find(QtWidgets.QPushButton, "SweptVolumeFind"))
    yield lambda: len(motions()) == 3
    Gui.Selection.clearSelection()
    yield 0.6
    yield from picture("improve_path")
    click(panel_button(Close))
    yield no_panel
    App.closeDocument(doc.Name)
