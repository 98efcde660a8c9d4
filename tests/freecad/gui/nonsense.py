# SPDX-License-Identifier: LGPL-2.1-or-later
"""Invalid text is typed into every field of every panel and confirmed. The panel either shows a message and
stays open, or uses the value that it shows. test_gui.py fails if a traceback is printed. With
SWEPT_LONG_TESTS, every kind of invalid text is typed into every field.
"""
import os
import sys
import tempfile

sys.path.insert(0, os.path.dirname(os.path.realpath(__file__)))
from driver import (  # noqa: E402
    App,
    Apply,
    Ok,
    QtCore,
    QtWidgets,
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
    visible_text,
)

V = App.Vector
NONSENSE = ["abc", "-5", "0.000001", "5 kg", "999999999"]
#: Number of these texts that are typed into each field of a panel. Different fields get different ones.
TYPED = len(NONSENSE) if os.environ.get("SWEPT_LONG_TESTS") else 2
CSV = "t,tx,ty,tz,qx,qy,qz,qw\n0,0,0,0,0,0,0,1\n1,4,0,0,0,0,0,1\n"
#: Time (s) until a run is stopped. A run starts if a field has accepted what was typed.
PATIENCE = 0.3


def fields(form):
    """Returns every field that takes text, also those without a name."""
    spins = form.findChildren(QtWidgets.QAbstractSpinBox)
    inner = [edit for spin in spins for edit in spin.findChildren(QtWidgets.QLineEdit)]
    lines = [edit for edit in form.findChildren(QtWidgets.QLineEdit) if edit not in inner]
    return [f for f in spins + lines if f.isVisible() and f.isEnabled()]


def settled():
    """Returns whether no run is in progress; stops one that takes long."""
    from sweptvolume import runner

    for one in runner.running():
        one.waited = getattr(one, "waited", 0) + 0.02
        if one.waited > PATIENCE:
            one.cancel()
    return not runner.running()


def storm(name, reopen, confirm):
    """Types every kind of invalid text into every field of a panel."""
    panel = reopen()
    yield 0.4
    count, shown = len(fields(panel.form)), 0
    for k in range(count):
        for text in (NONSENSE * 2)[k % 5 : k % 5 + TYPED]:
            if no_panel():
                panel = reopen()
                yield 0.3
            found = fields(panel.form)
            if k >= len(found):
                continue
            edit = type_over(found[k], text)
            typed, before = edit.text(), visible_text(panel.form)
            confirm(panel)
            yield 0.05
            yield settled
            yield 0.05
            if no_panel():
                continue
            assert edit.text() == typed or edit.text(), "{}: what was typed is lost".format(name)
            shown += visible_text(panel.form) != before
            if text == "5 kg":
                shot("60_nonsense_{}_{}".format(name, k))
        if not no_panel():
            panel.reject()
            yield no_panel
    if not no_panel():
        panel.reject()
        yield no_panel
    say("{}: {} fields, told {} times".format(name, count, shown))
    assert count and shown, (name, count, shown)


def table_storm(panel):
    """Types invalid text into the cells of the table of keys."""
    table = find(QtWidgets.QTableWidget, "SweptVolumeKeys")
    for column in range(table.columnCount()):
        for text in NONSENSE:
            table.item(1, column).setText(text)
            yield 0.01
    for place in panel.keys.placements:
        numbers = list(place.Base) + list(place.Rotation.Q)
        assert all(abs(n) <= 1e9 for n in numbers), numbers


def counted_as_rows(doc, box):
    """Messages name poses by the numbers before their rows in the table of keys."""
    from sweptvolume import core
    from sweptvolume.features import envelope, motion
    from sweptvolume.panels import motion_panel

    about = [App.Rotation(V(0, 0, 1), degrees) for degrees in (0, 10, 190)]
    path = motion.motion_from_poses(doc, [0, 1, 2], [App.Placement(V(), r) for r in about])
    doc.recompute()
    hull = envelope.make_envelope(doc, [box], path, Resolution=24)
    doc.recompute()
    try:
        envelope.compute(hull)
    except core.CoreError as problem:
        message = str(problem)
    panel = motion_panel.show(doc, path, (box, ""))
    yield 0.5
    table = find(QtWidgets.QTableWidget, "SweptVolumeKeys")
    rows = [str(table.model().headerData(r, QtCore.Qt.Vertical)) for r in range(3)]
    words = "between pose {} and pose {} the part turns by 180".format(*rows[1:])
    assert words in message and words in hull.Message, (words, message, hull.Message)
    panel.reject()
    yield no_panel
    doc.removeObject(hull.Name)
    doc.removeObject(path.Name)
    doc.recompute()


def scenario():
    import Part

    from sweptvolume.features import envelope, motion
    from sweptvolume.panels import (
        clearance_panel,
        envelope_panel,
        file_panel,
        find_path_panel,
        improve_panel,
        motion_panel,
        solid_panel,
        source_panel,
    )

    open_workbench()
    yield
    folder = tempfile.mkdtemp()
    csv = os.path.join(folder, "way.csv")
    with open(csv, "w") as out:
        out.write(CSV)
    doc = new_document("Nonsense")
    box, wall = doc.addObject("Part::Box", "Slide"), doc.addObject("Part::Box", "Wall")
    wall.Placement.Base = V(0, 13, 0)
    wire = doc.addObject("Part::Feature", "Wire")
    wire.Shape = Part.makePolygon([V(), V(20, 0, 0), V(20, 20, 0)])
    places = [App.Placement(), App.Placement(V(30, 0, 0), App.Rotation())]
    path = motion.motion_from_poses(doc, [0, 1], places)
    doc.recompute()
    hull = envelope.make_envelope(doc, [box], path, Resolution=24)
    doc.recompute()
    envelope.compute(hull)

    yield from counted_as_rows(doc, box)

    def ok(panel):
        click(panel_button(Ok))

    def apply(panel):
        click(panel_button(Apply))

    def by_cell():
        panel = envelope_panel.show(doc, obj=hull)
        panel.by.setCurrentIndex(panel.by.findData("CellSize"))
        return panel

    def keys():
        panel = motion_panel.show(doc, path, (box, ""))
        panel.interpolation.setCurrentIndex(3)
        panel.tangent.kind.setCurrentIndex(3)
        return panel

    def start_at(panel):
        panel.start_at.show_placement(App.Placement(V(0, -20, 0), App.Rotation()))
        return panel

    panel = keys()
    yield 0.4
    yield from table_storm(panel)
    click(panel_button(Ok))
    yield no_panel
    path.Placements, path.Times = places, [0, 1]
    doc.recompute()
    jobs = [
        ("envelope", lambda: envelope_panel.show(doc, obj=hull), ok),
        ("cell", by_cell, apply),
        ("clearance", lambda: clearance_panel.show(doc, envelope=hull), lambda p: p.start()),
        ("solid", lambda: solid_panel.show(hull), ok),
        ("step", lambda: solid_panel.show(hull, path=os.path.join(folder, "a.step")), ok),
        ("file", lambda: file_panel.show(doc, csv), ok),
        ("wire", lambda: source_panel.show(doc, "Curve", [wire]), ok),
        ("value", lambda: source_panel.show(doc, "Driven", [wall, box]), ok),
        ("motion", keys, ok),
        (
            "path",
            lambda: start_at(find_path_panel.show(doc, pairs=[(box, "")])),
            lambda p: p.start(),
        ),
        (
            "improve",
            lambda: improve_panel.show(doc, motion=path, pairs=[(box, "")]),
            lambda p: p.start(),
        ),
    ]
    for name, reopen, confirm in jobs:
        yield from storm(name, reopen, confirm)
    App.closeDocument(doc.Name)
    yield


run(scenario)
