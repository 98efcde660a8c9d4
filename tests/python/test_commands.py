# SPDX-License-Identifier: LGPL-2.1-or-later
"""Every command: no file is lost, reports keep the schema and say how the run ended, and the examples in
the help work.
"""
import json
import lzma
import os
import pathlib
import re
import shlex
import shutil
import subprocess

import numpy as np
import pytest

import _swept
import swept_volume as sv
from bodies import box
from commands import EACH, RUNS, STUDY, contents, folder, run  # noqa: F401
from test_program import COMMANDS, call  # noqa: F401
from test_reports import reproducible, validator  # noqa: F401


def test_every_command_is_here():
    assert sorted(RUNS) == sorted(COMMANDS)


@EACH
def test_no_output_takes_the_place_of_an_input_or_another_output(run, folder, name):  # noqa: F811
    command = RUNS[name]
    if name == "sequence":  # its outputs are files of a folder, named after the parts
        (folder / "motions/part.csv").symlink_to(folder / "wall.ply")
        os.link(folder / "way.csv", folder / "motions/other.csv")
    os.link(folder / command.inputs[-1], folder / "hard.ply")
    (folder / "link.ply").symlink_to(command.inputs[0])
    before = contents(folder)
    for output in command.outputs:
        option = output.split()[0]
        targets = [*command.inputs, "link.ply", "hard.ply", "./" + command.inputs[0]]
        if output == "-o motions":
            targets = ["motions"]
        for target in targets:
            done = run(name, option, target, "" if option == "-o" else command.needed)
            assert done.returncode == 2 and "SameFile" in done.stderr, (option, target, done.stderr)
            assert done.stderr.count("\n") == 1 and done.stdout == ""
    for output in command.outputs[1:]:
        done = run(name, command.outputs[0].split()[0], output.split()[1], output)
        if name != "sequence":
            assert done.returncode == 2 and "SameFile" in done.stderr, done.stderr
    assert contents(folder) == before


@EACH
def test_results_are_replaced_unless_no_clobber(run, folder, name):  # noqa: F811
    command = RUNS[name]
    files = [output.split()[1] for output in command.outputs if output != "-o motions"]
    files += ["motions/part.csv", "motions/other.csv"] if name == "sequence" else []
    for file in files:
        (folder / file).write_text("old")
        done = run(name, *command.outputs, "--no-clobber")
        assert done.returncode == 1 and "ExportFailed/Exists" in done.stderr, done.stderr
        assert (folder / file).read_text() == "old"
        (folder / file).unlink()
        assert not [f for f in files if (folder / f).exists()], "nothing else was written"
    assert run(name, *command.outputs, "--no-clobber").returncode == command.status
    assert run(name, *command.outputs, "--no-clobber").returncode == 1
    for file in files:
        (folder / file).write_text("old")
    assert run(name, *command.outputs).returncode == command.status
    assert not [f for f in files if (folder / f).read_bytes() == b"old"]


@EACH
def test_reports_keep_the_schema_and_say_how_it_ended(run, folder, name, validator):  # noqa: F811
    command = RUNS[name]

    def report_of(status):
        done = run(name, command.needed, "--report -")
        assert done.returncode == status, done.stderr
        report = json.loads(done.stdout)
        validator.validate(report)
        assert report["command"] == name
        return report

    first = report_of(command.status)
    assert first["status"] == "Ok" and first["code"] == ""
    if name == "study":
        validator.validate(json.loads((folder / "results/part way/report.json").read_text()))
        return
    again = report_of(command.status)
    for report in (first, again):
        report.get("solid", {}).pop("file_bytes", None)  # contains the date
    assert reproducible(again) == reproducible(first)
    (folder / command.inputs[0]).write_text("ply\nnothing")
    assert report_of(1)["status"] == "InvalidInput"


@EACH
def test_what_cannot_be_written_is_named(run, folder, program, name, validator):  # noqa: F811
    """The size of files is limited: the report says that a file could not be written, and no
    incomplete file is left."""
    before = sorted(contents(folder))
    for output in RUNS[name].outputs:
        if output.startswith("--report"):
            line = (
                f"{program} {name} {RUNS[name].words} -q {RUNS[name].needed} --report - > /dev/full"
            )
        else:
            needed = "" if output.startswith("-o") else RUNS[name].needed
            words = f"{name} {RUNS[name].words} -q {needed} {output} --report -"
            line = f"ulimit -f 0; {program} {words} | cat"
        done = subprocess.run(
            ["bash", "-o", "pipefail", "-c", line], cwd=folder, capture_output=True, text=True
        )
        assert done.returncode == 1, (line, done.stderr)
        assert "swept: ExportFailed/WriteFailed: " in done.stderr, (line, done.stderr)
        assert done.stderr.count("swept: ExportFailed") == 1
        if not output.startswith("--report"):
            report = json.loads(done.stdout)
            validator.validate(report)
            assert (report["status"], report["code"]) == ("ExportFailed", "WriteFailed"), line
        for file in ("made.ply", "made.step", "results"):
            if (folder / file).is_dir():
                shutil.rmtree(folder / file)
            elif output.startswith("--report"):
                (folder / file).unlink(missing_ok=True)
        assert sorted(contents(folder)) == before, line


def test_the_report_of_a_study_is_none_of_its_results(run, folder):  # noqa: F811
    for target in ("results/study.csv", "results/part way/x.json", "results/STUDY.json"):
        done = run("study", "--report", f"'{target}'")
        if target == "results/STUDY.json":
            assert done.returncode in (0, 1, 2)  # a different file if names differ by case
            continue
        assert done.returncode == 2 and "SameFile" in done.stderr, done.stderr
    assert not (folder / "results/study.csv").exists() or run("study").returncode == 0
    line = f"study.toml --report {folder}/gone/r.json"
    done = run("study", words=line)
    assert done.returncode == 1 and "ExportFailed/MissingFolder" in done.stderr
    old = (folder / "study.toml").read_bytes()
    with open(folder / "study.toml", "ab") as file:
        program = str(pathlib.Path(os.environ.get("SWEPT_BUILD", "build"), "bin/swept").resolve())
        done = subprocess.run(
            [program, "study", "study.toml", "--report", "-"], cwd=folder, stdout=file,
            stderr=subprocess.PIPE, text=True,
        )  # fmt: skip
    assert done.returncode == 2 and "SameFile" in done.stderr, done.stderr
    assert (folder / "study.toml").read_bytes() == old
    (folder / "r.json").write_text("old")
    (folder / "r.json").chmod(0o640)
    assert run("study", "--report r.json -q").returncode == 0
    assert json.loads((folder / "r.json").read_text())["status"] == "Ok"
    assert (folder / "r.json").stat().st_mode & 0o777 == 0o640
    assert not [path for path in folder.iterdir() if path.name.startswith(".swept")]
    done = run("study", "--jobs many")
    assert done.returncode == 2 and done.stderr.count("\n") == 1, done.stderr


def test_shared_volumes_are_refused_before_anything_is_computed(run, folder):  # noqa: F811
    for target in ("x.step", "x.foo", "x"):
        done = run("overlap", "--shared", target)
        assert done.returncode == 2 and "unknown format" in done.stderr, done.stderr
    line = "--report made.json --shared made.ply"
    done = run("overlap", line, words="part.ply wall.ply")
    report = json.loads((folder / "made.json").read_text())
    assert done.returncode == 1 and report["code"] == "NothingShared" and report["pairs"]


def scene_of_examples(folder):  # noqa: F811
    """Makes the files that the examples of the help name."""
    far = 0
    body, motion = box((0, 0, 0), (10, 20, 30)), "0,0,0,0,0,0,0,1\n1,0.05,0,0,0,0,0,1\n"

    def make(name):
        nonlocal far
        path = folder / name
        path.parent.mkdir(exist_ok=True)
        far += 100
        if path.suffix in (".ply", ".stl"):
            _swept.write_mesh(path, body[0] + [0, 0 if "envelope_" in name else far, 0], body[1])
        elif path.suffix == ".step":
            _swept.write_solid(path, body[0] + [0, far, 0], body[1])
        elif path.suffix == ".toml":
            path.write_text(STUDY)
        elif path.suffix == ".csv":
            path.write_text(motion)
        elif path.suffix == ".xz":
            path.write_bytes(lzma.compress(motion.encode()))

    return make


@pytest.mark.skipif(not _swept.HAS_SOLIDS, reason="built without OpenCASCADE")
@EACH
def test_the_examples_of_the_help_run(call, program, folder, name):  # noqa: F811
    text = call(name, "--help").stdout.split("Examples:\n")[1]
    lines = [line.strip() for line in text.splitlines() if line.startswith("  ")]
    assert lines
    make = scene_of_examples(folder)
    for line in lines:
        if "--scheduler" in line:  # needs a cluster
            continue
        read = re.sub(
            r"(-o|--output|--report|--shared|--page|--csv|--offer-rules|--sources) \S+", "", line
        )
        line = line.replace("parts/*.stl", "parts/a.stl parts/b.stl")
        for file in re.findall(
            r"[\w/]+\.(?:ply|stl|step|csv|toml)(?:\.xz)?\b", read.replace("*", "a")
        ):
            if not (folder / file).exists():
                make(file)
        if "parts/" in line:
            make("parts/b.stl")
        ran = line.replace("swept ", shlex.quote(program) + " ")
        done = subprocess.run(
            ["bash", "-o", "pipefail", "-c", ran], cwd=folder, capture_output=True, text=True
        )
        assert done.returncode in (0, 3), (line, done.stderr)


def test_what_is_planted_in_a_report_is_found(run, validator):  # noqa: F811
    """The schema of the newest commands refuses unknown keys, and values of the wrong type."""
    import jsonschema

    for name, changes in (
        ("sequence", ({"order": "any"}, {"steps": [{"part": "x"}]}, {"duration": -1})),
        ("sequence", ({"clearance": None}, {"keys": 3}, {"verdict": "no_translation"})),
        ("path", ({"method": "guessed"}, {"before": {}}, {"path": [{"t": 0}]}, {"part": "x"})),
        ("overlap", ({"pairs": [{"first": "a", "second": "b"}]}, {"smallest": -1})),
        ("study", ({"runs": [{"run": "x"}]}, {"done": 0.5}, {"order": "given"})),
    ):
        report = json.loads(run(name, "--report -").stdout)
        validator.validate(report)
        for change in changes:
            with pytest.raises(jsonschema.ValidationError):
                validator.validate({**report, **change})


def test_improved_paths_and_sequences_of_the_module_keep_the_schema(validator):  # noqa: F811
    from test_paths import PART, WALLS, shift

    motion = sv.Motion.from_matrices(np.array([shift(0, 0, 60), shift(9, 0, 30), shift(0, 0, 0)]))
    report, _ = sv.improve_path(PART, motion, WALLS, clearance=0.3)
    validator.validate(report)
    assert report["method"] == "improved" and report["before"]["keys"] == 3
    ignored = [("part", name) for name, _ in WALLS]
    report, _ = sv.find_sequence(
        [sv.SequencePart("part", PART, extract=90.0)], WALLS, ignored=ignored
    )
    validator.validate(report)
    assert report["steps"][0]["method"] == "nothing in the way"
    assert "clearance" not in report["steps"][0] and "clearance" not in report
