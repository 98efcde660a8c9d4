# SPDX-License-Identifier: LGPL-2.1-or-later
"""Estimates for a panel, in the background and before a run starts."""
from .. import runner
from .widgets import alive


class _EstimateTask(runner.Task):
    """A task that does not change the document."""

    writes = False

    def __init__(self, document, find, show):
        self.title, self.document = "Estimate", document
        self.find, self.show = find, show

    def work(self, control):
        return self.find(control)

    def finish(self, found):
        self.show(found)


class BackgroundEstimate:
    """Keeps at most one estimate in progress. Only the newest request counts.

    Calls show(found), and report(text) after a failure, in the window's thread."""

    def __init__(self, document, show, report):
        self.document, self.show, self.report = document, show, report
        self.run, self._next, self._later = None, (), ()

    def want(self, *finds):
        """Starts the functions find(control), one after the other, in a background thread.
        They may use only plain values. Each result is shown when it is ready; give the quickest
        function first."""
        self._next = finds
        if self.run is None:
            self._start()
        else:
            self.run.cancel()

    def _start(self):
        find, self._next, self._later = self._next[0], (), self._next[1:]
        self.run = runner.start(_EstimateTask(self.document, find, self.show))
        self.run.ended.connect(self._ended)

    def _ended(self, run):
        self.run = None
        if not alive(self.document):
            return
        if run.state == "ok":
            self._next = self._next or self._later
        if self._next:
            self._start()
        elif run.state == "failed":
            self.report(run.message)

    def has_more(self):
        """Returns whether another result follows the one that is shown."""
        return bool(self._next or self._later)

    def stop(self):
        """Drops the estimates in progress."""
        self._next = self._later = ()
        if self.run is not None:
            self.run.ended.disconnect(self._ended)
            self.run.cancel()
            self.run = None
