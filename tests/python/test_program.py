# SPDX-License-Identifier: LGPL-2.1-or-later
"""The program `swept`: results, reports, exit codes, refused input, cancelling, output to a terminal."""
import json
import os
import pty
import re
import resource
import signal
import stat
import subprocess
import time

import numpy as np
import pytest

import _swept


@pytest.fixture
def inputs(tmp_path, box):
    """Makes a folder with box.ply and slide.csv (50 mm along x)."""
    _swept.write_mesh(tmp_path / "box.ply", *box)
    (tmp_path / "slide.csv").write_text(
        "# mm\nt,tx,ty,tz,qx,qy,qz,qw\n0,0,0,0,0,0,0,1\n1,50,0,0,0,0,0,1\n"
    )
    return tmp_path


@pytest.fixture
def call(program):
    """Returns a function that runs the program with pipes and returns the finished process."""

    def run(*words, **keywords):
        keywords.setdefault("timeout", 120)
        return subprocess.run(
            [program, *map(str, words)], capture_output=True, text=True, **keywords
        )

    return run


def envelope(inputs, output, *more):
    return (
        "envelope", inputs / "box.ply", "--motion", inputs / "slide.csv",
        "--output", inputs / output, *more,
    )  # fmt: skip


COMMANDS = "envelope check clearance mechanism overlap path sequence study".split()
COMMANDS += ["solid"] * _swept.HAS_SOLIDS


def test_help_and_version(call):
    listed = re.split("subcommands:\n", call("--help").stdout, flags=re.I)[1].split("\n\n")[0]
    named = [line.split()[0] for line in listed.splitlines() if line[2] != " "]
    assert sorted(named) == sorted([*COMMANDS, "manual", "completion"]), "a command is not tested"
    commands = COMMANDS
    for words in (["--help"], ["-h"], ["help"]):
        done = call(*words)
        assert done.returncode == 0 and done.stderr == "", done.stderr
        assert all(f"  {command} " in done.stdout for command in commands)
    for command in commands:
        done = call(command, "--help")
        assert done.returncode == 0 and done.stderr == "", done.stderr
        assert "--report" in done.stdout and "Examples:\n  swept " + command in done.stdout
        assert call("help", command).stdout == done.stdout
        assert "see swept" not in done.stdout, "the help is here"
    text = call("envelope", "--help").stdout
    for option in (
        "--motion --motion-unit --body-unit --interpolation --resolution --cell --threads "
        "--memory-limit --backend --components --output --tolerance --keep-cavities --offset "
        "--conservative --no-cull --chord-tolerance --position-filter"
    ).split():
        assert option + " " in text or option + "\n" in text, option
    assert call("-V").stdout == f"swept {_swept.__version__}\n"
    assert call("--version").stdout == f"swept {_swept.__version__}\n"
    assert call().returncode == 2


@pytest.mark.parametrize("suffix", ["ply", "stl", "obj", "off"])
def test_envelope_and_check(call, inputs, suffix):
    output = inputs / f"out.{suffix}"
    done = call(*envelope(inputs, output.name, "--resolution", 40, "--report", inputs / "r.json"))
    assert done.returncode == 0, done.stderr
    assert "\r" not in done.stdout + done.stderr, "progress bar in a pipe"
    report = json.loads((inputs / "r.json").read_text())
    assert report["status"] == "Ok" and report["output"] == str(output)
    area = 2 * (60 * 20 + 60 * 30 + 20 * 30)
    assert report["volume"] == pytest.approx(36000, abs=0.05 * area * report["cell"])
    assert set(report["seconds"]) >= {"read", "write", "total", "sampling", "contour", "check"}
    stages = sum(s for name, s in report["seconds"].items() if name != "total")
    assert stages <= report["seconds"]["total"] * 1.01
    found = call("check", output, "--report", "-")
    assert found.returncode == 0, found.stderr
    assert json.loads(found.stdout)["triangles"] == report["triangles"]
    assert not [name for name in os.listdir(inputs) if name.startswith(".")], "left-overs"


@pytest.mark.skipif(not _swept.HAS_SOLIDS, reason="built without OpenCASCADE")
@pytest.mark.parametrize("suffix", ["step", "brep"])
def test_envelope_as_solid(call, inputs, suffix):
    done = call(*envelope(inputs, f"o.{suffix}", "--resolution", 24, "--report", inputs / "r.json"))
    assert done.returncode == 0, done.stderr
    report = json.loads((inputs / "r.json").read_text())
    assert report["solid"]["valid"] and report["solid"]["solids"] == 1
    assert report["solid"]["volume"] == pytest.approx(report["volume"], rel=1e-6)
    assert (inputs / f"o.{suffix}").stat().st_size == report["solid"]["file_bytes"]


def test_units_and_interpolation_reach_the_core(call, inputs):
    def bounds(*more):
        done = call(*envelope(inputs, "o.ply", "--cell", 2, *more))
        assert done.returncode == 0, done.stderr
        return np.ptp(_swept.read_mesh(inputs / "o.ply").vertices, axis=0)

    assert bounds() == pytest.approx([60, 20, 30], abs=0.5)
    assert bounds("--motion-unit", "cm") == pytest.approx([510, 20, 30], abs=0.5)
    assert bounds("--body-unit", "cm") == pytest.approx([150, 200, 300], abs=0.5)
    assert bounds("--interpolation", "none") == pytest.approx([60, 20, 30], abs=0.5)
    assert _swept.check_mesh(
        *(lambda m: (m.vertices, m.triangles))(_swept.read_mesh(inputs / "o.ply"))
    )["shells"] == 2, "two posed copies are two shells"  # fmt: skip


def test_earlier_names_of_options_work_but_are_not_shown(call, inputs):
    done = call(*envelope(inputs, "o.ply", "--cell", 2, "--generator-unit", "cm"))
    assert done.returncode == 0, done.stderr
    size = np.ptp(_swept.read_mesh(inputs / "o.ply").vertices, axis=0)
    assert size == pytest.approx([150, 200, 300], abs=0.5)
    both = ["--generator-unit", "cm", "--body-unit", "cm"]
    assert call(*envelope(inputs, "o.ply", "--cell", 2, *both)).returncode == 2
    done = call(*envelope(inputs, "o.ply", "--cell", 2, "--generator-unit", "mile"))
    assert done.returncode == 2 and "--body-unit" in done.stderr, done.stderr
    for words in (["manual"], *(["completion", shell] for shell in ("bash", "zsh", "fish"))):
        assert "generator" not in call(*words).stdout.lower(), words
    for command in COMMANDS:
        assert "generator" not in call(command, "--help").stdout.lower(), command
    assert "--chord" not in call("overlap", "--help").stdout.replace("--part-chord", "")


def test_same_bytes_for_any_number_of_threads(call, inputs):
    files = []
    for threads in (1, 2, 3):
        name = f"t{threads}.ply"
        assert call(*envelope(inputs, name, "--threads", threads)).returncode == 0
        files.append((inputs / name).read_bytes())
    assert files[0] == files[1] == files[2]


@pytest.mark.parametrize(
    "words, says",
    [
        (["--resolution", "many"], "--resolution is 'many'"),
        (["--resolution", "3"], "from 4 to 16384"),
        (["--cell", "0"], "--cell must be greater than 0"),
        (["--cell", "nan"], "--cell is 'nan'"),
        (["--cell", "1", "--resolution", "5"], "--resolution excludes --cell"),
        (["--threads", "-1"], "--threads is '-1'"),
        (["--backend", "tpu"], "auto, cpu, gpu"),
        (["--components", "best"], "consistent"),
        (["--interpolation", "cubic"], "none, linear, screw"),
        (["--motion-unit", "mile"], "mm, cm, m, in"),
        (["--frobnicate"], "unknown option '--frobnicate'"),
        (["--frobnicate", "3"], "unknown option '--frobnicate'"),
        (["--format", "stl"], "leave out --format, or change the extension"),
        (["--offset", "1", "--offset", "2"], "--offset is given twice"),
        (["--solid-tolerance", "1", "--conservative"], "leave out one of them"),
        (["--tolerance"], "needs a value"),
        (["second.ply"], "too many files: 'second.ply'"),
        (["second.ply", "third.ply"], "too many files: 'second.ply'"),
    ],
)
def test_wrong_usage_is_status_2_and_one_line(call, inputs, words, says):
    done = call(*envelope(inputs, "o.ply", *words))
    assert done.returncode == 2
    assert says in done.stderr and done.stderr.count("\n") == 1 and done.stdout == ""
    assert not (inputs / "o.ply").exists()


def test_missing_words(call, inputs):
    for words in (
        ["envelope"],
        ["envelope", inputs / "box.ply", "--output", inputs / "o.ply"],
        ["envelope", inputs / "box.ply", "--motion", inputs / "slide.csv"],
        ["check"],
        ["melt"],
    ):
        assert call(*words).returncode == 2


def test_failures_are_status_1_with_a_report(call, inputs):
    (inputs / "bad.csv").write_text("t,tx,ty,tz,qx,qy,qz,qw\n0,1,two,3,0,0,0,1\n")
    report = inputs / "r.json"
    for words, status, code, says in (
        (["absent.ply", "slide.csv"], "InvalidInput", "BadFile", "absent.ply"),
        (["box.ply", "absent.csv"], "InvalidInput", "BadFile", "absent.csv"),
        (["box.ply", "bad.csv"], "InvalidInput", "BadFile", "line 2, column 3"),
    ):
        done = call(
            "envelope", inputs / words[0], "--motion", inputs / words[1],
            "--output", inputs / "o.ply", "--report", report,
        )  # fmt: skip
        assert done.returncode == 1 and done.stderr.count("\n") == 1 and says in done.stderr
        found = json.loads(report.read_text())
        assert (found["status"], found["code"]) == (status, code) and says in found["message"]
        assert "output" not in found and "volume" not in found and "cell" not in found
        assert not (inputs / "o.ply").exists()


def test_limit_of_memory(call, inputs):
    done = call(*envelope(inputs, "o.ply", "--resolution", 3000, "--memory-limit", 1))
    assert done.returncode == 1 and done.stderr.startswith("swept: ResourceLimit")


def test_bad_input_38_targets_are_refused_before_computing(call, inputs):
    (inputs / "folder.ply").mkdir()
    locked = inputs / "locked.ply"
    locked.write_text("old")
    locked.chmod(stat.S_IREAD)
    for name, code in (
        ("no/such/o.ply", "MissingFolder"),
        ("folder.ply", "BadTarget"),
        ("locked.ply", "ReadOnly"),
        ("o.xyz", "BadFormat"),
        ("o", "BadFormat"),
    ):
        # The input file does not even exist: the program checks the output first.
        done = call(
            "envelope", inputs / "absent.ply", "--motion", inputs / "slide.csv",
            "--output", inputs / name, "--report", inputs / "r.json",
        )  # fmt: skip
        assert done.returncode == 1 and f"ExportFailed/{code}" in done.stderr, done.stderr
        assert json.loads((inputs / "r.json").read_text())["code"] == code
    assert locked.read_text() == "old"
    done = call(*envelope(inputs, "o.ply", "--report", inputs / "no" / "r.json"))
    assert done.returncode == 1 and "MissingFolder" in done.stderr
    assert not (inputs / "o.ply").exists()


def test_bad_input_36_full_disk_leaves_the_old_file(call, inputs):
    (inputs / "o.ply").write_text("old")
    # The child process may write no file longer than 20 kB. Python ignores the signal that would end
    # it, and so does the child. So a write fails as on a full disk.
    done = call(
        *envelope(inputs, "o.ply"),
        preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (20000, 20000)),
        restore_signals=False,
    )
    assert done.returncode == 1 and "ExportFailed/WriteFailed" in done.stderr, done.stderr
    assert (inputs / "o.ply").read_text() == "old"
    assert not [name for name in os.listdir(inputs) if name.startswith(".")], "left-overs"


def test_check_fails_on_a_hole(call, inputs, box):
    _swept.write_mesh(inputs / "open.ply", box[0], box[1][1:])
    done = call("check", inputs / "open.ply", "--report", inputs / "r.json")
    assert done.returncode == 1 and "3 open edges" in done.stderr
    report = json.loads((inputs / "r.json").read_text())
    assert report["code"] == "CheckFailed" and report["open_edges"] == 3


def long_run(program, shared, inputs):
    return [
        program, "envelope", str(shared / "meshes" / "bunny_stanford_70k.ply"),
        "--body-unit", "m", "--motion-unit", "m", "--resolution", "900", "--report",
        str(inputs / "r.json"), "--output", str(inputs / "o.ply"), "--motion",
        str(shared / "motions" / "keyposes_16_arc_for_bunny.csv"),
    ]  # fmt: skip


def wait_until_caught(child, number):
    """Waits until the program has a handler for the signal; loading it may take long on a busy machine."""
    for _ in range(1200):
        with open("/proc/{}/status".format(child.pid)) as status:
            caught = next(line.split()[1] for line in status if line.startswith("SigCgt:"))
        if int(caught, 16) >> (number - 1) & 1:
            return
        time.sleep(0.05)
    raise AssertionError("the program does not handle signal {}".format(number))


def test_bad_input_24_and_25_interrupts_cancel_cleanly(program, shared, inputs):
    child = subprocess.Popen(long_run(program, shared, inputs), stderr=subprocess.PIPE, text=True)
    wait_until_caught(child, signal.SIGINT)
    time.sleep(0.3)
    start = time.monotonic()
    child.send_signal(signal.SIGINT)
    time.sleep(0.02)
    child.send_signal(signal.SIGINT)  # a second signal changes nothing
    _, errors = child.communicate(timeout=60)
    assert child.returncode == 130, errors
    assert time.monotonic() - start < 10
    assert errors.startswith("swept: Cancelled")
    assert json.loads((inputs / "r.json").read_text())["status"] == "Cancelled"
    assert not (inputs / "o.ply").exists()
    assert not [name for name in os.listdir(inputs) if name.startswith(".")], "left-overs"


def test_progress_bar_on_a_terminal(program, shared, inputs):
    controller, terminal = pty.openpty()
    child = subprocess.Popen(
        long_run(program, shared, inputs), stderr=terminal, stdout=subprocess.DEVNULL
    )
    os.close(terminal)
    seen = b""
    while b" % " not in seen and len(seen) < 100000:
        try:
            seen += os.read(controller, 4096)
        except OSError:
            break
    child.send_signal(signal.SIGINT)
    child.wait(timeout=60)
    os.close(controller)
    assert b"\r[" in seen and b" %" in seen
