# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pages in a real browser, without a window: the 3D view draws, follows the slider and the rows, and no error
is logged. Skipped where there is no chromium or the module was built without three.js. With
SWEPT_SCREENSHOTS=FOLDER, pictures of the pages are kept, to be looked at.
"""
import html
import json
import os
import pathlib
import re
import shutil
import subprocess

import numpy as np
import pytest

import _swept
import swept_volume as sv
from test_pages import CUBE, HOSTILE, MOTION, NEIGHBOURS

CHROMIUM = shutil.which("chromium") or shutil.which("chromium-browser")
pytestmark = [
    pytest.mark.skipif(CHROMIUM is None, reason="chromium is not installed"),
    pytest.mark.skipif(not _swept.page_has_view(), reason="built without three.js"),
]
#: A script added to a page: it acts like a user and writes what it sees into the page.
PROBE = """
<script>
const seen = {};
function look() {  // colours of the canvas: all, and those of the line between closest points
  const copy = document.createElement("canvas"), source = document.getElementById("view-canvas");
  copy.width = source.width;
  copy.height = source.height;
  const painter = copy.getContext("2d");
  painter.drawImage(source, 0, 0);
  const { data } = painter.getImageData(0, 0, copy.width, copy.height);
  let drawn = 0, yellow = 0, blue = 0, sum = 0;
  for (let i = 0; i < data.length; i += 4) {
    const [r, g, b, a] = data.slice(i, i + 4);
    if (a > 0) ++drawn;
    if (r > 230 && g > 190 && b < 60) ++yellow;
    if (b > 1.4 * r && b > 90) { ++blue; sum += (i / 4) % copy.width; }
  }
  return { drawn, yellow, blue, x: sum / blue / copy.width };
}
function slide(k) {
  const slider = document.getElementById("view-time");
  slider.value = k;
  slider.dispatchEvent(new Event("input"));
}
try {
  seen.errors = [];
  window.onerror = (text) => seen.errors.push(String(text));
  seen.rows = [...document.querySelectorAll("tr[data-row]")].map((row) => {
    row.click();
    return { name: row.cells[0].textContent, now: document.getElementById("view-now").value,
             chosen: row.classList.contains("chosen"), ...look() };
  });
  document.getElementById("view-reset").click();
  const last = Number(document.getElementById("view-time").max);
  slide(0); seen.first = look();
  slide(last); seen.last = look();
  const box = document.querySelector("#view-parts input");
  box.click(); seen.hidden = look();
  box.click(); seen.again = look();
  seen.lines = document.querySelectorAll("#view-parts label").length;
  seen.now = document.getElementById("graph-now").getAttribute("visibility");
  seen.stage = getComputedStyle(document.querySelector(".stage")).display;
  seen.dark = getComputedStyle(document.body).backgroundColor;
  seen.dialogs = window.attacked || 0;
} catch (error) {
  seen.failed = String(error && error.stack);
}
document.body.dataset.seen = JSON.stringify(seen);
</script></body>"""
ARGUMENTS = (
    "--headless=new --no-sandbox --hide-scrollbars --use-angle=swiftshader --disable-background-networking "
    "--enable-unsafe-swiftshader --enable-logging=stderr --virtual-time-budget=2000"
).split()


def browse(tmp_path, page, *words):
    """Returns Chromium's output for a page: (standard output, lines of the console)."""
    file = tmp_path / "page.html"
    file.write_text(page, encoding="utf-8")
    done = subprocess.run(
        [CHROMIUM, *ARGUMENTS, f"--user-data-dir={tmp_path / 'profile'}", *words, file.as_uri()],
        capture_output=True,
        text=True,
        timeout=600,
    )
    assert done.returncode == 0, done.stderr[-2000:]
    return done.stdout, re.findall(r".*CONSOLE.*", done.stderr)


def acted(tmp_path, page, *words):
    """Returns what the script saw in the page. The console must be empty."""
    assert page.count("</body>") == 1
    text, console = browse(tmp_path, page.replace("</body>", PROBE), "--dump-dom", *words)
    assert console == []
    seen = json.loads(html.unescape(re.search(r'data-seen="([^"]*)"', text)[1]))
    assert "failed" not in seen and seen["errors"] == [] and seen["stage"] == "flex", seen
    return seen


def keep(tmp_path, name, page, *words):
    """Takes a picture of the page and returns its bytes. Keeps the file if SWEPT_SCREENSHOTS is
    set."""
    folder = os.environ.get("SWEPT_SCREENSHOTS")
    picture = (pathlib.Path(folder) if folder else tmp_path) / f"{name}.png"
    browse(tmp_path, page, "--window-size=1100,2600", f"--screenshot={picture}", *words)
    assert picture.stat().st_size > 20000
    return picture.read_bytes()


@pytest.fixture(scope="module")
def report():
    return sv.clearance(CUBE, MOTION, NEIGHBOURS, required=3, rules={"rail": "contact"})


def page_of(report, **options):
    parts = [("cube", CUBE, MOTION), *NEIGHBOURS]
    return sv.report_page(report, parts=parts, title=HOSTILE, **options)


def test_the_view_draws_and_follows(tmp_path, report):
    seen = acted(tmp_path, page_of(report))
    assert seen["lines"] == 5 and seen["now"] == "visible"
    assert (
        seen["first"]["drawn"] > 10000 and seen["first"]["blue"] > 300
    ), "the moving part is there"
    assert seen["last"]["x"] > seen["first"]["x"] + 0.05, "it has moved to the right"
    assert seen["hidden"]["blue"] < 0.1 * seen["last"]["blue"] and seen["again"] == seen["last"]
    rows = {row["name"]: row for row in seen["rows"]}
    for neighbour in report["neighbours"][:3]:
        row = rows[neighbour["name"]]
        assert row["chosen"] and row["yellow"] > 20, "the closest line"
        assert float(row["now"].split()[0]) == pytest.approx(neighbour["time_seconds"], abs=1e-3)


def test_mechanisms_and_german(tmp_path):
    back = sv.Motion([0.0, 2.0], MOTION.quaternions, [[40, 13, 0], [0, 13, 0]])
    wall = sv.Mesh(*(NEIGHBOURS[0][1].vertices, NEIGHBOURS[0][1].triangles))
    parts = [("links", CUBE, MOTION), ("rechts", CUBE, back), ("Wand", wall, None)]
    report = sv.mechanism(parts, required=4, range=60)
    shown = [part if part[2] is not None else part[:2] for part in parts]
    page = sv.report_page(report, parts=shown, language="de")
    seen = acted(tmp_path, page)
    assert seen["lines"] == 3 and len(seen["rows"]) == 3
    assert all(
        "," in row["now"] or row["now"].startswith(("0 ", "1 ", "2 ")) for row in seen["rows"]
    )
    assert seen["first"]["blue"] > 300


@pytest.mark.skipif(shutil.which("pdftotext") is None, reason="pdftotext is not installed")
def test_nothing_is_cut_off_on_paper(tmp_path, report):
    paper = tmp_path / "paper.pdf"
    browse(tmp_path, page_of(report), "--no-pdf-header-footer", f"--print-to-pdf={paper}")
    text = subprocess.run(["pdftotext", "-raw", paper, "-"], capture_output=True).stdout.decode()
    words = " ".join(text.split())
    for word in ("Below required for", "Depth", "below required", "Rules", "Settings", "Findings"):
        assert word in words, (word, words)
    below = report["neighbours"][0]["below"][0]
    assert f"{below[1] - below[0]:.4g} s" in words and "Point at a curve" not in words
    assert shutil.which("pdftoppm") is None or room_at_the_right(tmp_path, paper) > 0


def room_at_the_right(tmp_path, paper):
    """Returns the distance (mm) of the text on the first page from its right edge."""
    subprocess.run(
        ["pdftoppm", "-r", "50", "-gray", "-l", "1", paper, tmp_path / "ink"], check=True
    )
    (picture,) = tmp_path.glob("ink*.pgm")
    kind, width, height, _, pixels = picture.read_bytes().split(maxsplit=4)
    rows = np.frombuffer(pixels[-int(width) * int(height) :], np.uint8).reshape(int(height), -1)
    columns = np.flatnonzero((rows < 128).any(axis=0))
    return (int(width) - 1 - columns.max()) * 25.4 / 50


def test_hostile_names_stay_text(tmp_path, report):
    attack = "</script><img src=x onerror='window.attacked=1'><script>window.attacked=1</script>"
    text = json.dumps(report).replace("Wand", json.dumps(attack)[1:-1])
    page = sv.report_page(
        json.loads(text),
        title=attack,
        date=attack,
        inputs=[(attack,) * 4],
        parts=[(attack, CUBE, MOTION), *NEIGHBOURS],
    )
    seen = acted(tmp_path, page)
    assert seen["dialogs"] == 0 and attack in [row["name"] for row in seen["rows"]]


def test_pictures_in_light_dark_and_without_a_view(tmp_path, report):
    light = keep(tmp_path, "light", page_of(report))
    dark = keep(
        tmp_path, "dark", page_of(report, language="de"), "--blink-settings=preferredColorScheme=0"
    )
    assert light != dark
    colours = [
        acted(tmp_path, page_of(report), *words)["dark"]
        for words in ((), ("--blink-settings=preferredColorScheme=0",))
    ]
    assert colours[0] == "rgb(255, 255, 255)" and colours[1] == "rgb(22, 25, 29)"
    probe = (
        'document.body.dataset.stage = getComputedStyle(document.querySelector(".stage")).display'
    )
    page = page_of(report).replace("</body>", f"<script>{probe}</script></body>")
    text, _ = browse(tmp_path, page, "--dump-dom", "--disable-gpu", "--disable-3d-apis")
    assert 'data-stage="none"' in text, "where WebGL is missing a sentence stands in its place"
    assert (
        "needs JavaScript and WebGL" in text and "with-view" not in text.partition("<body")[0][:200]
    )
