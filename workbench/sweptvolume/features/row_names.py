# SPDX-License-Identifier: LGPL-2.1-or-later
"""Names in the stored report of a check follow the labels of the parts that they mean. A report keeps where
each part stands in the document, its place: [name of the root object, path below it]. Reports of before have
no places, and their names stay.
"""
from .. import convert
from .base import fits


def place_of(root, sub):
    return [root.Name, sub]


def placed(report, names, places):
    """[(name, place)] of two lists of a report that belong together; none where they are damaged."""
    names, places = report.get(names), report.get(places)
    fine = fits(names, [str]) and fits(places, [(str, str)]) and len(names) == len(places)
    return list(zip(names, places)) if fine else []


def pair_at(document, place):
    """(root, sub) of a place; None where it leads to nothing any more, or is damaged."""
    if not fits(place, (str, str)):
        return None
    root = document.getObject(place[0])
    if root is None or root.getSubObject(place[1], retType=1) is None:
        return None
    return root, place[1]


def label_at(document, place, known):
    """What the part at a place is called now; known: what it was called, where it is gone."""
    pair = pair_at(document, place)
    return known if pair is None else convert.label_of(*pair)


def rename_in_summary(report, old, new):
    """The core's own sentence ends with the name of the nearest row in brackets."""
    if report["summary"].endswith("({})".format(old)):
        report["summary"] = report["summary"][: -len(old) - 1] + new + ")"
