# SPDX-License-Identifier: LGPL-2.1-or-later
"""Reads large parts without blocking the window. Parts are copied one after the other between
events of the window, and then read in a thread.
"""
import FreeCAD as App
from PySide import QtCore

from . import contents, core, runner
from .convert import InputProblem
from .features import status
from .features.base import quietly
from .texts import translate

_readers = {}  # name of the document -> Reader


class _ReadTask(runner.Task):
    """A task that does not change the document."""

    writes = False

    def __init__(self, document, parts):
        self.title, self.document = translate("SweptVolume", "Read parts"), document
        self.parts = parts

    def work(self, control):
        for part in self.parts:
            if control.is_cancelled():
                raise core.cancelled()
            part.text()

    def finish(self, value):
        pass


class Reader:
    """Reads the parts of one document, and calls all callbacks when all parts are read."""

    def __init__(self, document):
        self.document, self.name = document, document.Name
        self._parts, self._calls = [], {}

    def ask(self, parts, key, call):
        """Starts to read parts (apart.Apart). When all are read, call() is called in the window's
        thread, once for each key."""
        begins = not self._calls
        self._parts += [part for part in parts if part not in self._parts]
        self._calls[key] = call
        if begins:
            QtCore.QTimer.singleShot(0, self._copy)

    def _copy(self):
        """Copies one part between two events of the window."""
        if self.document not in App.listDocuments().values():
            _readers.pop(self.name, None)
            return
        for part in self._parts:
            if part.cost() and not part.is_detached():
                part.detached()
                QtCore.QTimer.singleShot(0, self._copy)
                return
        run = runner.start(_ReadTask(self.document, list(self._parts)))
        run.ended.connect(self._ended)

    def _ended(self, run):
        if run.state == "cancelled":  # the document was closed
            _readers.pop(self.name, None)
            return
        if run.state == "ok" and any(part.cost() for part in self._parts):
            self._copy()  # other parts were requested meanwhile
            return
        self._parts, calls = [], list(self._calls.values())
        self._calls = {}
        for call in calls:
            call()


def beside(document, parts, key, call):
    """Calls Reader.ask() of the document's reader."""
    reader = _readers.get(document.Name)
    if reader is None or reader.document is not document:
        reader = _readers[document.Name] = Reader(document)
    reader.ask(parts, key, call)


def first(document, words, key, call):
    """Returns whether parts are so large that they must be read first. If so, call() follows when
    they are read. words: a function that returns contents.words(). Its exceptions are ignored here
    and reach the next caller."""
    try:
        parts = contents.unread(words())
    except (InputProblem, RuntimeError, AttributeError):
        return False
    if not contents.is_much(parts):
        return False
    beside(document, parts, key, call)
    return True


def _compare_later(obj, parts):
    document, name = obj.Document, obj.Name

    def compare():
        again = document.getObject(name)
        if again is not None:
            with quietly(again):
                again.Proxy.refresh_status(again)
            status.update_users(again)

    beside(document, parts, name, compare)


def watch():
    """From now on, objects with large parts check for changes only after these were read in the
    background."""
    status.read_beside = _compare_later
