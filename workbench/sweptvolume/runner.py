# SPDX-License-Identifier: LGPL-2.1-or-later
"""Long work beside the GUI: a thread that computes, a timer that watches, a result that is applied
on the GUI thread.

A task has `document`, `watched` (objects it needs to the end), `title`, `work(control)` (any thread,
plain values only), `finish(value)` (GUI thread, inside one transaction), and what else the class Task
names. If the document closes or a watched object goes, the run is cancelled and finish() is never
called. A run that is asked to stop ends at once for whoever waits for it, even where its thread is in a
piece of work that cannot be broken off.
"""
import atexit
import contextlib
import os
import time

import FreeCAD as App
from PySide import QtCore

from . import core
from .texts import translate

#: ms between two looks at the progress.
POLL = 100
#: ms until a result that was taken over is freed: the window draws it first.
FORGET = 400
#: ms that a cancelled run has to end by itself: with a look of the window an answer within 0.3 s.
GRACE = 150
#: s that all threads have to end in when FreeCAD closes: with what it does itself, below 2 s.
LEAVE = 1.0
#: Bytes from which on memory for the result is fetched beforehand.
LARGE = 8 << 20

_runs = []
#: Threads of runs that have ended without them.
_left = []
_observer = None


class Task:
    """What a run does; see the module's head."""

    title = ""
    document = None
    watched = ()
    #: Whether finish() changes the document: then it runs in a transaction and failures are told.
    writes = True

    def steps(self, control):
        """GUI thread, before work(): what only the window can do, in pieces. A generator; after each piece
        the window goes on for the ms that it yields."""
        return iter(())

    def work(self, control):
        raise NotImplementedError

    def room(self, value):
        """Bytes of memory that finish() is going to fill; 0: little."""
        return 0

    def finish(self, value):
        raise NotImplementedError

    def after(self, value):
        """GUI thread, after finish(): what must not be kept for Undo."""

    def drop(self, value):
        """A result that nobody takes: removes the files that it stands for."""

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
        self._steps = None  # those that are left, while there are any
        self._timer = QtCore.QTimer()
        self._timer.timeout.connect(self._look)

    def start(self):
        _runs.append(self)
        _watch()
        self._timer.start(POLL)
        self._steps = self.task.steps(self.control)
        self._step()
        for obj in self.task.watched:
            _refresh_icon(obj)

    def _step(self):
        """The next piece of the task's steps; the thread after the last."""
        if self._steps is None:
            return  # it was cancelled meanwhile
        try:
            pause = next(self._steps)
        except StopIteration:
            self._steps = None
            self._thread.start()
        except Exception as error:  # shown by _conclude
            self._steps, self._thread.error = None, error
            self._ended(wait=False)
        else:
            QtCore.QTimer.singleShot(int(pause or 0), self._step)

    def cancel(self):
        """Asks the run to stop; it ends within GRACE."""
        self.control.cancel()
        if self._steps is None:
            QtCore.QTimer.singleShot(GRACE, self._leave)
        else:
            QtCore.QTimer.singleShot(0, self._leave_steps)

    def _leave_steps(self):
        """Ends a run whose thread has not begun."""
        steps, self._steps = self._steps, None
        if steps is not None and self.state == "running":
            steps.close()
            self._thread.error = core.cancelled()
            self._ended(wait=False)

    def _leave(self):
        """Ends a run whose thread has not answered: the thread goes on alone until it looks up, and what
        it finds is dropped."""
        if self.state != "running" or self._thread.isFinished() or self._fetching is not None:
            return
        self._thread.finished.disconnect(self._worked)
        _left.append(self._thread)
        self._thread.finished.connect(self._come_late)
        self._thread.error = core.cancelled()
        self._ended(wait=False)

    def _come_late(self):
        _left.remove(self._thread)
        self._forget()

    def concerns(self, obj):
        return obj.Document.Name == self._document and obj.Name in self._watched

    def lose(self, document, name=None):
        """The document closes, or one of its objects goes."""
        if document == self._document and (name is None or name in self._watched):
            self._gone = True
            self.cancel()

    def threads(self):
        """Its threads that may be at work."""
        return [thread for thread in (self._thread, self._fetching) if thread is not None]

    def _wait(self):
        for thread in self.threads():
            thread.wait()

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

    def _ended(self, wait=True):
        self._timer.stop()
        if wait:
            self._wait()
        if self._fetching is not None:
            self._fetching.warm.release()
        _runs.remove(self)
        if self._gone:
            self.state = "cancelled"
            self.message = translate(
                "Messages", "Cancelled: the document was closed, or an object was deleted."
            )
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
        value = self._thread.value
        if self._thread not in _left and value is not None:
            self._thread.value = None
            if self.state != "ok":
                self.task.drop(value)

    def _conclude(self):
        error = self._thread.error
        if error is None:
            try:
                writing = transaction(self.task.document, self.task.title)
                with writing if self.task.writes else contextlib.nullcontext():
                    self.task.finish(self._thread.value)
                self.task.after(self._thread.value)
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
        # The panel and the object's Message tell it; the report view would open itself for an error.
        App.Console.PrintLog("{}: {}\n".format(self.task.title, self.message))
        self.task.fail(self.message)


@contextlib.contextmanager
def transaction(document, title):
    """One undo step; an error undoes what the block did."""
    document.openTransaction(title)
    try:
        yield
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
    """FreeCAD closes: waits a moment for the threads, and leaves the process without those that stay."""
    threads = list(_left)
    for run in list(_runs):
        run.lose(run._document)
        threads += run.threads()
    until = time.monotonic() + LEAVE
    for thread in threads:
        thread.wait(max(1, int(1000 * (until - time.monotonic()))))
    if any(thread.isRunning() for thread in threads):
        _left.extend(thread for thread in threads if thread not in _left)
        # Python ends last, after FreeCAD has written its settings; Qt would end the process with an
        # error for a thread that still runs.
        atexit.register(os._exit, 0)
