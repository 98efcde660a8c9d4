# SPDX-License-Identifier: LGPL-2.1-or-later
"""Properties that had another name in earlier versions. When a document of such a version opens,
their values, the expressions bound to them and the expressions that read them move to the new
names.
"""
import html
import json
import re

#: KIND of an object -> {old name: new name}.
RENAMED = {
    "SweptVolume::Motion": {"Frame": "PoseType", "SourceConvention": "SourceRotaryAxes"},
    "SweptVolume::Envelope": {"Generators": "MovingParts"},
    "SweptVolume::Clearance": {
        "Generators": "MovingParts",
        "Required": "RequiredDistance",
        "Tolerance": "Accuracy",
        "Deflection": "MeshDeflection",
    },
}
RENAMED["SweptVolume::Mechanism"] = RENAMED["SweptVolume::Clearance"]
RENAMED["SweptVolume::Sequence"] = dict(
    RENAMED["SweptVolume::Clearance"], Release="ReleaseDistance"
)
RENAMED["SweptVolume::Shared"] = {"Generators": "MovingParts", "Deflection": "MeshDeflection"}

_FORMER = {new: old for names in RENAMED.values() for old, new in names.items()}


def hashed(values):
    """Returns JSON of settings for a hash, under their original names, so that renaming does not
    make results stale."""
    return json.dumps({_FORMER.get(k, k): v for k, v in values.items()}, sort_keys=True)


def move_values(obj, names):
    """Moves the values of a restored object from properties with old names to those with the new
    names, which it already has, and removes the old properties. names: {old: new}."""
    names = {old: new for old, new in names.items() if old in obj.PropertiesList}
    if not names:
        return
    own = [(path.lstrip("."), text) for path, text in obj.ExpressionEngine]
    for path, _ in own:
        if path in names:
            obj.setExpression(path, None)
    for old, new in names.items():
        setattr(obj, new, getattr(obj, old))
    for path, text in own:
        after = _without_object(text, names)
        if path in names or after != text:
            obj.setExpression(names.get(path, path), after)
    _update_readers(obj, names)
    from . import missing

    missing.rename(obj, names)
    for old in names:
        obj.removeProperty(old)


def _without_object(text, names):
    """Renames properties in an expression of the object itself, where they stand without the name of
    the object (".Frame" or "Frame"). names: {old: new}."""
    pattern = r"(?<![\w.>])(\.?)({})\b(?!\s*\()".format("|".join(names))
    return re.sub(pattern, lambda found: found.group(1) + names[found.group(2)], text)


def _update_readers(obj, names):
    """Updates expressions of other objects, and cells of spreadsheets, that read the old names."""
    called = "|".join(map(re.escape, (obj.Name, "<<{}>>".format(obj.Label))))
    pattern = re.compile(r"(?<![\w.])({})\.({})\b".format(called, "|".join(names)))

    def renewed(text):
        return pattern.sub(lambda found: found.group(1) + "." + names[found.group(2)], text)

    for reader in obj.Document.Objects:
        for path, text in reader.ExpressionEngine:
            if renewed(text) != text:
                reader.setExpression(path, renewed(text))
        if reader.TypeId == "Spreadsheet::Sheet":
            for cell, text in _formulas(reader):
                if renewed(text) != text:
                    reader.set(cell, renewed(text))


def _formulas(sheet):
    """Returns (address, content) of the cells with formulas."""
    for cell in re.findall(r"<Cell [^>]*>", sheet.cells.Content):
        found = dict(re.findall(r'(\w+)="([^"]*)"', cell))
        if found.get("content", "").startswith("="):
            yield found["address"], html.unescape(found["content"])
