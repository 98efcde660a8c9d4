# SPDX-License-Identifier: LGPL-2.1-or-later
"""The folder with the results of a study: the table, the page, and for each run a folder with its report."""
from __future__ import annotations

import contextlib
import json
import os
import pathlib
import shutil
import sys
from typing import Iterator, Optional

from . import _core
from ._study_checks import RESERVED
from ._study_file import Run
from ._study_run import (
    PARTIAL,
    REPORT_FILE,
    Report,
    json_text,
    output_names,
    partial_folder,
)
from ._values import core_error

if sys.platform != "win32":
    import fcntl

TABLE, STUDY_REPORT, STUDY_PAGE = RESERVED
_LOCK = ".study.lock"


def _in_use(path: pathlib.Path) -> _core.InvalidInput:
    text = f"another study is writing to '{path}'; wait until it has ended, or name another folder"
    return core_error(_core.InvalidInput, "FolderInUse", text)


class Folder:
    """The folder of results. Results get their final names only when they are complete."""

    def __init__(self, path: pathlib.Path) -> None:
        self.path = path

    @contextlib.contextmanager
    def locked(self) -> Iterator[None]:
        """Locks the folder, so that only one study at a time writes to it. The system removes the lock when
        the process ends, for whatever reason. The empty lock file remains. Raises InvalidInput
        (FolderInUse), OSError. There is no lock in Windows."""
        self.path.mkdir(parents=True, exist_ok=True)
        handle = os.open(self.path / _LOCK, os.O_RDWR | os.O_CREAT, 0o666)
        try:
            if sys.platform != "win32":
                try:
                    fcntl.flock(handle, fcntl.LOCK_EX | fcntl.LOCK_NB)
                except BlockingIOError:
                    raise _in_use(self.path) from None
            self.remove_partial()
            yield
        finally:
            os.close(handle)

    def remove_partial(self) -> None:
        """Removes the incomplete folders that a stopped study has left."""
        for left in self.path.glob(PARTIAL + "*"):
            shutil.rmtree(left, ignore_errors=True)

    def earlier(self, run: Run, key: str) -> Optional[Report]:
        """Returns the report of an earlier run with the same input and options, unless it failed."""
        folder = self.path / run.name
        try:
            report: Report = json.loads((folder / REPORT_FILE).read_text(encoding="utf-8"))
            whole = all((folder / name).is_file() for name in output_names(run))
            same = report["key"] == key and report["status"] == "Ok"
        except (OSError, ValueError, KeyError, TypeError):
            return None
        return report if whole and same else None

    def take(self, run: Run, report: Report, filled: Optional[str]) -> None:
        """Gives the folder `filled` the name of the run, in place of an older folder. If the run has filled
        no folder (None), makes one with the report."""
        folder = self.path / run.name
        if filled is None:
            filled = partial_folder(str(self.path))
            text = json_text(report)
            pathlib.Path(filled, REPORT_FILE).write_text(text, encoding="utf-8")
        if folder.exists():
            old = self.path / (PARTIAL + run.name + ".old")
            folder.rename(old)
            pathlib.Path(filled).rename(folder)
            shutil.rmtree(old)
        else:
            pathlib.Path(filled).rename(folder)

    def write(self, name: str, text: str) -> None:
        made = self.path / (PARTIAL + name)
        made.write_text(text, encoding="utf-8", newline="")
        os.replace(made, self.path / name)
