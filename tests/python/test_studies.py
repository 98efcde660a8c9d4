# SPDX-License-Identifier: LGPL-2.1-or-later
"""Studies: the same bytes as single runs; finished runs are kept; a failed run does not affect the others;
clusters; bad files.
"""
import json
import os
import pathlib
import re
import signal
import subprocess
import sys
import time

import pytest

import _swept
import swept_volume as sv
from test_program import call, inputs  # noqa: F401
from test_reports import reproducible, validator  # noqa: F401

STAGES = ["envelope", "solid", "clearance"] if _swept.HAS_SOLIDS else ["envelope", "clearance"]
HEAD = f"""
[study]
name = "boxes"
[defaults]
part = "box.ply"
compute = {json.dumps(STAGES)}
envelope = {{ resolution = 24 }}
neighbours = ["post.ply", "rail.ply"]
"""


def write_motion(path, distance):
    path.write_text(f"0,0,0,0,0,0,0,1\n1,{distance},0,0,0,0,0,1\n")


@pytest.fixture
def study(inputs, box):  # noqa: F811
    """Makes a folder with a box, motions of 30, 40 and 50 mm, a post at a distance of 5 mm, and a
    rail in the way."""
    vertices, triangles = box
    _swept.write_mesh(inputs / "post.ply", vertices + [0, 25, 0], triangles)
    _swept.write_mesh(inputs / "rail.ply", vertices + [45, 0, 0], triangles)
    for distance in (30, 40, 50):
        write_motion(inputs / f"by{distance}.csv", distance)
    (inputs / "study.toml").write_text(
        HEAD + '[[run]]\nmotion = ["by30.csv", "by40.csv", "by50.csv"]\n'
        'rules = { rail = "ignore" }\n[[run]]\nname = "with rail"\nmotion = "by50.csv"\n'
    )
    return inputs


@pytest.fixture
def run(program, study):
    """Returns a function that runs `swept study FILE` and returns the finished process."""

    def run(*words, file="study.toml", **keywords):
        command = [program, "study", str(study / file), *map(str, words)]
        return subprocess.run(command, capture_output=True, text=True, timeout=240, **keywords)

    return run


def without_date(path):
    return re.sub(rb"FILE_NAME\(.*", b"", path.read_bytes())


def results(folder):
    """Returns the bytes of all meshes and solids, and the parts of the reports that are the same in
    every run."""
    found = {}
    for path in sorted(pathlib.Path(folder).glob("*/*")):
        key = str(path.relative_to(folder))
        found[key] = without_date(path)
        if path.suffix == ".json":
            found[key] = reproducible(json.loads(path.read_text()))
    return found


def test_results_are_the_bytes_of_single_runs(run, call, study, validator):  # noqa: F811
    done = run("--report", "-")
    assert done.returncode == 3, done.stderr
    report = json.loads(done.stdout)
    validator.validate(report)
    assert [row["state"] for row in report["runs"]] == ["done"] * 3 + ["not clear"]
    assert report["worst"] == "with rail" and report["runs"][3]["verdict"] == "clash"
    assert report["runs"][0]["distance"] == pytest.approx(5, abs=0.01)
    folder = study / "results" / "with rail"
    own = json.loads((folder / "report.json").read_text())
    validator.validate(own)
    moving = [study / "box.ply", "--motion", study / "by50.csv"]
    single = ["envelope", *moving, "--resolution", 24, "-o"]
    assert call(*single, study / "one.ply").returncode == 0
    assert (folder / "envelope.ply").read_bytes() == (study / "one.ply").read_bytes()
    if _swept.HAS_SOLIDS:
        assert call(*single, study / "solid.step").returncode == 0
        assert without_date(folder / "solid.step") == without_date(study / "solid.step")
    neighbours = [study / "post.ply", study / "rail.ply"]
    found = call("clearance", *moving, *neighbours, "--report", "-")
    expected = reproducible(json.loads(found.stdout))
    assert reproducible(own["clearance"]) == expected


def test_pages_of_runs(run, study):
    text = (study / "study.toml").read_text()
    (study / "study.toml").write_text(text + "clearance = { page = true }\n")
    assert run().returncode == 3
    page = study / "results/with rail/clearance.html"
    assert "with rail" in page.read_text() and "clash" in page.read_text().lower()
    assert not (study / "results/box by30/clearance.html").exists()
    first = page.read_bytes()
    page.unlink()
    run()
    assert page.read_bytes() == first, "what is missing is made again, the same"


def test_any_number_of_processes_gives_the_same(run, study):
    assert run("--jobs", 1, "-o", study / "one").returncode == 3
    assert run("--jobs", 3, "-o", study / "three").returncode == 3
    assert results(study / "one") == results(study / "three") != {}
    assert (study / "one/study.csv").read_bytes() == (study / "three/study.csv").read_bytes()


def test_what_is_done_is_kept(run, study):
    run()
    before = {p: p.stat().st_mtime_ns for p in (study / "results").glob("*/*")}

    def computed_again():
        assert run().returncode == 3
        after = {p: p.stat().st_mtime_ns for p in (study / "results").glob("*/*")}
        changed = {p.parent.name for p in after if after[p] != before.get(p)}
        before.update(after)
        return changed

    assert computed_again() == set()
    write_motion(study / "by40.csv", 41)
    assert computed_again() == {"box by40"}
    (study / "results/box by30/envelope.ply").unlink()
    assert computed_again() == {"box by30"}
    (study / "results/box by50/report.json").write_text("{")
    assert computed_again() == {"box by50"}
    text = (study / "study.toml").read_text()
    (study / "study.toml").write_text(text.replace('"ignore"', "3"))
    assert computed_again() == {"box by30", "box by40", "box by50"}
    assert run("--again", "-q").returncode == 3
    assert computed_again() == {"box by30", "box by40", "box by50", "with rail"}


def test_a_run_that_fails_stops_no_other(run, study, validator):  # noqa: F811
    (study / "by40.csv").write_text("0,0,0,0,0,0,0,1\n1,nan,0,0,0,0,0,1\n")
    done = run("--report", study / "all.json")
    assert done.returncode == 1 and "1 of 4 runs failed; 'box by40'" in done.stderr
    report = json.loads((study / "all.json").read_text())
    validator.validate(report)
    states = {row["run"]: row["state"] for row in report["runs"]}
    assert list(states.values()) == ["done", "failed", "done", "not clear"]
    assert report["worst"] == "box by40" and "line 2" in report["runs"][1]["message"]
    validator.validate(json.loads((study / "results/box by40/report.json").read_text()))
    write_motion(study / "by40.csv", 40)
    assert run().returncode == 3, "what failed is computed again"


def children(pid):
    """Returns the process numbers of the children of a process."""
    lists = pathlib.Path(f"/proc/{pid}/task").glob("*/children")
    return [int(word) for path in lists for word in path.read_text().split()]


def wait_for(condition, seconds=60):
    end = time.monotonic() + seconds
    while time.monotonic() < end:
        found = condition()
        if found:
            return found
        time.sleep(0.02)
    raise AssertionError(f"nothing within {seconds} s")


LONG = '[[run]]\nname = "long"\nmotion = "by30.csv"\ncompute = ["envelope"]\n' + (
    "envelope = { resolution = 1500 }\n"
)


def test_what_costs_accuracy_is_a_failure_with_strict(run, study):
    """The solid of the turned box has more faces than allowed: a simpler one is made, and the report
    says so."""
    if "solid" not in STAGES:
        pytest.skip("built without OpenCASCADE")
    (study / "turn.csv").write_text("0,0,0,0,0,0,0,1\n1,5,0,0,0.5,0.5,0.5,0.5\n")
    (study / "study.toml").write_text(
        '[defaults]\npart = "box.ply"\ncompute = ["solid"]\nenvelope = { resolution = 24 }\n'
        '[[run]]\nname = "turned"\nmotion = "turn.csv"\nsolid = { max_faces = 250 }\n'
        '[[run]]\nname = "straight"\nmotion = "by30.csv"\n'
    )
    done = run("--strict")
    assert done.returncode == 1, done.stderr
    report = json.loads((study / "results" / "study.json").read_text())
    states = {row["run"]: row["state"] for row in report["runs"]}
    assert states == {"turned": "failed", "straight": "done"} and report["failed"] == 1
    row = next(row for row in report["runs"] if row["run"] == "turned")
    assert row["message"].startswith("strict: ") and "SolidSimplified" in row["findings"]
    written = (study / "results" / "turned" / "solid.step").read_bytes()
    done = run()
    assert done.returncode == 0, done.stderr
    report = json.loads((study / "results" / "study.json").read_text())
    assert report["done"] == 2
    assert (study / "results" / "turned" / "solid.step").read_bytes() == written


def test_a_process_that_dies_is_one_failed_run(program, study):
    (study / "study.toml").write_text(HEAD + LONG + '[[run]]\nname = "b"\nmotion = "by40.csv"\n')
    command = [program, "study", str(study / "study.toml"), "--jobs", "1"]
    process = subprocess.Popen(command, stderr=subprocess.PIPE, text=True)
    wait_for(lambda: list((study / "results").glob(".partial-*")))
    (child,) = children(process.pid)
    os.kill(child, signal.SIGKILL)
    _, errors = process.communicate(timeout=240)
    assert process.returncode == 1
    assert "failed    long: the process of the run was ended by SIGKILL" in errors
    report = json.loads((study / "results/study.json").read_text())
    assert [row["state"] for row in report["runs"]] == ["failed", "not clear"]
    assert not list((study / "results").glob(".partial-*"))


@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM])
def test_a_study_that_is_stopped_goes_on(program, run, study, number):
    text = HEAD + '[[run]]\nname = "a"\nmotion = "by40.csv"\n'
    (study / "study.toml").write_text(text + LONG)
    command = [program, "study", str(study / "study.toml"), "--jobs", "1"]
    process = subprocess.Popen(command, stderr=subprocess.PIPE, text=True)
    wait_for((study / "results/a/report.json").exists)
    process.send_signal(number)
    _, errors = process.communicate(timeout=240)
    assert process.returncode == 128 + number
    assert "stopped; 1 of 2 runs are left" in errors
    report = json.loads((study / "results/study.json").read_text())
    assert [row["state"] for row in report["runs"]] == ["not clear", "not run"]
    assert not list((study / "results").glob(".partial-*"))
    before = (study / "results/a/report.json").stat().st_mtime_ns
    (study / "study.toml").write_text(text + LONG.replace("1500", "24"))
    assert run().returncode == 3
    assert (study / "results/a/report.json").stat().st_mtime_ns == before


RUN = '[[run]]\npart = "box.ply"\nmotion = "by30.csv"\ncompute = ["envelope"]\n'
CHECK = '[[run]]\npart = "box.ply"\nmotion = "by30.csv"\nneighbours = ["post.ply"]\n' + (
    'compute = ["clearance"]\n'
)


@pytest.mark.parametrize(
    "text, said",
    [
        (RUN + "resoluton = 3", "run 1: unknown key 'resoluton'; known keys: name, part"),
        (RUN + "envelope = { resoluton = 3 }", "run 1, envelope: unknown key 'resoluton'; did you"),
        (RUN + "envelope = { resolution = 1.5 }", "resolution is 1.5; it must be a whole number"),
        (RUN + "envelope = { cell = 1, resolution = 9 }", "cell and resolution exclude"),
        (RUN + 'motion_unit = "ft"', "motion_unit is 'ft'; it must be one of mm, cm, m, in"),
        (RUN + "pivot = [1, 2]", "pivot is [1, 2]; it must be a list of three numbers"),
        (RUN + "pivot = [1, 2, nan]", "it must be a list of three numbers"),
        (RUN + 'compute_command = "rm"', "unknown key 'compute_command'"),
        (RUN + RUN, "two runs are called 'box by30'"),
        (RUN + 'name = "../away"', "run '../away': a name has"),
        (RUN + 'name = ".."', "run '..': a name has"),
        (RUN.replace("by30", "gone"), "there is no file '"),
        (RUN.replace('["envelope"]', '["clearance"]'), "there are no neighbours"),
        (RUN.replace('["envelope"]', '["drawing"]'), "it must be a list of envelope, solid"),
        ('[[run]]\nmotion = "by30.csv"', "run 1: part and compute missing"),
        ('[study]\noutput = "."\n' + RUN, "lies in the folder for results"),
        (RUN + 'name = "Study.csv"', "run 'Study.csv': the study writes a file with this name"),
        (RUN + 'name = "study.html"', "the study writes a file with this name"),
        (CHECK + 'rules = { post = "touch" }', "rules: rule 'touch' is not understood; write"),
        (
            CHECK + "rules = { post = -1 }",
            "rules: rule '-1.0': a required distance of -1 mm is not",
        ),
        (
            CHECK + "rules = { pots = 3 }",
            "rules: the rule for 'pots' names no neighbour; the neighbours are: 'p",
        ),
        (
            CHECK + "rules = { 'p*' = 3, '*t' = 4 }",
            "rules: two rules contradict each other for neig",
        ),
        (
            CHECK.replace("post", "box"),
            "box.ply' is the part that moves and a neighbour; take it out",
        ),
        ('[study]\npage = "yes"\n' + RUN, "[study]: page is 'yes'; it must be true or false"),
        ('[study]\nlanguage = "fr"\n' + RUN, "language is 'fr'; it must be one of en, de"),
        ('[study]\ntemplate = "gone.html"\n' + RUN, "gone.html' cannot be read"),
        (
            '[study]\ntemplate = "by30.csv"\npages = true\n' + RUN,
            "unknown key 'pages'; did you mean",
        ),
        ("[[run]", "at line 1"),
        ("x = 1\n" + RUN, "the file: unknown key 'x'; known keys: study, defaults, run"),
        ("", "it has no table [[run]]"),
    ],
)
def test_bad_files_are_refused_before_anything_runs(run, study, text, said):
    (study / "bad.toml").write_text(text)
    done = run(file="bad.toml")
    assert done.returncode == 1 and "swept: InvalidInput/BadStudy: '" in done.stderr
    assert said in done.stderr and "bad.toml" in done.stderr
    assert not (study / "results").exists()


def test_bad_options(run, study):
    assert run("--jobs", 0).returncode == 2
    assert run("--send-files").returncode == 2
    assert run("--jobs", "many").returncode == 2
    assert "No such file" in run(file="gone.toml").stderr
    done = run("--report", study / "by30.csv")
    assert done.returncode == 2 and "is an input" in done.stderr
    assert (study / "by30.csv").read_text().startswith("0,0")


def test_modules_in_the_current_folder_are_not_run(run, study):
    for name in ("json", "numpy", "swept_volume", "tomllib"):
        (study / f"{name}.py").write_text(f"open('{study}/was_run', 'w').close()")
    assert run(cwd=study).returncode == 3
    assert not (study / "was_run").exists()


def test_program_and_package_have_the_same_options(call):  # noqa: F811
    package = pathlib.Path(sv.__file__).parents[1]
    environment = {**os.environ, "PYTHONPATH": str(package)}
    words = [sys.executable, "-m", "swept_volume", "study", "--help"]
    own = subprocess.run(words, env=environment, capture_output=True, text=True, check=True)
    options = [set(re.findall(r"--[a-z-]+", text.split("Examples")[0]))
               for text in (own.stdout, call("study", "--help").stdout)]  # fmt: skip
    assert options[0] == options[1] and "--scheduler" in options[0]


def test_from_python(study):
    rows = []
    report = sv.run_study(
        study / "study.toml", jobs=2, progress=lambda done, total, row: rows.append((done, total))
    )
    assert rows == [(n, 4) for n in range(1, 5)] and report["kept"] == 0
    context = sv.RunContext()
    context.cancel()
    stopped = sv.run_study(study / "study.toml", again=True, run=context)
    assert stopped["status"] == "Cancelled" and stopped["not_run"] == 4
    with pytest.raises(sv.InvalidInput, match="jobs is 0"):
        sv.run_study(study / "study.toml", jobs=0)
    parts = sv.read_parts(study / "post.ply")
    assert [name for name, _ in parts] == ["post"] and len(parts[0][1].triangles) == 12


@pytest.fixture
def cluster(tmp_path):
    """Starts a scheduler on the loopback interface with two workers. Returns its address and the
    workers."""
    pytest.importorskip("distributed", reason="dask.distributed is not installed")
    package = str(pathlib.Path(sv.__file__).parents[1])
    environment = {**os.environ, "PYTHONPATH": package}
    started = []

    def start(*words):
        with open(tmp_path / f"dask{len(started)}.log", "w") as log:
            command = [sys.executable, "-m", *words, "--no-dashboard"]
            started.append(subprocess.Popen(command, env=environment, stdout=log, stderr=log))

    file = tmp_path / "scheduler.json"
    start("distributed.cli.dask_scheduler", "--host", "127.0.0.1", "--port", "0",
          "--scheduler-file", str(file))  # fmt: skip
    wait_for(lambda: file.exists() and file.read_text())
    address = json.loads(file.read_text())["address"]
    for _ in range(2):
        start("distributed.cli.dask_worker", address, "--nthreads", "1", "--no-nanny",
              "--host", "127.0.0.1", "--local-directory", str(tmp_path))  # fmt: skip
    yield address, started[1:]
    for process in reversed(started):
        process.kill()
        process.wait()


@pytest.mark.parametrize("sending", [[], ["--send-files"]])
def test_a_cluster_gives_the_same_bytes(cluster, run, study, sending):
    assert run("-o", study / "here").returncode == 3
    done = run("-o", study / "there", "--scheduler", cluster[0], *sending)
    assert done.returncode == 3, done.stderr
    assert results(study / "here") == results(study / "there") != {}


def test_a_worker_that_dies_costs_nothing(cluster, program, study):
    address, workers = cluster
    text = HEAD + '[[run]]\nname = "first"\nmotion = "by40.csv"\n'
    text += "".join(
        f'[[run]]\nname = "r{n}"\nmotion = "by30.csv"\ncompute = ["envelope"]\n'
        f"envelope = {{ resolution = {300 + n} }}\n"
        for n in range(8)
    )
    (study / "study.toml").write_text(text)
    command = [program, "study", str(study / "study.toml"), "--scheduler", address, "--send-files"]
    process = subprocess.Popen(command, stderr=subprocess.PIPE, text=True)
    wait_for(lambda: len(list((study / "results").glob("*/report.json"))) >= 2)
    workers[0].kill()
    _, errors = process.communicate(timeout=240)
    assert process.returncode == 3, errors
    report = json.loads((study / "results/study.json").read_text())
    assert [row["state"] for row in report["runs"]] == ["not clear"] + ["done"] * 8


def test_no_scheduler(run):
    done = run("--scheduler", "tcp://127.0.0.1:1")
    assert done.returncode == 1 and "127.0.0.1:1" in done.stderr
