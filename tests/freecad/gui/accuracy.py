# SPDX-License-Identifier: LGPL-2.1-or-later
"""The field Accuracy in the panel of an envelope: a typed value, a computed one, an invalid one, one that
needs too many cells, and inches.
"""
import os
import sys

sys.path.insert(0, os.path.dirname(os.path.realpath(__file__)))
from driver import (  # noqa: E402
    App,
    Apply,
    Cancel,
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
    say,
    shot,
    type_over,
)

V = App.Vector


def scenario():
    from sweptvolume import runner
    from sweptvolume.features import envelope, motion
    from sweptvolume.panels import envelope_panel

    open_workbench()
    yield
    doc = new_document("Accuracy")
    wedge = doc.addObject("Part::Wedge", "Wedge")  # 10 x 10 x 10 mm
    places = [App.Placement(), App.Placement(V(25, 0, 7), App.Rotation(V(0, 0, 1), 40))]
    path = motion.motion_from_poses(doc, [0, 2], places)
    doc.recompute()

    # An accuracy of 0.5 mm: the estimate, the cells, the bound, and what an opened panel shows.
    panel = envelope_panel.show(doc, [(wedge, "")], path)
    panel.by.setObjectName("By")
    yield 0.3
    choose("By", "Accuracy")
    type_over(find(QtWidgets.QWidget, "SweptVolumeAccuracy"), "0.5 mm")
    assert not panel.tolerance.isEnabled() and not panel.resolution.isEnabled()
    yield lambda: "cells of 0.25 mm" in panel.estimate_label.text()
    shot("70_accuracy")
    click(panel_button(Ok))
    yield no_panel
    made = doc.getObject("Envelope")
    assert made.Status == envelope.UP_TO_DATE, (made.Status, made.Message)
    assert (made.Accuracy.Value, made.UsedCellSize.Value) == (0.5, 0.25)
    assert 0.4 < made.AccuracyBound.Value <= 0.5, made.AccuracyBound
    say(
        "accuracy 0.5 mm: bound {:.3f} mm, {} triangles".format(
            made.AccuracyBound.Value, made.Triangles
        )
    )

    panel = envelope_panel.show(doc, obj=made)
    panel.by.setObjectName("By")
    yield 0.3
    assert panel.by.currentData() == "Accuracy", panel.by.currentData()
    bound = "Distance from the true surface: at most "
    assert bound in panel.read_outs.text.text(), panel.read_outs.text.text()

    # Invalid text: the panel shows a message and keeps the text. Nothing is computed or changed.
    for typed, words in (
        ("abc", "Accuracy"),
        ("0 mm", "accuracy must be above 0 mm"),
        ("5 kg", "Accuracy"),
        ("-3 mm", "Accuracy"),
        ("0.0001 mm", "an accuracy of "),
        ("30 mm", "at most 2.5 mm (an accuracy of 5 mm)"),
    ):
        type_over(find(QtWidgets.QWidget, "SweptVolumeAccuracy"), typed)
        click(panel_button(Apply))
        yield lambda: not runner.running()
        yield 0.1
        messages = [panel.message.text(), panel.estimate_label.text()]
        say("{}: {}".format(typed, messages[0]))
        assert words in messages[0], (typed, words, messages)
        assert (made.Accuracy.Value, made.UsedCellSize.Value) == (0.5, 0.25), typed
    shot("71_accuracy_too_coarse")
    type_over(find(QtWidgets.QWidget, "SweptVolumeAccuracy"), "2 mm")
    click(panel_button(Apply))
    yield lambda: not runner.running()
    yield 0.1
    assert (made.Accuracy.Value, made.UsedCellSize.Value) == (2, 1), made.Message
    assert made.Status == envelope.UP_TO_DATE and 1 < made.AccuracyBound.Value <= 2
    click(panel_button(Cancel))
    yield no_panel

    # Inches: a number without a unit is in inches, and the panel shows the bound in inches.
    App.ParamGet("User parameter:BaseApp/Preferences/Units").SetInt("UserSchema", 3)
    App.Units.setSchema(3)
    panel = envelope_panel.show(doc, obj=made)
    yield 0.3
    type_over(find(QtWidgets.QWidget, "SweptVolumeAccuracy"), "0.04")
    click(panel_button(Apply))
    yield lambda: not runner.running()
    yield 0.1
    assert abs(made.Accuracy.Value - 1.016) < 1e-9, made.Accuracy
    lines = [s for s in panel.read_outs.text.text().split("\n") if s.startswith(bound)]
    assert len(lines) == 1 and lines[0].endswith(" in"), lines
    say(lines[0])
    click(panel_button(Cancel))
    yield no_panel
    App.Units.setSchema(0)
    App.closeDocument(doc.Name)
    yield


run(scenario)
