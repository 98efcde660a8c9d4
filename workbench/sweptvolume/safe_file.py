# SPDX-License-Identifier: LGPL-2.1-or-later
"""Lets FreeCAD's own writers write to a temporary file beside the target, which replaces the target
only when it is complete. (The core's writers do this themselves.)"""
import contextlib
import os
import secrets
import tempfile

from .texts import translate


@contextlib.contextmanager
def written_beside(path):
    """Yields the path of an empty file of the same type in the same folder, readable only by its
    owner. If the block succeeds, the file replaces `path` and gets its permissions, or the default
    ones if `path` did not exist. Otherwise the file is removed, and `path` does not change."""
    suffix = os.path.splitext(path)[1]
    beside = "{}.{}{}".format(path, secrets.token_hex(4), suffix)
    handle = os.open(beside, os.O_CREAT | os.O_EXCL | os.O_WRONLY, 0o666)
    try:
        usual = os.fstat(handle).st_mode & 0o777
        os.close(handle)
        os.chmod(beside, 0o600)
        yield beside
        os.chmod(beside, os.stat(path).st_mode & 0o777 if os.path.exists(path) else usual)
        os.replace(beside, path)
    except BaseException:
        os.remove(beside)
        raise


@contextlib.contextmanager
def passing(suffix):
    """Yields the path of an empty file in the temporary folder. The file is removed after the
    block."""
    handle, path = tempfile.mkstemp(suffix=suffix)
    os.close(handle)
    try:
        yield path
    finally:
        os.remove(path)


def no_room_text():
    return translate(
        "SweptVolume",
        "The temporary folder {0} is full: delete files there, or set the "
        "environment variable TMPDIR to another folder.",
    ).format(tempfile.gettempdir())
