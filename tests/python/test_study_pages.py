# SPDX-License-Identifier: LGPL-2.1-or-later
"""One page for all runs of a study; folders in use by another study; rows that are written as runs end."""
import csv
import json
import os
import pathlib
import signal
import subprocess
import sys
import threading

import pytest

import swept_volume as sv
from page_check import cells, check_alone, data, parsed, plain
from swept_volume import _study, _study_run
from test_program import inputs  # noqa: F401
from test_studies import HEAD, LONG, run, study, wait_for, write_motion  # noqa: F401

LIGHT = HEAD.replace(
    HEAD[HEAD.index("compute") : HEAD.index("envelope =")], 'compute = ["clearance"]\n'
)
RUNS = """
[[run]]
name = "{motion}"
motion = ["by30.csv", "by40.csv"]
rules = { rail = "ignore" }
[[run]]
name = "with b rail"
motion = "by50.csv"
clearance = { page = true }
[[run]]
name = "broken"
motion = "bad.csv"
"""


@pytest.fixture
def light(study):  # noqa: F811
    """Makes a study of four clearance runs: two that are done, one with a clash and a page, and one
    that fails."""
    (study / "bad.csv").write_text("0,0,0,0,0,0,0,1\n1,nan,0,0,0,0,0,1\n")
    (study / "study.toml").write_text(LIGHT + RUNS)
    return study


def links(text):
    return [e.get("href") for e in parsed(text).iter() if e.get("href")]


def test_a_page_tells_of_all_runs_the_worst_first(run, light):  # noqa: F811
    assert run("--page", "-q").returncode == 1
    text = (light / "results/study.html").read_text(encoding="utf-8")
    check_alone(text.replace('href="with%20b%20rail/clearance.html"', 'href="#"'))
    rows = cells(text, "runs")
    assert [row[0] for row in rows] == ["Run", "broken", "with b rail", "by30", "by40"]
    assert [row[1] for row in rows[1:]] == ["failed", "not clear", "done", "done"]
    worst = dict(zip(rows[0], rows[2]))
    report = json.loads((light / "results/with b rail/report.json").read_text())["clearance"]
    rail = next(row for row in report["neighbours"] if row["name"] == "rail")
    depth = f"{rail['penetration']['depth']:.4g} mm"
    assert (worst["Verdict"], worst["Worst neighbour"], worst["Depth"]) == ("clash", "rail", depth)
    assert "line 2, column 2, pose 2: 'nan' is not" in plain(text), "why the run failed"
    assert "2 of 4 runs are done and meet their rules." in plain(text)
    kept = data(text, "report")
    assert [row["run"] for row in kept["runs"]] == ["broken", "with b rail", "by30", "by40"]
    assert kept["runs"][1]["clearance"]["neighbours"][1]["curve"] == rail["curve"]
    page = "with%20b%20rail/clearance.html"
    assert links(text).count(page) == 2 and (light / "results/with b rail/clearance.html").exists()
    assert (
        text.count("<svg") == 3 and text.count('id="graph') == 0
    ), "a graph for each that was done"


def test_every_link_leads_to_a_place(run, light):  # noqa: F811
    run("--page", "-q")
    text = (light / "results/study.html").read_text(encoding="utf-8")
    places = [e.get("id") for e in parsed(text).iter() if e.get("id")]
    assert len(places) == len(set(places))
    inside = [link[1:] for link in links(text) if link.startswith("#")]
    assert len(inside) == 5 and set(inside) <= set(places)


def test_language_and_template_are_those_of_the_study(run, light):  # noqa: F811
    (light / "own.html").write_text("<p>ACME {{title}} {{language}}</p>{{table}}{{runs}}")
    text = (light / "study.toml").read_text()
    chosen = 'name = "boxes"\npage = true\nlanguage = "de"\ntemplate = "own.html"\n'
    (light / "study.toml").write_text(text.replace('name = "boxes"\n', chosen))
    assert run("-q").returncode == 1
    page = (light / "results/study.html").read_text(encoding="utf-8")
    assert page.startswith("<p>ACME boxes de</p>") and "fehlgeschlagen" in page
    single = (light / "results/with b rail/clearance.html").read_text(encoding="utf-8")
    assert single.startswith("<p>ACME with b rail de</p>")
    (light / "own.html").write_text("{{logo}}")
    assert "{{logo}} is not a placeholder" in run("-q").stderr
    (light / "own.html").write_text(" \n")
    assert "is empty" in run("-q").stderr


def test_the_page_repeats_itself_and_computes_nothing(light, monkeypatch):  # noqa: F811
    monkeypatch.setenv("SOURCE_DATE_EPOCH", "1700000000")
    sv.run_study(light / "study.toml", page=True, jobs=2)
    first = (light / "results/study.html").read_bytes()
    sv.run_study(light / "study.toml", page=True, again=True, jobs=1)
    assert (light / "results/study.html").read_bytes() == first
    assert b"2023-11-14 22:13 UTC" in first
    for left in (light / "results").glob("*/report.json"):
        os.utime(left, ns=(1, 1))
    text = sv.study_page(light / "study.toml", folder="results/")
    assert "results/with%20b%20rail/clearance.html" in links(text)
    assert cells(text, "runs")[1][:2] == ["with b rail", "not clear"]
    states = {row[0]: row[1] for row in cells(text, "runs")[1:]}
    assert states["broken"] == "not run", "what failed is not kept"
    write_motion(light / "by30.csv", 31)
    text = sv.study_page(light / "study.toml")
    assert {row[0]: row[1] for row in cells(text, "runs")[1:]}["by30"] == "not run"
    assert {p.stat().st_mtime_ns for p in (light / "results").glob("*/report.json")} == {1}
    monkeypatch.setenv("SOURCE_DATE_EPOCH", "now")
    with pytest.raises(sv.InvalidInput, match="SOURCE_DATE_EPOCH is 'now'"):
        sv.run_study(light / "study.toml", page=True)


def test_inputs_are_told_once_and_hashed_once(light, monkeypatch):  # noqa: F811
    hashed = []
    whole = _study_run.file_hash
    monkeypatch.setattr(_study, "file_hash", lambda path: hashed.append(path) or whole(path))
    sv.run_study(light / "study.toml", page=True, jobs=1)
    assert len(hashed) == len(set(hashed)) == 8, "study, box, two neighbours, four motions"
    text = (light / "results/study.html").read_text(encoding="utf-8")
    rows = cells(text, "inputs")[1:]
    assert [row[1] for row in rows[:3]] == ["study.toml", "box.ply", "by30.csv"] and len(rows) == 8
    single = cells((light / "results/with b rail/clearance.html").read_text(), "inputs")[1:]
    assert {tuple(row[1::2]) for row in single} <= {tuple(row[1::2]) for row in rows}


def test_what_may_touch_is_not_the_worst_neighbour(light):  # noqa: F811
    text = (light / "study.toml").read_text().replace('rail = "ignore"', 'rail = "contact:50"')
    (light / "study.toml").write_text(text)
    write_motion(light / "by40.csv", 38)  # the box now moves into the rail
    report = sv.run_study(light / "study.toml")
    rows = {row["run"]: row for row in report["runs"]}
    assert rows["by40"]["state"] == "done" and rows["by40"]["neighbour"] == "post"
    with open(light / "results/study.csv", newline="") as file:
        table = {row["run"]: row for row in csv.DictReader(file)}
    assert float(table["with b rail"]["depth_mm"]) == rows["with b rail"]["depth"] > 1


def test_a_folder_takes_one_study_at_a_time(program, run, study):  # noqa: F811
    (study / "study.toml").write_text(HEAD + LONG)
    command = [program, "study", str(study / "study.toml"), "--jobs", "1"]
    first = subprocess.Popen(command, stderr=subprocess.PIPE, text=True)
    try:
        wait_for(lambda: list((study / "results").glob(".partial-*")))
        second = run()
        assert second.returncode == 1, second.stderr
        assert "InvalidInput/FolderInUse: another study is writing to" in second.stderr
        assert list((study / "results").glob(".partial-*")), "what the first one fills stays"
    finally:
        first.kill()  # as a crash: nothing is tidied up
        first.communicate()
    (study / "study.toml").write_text(HEAD + LONG.replace("1500", "24"))
    assert run().returncode == 0, "a killed study leaves no lock behind"


def test_threads_of_one_process_are_refused_as_well(light):  # noqa: F811
    entered, leave = threading.Event(), threading.Event()

    def wait(*ignored):
        entered.set()
        leave.wait(60)

    first = threading.Thread(
        target=lambda: sv.run_study(light / "study.toml", jobs=1, progress=wait), daemon=True
    )
    first.start()
    assert entered.wait(60)
    try:
        with pytest.raises(sv.InvalidInput, match="another study is writing to") as error:
            sv.run_study(light / "study.toml")
        assert error.value.code == "FolderInUse"
    finally:
        leave.set()
        first.join()
    assert sv.run_study(light / "study.toml")["kept"] == 3


def test_rows_are_told_as_runs_end(run, light):  # noqa: F811
    done = run("--rows", "--report", light / "all.json")
    assert done.returncode == 1
    lines = [json.loads(line) for line in done.stdout.splitlines()]
    assert [line["done"] for line in lines] == [1, 2, 3, 4] and {
        line["runs"] for line in lines
    } == {4}
    rows = json.loads((light / "all.json").read_text())["runs"]
    assert {json.dumps(line["row"]) for line in lines} == {json.dumps(row) for row in rows}
    lines = [json.loads(line) for line in run("--rows").stdout.splitlines()]
    kept = [line["row"]["run"] for line in lines if "done" not in line]
    assert (
        kept == ["by30", "by40", "with b rail"] and lines[3]["done"] == 4
    ), "what is there comes first"
    assert run("--rows", "--report", "-").returncode == 2


def test_a_reader_of_rows_that_dies_stops_the_study(program, light):  # noqa: F811
    command = [program, "study", str(light / "study.toml"), "--rows", "--jobs", "1"]
    process = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE)
    process.stdout.close()
    _, errors = process.communicate(timeout=240)
    assert process.returncode not in (0, -signal.SIGKILL) and b"Traceback" not in errors, errors
    assert json.loads((light / "results/study.json").read_text())["not_run"] > 0


def test_bad_reports_of_studies_are_refused():
    good = {"report_version": 1, "command": "study", "name": "x", "done": 1, "not_clear": 0}
    good.update(failed=0, not_run=0, runs=[{"run": "a", "state": "done"}])
    assert "The run is done" in sv.report_page(good)
    for row, said in (
        ({"run": "a", "state": "lost"}, "the state 'lost' of a run is unknown"),
        ({"run": "a", "state": "done", "page": "http://x/y"}, "must be a path relative to"),
        ({"run": "a", "state": "done", "page": "//x/y"}, "must be a path relative to"),
        ({"run": "a", "state": "done", "distance": -1}, "distance is not a length"),
        ({"state": "done"}, "run"),
    ):
        with pytest.raises(sv.InvalidInput, match=said) as error:
            sv.report_page(dict(good, runs=[row]))
        assert error.value.code == "BadReport"


def test_hostile_names_of_runs_stay_text():
    attack = "</a><script>alert(1)</script>"
    report = {"report_version": 1, "command": "study", "name": attack, "done": 0, "not_clear": 0}
    report.update(failed=1, not_run=0, runs=[{"run": attack, "state": "failed", "message": attack}])
    text = sv.report_page(report)
    check_alone(text)
    assert text.count("<script") == 1 and attack in plain(text)


if __name__ == "__main__":
    sys.exit(pytest.main([str(pathlib.Path(__file__)), "-q"]))
