# SPDX-License-Identifier: LGPL-2.1-or-later
"""What every command holds to: nothing is lost, streams, reports that keep the schema and say how it
ended, signals, examples of the help that run."""
import dataclasses
import json
import os
import pathlib
import re
import shlex
import shutil
import signal
import subprocess
import time
from typing import Tuple

import numpy as np
import pytest

import _swept
import swept_volume as sv
from bodies import ball, box, joined
from test_paths import block
from test_program import COMMANDS, call, wait_until_caught  # noqa: F401
from test_reports import reproducible, validator  # noqa: F401


@dataclasses.dataclass(frozen=True)
class Command:
    """A small run of a command: its words, the files among them that it reads, options that name
    outputs, and of these the ones that may be standard output."""

    words: str
    inputs: Tuple[str, ...]
    outputs: Tuple[str, ...]
    streams: Tuple[str, ...] = ()
    status: int = 0

    @property
    def needed(self):
        """The output that has to be named."""
        return self.outputs[0] if self.outputs[0] in ("-o made.ply", "-o made.step") else ""


RUNS = {
    "envelope": Command(
        "part.ply --motion way.csv --cell 0.5", ("part.ply", "way.csv"),
        ("-o made.ply", "--report made.json", "--sources made.csv"), ("-o made.ply",),
    ),
    "check": Command("part.ply", ("part.ply",), ("--report made.json",)),
    "solid": Command("part.ply", ("part.ply",), ("-o made.step", "--report made.json")),
    "clearance": Command(
        "part.ply --motion way.csv wall.ply --rules rules.txt --curve 3",
        ("part.ply", "way.csv", "wall.ply", "rules.txt"),
        ("--csv made.csv", "--page made.html", "--report made.json"),
        ("--csv made.csv", "--page made.html"),
    ),
    "mechanism": Command(
        "--moving part.ply way.csv wall.ply", ("part.ply", "way.csv", "wall.ply"),
        ("--csv made.csv", "--page made.html", "--report made.json"),
        ("--csv made.csv", "--page made.html"),
    ),
    "overlap": Command(
        "part.ply over.ply", ("part.ply", "over.ply"),
        ("--csv made.csv", "--shared made.ply", "--report made.json"),
        ("--csv made.csv", "--shared made.ply"), status=3,
    ),
    "path": Command(
        "part.ply wall.ply --start 0,0,60 --rules rules.txt", ("part.ply", "wall.ply", "rules.txt"),
        ("-o made.csv", "--report made.json"), ("-o made.csv",),
    ),
    "sequence": Command(
        "--part part.ply motion:way.csv --part other.ply out:90 wall.ply",
        ("part.ply", "way.csv", "other.ply", "wall.ply"), ("-o motions", "--report made.json"),
    ),
    "study": Command(
        "study.toml", ("study.toml", "part.ply", "way.csv", "wall.ply"), ("--report made.json",)
    ),
}  # fmt: skip
if not _swept.HAS_SOLIDS:
    del RUNS["solid"]
EACH = pytest.mark.parametrize("name", RUNS)
STUDY = (
    '[[run]]\npart = "part.ply"\nmotion = "way.csv"\nneighbours = ["wall.ply"]\n'
    'compute = ["envelope", "clearance"]\nenvelope = { cell = 0.5 }\n'
)


@pytest.fixture
def folder(tmp_path):
    """Folder of the inputs: a part comes 50 mm along x, a wall beside its way, a part that it overlaps."""
    parts = {
        "part": block([-1, -1, -1], [1, 1, 1]),
        "wall": block([-5, 3, -5], [60, 5, 5]),
        "over": block([0, -0.5, -0.5], [4, 0.5, 0.5]),
        "other": block([-1, -9, -1], [1, -7, 1]),
    }
    for name, mesh in parts.items():
        _swept.write_mesh(tmp_path / f"{name}.ply", mesh.vertices, mesh.triangles)
    (tmp_path / "way.csv").write_text("0,50,0,0,0,0,0,1\n1,0,0,0,0,0,0,1\n")
    (tmp_path / "rules.txt").write_text("wall=0.5\n")
    (tmp_path / "study.toml").write_text(STUDY)
    (tmp_path / "motions").mkdir()
    return tmp_path


@pytest.fixture
def run(program, folder):
    """run(name, more words): the small run of a command in the folder of inputs."""

    def run(name, *more, words=None, **keywords):
        keywords.setdefault("timeout", 240)
        line = [
            program,
            name,
            *shlex.split(words or RUNS[name].words),
            *shlex.split(" ".join(more)),
        ]
        return subprocess.run(line, cwd=folder, capture_output=True, text=True, **keywords)

    return run


def contents(folder):
    """Bytes of all files, by name."""
    files = (path for path in pathlib.Path(folder).rglob("*") if path.is_file())
    return {str(path.relative_to(folder)): path.read_bytes() for path in files}


def test_every_command_is_here():
    assert sorted(RUNS) == sorted(COMMANDS)


@EACH
def test_no_output_takes_the_place_of_an_input_or_another_output(run, folder, name):
    command = RUNS[name]
    if name == "sequence":  # its outputs are files of a folder, called after the parts
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
def test_results_are_replaced_unless_no_clobber(run, folder, name):
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
        report.get("solid", {}).pop("file_bytes", None)  # with the date
    assert reproducible(again) == reproducible(first)
    (folder / command.inputs[0]).write_text("ply\nnothing")
    assert report_of(1)["status"] == "InvalidInput"


@EACH
def test_what_cannot_be_written_is_a_named_failure(
    run, folder, program, name, validator
):  # noqa: F811
    """Files that must not grow: the report says so too, and no half-written file is left."""
    before = sorted(contents(folder))
    for output in RUNS[name].outputs:
        if output.startswith("--report"):
            line = (
                f"{program} {name} {RUNS[name].words} -q {RUNS[name].needed} --report - > /dev/full"
            )
        else:
            line = f"ulimit -f 0; {program} {name} {RUNS[name].words} -q {output} --report - | cat"
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


@EACH
def test_standard_output_has_the_bytes_of_the_file(run, folder, name):
    for output in RUNS[name].streams:
        option, file = output.split()
        environment = {**os.environ, "SOURCE_DATE_EPOCH": "1700000000"}  # of pages
        assert run(name, output, "-q", env=environment).returncode == RUNS[name].status
        done = run(name, option, "-", env=environment)
        assert done.returncode == RUNS[name].status and not (folder / "-").exists()
        assert done.stdout.encode("utf-8", "surrogateescape") == (folder / file).read_bytes()


@EACH
def test_inputs_come_from_pipes(run, folder, program, name):
    """A pipe of the same name in another folder: the report is the one of the file."""
    command = RUNS[name]
    expected = json.loads(run(name, command.needed, "--report -").stdout)
    for input in command.inputs:
        if name == "study":  # reads its files in several processes, and again
            break
        (folder / "pipes").mkdir(exist_ok=True)
        os.mkfifo(folder / "pipes" / input)
        words = command.words.replace(input, "pipes/" + input)
        line = f"cat {input} > pipes/{input} & {program} {name} {words} {command.needed} --report -"
        done = subprocess.run(["bash", "-c", line], cwd=folder, capture_output=True, text=True)
        assert done.returncode == command.status, (input, done.stderr)
        found = reproducible(json.loads(done.stdout.replace("pipes/", "")))
        assert {**found, "solid": 0} == {**reproducible(expected), "solid": 0}, input


@EACH
def test_a_signal_ends_the_wait_for_a_pipe(folder, program, name):
    """Nobody writes into the pipe: before this the program could only be killed."""
    command = RUNS[name]
    for input in command.inputs[: 0 if name == "study" else None]:
        (folder / "pipes").mkdir(exist_ok=True)
        os.mkfifo(folder / "pipes" / input)
        words = f"{name} {command.words.replace(input, 'pipes/' + input)} {command.needed}"
        child = subprocess.Popen([program, *shlex.split(words)], cwd=folder, stderr=subprocess.PIPE)
        time.sleep(0.5)
        assert child.poll() is None, child.stderr.read()
        child.send_signal(signal.SIGTERM)
        try:
            child.wait(timeout=60)
        except subprocess.TimeoutExpired:
            child.kill()
            raise AssertionError(f"{words} goes on") from None
        finally:
            child.stderr.close()
        assert child.returncode in (-signal.SIGTERM, 128 + signal.SIGTERM), input  # 143 in a shell


def long_words(folder, name):
    """Words of a run that takes minutes."""
    write = _swept.write_mesh
    if name in ("path", "sequence"):  # a bent part in a closed box: searched as long as it may be
        bent = joined(box((-3, -3, -3), (3, 3, -2)), box((-3, -3, -1.9), (-2, 3, 3)))
        write(folder / "part.ply", *bent)
        walls = [((-5, -5, -5), (5, 5, -4)), ((-5, -5, 4), (5, 5, 5)), ((-5, -5, -4), (5, -4, 4)),
                 ((-5, 4, -4), (5, 5, 4)), ((-5, -4, -4), (-4, 4, 4)), ((4, -4, -4), (5, 4, 4))]  # fmt: skip
        write(folder / "wall.ply", *joined(*(box(*wall) for wall in walls)))
        how = "part.ply --extract 90" if name == "path" else "--part part.ply out:90"
        return f"{how} wall.ply --budget 3000"
    if name == "overlap":
        for i in range(12):
            points, triangles = ball(10.0, 160, 80)
            write(folder / f"ball{i}.ply", points + [0.8 * i, 0.3 * i, 0], triangles)
        return " ".join(f"ball{i}.ply" for i in range(12))
    rows = np.zeros((20000, 8))
    rows[:, 0], rows[:, 7] = np.arange(len(rows)), 1
    rows[:, 1:4] = 0.5 * np.random.default_rng(1).normal(size=(len(rows), 3))
    np.savetxt(folder / "way.csv", rows, "%.9g", ",")
    write(folder / "part.ply", *ball(10.0, 400, 200))
    points, triangles = ball(10.0, 400, 200)
    write(folder / "wall.ply", points + [22, 0, 0], triangles)
    return (
        RUNS[name].words.replace("--cell 0.5", "--resolution 900").replace("--rules rules.txt", "")
    )


@pytest.mark.parametrize("name", [n for n in RUNS if n not in ("check", "study", "solid")])
def test_terminated_runs_end_with_143(folder, program, name, validator):  # noqa: F811
    words = shlex.split(long_words(folder, name)) + ["--report", "made.json"]
    words += ["-o", "made.ply"] if name == "envelope" else []
    before = set(contents(folder))
    child = subprocess.Popen(
        [program, name, *words],
        cwd=folder,
        stderr=subprocess.PIPE,
        stdout=subprocess.PIPE,
        text=True,
    )
    wait_until_caught(child, signal.SIGTERM)
    time.sleep(0.5)
    assert child.poll() is None, child.communicate()
    child.send_signal(signal.SIGTERM)
    _, said = child.communicate(timeout=240)
    assert child.returncode == 143 and said.startswith("swept: Cancelled"), said
    report = json.loads((folder / "made.json").read_text())
    validator.validate(report)
    assert report["status"] == "Cancelled"
    assert set(contents(folder)) - before == {"made.json"}


def test_the_report_of_a_study_is_none_of_its_results(run, folder):
    for target in ("results/study.csv", "results/part way/x.json", "results/STUDY.json"):
        done = run("study", "--report", f"'{target}'")
        if target == "results/STUDY.json":
            assert done.returncode in (0, 1, 2)  # another file where names differ by case
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


def test_shared_volumes_are_refused_before_anything_is_computed(run, folder):
    for target in ("x.step", "x.foo", "x"):
        done = run("overlap", "--shared", target)
        assert done.returncode == 2 and "unknown format" in done.stderr, done.stderr
    line = "--report made.json --shared made.ply"
    done = run("overlap", line, words="part.ply wall.ply")
    report = json.loads((folder / "made.json").read_text())
    assert done.returncode == 1 and report["code"] == "NothingShared" and report["pairs"]


def scene_of_examples(folder):
    """Files of the names that the examples of the help speak of."""
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
        for file in re.findall(r"[\w/]+\.(?:ply|stl|step|csv|toml)\b", read.replace("*", "a")):
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
    """The schema of the newest commands refuses keys that do not belong, and values of another kind."""
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
