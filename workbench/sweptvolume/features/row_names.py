# SPDX-License-Identifier: LGPL-2.1-or-later
"""Updates the names in the stored report of a check to the present labels of the parts. A report
stores the place of each part in the document: [name of the root object, path below it]. Reports
of earlier versions have no places, so their names stay.
"""
from .. import convert
from .base import fits


def place_of(root, sub):
    return [root.Name, sub]


def placed(report, names, places):
    """Returns [(name, place)] from two lists of a report, or an empty list if the lists are
    damaged."""
    names, places = report.get(names), report.get(places)
    fine = fits(names, [str]) and fits(places, [(str, str)]) and len(names) == len(places)
    return list(zip(names, places)) if fine else []


def pair_at(document, place):
    """Returns (root, sub) of a place, or None if it leads to no object or is damaged."""
    if not fits(place, (str, str)):
        return None
    root = document.getObject(place[0])
    if root is None or root.getSubObject(place[1], retType=1) is None:
        return None
    return root, place[1]


def label_at(document, place, known):
    """Returns the present label of the part at a place. known: the former label, returned if the
    part is gone."""
    pair = pair_at(document, place)
    return known if pair is None else convert.label_of(*pair)


def rename_in_summary(report, old, new):
    """Renames the part in the core's summary, which ends with the name of the nearest row in
    brackets."""
    if report["summary"].endswith("({})".format(old)):
        report["summary"] = report["summary"][: -len(old) - 1] + new + ")"
