# SPDX-License-Identifier: LGPL-2.1-or-later
"""The panel of a solid: upper bounds at once, then the figures of a trial, which are exactly those of the
solid and its file. A change of a setting or Cancel ends the trial; OK does not wait for it.
"""
import os
import re
import sys
import tempfile

sys.path.insert(0, os.path.dirname(os.path.realpath(__file__)))
from driver import (  # noqa: E402
    App,
    Cancel,
    Gaps,
    Gui,
    Ok,
    QtWidgets,
    answered,
    click,
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
FIGURES = re.compile(
    r"([\d,.]+) triangles: (at most )?([\d,.]+) faces,\s+(?:up to )?about ([\d,.]+) MB"
)


def figures(text):
    """Returns (faces, megabytes, whether they are upper bounds) that the panel shows; None if there are
    none yet."""
    found = FIGURES.match(text)
    if found is None:
        return None
    return int(found[3].replace(",", "")), float(found[4].replace(",", "")), bool(found[2])


def scenario():
    import MeshPart
    import Part
    from sweptvolume import core, runner
    from sweptvolume.features import envelope, motion
    from sweptvolume.panels import file_dialogs

    open_workbench()
    yield
    doc = new_document("Trial")
    # As a mesh: from a CAD part, each trial would take a minute.
    part = doc.addObject("Mesh::Feature", "Ring")
    ring = Part.makeTorus(10, 2)
    part.Mesh = MeshPart.meshFromShape(Shape=ring, LinearDeflection=0.05, AngularDeflection=0.2)
    places = [
        App.Placement(),
        App.Placement(V(20, 3, 6), App.Rotation(V(3, 5, 8), 25)),
        App.Placement(V(30, 20, 4), App.Rotation(V(-2, 7, 4), 41)),
    ]
    path = motion.motion_from_poses(doc, [0, 1, 2], places)
    doc.recompute()
    hull = envelope.make_envelope(doc, [part], path, Resolution=64)
    envelope.compute(hull)
    select(hull)
    Gui.runCommand("SweptVolume_Solid")
    yield
    label = find(QtWidgets.QLabel, "SweptVolumeSolidEstimate")
    tolerance = find(QtWidgets.QWidget, "SweptVolumeSolidTolerance")
    tried = lambda: figures(label.text()) is not None and not figures(label.text())[2]  # noqa: E731
    bound = lambda: figures(label.text()) is not None and figures(label.text())[2]  # noqa: E731
    # The panel proposes a tolerance, so that the solid gets the surfaces that the part sweeps.
    proposed = tolerance.property("rawValue")
    assert 0.05 < proposed < 0.15, proposed  # about a tenth of a cell
    tolerance.setProperty("rawValue", 0)
    yield tried
    exact = figures(label.text())

    # Bounds first, then the figures of the trial; the window responds meanwhile.
    gaps = Gaps()
    tolerance.setProperty("rawValue", 0.1)
    yield bound
    bounds = figures(label.text())
    assert "Estimating" in label.text(), label.text()
    shot("85_solid_bounds")
    yield tried
    say("longest between two events: " + gaps.stop())
    fine = figures(label.text())
    shot("86_solid_tried")
    yield 0.5
    assert fine[0] <= bounds[0] and fine[0] < exact[0], (fine, bounds, exact)
    assert "Estimating" not in label.text(), label.text()

    # A change during a trial: only the result for the last settings is shown.
    tolerance.setProperty("rawValue", 0.02)
    yield bound
    tolerance.setProperty("rawValue", 0.4)
    shown = []

    def settled():
        shown.append(label.text())
        return tried() and figures(label.text()) != fine and not runner.running()

    yield settled
    coarse = figures(label.text())
    assert coarse[0] < fine[0], (coarse, fine)
    exact_ones = {t for t in shown if figures(t) and not figures(t)[2] and figures(t) != fine}
    assert exact_ones == {label.text()}, exact_ones

    # Cancel during a trial leaves no run.
    tolerance.setProperty("rawValue", 0.03)
    yield bound
    assert runner.running()
    click(panel_button(Cancel))
    yield no_panel
    yield lambda: not runner.running()
    assert doc.getObject("EnvelopeSolid") is None

    # OK during a trial does not wait for its result. The solid has as many faces as the earlier trial
    # with this tolerance showed.
    select(hull)
    Gui.runCommand("SweptVolume_Solid")
    yield
    label = find(QtWidgets.QLabel, "SweptVolumeSolidEstimate")
    find(QtWidgets.QWidget, "SweptVolumeSolidTolerance").setProperty("rawValue", 0.1)
    yield bound
    click(panel_button(Ok))
    yield no_panel
    body = doc.getObject("EnvelopeSolid")
    assert body.Faces == fine[0], (body.Faces, fine)
    assert body.Shape.isValid()

    # The limit requires a tolerance: the panel says which.
    select(hull)
    Gui.runCommand("SweptVolume_Solid")
    yield
    label = find(QtWidgets.QLabel, "SweptVolumeSolidEstimate")
    find(QtWidgets.QWidget, "SweptVolumeSolidTolerance").setProperty("rawValue", 0)
    yield lambda: tried() and figures(label.text()) == exact
    find(QtWidgets.QSpinBox, "SweptVolumeMaxFaces").setValue(1500)
    yield lambda: tried() and figures(label.text())[0] <= 1500
    assert "is needed to meet the limits" in label.text(), label.text()
    # The trial refuses what the run would refuse, with the same message.
    find(QtWidgets.QSpinBox, "SweptVolumeMaxFaces").setValue(4)
    yield lambda: "the limit is 4 faces" in label.text()
    click(panel_button(Cancel))
    yield no_panel

    # A core without OpenCASCADE makes no trial: the bounds stay, and the panel announces no other
    # figures.
    with answered(core, "has_solids", lambda: False):
        select(hull)
        Gui.runCommand("SweptVolume_Solid")
        yield
        label = find(QtWidgets.QLabel, "SweptVolumeSolidEstimate")
        yield bound
        yield lambda: not runner.running()
        assert "Estimating" not in label.text(), label.text()
        click(panel_button(Cancel))
        yield no_panel

    # For a file, the panel shows its megabytes.
    target = os.path.join(tempfile.mkdtemp(), "ring.step")
    with answered(file_dialogs, "ask_export", lambda name: target):
        select(hull)
        Gui.runCommand("SweptVolume_Export")
        yield
    label = find(QtWidgets.QLabel, "SweptVolumeSolidEstimate")
    find(QtWidgets.QWidget, "SweptVolumeSolidTolerance").setProperty("rawValue", 0.1)
    yield bound
    yield tried
    faces, megabytes, _ = figures(label.text())
    assert faces == fine[0], (faces, fine)
    click(panel_button(Ok))
    yield no_panel
    real = os.path.getsize(target) / 1e6
    assert abs(megabytes - real) < 0.01 * real, (megabytes, real)


run(scenario)
