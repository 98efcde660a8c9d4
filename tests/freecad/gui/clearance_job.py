# SPDX-License-Identifier: LGPL-2.1-or-later
"""A clearance check through the commands, as a user works: envelope, check, table, row, colours, graph,
spreadsheet.
"""
import os
import re
import shutil
import subprocess
import sys
import tempfile

sys.path.insert(0, os.path.dirname(os.path.realpath(__file__)))
from driver import (  # noqa: E402
    App,
    Close,
    Gui,
    QtWidgets,
    click,
    find,
    new_document,
    no_panel,
    open_workbench,
    panel_button,
    read_verdicts,
    run,
    select,
    shot,
    titles_of,
)


def check_pdf(content):
    """Checks that a PDF file is complete: its pages, its pictures, and its text if pdftotext is
    installed."""
    assert content.startswith(b"%PDF-") and content.rstrip().endswith(b"%%EOF")
    pages = len(re.findall(rb"/Type\s*/Page\b", content))
    pictures = len(re.findall(rb"/Subtype\s*/Image\b", content))
    assert 1 <= pages <= 8 and pictures >= 2, (pages, pictures)
    if shutil.which("pdftotext") is None:
        return
    done = subprocess.run(["pdftotext", "-layout", "-", "-"], input=content, capture_output=True)
    text = done.stdout.decode("utf-8")
    for word in ("Clearance", "Post", "clash", "Verdicts", "Rules", "SHA-256"):
        assert word in text, (word, text)


def keep(path):
    """Keeps a copy beside the screenshots, to look at."""
    if os.environ.get("SWEPT_SHOTS"):
        shutil.copy(path, os.environ["SWEPT_SHOTS"])


def scenario():
    from sweptvolume.features import clearance, envelope, motion
    from sweptvolume.panels import file_dialogs

    open_workbench()
    yield
    doc = new_document("Check")
    box = doc.addObject("Part::Box", "Slide")
    box.Length, box.Width, box.Height = 30, 16, 10

    def place(x, y, degrees):
        return App.Placement(App.Vector(x, y, 0), App.Rotation(App.Vector(0, 0, 1), degrees))

    path = motion.motion_from_poses(
        doc, [0, 1, 2], [place(0, 0, 0), place(60, 0, 0), place(90, 50, 90)]
    )
    for name, x, y, size in (
        ("Post", 48, 22, 6),
        ("Wall", 100, -20, 12),
        ("Stop", 58, 52, 14),
        ("Far", -40, 60, 10),
    ):
        part = doc.addObject("Part::Box", name)
        part.Length = part.Width = size
        part.Height = 20
        part.Placement.Base = App.Vector(x, y, -5)
    doc.recompute()
    swept = envelope.make_envelope(doc, [box], path, Resolution=90)
    doc.recompute()
    envelope.compute(swept)
    path.ViewObject.Visibility = False
    Gui.activeDocument().activeView().viewIsometric()
    Gui.SendMsgToActiveView("ViewFit")
    yield
    undo = doc.UndoCount
    select(swept)
    Gui.runCommand("SweptVolume_Clearance")
    yield 0.5
    click(find(QtWidgets.QPushButton, "SweptVolumeCheck"))
    yield lambda: doc.getObject("Clearance") is not None
    yield 0.5
    obj = doc.getObject("Clearance")
    assert list(obj.RuleKinds) == []
    assert obj.Status == clearance.UP_TO_DATE, obj.Status
    assert doc.UndoCount == undo + 1, (doc.UndoCount, undo)
    table = find(QtWidgets.QTableWidget, "SweptVolumeClearanceTable")
    assert table.rowCount() == 4, table.rowCount()
    heads = ["Neighbour", "Verdict", "Distance\nmm", "Time\ns", "Depth\nmm"]
    assert titles_of(table) == heads, titles_of(table)
    distances = [float(table.item(r, 2).text()) for r in range(4)]
    assert distances == sorted(distances), distances
    summary = find(QtWidgets.QLabel, "SweptVolumeClearanceSummary").text()
    assert "4 checked" in summary, summary
    assert len(set(read_verdicts(table).values())) > 1
    shot("11_clearance_table")
    yield 1.0
    table.selectRow(1)
    yield 0.5
    view = obj.ViewObject.Proxy
    assert view.row.getNumChildren() >= 1
    shot("12_clearance_row")
    yield 1.0
    Gui.SendMsgToActiveView("ViewFit")
    find(QtWidgets.QCheckBox, "SweptVolumeColours").setChecked(True)
    yield 0.5
    assert view.colours.getNumChildren() == 1 and not swept.ViewObject.Visibility
    shot("13_clearance_colours")
    yield 1.0

    # Other limits of the colour bands change the colours; a click on a heading sorts; the table is
    # written to a file.
    def corners_in_contact():
        surface = view.colours.getChild(0)
        faces = surface.getChild(surface.getNumChildren() - 1)
        return list(faces.materialIndex.getValues()).count(1)

    before = corners_in_contact()
    find(QtWidgets.QWidget, "SweptVolumeRequiredBand").setProperty("rawValue", 40.0)
    find(QtWidgets.QWidget, "SweptVolumeContactBand").setProperty("rawValue", 20.0)
    yield 0.3
    assert corners_in_contact() > before + 100, (corners_in_contact(), before)
    shot("14_clearance_bands")
    yield 1.0
    table.sortItems(0)
    names = [table.item(r, 0).text() for r in range(4)]
    assert names == sorted(names), names
    undo = doc.UndoCount
    click(find(QtWidgets.QPushButton, "SweptVolumeSheet"))
    yield 0.3
    sheets = [o for o in doc.Objects if o.isDerivedFrom("Spreadsheet::Sheet")]
    assert len(sheets) == 1 and doc.UndoCount == undo + 1, (sheets, doc.UndoNames)
    path = os.path.join(tempfile.mkdtemp(), "table.csv")
    file_dialogs.ask_table = lambda name: path
    click(find(QtWidgets.QPushButton, "SweptVolumeCsv"))
    yield 0.3
    with open(path, encoding="utf-8") as file:
        lines = file.read().splitlines()
    assert len(lines) == 5 and any("Post" in line for line in lines), lines
    # The report as a page and as PDF.
    for suffix in ("html", "pdf"):
        target = os.path.join(tempfile.mkdtemp(), "Bericht." + suffix)
        file_dialogs.ask_report = lambda name, target=target: target
        click(find(QtWidgets.QPushButton, "SweptVolumeReport"))
        yield lambda target=target: os.path.exists(target)
        yield 0.3
        with open(target, "rb") as file:
            content = file.read()
        if suffix == "html":
            assert b"Post" in content and b"</html>" in content
        else:
            check_pdf(content)
            keep(target)
    # Rules: one with a larger distance, one *Ignored*. Contacts at the first pose are offered as rules.
    bench = doc.addObject("Part::Box", "Bench")
    bench.Length, bench.Width, bench.Height = 60, 40, 4
    bench.Placement.Base = App.Vector(-15, -12, -4)
    doc.recompute()
    click(panel_button(Close))
    yield no_panel
    select(obj)
    Gui.runCommand("SweptVolume_Clearance")
    yield 0.5
    rule_table = find(QtWidgets.QTableWidget, "SweptVolumeRules")
    assert rule_table.rowCount() == 5, rule_table.rowCount()
    row_of = {rule_table.item(r, 0).text(): r for r in range(5)}
    click(find(QtWidgets.QPushButton, "SweptVolumeTouching"))
    yield lambda: rule_table.item(row_of["Bench"], 2).text() == "Contact allowed"
    assert [rule_table.item(r, 2).text() for r in range(5)].count("Contact allowed") == 1
    rule_table.item(row_of["Far"], 1).setText("12 cm")
    rule_table.setCurrentCell(row_of["Post"], 2)
    rule_table.editItem(rule_table.item(row_of["Post"], 2))
    yield 0.2
    choice = rule_table.findChild(QtWidgets.QComboBox)
    assert choice.count() == 3, choice.count()
    choice.setCurrentIndex(2)
    choice.activated.emit(2)
    yield 0.2
    assert rule_table.item(row_of["Post"], 2).text() == "Ignored"
    shot("15_clearance_rules")
    undo = doc.UndoCount
    click(find(QtWidgets.QPushButton, "SweptVolumeCheck"))
    yield lambda: doc.UndoCount == undo + 1
    yield 0.5
    kinds = {part.Label: kind for (part, _), kind in zip(obj.RuleParts, obj.RuleKinds)}
    assert kinds == {"Bench": "Contact", "Far": "Required", "Post": "Ignore"}, kinds
    assert sorted(obj.RuleLengths) == [0.0, 0.0, 120.0], obj.RuleLengths
    table = find(QtWidgets.QTableWidget, "SweptVolumeClearanceTable")
    shown = {table.item(r, 0).text(): table.item(r, 1).text() for r in range(table.rowCount())}
    assert sorted(shown) == ["Bench", "Far", "Stop", "Wall"], shown
    assert shown["Bench"] == "Allowed contact" and shown["Far"] == "Below required", shown
    summary = find(QtWidgets.QLabel, "SweptVolumeClearanceSummary").text()
    assert "1 in allowed contact, 1 ignored" in summary, summary
    shot("16_clearance_ruled")
    doc.undo()
    assert list(obj.RuleKinds) == [], obj.RuleKinds
    doc.redo()
    assert sorted(obj.RuleKinds) == ["Contact", "Ignore", "Required"], obj.RuleKinds
    click(panel_button(Close))
    yield no_panel
    assert swept.ViewObject.Visibility and view.colours.getNumChildren() == 0
    doc.getObject("Post").Placement.Base.y = 40
    doc.recompute()
    assert obj.Status == clearance.STALE, obj.Status
    yield from rules_of_groups(doc, obj)


def rules_of_groups(doc, obj):
    """The rule of a group stays if the row of another part, or of a part in the group, changes."""
    from sweptvolume.features import neighbour_rules
    from sweptvolume.features.neighbour_rules import Rule

    group = doc.addObject("App::Part", "Fixture")
    group.addObjects([doc.getObject("Stop"), doc.getObject("Wall")])
    doc.recompute()
    far, fixture = (doc.getObject("Far"), ""), (group, "")
    stop, wall = (group, "Stop."), (group, "Wall.")
    neighbour_rules.write(obj, {fixture: Rule(length=3.0)})
    doc.recompute()
    select(obj)
    Gui.runCommand("SweptVolume_Clearance")
    yield 0.5
    rule_table = find(QtWidgets.QTableWidget, "SweptVolumeRules")
    row_of = {rule_table.item(r, 0).text(): r for r in range(rule_table.rowCount())}
    assert [rule_table.item(row_of[name], 1).text() for name in ("Stop", "Wall", "Far")] == [
        "3",
        "3",
        "",
    ]
    for name, text, rules in (
        ("Far", "20", {fixture: Rule(length=3.0), far: Rule(length=20.0)}),
        ("Wall", "4", {fixture: Rule(length=3.0), far: Rule(length=20.0), wall: Rule(length=4.0)}),
        ("Wall", "", {far: Rule(length=20.0), stop: Rule(length=3.0)}),
    ):
        rule_table.item(row_of[name], 1).setText(text)
        undo = doc.UndoCount
        click(find(QtWidgets.QPushButton, "SweptVolumeCheck"))
        yield lambda undo=undo: doc.UndoCount == undo + 1
        yield 0.3
        found = neighbour_rules.read(obj)
        assert found == rules, {key[1]: rule.text() for key, rule in found.items()}
    click(panel_button(Close))
    yield no_panel


run(scenario)
