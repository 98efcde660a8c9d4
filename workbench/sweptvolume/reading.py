# SPDX-License-Identifier: LGPL-2.1-or-later
"""Parts that are too large to be read at once are read beside the window: copied one after the other between
its events, then read in a thread.
"""
import FreeCAD as App
from PySide import QtCore

from . import contents, core, runner
from .convert import InputProblem
from .features import status
from .features.base import quietly
from .texts import translate

_readers = {}  # document's name -> Reader


class _ReadTask(runner.Task):
    """Changes no document."""

    writes = False

    def __init__(self, document, parts):
        self.title, self.document = translate("Messages", "Read parts"), document
        self.parts = parts

    def work(self, control):
        for part in self.parts:
            if control.is_cancelled():
                raise core.cancelled()
            part.text()

    def finish(self, value):
        pass


class Reader:
    """Reads the parts of one document, and calls whoever waits for them when all are read."""

    def __init__(self, document):
        self.document, self.name = document, document.Name
        self._parts, self._calls = [], {}

    def ask(self, parts, key, call):
        """Parts (apart.Apart) that are to be read; call() follows in the window's thread, once for each
        key."""
        begins = not self._calls
        self._parts += [part for part in parts if part not in self._parts]
        self._calls[key] = call
        if begins:
            QtCore.QTimer.singleShot(0, self._copy)

    def _copy(self):
        """One part between two events of the window."""
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
            self._copy()  # others were asked for meanwhile
            return
        self._parts, calls = [], list(self._calls.values())
        self._calls = {}
        for call in calls:
            call()


def beside(document, parts, key, call):
    """As Reader.ask()."""
    reader = _readers.get(document.Name)
    if reader is None or reader.document is not document:
        reader = _readers[document.Name] = Reader(document)
    reader.ask(parts, key, call)


def first(document, words, key, call):
    """Whether parts are so large that they have to be read first; call() follows then. words: gives
    contents.words(); what it raises is left to whoever asks next."""
    try:
        parts = contents.unread(words())
    except (InputProblem, RuntimeError, AttributeError):
        return False
    if not contents.is_much(parts):
        return False
    beside(document, parts, key, call)
    return True


def _look_later(obj, parts):
    document, name = obj.Document, obj.Name

    def look():
        again = document.getObject(name)
        if again is not None:
            with quietly(again):
                again.Proxy.look(again)
            status.tell_users(again)

    beside(document, parts, name, look)


def watch():
    """From now on objects with large parts are judged when those were read beside the window."""
    status.read_beside = _look_later
