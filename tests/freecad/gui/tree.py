# SPDX-License-Identifier: LGPL-2.1-or-later
"""The tree: envelopes below their motion, solids and checks below their envelope. A double click and
FreeCAD's Edit open the panel of each. The icon of a check shows a clash.
"""
import contextlib
import os
import sys

sys.path.insert(0, os.path.dirname(os.path.realpath(__file__)))
from driver import (  # noqa: E402
    App,
    Gui,
    QtCore,
    QtWidgets,
    no_panel,
    new_document,
    open_workbench,
    run,
    shot,
    tree,
)

V = App.Vector


def items(document):
    """Returns {label: label of the item above it} for the whole tree."""
    view, found = tree(), {}
    walk = [view.topLevelItem(i) for i in range(view.topLevelItemCount())]
    for item in walk:  # the list grows, and keeps items alive: PySide 6 needs it
        for k in range(item.childCount()):
            found.setdefault(item.child(k).text(0), []).append(item.text(0))
            walk.append(item.child(k))
    return found


def drawn(label):
    """Returns the icon of an item of the tree."""
    (item,) = tree().findItems(label, QtCore.Qt.MatchExactly | QtCore.Qt.MatchRecursive, 0)
    return item.icon(0).pixmap(16, 16).toImage()


def scenario():
    from sweptvolume import core, icon
    from sweptvolume.convert import InputProblem
    from sweptvolume.features import clearance, envelope, motion, solid

    open_workbench()
    yield
    doc = new_document("Tree")
    box, wall = doc.addObject("Part::Box", "Slide"), doc.addObject("Part::Box", "Wall")
    wall.Placement.Base = V(0, 13, 0)
    places = [App.Placement(), App.Placement(V(30, 0, 0), App.Rotation())]
    path = motion.motion_from_poses(doc, [0, 1], places)
    doc.recompute()
    yield 0.5
    hull = envelope.make_envelope(doc, [box], path, Resolution=24)
    doc.recompute()
    envelope.compute(hull)
    body = solid.make_solid(doc, hull)
    solid.compute(body)
    check = clearance.make_clearance(doc, Envelope=hull, RequiredDistance=5.0)
    doc.recompute()
    clearance.compute(check)
    yield 1.0
    shot("66_tree")
    yield 0.3
    above = items(doc)
    assert above["Envelope"] == ["Motion"], above
    assert above[body.Label] == ["Envelope"] and above[check.Label] == ["Envelope"], above
    assert not [o for o in doc.Objects if "Touched" in o.State], "the tree touched something"
    # Icons: clear, below required, clash; a stale result shows only that it is stale.
    assert check.Smallest.Value == 3 and check.ViewObject.Proxy.getIcon() == icon(
        "SweptVolume_Clearance_near"
    )
    wall.Placement.Base.y = 9
    doc.recompute()
    assert check.ViewObject.Proxy.getIcon() == icon("SweptVolume_Clearance_stale")
    clearance.compute(check)
    assert check.ViewObject.Proxy.getIcon() == icon("SweptVolume_Clearance_clash")
    wall.Placement.Base.y = 40
    doc.recompute()
    clearance.compute(check)
    assert check.ViewObject.Proxy.getIcon() == icon("SweptVolume_Clearance")
    assert all(os.path.isfile(icon("SweptVolume_Clearance_" + k)) for k in ("near", "clash"))
    # A double click and Edit open the panel of each object; FreeCAD does not stay in edit mode.
    shown = Gui.getDocument(doc.Name)
    for obj in (path, hull, body, check):
        for begin in (
            lambda: obj.ViewObject.Proxy.doubleClicked(obj.ViewObject),
            lambda: shown.setEdit(obj.Name, 0),
        ):
            begin()
            yield lambda: not no_panel()
            yield 0.3
            assert shown.getInEdit() is None
            QtWidgets.QApplication.processEvents()
            for button in Gui.getMainWindow().findChildren(QtWidgets.QPushButton):
                if button.isVisible() and button.text().replace("&", "") in ("Cancel", "Close"):
                    QtCore.QTimer.singleShot(0, button.click)
                    break
            yield no_panel
            yield 0.2
    # A failed result has another icon than one that is up to date or stale.
    made = ((hull, "Envelope"), (body, "Solid"), (check, "Clearance"))
    assert [obj.Status for obj, _ in made] == [envelope.UP_TO_DATE] * 3
    seen = {obj.Name: [drawn(obj.Label)] for obj, _ in made}
    path.Times = [0, 2]
    doc.recompute()
    yield 0.3
    assert [obj.Status for obj, _ in made] == [envelope.STALE] * 3, [o.Status for o, _ in made]
    for obj, _ in made:
        seen[obj.Name].append(drawn(obj.Label))
    path.Times = [0, 1]
    doc.recompute()
    most, body.MaxFaces = body.MaxFaces, 1
    doc.recompute()
    with contextlib.suppress(core.CoreError, InputProblem):
        solid.compute(body)
    hull.Motion = None
    doc.recompute()
    yield 0.3
    shot("67_tree_failed")
    yield 0.3
    for obj, name in made:
        assert obj.Status == envelope.FAILED, (obj.Name, obj.Status)
        assert obj.ViewObject.Proxy.getIcon() == icon("SweptVolume_" + name + "_failed")
        seen[obj.Name].append(drawn(obj.Label))
        current, stale, failed = seen[obj.Name]
        assert failed != current and failed != stale and stale != current, obj.Name
    hull.Motion, body.MaxFaces = path, most
    doc.recompute()
    yield 0.3
    assert all(drawn(obj.Label) == seen[obj.Name][0] for obj, _ in made)
    # Undo and a deleted motion keep the tree in order.
    other = motion.motion_from_poses(doc, [0, 1], places)
    other.Label = "Other"
    doc.recompute()
    hull.Motion = other
    yield 0.5
    assert items(doc)["Envelope"] == ["Other"], items(doc)
    doc.removeObject(other.Name)
    yield 0.5
    assert items(doc)["Envelope"] == ["Tree"], items(doc)
    App.closeDocument(doc.Name)
    yield


run(scenario)
