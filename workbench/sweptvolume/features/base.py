# SPDX-License-Identifier: LGPL-2.1-or-later
"""Base of all document objects. Adds only properties that are missing. The proxies themselves store
nothing in documents."""
import contextlib
import json

import FreeCAD as App

from ..texts import QT_TRANSLATE_NOOP
from . import renamed

READ_ONLY = 1
HIDDEN = 2

#: States of a result. Documents store these texts; views translate them.
NOT_COMPUTED = QT_TRANSLATE_NOOP("SweptVolume", "Not computed")
UP_TO_DATE = QT_TRANSLATE_NOOP("SweptVolume", "Up to date")
STALE = QT_TRANSLATE_NOOP("SweptVolume", "Stale")
CANCELLED = QT_TRANSLATE_NOOP("SweptVolume", "Cancelled")
FAILED = QT_TRANSLATE_NOOP("SweptVolume", "Failed")


class Feature:
    """Base of the proxies. Subclasses define KIND and properties(), a list of tuples (type, name,
    group, help, default, editor mode)."""

    KIND = ""
    #: Whether texts of the object contain the labels of its inputs.
    NAMES_PARTS = False

    def __init__(self, obj):
        self.add_properties(obj)
        obj.Proxy = self

    def properties(self):
        return []

    def add_properties(self, obj):
        """Adds missing properties. Documents of earlier versions gain new properties this way."""
        for kind, name, group, text, default, mode in self.properties():
            choice = kind == "App::PropertyEnumeration" and isinstance(default, list)
            if choice and name in obj.PropertiesList and getattr(obj, name) is None:
                # The property is damaged. In FreeCAD 1.0, it would not accept a value any more.
                obj.removeProperty(name)
            if name not in obj.PropertiesList:
                obj.addProperty(kind, name, group, text)
                if default is not None:
                    setattr(obj, name, default)
            elif choice:
                now = getattr(obj, name)
                if obj.getEnumerationsOfProperty(name) != default:
                    setattr(obj, name, default)
                if getattr(obj, name) != now:
                    setattr(obj, name, now if now in default else default[0])
            if obj.getDocumentationOfProperty(name) != text:
                obj.setDocumentationOfProperty(name, text)  # earlier versions stored translations
            if mode:
                obj.setEditorMode(name, mode)

    def onDocumentRestored(self, obj):
        self.add_properties(obj)
        with quietly(obj):
            renamed.move_values(obj, renamed.RENAMED.get(self.KIND, {}))

    def refresh_status(self, obj):
        """If there is a stored result, compares its inputs with the present ones, and sets the
        state."""

    def dumps(self):
        return None

    def loads(self, state):
        return None

    __getstate__ = dumps

    def __setstate__(self, state):
        return None


class Result(Feature):
    """Base of the proxies of objects with a result."""

    def __init__(self, obj):
        super().__init__(obj)
        obj.Status = NOT_COMPUTED


def inputs_and_results(inputs, results):
    """Returns the list of Feature.properties() for inputs (type, name, help, default) and results
    (type, name, help, editor mode)."""
    given = [(kind, name, "Input", text, default, 0) for kind, name, text, default in inputs]
    return given + [(kind, name, "Result", text, None, mode) for kind, name, text, mode in results]


def fits(value, shape):
    """Returns whether a value from JSON has a given shape. A shape is one of: a type (float for any
    number); a set of allowed values; a dict of required keys with shapes; [shape of all items];
    (shape of each item, ...)."""
    if isinstance(shape, dict):
        return isinstance(value, dict) and all(
            k in value and fits(value[k], shape[k]) for k in shape
        )
    if isinstance(shape, (list, tuple)):
        if not isinstance(value, list):
            return False
        shapes = shape * len(value) if isinstance(shape, list) else shape
        return len(value) == len(shapes) and all(map(fits, value, shapes))
    if isinstance(shape, set):
        return isinstance(value, str) and value in shape
    return isinstance(value, (int, float) if shape is float else shape)


def stored(text, shape):
    """Returns the JSON value stored in a document, or None if it is damaged (not JSON, or of
    another shape)."""
    try:
        value = json.loads(text)
    except ValueError:
        return None
    return value if fits(value, shape) else None


def kind_of(obj):
    """Returns the KIND of an object of this workbench, or "" for other objects."""
    return getattr(getattr(obj, "Proxy", None), "KIND", "")


def objects_of_kind(document, kind):
    return [obj for obj in document.Objects if kind_of(obj) == kind]


def set_changed(obj, name, value):
    """Sets a property only if its value changes. This avoids needless recomputes and undo entries."""
    if getattr(obj, name) != value:
        setattr(obj, name, value)


def whole(pieces):
    """Runs a generator to its end and returns its return value."""
    while True:
        try:
            next(pieces)
        except StopIteration as end:
            return end.value


@contextlib.contextmanager
def quietly(obj):
    """Context in which changes of the object cause no recompute."""
    touched = "Touched" in obj.State
    yield
    if not touched:
        obj.purgeTouched()


def add_object(document, kind, name, proxy, label, settings, view):
    """Adds an object to the document: its proxy (class), label, settings (dict of property values)
    and view provider ("module:Class")."""
    obj = document.addObject(kind, name)
    proxy(obj)
    obj.Label = label
    for key, value in settings.items():
        setattr(obj, key, value)
    attach_view(obj, view)
    return obj


def attach_view(obj, maker):
    """Attaches the view provider to the object if there is a GUI. `maker` is "module:Class"."""
    if not App.GuiUp or getattr(obj, "ViewObject", None) is None:
        return
    import importlib

    module, name = maker.split(":")
    getattr(importlib.import_module(module), name)(obj.ViewObject)
