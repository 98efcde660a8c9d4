# SPDX-License-Identifier: LGPL-2.1-or-later
"""The result of a mechanism check in one line and as a table: as clearance_table.py has those of one moving
body, with a row for each pair."""
from .. import quantities
from ..texts import translate
from . import clearance_table

#: Titles of the clearance table that mean something else where both parts move.
_TITLES = {"Body": "First", "Neighbour": "Second"}


def as_rows(report):
    """A report as clearance_table takes it: the body is the first part of a pair, the neighbour the
    second."""
    ignored = [" - ".join(pair) for pair in report["ignored"]]
    return dict(report, neighbours=[pair["clearance"] for pair in report["pairs"]], ignored=ignored)


def count(report):
    """How many pairs were checked, with those that stay far apart."""
    return report["far_pairs"] + len(report["pairs"])


def summary(report):
    """The result in one line, in the user's language and unit."""
    head = translate("Messages", "{0} pairs checked").format(quantities.count(count(report)))
    if not report["pairs"]:
        text = translate("Messages", "{0}, none nearer than {1}")
        return text.format(head, quantities.quantity(report["range"], quantities.TABLE_DIGITS))
    return clearance_table.summary(as_rows(report), head)


def worst(report):
    """As clearance_table.worst()."""
    return clearance_table.worst(as_rows(report))


def smallest(report):
    """Smallest distance of all pairs (mm); the range where none comes so near."""
    if not report["pairs"]:
        return report["range"]
    return report["pairs"][report["smallest"]]["clearance"]["distance"]


def columns():
    """The head of the table."""
    found = []
    for title in clearance_table.columns()[1:]:
        word, space, rest = title.partition(" ")
        found.append(_TITLES.get(word, word) + space + rest)
    return ["First", "Second"] + found


def table(report):
    """The rows of the table, as columns()."""
    names = [[pair["first"], pair["second"]] for pair in report["pairs"]] + report["ignored"]
    rows = clearance_table.table(as_rows(report))
    return [list(pair) + row[1:] for pair, row in zip(names, rows)]


def write_csv(report, path):
    """The table as a CSV file (UTF-8)."""
    clearance_table.write_rows([columns()] + table(report), path)


def make_spreadsheet(obj, report):
    """The table as a spreadsheet in the document."""
    return clearance_table.spreadsheet_of(obj, [columns()] + table(report))
