# SPDX-License-Identifier: LGPL-2.1-or-later
"""Keeps the last simplified envelope so that it can be simplified to another tolerance.

Keeps only one envelope, because envelopes are large, and only until its document is closed. Only
for the GUI thread.
"""
import FreeCAD as App

_last = None
_observer = None


class _Observer:
    def slotDeletedDocument(self, document):
        if _last is not None and _last[0] == document.Name:
            drop()


def keep(document, key, outcome):
    """Keeps an outcome. key: identifies all inputs except the tolerance (Plan.hash())."""
    global _last, _observer
    if not key or outcome.result is None:
        return
    _last = document.Name, key, outcome.result
    if _observer is None:
        _observer = _Observer()
        App.addDocumentObserver(_observer)


def find(document, key):
    """Returns the argument for core.recut(), or None if no envelope with this key is kept."""
    return _last[2] if _last is not None and _last[:2] == (document.Name, key) else None


def drop():
    """Releases the kept envelope."""
    global _last
    _last = None
