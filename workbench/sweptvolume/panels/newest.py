# SPDX-License-Identifier: LGPL-2.1-or-later
"""Work beside the window on wishes that come quicker than they can be met: the newest counts."""
import threading

from ..runner import Task


class NewestTask(Task):
    """Meets wishes, the newest each time, until none is left; what was made waits to be taken. It changes no
    document. Subclasses give make(wish, control), any thread, and may give rest(wish, control), what is done
    after each."""

    writes = False

    def __init__(self, document, title, wish):
        self.title, self.document = title, document
        self._lock, self._next, self._made, self._over = threading.Lock(), wish, None, False

    def make(self, wish, control):
        raise NotImplementedError

    def rest(self, wish, control):
        pass

    def offer(self, wish):
        """A newer wish, from the window's thread; False if it comes too late."""
        with self._lock:
            if not self._over:
                self._next = wish
            return not self._over

    def has_made(self):
        """Whether take() has something; without waiting."""
        return self._made is not None

    def take(self):
        """The newest of what was made since the last call, or None."""
        with self._lock:
            made, self._made = self._made, None
        return made

    def work(self, control):
        while True:
            with self._lock:
                wish, self._next = self._next, None
                self._over = wish is None
            if wish is None:
                return
            control.enter(0, 1)
            made = self.make(wish, control)
            with self._lock:
                self._made = made
            self.rest(wish, control)

    def finish(self, value):
        pass
