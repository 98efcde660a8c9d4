# SPDX-License-Identifier: LGPL-2.1-or-later
"""Checks whether files can be written, before any work starts."""
import os

import FreeCAD as App

from .body import InputProblem
from .texts import translate


def check_target(path, suffixes):
    """Checks whether a file of one of these types can be written. Raises InputProblem."""
    folder, suffix = os.path.dirname(os.path.abspath(path)), os.path.splitext(path)[1].lower()
    if suffix not in suffixes:
        text = translate(
            "SweptVolume", 'The file type "{0}" is not supported: use one of these: {1}.'
        )
        raise InputProblem(text.format(suffix, " ".join(suffixes)))
    if not os.path.isdir(folder):
        raise InputProblem(
            translate(
                "SweptVolume",
                'The folder "{0}" does not exist: create it, or choose another folder.',
            ).format(folder)
        )
    if os.path.isdir(path):
        raise InputProblem(
            translate("SweptVolume", '"{0}" is a folder: enter the name of a file.').format(path)
        )
    if not os.access(folder, os.W_OK):
        raise InputProblem(
            translate(
                "SweptVolume",
                'The folder "{0}" is write-protected: choose another folder, or change its '
                "permissions.",
            ).format(folder)
        )
    if os.path.exists(path) and not os.access(path, os.W_OK):
        raise InputProblem(
            translate(
                "SweptVolume",
                'The file "{0}" is write-protected: choose another name, or change its '
                "permissions.",
            ).format(path)
        )


def check_not_read(path):
    """Checks that no open document is stored in this file or reads it, because the data would be
    lost. Window's thread. Raises InputProblem."""
    if not os.path.exists(path):
        return
    for document in App.listDocuments().values():
        if _is_same(document.FileName, path):
            text = translate(
                "SweptVolume",
                '"{0}" is the file of the document "{1}" and would be overwritten: '
                "choose another file.",
            )
            raise InputProblem(text.format(path, document.Label))
        for obj in document.Objects:
            for name in obj.PropertiesList:
                if obj.getTypeIdOfProperty(name) != "App::PropertyFile":
                    continue
                if _is_same(getattr(obj, name), path):
                    text = translate(
                        "SweptVolume",
                        '"{0}" is an input of "{1}" and would be overwritten: choose another '
                        "file.",
                    )
                    raise InputProblem(text.format(path, obj.Label))


def _is_same(known, path):
    """Returns whether both paths are the same file, also through another spelling or a link."""
    return bool(known) and os.path.exists(known) and os.path.samefile(known, path)
