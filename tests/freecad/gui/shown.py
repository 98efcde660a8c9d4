# SPDX-License-Identifier: LGPL-2.1-or-later
"""Parts count as visible if FreeCAD draws them: elements of link arrays and of groups of links, members of
plain groups and of part containers, each shown and hidden.
"""
import os
import sys

sys.path.insert(0, os.path.dirname(os.path.realpath(__file__)))
from driver import App, new_document, open_workbench, run, say, shot, view_from  # noqa: E402

V = App.Vector
SIZE = 10


def box(doc, name, x, y):
    obj = doc.addObject("Part::Box", name)
    obj.Placement.Base = V(x, y, 0)
    return obj


def scene(doc):
    """Returns the position of each part: {path: corner}."""
    pin = doc.addObject("Part::Box", "Pin")
    row = doc.addObject("App::Link", "Row")
    row.LinkedObject, row.ShowElement, row.ElementCount = pin, False, 3
    row.PlacementList = [App.Placement(V(20 * k, 0, 0), App.Rotation()) for k in range(3)]
    several = doc.addObject("App::LinkGroup", "Several")
    several.setLink([box(doc, "Peg", 0, 40), box(doc, "Stop", 20, 40), box(doc, "Post", 40, 40)])
    plain = doc.addObject("App::DocumentObjectGroup", "Plain")
    plain.addObjects([box(doc, "Loose", 0, 80), box(doc, "Lost", 20, 80)])
    holder, inner = (
        doc.addObject("App::Part", "Holder"),
        doc.addObject("App::DocumentObjectGroup", "Inner"),
    )
    holder.addObject(inner)
    inner.addObjects([box(doc, "Held", 0, 120), box(doc, "Hidden", 20, 120)])
    away = doc.addObject("App::Part", "Away")
    away.addObject(box(doc, "Member", 40, 120))
    doc.recompute()
    places = {("Row", str(k) + "."): (20 * k, 0) for k in range(3)}
    for k, name in enumerate(("Peg", "Stop", "Post")):
        places["Several", name + "."] = 20 * k, 40
    for k, name in enumerate(("Loose", "Lost")):
        places["Plain", name + "."] = 20 * k, 80
    places["Holder", "Inner.Held."], places["Holder", "Inner.Hidden."] = (0, 120), (20, 120)
    places["Away", "Member."] = 40, 120
    return places


def hide(doc):
    """Shows and hides as a user does in the tree: plain groups hide their members, which are then shown
    one by one."""
    doc.Pin.Visibility = False
    doc.Row.setElementVisible("1", False)
    doc.Several.setElementVisible("Peg", False)
    doc.Stop.Visibility = False  # the group of links shows it all the same
    doc.Plain.Visibility = False
    doc.Loose.Visibility = True
    doc.Inner.Visibility = False
    doc.Held.Visibility = True
    doc.Away.Visibility = False


def drawn(places):
    """A generator that returns the paths of the parts at whose corner something is drawn, seen from above."""
    view, half = view_from("Top"), SIZE / 2
    yield 1.0
    found = set()
    for path, (x, y) in places.items():
        point = view.getPointOnScreen(V(x + half, y + half, SIZE))
        if view.getObjectInfo(point):
            found.add(path)
    return found


def taken(doc):
    from sweptvolume import convert
    from sweptvolume.features import containers

    roots = [root for root in containers.standing(doc) if convert.is_shown(root)]
    return {(root.Name, path) for root in roots for _, path in convert.leaves(root) if path}


def scenario():
    open_workbench()
    yield
    doc = new_document("Shown")
    places = scene(doc)
    yield 0.5
    seen = yield from drawn(places)
    assert seen == taken(doc) == set(places), (seen, taken(doc))
    hide(doc)
    doc.recompute()
    yield 0.5
    seen = yield from drawn(places)
    shot("98_shown")
    yield 0.3
    say("drawn: {}".format(sorted(seen)))
    assert seen == taken(doc), (sorted(seen), sorted(taken(doc)))
    assert len(seen) == 6, sorted(seen)
    App.closeDocument(doc.Name)
    yield


run(scenario)
