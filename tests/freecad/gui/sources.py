# SPDX-License-Identifier: LGPL-2.1-or-later
"""Every kind of source with its command and panel, on objects that FreeCAD's own tools make."""
import os
import sys
import time

HERE = os.path.dirname(os.path.realpath(__file__))
sys.path[:0] = [HERE, os.path.dirname(HERE)]
from simulations import Absent, arm_after, hinge, stuck  # noqa: E402
from driver import (  # noqa: E402
    App,
    Gui,
    Ok,
    QtWidgets,
    choose,
    click,
    find,
    new_document,
    no_panel,
    open_workbench,
    panel_button,
    run,
    select,
    shot,
    to_3d_view,
    visible_text,
)

V = App.Vector


def made(doc):
    """Returns the motion that was made last."""
    from sweptvolume.features.motion import is_motion

    return [o for o in doc.Objects if is_motion(o)][-1]


def stops_early(doc):
    """If frames of a simulation are missing, the panel says so before a motion is made. A second OK
    uses the frames that exist. Tested with one chosen part, and with all parts that move. The
    motion was read from a source, but this source has no settings."""
    from sweptvolume.commands import edit_source

    simulation, part = stuck(doc)
    for chosen in ((simulation, part), (simulation,)):
        before, undo = len(doc.Objects), doc.UndoCount
        select(*chosen)
        Gui.runCommand("SweptVolume_MotionFromSource")
        yield 0.4
        for button in range(2):
            assert len(doc.Objects) == before and doc.UndoCount == undo, "taken before it was said"
            click(panel_button(Ok))
            yield 0.4
            if button == 0:
                text = visible_text()
                for words in ("stopped early", "4 of 5 frames", "0.75 s of 1 s", "OK again"):
                    assert words in text, text
                shot("26_stops_early_{}".format(len(chosen)))
                yield 0.6
        yield no_panel
        found = made(doc)
        assert (found.SourceType, found.Count, doc.UndoCount) == ("Simulation", 4, undo + 1)
        assert "4 of 5 frames" in found.Message, found.Message
        select(found)
        reason = edit_source.Command().missing(doc)
        assert "recorded from an assembly simulation" in reason, reason
        assert part.Placement.Base.Length < 1e-9, part.Placement
        doc.removeObject(found.Name)
        doc.recompute()


def scenario():
    import Part

    open_workbench()
    yield
    doc = new_document("Sources")
    box = doc.addObject("Part::Box", "Slide")
    helix = doc.addObject("Part::Helix", "Helix")
    helix.Pitch, helix.Height, helix.Radius = 40, 80, 60
    axis = doc.addObject("Part::Feature", "Axis")
    axis.Shape = Part.makeLine(V(0, 0, 0), V(0, 0, 80))
    doc.recompute()
    Gui.activeDocument().activeView().viewIsometric()
    Gui.SendMsgToActiveView("ViewFit")
    yield

    # A path and a second curve; Undo takes one step.
    undo = doc.UndoCount
    select(helix, axis)
    Gui.runCommand("SweptVolume_MotionFromSource")
    yield 0.4
    assert find(QtWidgets.QComboBox, "SweptVolumeOrientation").currentData() == "SecondCurve"
    find(QtWidgets.QWidget, "SweptVolumeAccuracy").setProperty("rawValue", 0.2)
    shot("20_second_curve")
    yield 0.6
    click(panel_button(Ok))
    yield no_panel
    motion = made(doc)
    assert motion.Count > 40 and motion.SourceObjects == [helix, axis], motion.Count
    assert doc.UndoCount == undo + 1
    Gui.SendMsgToActiveView("ViewFit")
    shot("21_second_curve_made")
    yield 0.6
    helix.Height = 120
    doc.recompute()
    assert abs(motion.Placements[-1].Base.z - 120) < 1e-6
    doc.undo()

    # One curve: along its tangent.
    select(axis)
    Gui.runCommand("SweptVolume_MotionFromSource")
    yield 0.3
    choose("SweptVolumeOrientation", "Tangent")
    click(panel_button(Ok))
    yield no_panel
    along = made(doc).Placements[0].Rotation.multVec(V(1, 0, 0))
    assert (along - V(0, 0, 1)).Length < 1e-9, along
    # The motion starts at the present placement of the part.
    assert made(doc).PoseType == "RelativeToFirst"

    # A driving value: the cell of a spreadsheet moves the box.
    sheet = doc.addObject("Spreadsheet::Sheet", "Values")
    sheet.set("A1", "5")
    sheet.setAlias("A1", "lift")
    doc.recompute()
    box.setExpression("Placement.Base.z", "Values.lift * 2")
    doc.recompute()
    undo = doc.UndoCount
    select(box, sheet)  # in any order
    yield 0.5
    to_3d_view()  # FreeCAD 1.1 opens a sheet that is selected
    yield 0.3
    Gui.runCommand("SweptVolume_MotionDriven")
    yield 0.4
    choose("SweptVolumeValue", "lift")
    assert find(QtWidgets.QDoubleSpinBox, "SweptVolumeStart").value() == 5
    find(QtWidgets.QDoubleSpinBox, "SweptVolumeStart").setValue(0)
    find(QtWidgets.QDoubleSpinBox, "SweptVolumeEnd").setValue(30)
    shot("22_driven")
    yield 0.6
    click(panel_button(Ok))
    yield no_panel
    driven = made(doc)
    assert abs(driven.Placements[-1].Base.z - 60) < 1e-9 and driven.Count == 16
    assert sheet.getContents("A1") == "5" and abs(box.Placement.Base.z - 10) < 1e-9
    assert doc.UndoCount == undo + 1, doc.UndoNames

    # The mechanism changes: the motion is stale until it is read again.
    box.setExpression("Placement.Base.z", "Values.lift * 3")
    doc.recompute()
    assert driven.Status == "Stale", driven.Status
    Gui.Selection.clearSelection()
    yield
    shot("23_stale_motion")
    yield 0.6
    select(driven)
    Gui.runCommand("SweptVolume_ReloadMotion")
    yield
    assert driven.Status == "" and abs(driven.Placements[-1].Base.z - 90) < 1e-9

    # A CAM path, with the table that turns.
    try:
        import Path
    except ImportError as error:
        print("CAM path skipped: this FreeCAD has none ({})".format(error))
    else:
        cut = doc.addObject("Path::Feature", "Cut")
        lines = ["G0 X10 Y0 Z5", "G1 Z0 F5", "G3 X-10 Y0 I-10 J0", "G1 X-20 C90"]
        cut.Path = Path.Path([Path.Command(line) for line in lines])
        doc.recompute()
        select(cut)
        Gui.runCommand("SweptVolume_MotionFromSource")
        yield 0.4
        choose("SweptVolumeConvention", "Table")
        shot("24_cam")
        yield 0.6
        click(panel_button(Ok))
        yield no_panel
        turned = made(doc).Placements[-1].Base
        assert (turned - V(0, 20, 0)).Length < 1e-9, turned

    # A simulation of FreeCAD's Assembly, if this version has them.
    try:
        simulation, arm, drive = hinge(doc)
    except Absent as reason:
        print("simulation skipped: {}".format(reason))
    else:
        yield
        select(simulation, arm)
        Gui.runCommand("SweptVolume_MotionFromSource")
        yield 0.4
        shot("25_simulation")
        yield 0.6
        click(panel_button(Ok))
        yield no_panel
        swung = made(doc)
        assert (swung.SourceType, swung.Count) == ("Simulation", 5), (swung.SourceType, swung.Count)
        assert swung.Placements[-1].isSame(arm_after(1), 1e-6), swung.Placements[-1]
        assert arm.Placement.isSame(arm_after(0), 1e-9), arm.Placement

    yield from stops_early(doc)

    # A link array, and the placements of selected objects.
    array = doc.addObject("App::Link", "Array")
    array.LinkedObject, array.ElementCount = box, 3
    doc.recompute()
    select(array)
    Gui.runCommand("SweptVolume_MotionFromSource")
    yield 0.3
    click(panel_button(Ok))
    yield no_panel
    assert made(doc).SourceType == "Array" and made(doc).Count == 3
    select(box, helix)
    Gui.runCommand("SweptVolume_MotionFromSelection")
    yield
    assert made(doc).SourceType == "Placements" and made(doc).Count == 2

    # Wrong selection: the commands are disabled, and their tooltips say what to select or create.
    from sweptvolume.panels import widgets

    before = len(doc.Objects)
    select(box)
    began = time.thread_time()
    for command in ("MotionFromSource", "MotionFromSelection", "EditEnvelope", "MotionDriven"):
        if command == "MotionDriven":  # needs no part: the box has values that can drive parts
            assert Gui.isCommandActive("SweptVolume_" + command)
            select()
        assert not Gui.isCommandActive("SweptVolume_" + command), command
        tips = [action.toolTip() for action in widgets.actions_of("SweptVolume_" + command)]
        assert tips and all("elect" in tip or "make one" in tip for tip in tips), tips
        Gui.runCommand("SweptVolume_" + command)
    assert time.thread_time() - began < 0.1, "FreeCAD asks this all the time"
    assert len(doc.Objects) == before and not Gui.Control.activeDialog()
    tips = widgets.actions_of("SweptVolume_MotionFromSelection")[0].toolTip()
    select(box, helix)
    assert Gui.isCommandActive("SweptVolume_MotionFromSelection")
    assert widgets.actions_of("SweptVolume_MotionFromSelection")[0].toolTip() in tips

    # The context menu offers what fits the selection.
    class Menu:
        names = []

        def appendContextMenu(self, menu, names):  # noqa: N802
            self.names = names

    from sweptvolume import commands

    for item, expected in (
        (driven, {"SweptVolume_EditMotion", "SweptVolume_ReloadMotion", "SweptVolume_Envelope"}),
        (box, {"SweptVolume_NewMotion", "SweptVolume_Envelope"}),
    ):
        select(item)
        menu = Menu()
        commands.fill_context_menu(menu, "View")
        assert expected.issubset(menu.names), menu.names
    App.closeDocument(doc.Name)
    yield


run(scenario)
