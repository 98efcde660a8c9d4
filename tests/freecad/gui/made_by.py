# SPDX-License-Identifier: LGPL-2.1-or-later
"""What made this?: an envelope is coloured by the faces that made it. A click on it names the face and
shows the part at that moment, as the player of the motion editor does. The colours remain after a
recompute.
"""
import os
import sys

sys.path.insert(0, os.path.dirname(os.path.realpath(__file__)))
from driver import (  # noqa: E402
    App,
    Close,
    Cancel,
    Gui,
    QtWidgets,
    choose,
    click,
    drag,
    find,
    new_document,
    no_panel,
    open_workbench,
    panel_button,
    run,
    select,
    shot,
)

V = App.Vector


def scenario():
    from sweptvolume.features import envelope, made_by, motion
    from sweptvolume.panels import made_panel, motion_panel

    def colours(obj):
        """Returns the number of different colours in which the envelope is drawn."""
        from pivy import coin

        search = coin.SoSearchAction()
        search.setType(coin.SoMaterial.getClassTypeId())
        search.setInterest(coin.SoSearchAction.ALL)
        search.setSearchingAll(True)
        search.apply(obj.ViewObject.RootNode)
        paths = search.getPaths()
        found = {
            tuple(round(x, 3) for x in paths[i].getTail().diffuseColor[0].getValue())
            for i in range(paths.getLength())
        }
        return len(found)

    def click_at(point):
        yield from drag(point, point, steps=1)

    open_workbench()
    doc = new_document("MadeBy")
    bracket = doc.addObject("Part::Box", "Bracket")
    bracket.Length, bracket.Width, bracket.Height = 10, 20, 30
    doc.recompute()
    path = motion.motion_from_poses(
        doc,
        [0, 1, 3],
        [
            App.Placement(),
            App.Placement(V(40, 0, 0), App.Rotation()),
            App.Placement(V(60, 10, 0), App.Rotation(V(0, 0, 1), 60)),
        ],
    )
    obj = envelope.make_envelope(doc, [bracket], path, Resolution=64)
    doc.recompute()
    envelope.compute(obj)
    Gui.activeDocument().activeView().viewIsometric()
    Gui.SendMsgToActiveView("ViewFit")
    yield

    # There is no record: the panel offers to compute the envelope again.
    select(obj)
    Gui.runCommand("SweptVolume_MadeBy")
    yield
    panel = made_panel.opened[-1]
    assert not find(QtWidgets.QComboBox, "SweptVolumeColourBy").isEnabled()
    assert "nothing was recorded" in panel.text.text(), panel.text.text()
    own = colours(obj)
    click(find(QtWidgets.QPushButton, "SweptVolumeRemember"))
    yield lambda: panel.run is None and made_by.find(obj) is not None
    assert obj.MadeBy == "Session" and obj.MadeByData == ""
    for by, least in (("Face", 8), ("Time", 12), ("Kind", 3)):
        choose("SweptVolumeColourBy", by)
        yield lambda least=least: colours(obj) >= own + least - 1
        yield 0.4
        shot("70_made_by_" + by.lower())
        yield 0.5

    # The top of the swept box, in the middle of the motion: made by the top face, which slides along
    # itself there.
    yield from click_at(V(25, 10, 30))
    answer = panel.answer
    assert answer is not None, panel.text.text()
    assert [part["label"] for part, _ in answer.faces] == ["Bracket"] * len(answer.faces)
    assert "of Bracket, at" in panel.text.text(), panel.text.text()
    # The lower end is a face of the part at the first pose: Face1, x = 0.
    bracket.ViewObject.Visibility = False  # it would hide the envelope here
    Gui.activeDocument().activeView().viewLeft()
    Gui.SendMsgToActiveView("ViewFit")
    yield 0.3
    yield from click_at(V(0, 10, 15))
    answer = panel.answer
    assert answer.kind == made_by.CAP and answer.time == 0, answer
    assert [number for _, number in answer.faces] == [1], answer
    assert "Face1 of Bracket, at 0.000 s" in panel.text.text(), panel.text.text()
    assert panel.player.now() == 0 and panel.moving is not None
    click(find(QtWidgets.QPushButton, "SweptVolumeSelectFace"))
    yield
    chosen = Gui.Selection.getSelectionEx("", 0)
    assert [s.SubElementNames for s in chosen] == [("Face1",)], chosen
    # The far end: a moving vertical edge, or the part at the last pose.
    Gui.activeDocument().activeView().viewRight()
    Gui.SendMsgToActiveView("ViewFit")
    yield 0.3
    far = V(obj.Mesh.BoundBox.XMax, 0, 15)
    rim = min(obj.Mesh.Points, key=lambda p: (p.Vector - V(far.x, p.y, 15)).Length).Vector
    yield from click_at(V(rim))
    assert panel.answer is not None and panel.answer.time > 1, panel.text.text()
    assert abs(panel.player.now() - panel.answer.time) < 1e-9
    Gui.activeDocument().activeView().viewIsometric()
    Gui.SendMsgToActiveView("ViewFit")
    choose("SweptVolumeColourBy", "Face")
    yield 0.6
    shot("71_made_by_click")
    yield 0.5
    click(panel_button(Close))
    yield no_panel
    assert obj.ViewObject.ColourBy == "Face"

    # For a stale envelope, the text is about the parts as they were when it was computed. So no face is
    # selected, and no part is shown.
    bracket.Height = 25
    obj.Motion = doc.copyObject(path)
    doc.recompute()
    assert obj.Status == envelope.STALE
    select(obj)
    Gui.runCommand("SweptVolume_MadeBy")
    yield
    panel = made_panel.opened[-1]
    Gui.activeDocument().activeView().viewLeft()
    Gui.SendMsgToActiveView("ViewFit")
    yield 0.3
    yield from click_at(V(0, 10, 15))
    assert panel.text.text().startswith("Face1 of Bracket, at 0.000 s"), panel.text.text()
    assert "is stale" in panel.text.text(), panel.text.text()
    assert not find(QtWidgets.QPushButton, "SweptVolumeSelectFace").isEnabled()
    assert panel.moving is None and not panel.player.isEnabled()
    assert not panel.message.text(), panel.message.text()
    shot("72_made_by_stale")
    click(panel_button(Close))
    yield no_panel

    # A recompute keeps the colours.
    obj.Motion = path
    doc.recompute()
    select(obj)
    before = made_by.find(obj)
    Gui.runCommand("SweptVolume_Recompute")
    yield no_panel
    assert obj.Status == envelope.UP_TO_DATE and made_by.find(obj) is not before
    yield lambda: colours(obj) >= own + 7

    # In the motion editor, a click on the envelope moves the player to that moment.
    select(path)
    Gui.runCommand("SweptVolume_EditMotion")
    yield
    editor = motion_panel.opened[-1]
    editor.preview_box.setChecked(False)
    editor.drag_box.setChecked(False)
    Gui.activeDocument().activeView().viewRight()
    Gui.SendMsgToActiveView("ViewFit")
    yield 0.3
    editor.player.go_to(0.0)
    yield from click_at(V(rim.x, rim.y, 12))
    assert editor.player.now() > 1, editor.player.now()
    click(panel_button(Cancel))
    yield no_panel
    obj.ViewObject.ColourBy = "Nothing"
    yield lambda: colours(obj) == own


run(scenario)
