# SPDX-License-Identifier: LGPL-2.1-or-later
"""Writes the report of a command to a file, completely or not at all. The file must be neither an input
nor another output of the command. The name "-" stands for standard output.
"""
from __future__ import annotations

import os
import pathlib
import stat
import sys
import tempfile
from typing import Sequence

from . import _core
from ._values import core_error


def _failed(code: str, message: str) -> _core.Error:
    return core_error(_core.ExportFailed, code, message)


def _target(path: str) -> str:
    """Returns the file that receives the report, with links resolved. "-": the file to which
    standard output is redirected."""
    return os.path.realpath("/dev/stdout" if path == "-" else path)


def check_report(
    path: str, inputs: Sequence[str], folder: str, results: Sequence[str], no_clobber: bool
) -> None:
    """Checks the name of the report before anything is computed. inputs: names of files; results: names
    in `folder`, of files and of folders with files. Raises InvalidInput (SameFile), ExportFailed (Exists,
    MissingFolder, BadTarget, ReadOnly)."""
    target = _target(path)
    is_file = os.path.isfile(target)
    for name in inputs:
        if is_file and os.path.samefile(target, name):
            text = f"--report '{path}' is an input, '{name}', which would be overwritten; name another file"
            raise core_error(_core.InvalidInput, "SameFile", text)
    inside = pathlib.Path(os.path.relpath(target, os.path.realpath(folder))).parts
    if (path != "-" or is_file) and inside and inside[0] in results:
        text = f"--report '{path}' is one of the results in '{folder}'; name another file"
        raise core_error(_core.InvalidInput, "SameFile", text)
    if path == "-":
        return
    if no_clobber and os.path.lexists(path):
        text = f"--report '{path}' exists already, and --no-clobber forbids replacing it; choose another name"
        raise _failed("Exists", text)
    parent = os.path.dirname(target)
    if not os.path.isdir(parent):
        raise _failed(
            "MissingFolder", f"cannot write '{path}': the folder '{parent}' does not exist"
        )
    if os.path.exists(target) and not is_file:
        raise _failed(
            "BadTarget", f"cannot write '{path}': it is not an ordinary file; choose another name"
        )
    if not os.access(parent, os.W_OK) or (is_file and not os.access(target, os.W_OK)):
        raise _failed("ReadOnly", f"cannot write '{path}': it or its folder is write-protected")


def silence_output() -> None:
    """Discards output whose reader has closed the pipe, so that Python prints no error about it
    when the program ends."""
    os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())


def _print(text: str) -> None:
    try:
        sys.stdout.write(text)
        sys.stdout.flush()
    except OSError as error:
        silence_output()
        text = f"writing to standard output failed: {error.strerror}"
        raise _failed("WriteFailed", text) from None


def write_report(path: str, text: str) -> None:
    """Replaces an old file only by the complete new one, and keeps its permissions. Raises ExportFailed."""
    if path == "-":
        _print(text)
        return
    target, made = _target(path), None
    try:
        handle, made = tempfile.mkstemp(prefix=".swept-", dir=os.path.dirname(target))
        with open(handle, "w", encoding="utf-8", newline="") as file:
            file.write(text)
        os.chmod(made, _mode(target))
        os.replace(made, target)
    except OSError as error:
        if made is not None and os.path.exists(made):
            os.remove(made)
        raise _failed("WriteFailed", f"cannot write '{path}': {error.strerror}") from None


def _mode(target: str) -> int:
    """Returns the permissions of the old file; if there is none, those that new files usually get."""
    if os.path.exists(target):
        return stat.S_IMODE(os.stat(target).st_mode)
    mask = os.umask(0)
    os.umask(mask)
    return 0o666 & ~mask
