# SPDX-License-Identifier: LGPL-2.1-or-later
"""The handbook's tutorial "Is the whole assembly clear?", step by step."""
import os
import sys
import tempfile

HERE = os.path.dirname(os.path.realpath(__file__))
sys.path[:0] = [HERE, os.path.join(HERE, "..", "..", "..", "docs", "handbook")]
import assembly_pictures  # noqa: E402
from driver import App, open_workbench, run, say, shot  # noqa: E402


def look(name):
    yield 0.5
    shot("6_" + name)
    yield 0.7


def verdicts(report):
    """Returns {name of the neighbour or pair: verdict} for the rows that do not meet their rule."""
    rows = [row.get("clearance", row) for row in report.get("pairs") or report["neighbours"]]
    return {row["name"]: row["verdict"] for row in rows if not row["meets_rule"]}


def scenario():
    from sweptvolume.features import clearance, mechanism, study

    open_workbench()
    yield
    folder = tempfile.mkdtemp()
    yield from assembly_pictures.work(look, folder)
    doc = App.ActiveDocument
    # The results that the page names.
    alone = verdicts(clearance.report_of(doc.Clearance))
    assert alone == {"Flywheel": "below", "Exhaust pipe": "below"}, alone
    together = mechanism.report_of(doc.Mechanism)
    bad = verdicts(together)
    assert bad == {
        "Starter motor - Exhaust pipe": "clash",
        "Starter motor - Flywheel": "below",
    }, bad
    deep = together["pairs"][together["smallest"]]["clearance"]
    expected = "{:.1f} mm deep at {:.1f} s".format(
        deep["penetration"]["depth"], deep["time_seconds"]
    )
    page = os.path.join(assembly_pictures.HERE, "tutorial_assembly.md")
    with open(page, encoding="utf-8") as file:
        text = file.read()
    assert expected in text, expected
    assert doc.Mechanism.Status == study.UP_TO_DATE, doc.Mechanism.Message
    rows = {row["run"]: row["state"] for row in study.report_of(doc.Study)["runs"]}
    assert rows == {"Clearance": "not clear", "Clearance001": "done", "Envelope": "done"}, rows
    assert study.report_of(doc.Study)["worst"] == "Clearance"
    for name, words in (
        ("assembly.html", "Starter motor - Exhaust pipe"),
        ("study.html", "2 of 3 runs are done and meet their rules."),
    ):
        with open(os.path.join(folder, name), encoding="utf-8") as file:
            assert words in file.read(), name
    say(expected)


run(scenario)
