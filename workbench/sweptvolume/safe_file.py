# SPDX-License-Identifier: LGPL-2.1-or-later
"""Files that FreeCAD's own writers make: beside the target, and there only once they are whole. (The core's
writers do the same by themselves.)"""
import contextlib
import os
import secrets
import tempfile

from .texts import translate


@contextlib.contextmanager
def written_beside(path):
    """Yields the path of an empty file in the same folder, of the same type, that its owner alone may read.
    If the block ends well it takes the place of `path`, to be read by whom that was, or any new file is;
    else it is removed and `path` stays as it was."""
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
    """Yields the path of an empty file in the temporary folder, which is gone after the block."""
    handle, path = tempfile.mkstemp(suffix=suffix)
    os.close(handle)
    try:
        yield path
    finally:
        os.remove(path)


def no_room_text():
    return translate(
        "Messages",
        "The temporary folder {0} is full: delete files there, or set the "
        "environment variable TMPDIR to another folder.",
    ).format(tempfile.gettempdir())
