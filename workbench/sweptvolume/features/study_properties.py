# SPDX-License-Identifier: LGPL-2.1-or-later
"""The properties of a study. Inputs: type, name, help, default. Results: type, name, help, mode."""
from ..texts import QT_TRANSLATE_NOOP
from . import clearance_properties
from .base import HIDDEN, READ_ONLY

INPUT = [
    (
        "App::PropertyFile",
        "File",
        QT_TRANSLATE_NOOP(
            "App::Property",
            "Study file (TOML) that lists the runs. Empty: the runs come from Sources",
        ),
        "",
    ),
    (
        "App::PropertyLinkListGlobal",
        "Sources",
        QT_TRANSLATE_NOOP(
            "App::Property",
            "Envelopes and clearance checks of this document. Each of them is one run",
        ),
        None,
    ),
    (
        "App::PropertyString",
        "Folder",
        QT_TRANSLATE_NOOP(
            "App::Property",
            "Folder for the results. Empty: the folder set in the study file, or the "
            'folder "results" beside that file. Without a study file: a folder '
            "beside the document",
        ),
        "",
    ),
    (
        "App::PropertyInteger",
        "Jobs",
        QT_TRANSLATE_NOOP(
            "App::Property", "Number of runs at the same time. 0: one for each processor core"
        ),
        0,
    ),
]
#: Properties that are the same as in the clearance check.
_SAME = ("Status", "Message", "Summary", "Verdict", "Report", "InputHash", "TriedHash", "Missing")
RESULT = [row for row in clearance_properties.RESULT if row[1] in _SAME] + [
    (
        "App::PropertyInteger",
        "Checked",
        QT_TRANSLATE_NOOP("App::Property", "Number of runs that have ended"),
        READ_ONLY,
    ),
    (
        "App::PropertyString",
        "Results",
        QT_TRANSLATE_NOOP("App::Property", "Folder of the stored result"),
        READ_ONLY,
    ),
    (
        "App::PropertyString",
        "Written",
        QT_TRANSLATE_NOOP("App::Property", "Study file of the stored result"),
        HIDDEN,
    ),
]
