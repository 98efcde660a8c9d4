# SPDX-License-Identifier: LGPL-2.1-or-later
"""Checks of the runs of a study: names, files, roles, rules, template. Each check adds problems to a
list. (_study_file.py checks single keys.)
"""
from __future__ import annotations

import os
import pathlib
import re
from typing import TYPE_CHECKING, Dict, List, Sequence

from . import _core
from ._clearance import rule_texts

if TYPE_CHECKING:
    from ._study_file import Run

#: Files in the folder for results, beside the folders of the runs.
RESERVED = ("study.csv", "study.json", "study.html")
_EXACT = (".step", ".stp", ".brep", ".brp")  # files in which each solid has a name


def check_names(runs: Sequence[Run], problems: List[str]) -> None:
    """Refuses names of runs that cannot be names of folders, or that differ only in upper and lower case."""
    seen: Dict[str, str] = {}
    for run in runs:
        if not re.fullmatch(r"[\w()+=,@ .-]{1,120}", run.name) or run.name.strip(" .") != run.name:
            problems.append(
                f"run {run.name!r}: a name has 1 to 120 letters, digits, blanks or ()+=,@.-_, and "
                "neither begins nor ends with a blank or a dot"
            )
        elif run.name.casefold() in seen:
            problems.append(
                f"two runs are called {run.name!r}; give them names, with {{part}} and {{motion}} "
                "where these are lists"
            )
        elif run.name.casefold() in RESERVED:
            problems.append(
                f"run {run.name!r}: the study writes a file with this name; choose another name for the run"
            )
        seen[run.name.casefold()] = run.name


def check_roles(runs: Sequence[Run], problems: List[str]) -> None:
    for run in runs:
        if run.part in run.neighbours:
            problems.append(
                f"run {run.name!r}: '{run.part}' is the part that moves and a neighbour; take it out of "
                "the neighbours"
            )


def check_rules(runs: Sequence[Run], problems: List[str]) -> None:
    """Refuses rules that clearance() would refuse. The names of the solids in a STEP or BREP file are
    unknown until the file is read. With such neighbours, only the texts of the rules are checked.
    """
    seen = set()
    for run in runs:
        rules = rule_texts(run.rules)
        given = (tuple(rules), run.neighbours)
        if "clearance" not in run.compute or not rules or given in seen:
            continue
        seen.add(given)
        paths = [pathlib.PurePath(file) for file in run.neighbours]
        exact = any(path.suffix.lower() in _EXACT for path in paths)
        try:
            _core.rules_for(rules, None if exact else [path.stem for path in paths])
        except _core.InvalidInput as error:
            problems.append(f"run {run.name!r}, rules: {error}")


def read_template(name: str, folder: pathlib.Path, problems: List[str]) -> str:
    """Returns the text of a template for pages; "" without a name, or if there is a problem."""
    if not name:
        return ""
    try:
        text = (folder / name).read_text(encoding="utf-8")
        if text.strip():
            _core.check_page_template(text)
            return text
        problems.append(f"[study]: the template '{folder / name}' is empty")
    except (OSError, UnicodeDecodeError) as error:
        problems.append(f"[study]: the template '{folder / name}' cannot be read: {error}")
    except _core.InvalidInput as error:
        problems.append(f"[study], template: {error}")
    return ""


def check_files(runs: Sequence[Run], output: pathlib.Path, problems: List[str]) -> None:
    inside = os.path.join(os.path.realpath(output), "")
    folders: Dict[str, str] = {}  # real path by folder; many files may lie in one folder
    for file in dict.fromkeys(file for run in runs for file in run.files()):
        folder, name = os.path.split(file)
        if folder not in folders:
            folders[folder] = os.path.realpath(folder)
        real = (
            os.path.realpath(file) if os.path.islink(file) else os.path.join(folders[folder], name)
        )
        if not os.path.isfile(file):
            problems.append(f"there is no file '{file}'")
        elif real.startswith(inside):
            problems.append(f"'{file}' lies in the folder for results, where it could be replaced")
