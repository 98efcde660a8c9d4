# SPDX-License-Identifier: LGPL-2.1-or-later
"""The result of a mechanism check as one line of text and as a table. Works like
clearance_table.py, with a row for each pair."""
from .. import quantities
from ..texts import translate
from . import clearance_table

#: Words that replace words in the titles of the clearance table, because both parts may move.
_TITLES = {"Body": "First", "Neighbour": "Second"}


def as_rows(report):
    """Returns the rows of a report with the keys that clearance_table reads: the first part of a
    pair becomes the body, the second the neighbour."""
    ignored = [" - ".join(pair) for pair in report["ignored"]]
    return dict(report, neighbours=[pair["clearance"] for pair in report["pairs"]], ignored=ignored)


def count(report):
    """Returns the number of checked pairs, including those that stay far apart."""
    return report["far_pairs"] + len(report["pairs"])


def summary(report):
    """Returns the result in one line, in the user's language and unit."""
    head = translate("SweptVolume", "{0} pairs checked").format(quantities.count(count(report)))
    if not report["pairs"]:
        text = translate("SweptVolume", "{0}, none nearer than {1}")
        return text.format(head, quantities.quantity(report["range"], quantities.TABLE_DIGITS))
    return clearance_table.summary(as_rows(report), head)


def worst(report):
    """Returns the same as clearance_table.worst()."""
    return clearance_table.worst(as_rows(report))


def smallest(report):
    """Returns the smallest distance of all pairs (mm), or the range if no pair comes that close."""
    if not report["pairs"]:
        return report["range"]
    return report["pairs"][report["smallest"]]["clearance"]["distance"]


def columns():
    """Returns the column headings."""
    found = []
    for title in clearance_table.columns()[1:]:
        word, space, rest = title.partition(" ")
        found.append(_TITLES.get(word, word) + space + rest)
    return ["First", "Second"] + found


def table(report):
    """Returns the rows of the table, with the columns of columns()."""
    names = [[pair["first"], pair["second"]] for pair in report["pairs"]] + report["ignored"]
    rows = clearance_table.table(as_rows(report))
    return [list(pair) + row[1:] for pair, row in zip(names, rows)]


def write_csv(report, path):
    """Writes the table as a CSV file (UTF-8)."""
    clearance_table.write_rows([columns()] + table(report), path)


def make_spreadsheet(obj, report):
    """Adds the table to the document as a spreadsheet."""
    return clearance_table.spreadsheet_of(obj, [columns()] + table(report))
