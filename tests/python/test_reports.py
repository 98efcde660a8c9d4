# SPDX-License-Identifier: LGPL-2.1-or-later
"""Every report of every command matches docs/report.schema.json. Keys that must be the same in every run
are the same.
"""
import json

import jsonschema
import pytest

import _swept
from test_program import call, envelope, inputs  # noqa: F401

#: Keys that depend on the machine and the time.
MACHINE = {
    "seconds", "backend", "device", "threads", "estimated_memory_bytes", "peak_memory_bytes",
}  # fmt: skip


@pytest.fixture(scope="module")
def validator(root):
    schema = json.loads((root / "docs" / "report.schema.json").read_text(encoding="utf-8"))
    jsonschema.Draft202012Validator.check_schema(schema)
    return jsonschema.Draft202012Validator(schema)


@pytest.fixture
def report_of(call, validator):  # noqa: F811
    """Returns a function that runs the program with --report - and returns the report, which must
    match the schema."""

    def run(*words, status=0):
        done = call(*words, "--report", "-")
        assert done.returncode == status, done.stderr
        report = json.loads(done.stdout)
        validator.validate(report)
        return report

    return run


def reproducible(report):
    if isinstance(report, dict):
        return {k: reproducible(v) for k, v in report.items() if k not in MACHINE}
    return [reproducible(v) for v in report] if isinstance(report, list) else report


def test_reports_of_envelopes(report_of, inputs):  # noqa: F811
    words = envelope(inputs, "o.ply", "--resolution", 24)
    report = report_of(*words)
    assert report["command"] == "envelope" and report["motion"] == str(inputs / "slide.csv")
    assert "conservative_bound" not in report and "position_filter_distance" not in report
    again = report_of(*words, "--threads", 1)
    assert reproducible(again) == reproducible(report)
    assert report_of(*words, "--conservative")["conservative_bound"] > 0
    assert report_of(*words, "--tolerance", 1)["simplification_deviation"] > 0


def test_reports_of_failures(report_of, inputs):  # noqa: F811
    words = envelope(inputs, "o.ply")
    report = report_of(*words, "--memory-limit", 1, "--resolution", 3000, status=1)
    assert report["status"] == "ResourceLimit" and "output" not in report
    assert "closed" not in report and "volume" not in report
    (inputs / "slide.csv").unlink()
    assert report_of(*words, status=1)["code"] == "BadFile"


def test_reports_of_checks(report_of, inputs, box):  # noqa: F811
    _swept.write_mesh(inputs / "open.ply", box[0], box[1][1:])
    report = report_of("check", inputs / "box.ply")
    assert report["volume"] == pytest.approx(6000) and "cell" not in report and "grid" not in report
    assert report["input"] == str(inputs / "box.ply")
    assert report_of("check", inputs / "open.ply", status=1)["open_edges"] == 3
    many = report_of("check", inputs / "box.ply", inputs / "open.ply", "absent.ply", status=1)
    assert [file["status"] for file in many["files"]] == ["Ok", "InvalidInput", "InvalidInput"]
    assert many["code"] == "CheckFailed"


@pytest.mark.skipif(not _swept.HAS_SOLIDS, reason="built without OpenCASCADE")
def test_reports_of_solids(report_of, inputs):  # noqa: F811
    report = report_of("solid", inputs / "box.ply", "-o", inputs / "o.step")
    assert report["solid"]["closed"] and report["solid"]["volume"] == pytest.approx(6000)
    assert "closed" not in report and "volume" not in report, "of a mesh that was not checked"
    assert report_of(*envelope(inputs, "o.brep", "--resolution", 16))["solid"]["valid"]
    assert report_of("check", inputs / "o.step")["solid"]["faces"] == 6
    report_of("solid", inputs / "slide.csv", "-o", inputs / "o.step", status=1)


@pytest.mark.skipif(not _swept.HAS_SOLIDS, reason="built without OpenCASCADE")
def test_reports_of_estimates_of_solids(report_of, inputs):  # noqa: F811
    """Estimates print what a run would make, and write nothing."""
    report_of(*envelope(inputs, "swept.ply", "--resolution", 32))
    for words in (("--solid-tolerance", 0.05), ("--facets",), ("--output-format", "brep")):
        files = sorted(inputs.iterdir())
        report = report_of("solid", inputs / "swept.ply", "--estimate", *words)
        assert [f for f in sorted(inputs.iterdir()) if f not in files] in (
            [],
            [inputs / "report.json"],
        )
        suffix = "brep" if "brep" in words else "step"
        made = report_of("solid", inputs / "swept.ply", "-o", inputs / ("made." + suffix), *words)
        estimate = report["estimate"]
        assert estimate["faces"] == made["solid"]["faces"] and estimate["tried"]
        assert abs(1e6 * estimate["megabytes"] - made["solid"]["file_bytes"]) < 100
        assert estimate["deviation"] == made["solid"]["deviation"]
        assert estimate["seconds"] >= estimate["trial_seconds"] > 0
        assert "solid" not in report and "output" not in report
        (inputs / ("made." + suffix)).unlink()
    report = report_of("solid", inputs / "slide.csv", "--estimate", status=1)
    assert "estimate" not in report
    report = report_of(
        "solid", inputs / "swept.ply", "--estimate", "--max-faces", 4, "--exact", status=1
    )
    assert report["code"] == "TooManyFaces"


def test_reports_of_clearances(report_of, inputs, box):  # noqa: F811
    _swept.write_mesh(inputs / "near.ply", box[0] + [15, 0, 0], box[1])
    _swept.write_mesh(inputs / "far.ply", box[0] + [150, 0, 0], box[1])
    words = ("clearance", inputs / "box.ply", "--motion", inputs / "slide.csv")
    report = report_of(*words, inputs / "near.ply", inputs / "far.ply", "--required", 2, status=3)
    assert [row["verdict"] for row in report["neighbours"]] == ["clash", "clear"]
    assert report["smallest"] == 0 and "penetration" in report["neighbours"][0]
    assert "smallest" not in report_of(*words, "absent.ply", status=1)
    report = report_of(
        *words,
        inputs / "near.ply",
        inputs / "far.ply",
        "--rule",
        "near=ignore",
        "--rule",
        "far=99",
        status=3,
    )
    assert [(row["name"], row["rule"]) for row in report["neighbours"]] == [
        ("far", {"required": 99})
    ]
    assert report["ignored"] == ["near"]


def test_reports_of_mechanisms(report_of, inputs, box):  # noqa: F811
    _swept.write_mesh(inputs / "near.ply", box[0] + [15, 0, 0], box[1])
    _swept.write_mesh(inputs / "far.ply", box[0] + [150, 0, 0], box[1])
    words = ("mechanism", "--moving", inputs / "box.ply", inputs / "slide.csv", "--required", 2)
    report = report_of(*words, inputs / "near.ply", inputs / "far.ply", "--curve", 5, status=3)
    (pair,) = report["pairs"]
    assert (pair["first"], pair["second"], pair["required"]) == ("box", "near", 2)
    assert pair["clearance"]["verdict"] == "clash" and len(pair["clearance"]["curve"]) == 6
    assert report["parts"] == ["box", "near", "far"] and report["far_pairs"] == 1
    assert report["smallest"] == 0 and "penetration" in pair["clearance"]
    again = report_of(*words, inputs / "near.ply", inputs / "far.ply", "--curve", 5, status=3)
    assert reproducible(again) == reproducible(report)
    less = report_of(*words, inputs / "near.ply", "--ignore", "near", "box")
    assert less["ignored"] == [["box", "near"]] and not less["pairs"]
    assert "smallest" not in report_of(*words, "absent.ply", status=1)


def test_reports_of_paths(report_of, inputs, box):  # noqa: F811
    _swept.write_mesh(inputs / "wall.ply", box[0] * [0.2, 5, 5] + [15, 0, 0], box[1])
    words = ("path", inputs / "box.ply", inputs / "wall.ply", "--start", "60,0,0")
    report = report_of(*words, "--clearance", 2)
    assert report["verdict"] == "found" and report["keys"] == len(report["path"]) > 2
    assert report["clearance"] >= 2 and report["certificate"][0]["verdict"] == "clear"
    assert "verdict" not in report_of(*words, "--clearance", 20, status=1)
    report = report_of(*words, inputs / "box.ply", "--clearance", 2, "--rule", "box=ignore")
    assert report["verdict"] == "found" and report["ignored"] == ["box"]


def test_the_schema_refuses_what_is_no_report(call, inputs, validator):  # noqa: F811
    done = call("check", inputs / "box.ply", "--report", "-")
    report = json.loads(done.stdout)
    for change in ({"file": "x"}, {"grid": [0, 0, 0]}, {"status": "Good"}, {"report_version": 2},
                   {"code": "Why"}, {"volume": "6000"}):  # fmt: skip
        with pytest.raises(jsonschema.ValidationError):
            validator.validate({**report, **change})


def test_reports_of_the_module_keep_the_schema(box, slide, validator):
    validator.validate(_swept.compute(*box, slide, resolution=16).report)
    with pytest.raises(_swept.Error) as caught:
        _swept.compute(*box, slide, resolution=100000)
    validator.validate(caught.value.report)
