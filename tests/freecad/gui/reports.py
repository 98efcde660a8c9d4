# SPDX-License-Identifier: LGPL-2.1-or-later
"""Export report, as a user works: a mechanism as a page and as PDF, with a custom template for each; a
study as PDF. The window responds while pictures are taken, and an export can be stopped before the file is
written.
"""
import os
import re
import shutil
import subprocess
import sys
import tempfile
import time

HERE = os.path.dirname(os.path.realpath(__file__))
sys.path[:0] = [HERE, os.path.dirname(HERE)]
from driver import (  # noqa: E402
    App,
    Gaps,
    Gui,
    new_document,
    no_panel,
    open_workbench,
    run,
    say,
    select,
)

FOLDER = tempfile.mkdtemp()
#: A blue square.
LOGO = (
    "iVBORw0KGgoAAAANSUhEUgAAAAgAAAAICAIAAABLbSncAAAAEUlEQVR42mPgjlmLFTEMLQkAzc5FAaNs8JMAAAAASU"
    "VORK5CYII="
)
TEMPLATE = (
    '<html><body><p><img src="data:image/png;base64,{}" width="16" height="16" /> ACME paper'
    "<h1>{{{{title}}}}</h1>{{{{verdict}}}}{{{{table}}}}{{{{graph}}}}{{{{runs}}}}{{{{pictures}}}}"
    "</body></html>"
).format(LOGO)


def text_of(path):
    """Returns the text of a PDF, or "" if pdftotext is not installed."""
    if shutil.which("pdftotext") is None:
        return ""
    done = subprocess.run(["pdftotext", "-layout", path, "-"], capture_output=True)
    return done.stdout.decode("utf-8")


def pictures_in(path):
    with open(path, "rb") as file:
        content = file.read()
    assert content.startswith(b"%PDF-") and content.rstrip().endswith(b"%%EOF")
    return len(re.findall(rb"/Subtype\s*/Image\b", content))


def picture():
    """Returns the CPU seconds of the window's thread for one picture that FreeCAD takes. This cannot be
    divided into steps.
    """
    from sweptvolume.panels.page_pictures import SIZE

    view, took = Gui.activeDocument().activeView(), []
    for _ in range(3):
        began = time.thread_time()
        view.saveImage(os.path.join(FOLDER, "alone.bmp"), *SIZE, "White")
        took.append(time.thread_time() - began)
    return max(took)


def exported(obj, name):
    """A generator that writes a report with the command, and returns its path."""
    from sweptvolume.panels import file_dialogs

    path = os.path.join(FOLDER, name)
    file_dialogs.ask_report = lambda label: path
    select(obj)
    alone, gaps = picture(), Gaps()
    Gui.runCommand("SweptVolume_ExportReport")
    yield no_panel
    line = "{}: the window stood still for {}; a picture takes {:.0f} ms"
    say(line.format(name, gaps.stop(), 1000 * alone))
    assert os.path.exists(path), os.listdir(FOLDER)
    if os.environ.get("SWEPT_SHOTS"):
        shutil.copy(path, os.environ["SWEPT_SHOTS"])
    # The window's thread may compute for 50 ms at a time, or for 2.5 times the time of one picture of FreeCAD
    # if this is longer: FreeCAD takes one picture, and then the window draws another one. Waiting for a
    # processor core does not count.
    assert gaps.busy < max(0.05, 2.5 * alone), (gaps.busy, alone)
    return path


def make_mechanism(doc):
    from sweptvolume.features import mechanism, motion

    V = App.Vector
    parts, motions = [], []
    for k, travel in enumerate((V(30, 0, 0), V(-30, 0, 0), V(0, 25, 0))):
        part = doc.addObject("Part::Box", "Box")
        part.Label = ("Links", "Rechts", "Oben")[k]
        part.Placement.Base = (V(0, 0, 0), V(60, 4, 0), V(25, -20, 0))[k]
        first = part.Placement
        last = App.Placement(first.Base + travel, App.Rotation(V(0, 0, 1), 30.0 * k))
        path = motion.motion_from_poses(doc, [0, 1], [first, last])
        parts.append((part, ""))
        motions.append(path)
    wall = doc.addObject("Part::Box", "Wall")
    wall.Placement.Base = V(0, 40, 0)
    doc.recompute()
    obj = mechanism.make_mechanism(
        doc, "Drei Teile", MovingParts=parts, Motions=motions, AllVisible=True, RequiredDistance=5.0
    )
    doc.recompute()
    mechanism.compute(obj)
    return obj


def make_study(doc):
    from sweptvolume.features import clearance, study

    part, wall = doc.getObject("Box"), doc.getObject("Wall")
    checks = [
        clearance.make_clearance(
            doc,
            "Run {}".format(k),
            MovingParts=[(part, "")],
            Motion=doc.getObject("Motion"),
            Neighbours=[(wall, "")],
            AllVisible=False,
            RequiredDistance=required,
        )
        for k, required in enumerate((20.0, 40.0))
    ]
    obj = study.make_study(doc, Sources=checks, Folder=os.path.join(FOLDER, "study"))
    doc.recompute()
    study.compute(obj)
    return obj


def stopped(obj):
    """A run that is cancelled while pictures are taken leaves no file."""
    from sweptvolume import runner
    from sweptvolume.panels import page_task

    path = os.path.join(FOLDER, "stopped.pdf")
    graph = Gui.activeDocument().activeView().getSceneGraph()
    before, camera = graph.getNumChildren(), Gui.activeDocument().activeView().getCamera()
    found = runner.start(page_task.PageTask(obj, path))
    found.cancel()
    yield lambda: found.state == "cancelled"
    yield 0.3
    assert not os.path.exists(path) and not runner.running()
    assert graph.getNumChildren() == before, "what was drawn is gone"
    assert Gui.activeDocument().activeView().getCamera() == camera


def scenario():
    from sweptvolume import settings

    open_workbench()
    yield
    doc = new_document("Reports")
    obj = make_mechanism(doc)
    study = make_study(doc)
    Gui.activeDocument().activeView().viewIsometric()
    Gui.SendMsgToActiveView("ViewFit")
    yield 0.5
    graph = Gui.activeDocument().activeView().getSceneGraph()
    drawn = graph.getNumChildren()
    page = yield from exported(obj, "mechanism.html")
    with open(page, encoding="utf-8") as file:
        text = file.read()
    assert "Links - Rechts" in text and "Drei Teile" in text and "<svg" in text
    paper = yield from exported(obj, "mechanism.pdf")
    assert pictures_in(paper) >= 2, "graph and places"
    content = text_of(paper)
    for word in ("Drei Teile", "Links - Rechts", "Verdicts", "Rules", "SHA-256") if content else ():
        assert word in content, (word, content)
    assert graph.getNumChildren() == drawn, "what was drawn for pictures is gone"
    yield from stopped(obj)
    whole = yield from exported(study, "study.pdf")
    content = text_of(whole)
    for word in ("Run 1", "not clear") if content else ():
        assert word in content, (word, content)
    assert pictures_in(whole) >= 2, "a graph for each run"
    # Custom templates, one for each kind of file.
    template = os.path.join(FOLDER, "acme.html")
    with open(template, "w") as file:
        file.write(TEMPLATE)
    group = App.ParamGet(settings.PATH)
    group.SetString("PrintTemplate", template)
    paper = yield from exported(obj, "acme.pdf")
    content = text_of(paper)
    assert not content or ("ACME paper" in content and "SHA-256" not in content), content
    paper = yield from exported(study, "acme study.pdf")
    content = text_of(paper)
    assert not content or ("ACME paper" in content and "Run 1" in content), content
    group.RemString("PrintTemplate")


run(scenario)
