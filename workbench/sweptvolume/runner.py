# SPDX-License-Identifier: LGPL-2.1-or-later
"""Long work beside the GUI: a thread that computes, a timer that watches, a result that is applied
on the GUI thread.

A task has `document`, `watched` (objects it needs to the end), `title`, `work(control)` (any thread,
plain values only), `finish(value)` (GUI thread, inside one transaction), and optionally
`fail(text, cancelled)` and `room(value)`. If the document closes or a watched object goes, the run is
cancelled and finish() is never called.
"""
import FreeCAD as App
from PySide import QtCore

from . import core
from .texts import translate

#: ms between two looks at the progress.
POLL = 100
#: ms until a result that was taken over is freed: the window draws it first.
FORGET = 400
#: Bytes from which on memory for the result is fetched beforehand.
LARGE = 8 << 20

_runs = []
_observer = None


class Task:
    """What a run does; see the module's head."""

    title = ""
    document = None
    watched = ()
    #: Whether finish() changes the document: then it runs in a transaction and failures are told.
    writes = True

    def work(self, control):
        raise NotImplementedError

    def room(self, value):
        """Bytes of memory that finish() is going to fill; 0: little."""
        return 0

    def finish(self, value):
        raise NotImplementedError

    def fail(self, text, cancelled=False):
        """A run that gave nothing, for the document to remember."""


class _Thread(QtCore.QThread):
    def __init__(self, task, control):
        super().__init__()
        self.task = task
        self.control = control
        self.value = None
        self.error = None

    def run(self):
        try:
            self.value = self.task.work(self.control)
        except Exception as error:  # shown by Run._conclude
            self.error = error


class _Fetching(QtCore.QThread):
    """Fetches memory for finish(): in the window's thread that would take longer than to fill it."""

    def __init__(self, warm):
        super().__init__()
        self.warm = warm

    def run(self):
        self.warm.touch()


class Run(QtCore.QObject):
    """One running task. `ended` is emitted exactly once, on the GUI thread."""

    progress = QtCore.Signal(float, str)
    ended = QtCore.Signal(object)

    def __init__(self, task):
        super().__init__()
        self.task = task
        self.control = core.Control()
        self.state = "running"  # then ok | failed | cancelled
        self.message = ""
        self._document = task.document.Name
        self._watched = {obj.Name for obj in task.watched}
        self._gone = False
        self._thread = _Thread(task, self.control)
        self._thread.finished.connect(self._worked)
        self._fetching = None
        self._timer = QtCore.QTimer()
        self._timer.timeout.connect(self._look)

    def start(self):
        _runs.append(self)
        _watch()
        self._timer.start(POLL)
        self._thread.start()
        for obj in self.task.watched:
            _refresh_icon(obj)

    def cancel(self):
        """Asks the run to stop; it ends within a quarter of a second."""
        self.control.cancel()

    def concerns(self, obj):
        return obj.Document.Name == self._document and obj.Name in self._watched

    def lose(self, document, name=None):
        """The document closes, or one of its objects goes."""
        if document == self._document and (name is None or name in self._watched):
            self._gone = True
            self.cancel()

    def wait(self):
        self._thread.wait()
        if self._fetching is not None:
            self._fetching.wait()

    def _look(self):
        self.progress.emit(self.control.progress(), self.control.phase())

    def _worked(self):
        self._thread.wait()
        if self._thread.error is None and not self._gone:
            try:
                self._fetch_room()
            except Exception as error:  # shown by _conclude
                self._thread.error = error
        if self._fetching is None:
            self._ended()

    def _fetch_room(self):
        room = self.task.room(self._thread.value)
        if room < LARGE:
            return
        fetching = _Fetching(core.warm_memory(room))
        fetching.finished.connect(self._ended)
        fetching.start()
        self._fetching = fetching

    def _ended(self):
        self._timer.stop()
        self.wait()
        if self._fetching is not None:
            self._fetching.warm.release()
        _runs.remove(self)
        if self._gone:
            self.state = "cancelled"
            self.message = translate("Messages", "Cancelled: the document or an object is gone.")
        else:
            try:
                self._conclude()
            except Exception as error:  # of fail(): the run ends all the same
                self.state, self.message = "failed", str(error) or type(error).__name__
                App.Console.PrintError("{}: {}\n".format(self.task.title, self.message))
            for obj in self.task.watched:
                _refresh_icon(obj)
        self._fetching = None
        QtCore.QTimer.singleShot(FORGET, self._forget)
        self.ended.emit(self)

    def _forget(self):
        """Gives the result back: it may be large, and the run lives on for a while."""
        self._thread.value = None

    def _conclude(self):
        error = self._thread.error
        if error is None:
            try:
                if self.task.writes:
                    _in_transaction(self.task, lambda: self.task.finish(self._thread.value))
                else:
                    self.task.finish(self._thread.value)
                self.state = "ok"
                return
            except Exception as problem:
                error = problem
        if isinstance(error, core.CoreError) and error.status == "Cancelled":
            self.state = "cancelled"
            self.message = str(error)
            self.task.fail(self.message, cancelled=True)
            return
        self.state = "failed"
        self.message = str(error) or type(error).__name__
        if self.task.writes:
            App.Console.PrintError("{}: {}\n".format(self.task.title, self.message))
        self.task.fail(self.message)


def _in_transaction(task, action):
    document = task.document
    document.openTransaction(task.title)
    try:
        action()
    except BaseException:
        document.abortTransaction()
        raise
    document.commitTransaction()


def _refresh_icon(obj):
    view = getattr(obj, "ViewObject", None)
    if view is not None and hasattr(view, "signalChangeIcon"):
        view.signalChangeIcon()


def is_running(obj):
    """Whether a run is under way for an object (for icons and commands)."""
    return any(run.concerns(obj) for run in _runs)


def running():
    """The runs under way."""
    return list(_runs)


def start(task):
    """Starts a task and returns its Run."""
    run = Run(task)
    run.start()
    return run


class _Observer:
    """Hears of documents that close and objects that go."""

    def slotDeletedDocument(self, document):
        for run in list(_runs):
            run.lose(document.Name)

    def slotDeletedObject(self, obj):
        for run in list(_runs):
            run.lose(obj.Document.Name, obj.Name)


def _watch():
    global _observer
    if _observer is None:
        _observer = _Observer()
        App.addDocumentObserver(_observer)
        application = QtCore.QCoreApplication.instance()
        if application is not None:
            application.aboutToQuit.connect(_stop_all)


def _stop_all():
    for run in list(_runs):
        run.lose(run._document)
        run.wait()
