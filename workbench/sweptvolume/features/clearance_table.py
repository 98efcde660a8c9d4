# SPDX-License-Identifier: LGPL-2.1-or-later
"""The result of a clearance check as one line of text, as a CSV file and as a spreadsheet. Lengths
are in the unit of FreeCAD's preferences, which the column headings show. Numbers in files have no
group separators, so that other programs can read them."""
import csv

from .. import targets
from ..quantities import TABLE_DIGITS, length_unit, number, quantity
from ..safe_file import written_beside
from ..texts import translate
from .neighbour_rules import CONTACT, REQUIRED


def verdict_word(verdict):
    """Returns the English text of a verdict, for files."""
    return "below required" if verdict == "below" else verdict


#: Title, unit, and function that takes the value from a row of the report. "mm" stands for the unit
#: of the preferences.
_COLUMNS = [
    ("Neighbour", "", lambda row, deep: row["name"]),
    ("Verdict", "", lambda row, deep: verdict_word(row["verdict"])),
    ("Distance", "mm", lambda row, deep: row["distance"]),
    ("Guaranteed", "mm", lambda row, deep: row["guaranteed"]),
    ("Time", "s", lambda row, deep: row["time_seconds"]),
    ("Depth", "mm", lambda row, deep: deep.get("depth", 0.0)),
    ("Depth at most", "mm", lambda row, deep: deep.get("depth_bound", 0.0)),
    ("Below required for", "s", lambda row, deep: sum((b - a for a, b in row["below"]), 0.0)),
    ("Body X", "mm", lambda row, deep: row["point_on_body"][0]),
    ("Body Y", "mm", lambda row, deep: row["point_on_body"][1]),
    ("Body Z", "mm", lambda row, deep: row["point_on_body"][2]),
    ("Neighbour X", "mm", lambda row, deep: row["point_on_neighbour"][0]),
    ("Neighbour Y", "mm", lambda row, deep: row["point_on_neighbour"][1]),
    ("Neighbour Z", "mm", lambda row, deep: row["point_on_neighbour"][2]),
    ("Rule", "", lambda row, deep: row["rule"]),
    ("Meets rule", "", lambda row, deep: "yes" if row["meets_rule"] else "no"),
]
#: Verdicts, the worst first.
WORST_FIRST = ("clash", "contact", "below", "clear")


def meets_rule(row):
    """Returns whether a row of a report meets its rule. In reports without rules (earlier
    versions), only "clear" does."""
    return row.get("meets_rule", row["verdict"] == "clear")


def judged(row):
    """Returns "clear" for a row that meets its rule, otherwise its verdict."""
    return "clear" if meets_rule(row) else row["verdict"]


def worst(report):
    """Returns the worst verdict of the rows that do not meet their rule, or "clear" if all do."""
    return min(map(judged, report["neighbours"]), key=WORST_FIRST.index, default="clear")


def worst_first(report):
    """Returns the indices of the rows in this order: rows that do not meet their rule (clash,
    contact, below required), then the others. Among equal verdicts, the deepest or the nearest
    comes first."""
    rows = report["neighbours"]

    def badness(index):
        row = rows[index]
        verdict = judged(row)
        deep = row.get("penetration", {}).get("depth", 0.0) if verdict == "clash" else 0.0
        return WORST_FIRST.index(verdict), -deep, row["distance"]

    return sorted(range(len(rows)), key=badness)


def worst_rows(report):
    """Returns the indices of the rows that do not meet their rule, the worst first. If all rows do,
    returns only the nearest row."""
    rows = report["neighbours"]
    bad = [index for index in worst_first(report) if not meets_rule(rows[index])]
    nearest = report.get("smallest", 0)
    return bad or ([nearest] if nearest < len(rows) else [])


def line_of(row):
    """Returns the line that shows a row in the 3D view: (its two ends, its text, whether the parts
    clash). The line connects the nearest points of the parts. For a clash it connects the deepest
    point with the surface.
    """
    ends, length = [row["point_on_body"], row["point_on_neighbour"]], row["distance"]
    deep = row.get("penetration", {}) if row["verdict"] == "clash" else {}
    if "point" in deep and "surface" in deep:
        ends = [deep["point"], deep["surface"]]
    text = quantity(deep.get("depth", length), TABLE_DIGITS)
    return ends, translate("SweptVolume", "{0} deep").format(text) if deep else text, bool(deep)


def rule_of(row, report):
    """Returns the rule of a row as (kind from neighbour_rules.KINDS, mm)."""
    rule = row.get("rule", {})
    if "contact" in rule:
        return CONTACT, rule["contact"]
    return REQUIRED, rule.get("required", report["required"])


def rule_text(row, report):
    """Returns the rule of a row in the user's language and unit."""
    kind, length = rule_of(row, report)
    if kind == REQUIRED:
        return quantity(length, TABLE_DIGITS)
    if not length:
        return translate("SweptVolume", "contact")
    return translate("SweptVolume", "contact, {0} deep").format(quantity(length, TABLE_DIGITS))


def summary(report, head=""):
    """Returns the result in one line in the user's language and unit; the core writes the same line
    in English. head: text with the number of checks, if this differs from the number of rows."""
    rows, nearest = report["neighbours"], report.get("smallest")
    if not isinstance(nearest, int) or not 0 <= nearest < len(rows):  # the report is damaged
        return report["summary"]
    words = [head or translate("SweptVolume", "{0} checked").format(len(rows))]
    for verdict, text in (
        ("clash", translate("SweptVolume", "{0} clash")),
        ("contact", translate("SweptVolume", "{0} in contact")),
        ("below", translate("SweptVolume", "{0} below required")),
    ):
        count = sum(row["verdict"] == verdict and not meets_rule(row) for row in rows)
        if count:
            words.append(text.format(count))
    for count, text in (
        (
            sum(row["verdict"] == "contact" and meets_rule(row) for row in rows),
            translate("SweptVolume", "{0} in allowed contact"),
        ),
        (len(report.get("ignored", [])), translate("SweptVolume", "{0} ignored")),
    ):
        if count:
            words.append(text.format(count))
    row = rows[nearest]
    deep = row.get("penetration", {}).get("depth") if row["verdict"] == "clash" else None
    where = number(row["time_seconds"], TABLE_DIGITS), row["name"]
    if isinstance(deep, (int, float)):
        text, lengths = translate("SweptVolume", "deepest clash {0} at t = {1} s ({2})"), [deep]
    else:
        text = translate("SweptVolume", "smallest distance {0} at t = {1} s ({2})")
        lengths = [row["distance"], row.get("guaranteed", row["distance"])]
    lengths = [quantity(length, TABLE_DIGITS) for length in lengths]
    if len(set(lengths)) > 1:  # the guaranteed distance is smaller
        text = translate(
            "SweptVolume", "smallest distance {0} (guaranteed: {1}) at t = {2} s ({3})"
        )
    else:
        del lengths[1:]
    return ", ".join(words + [text.format(*lengths, *where)])


def columns():
    """Returns the column headings."""
    shown = {"": "", "s": " (s)", "mm": " ({})".format(length_unit()[1])}
    return [title + shown[unit] for title, unit, _ in _COLUMNS]


def table(report):
    """Returns the rows of the table, with the columns of columns()."""
    one = length_unit()[0]
    rows = []
    for row in report["neighbours"]:
        deep = row.get("penetration", {})
        row = dict(row, rule=rule_text(row, report), meets_rule=meets_rule(row))
        cells = [(unit, find(row, deep)) for _, unit, find in _COLUMNS]
        rows.append([value / one if unit == "mm" else value for unit, value in cells])
    ignored = translate("SweptVolume", "ignored")
    for name in report.get("ignored", []):
        rows.append([name] + [""] * (len(_COLUMNS) - 3) + [ignored, ""])
    return rows


def write_csv(report, path):
    """Writes the table as a CSV file (UTF-8). Raises InputProblem if a document reads from that
    file."""
    write_rows([columns()] + table(report), path)


def write_rows(rows, path):
    """Writes rows of a table as a CSV file (UTF-8). Raises InputProblem if a document reads from
    that file."""
    targets.check_not_read(path)
    with written_beside(path) as beside:
        with open(beside, "w", encoding="utf-8", newline="") as out:
            csv.writer(out).writerows(rows)


def make_spreadsheet(obj, report):
    """Adds the table to the document as a spreadsheet."""
    return spreadsheet_of(obj, [columns()] + table(report))


def spreadsheet_of(obj, rows):
    """Adds rows of a table as a spreadsheet beside an object."""
    sheet = obj.Document.addObject("Spreadsheet::Sheet", "ClearanceTable")
    sheet.Label = translate("SweptVolume", "{0} table").format(obj.Label)
    for r, row in enumerate(rows):
        for c, value in enumerate(row):
            cell = "{}{}".format(chr(ord("A") + c), r + 1)
            sheet.set(cell, repr(value) if isinstance(value, float) else "'" + str(value))
    return sheet
