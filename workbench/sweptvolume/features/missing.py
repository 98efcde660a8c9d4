# SPDX-License-Identifier: LGPL-2.1-or-later
"""Remembers inputs that were deleted. FreeCAD removes a deleted object from all links, and then
nothing shows that an input is missing; a run could use another motion, or only the remaining parts.
So each object of this workbench keeps the name of a deleted input until another input is chosen, or
until undo restores it.
"""
import json

import FreeCAD as App

from .. import convert
from ..convert import InputProblem
from ..texts import translate
from .base import kind_of, stored

#: Hidden property: [{property, label, name, left}]. left: what remained in the property.
PROPERTY = "Missing"
_SHAPE = [{"property": str, "label": str, "name": str, "left": [(str, str)]}]

_observer = None


def _value(holder, name):
    """Returns the value of a link property as a flat list of [object name, sub]."""
    value = getattr(holder, name)
    if value is None:
        return []
    if isinstance(value, App.DocumentObject):
        return [[value.Name, ""]]
    if isinstance(value, list) and all(isinstance(v, App.DocumentObject) for v in value):
        return [[v.Name, ""] for v in value]
    return [[obj.Name, sub] for obj, sub in convert.links_in(value)]


def _links(holder):
    """Returns the names of the properties that are inputs. Leaves out rules, which belong to their
    parts."""
    for name in holder.PropertiesList:
        kind = holder.getTypeIdOfProperty(name)
        if (
            kind.startswith("App::PropertyLink")
            and not kind.endswith("Hidden")
            and name not in ("Seen", "RuleParts")
        ):
            yield name


def _read(holder):
    text = getattr(holder, PROPERTY, "")
    return (stored(text, _SHAPE) or []) if text else []


def _write(holder, found):
    text = json.dumps(found) if found else ""
    if getattr(holder, PROPERTY) != text:
        setattr(holder, PROPERTY, text)


def text(holder):
    """Returns the text about deleted inputs of this object, or "" if there are none."""
    found = [
        entry
        for entry in _read(holder)
        if entry["property"] in holder.PropertiesList
        and _value(holder, entry["property"]) == entry["left"]
    ]
    if not found:
        return ""
    return translate(
        "SweptVolume",
        "{0} was deleted, and {1} needs it: choose a replacement in the property {2}, or undo "
        "the deletion.",
    ).format(
        ", ".join('"{}"'.format(entry["label"]) for entry in found),
        '"{}"'.format(holder.Label),
        ", ".join(sorted({entry["property"] for entry in found})),
    )


def check(holder):
    """Raises InputProblem with the names of deleted inputs."""
    problem = text(holder)
    if problem:
        raise InputProblem(problem)


def forget(holder, name=None):
    """Forgets the deleted inputs of one property, or without a name all of them, because new inputs
    were chosen."""
    found = _read(holder)
    if found:
        kept = [entry for entry in found if name is not None and entry["property"] != name]
        _write(holder, kept)


def rename(holder, names):
    """Updates the names of inputs. names: {old: new}."""
    found = _read(holder)
    for entry in found:
        entry["property"] = names.get(entry["property"], entry["property"])
    if found:
        _write(holder, found)


def changed(holder, name):
    """Handles a change of a property: its deleted inputs are no longer missing. The deletion itself
    also changes the property, but then the deleted object still exists."""
    document = holder.Document
    if (
        document is None
        or getattr(document, "Restoring", False)
        or not getattr(holder, PROPERTY, "")
    ):
        return
    if document.Transacting:
        return
    entries = [entry for entry in _read(holder) if entry["property"] == name]
    if entries and all(document.getObject(entry["name"]) is None for entry in entries):
        forget(holder, name)


class _Observer:
    """Is called before an object is deleted, while links to it still exist. Also calls lost(holder,
    object) of the proxies that have this method."""

    def slotDeletedObject(self, obj):  # noqa: N802
        document = obj.Document
        if document is None or document.Transacting or document.Restoring:
            return
        for holder in set(obj.InList):
            if not kind_of(holder) or PROPERTY not in holder.PropertiesList:
                continue
            found = _read(holder)
            for name in _links(holder):
                value = _value(holder, name)
                left = [pair for pair in value if pair[0] != obj.Name]
                if left != value:
                    found = [e for e in found if e["property"] != name or e["left"] == value]
                    for entry in found:
                        if entry["property"] == name:
                            entry["left"] = left
                    entry = {"property": name, "label": obj.Label, "name": obj.Name, "left": left}
                    found.append(entry)
            _write(holder, found)
            lost = getattr(holder.Proxy, "lost", None)
            if lost is not None:
                lost(holder, obj)


def watch():
    """Installs the observer, once."""
    global _observer
    if _observer is None:
        _observer = _Observer()
        App.addDocumentObserver(_observer)
