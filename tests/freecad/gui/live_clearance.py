# SPDX-License-Identifier: LGPL-2.1-or-later
"""The live clearance in the motion editor: the number follows a key that is dragged with the mouse, a clash
is red, and the key stops at contact. Also measures how quickly the number follows while the demo's starter
motor is dragged.
"""
import os
import sys
import time

sys.path.insert(0, os.path.dirname(os.path.realpath(__file__)))
from driver import (  # noqa: E402
    App,
    Cancel,
    Gaps,
    Gui,
    QtWidgets,
    click,
    drag,
    find,
    new_document,
    no_panel,
    open_workbench,
    panel_button,
    run,
    say,
    select,
    shot,
)

V = App.Vector
#: Shortest time of a drag in the demo, and the smallest number of answers; the position of the dragger
#: is read every POLL.
SECONDS, ANSWERS, POLL = 4.0, 8, 0.03


def text():
    return find(QtWidgets.QLabel, "SweptVolumeLiveText").text()


def box_before_a_wall():
    """Tests known distances: a cube of 10 mm, and a wall 20 mm above it."""
    from sweptvolume.features import motion
    from sweptvolume.panels import motion_panel

    doc = new_document("Live")
    cube, wall = doc.addObject("Part::Box", "Cube"), doc.addObject("Part::Box", "Wall")
    wall.Length, wall.Width, wall.Height = 60, 60, 5
    wall.Placement.Base = V(-25, -25, 30)
    places = [App.Placement(), App.Placement(V(40, 0, 0), App.Rotation())]
    path = motion.motion_from_poses(doc, [0, 1], places)
    doc.recompute()
    Gui.activeDocument().activeView().viewFront()
    Gui.SendMsgToActiveView("ViewFit")
    select(cube, path)
    Gui.runCommand("SweptVolume_EditMotion")
    yield 0.5
    Gui.Selection.clearSelection()
    panel = motion_panel.opened[-1]
    find(QtWidgets.QTableWidget, "SweptVolumeKeys").setCurrentCell(0, 1)
    yield 0.3
    start = panel._standing_at(0).multiply(panel.handle).Base
    tip = start + V(0, 0, panel.dragger.arrow)
    yield from drag(tip, tip + V(0, 0, 12))
    yield lambda: " to Wall" in text()
    moved = panel.keys.placements[0].Base.z
    yield 0.5
    assert 5 < moved < 20, moved
    assert abs(float(text().split()[0]) - (20 - moved)) < 0.05, (text(), moved)
    shot("80_live_clearance")
    yield 0.7
    # The wall is moved while the editor is open.
    wall = doc.Wall
    wall.Placement.Base.z += 7
    yield 0.7
    start = panel._standing_at(0).multiply(panel.handle).Base
    tip = start + V(0, 0, panel.dragger.arrow)
    yield from drag(tip, tip + V(0, 0, 1))
    moved = panel.keys.placements[0].Base.z
    yield lambda: " to Wall" in text() and abs(float(text().split()[0]) - (27 - moved)) < 0.05
    wall.Placement.Base.z -= 7
    yield 0.7
    # A longer drag moves the cube into the wall.
    start = panel._standing_at(0).multiply(panel.handle).Base
    tip = start + V(0, 0, panel.dragger.arrow)
    yield from drag(tip, tip + V(0, 0, 15))
    yield lambda: "Clash with Wall" in text()
    red = panel.ghosts.paint.diffuseColor.getValues()[0].getValue()
    assert red[0] > 0.8 and red[1] < 0.2, red
    shot("81_live_clash")
    yield 0.7
    # The same drag again, with *Stop at contact*.
    while panel.history.before:  # each pause of these mouse events counts as letting go
        panel.step_back(True)
    yield 0.3
    assert abs(panel.keys.placements[0].Base.z) < 1e-9, panel.keys.placements[0]
    find(QtWidgets.QCheckBox, "SweptVolumeStopAtContact").setChecked(True)
    yield 0.2
    start = panel._standing_at(0).multiply(panel.handle).Base
    tip = start + V(0, 0, panel.dragger.arrow)
    yield from drag(tip, tip + V(0, 0, 28))
    yield lambda: "Wall" in text() and not panel.let_go
    shot("82_live_stopped")
    yield 0.7
    height = panel.keys.placements[0].Base.z
    assert 19.5 < height < 20, height
    assert panel.history.before and abs(panel.history.now[0].placements[0].Base.z - height) < 1e-9
    position = panel.dragger.placement().Base
    assert (position - panel._standing_at(0).multiply(panel.handle).Base).Length < 1e-4, position
    click(panel_button(Cancel))
    yield no_panel


def engine_bay():
    """Measures in the demo the number of answers per second, and the time that the window's thread
    spends on them."""
    from sweptvolume import demo
    from sweptvolume.panels import motion_panel

    scene = demo.build()
    yield 0.5
    select(scene.starter, scene.motion)
    Gui.runCommand("SweptVolume_EditMotion")
    yield 0.5
    panel = motion_panel.opened[-1]
    panel.preview_box.setChecked(False)
    find(QtWidgets.QTableWidget, "SweptVolumeKeys").setCurrentCell(7, 1)
    yield 0.3
    home, gaps, began = panel._standing_at(7).multiply(panel.handle), Gaps(), time.perf_counter()
    panel.dragged(home)
    yield lambda: panel.live.live.answers
    say("prepared in {:.2f} s, gap {}".format(time.perf_counter() - began, gaps.stop()))
    gaps, began, answers, n = Gaps(), time.perf_counter(), panel.live.live.answers, 0
    # Answers come during the drag, not only at its end. Their number per second is printed, not tested.
    while time.perf_counter() - began < SECONDS or panel.live.live.answers - answers < ANSWERS:
        n += 1
        place = App.Placement(home)
        place.Base.z += 40 * (1 - abs(n % 40 - 20) / 20.0)
        panel.dragged(place)
        yield POLL
        if n == 20:
            shot("83_live_engine_bay")
    seconds = time.perf_counter() - began
    rate = (panel.live.live.answers - answers) / seconds
    text_of_rates = "engine bay: {:.1f} answers a second to {:.1f} questions, gap {}"
    say(text_of_rates.format(rate, n / seconds, gaps.stop()))
    click(panel_button(Cancel))
    yield no_panel


def scenario():
    open_workbench()
    yield
    yield from box_before_a_wall()
    yield from engine_bay()


run(scenario)
