# SPDX-License-Identifier: LGPL-2.1-or-later
"""Poses of a part while a property runs through a range: sketch-driven mechanisms, spreadsheets,
Assembly4 variables. The document is recomputed for each value and put back afterwards."""
from ..convert import InputProblem, global_placement, root_path
from ..texts import translate
from .poses import Poses, even_times


def poses(objects, name, start, end, count, duration):
    """objects: the object with the property, the part to watch. name: property or cell alias."""
    if len(objects) != 2:
        raise InputProblem(
            translate(
                "Messages", "choose the object whose property is driven, then the part to watch."
            )
        )
    driver, part = objects
    if not name or not hasattr(driver, name):
        raise InputProblem(
            translate("Messages", '"{0}" has no property "{1}".').format(driver.Label, name)
        )
    document, before = driver.Document, getattr(driver, name)
    before = getattr(before, "Value", before)
    sheet = driver.isDerivedFrom("Spreadsheet::Sheet")
    if sheet:
        cell = driver.getCellFromAlias(name) or name
        before = driver.getContents(cell)
    found = []
    try:
        for i in range(count):
            value = start + (end - start) * i / max(count - 1, 1)
            if sheet:
                driver.set(cell, repr(float(value)))
            else:
                setattr(driver, name, value)
            document.recompute()
            if "Invalid" in part.State or "Invalid" in driver.State:
                raise InputProblem(
                    translate("Messages", '"{0}" = {1:g}: the document does not recompute.').format(
                        name, value
                    )
                )
            found.append(global_placement(*root_path(part)))
    finally:
        if sheet:
            driver.set(cell, before)
        else:
            setattr(driver, name, before)
        document.recompute()
    return Poses(even_times(count, duration / max(count - 1, 1)), found)
