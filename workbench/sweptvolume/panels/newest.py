# SPDX-License-Identifier: LGPL-2.1-or-later
"""Work in the background for requests that come faster than they can be handled. Only the newest
request counts."""
import threading

from ..runner import Task


class NewestTask(Task):
    """Handles requests, always the newest one, until none is left. Results wait until take() is
    called. Does not change the document. Subclasses define make(request, control), which runs in
    any thread, and may define after_request(request, control), which runs after each request."""

    writes = False

    def __init__(self, document, title, request):
        self.title, self.document = title, document
        self._lock, self._next, self._made, self._over = threading.Lock(), request, None, False

    def make(self, request, control):
        raise NotImplementedError

    def after_request(self, request, control):
        pass

    def offer(self, request):
        """Offers a newer request, from the window's thread. Returns False if the task has already
        ended."""
        with self._lock:
            if not self._over:
                self._next = request
            return not self._over

    def has_result(self):
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
                request, self._next = self._next, None
                self._over = request is None
            if request is None:
                return
            control.enter(0, 1)
            made = self.make(request, control)
            with self._lock:
                self._made = made
            self.after_request(request, control)

    def finish(self, value):
        pass
