# SPDX-License-Identifier: LGPL-2.1-or-later
"""Study files: TOML that names parts, motions, neighbours, rules and the stages to compute.

A file has a table [study], a table [defaults] with any key of a run, and a table [[run]] for each run.
Where `part` or `motion` is a list, there is one run for each combination. Nothing in a study file is
executed: every key is known, and every value is checked before the first run starts.
"""
from __future__ import annotations

import dataclasses
import difflib
import importlib
import itertools
import math
import os
import pathlib
import sys
from typing import Any, Callable, Dict, Iterator, List, Mapping, Optional, Sequence, Tuple

from . import _core
from ._study_checks import check_files, check_names, check_roles, check_rules, read_template
from ._values import Path

Table = Mapping[str, Any]

STAGES = ("envelope", "solid", "clearance")
_UNITS = ("mm", "cm", "m", "in")
_MAX_LISTED = 12  # largest number of problems in one message


@dataclasses.dataclass(frozen=True)
class Run:
    """One run of a study. Files are absolute paths. options: a table for each stage, and a table with
    the key "" for the options of the files."""

    name: str
    part: str
    motion: str
    neighbours: Tuple[str, ...]
    rules: Table
    compute: Tuple[str, ...]
    options: Mapping[str, Table]

    def files(self) -> List[str]:
        """Returns the files that the run reads."""
        return list(dict.fromkeys([self.part, self.motion, *self.neighbours]))


@dataclasses.dataclass(frozen=True)
class Study:
    """The content of a study file. file: its path. output: the folder for results. runs: in the order
    of the file. page: whether a page about the study is written. language and template apply to all
    its pages; template is a text, or "" for the built-in template."""

    file: pathlib.Path
    name: str
    output: pathlib.Path
    runs: Tuple[Run, ...]
    page: bool = False
    language: str = "en"
    template: str = ""


def _is_number(value: Any) -> bool:
    number = isinstance(value, (int, float)) and not isinstance(value, bool)
    return number and math.isfinite(value)


def _is_text(value: Any) -> bool:
    return isinstance(value, str) and value != ""


Check = Tuple[Callable[[Any], bool], str]
_NUMBER: Check = (lambda v: _is_number(v) and v >= 0, "a number of 0 or more")
_ABOVE: Check = (lambda v: _is_number(v) and v > 0, "a number above 0")
_COUNT: Check = (lambda v: isinstance(v, int) and _is_number(v) and v > 0, "a whole number above 0")
_YES_NO: Check = (lambda v: isinstance(v, bool), "true or false")
_TEXT: Check = (_is_text, "a text")
_POINT: Check = (
    lambda v: isinstance(v, list) and len(v) == 3 and all(map(_is_number, v)),
    "a list of three numbers",
)
_TEXTS: Check = (lambda v: isinstance(v, list) and all(map(_is_text, v)), "a list of texts")
_FILES: Check = (
    lambda v: _is_text(v) or (isinstance(v, list) and v != [] and all(map(_is_text, v))),
    "a file, or a list of files",
)
_RULES: Check = (
    lambda v: isinstance(v, dict) and all(_is_text(r) or _is_number(r) for r in v.values()),
    "a table of names, each with a distance in mm, 'contact', 'contact:MM' or 'ignore'",
)

_CHORDS: Check = (
    lambda v: all(_is_number(c) and c >= 0 for c in (v.values() if isinstance(v, dict) else [v])),
    "a number of 0 or more, or a table of them by the names of files",
)


def _one_of(*words: str) -> Check:
    return (lambda v: v in words), "one of " + ", ".join(words)


_STAGES: Check = (
    lambda v: isinstance(v, list) and v != [] and all(s in STAGES for s in v),
    "a list of " + ", ".join(STAGES),
)
_STUDY_KEYS: Dict[str, Check] = {
    "name": _TEXT,
    "output": _TEXT,
    "page": _YES_NO,
    "language": _one_of("en", "de"),
    "template": _TEXT,
}
_RUN_KEYS: Dict[str, Check] = {
    "name": _TEXT,
    "part": _FILES,
    "motion": _FILES,
    "neighbours": _TEXTS,
    "rules": _RULES,
    "compute": _STAGES,
}
#: Options of the files ("") and of each stage. Most are arguments of compute(), write_solid() or clearance().
_OPTIONS: Dict[str, Dict[str, Check]] = {
    "": {
        "part_unit": _one_of(*_UNITS),
        "motion_unit": _one_of(*_UNITS),
        "neighbour_unit": _one_of(*_UNITS),
        "interpolation": _one_of("none", "linear", "screw"),
        "pivot": _POINT,
    },
    "envelope": {
        "format": _one_of("ply", "stl", "obj", "off", "3mf"),
        "accuracy": _ABOVE,
        "resolution": _COUNT,
        "cell": _ABOVE,
        "tolerance": _NUMBER,
        "offset": _NUMBER,
        "conservative": _YES_NO,
        "keep_cavities": _YES_NO,
        "position_filter": _NUMBER,
        "chord_tolerance": _ABOVE,
    },
    "solid": {
        "format": _one_of("step", "brep"),
        "tolerance": _NUMBER,
        "exact": _YES_NO,
        "recognise": _YES_NO,
        "max_faces": _COUNT,
        "max_megabytes": _ABOVE,
        "schema": _one_of("ap214", "ap242", "ap242-tessellated"),
        "author": _TEXT,
        "organization": _TEXT,
        "product_name": _TEXT,
    },
    "clearance": {
        "required": _NUMBER,
        "tolerance": _ABOVE,
        "deflection": _ABOVE,
        "body_chord": _NUMBER,
        "neighbour_chord": _CHORDS,
        "interval_tolerance": _ABOVE,
        "curve": _COUNT,
        "penetration": _YES_NO,
        "page": _YES_NO,
    },
}


class _Problems(List[str]):
    """The problems of a file, each with its position in the file."""

    def unknown(self, where: str, key: str, known: Sequence[str]) -> None:
        near = difflib.get_close_matches(key, known, 1)
        hint = f"did you mean '{near[0]}'?" if near else "known keys: " + ", ".join(known)
        self.append(f"{where}: unknown key '{key}'; {hint}")

    def check(self, where: str, key: str, value: Any, check: Check) -> bool:
        good, wanted = check
        if good(value):
            return True
        self.append(f"{where}: {key} is {value!r}; it must be {wanted}")
        return False


def _bad_study(path: pathlib.Path, problems: Sequence[str]) -> _core.InvalidInput:
    more = len(problems) - _MAX_LISTED
    lines = list(problems[:_MAX_LISTED]) + ([f"and {more} more"] if more > 0 else [])
    error = _core.InvalidInput(f"'{path}': " + "\n  ".join(lines))
    error.status, error.code, error.report = "InvalidInput", "BadStudy", None
    return error


def _parsed(path: pathlib.Path) -> Dict[str, Any]:
    name = "tomllib" if sys.version_info >= (3, 11) else "tomli"
    toml: Any = importlib.import_module(name)
    text = path.read_bytes()
    try:
        parsed: Dict[str, Any] = toml.loads(text.decode("utf-8-sig"))
    except UnicodeDecodeError as error:
        raise _bad_study(path, [f"byte {error.start} is not UTF-8"]) from error
    except toml.TOMLDecodeError as error:
        raise _bad_study(path, [str(error)]) from error
    return parsed


def _checked(table: Table, where: str, problems: _Problems) -> Dict[str, Any]:
    """Returns the valid keys of a table [[run]] or [defaults], and adds the others to
    `problems`."""
    good: Dict[str, Any] = {}
    known = {**_RUN_KEYS, **_OPTIONS[""]}
    for key, value in table.items():
        if key in STAGES:
            if not isinstance(value, dict):
                problems.append(f"{where}: {key} is {value!r}; it must be a table of options")
                continue
            options = good[key] = {}
            for option, setting in value.items():
                place = f"{where}, {key}"
                if option not in _OPTIONS[key]:
                    problems.unknown(place, option, list(_OPTIONS[key]))
                elif problems.check(place, option, setting, _OPTIONS[key][option]):
                    options[option] = setting
        elif key not in known:
            problems.unknown(where, key, [*known, *STAGES])
        elif problems.check(where, key, value, known[key]):
            good[key] = value
    return good


#: Options of an envelope that exclude each other.
_EXCLUDES = {
    "accuracy": {"cell", "chord_tolerance", "resolution", "tolerance"},
    "cell": {"accuracy", "resolution"},
    "chord_tolerance": {"accuracy"},
    "resolution": {"accuracy", "cell"},
    "tolerance": {"accuracy"},
}


def _merged(defaults: Table, table: Table) -> Dict[str, Any]:
    merged = {**defaults, **table}
    for stage in STAGES:
        merged[stage] = {**defaults.get(stage, {}), **table.get(stage, {})}
        given = table.get(stage, {})
        # An option of a run removes the options of [defaults] that it excludes.
        for key in _EXCLUDES:
            if key in given and stage == "envelope":
                for other in _EXCLUDES[key] - set(given):
                    merged[stage].pop(other, None)
    return merged


def _listed(value: Any) -> List[str]:
    return list(value) if isinstance(value, list) else [value]


def _stem(path: str) -> str:
    return os.path.splitext(os.path.basename(path))[0]


def _joined(folder: pathlib.Path, name: str) -> str:
    return os.path.join(folder, name)


def _combinations(
    table: Table, folder: pathlib.Path, where: str, problems: _Problems
) -> Iterator[Run]:
    missing = [key for key in ("part", "motion", "compute") if key not in table]
    if missing:
        problems.append(f"{where}: {' and '.join(missing)} missing")
        return
    stages = tuple(stage for stage in STAGES if stage in table["compute"])
    if "clearance" in stages and not table.get("neighbours"):
        problems.append(f"{where}: compute contains 'clearance', but there are no neighbours")
    for key, others in _EXCLUDES.items():
        for other in sorted(others & set(table["envelope"])):
            if key in table["envelope"] and key < other:
                problems.append(f"{where}, envelope: {key} and {other} exclude one another")
    if "solid" in stages and not _core.HAS_SOLIDS:
        problems.append(f"{where}: this build has no OpenCASCADE and cannot make solids")
    neighbours = tuple(_joined(folder, name) for name in table.get("neighbours", ()))
    used = {*stages, "envelope"} if "solid" in stages else {*stages}  # a solid needs an envelope
    options: Dict[str, Table] = {s: table[s] for s in STAGES if s in used}
    options[""] = {key: table[key] for key in _OPTIONS[""] if key in table}
    pattern = table.get("name", "{part} {motion}")
    for part, motion in itertools.product(_listed(table["part"]), _listed(table["motion"])):
        name = pattern.replace("{part}", _stem(part)).replace("{motion}", _stem(motion))
        files = _joined(folder, part), _joined(folder, motion), neighbours
        yield Run(name, *files, dict(table.get("rules", {})), stages, options)


def _with_pages(run: Run, language: str, template: str) -> Run:
    """Returns the run with the language and the template of the study for its page."""
    options = run.options.get("clearance", {})
    if not options.get("page"):
        return run
    shown = {**options, "language": language, "template": template}
    return dataclasses.replace(run, options={**run.options, "clearance": shown})


def read_study(path: Path, output: Optional[Path] = None) -> Study:
    """Reads and checks a study file. output: folder for the results, in place of the folder that the
    file names. Relative paths start at the folder of the file. Raises InvalidInput (BadStudy) with
    all problems of the file, and FileNotFoundError."""
    file = pathlib.Path(os.fsdecode(path))
    parsed, problems = _parsed(file), _Problems()
    for key in parsed:
        if key not in ("study", "defaults", "run"):
            problems.unknown("the file", key, ["study", "defaults", "run"])
    about, tables = parsed.get("study", {}), parsed.get("run", [])
    if not isinstance(about, dict) or not isinstance(tables, list) or not tables:
        raise _bad_study(file, [*problems, "it has no table [[run]]; add one for each run"])
    for key, value in about.items():
        if key not in _STUDY_KEYS:
            problems.unknown("[study]", key, list(_STUDY_KEYS))
        else:
            problems.check("[study]", key, value, _STUDY_KEYS[key])
    if problems:
        raise _bad_study(file, problems)
    defaults = _checked(parsed.get("defaults", {}), "[defaults]", problems)
    folder = file.absolute().parent
    template = read_template(about.get("template", ""), folder, problems)
    runs: List[Run] = []
    for number, table in enumerate(tables, 1):
        where = f"run {number}" + (f" ({table['name']!r})" if "name" in table else "")
        before = len(problems)
        good = _checked(table, where, problems)
        if len(problems) == before:
            runs.extend(_combinations(_merged(defaults, good), folder, where, problems))
    chosen = (
        pathlib.Path(os.fsdecode(output)) if output else folder / about.get("output", "results")
    )
    if not problems:
        check_names(runs, problems)
        check_files(runs, chosen, problems)
        check_roles(runs, problems)
        check_rules(runs, problems)
    if problems:
        raise _bad_study(file, problems)
    language = about.get("language", "en")
    return Study(
        file.absolute(),
        about.get("name", file.stem),
        chosen.absolute(),
        tuple(_with_pages(run, language, template) for run in runs),
        about.get("page", False),
        language,
        template,
    )
