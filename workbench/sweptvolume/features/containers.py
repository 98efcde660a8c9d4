# SPDX-License-Identifier: LGPL-2.1-or-later
"""Links from objects of this workbench to parts in groups (App::Part and similar). A group depends
on its contents. So if an object is in a group, a link from this object to the group would be
circular. A link through a group also breaks if the part leaves the group. Therefore these links
begin at the part itself, below all groups. Such a link does not report moves of a group; _Observer
does.
"""
import FreeCAD as App

from .. import convert
from . import status
from .base import kind_of

#: Properties that hold paths to parts.
_LISTS, _SINGLES = ("MovingParts", "Neighbours", "Parts"), ("Reference",)

_observer = None


def is_contained(obj):
    """Returns whether a group or a link array contains an object and shows it in the tree."""
    lists = [getattr(user, "Group", []) + getattr(user, "ElementList", []) for user in obj.InList]
    return any(obj in members for members in lists)


def standing(document):
    """Returns the objects at the top level of the document that may show solids or meshes, hidden
    or not.

    Document.RootObjects is not suitable: it contains only objects that no other object refers to.
    """
    return [
        o for o in document.Objects if not kind_of(o) and _has_geometry(o) and not is_contained(o)
    ]


def _has_geometry(obj):
    """Returns whether an object may show solids or meshes, itself or as a group or a link."""
    names = ("Shape", "Mesh", "Group", "LinkedObject", "ElementList")
    return hasattr(obj, "Visibility") and any(hasattr(obj, name) for name in names)


def around(obj):
    """Returns all groups that hold an object, directly or through other groups."""
    found, waiting = [], [obj]
    while waiting:
        now = waiting.pop()
        for user in now.InList:
            if user not in found and now in getattr(user, "Group", []):
                found.append(user)
                waiting.append(user)
    return found


def inside(group):
    """Returns all objects in a group, also through other groups."""
    found, waiting = [], [group]
    while waiting:
        for member in getattr(waiting.pop(), "Group", []):
            if member not in found:
                found.append(member)
                waiting.append(member)
    return found


def links_for(holder, pairs):
    """Converts (root, sub) pairs to links that `holder` may have; convert.pairs_of() is the
    inverse. If a pair is a whole group around the holder, its other members replace it."""
    outer, found, waiting = around(holder), [], list(reversed(pairs))
    while waiting:
        root, sub = waiting.pop()
        child = _member_on_path(root, sub)
        if child is not None:
            waiting.append((child, sub.split(".", 1)[1]))
        elif root not in outer or sub:
            found.append((root, sub))
        else:
            parts = [o for o in root.Group if convert.is_shown(o) or o in outer]
            waiting += [(o, "") for o in reversed(parts) if not kind_of(o)]
    return found


def _member_on_path(root, sub):
    """Returns the direct member of the group `root` through which a path leads, or None if the path
    leads through a link."""
    if "." not in sub or "Group" not in root.PropertiesList:
        return None
    child = root.getSubObject(sub.split(".", 1)[0] + ".", retType=1)
    return child if child in root.Group else None


def set_pairs(holder, name, pairs):
    """Writes pairs into a link property of an object of this workbench if they differ from its
    value."""
    links = links_for(holder, pairs)
    if name in _SINGLES:
        links = links[:1]
    if convert.links_in(getattr(holder, name)) == links:
        return
    if name in _SINGLES:
        setattr(holder, name, (links[0][0], [links[0][1]]) if links else None)
    else:
        setattr(holder, name, links)


def shorten(holder):
    """Rewrites the links of an object of this workbench so that they begin below the groups around
    it."""
    for name in _LISTS + _SINGLES:
        if name in holder.PropertiesList:
            set_pairs(holder, name, convert.pairs_of(getattr(holder, name)))
    shorten_links = getattr(holder.Proxy, "shorten_links", None)
    if shorten_links is not None:
        shorten_links(holder)


def _touch_checks(document, but=None):
    """Touches all checks with AllVisible except `but`, so that the next recompute compares their
    inputs."""
    for check in document.Objects:
        if check is not but and getattr(check, "AllVisible", False) and kind_of(check):
            check.touch()


def _touch_users(obj):
    """Touches the objects of this workbench that use an object or a group around it."""
    for used in [obj] + around(obj):
        for ours in used.InList:
            if kind_of(ours):
                ours.touch()


def _update_labels_in_users(obj):
    """Updates the objects of this workbench that show the label of an object. FreeCAD does not
    recompute them after a change of a label. Undo restores the texts by itself."""
    for ours in obj.InListRecursive:
        if kind_of(ours) and ours.Proxy.NAMES_PARTS:
            if ours.Document.Transacting:
                ours.touch()
            else:
                status.compare_again(ours)


def _update_users_of_failed(broken):
    """Updates the objects of this workbench that depend on a failed object. FreeCAD's recompute
    stops at the failed object and does not reach them. An example is a link that shows nothing
    because its target, or the target's document, is gone."""
    for ours in broken.InListRecursive:
        if kind_of(ours):
            status.compare_again(ours)
            status.update_users(ours)


class _Observer:
    """Notices changes that FreeCAD's links do not report: objects are added to a group or removed
    from it, groups are moved, objects are shown, hidden, renamed or created, and inputs fail. After
    Undo, it only marks objects as touched, because Undo restores the links itself.

    Runs at each change of any property. CPU time of a change with and without this observer: 58 and
    55 us for a length, 8 and 4 us for a placement, 36 and 28 us for a name. A recompute of 1,000
    objects takes no longer.

    Without it, results would stay "Up to date" after a group was moved, a part hidden, or a link's
    target lost (test_states_in_groups.py, test_states_of_other_documents.py)."""

    def slotChangedObject(self, obj, name):  # noqa: N802
        if name not in ("Visibility", "VisibilityList", "Group", "Placement", "Label"):
            return
        document = obj.Document
        if document.Restoring:
            return
        if name == "Label":
            _update_labels_in_users(obj)
        elif name in ("Visibility", "VisibilityList"):  # VisibilityList: property of a link array
            if not kind_of(obj):
                _touch_users(obj)
        elif hasattr(obj, "Group"):
            if name == "Placement":
                for member in inside(obj):
                    for ours in [member] + member.InList:
                        if kind_of(ours):
                            ours.touch()
                return
            for holder in [o for o in document.Objects if kind_of(o)]:
                if not document.Transacting:
                    shorten(holder)
                holder.touch()  # its inputs or the visible parts may have changed

    def slotCreatedObject(self, obj):  # noqa: N802
        if not obj.Document.Restoring:
            _touch_checks(obj.Document, obj)

    def slotRecomputedDocument(self, document):  # noqa: N802
        if not document.isTouched():  # failed objects stay touched
            return
        for obj in document.Objects:
            if "Invalid" in obj.State:
                _update_users_of_failed(obj)

    def slotDeletedObject(self, obj):  # noqa: N802
        """Removes links to a deleted object from checks. Undo may delete an object to which such a
        link still leads, because the links are set outside the undo record."""
        for check in set(obj.InList):
            if kind_of(check) and obj in getattr(check, "Seen", []):
                check.Seen = [seen for seen in check.Seen if seen is not obj]


def watch():
    """Installs the observer, once."""
    global _observer
    if _observer is None:
        _observer = _Observer()
        App.addDocumentObserver(_observer)
