# SPDX-License-Identifier: LGPL-2.1-or-later
"""HTML pages of reports, from Python and from the program."""
import base64
import hashlib
import json
import re

import numpy as np
import pytest

import _swept
import swept_volume as sv
from bodies import box, torus
from page_check import cells, check_alone, data, parsed, plain, shown, steady
from test_program import call, inputs  # noqa: F401

HOSTILE = "</script><script>alert(1)</script> & \"q\" 'a' <b>Gehäuse\nJürgen\x01 {{title}}"
CUBE = sv.Mesh(*box((-5, -5, -5), (5, 5, 5)))
MOTION = sv.Motion([0.0, 2.0], np.tile([0.0, 0.0, 0.0, 1.0], (2, 1)), [[0, 0, 0], [40, 0, 0]])
NEIGHBOURS = [
    ("Wand", sv.Mesh(*box((47, -5, -5), (50, 5, 5)))),
    ("clash", sv.Mesh(*box((20, 3, -5), (25, 9, 5)))),
    ("rail", sv.Mesh(*box((-10, -7, -9), (60, 7, -5)))),
    (HOSTILE, sv.Mesh(*box((0, 30, 0), (9, 39, 9)))),
]


@pytest.fixture(scope="module")
def report():
    return sv.clearance(CUBE, MOTION, NEIGHBOURS, required=3, rules={"rail": "contact"})


@pytest.fixture(scope="module")
def page(report):
    parts = [("cube", CUBE, MOTION), *NEIGHBOURS]
    return sv.report_page(report, parts=parts, title=HOSTILE, date="2026-01-02")


def test_a_page_is_well_formed_and_needs_nothing_else(page):
    check_alone(page)
    assert "2026-01-02" in page and f"Swept Volume {sv.__version__}" in page
    assert HOSTILE.replace("\x01", "\ufffd") in plain(page), "as it was given, and as text alone"
    assert page.count("<script") == page.count("</script>") == (3 if _swept.page_has_view() else 1)


def test_the_checker_of_pages_sees_faults(page):
    for fault in (
        page.replace("<main>", '<main><img src="http://a.b/c.png" />'),
        page.replace("<main>", '<main><a href="//a.b">x</a>'),
        page.replace("<main>", '<main onclick="x()">'),
        page.replace("</style>", "@import 'a.css';</style>"),
    ):
        assert fault != page
        with pytest.raises(AssertionError):
            check_alone(fault)
    with pytest.raises(SyntaxError):
        parsed(page.replace("</main>", ""))


def test_what_a_page_tells_is_what_the_report_says(report, page):
    assert data(page, "report") == steady(report)
    rows = cells(page, "verdicts")
    assert [row[:2] for row in rows[1:]] == [
        ["clash", "clash"],
        ["Wand", "below required"],
        ["rail", "allowed contact"],
        [HOSTILE.replace("\x01", "\ufffd"), "clear"],
    ], "the worst first"
    wall, clash = report["neighbours"][:2]
    assert rows[2][2:5] == ["2 mm", "1.99 mm", "2 s"] and wall["distance"] == pytest.approx(
        2, abs=0.01
    )
    depth = clash["penetration"]
    assert rows[1][5] == f"{depth['depth']:.4g} to {depth['depth_bound']:.4g} mm"
    (below,) = wall["below"]
    assert float(rows[2][6].split()[0]) == pytest.approx(below[1] - below[0], rel=1e-3)
    assert "2 of 4 checked pairs do not meet their rules." in page
    rules = {name: (rule, met) for name, rule, met in cells(page, "rules")[1:]}
    assert rules["Wand"] == ("at least 3 mm", "no") and rules["rail"] == ("contact allowed", "yes")


def test_the_graph_shows_every_curve_and_the_required_distance(report, page):
    svg = next(e for e in parsed(page).iter() if e.tag.endswith("svg"))
    curves = {
        g[0].text.rpartition(": ")[0]: g[1].get("points")
        for g in svg.iter()
        if g.get("class") == "curve"
    }
    assert len(curves) == 4 and "Wand" in curves
    demand = [e for e in svg.iter() if e.get("class") == "demand" and e.tag.endswith("line")]
    assert len(demand) == 1
    required = float(demand[0].get("y1"))
    points = [tuple(map(float, p.split(","))) for p in curves["Wand"].split()]
    height = float(svg.get("height"))
    floor = max(
        y for p in curves.values() for _, y in (map(float, q.split(",")) for q in p.split())
    )
    assert 0.2 * height < floor - required, "3 mm can be seen beside 37 mm"
    curve = report["neighbours"][0]["curve"]
    assert len(points) == len(curve)
    for (_, y), (_, distance) in zip(points, curve):  # below the line: too near
        assert (y >= required - 0.1) == (distance <= 3 + 0.02)
    assert points == sorted(points) and "required: 3 mm" in page


@pytest.mark.skipif(not _swept.page_has_view(), reason="built without three.js")
def test_the_scene_holds_the_shapes_and_the_motion(report, page):
    scene = data(page, "scene")
    names = [part["name"] for part in scene["parts"]]
    assert names == ["cube"] + [name for name, _ in NEIGHBOURS]
    assert [p["verdict"] for p in scene["parts"]] == ["none", "below", "clash", "allowed", "clear"]
    for part, mesh in zip(scene["parts"], [CUBE] + [mesh for _, mesh in NEIGHBOURS]):
        points, triangles = shown(part)
        assert len(triangles) == len(mesh.triangles)
        step = part["step"]
        for corner in points:
            assert np.abs(mesh.vertices - corner).max(axis=1).min() <= 0.51 * step + 1e-5
        edges = points[triangles]
        volume = np.einsum("ij,ij->", edges[:, 0], np.cross(edges[:, 1], edges[:, 2])) / 6
        low, high = mesh.vertices.min(axis=0), mesh.vertices.max(axis=0)
        assert volume == pytest.approx(np.prod(high - low), rel=1e-3)
    times = np.array(scene["times"])
    poses = np.frombuffer(base64.b64decode(scene["parts"][0]["poses"]), "<f4").reshape(-1, 7)
    assert len(poses) == len(times) and (np.diff(times) >= 0).all()
    assert np.allclose(poses[:, 0], 20 * times, atol=1e-4)
    for row in scene["rows"]:
        neighbour = report["neighbours"][row["row"]]
        assert times[row["frame"]] == neighbour["time_seconds"]
        assert np.allclose(poses[row["frame"], :3], neighbour["pose"]["translation"], atol=1e-4)
        assert row["name"] == neighbour["name"]
    clash = next(row for row in scene["rows"] if row["name"] == "clash")
    deepest = report["neighbours"][1]["penetration"]
    assert clash["line"] == [deepest["point"], deepest["surface"]]


@pytest.mark.skipif(not _swept.page_has_view(), reason="built without three.js")
def test_large_shapes_are_thinned_for_the_view_and_that_is_said(report):
    ring = sv.Mesh(*torus(30, 8, 400, 200))
    page = sv.report_page(report, parts=[("ring", ring, MOTION), *NEIGHBOURS])
    points, triangles = shown(data(page, "scene")["parts"][0])
    assert 20000 < len(triangles) < 65000 < len(ring.triangles)
    assert "The shapes shown are simplified" in page and len(page) < 3.5e6
    distance = np.hypot(np.hypot(points[:, 0], points[:, 1]) - 30, points[:, 2]) - 8
    assert np.abs(distance).max() < 0.2
    assert points[:, 2].max() == pytest.approx(8, abs=0.1)


def test_german_pages(report):
    page = sv.report_page(report, parts=[("cube", CUBE, MOTION)], language="de")
    check_alone(page)
    assert '<html lang="de"' in page
    rows = cells(page, "verdicts")
    assert [row[1] for row in rows[1:]] == [
        "Kollision",
        "unter Sollabstand",
        "erlaubter Kontakt",
        "frei",
    ]
    assert (
        rows[2][3] == "1,99 mm" and "2 von 4 geprüften Paaren erfüllen ihre Regeln nicht." in page
    )
    english = sv.report_page(report, parts=[("cube", CUBE, MOTION)])
    for heading in re.findall(r"<h[12]>(.*?)</h[12]>", page):
        assert heading not in re.findall(r"<h[12]>(.*?)</h[12]>", english)
    with pytest.raises(sv.InvalidInput, match="allowed: en, de"):
        sv.report_page(report, language="fr")


def test_templates_of_a_company(report):
    layout = "<!DOCTYPE html>\n<html><body><b>ACME</b>{{ table }}{{inputs}}</body></html>"
    rows = [("body", "Kübel", "12 bytes", "ab" * 32), ("Werkzeug", "x", "", "")]
    page = sv.report_page(report, template=layout, inputs=rows)
    check_alone(page)
    assert page.startswith('<!DOCTYPE html>\n<html><body><b>ACME</b><section id="verdicts">')
    assert cells_of(page) == [
        ["moving part", "Kübel", "12 bytes", "ab" * 32],
        ["Werkzeug", "x", "", "not known"],
    ]
    with pytest.raises(
        sv.InvalidInput, match="line 2 .*{{logo}} is not a placeholder.*verdict"
    ) as e:
        sv.report_page(report, template="\n{{logo}}")
    assert e.value.code == "BadTemplate"
    assert sv.report_page(report, template=sv.page_template()) == sv.report_page(report)
    assert "<canvas" not in sv.page_template("print")


def cells_of(page):
    bare = page.replace("<html>", '<html xmlns="http://www.w3.org/1999/xhtml">')
    return cells(bare, "inputs")[1:]


def test_pictures_stand_in_the_page(report):
    bytes_ = b"\x89PNG\r\n\x1a\n" + bytes(range(256))
    page = sv.report_page(report, pictures=[("<the> place", "image/png", bytes_)])
    check_alone(page)
    found = re.search(r'src="data:image/png;base64,([^"]*)"', page)[1]
    assert base64.b64decode(found) == bytes_ and "&lt;the&gt; place" in page
    with pytest.raises(sv.InvalidInput, match="image/gif"):
        sv.report_page(report, pictures=[("a", "image/gif", b"")])


def test_wrong_arguments_are_named(report):
    with pytest.raises(TypeError, match=r"a part is \(name, mesh\)"):
        sv.report_page(report, parts=[("cube",)])
    with pytest.raises(sv.InvalidInput, match="this report cannot be turned into") as error:
        sv.report_page({"command": "clearance"})
    assert error.value.code == "BadReport"
    if _swept.page_has_view():
        corners = CUBE.vertices.copy()
        corners[3, 1] = np.nan
        cases = (
            ((corners, CUBE.triangles), MOTION, "NonFiniteVertex", "part 'cube'"),
            ((CUBE.vertices, CUBE.triangles + 1), MOTION, "BadIndex", "vertex 8"),
            (CUBE, ([0.0], [[0.0, 0, 0, 0]], [[0.0, 0, 0]]), "BadPose", "pose 1"),
        )
        for mesh, motion, code, text in cases:
            with pytest.raises(sv.InvalidInput, match=text) as error:
                sv.report_page(report, parts=[("cube", mesh, motion)])
            assert error.value.code == code
    damaged = json.loads(json.dumps(report))
    damaged["neighbours"][0]["distance"] = "near"
    with pytest.raises(sv.InvalidInput, match="distance is not a number"):
        sv.report_page(damaged)
    damaged["neighbours"][0] = 5
    with pytest.raises(sv.InvalidInput, match="this report cannot be turned into"):
        sv.report_page(damaged)


@pytest.fixture
def bench(inputs, box):  # noqa: F811
    """Returns the arguments of a check with two neighbours: one with a clash, and one far away."""
    _swept.write_mesh(inputs / "near.ply", box[0] + [15, 0, 0], box[1])
    _swept.write_mesh(inputs / "far ü.ply", box[0] + [150, 0, 0], box[1])
    words = ("clearance", inputs / "box.ply", "--motion", inputs / "slide.csv", "--required", 2)
    return *words, inputs / "near.ply", inputs / "far ü.ply"


def test_the_program_writes_a_page(call, inputs, bench, monkeypatch):  # noqa: F811
    monkeypatch.setenv("SOURCE_DATE_EPOCH", "1700000000")
    done = call(*bench, "--page", inputs / "p.html", "--report", inputs / "r.json")
    assert done.returncode == 3 and "clash" in done.stdout, done.stderr
    page = (inputs / "p.html").read_text(encoding="utf-8")
    check_alone(page)
    assert data(page, "report") == steady(json.loads((inputs / "r.json").read_text()))
    assert "2023-11-14 22:13 UTC" in page
    rows = [row[1:] for row in cells(page, "inputs")[1:]]
    for row, name in zip(rows, ("box.ply", "slide.csv", "near.ply", "far ü.ply")):
        content = (inputs / name).read_bytes()
        assert row == [name, f"{len(content)} bytes", hashlib.sha256(content).hexdigest()]
    again = call(*bench, "--page", "-", "--threads", 1)
    assert again.stdout == page, "the same bytes for any number of threads"
    german = call(*bench, "--page", "-", "--page-language", "de", "--page-title", "Prüfung <7>")
    assert "<h1>Prüfung &lt;7&gt;</h1>" in german.stdout and "Kollision" in german.stdout


def test_the_program_names_wrong_options_of_pages(call, inputs, bench):  # noqa: F811
    template = inputs / "t.html"
    template.write_text("<p>{{verdict}}</p>\n{{nothing}}")
    target = inputs / "p.html"
    for words, status, text in (
        (("--page", target, "--page-template", template), 1, "{{nothing}} is not a placeholder"),
        (("--page", target, "--page-template", inputs / "no.html"), 1, "does not exist"),
        (("--page", target, "--page-language", "fr"), 2, "allowed: en, de"),
        (("--page-title", "x"), 2, "--page-title can be used only"),
        (("--page-template", template), 2, "--page-template can be used only"),
        (("--page", target, "--offer-rules", "-"), 2, "cannot be combined with --offer-rules"),
        (("--page", inputs / "box.ply"), 2, "SameFile"),
        (("--page", template, "--page-template", template), 2, "SameFile"),
        (("--page", inputs / "x" / "p.html"), 1, "MissingFolder"),
    ):
        done = call(*bench, *words)
        assert (done.returncode, text in done.stderr) == (status, True), (words, done.stderr)
        assert not target.exists()
    target.write_text("old")
    done = call(*bench, "--page", target, "--no-clobber")
    assert done.returncode == 1 and "Exists" in done.stderr and target.read_text() == "old"
    done = call(*bench, "--page", "-", env={"SOURCE_DATE_EPOCH": "soon"})
    assert done.returncode == 1 and "SOURCE_DATE_EPOCH is 'soon'" in done.stderr


def test_pages_of_mechanisms(call, inputs, box, monkeypatch):  # noqa: F811
    monkeypatch.setenv("SOURCE_DATE_EPOCH", "1700000000")
    _swept.write_mesh(inputs / "near.ply", box[0] + [61, 0, 0], box[1])
    (inputs / "up.csv").write_text("t,tx,ty,tz,qx,qy,qz,qw\n0,0,40,0,0,0,0,1\n1,0,40,90,0,0,0,1\n")
    _swept.write_mesh(inputs / "lift.ply", *box)
    words = ["mechanism", "--moving", inputs / "box.ply", inputs / "slide.csv", "--required", 2]
    words += [
        "--moving",
        inputs / "lift.ply",
        inputs / "up.csv",
        inputs / "near.ply",
        "--range",
        90,
    ]
    done = call(*words, "--page", inputs / "p.html", "--report", inputs / "r.json")
    assert done.returncode == 3, done.stderr
    page = (inputs / "p.html").read_text(encoding="utf-8")
    check_alone(page)
    report = json.loads((inputs / "r.json").read_text())
    assert data(page, "report") == steady(report)
    assert [row[0] for row in cells(page, "verdicts")[1:]][0] == "box - near"
    assert len(report["pairs"][0]["clearance"]["curve"]) > 100 and "<svg" in page
    if _swept.page_has_view():
        scene = data(page, "scene")
        kinds = {part["name"]: (part["kind"], part["verdict"]) for part in scene["parts"]}
        assert kinds["box"] == ("moves", "below") and kinds["near"] == ("stands", "below")
        lift = next(part for part in scene["parts"] if part["name"] == "lift")
        poses = np.frombuffer(base64.b64decode(lift["poses"]), "<f4").reshape(-1, 7)
        assert np.allclose(poses[:, 2], 90 * np.array(scene["times"]), atol=1e-3)
        first = scene["rows"][0]
        assert [scene["parts"][i]["name"] for i in first["parts"]] == ["box", "near"]
    done = call(*words, "--report", "-")
    assert (
        json.loads(done.stdout)["pairs"][0]["clearance"]["curve"] == []
    ), "only pages want a graph"
