# SPDX-License-Identifier: LGPL-2.1-or-later
"""Collects the texts of the workbench into the .ts files, keeps what is translated, and packs them.

    python3 resources/translations/update.py            collects, reports what is missing
    python3 resources/translations/update.py --release  packs .qm with Qt's lrelease as well
"""
import ast
import glob
import os
import subprocess
import sys
import xml.etree.ElementTree as Tree

HERE = os.path.dirname(os.path.realpath(__file__))
ROOT = os.path.dirname(os.path.dirname(HERE))
LANGUAGES = ["de"]
#: Help texts of properties are stored in documents in English; FreeCAD translates them in this context where
#: it shows them.
CONTEXTS = {"Properties": "App::Property"}


def texts():
    """{context: [text, ...]} of all translate() and mark() calls and of the .ui files."""
    found = {}
    files = sorted(
        glob.glob(os.path.join(ROOT, "workbench", "sweptvolume", "**", "*.py"), recursive=True)
    )
    for path in files + [os.path.join(ROOT, "InitGui.py")]:
        with open(path, encoding="utf-8") as file:
            tree = ast.parse(file.read())
        for node in ast.walk(tree):
            if not isinstance(node, ast.Call):
                continue
            name = getattr(node.func, "id", "")
            values = [getattr(a, "value", None) for a in node.args]
            if name in ("translate", "mark") and len(values) == 2:
                if all(isinstance(v, str) for v in values):
                    add(found, CONTEXTS.get(values[0], "SweptVolume_" + values[0]), values[1])
            elif name == "menu" and len(values) == 1 and isinstance(values[0], str):
                add(found, "Workbench", values[0])
            elif name == "t" and len(values) == 1 and isinstance(values[0], str):
                add(found, "SweptVolume_Panels", values[0])
    for path in sorted(glob.glob(os.path.join(ROOT, "resources", "ui", "*.ui"))):
        tree = Tree.parse(path)
        context = tree.find("class").text
        for node in tree.iter("string"):
            if node.text and node.get("notr") != "true":
                add(found, context, node.text)
    return found


def add(found, context, text):
    entries = found.setdefault(context, [])
    if text not in entries:
        entries.append(text)


def known(path):
    """{(context, text): translation} of an existing .ts file."""
    result = {}
    if os.path.isfile(path):
        for context in Tree.parse(path).getroot().iter("context"):
            for message in context.iter("message"):
                translation = message.find("translation")
                if translation is not None and translation.text:
                    key = (context.find("name").text, message.find("source").text)
                    result[key] = translation.text
    return result


def write(path, language, found, translations):
    """Writes the .ts file; returns the texts without a translation."""
    root, missing = Tree.Element("TS", version="2.1", language=language, sourcelanguage="en"), []
    for context in sorted(found):
        node = Tree.SubElement(root, "context")
        Tree.SubElement(node, "name").text = context
        for text in found[context]:
            message = Tree.SubElement(node, "message")
            Tree.SubElement(message, "source").text = text
            translation = Tree.SubElement(message, "translation")
            translation.text = translations.get((context, text))
            if not translation.text:
                translation.set("type", "unfinished")
                missing.append((context, text))
    Tree.indent(root, " ")
    with open(path, "wb") as out:
        out.write(b'<?xml version="1.0" encoding="utf-8"?>\n<!DOCTYPE TS>\n')
        out.write(Tree.tostring(root, encoding="utf-8") + b"\n")
    return missing


def main():
    found = texts()
    for language in LANGUAGES:
        path = os.path.join(HERE, "SweptVolume_{}.ts".format(language))
        missing = write(path, language, found, known(path))
        total = sum(map(len, found.values()))
        print("{}: {} texts, {} without a translation".format(language, total, len(missing)))
        for context, text in missing:
            print("   {}: {!r}".format(context, text))
        if "--release" in sys.argv:
            subprocess.run(["lrelease", "-silent", path, "-qm", path[:-3] + ".qm"], check=True)


if __name__ == "__main__":
    main()
