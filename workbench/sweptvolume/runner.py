# SPDX-License-Identifier: LGPL-2.1-or-later
"""Runs long work in the background. A thread computes, a timer watches it, and the GUI thread applies
the result.

A task has `document`, `watched` (objects that it needs until the end), `title`, `work(control)`
(any thread, only plain values), `finish(value)` (GUI thread, inside one transaction), and the other
members of class Task. If the document closes or a watched object is deleted, the run is cancelled
and finish() is never called. A cancelled run ends at once for all callers that wait, even if its
thread cannot stop its present piece of work yet.
"""
import atexit
import contextlib
import os
import time

import FreeCAD as App
from PySide import QtCore

from . import core
from .texts import translate

#: Interval (ms) between two checks of the progress.
POLL = 100
#: Time (ms) after which an applied result is freed. The window is drawn before that.
FORGET = 400
#: Time (ms) in which a cancelled run may end by itself. So Stop takes effect within 0.3 s, including
#: the interval between two checks.
GRACE = 150
#: Time (s) in which all threads must end when FreeCAD closes. With FreeCAD's own work this stays
#: below 2 s.
LEAVE = 1.0
#: For results of at least this many bytes, memory is fetched beforehand (core.warm_memory).
LARGE = 8 << 20

_runs = []
#: Threads that still work although their runs have ended.
_left = []
_observer = None


class Task:
    """The work of a run; see the docstring of the module."""

    title = ""
    document = None
    watched = ()
    #: Whether finish() changes the document. If so, it runs in a transaction, and failures are
    #: shown.
    writes = True

    def steps(self, control):
        """Does work before work() that only the window's thread can do, in pieces. GUI thread. A
        generator that yields, after each piece, the time (ms) for which the window may handle
        events."""
        return iter(())

    def work(self, control):
        raise NotImplementedError

    def room(self, value):
        """Returns the bytes of memory that finish() will fill. 0: little."""
        return 0

    def finish(self, value):
        raise NotImplementedError

    def after(self, value):
        """Called after finish(). Makes changes that do not belong to the undo step. GUI thread."""

    def drop(self, value):
        """Discards a result that was not applied: removes the files that it refers to."""

    def fail(self, text, cancelled=False):
        """Stores the text of a failed run in the document."""


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
    """Fetches memory for finish(). In the window's thread this would take longer than filling the
    memory."""

    def __init__(self, warm):
        super().__init__()
        self.warm = warm

    def run(self):
        self.warm.touch()


class Run(QtCore.QObject):
    """One running task. Emits `ended` exactly once, in the GUI thread."""

    progress = QtCore.Signal(float, str)
    ended = QtCore.Signal(object)

    def __init__(self, task):
        super().__init__()
        self.task = task
        self.control = core.Control()
        self.state = "running"  # later ok, failed or cancelled
        self.message = ""
        self._document = task.document.Name
        self._watched = {obj.Name for obj in task.watched}
        self._gone = False
        self._thread = _Thread(task, self.control)
        self._thread.finished.connect(self._worked)
        self._fetching = None
        self._steps = None  # the generator of the remaining steps, or None
        self._timer = QtCore.QTimer()
        self._timer.timeout.connect(self._emit_progress)

    def start(self):
        _runs.append(self)
        _watch()
        self._timer.start(POLL)
        self._steps = self.task.steps(self.control)
        self._step()
        for obj in self.task.watched:
            _refresh_icon(obj)

    def _step(self):
        """Runs the next piece of the task's steps. Starts the thread after the last piece."""
        if self._steps is None:
            return  # the run was cancelled meanwhile
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
        """Asks the run to stop. It ends within GRACE."""
        self.control.cancel()
        if self._steps is None:
            QtCore.QTimer.singleShot(GRACE, self._leave)
        else:
            QtCore.QTimer.singleShot(0, self._leave_steps)

    def _leave_steps(self):
        """Ends a run whose thread has not started."""
        steps, self._steps = self._steps, None
        if steps is not None and self.state == "running":
            steps.close()
            self._thread.error = core.cancelled()
            self._ended(wait=False)

    def _leave(self):
        """Ends a run whose thread has not responded. The thread continues alone until its next
        check, and its result is dropped."""
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
        """Handles a document that closes, or one of its objects that is deleted."""
        if document == self._document and (name is None or name in self._watched):
            self._gone = True
            self.cancel()

    def threads(self):
        """Returns the threads of the run that may be working."""
        return [thread for thread in (self._thread, self._fetching) if thread is not None]

    def _wait(self):
        for thread in self.threads():
            thread.wait()

    def _emit_progress(self):
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
                "SweptVolume", "Cancelled: the document was closed, or an object was deleted."
            )
        else:
            try:
                self._conclude()
            except Exception as error:  # an error in fail() must not keep the run alive
                self.state, self.message = "failed", str(error) or type(error).__name__
                App.Console.PrintError("{}: {}\n".format(self.task.title, self.message))
            for obj in self.task.watched:
                _refresh_icon(obj)
        self._fetching = None
        QtCore.QTimer.singleShot(FORGET, self._forget)
        self.ended.emit(self)

    def _forget(self):
        """Releases the result: it may be large, and the run object lives for some time."""
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
        # The panel and the object's Message show the error. The report view would open by itself,
        # so only the log gets the text.
        App.Console.PrintLog("{}: {}\n".format(self.task.title, self.message))
        self.task.fail(self.message)


@contextlib.contextmanager
def transaction(document, title):
    """Makes one undo step. If the block raises, its changes are undone."""
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
    """Returns whether a run for an object is in progress, for icons and commands."""
    return any(run.concerns(obj) for run in _runs)


def running():
    """Returns the runs in progress."""
    return list(_runs)


def start(task):
    """Starts a task and returns its Run."""
    run = Run(task)
    run.start()
    return run


class _Observer:
    """Is notified of documents that close and of objects that are deleted."""

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
    """When FreeCAD closes, waits up to LEAVE for the threads. If a thread is still running, makes
    the process end without waiting for it."""
    threads = list(_left)
    for run in list(_runs):
        run.lose(run._document)
        threads += run.threads()
    until = time.monotonic() + LEAVE
    for thread in threads:
        thread.wait(max(1, int(1000 * (until - time.monotonic()))))
    if any(thread.isRunning() for thread in threads):
        _left.extend(thread for thread in threads if thread not in _left)
        # Python ends last, after FreeCAD has written its settings. Without this exit, Qt would end
        # the process with an error because a thread still runs.
        atexit.register(os._exit, 0)
