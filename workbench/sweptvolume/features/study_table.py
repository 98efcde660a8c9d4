# SPDX-License-Identifier: LGPL-2.1-or-later
"""Texts about the rows of a study, and a summary line."""
from ..quantities import TABLE_DIGITS, number, quantity
from ..texts import QT_TRANSLATE_NOOP, translate
from .clearance import VERDICTS

#: State of a run -> text for users.
STATES = {
    "failed": QT_TRANSLATE_NOOP("SweptVolume", "Failed"),
    "not clear": QT_TRANSLATE_NOOP("SweptVolume", "Not clear"),
    "not run": QT_TRANSLATE_NOOP("SweptVolume", "Not run"),
    "done": QT_TRANSLATE_NOOP("SweptVolume", "Done"),
}
#: The entries of a stored report that are used, with their shapes (base.fits()).
REPORT = {"runs": [{"run": str, "state": set(STATES)}], "worst": str, "message": str}


def count(rows, state):
    return sum(row["state"] == state for row in rows)


def state_text(row):
    return translate("SweptVolume", STATES[row["state"]])


def verdict_text(row):
    """Returns the worst verdict of a run, or "" if it computed no clearance."""
    verdict = row.get("verdict", "")
    if verdict == "contact" and row["state"] == "done":
        return translate("SweptVolume", "Allowed contact")
    return translate("SweptVolume", VERDICTS[verdict]) if verdict in VERDICTS else ""


def length_text(row):
    """Returns the smallest distance, or the depth of a clash, or ""."""
    if row.get("verdict") == "clash" and row.get("depth"):
        return translate("SweptVolume", "{0} deep").format(quantity(row["depth"], TABLE_DIGITS))
    return quantity(row["distance"], TABLE_DIGITS) if "distance" in row else ""


def line_of(row):
    """Returns a run in one line."""
    words = [row["run"], state_text(row), verdict_text(row), length_text(row)]
    words.append(row.get("neighbour", ""))
    if "time_seconds" in row:
        words.append(translate("SweptVolume", "t = {0} s").format(number(row["time_seconds"], 4)))
    words.append(row.get("message", ""))
    return ", ".join(filter(None, words))


def worst(report):
    """Returns the row with the worst result, or None."""
    rows = report["runs"]
    return next((row for row in rows if row["run"] == report["worst"]), None)


def verdict(report):
    """Returns a verdict for the icon: "failed" if a run failed, the worst verdict of the checks, or
    "" if all is well."""
    row = worst(report)
    if row is None or row["state"] in ("done", "not run"):
        return ""
    return row["state"] if row["state"] == "failed" else row.get("verdict", "below")


def summary(report):
    """Returns the result in one line."""
    rows = report["runs"]
    words = [translate("SweptVolume", "{0} runs").format(len(rows))]
    for state, text in (
        ("failed", translate("SweptVolume", "{0} failed")),
        ("not clear", translate("SweptVolume", "{0} not clear")),
        ("not run", translate("SweptVolume", "{0} not run")),
        ("done", translate("SweptVolume", "{0} done")),
    ):
        if count(rows, state):
            words.append(text.format(count(rows, state)))
    return ", ".join(words)
