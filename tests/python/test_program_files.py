# SPDX-License-Identifier: LGPL-2.1-or-later
"""The program and its files: no file is lost, pipes work, several files, all forms of the help."""
import csv
import io
import json
import os
import shutil
import signal
import subprocess
import time
from collections import Counter

import numpy as np
import pytest

import _swept
from bodies import ball, torus
from test_program import COMMANDS, call, envelope, inputs, long_run, wait_until_caught  # noqa: F401

SOLIDS = pytest.mark.skipif(not _swept.HAS_SOLIDS, reason="built without OpenCASCADE")


@pytest.mark.parametrize(
    "output, report, says",
    [
        ("box.ply", None, "is the moving part"),
        ("./box.ply", None, "is the moving part"),
        ("link.ply", None, "is the moving part"),
        ("hard.ply", None, "is the moving part"),
        ("o.ply", "slide.csv", "is the motion"),
        ("o.ply", "../{here}/slide.csv", "is the motion"),
        ("o.ply", "o.ply", "is also the file of --output"),
        ("o.ply", "./o.ply", "is also the file of --output"),
        ("dangling.ply", "nowhere.ply", "is also the file of --output"),
    ],
)
def test_outputs_that_are_inputs_or_other_outputs(call, inputs, output, report, says):  # noqa: F811
    (inputs / "link.ply").symlink_to("box.ply")
    os.link(inputs / "box.ply", inputs / "hard.ply")
    (inputs / "dangling.ply").symlink_to("nowhere.ply")
    before = sorted(os.listdir(inputs))
    bytes_before = (inputs / "box.ply").read_bytes(), (inputs / "slide.csv").read_bytes()
    more = ["--report", report.format(here=inputs.name)] if report else []
    done = call(
        "envelope", "box.ply", "--motion", "slide.csv", "--output", output, *more, cwd=inputs
    )
    assert done.returncode == 2 and says in done.stderr, done.stderr
    assert done.stderr.count("\n") == 1 and "SameFile" in done.stderr
    assert sorted(os.listdir(inputs)) == before
    assert bytes_before == ((inputs / "box.ply").read_bytes(), (inputs / "slide.csv").read_bytes())


def test_standard_output_that_is_an_input_or_another_output(program, inputs):  # noqa: F811
    whole = (inputs / "box.ply").read_bytes()
    rest = "--motion slide.csv --resolution 16 --quiet"
    for line, says in (
        (f"{program} envelope box.ply {rest} -o - >> box.ply", "is the moving part"),
        (f"{program} envelope - {rest} -o - < box.ply >> box.ply", "is the moving part"),
        (f"{program} check box.ply --report - >> box.ply", "is the file to check"),
        (f"{program} envelope box.ply {rest} -o o.ply --report - > o.ply", "the file of --output"),
        (f"{program} envelope box.ply {rest} -o - --report - > /dev/null", "the file of --output"),
    ):
        done = subprocess.run(["bash", "-c", line], cwd=inputs, capture_output=True, text=True)
        assert done.returncode == 2 and says in done.stderr, line + done.stderr
        assert (inputs / "box.ply").read_bytes() == whole
    line = f"{program} envelope box.ply {rest} -o o.ply --report - > /dev/null"
    assert subprocess.run(["bash", "-c", line], cwd=inputs).returncode == 0


def test_check_and_clearance_do_not_overwrite_their_inputs(call, inputs):  # noqa: F811
    whole = (inputs / "box.ply").read_bytes()
    box, other = inputs / "box.ply", inputs / "other.ply"
    shutil.copy(box, other)
    words = ["clearance", box, other, "--motion", inputs / "slide.csv"]
    for arguments in (
        ["check", box, "--report", box],
        [*words, "--csv", box],
        [*words, "--csv", other],
        [*words, "--csv", inputs / "x", "--report", inputs / "x"],
    ):
        done = call(*arguments)
        assert done.returncode == 2 and "SameFile" in done.stderr, done.stderr
    assert box.read_bytes() == other.read_bytes() == whole and not (inputs / "x").exists()


def test_results_are_replaced_unless_no_clobber(call, inputs):  # noqa: F811
    (inputs / "o.ply").write_text("old")
    done = call(*envelope(inputs, "o.ply", "--no-clobber"))
    assert done.returncode == 1 and "ExportFailed/Exists" in done.stderr, done.stderr
    assert (inputs / "o.ply").read_text() == "old"
    assert call(*envelope(inputs, "o.ply", "--resolution", 16)).returncode == 0
    assert call("check", inputs / "o.ply").returncode == 0
    assert call(*envelope(inputs, "new.ply", "--no-clobber", "--resolution", 16)).returncode == 0


def test_limit_of_file_sizes_is_a_named_failure(program, inputs):  # noqa: F811
    words = " ".join(map(str, envelope(inputs, "o.ply")))
    done = subprocess.run(
        ["bash", "-c", f"ulimit -f 20; exec {program} {words}"], capture_output=True, text=True
    )
    assert done.returncode == 1 and "ExportFailed/WriteFailed" in done.stderr, done.stderr
    line = f"ulimit -f 1; {program} {words} -o - | cat".replace(f"--output {inputs}/o.ply", "")
    done = subprocess.run(["bash", "-c", line], capture_output=True, text=True)
    assert "WriteFailed: temporary file for standard output: " in done.stderr, done.stderr
    assert sorted(os.listdir(inputs)) == ["box.ply", "slide.csv"], "left-overs"


def test_closed_pipe_and_full_device_are_named_failures(program, inputs):  # noqa: F811
    for target in ("/dev/full", "| true"):
        redirect = f"> {target}" if target[0] == "/" else target
        done = subprocess.run(
            ["bash", "-o", "pipefail", "-c",
             f"(sleep 0.3; exec {program} check {inputs}/box.ply --report -) {redirect}"],
            capture_output=True, text=True,
        )  # fmt: skip
        assert done.returncode == 1 and "ExportFailed/WriteFailed" in done.stderr, done.stderr
        assert done.stderr.count("\n") == 1, "said twice: " + done.stderr


def test_terminated_runs_end_with_143(program, shared, inputs):  # noqa: F811
    child = subprocess.Popen(long_run(program, shared, inputs), stderr=subprocess.PIPE, text=True)
    wait_until_caught(child, signal.SIGTERM)
    time.sleep(0.3)
    child.send_signal(signal.SIGTERM)
    _, errors = child.communicate(timeout=60)
    assert child.returncode == 143, errors
    assert json.loads((inputs / "r.json").read_text())["status"] == "Cancelled"
    assert sorted(os.listdir(inputs)) == ["box.ply", "r.json", "slide.csv"]


def test_pipes_in_and_out_give_the_same_bytes(program, inputs):  # noqa: F811
    subprocess.run([program, *map(str, envelope(inputs, "o.ply", "--resolution", 24))], check=True)
    expected = (inputs / "o.ply").read_bytes()
    rest = "--resolution 24 --quiet"
    for line in (
        f"cat slide.csv | {program} envelope box.ply --motion - -o piped.ply {rest}",
        f"cat box.ply | {program} envelope - --motion slide.csv -o piped.ply {rest}",
        f"{program} envelope - --motion slide.csv -o piped.ply {rest} < box.ply",
        f"{program} envelope box.ply --motion <(cat slide.csv) -o piped.ply {rest}",
        f"{program} envelope box.ply --motion /dev/stdin -o piped.ply {rest} < slide.csv",
        f"gzip -c slide.csv | {program} envelope box.ply --motion - -o piped.ply {rest}",
        f"{program} envelope box.ply --motion slide.csv -o - {rest} > piped.ply",
        f"mkfifo f; cat slide.csv > f & {program} envelope box.ply --motion f -o piped.ply {rest}",
    ):
        done = subprocess.run(
            ["bash", "-c", line], cwd=inputs, capture_output=True, text=True, timeout=60
        )
        assert done.returncode == 0 and done.stderr == "", line + done.stderr
        assert (inputs / "piped.ply").read_bytes() == expected, line
        (inputs / "piped.ply").unlink()


@SOLIDS
def test_solids_and_meshes_from_pipes(program, inputs, box):  # noqa: F811
    """The format of input from a pipe follows from its first bytes, or from an option."""
    _swept.write_mesh(inputs / "far.ply", box[0] + [100, 0, 0], box[1])
    _swept.write_mesh(inputs / "box.stl", *box)
    for name in ("box", "far"):
        line = [program, "solid", name + ".ply", "-o", name + ".step", "-q"]
        subprocess.run(line, cwd=inputs, check=True)
    (inputs / "x.step").symlink_to("/dev/stdin")

    def run(line):
        done = subprocess.run(
            ["bash", "-c", line.replace("swept", program, 1)], cwd=inputs, capture_output=True,
            text=True,
        )  # fmt: skip
        return done.returncode, done.stdout + done.stderr

    for line in (
        "swept check - < box.step",
        "swept check <(cat box.step)",
        "cat box.step | swept check x.step",
        "cat box.step | swept check - --format step",
    ):
        status, output = run(line)
        assert status == 0 and "1 solids" in output, line + output
    for line in (
        "swept clearance {} <(cat far.step) --motion <(cat slide.csv) -q --csv - < box.ply",
        "swept clearance {} <(cat far.ply) --motion <(cat slide.csv) -q --csv - < box.step",
        "swept clearance {} --body-format stl far.step --motion slide.csv -q --csv - < box.stl",
    ):
        for body in ("-", "/dev/stdin"):
            status, output = run(line.format(body))
            assert status == 0 and ",clear,40" in output, line + output
    for line, says in (
        ("cat box.ply | swept check - --format step", "'-' does not begin like a STEP"),
        ("cat slide.csv | swept check -", "has no file extension"),
        ("swept check <(head -c 300 box.step)", "is not a valid STEP file"),
    ):
        status, output = run(line)
        assert status == 1 and says in output and "/proc/" not in output, output


def test_formats_of_standard_input_and_output(program, inputs):  # noqa: F811
    line = (
        f"{program} envelope box.ply --motion slide.csv --resolution 16 -o - --format stl | "
        f"{program} check - --format stl --report -"
    )
    done = subprocess.run(["bash", "-c", line], cwd=inputs, capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    assert json.loads(done.stdout)["closed"] and json.loads(done.stdout)["input"] == "-"
    done = subprocess.run([program, "envelope", "-", "--motion", "-", "-o", str(inputs / "o.ply")],
                          capture_output=True, text=True, input="")  # fmt: skip
    assert done.returncode == 2 and "standard input" in done.stderr


def test_csv_of_clearance_on_standard_output(call, inputs, box):  # noqa: F811
    _swept.write_mesh(inputs / "wall.ply", box[0] + [100, 0, 0], box[1])
    words = ("clearance", inputs / "box.ply", inputs / "wall.ply", "--motion", inputs / "slide.csv")
    done = call(*words, "--csv", "-", cwd=inputs)
    assert done.returncode == 0 and done.stdout.startswith("neighbour,verdict,"), done.stderr
    assert done.stdout.count("\n") == 2 and not (inputs / "-").exists()


def test_all_inputs_are_looked_at_first(call, inputs):  # noqa: F811
    shutil.copy(inputs / "box.ply", inputs / "other.ply")
    words = [
        "clearance",
        inputs / "box.ply",
        inputs / "other.ply",
        "--motion",
        inputs / "slide.csv",
    ]
    for name in ("absent.step", "absent.ply"):
        done = call(*words, inputs / name)
        assert done.returncode == 1 and f"{name}' does not exist" in done.stderr, done.stderr


@SOLIDS
def test_a_file_that_is_no_step_file_is_not_one_just_written(call, inputs):  # noqa: F811
    (inputs / "bad.step").write_text("ISO-10303-21;\nHEADER;\nENDSEC;\nDATA;\nENDSEC;\n")
    (inputs / "bad.brep").write_text("nothing")
    for name in ("bad.step", "bad.brep"):
        done = call("check", inputs / name)
        assert done.returncode == 1 and name in done.stderr and "InvalidInput" in done.stderr
        assert "written" not in done.stderr


@SOLIDS
def test_conservative_solids_name_what_works(call, inputs):  # noqa: F811
    words = envelope(inputs, "o.step", "--conservative", "--resolution", 24)
    done = call(*words, "--max-faces", 4)
    assert done.returncode == 1 and "TooManyFaces" in done.stderr, done.stderr
    assert "tolerance, raise" not in done.stderr and "larger cells" in done.stderr
    assert "mesh file" in done.stderr


@SOLIDS
def test_solids_simplified_unasked_say_so(call, inputs, program):  # noqa: F811
    """Solids of turned bodies have many faces, so the limit of faces leads to a simpler solid."""
    turn = "0,0,0,0,0,0,0,1\n1,5,0,0,0.5,0.5,0.5,0.5\n"
    (inputs / "slide.csv").write_text(turn)
    words = envelope(inputs, "o.step", "--resolution", 24, "--max-faces", 250, "--quiet")
    done = call(*words, "--report", "-")
    assert done.returncode == 0, done.stderr
    report = json.loads(done.stdout)
    found = [w for w in report["warnings"] if w["code"] == "SolidSimplified"]
    assert len(found) == 1 and report["solid"]["deviation"] > 0
    assert "SolidSimplified" in done.stderr and "%" in done.stderr
    (inputs / "o.step").unlink()
    done = call(*words, "--strict")
    assert done.returncode == 1 and not (inputs / "o.step").exists(), done.stderr


def test_the_chord_is_kept_or_a_finding_and_strict_a_failure(call, inputs):  # noqa: F811
    """Sweeps a serrated cone of many long triangles that turns fast: its edges need many placements,
    which take memory. It cannot be thinned."""
    count, chord = 5000, 0.06  # chord in mm, much less than a cell
    angles = np.linspace(0, 2 * np.pi, count, endpoint=False)
    first = np.arange(count)
    radii = 100 - first % 2
    rim = np.stack([radii * np.cos(angles), radii * np.sin(angles), 0 * angles], axis=1)
    after = (first + 1) % count
    sides = np.stack([first, after, np.full(count, count)], axis=1)
    base = np.stack([after, first, np.full(count, count + 1)], axis=1)
    points = np.concatenate([rim, [[0, 0, 100], [0, 0, 0]]])
    _swept.write_mesh(inputs / "box.ply", points, np.concatenate([sides, base]))
    rows = [f"{i},0,0,0,{np.sin(i / 2)},0,0,{np.cos(i / 2)}" for i in range(3)]
    (inputs / "slide.csv").write_text("\n".join(rows) + "\n")
    words = envelope(inputs, "o.ply", "--resolution", 16, "--chord-tolerance", chord)

    def report():
        return json.loads((inputs / "r.json").read_text())

    done = call(*words, "--strict", "--report", inputs / "r.json")
    assert done.returncode == 0, done.stderr
    assert 0 < report()["chord_error"] <= chord * (1 + 1e-6)
    (inputs / "o.ply").unlink()
    little = [*words, "--memory-limit", 64]
    done = call(*little, "--strict", "--report", inputs / "r.json")
    assert done.returncode == 1 and "ChordCapped" in done.stderr, done.stderr
    assert report()["code"] == "ChordCapped"
    assert report()["chord_error"] > chord
    assert not (inputs / "o.ply").exists()
    done = call(*little, "--quiet")
    assert done.returncode == 0 and "ChordCapped" in done.stderr and done.stdout == ""


@SOLIDS
def test_a_solid_keeps_its_tolerance_or_is_refused_with_strict(call, inputs):  # noqa: F811
    """Bodies so coarse that the facets of their solids use most of the tolerance."""
    vertices, triangles = torus(20, 8, 24, 12)
    rough = vertices + 0.2 * np.random.default_rng(3).standard_normal(vertices.shape)
    for body, tolerance in ((ball(10, 12, 6), 1.0), ((rough, triangles), 0.6)):
        _swept.write_mesh(inputs / "b.ply", *body)
        words = ("solid", inputs / "b.ply", "-o", inputs / "b.step", "--solid-tolerance", tolerance)
        done = call(*words, "--strict", "--report", inputs / "r.json")
        report = json.loads((inputs / "r.json").read_text())
        assert (done.returncode == 0) == (report["status"] == "Ok") == (inputs / "b.step").exists()
        if done.returncode == 0:
            assert 0.8 * tolerance < report["solid"]["deviation"] <= tolerance
            (inputs / "b.step").unlink()
        else:
            assert report["code"] == "SolidInaccurate"


@SOLIDS
def test_neighbours_are_called_as_the_products_of_a_step_file(call, inputs, shared):  # noqa: F811
    assembly = shared / "cad" / "bracket_assembly_as1.step"
    words = ("clearance", inputs / "box.ply", assembly, shared / "cad" / "link_rod.step")
    done = call(*words, "--motion", inputs / "slide.csv", "--csv", "-", "-q",
                "--report", inputs / "r.json")  # fmt: skip
    assert done.returncode in (0, 3), done.stderr
    names = [row["neighbour"] for row in csv.DictReader(io.StringIO(done.stdout))]
    report = json.loads((inputs / "r.json").read_text())
    assert names == [neighbour["name"] for neighbour in report["neighbours"]]
    counts = Counter(name.rstrip("0123456789 ") for name in names)
    assert counts == {"nut": 8, "bolt": 6, "l-bracket": 2, "plate": 1, "rod": 1, "link_rod": 1}
    assert len(set(names)) == len(names) == 19 and {"nut 1", "bolt 6", "plate"} <= set(names)


@pytest.mark.parametrize("suffix", ["stl", "obj", "off", "ply"])
@pytest.mark.parametrize("far", [0, 10000])
def test_check_finds_in_the_file_what_the_report_said(call, inputs, suffix, far):  # noqa: F811
    """Ten metres from the origin, the coordinates of STL are a micrometre apart."""
    half = np.radians(45) / 2
    rows = [f"0,{far},{0.7 * far},0,0,0,0,1",
            f"1,{far + 40},{0.7 * far},0,0,0,{np.sin(half)},{np.cos(half)}"]  # fmt: skip
    (inputs / "slide.csv").write_text("t,x,y,z,qx,qy,qz,qw\n" + "\n".join(rows) + "\n")
    words = envelope(inputs, f"o.{suffix}", "--resolution", 120, "--report", inputs / "r.json")
    done = call(*words)
    assert done.returncode == 0, done.stderr
    report = json.loads((inputs / "r.json").read_text())
    checked = json.loads(call("check", inputs / f"o.{suffix}", "--report", "-").stdout)
    keys = set(report) & set(checked) - {
        "report_version",
        "command",
        "input",
        "seconds",
        "warnings",
    }
    keys -= {"vertices"} if suffix == "stl" and report["unused_vertices"] else set()
    assert {"triangles", "closed", "self_intersections", "volume", "degenerate_triangles"} <= keys
    assert {k: report[k] for k in keys} == pytest.approx({k: checked[k] for k in keys}, rel=1e-12)
    codes = {w["code"] for w in report["warnings"]}
    assert ("SinglePrecision" in codes) == ("SinglePrecision" in done.stderr)
    if report["self_intersections"] > 0:
        assert call(*words, "--strict").returncode == 1


@SOLIDS
def test_check_takes_several_files_and_solids(call, inputs, box):  # noqa: F811
    _swept.write_mesh(inputs / "open.stl", box[0], box[1][1:])
    done = call("solid", inputs / "box.ply", "-o", inputs / "box.step", "-q")
    assert done.returncode == 0 and done.stdout == ""
    files = [inputs / name for name in ("box.ply", "open.stl", "box.step")]
    done = call("check", *files, "--report", inputs / "r.json")
    assert done.returncode == 1 and "open edges" in done.stderr
    assert done.stdout.count("\n") == 3 and "1 solids" in done.stdout
    report = json.loads((inputs / "r.json").read_text())
    assert report["code"] == "CheckFailed"
    assert [file["status"] for file in report["files"]] == ["Ok", "InvalidInput", "Ok"]
    assert [file["input"] for file in report["files"]] == [str(f) for f in files]
    solid = report["files"][2]["solid"]
    assert solid["valid"] and solid["closed"] and solid["volume"] == pytest.approx(6000)
    assert call("check", files[0], files[2]).returncode == 0


def test_short_options(call, inputs):  # noqa: F811
    words = ("envelope", inputs / "box.ply", "--motion", inputs / "slide.csv", "--resolution", 16)
    done = call(*words, "-o", inputs / "o.ply", "-qv")
    assert done.returncode == 0 and done.stdout == "" and "total" in done.stderr


@pytest.mark.parametrize("shell", ["bash", "zsh", "fish"])
def test_completions_name_every_option_of_the_help(call, shell, tmp_path):  # noqa: F811
    text = call("completion", shell).stdout
    (tmp_path / "completion").write_text(text)
    for command in COMMANDS:
        for word in call(command, "--help").stdout.split():
            name = word.split(",")[-1]
            if name.startswith("--") and name[2:].replace("-", "").isalpha():
                option = f"-l {name[2:]} " if shell == "fish" else name
                assert option in text, (command, name)
    if shutil.which(shell):
        subprocess.run([shell, "-n", str(tmp_path / "completion")], check=True)
    if shell == "bash":
        complete = (
            f"source {tmp_path}/completion; COMP_WORDS=(swept envelope --backend g); "
            "COMP_CWORD=3; _swept; echo ${COMPREPLY[@]}; "
            "COMP_WORDS=(swept envelope --no-c); COMP_CWORD=2; _swept; echo ${COMPREPLY[@]}"
        )
        done = subprocess.run(["bash", "-c", complete], capture_output=True, text=True)
        assert done.stdout == "gpu\n--no-cull --no-clobber\n", done.stdout + done.stderr
    assert call("completion", "csh").returncode == 2


def test_manual_page_names_every_option(call):  # noqa: F811
    page = call("manual").stdout
    assert page.startswith(".TH SWEPT 1")
    plain = page.replace("\\-", "-").replace("\\fB", "").replace("\\fR", "")
    for command in COMMANDS:
        assert f"SWEPT {command}" in plain
        for word in call(command, "--help").stdout.split():
            if word.startswith("--") and word[2:].replace("-", "").isalpha():
                assert word in plain, word
