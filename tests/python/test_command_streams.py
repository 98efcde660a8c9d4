# SPDX-License-Identifier: LGPL-2.1-or-later
"""Every command: standard output and pipes get the same bytes as files, and a signal ends the command."""
import json
import os
import shlex
import signal
import subprocess
import time

import numpy as np
import pytest

import _swept
from bodies import ball, box, joined
from commands import EACH, RUNS, contents, folder, run  # noqa: F401
from test_program import wait_until_caught
from test_reports import reproducible, validator  # noqa: F401


@EACH
def test_standard_output_has_the_bytes_of_the_file(run, folder, name):  # noqa: F811
    for output in RUNS[name].streams:
        option, file = output.split()
        environment = {**os.environ, "SOURCE_DATE_EPOCH": "1700000000"}  # date of pages
        assert run(name, output, "-q", env=environment).returncode == RUNS[name].status
        done = run(name, option, "-", env=environment, text=False)
        assert done.returncode == RUNS[name].status and not (folder / "-").exists()
        assert done.stdout == (folder / file).read_bytes()


@EACH
def test_inputs_come_from_pipes(run, folder, program, name):  # noqa: F811
    """Replaces each input by a pipe with the same name in another folder. The report must not
    change."""
    command = RUNS[name]
    expected = json.loads(run(name, command.needed, "--report -").stdout)
    for input in command.inputs:
        if name == "study":  # several processes read its files, more than once
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
def test_a_signal_ends_the_wait_for_a_pipe(folder, program, name):  # noqa: F811
    """No process writes into the pipe: a signal must end the program."""
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


def long_words(folder, name):  # noqa: F811
    """Returns the arguments of a run that takes minutes."""
    write = _swept.write_mesh
    if name in ("path", "sequence"):  # a bent part in a closed box: there is no path
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
    rows = np.zeros((200000 if name == "mechanism" else 20000, 8))
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
    _, errors = child.communicate(timeout=240)
    assert child.returncode == 143 and errors.startswith("swept: Cancelled"), errors
    report = json.loads((folder / "made.json").read_text())
    validator.validate(report)
    assert report["status"] == "Cancelled"
    assert set(contents(folder)) - before == {"made.json"}
