# SPDX-License-Identifier: LGPL-2.1-or-later
"""Work in the background for requests that come faster than they can be handled. Only the newest
request counts."""
import threading

from ..runner import Task


class NewestTask(Task):
    """Handles requests, always the newest one, until none is left. Results wait until take() is
    called. Does not change the document. Subclasses define make(wish, control), which runs in
    any thread, and may define rest(wish, control), which runs after each request."""

    writes = False

    def __init__(self, document, title, wish):
        self.title, self.document = title, document
        self._lock, self._next, self._made, self._over = threading.Lock(), wish, None, False

    def make(self, wish, control):
        raise NotImplementedError

    def rest(self, wish, control):
        pass

    def offer(self, wish):
        """Offers a newer request, from the window's thread. Returns False if the task has already
        ended."""
        with self._lock:
            if not self._over:
                self._next = wish
            return not self._over

    def has_made(self):
        """Returns whether take() has a result. Does not wait."""
        return self._made is not None

    def take(self):
        """Returns the newest result since the last call, or None."""
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
