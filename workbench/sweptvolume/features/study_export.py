# SPDX-License-Identifier: LGPL-2.1-or-later
"""Writes envelopes and clearance checks of a document as a study file (docs/studies.md): parts and
neighbours as the triangles that are checked, motions as poses, rules, and what is computed.
`run_of()` reads the document; `write()` may run in any thread.

Meshes and motions are written to subfolders of the folder inputs/ beside the study file. A
subfolder is named after the hash of what it contains, so equal meshes and motions are written only
once.
"""
import hashlib
import json
import os
import shutil

import numpy as np

from .. import core, settings
from ..convert import InputProblem, label_of
from ..safe_file import written_beside
from ..texts import language, translate
from .clearance_plan import Plan as ClearancePlan

INPUTS = "inputs"
#: The page of all runs, in the folder of the results.
PAGE = "study.html"
_MOST_LETTERS = 50
#: Options of an envelope that have the same names in studies. Values 0 and False are left out.
_OPTIONS = (
    "tolerance",
    "offset",
    "conservative",
    "keep_cavities",
    "position_filter",
    "chord_tolerance",
)


def file_name(label):
    """Converts a label to the name of a run, a part or a file. Keeps letters, digits, blanks and
    ()+,@.-_."""
    kept = "".join(c if c.isalnum() or c in "()+,@.-_ " else "_" for c in label)
    kept = kept[:_MOST_LETTERS].strip(" .")
    # Files in the folder of the results have these names.
    is_reserved = kept.casefold() in ("", "study.csv", "study.json", PAGE)
    return kept + "_" if is_reserved else kept


def numbered(names, same=str):
    """Numbers equal names. same: a function; names with the same value of it count as equal."""
    found, seen = [], set()
    for base in names:
        name, number = base, 1
        while same(name) in seen:
            number += 1
            name = "{} ({})".format(base, number)
        seen.add(same(name))
        found.append(name)
    return found


class PageStyle:
    """Title, language and template of the study's pages."""

    def __init__(self, name, language_code, template):
        self.name, self.language, self.template = name, language_code, template

    @classmethod
    def now(cls, name):
        """Returns the PageStyle from the preferences."""
        return cls(name, language(), settings.page_template())


class Run:
    """One run. body: core.Request; neighbours: clearance_plan.Request or None; options: {stage: its
    options}."""

    def __init__(self, name, part, motion, body, neighbours, options):
        self.name, self.part, self.motion = name, file_name(part), file_name(motion)
        self.body, self.neighbours, self.options = body, neighbours, options


def _one_motion(label):
    text = translate(
        "SweptVolume",
        'Each part of "{0}" has its own motion, but a run of a study has only one '
        'motion: leave "{0}" out, or give its parts one common motion.',
    )
    return InputProblem(text.format(label))


def run_of(name, source, plan):
    """Returns the run of an envelope or a clearance check. Raises InputProblem."""
    if isinstance(plan, ClearancePlan):
        moving, request = plan.moving(), plan.request()
        part = ", ".join(label_of(*pair) for pair in plan.pairs)
        own = dict(request.options, page=True)
        return Run(name, part, moving.motion.Label, request.body, request, {"clearance": own})
    requests = plan.requests()
    if len(requests) != 1:
        raise _one_motion(source.Label)
    given = requests[0].options
    if given["components"] != "consistent":
        text = translate(
            "SweptVolume",
            'Studies cannot use the setting Components of "{0}": set it to Consistent.',
        )
        raise InputProblem(text.format(source.Label))
    own = {key: given[key] for key in _OPTIONS if given.get(key)}
    size = {"cell": given["cell"]} if given["cell"] > 0 else {"resolution": given["resolution"]}
    part = ", ".join(label_of(*pair) for pair in plan.pairs)
    label = plan.groups()[0].motion.Label
    return Run(name, part, label, requests[0], None, {"envelope": dict(own, **size)})


class _Inputs:
    """The folder of inputs. `used`: names of the subfolders that the study needs."""

    def __init__(self, folder):
        self.folder, self.used = os.path.join(folder, INPUTS), set()

    def add(self, key, name, make):
        """Returns the path, relative to the study file, of the mesh or motion that these bytes
        (key) identify. If the file does not exist yet, make(path) writes it."""
        subfolder = hashlib.sha256(key).hexdigest()[:16]
        self.used.add(subfolder)
        path = os.path.join(self.folder, subfolder, name)
        if not os.path.exists(path):
            os.makedirs(os.path.dirname(path), exist_ok=True)
            with written_beside(path) as beside:
                make(beside)
        return "/".join((INPUTS, subfolder, name))

    def mesh(self, name, vertices, triangles):
        vertices, triangles = np.asarray(vertices, "<f8"), np.asarray(triangles, "<i4")
        key = vertices.tobytes() + triangles.tobytes()
        return self.add(key, name + ".ply", lambda path: core.write_mesh(vertices, triangles, path))

    def motion(self, name, request):
        rows = np.column_stack([request.times, request.translations, request.rotations])
        lines = [",".join(map(repr, map(float, row))) for row in rows]
        text = "\n".join(["t,tx,ty,tz,qx,qy,qz,qw"] + lines) + "\n"

        def write(path):
            with open(path, "w", encoding="utf-8", newline="") as file:
                file.write(text)

        return self.add(text.encode(), name + ".csv", write)

    def tidy(self):
        """Removes subfolders that only an earlier export needed."""
        if os.path.isdir(self.folder):
            for name in os.listdir(self.folder):
                if name not in self.used and len(name) == 16:
                    shutil.rmtree(os.path.join(self.folder, name), ignore_errors=True)


def _toml(value):
    """Returns a value in TOML form."""
    if isinstance(value, dict):
        pairs = ("{} = {}".format(_text(k), _toml(v)) for k, v in value.items())
        return "{ " + ", ".join(pairs) + " }" if value else "{}"
    if isinstance(value, (list, tuple)):
        return "[" + ", ".join(map(_toml, value)) + "]"
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, (int, np.integer)):
        return str(int(value))
    return _text(value) if isinstance(value, str) else repr(float(value))


def _text(value):
    return json.dumps(value, ensure_ascii=False).replace("\x7f", "\\u007F")


def _neighbours(run, inputs, table):
    """Adds the neighbours of a run to its table, with different names, their rules and chord
    errors."""
    rows = run.neighbours.rows()
    files, rules, chords = [], {}, {}
    names = numbered(file_name(label) for label, *_ in rows)
    for name, (_, vertices, triangles, chord, rule) in zip(names, rows):
        files.append(inputs.mesh(name, vertices, triangles))
        if rule is not None:
            rules[name] = rule
        if chord:
            chords[name] = float(chord)
    table["neighbours"], table["rules"] = files, rules
    table["clearance"] = dict(run.options["clearance"], neighbour_chord=chords)


def _table(run, inputs):
    """Returns the table [[run]] as a dict."""
    body = run.body
    table = {
        "name": run.name,
        "part": inputs.mesh(run.part, body.body.vertices, body.body.triangles),
        "motion": inputs.motion(run.motion, body),
        "interpolation": body.interpolation,
        "compute": list(run.options),
        **run.options,
    }
    if run.neighbours is not None:
        _neighbours(run, inputs, table)
    return table


def write(path, runs, style, control):
    """Writes a study file and its input files, in any thread. Raises InputProblem, core.CoreError,
    OSError."""
    folder = os.path.dirname(path)
    os.makedirs(folder, exist_ok=True)
    inputs, tables = _Inputs(folder), []
    for run in runs:
        if control.is_cancelled():
            raise core.cancelled()
        tables.append(_table(run, inputs))
    about = {"name": style.name, "page": True, "language": style.language}
    if style.template:
        about["template"] = os.path.abspath(style.template)
    lines = ["[study]"] + ["{} = {}".format(key, _toml(value)) for key, value in about.items()]
    for table in tables:
        lines += ["", "[[run]]"] + ["{} = {}".format(k, _toml(v)) for k, v in table.items()]
    with written_beside(path) as beside, open(beside, "w", encoding="utf-8") as file:
        file.write("\n".join(lines) + "\n")
    inputs.tidy()
