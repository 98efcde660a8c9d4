# SPDX-License-Identifier: LGPL-2.1-or-later
"""Reads an HTML page: its content, whether it is well-formed, and whether it needs any other file."""
import base64
import html
import json
import re
import xml.etree.ElementTree as tree

import numpy as np

_SCRIPT = re.compile(r"(<script[^>]*>)(.*?)</script>", re.S)
_ADDRESSES = (
    "src",
    "href",
    "action",
    "data",
    "poster",
    "srcset",
    "background",
    "{http://www.w3.org/1999/xlink}href",
)


def parsed(text):
    """Returns the page as a tree without its scripts, which are not XML. Raises an error if it is not
    well-formed."""
    assert text.startswith("<!DOCTYPE html>\n")
    bare = _SCRIPT.sub(r"\1</script>", text)
    bare = re.sub(r"(<style>).*?(</style>)", r"\1\2", bare, flags=re.S)
    return tree.fromstring(bare)


def check_alone(text):
    """Checks that nothing is loaded from elsewhere: only addresses of data and of places in the page,
    no import, no url()."""
    for element in parsed(text).iter():
        for name in _ADDRESSES:
            address = element.get(name, "")
            if name != "data" or element.tag.endswith("object"):
                assert re.match(r"data:image/|#|$", address), (element.tag, name, address[:60])
        assert not any(name.lower().startswith("on") for name in element.keys()), element.attrib
        assert "link" != element.tag.rpartition("}")[2]
    for style in re.findall(r"<style>(.*?)</style>", text, re.S):
        assert "@import" not in style and "url(" not in style


def data(text, name):
    """Returns the JSON value in a script element."""
    found = re.search(rf'<script type="application/json" id="{name}">(.*?)</script>', text, re.S)
    return json.loads(found[1])


def steady(report):
    """Returns a report without times, threads and memory."""
    report = json.loads(json.dumps(report))
    for key in ("seconds", "threads"):
        report.pop(key, None)
    for row in report.get("neighbours", []) + [p["clearance"] for p in report.get("pairs", [])]:
        row.pop("seconds", None)
    return report


def cells(text, section):
    """Returns the texts of a section's table, row by row."""
    for element in parsed(text).iter():
        if element.get("id") == section:
            rows = [e for e in element.iter() if e.tag.endswith("}tr")]
            return [["".join(cell.itertext()) for cell in row] for row in rows]
    return None


def shown(part):
    """Returns the vertices (mm) and triangles of a part of the 3D view."""

    def numbers(key, kind):
        return np.frombuffer(base64.b64decode(part[key]), kind)

    points = numbers("points", "<u2").reshape(-1, 3) * part["step"] + part["origin"]
    return points, numbers("indices", "<u4" if part["wide"] else "<u2").reshape(-1, 3)


def plain(text):
    """Returns the visible text, without markup."""
    bare = _SCRIPT.sub("", re.sub(r"<style>.*?</style>", "", text, flags=re.S))
    return html.unescape(re.sub(r"<[^>]+>", " ", bare))
