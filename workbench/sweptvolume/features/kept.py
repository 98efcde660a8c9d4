# SPDX-License-Identifier: LGPL-2.1-or-later
"""The last simplified envelope, in the form that can be cut anew: another tolerance needs no sampling.

One at a time, for it is large; until its document is closed. Only in the thread of the GUI.
"""
import FreeCAD as App

_last = None
_observer = None


class _Observer:
    def slotDeletedDocument(self, document):
        if _last is not None and _last[0] == document.Name:
            drop()


def keep(document, key, outcome):
    """key: stands for all the inputs but the tolerance (Plan.hash)."""
    global _last, _observer
    if not key or outcome.result is None:
        return
    _last = document.Name, key, outcome.result
    if _observer is None:
        _observer = _Observer()
        App.addDocumentObserver(_observer)


def find(document, key):
    """What core.recut() takes, or None."""
    return _last[2] if _last is not None and _last[:2] == (document.Name, key) else None


def drop():
    """Gives back what is kept."""
    global _last
    _last = None
